#include <pinball/version.h>

#include <cstdio>

#if defined(__AVX__) || defined(_OPENMP)
#error "options of the library reach the compilation of its host"
#endif

int main() { std::printf("%s %d\n", pinball_instruction_set(), pinball_simd_width()); }

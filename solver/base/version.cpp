#include "version.h"

#include <kernels/simd.hpp>

const char* pinball_version() { return PINBALL_VERSION; }

const char* pinball_instruction_set() {
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
  return "AVX-512";
#elif defined(__AVX2__) && defined(__FMA__)
  return "AVX2";
#elif defined(__AVX__)
  return "AVX";
#elif defined(__SSE2__)
  return "SSE2";
#else
  return "generic";
#endif
}

int pinball_simd_width() { return pinball::native_width<double>; }

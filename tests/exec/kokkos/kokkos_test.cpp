// Kokkos' default execution space under the tests of all spaces.
#include <kernels/exec.hpp>
#include <kernels/exec/kokkos.hpp>
#define PINBALL_TEST_SPACES pinball::KokkosDefault
#define PINBALL_TEST_MEMORIES pinball::KokkosMemory
#include <tests/exec/array_test.cpp>
#include <tests/exec/sums_test.cpp>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const Kokkos::ScopeGuard kokkos(argc, argv);
  return RUN_ALL_TESTS();
}

#pragma once

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace pinball::test {

/// Runs body with the given number of threads.
template <class Body>
void with_threads(int threads, const Body& body) {
#if defined(_OPENMP)
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  body();
  omp_set_num_threads(before);
#else
  (void)threads;
  body();
#endif
}

}  // namespace pinball::test

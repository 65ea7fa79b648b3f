#include "ceilings.hpp"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cstddef>

#include <kernels/exec/array.hpp>
#include <kernels/simd.hpp>

namespace pinball::bench {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

double memory_bandwidth(int threads) {
  constexpr std::ptrdiff_t n = 16'000'000;  // 128 MB an array
  static Array<double> a(n), b(n), c(n);
  double best = 0;
  for (int run = 0; run < 8; ++run) {
    const auto start = Clock::now();
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      a[static_cast<std::size_t>(i)] = b[static_cast<std::size_t>(i)] + 0.5 * c[static_cast<std::size_t>(i)];
    }
    best = std::max(best, 4.0 * sizeof(double) * static_cast<double>(n) / seconds_since(start));
  }
  return best;
}

double arithmetic_peak(int threads) {
  using T = Pack<double, native_width<double>>;
  constexpr int chains = 12;
  constexpr long rounds = 2'000'000;
  double best = 0;
  double guard = 0;
  for (int run = 0; run < 5; ++run) {
    const auto start = Clock::now();
#pragma omp parallel num_threads(threads) reduction(+ : guard)
    {
      T x[chains];
      for (int k = 0; k < chains; ++k) x[k] = T(1.0 + k);
      const T factor(0.999999), offset(1e-6);
      for (long r = 0; r < rounds; ++r) {
        PINBALL_UNROLL
        for (int k = 0; k < chains; ++k) x[k] = x[k] * factor + offset;
      }
      for (int k = 0; k < chains; ++k) guard += lane_sum(x[k]);
    }
    const double operations = 2.0 * chains * width_of<T> * static_cast<double>(rounds) * threads;
    best = std::max(best, operations / seconds_since(start));
  }
  return guard == 0 ? 0 : best;
}

}  // namespace pinball::bench

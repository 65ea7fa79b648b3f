#pragma once

#include <cstdint>

#include "macros.hpp"

#if defined(_OPENMP)
#include <omp.h>
#endif

/// Execution layer with the vocabulary and semantics of Kokkos: named kernels, range policies on an execution space,
/// functors called with an index, `parallel_for` and `parallel_reduce` that return when the work is done. It is this
/// thin so that another backend can be put under it without touching a kernel.
///
/// Results never depend on the number of threads: a `parallel_for` body writes only what belongs to its index, and
/// `parallel_reduce` combines partial results of fixed pieces of the range in order.
namespace pinball {

struct Serial {
  static int concurrency() { return 1; }
  static void set_concurrency(int /*threads*/) {}
};

#if defined(_OPENMP)
struct OpenMP {
  static int concurrency() { return omp_get_max_threads(); }
  static void set_concurrency(int threads) { omp_set_num_threads(threads); }
};
using DefaultExecutionSpace = OpenMP;
#else
using OpenMP = Serial;
using DefaultExecutionSpace = Serial;
#endif

/// Sums and lists that are made in this many pieces, and joined in order, do not depend on the number of threads.
inline constexpr std::int64_t fixed_pieces = 64;

/// Half-open range of indices on an execution space.
template <class Space = DefaultExecutionSpace>
struct RangePolicy {
  std::int64_t begin;
  std::int64_t end;
};

/// Calls body(i) for every i of the range, in any order. The name is for tools; it costs nothing.
template <class Body>
void parallel_for(const char* /*name*/, RangePolicy<Serial> range, const Body& body) {
  for (std::int64_t i = range.begin; i < range.end; ++i) body(i);
}

/// Calls body(begin, end, partial) for consecutive pieces of the range and joins the partial results in order:
/// join(result, partial). The pieces depend on the length of the range alone.
template <class Value, class Body, class Join>
void parallel_reduce(const char* /*name*/, RangePolicy<Serial> range, Value& result, const Body& body,
                     const Join& join) {
  const std::int64_t count = range.end - range.begin;
  for (std::int64_t p = 0; p < fixed_pieces; ++p) {
    Value partial{};
    body(range.begin + count * p / fixed_pieces, range.begin + count * (p + 1) / fixed_pieces, partial);
    join(result, partial);
  }
}

/// Runs body(item) for the items of one colour after the other; the items of a colour share nothing that they write, so
/// that each sum has one order for any number of threads. colour_offsets: colours + 1 entries into items.
template <class Body>
void parallel_for_coloured(const char* /*name*/, Serial /*space*/, const std::int32_t* colour_offsets,
                           std::int32_t colours, const std::int32_t* items, const Body& body) {
  for (std::int32_t i = colour_offsets[0]; i < colour_offsets[colours]; ++i) body(items[i]);
}

#if defined(_OPENMP)

template <class Body>
void parallel_for(const char* /*name*/, RangePolicy<OpenMP> range, const Body& body) {
#pragma omp parallel for schedule(static)
  for (std::int64_t i = range.begin; i < range.end; ++i) body(i);
}

template <class Value, class Body, class Join>
void parallel_reduce(const char* /*name*/, RangePolicy<OpenMP> range, Value& result, const Body& body,
                     const Join& join) {
  const std::int64_t count = range.end - range.begin;
  Value partial[fixed_pieces]{};
#pragma omp parallel for schedule(static)
  for (std::int64_t p = 0; p < fixed_pieces; ++p) {
    body(range.begin + count * p / fixed_pieces, range.begin + count * (p + 1) / fixed_pieces, partial[p]);
  }
  for (std::int64_t p = 0; p < fixed_pieces; ++p) join(result, partial[p]);
}

template <class Body>
void parallel_for_coloured(const char* /*name*/, OpenMP /*space*/, const std::int32_t* colour_offsets,
                           std::int32_t colours, const std::int32_t* items, const Body& body) {
#pragma omp parallel
  for (std::int32_t c = 0; c < colours; ++c) {
#pragma omp for schedule(static)
    for (std::int32_t i = colour_offsets[c]; i < colour_offsets[c + 1]; ++i) body(items[i]);
  }
}

#endif

}  // namespace pinball

#pragma once

#include <cstdint>

#include "spaces.hpp"

#if defined(_OPENMP)
#include "region_failure.hpp"
#include "thread_team.hpp"
#endif

namespace pinball {

/// Sums and lists that are made in this many pieces, and joined in order, do not depend on the number of threads.
inline constexpr std::int64_t fixed_pieces = 64;

/// Calls body(i) for every i of the range, in any order. The name is for tools; it costs nothing.
template <class Body>
void parallel_for(const char* /*name*/, RangePolicy<Serial> range, const Body& body) {
  for (std::int64_t i = range.begin; i < range.end; ++i) body(i);
}

/// Runs body(item) for the items of one colour after the other; the items of a colour share nothing that they write, so
/// that each sum has one order for any number of threads. colour_offsets: colours + 1 entries into items.
template <class Body>
void parallel_for_coloured(const char* /*name*/, Serial /*space*/, const std::int32_t* colour_offsets,
                           std::int32_t colours, const std::int32_t* items, const Body& body) {
  for (std::int32_t i = colour_offsets[0]; i < colour_offsets[colours]; ++i) body(items[i]);
}

/// Work on a range of indices, for a team. A type with a name: so has its machine code, which tools look for.
template <class Body>
struct RangeOf {
  const Body& body;
  static void work(const void* of, std::int64_t begin, std::int64_t end) {
    const Body& body = static_cast<const RangeOf*>(of)->body;
    for (std::int64_t i = begin; i < end; ++i) body(i);
  }
};

#if defined(_OPENMP)

template <class Body>
void parallel_for(const char* /*name*/, RangePolicy<Threads> range, const Body& body) {
  const RangeOf<Body> work{body};
  ThreadTeam::of_this_thread().run(Threads::of_region(), range.begin, range.end, &RangeOf<Body>::work, &work);
}

/// The items of a colour.
template <class Body>
struct ItemsOf {
  const std::int32_t* items;
  const Body& body;
  void operator()(std::int64_t i) const { body(items[i]); }
};

template <class Body>
void parallel_for_coloured(const char* name, Threads /*space*/, const std::int32_t* colour_offsets,
                           std::int32_t colours, const std::int32_t* items, const Body& body) {
  for (std::int32_t c = 0; c < colours; ++c) {
    const RangePolicy<Threads> range{colour_offsets[c], colour_offsets[c + 1]};
    parallel_for(name, range, ItemsOf<Body>{items, body});
  }
}

/// Calls part(begin, end) for the calling OpenMP thread's part of the range, within a region.
template <class Part>
void run_own_part(RegionFailure& failure, std::int64_t begin, std::int64_t end, const Part& part) {
  const std::int64_t thread = omp_get_thread_num(), threads = omp_get_num_threads(), count = end - begin;
  failure.guard(thread, [&] { part(begin + count * thread / threads, begin + count * (thread + 1) / threads); });
}

template <class Body>
void parallel_for(const char* /*name*/, RangePolicy<OpenMP> range, const Body& body) {
  RegionFailure failure;
#pragma omp parallel
  run_own_part(failure, range.begin, range.end, [&body](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i) body(i);
  });
  failure.rethrow();
}

template <class Body>
void parallel_for_coloured(const char* /*name*/, OpenMP /*space*/, const std::int32_t* colour_offsets,
                           std::int32_t colours, const std::int32_t* items, const Body& body) {
  RegionFailure failure;
#pragma omp parallel
  for (std::int32_t c = 0; c < colours; ++c) {
    run_own_part(failure, colour_offsets[c], colour_offsets[c + 1], [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i) body(items[i]);
    });
#pragma omp barrier
  }
  failure.rethrow();
}

#endif

/// A piece of a sum.
template <class Value, class Body>
struct PieceOf {
  std::int64_t begin, count;
  Value* partial;
  const Body& body;
  void operator()(std::int64_t p) const {
    body(begin + count * p / fixed_pieces, begin + count * (p + 1) / fixed_pieces, partial[p]);
  }
};

/// For loops of the host that run over a piece of the range by themselves. Calls body(begin, end, partial) for
/// consecutive pieces and joins the partial results in order: join(result, partial). The pieces depend on the length of
/// the range alone.
template <class Space, class Value, class Body, class Join>
void parallel_reduce(const char* name, RangePolicy<Space> range, Value& result, const Body& body, const Join& join) {
  Value partial[fixed_pieces]{};
  parallel_for(name, RangePolicy<Space>{0, fixed_pieces},
               PieceOf<Value, Body>{range.begin, range.end - range.begin, partial, body});
  for (std::int64_t p = 0; p < fixed_pieces; ++p) join(result, partial[p]);
}

}  // namespace pinball

#pragma once

#include <cstdint>

#include "../macros.hpp"
#include "spaces.hpp"

#if defined(_OPENMP)
#include "region_failure.hpp"
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

/// Part of the work on a range; `of` is what it is done with.
using RangeWork = void (*)(const void* of, std::int64_t begin, std::int64_t end);

/// Work on a range of indices. Its machine code is there once, whoever calls it: another copy might fuse other
/// multiplications and additions, and one thread would make other bits than two; so would a loop that makes several
/// rounds at once, and a body that is to be vectorized works on a pack. A type with a name: so has its code, which
/// tools look for.
template <class Body>
struct RangeOf {
  const Body& body;
  PINBALL_ONE_COPY static void work(const void* of, std::int64_t begin, std::int64_t end) {
    const Body& body = static_cast<const RangeOf*>(of)->body;
    for (std::int64_t i = begin; i < end; ++i) {
      PINBALL_ONE_BY_ONE;
      body(i);
    }
  }
};

/// The items of a colour.
template <class Body>
struct ItemsOf {
  const std::int32_t* items;
  const Body& body;
  void operator()(std::int64_t i) const { body(items[i]); }
};

#if defined(_OPENMP)

/// Work on the calling thread's part of the range, within a region.
inline void work_own_part(RegionFailure& failure, std::int64_t begin, std::int64_t end, RangeWork work,
                          const void* of) {
  const std::int64_t thread = omp_get_thread_num(), threads = omp_get_num_threads(), count = end - begin;
  failure.guard(thread, [&] { work(of, begin + count * thread / threads, begin + count * (thread + 1) / threads); });
}

/// Work on a range, a part for each thread: always the same, so that what it has in its cache serves the next loop,
/// too.
inline void work_in_parts(std::int64_t begin, std::int64_t end, RangeWork work, const void* of) {
  if (OpenMP::is_alone(end - begin)) {
    if (begin < end) work(of, begin, end);
    return;
  }
  RegionFailure failure;
#pragma omp parallel
  work_own_part(failure, begin, end, work, of);
  failure.rethrow();
}

template <class Body>
void parallel_for(const char* /*name*/, RangePolicy<OpenMP> range, const Body& body) {
  const RangeOf<Body> work{body};
  work_in_parts(range.begin, range.end, &RangeOf<Body>::work, &work);
}

/// Work on consecutive ranges, one after the other, in one region.
inline void work_on_colours(const std::int32_t* colour_offsets, std::int32_t colours, RangeWork work, const void* of) {
  if (OpenMP::is_alone(colour_offsets[colours] - colour_offsets[0])) {
    work(of, colour_offsets[0], colour_offsets[colours]);
    return;
  }
  RegionFailure failure;
#pragma omp parallel
  for (std::int32_t c = 0; c < colours; ++c) {
    work_own_part(failure, colour_offsets[c], colour_offsets[c + 1], work, of);
#pragma omp barrier
  }
  failure.rethrow();
}

template <class Body>
void parallel_for_coloured(const char* /*name*/, OpenMP /*space*/, const std::int32_t* colour_offsets,
                           std::int32_t colours, const std::int32_t* items, const Body& body) {
  const ItemsOf<Body> of_colour{items, body};
  const RangeOf<ItemsOf<Body>> work{of_colour};
  work_on_colours(colour_offsets, colours, &RangeOf<ItemsOf<Body>>::work, &work);
}

#else

inline void work_in_parts(std::int64_t begin, std::int64_t end, RangeWork work, const void* of) {
  if (begin < end) work(of, begin, end);
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

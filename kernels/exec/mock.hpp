#pragma once

#include <cstdint>
#include <type_traits>

#include "host_loops.hpp"
#include "mock_space.hpp"

namespace pinball {

/// A device for tests: threads of the host, at work on memory that the host may not touch outside kernels. What would
/// fail on a device because of a host's pointer used late, or a copy forgotten, fails on it. It does not find kernels
/// that read the host's memory.
struct Mock {
  using memory_space = MockSpace;
  static int concurrency() { return OpenMP::concurrency(); }
  static void set_concurrency(int threads) { OpenMP::set_concurrency(threads); }
};

/// A range whose parts open the memory for the thread that works on them; an exception closes it, too.
template <class Body>
struct OpenedRangeOf {
  RangeOf<Body> range;
  static void work(const void* of, std::int64_t begin, std::int64_t end) {
    const MockMemory::OpenHere while_it_works;
    RangeOf<Body>::work(&static_cast<const OpenedRangeOf*>(of)->range, begin, end);
  }
};

template <class Functor>
void parallel_for(const char* /*name*/, RangePolicy<Mock> range, const Functor& given) {
  static_assert(std::is_trivially_copyable_v<Functor>, "a device gets a copy of its bytes");
  if (range.begin >= range.end) return;
  const Functor functor = given;
  const OpenedRangeOf<Functor> opened{{functor}};
  const MockMemory::OpenForTeam while_it_works;
  work_in_parts(range.begin, range.end, &OpenedRangeOf<Functor>::work, &opened);
}

}  // namespace pinball

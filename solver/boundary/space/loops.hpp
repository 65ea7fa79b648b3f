#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include <kernels/exec.hpp>

/// What loops of boundary conditions have in common.
namespace pinball {

template <class Space>
inline constexpr bool on_host = std::is_same_v<typename Space::memory_space, HostSpace>;

/// A list of the host in the memory of a space.
template <class Space, class T>
Array<T, typename Space::memory_space> list_in(const std::vector<T>& list) {
  Array<T, typename Space::memory_space> array;
  array.renew(list.size());
  deep_copy(array, list.data(), list.size());
  return array;
}

/// Calls functor(i) for i below count. Threads of the host are not called together for a few nodes.
template <class Space, class Functor>
void for_each(const char* name, std::int64_t count, const Functor& functor) {
  constexpr std::int64_t few = 512;
  if (on_host<Space> && count < few) {
    for (std::int64_t i = 0; i < count; ++i) functor(i);
  } else {
    parallel_for(name, RangePolicy<Space>{0, count}, functor);
  }
}

/// Adds to `sum` what functor(i, partial) adds up for i below count.
template <class Space, class Functor, class Value>
void add_sum(const char* name, std::int64_t count, const Functor& functor, Value& sum) {
  Value own{};
  parallel_reduce(name, RangePolicy<Space>{0, count}, functor, own);
  join_to(sum, own);
}

}  // namespace pinball

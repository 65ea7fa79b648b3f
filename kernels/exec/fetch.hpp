#pragma once

#include "../macros.hpp"

#if defined(PINBALL_DEVICE_COMPILER)

/// Copies of a thread's numbers into the memory of its block that go on while it works. Where a device has no such
/// copies they are made at once.
namespace pinball {

/// Begins to copy a number of 4 or 8 bytes.
template <class Number>
__device__ inline void fetch(Number* shared, const Number* from) {
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 800
  const auto to = static_cast<unsigned>(__cvta_generic_to_shared(shared));
  if constexpr (sizeof(Number) == 8) {
    asm volatile("cp.async.ca.shared.global [%0], [%1], 8;" ::"r"(to), "l"(from) : "memory");
  } else {
    static_assert(sizeof(Number) == 4);
    asm volatile("cp.async.ca.shared.global [%0], [%1], 4;" ::"r"(to), "l"(from) : "memory");
  }
#else
  *shared = *from;
#endif
}

/// What the thread has begun to fetch since the last call is one group.
__device__ inline void end_of_group() {
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 800
  asm volatile("cp.async.commit_group;" ::: "memory");
#endif
}

/// Waits until all groups of the thread but the last are there.
__device__ inline void wait_for_all_groups_but_one() {
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 800
  asm volatile("cp.async.wait_group 1;" ::: "memory");
#endif
}

}  // namespace pinball

#endif

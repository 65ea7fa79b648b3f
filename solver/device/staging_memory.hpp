#pragma once

#include <kernels/exec/host_space.hpp>

namespace pinball {

/// Memory of the host that a memory is copied from and to the quickest: what its device reaches by itself where there
/// is such a thing (`staging_memory`), else any.
template <class Memory>
struct StagingMemoryOf {
  using type = HostSpace;
};
template <class Memory>
requires(requires { typename Memory::staging_memory; }) struct StagingMemoryOf<Memory> {
  using type = typename Memory::staging_memory;
};
template <class Memory>
using StagingMemory = typename StagingMemoryOf<Memory>::type;

}  // namespace pinball

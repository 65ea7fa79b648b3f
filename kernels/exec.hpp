#pragma once

/// Execution layer with the vocabulary and semantics of Kokkos: named kernels, range policies on an execution space,
/// functors called with an index, arrays that lie in the memory of a space. It is this thin so that another backend can
/// be put under it without touching a kernel.
///
/// Spaces and where their arrays lie: Serial and OpenMP, the default, in HostSpace; Mock in MockSpace (mock.hpp); Cuda
/// in CudaSpace and Hip in HipSpace, where their compiler reads this (gpu.hpp).
///
/// Results never depend on the number of threads: a `parallel_for` body writes only what belongs to its index, and
/// `parallel_reduce` combines partial results of fixed pieces of the range in order.
///
/// A body may throw, but on a device. Of several exceptions that of the first index is thrown, and what else was done
/// is not defined.
#include "exec/array.hpp"
#include "exec/gpu.hpp"
#include "exec/host_loops.hpp"
#include "exec/mock.hpp"
#include "exec/spaces.hpp"
#include "exec/sums.hpp"

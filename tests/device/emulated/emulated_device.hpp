#pragma once

#include <cstddef>
#include <cstdint>

/// A GPU on a processor, for tests: the sources for GPUs, compiled by the host's compiler with the cuda_runtime.h
/// beside this, run on it as they are. What it does is what CUDA promises, and nothing beyond, so that what leans on
/// more shows:
///
///   - Threads of a block take turns at barriers alone, and in the order that is set; so do blocks.
///   - Kernels wait until the host waits for them: a result that is read before is not there yet.
///   - Memory is all ones when it is given out: numbers are none.
///   - The host may not touch memory of the device: SIGSEGV (MockMemory).
///   - A kernel that is given an address of the host's, a copy of the wrong kind or beyond an end, a barrier that some
///     threads of a block do not reach, and memory that is released twice end the process with a word.
///
/// It knows nothing of warps, streams, caches, registers and speed. Threads of the host use it one after the other.
namespace pinball::emulated {

/// The turns of blocks, and between two barriers of the threads of a block.
enum class Order { forward, reverse, shuffled };

/// seed: of the shuffled order. Kernels given before are run before. Before the first call the order is what the
/// environment says, PINBALL_EMULATED_ORDER: forward, which it is where nothing is said, reverse, or a seed.
void set_order(Order order, std::uint32_t seed = 1);

/// Of the thread that runs: threadIdx, blockIdx, blockDim and gridDim along their first axis.
struct Coordinates {
  struct Along {
    unsigned x, y, z;
  };
  Along thread, block, threads, blocks;
};
extern Coordinates coordinates;

using Kernel = void (*)(const void* parameters);

/// While one lives, other threads of the host wait for the device. One thread may have several.
class Turn {
 public:
  Turn();
  ~Turn();
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
};

/// What the calling thread has asked of it since it began.
struct Counts {
  std::int64_t launches = 0;
  std::int64_t waits = 0;      ///< for kernels, and copies
  std::int64_t to_device = 0;  ///< copied [bytes]
  std::int64_t to_host = 0;    ///< copied [bytes]; results of sums are none
};
Counts counts();

/// Memory in which the parameters of a launch stay until it has run.
void* parameters_of_launch(std::size_t bytes);
/// Ends the process where a parameter has the address of anything of the host. Its padding has to be zero.
void check_parameter(const void* parameter, std::size_t bytes);
/// kernel: called with the parameters by each thread, once something waits for it.
void launch(unsigned blocks, unsigned threads, Kernel kernel, const void* parameters);
void barrier();
/// Runs what was launched.
void wait();

void* allocate(std::size_t bytes);
void release(void* memory);
enum class Copy { host_to_device, device_to_host, device_to_device };
void copy(void* to, const void* from, std::size_t bytes, Copy kind);
void set(void* to, int byte, std::size_t bytes);
/// Of the host, where kernels may write.
void* allocate_pinned(std::size_t bytes);
void release_pinned(void* memory);

}  // namespace pinball::emulated

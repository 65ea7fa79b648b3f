#pragma once

// In place of CUDA's own header, for sources for GPUs that the host's compiler takes (emulated_device.hpp): what
// kernels/exec/gpu.hpp asks of it.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <tuple>
#include <type_traits>

#include "emulated_device.hpp"

// NOLINTBEGIN: names of CUDA
#define __host__
#define __device__
#define __global__
#define __shared__ static  // one block runs at a time
#define __launch_bounds__(...)

inline auto& threadIdx = pinball::emulated::coordinates.thread;
inline auto& blockIdx = pinball::emulated::coordinates.block;
inline auto& blockDim = pinball::emulated::coordinates.threads;
inline auto& gridDim = pinball::emulated::coordinates.blocks;

enum cudaError_t { cudaSuccess = 0, cudaErrorMemoryAllocation = 2 };
enum cudaMemcpyKind { cudaMemcpyHostToDevice, cudaMemcpyDeviceToHost, cudaMemcpyDeviceToDevice };
inline constexpr unsigned cudaHostAllocDefault = 0;
using cudaStream_t = void*;
struct dim3 {
  unsigned x = 1, y = 1, z = 1;
};
struct cudaLaunchConfig_t {
  dim3 gridDim, blockDim;
};
struct cudaDeviceProp {
  char name[64];
  std::size_t totalGlobalMem;
};

inline void __syncthreads() { pinball::emulated::barrier(); }
inline void __threadfence() {}
/// Threads take turns: nothing is between the two halves.
inline unsigned atomicInc(unsigned* number, unsigned largest) {
  const unsigned before = *number;
  *number = before >= largest ? 0 : before + 1;
  return before;
}

inline cudaError_t cudaMalloc(void** memory, std::size_t bytes) {
  try {
    *memory = pinball::emulated::allocate(bytes);
  } catch (const std::bad_alloc&) {
    return cudaErrorMemoryAllocation;
  }
  return cudaSuccess;
}
inline cudaError_t cudaFree(void* memory) {
  pinball::emulated::release(memory);
  return cudaSuccess;
}
inline cudaError_t cudaHostAlloc(void** memory, std::size_t bytes, unsigned /*flags*/) {
  *memory = pinball::emulated::allocate_pinned(bytes);
  return cudaSuccess;
}
inline cudaError_t cudaFreeHost(void* memory) {
  pinball::emulated::release_pinned(memory);
  return cudaSuccess;
}
inline cudaError_t cudaMemset(void* to, int byte, std::size_t bytes) {
  pinball::emulated::set(to, byte, bytes);
  return cudaSuccess;
}
inline cudaError_t cudaMemcpy(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind) {
  using pinball::emulated::Copy;
  pinball::emulated::copy(to, from, bytes,
                          kind == cudaMemcpyHostToDevice   ? Copy::host_to_device
                          : kind == cudaMemcpyDeviceToHost ? Copy::device_to_host
                                                           : Copy::device_to_device);
  return cudaSuccess;
}
inline cudaError_t cudaDeviceSynchronize() {
  pinball::emulated::wait();
  return cudaSuccess;
}
inline cudaError_t cudaStreamSynchronize(cudaStream_t /*stream*/) {
  pinball::emulated::wait();
  return cudaSuccess;
}
inline cudaError_t cudaGetLastError() { return cudaSuccess; }
inline const char* cudaGetErrorString(cudaError_t status) {
  return status == cudaSuccess ? "no error" : "out of memory";
}
inline cudaError_t cudaGetDevice(int* device) {
  *device = 0;
  return cudaSuccess;
}
/// All are the same one.
inline cudaError_t cudaGetDeviceCount(int* count) {
  *count = 3;
  return cudaSuccess;
}
inline cudaError_t cudaSetDevice(int /*device*/) { return cudaSuccess; }
inline cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int /*device*/) {
  std::strcpy(properties->name, "GPU emulated on the processor");
  properties->totalGlobalMem = std::size_t(1) << 38;
  return cudaSuccess;
}

namespace pinball::emulated {

template <class Parameter>
Parameter checked_parameter(Parameter parameter) {
  static_assert(std::is_trivially_copyable_v<Parameter>, "parameters of kernels are copied as bytes");
  __builtin_clear_padding(&parameter);  // there, what was on the stack before may look like an address
  check_parameter(&parameter, sizeof(parameter));
  return parameter;
}

}  // namespace pinball::emulated

template <class... Parameter, class... Argument>
cudaError_t cudaLaunchKernelEx(const cudaLaunchConfig_t* how, void (*kernel)(Parameter...), Argument&&... arguments) {
  struct Call {
    void (*kernel)(Parameter...);
    std::tuple<Parameter...> parameters;
    static void run(const void* call) {
      const Call& self = *static_cast<const Call*>(call);
      std::apply(self.kernel, self.parameters);
    }
  };
  static_assert(sizeof(Call) <= 4096, "more than a kernel takes");
  using namespace pinball::emulated;
  const Turn turn;  // of this thread, until its launch is there with its parameters
  const auto* const call = new (parameters_of_launch(sizeof(Call)))
      Call{kernel, {checked_parameter<Parameter>(arguments)...}};
  launch(how->gridDim.x, how->blockDim.x, &Call::run, call);
  return cudaSuccess;
}
// NOLINTEND

#pragma once

#include "../macros.hpp"

#if defined(PINBALL_DEVICE_COMPILER)

#include <cstddef>
#include <new>
#include <stdexcept>

#if defined(__HIPCC__)
#include <hip/hip_runtime.h>
#define PINBALL_GPU(name) hip##name
#else
#include <cuda_runtime.h>
#define PINBALL_GPU(name) cuda##name
#endif

#include "error_text.hpp"
#include "host_space.hpp"

/// Memory of accelerators, and of the host as they see it. For gpu.hpp, which takes PINBALL_GPU away again.
namespace pinball {

/// What the runtime or the device has refused, and in what.
class GpuError : public std::runtime_error {
 public:
  GpuError(const char* what, PINBALL_GPU(Error_t) status)
      : std::runtime_error((ErrorText() << what << ": " << PINBALL_GPU(GetErrorString)(status)).c_str()),
        status_(status) {}
  /// The runtime's own sentence.
  const char* reason() const { return PINBALL_GPU(GetErrorString)(status_); }

 private:
  PINBALL_GPU(Error_t) status_;
};

inline void require_gpu(PINBALL_GPU(Error_t) status, const char* what) {
  if (status == PINBALL_GPU(Success)) return;
  (void)PINBALL_GPU(GetLastError)();  // it would be reported again
  throw GpuError(what, status);
}

/// Memory of the host that stays where it is, so that the device copies from and to it, or writes there, by itself.
struct GpuHostSpace {
  static std::size_t room(std::size_t bytes) { return HostSpace::room(bytes); }
  static void* allocate(std::size_t room) {
    void* memory = nullptr;
#if defined(__HIPCC__)
    require_gpu(hipHostMalloc(&memory, room, hipHostMallocDefault), "pinned memory");
#else
    require_gpu(cudaHostAlloc(&memory, room, cudaHostAllocDefault), "pinned memory");
#endif
    return memory;
  }
  static void release(void* memory, std::size_t /*room*/) noexcept {
#if defined(__HIPCC__)
    (void)hipHostFree(memory);
#else
    (void)cudaFreeHost(memory);
#endif
  }
  static void zero(void* to, std::size_t bytes) { HostSpace::zero(to, bytes); }
};

struct GpuSpace {
  using staging_memory = GpuHostSpace;
  static constexpr std::size_t alignment = 256;
  static std::size_t room(std::size_t bytes) { return (bytes + alignment - 1) / alignment * alignment; }
  static void* allocate(std::size_t room) {
    void* memory = nullptr;
    const auto status = PINBALL_GPU(Malloc)(&memory, room);
    if (status == PINBALL_GPU(ErrorMemoryAllocation)) {
      (void)PINBALL_GPU(GetLastError)();
      throw std::bad_alloc();
    }
    require_gpu(status, "memory of the device");
    return memory;
  }
  static void release(void* memory, std::size_t /*room*/) noexcept { (void)PINBALL_GPU(Free)(memory); }

  static void zero(void* to, std::size_t bytes) { require_gpu(PINBALL_GPU(Memset)(to, 0, bytes), "zero"); }
  static void copy(void* to, const void* from, std::size_t bytes) {
    transfer(to, from, bytes, PINBALL_GPU(MemcpyDeviceToDevice));
    require_gpu(PINBALL_GPU(DeviceSynchronize)(), "deep_copy");
  }
  static void copy_from_host(void* to, const void* from, std::size_t bytes) {
    transfer(to, from, bytes, PINBALL_GPU(MemcpyHostToDevice));
  }
  static void copy_to_host(void* to, const void* from, std::size_t bytes) {
    transfer(to, from, bytes, PINBALL_GPU(MemcpyDeviceToHost));
  }

 private:
  static void transfer(void* to, const void* from, std::size_t bytes, PINBALL_GPU(MemcpyKind) kind) {
    require_gpu(PINBALL_GPU(Memcpy)(to, from, bytes, kind), "deep_copy");
  }
};

}  // namespace pinball

#endif

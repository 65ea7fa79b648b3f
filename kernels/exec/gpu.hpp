#pragma once

#include "../macros.hpp"

#if defined(PINBALL_DEVICE_COMPILER)

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "gpu_space.hpp"
#include "pieces.hpp"
#include "sums.hpp"

/// Accelerators of CUDA and of HIP, by one source: `Cuda` and `CudaSpace`, or `Hip` and `HipSpace`. All work is done in
/// the order in which it is given, on the device that is current for the calling thread.
namespace pinball {

/// A kernel is under way when parallel_for returns. What goes wrong in it is thrown by what waits for it next: fence,
/// deep_copy, the result of a sum.
struct Gpu {
  using memory_space = GpuSpace;
  static constexpr int block = sum_lanes;  ///< threads
  static void wait() { require_gpu(PINBALL_GPU(DeviceSynchronize)(), "fence"); }

#if defined(__HIPCC__)
  using Properties = hipDeviceProp_t;
#else
  using Properties = cudaDeviceProp;
#endif
  /// Devices of this machine. Throws GpuError where there is none.
  static int count() {
    int count = 0;
    require_gpu(PINBALL_GPU(GetDeviceCount)(&count), "devices");
    return count;
  }
  /// Makes a device that of the calling thread.
  static void choose(int device) { require_gpu(PINBALL_GPU(SetDevice)(device), "device"); }
  /// Of the device that is current. Throws GpuError where there is none.
  static Properties properties() {
    int device = 0;
    require_gpu(PINBALL_GPU(GetDevice)(&device), "device");
    Properties properties;
    require_gpu(PINBALL_GPU(GetDeviceProperties)(&properties, device), "device");
    return properties;
  }
};

#if defined(__HIPCC__)
using HipSpace = GpuSpace;
using Hip = Gpu;
#else
using CudaSpace = GpuSpace;
using Cuda = Gpu;
#endif

/// Blocks that a processor of the device has to hold of a functor's kernel, which bounds its registers: as many as the
/// functor says in `least_blocks`.
template <class Functor>
constexpr int least_blocks() {
  if constexpr (requires { Functor::least_blocks; }) {
    return Functor::least_blocks;
  } else {
    return 1;
  }
}

/// Gives blocks of Gpu::block threads a kernel to work on, without waiting for it. By the runtime's function: sources
/// that call it are C++ but for their marks, and tests compile them for the processor.
template <class... Parameter>
void launch(const char* name, std::int64_t blocks, void (*kernel)(Parameter...),
            const std::type_identity_t<Parameter>&... parameters) {
#if defined(__HIPCC__)
  hipLaunchKernelGGL(kernel, dim3(static_cast<unsigned>(blocks)), dim3(Gpu::block), 0, nullptr, parameters...);
  require_gpu(hipGetLastError(), name);
#else
  cudaLaunchConfig_t how{};
  how.gridDim.x = static_cast<unsigned>(blocks);
  how.blockDim.x = Gpu::block;
  require_gpu(cudaLaunchKernelEx(&how, kernel, parameters...), name);
#endif
}

template <class Functor>
__global__ void __launch_bounds__(Gpu::block, least_blocks<Functor>())
    call_for_each(std::int64_t begin, std::int64_t end, Functor functor) {
  const std::int64_t i = begin + std::int64_t(blockIdx.x) * Gpu::block + threadIdx.x;
  if (i < end) functor(i);
}

template <class Functor>
void parallel_for(const char* name, RangePolicy<Gpu> range, const Functor& functor) {
  static_assert(std::is_trivially_copyable_v<Functor> && sizeof(Functor) <= 4000, "parameter of a kernel");
  if (range.begin >= range.end) return;
  launch(name, (range.end - range.begin + Gpu::block - 1) / Gpu::block, &call_for_each<Functor>, range.begin, range.end,
         functor);
}

/// What threads of a block have for each other; values may be of types with constructors.
template <class Value, int count>
__device__ Value* shared_values() {
  static_assert(count * sizeof(Value) <= std::size_t(48) << 10, "more than a block has");
  alignas(Value) __shared__ unsigned char bytes[count * sizeof(Value)];
  return reinterpret_cast<Value*>(bytes);
}

/// Joins the values of a block's threads in pairs, as sum_of_piece does; thread 0 has the sum.
template <class Value>
__device__ void join_lanes(Value& own) {
  Value* const upper = shared_values<Value, sum_lanes / 2>();
  const int lane = static_cast<int>(threadIdx.x);
  for (int width = sum_lanes / 2; width > 0; width /= 2) {
    if (lane >= width && lane < 2 * width) upper[lane - width] = own;
    __syncthreads();
    if (lane < width) join_to(own, upper[lane]);
    __syncthreads();
  }
}

/// Of a piece, by one block. Thread 0 has the sum. A functor that can do better than to take one index after another
/// says so: sum_lane(first, end, sum) takes first, first + sum_lanes, ... in their order.
template <class Value, class Functor>
__device__ void sum_piece_of_range(std::int64_t begin, SumPiece piece, const Functor& functor, Value& own) {
  if constexpr (requires { functor.sum_lane(begin, begin, own); }) {
    functor.sum_lane(begin + piece.begin + threadIdx.x, begin + piece.end, own);
  } else {
    for (std::int64_t i = piece.begin + threadIdx.x; i < piece.end; i += sum_lanes) functor(begin + i, own);
  }
  join_lanes(own);
}

template <class Value, class Functor>
__global__ void __launch_bounds__(Gpu::block, least_blocks<Functor>())
    sum_pieces_of_range(std::int64_t begin, std::int64_t count, Functor functor, Value* partial) {
  Value own{};
  sum_piece_of_range(begin, sum_piece(count, blockIdx.x, gridDim.x), functor, own);
  if (threadIdx.x == 0) partial[blockIdx.x] = own;
}

/// What other blocks have written: by words, and not from a cache of this processor's own.
template <class Value>
__device__ Value written_by_another(const Value* value) {
  using Word = std::conditional_t<alignof(Value) % 8 == 0, std::uint64_t, std::uint32_t>;
  static_assert(sizeof(Value) % sizeof(Word) == 0);
  union Words {
    Word word[sizeof(Value) / sizeof(Word)];
    Value value;
    __device__ Words() {}
  } copy;
  const volatile Word* const from = reinterpret_cast<const volatile Word*>(value);
  PINBALL_UNROLL
  for (int w = 0; w < int(sizeof(Value) / sizeof(Word)); ++w) copy.word[w] = from[w];
  return copy.value;
}

/// Of the pieces of a range those from `first` on. The block that ends last joins the sums of all in their order,
/// whichever it is. ended: 0 before and after; null: nobody joins them.
template <class Value, class Functor>
__global__ void __launch_bounds__(Gpu::block, least_blocks<Functor>())
    sum_range(std::int64_t begin, std::int64_t count, std::int64_t pieces, std::int64_t first, Functor functor,
              Value* partial, unsigned* ended, Value* result) {
  __shared__ bool last;
  Value own{};
  sum_piece_of_range(begin, sum_piece(count, first + blockIdx.x, pieces), functor, own);
  if (threadIdx.x == 0) partial[blockIdx.x] = own;
  if (ended == nullptr) return;
  if (threadIdx.x == 0) {
    __threadfence();
    last = atomicInc(ended, gridDim.x - 1) == gridDim.x - 1;
  }
  __syncthreads();
  if (!last) return;
  own = Value{};
  _Pragma("unroll 4") for (unsigned p = threadIdx.x; p < gridDim.x; p += sum_lanes)
      join_to(own, written_by_another(partial + p));
  join_lanes(own);
  if (threadIdx.x == 0) *result = own;
}

/// Memory for partial results and for results, of each thread of the host.
class GpuScratch {
 public:
  /// Of the device.
  template <class Value>
  static Value* values(std::int64_t count) {
    return static_cast<Value*>(of_this_thread().bytes(static_cast<std::size_t>(count) * sizeof(Value)));
  }
  /// Of the host, where kernels may write: what needs no copy.
  template <class Value>
  static Value* results(std::int64_t count) {
    GpuScratch& scratch = of_this_thread();
    scratch.make_results(static_cast<std::size_t>(count) * sizeof(Value));
    return static_cast<Value*>(scratch.results_);
  }
  /// Of the device: a number that is 0 between kernels.
  static unsigned* counter() {
    GpuScratch& scratch = of_this_thread();
    if (scratch.counter_ == nullptr) {
      scratch.counter_ = static_cast<unsigned*>(GpuSpace::allocate(GpuSpace::room(sizeof(unsigned))));
      GpuSpace::zero(scratch.counter_, sizeof(unsigned));
    }
    return scratch.counter_;
  }
  GpuScratch(const GpuScratch&) = delete;
  GpuScratch& operator=(const GpuScratch&) = delete;

 private:
  static constexpr std::size_t least_room = 4096;
  GpuScratch() = default;
  ~GpuScratch() {
    GpuSpace::release(memory_, room_);
    GpuSpace::release(counter_, 0);
    GpuHostSpace::release(results_, results_room_);
  }
  void make_results(std::size_t wanted) {
    if (wanted <= results_room_) return;
    GpuHostSpace::release(results_, results_room_);
    results_ = nullptr;
    results_room_ = 0;
    const std::size_t room = GpuHostSpace::room(wanted < least_room ? least_room : wanted);
    results_ = GpuHostSpace::allocate(room);
    results_room_ = room;
  }
  static GpuScratch& of_this_thread() {
    static thread_local GpuScratch scratch;
    return scratch;
  }
  void* bytes(std::size_t wanted) {
    if (wanted > room_) {
      GpuSpace::release(memory_, room_);
      memory_ = nullptr;
      room_ = 0;
      memory_ = GpuSpace::allocate(GpuSpace::room(wanted));
      room_ = GpuSpace::room(wanted);
    }
    return memory_;
  }
  void* memory_ = nullptr;
  std::size_t room_ = 0;
  void* results_ = nullptr;
  std::size_t results_room_ = 0;
  unsigned* counter_ = nullptr;
};

/// The same sums in the same order as on the host (sums.hpp). least_blocks of the functor counts here, too.
template <class Functor, class Value>
void parallel_reduce(const char* name, RangePolicy<Gpu> range, const Functor& functor, Value& result) {
  static_assert(std::is_trivially_copyable_v<Value> && std::is_trivially_copyable_v<Functor>);
  const std::int64_t count = range.end - range.begin, pieces = sum_pieces(count);
  auto* const partial = GpuScratch::values<Value>(pieces);
  auto* const written = GpuScratch::results<Value>(1);
  launch(name, pieces, &sum_range<Value, Functor>, range.begin, count, pieces, 0, functor, partial,
         GpuScratch::counter(), written);
  require_gpu(PINBALL_GPU(StreamSynchronize)(nullptr), name);
  result = *written;
}

/// By the same kernel: they come without a copy, too.
template <class Functor, class Value>
void reduce_pieces(const char* name, RangePolicy<Gpu> range, PieceRange pieces, const Functor& functor,
                   Value* partial) {
  static_assert(std::is_trivially_copyable_v<Value> && std::is_trivially_copyable_v<Functor>);
  const std::int64_t count = range.end - range.begin, some = pieces.last - pieces.first;
  if (some <= 0) return;
  auto* const written = GpuScratch::results<Value>(some);
  launch(name, some, &sum_range<Value, Functor>, range.begin, count, sum_pieces(count), pieces.first, functor, written,
         nullptr, nullptr);
  require_gpu(PINBALL_GPU(StreamSynchronize)(nullptr), name);
  for (std::int64_t p = 0; p < some; ++p) partial[pieces.first + p] = written[p];
}

/// The term of each index, for its sums.
template <class Functor>
struct TermsOf {
  Functor functor;
  template <class Value>
  PINBALL_FUNCTION void operator()(std::int64_t i, Value& sum) const {
    functor(i, sum, false);
  }
};

/// partial: sums of pieces, which become the sums before each of them; the total comes behind them. By one block.
template <class Value>
__global__ void __launch_bounds__(Gpu::block) scan_pieces(std::int64_t pieces, Value* partial) {
  Value* const run = shared_values<Value, Gpu::block>();
  const int lane = static_cast<int>(threadIdx.x);
  const std::int64_t begin = pieces * lane / Gpu::block, end = pieces * (lane + 1) / Gpu::block;
  Value own{};
  for (std::int64_t p = begin; p < end; ++p) join_to(own, partial[p]);
  run[lane] = own;
  __syncthreads();
  if (lane == 0) {
    Value sum{};
    for (int l = 0; l < Gpu::block; ++l) {
      const Value of_run = run[l];
      run[l] = sum;
      join_to(sum, of_run);
    }
    partial[pieces] = sum;
  }
  __syncthreads();
  Value sum = run[lane];
  for (std::int64_t p = begin; p < end; ++p) {
    const Value of_piece = partial[p];
    partial[p] = sum;
    join_to(sum, of_piece);
  }
}

/// run: one value a thread, which becomes the sum of those up to and with its own.
template <class Value>
__device__ void scan_lanes(Value* run) {
  const int lane = static_cast<int>(threadIdx.x);
  for (int distance = 1; distance < Gpu::block; distance *= 2) {
    Value sum{};
    if (lane >= distance) sum = run[lane - distance];
    __syncthreads();
    if (lane >= distance) {
      join_to(sum, run[lane]);
      run[lane] = sum;
    }
    __syncthreads();
  }
}

template <class Value, class Functor>
__global__ void __launch_bounds__(Gpu::block)
    scan_range(std::int64_t begin, std::int64_t count, Functor functor, const Value* before) {
  Value* const run = shared_values<Value, Gpu::block>();
  const int lane = static_cast<int>(threadIdx.x);
  const SumPiece piece = sum_piece(count, blockIdx.x, gridDim.x);
  Value sum = before[blockIdx.x];
  for (std::int64_t round = piece.begin; round < piece.end; round += Gpu::block) {
    Value own{};
    if (round + lane < piece.end) functor(begin + round + lane, own, false);
    run[lane] = own;
    __syncthreads();
    scan_lanes(run);
    Value update = sum;
    if (lane > 0) join_to(update, run[lane - 1]);
    if (round + lane < piece.end) functor(begin + round + lane, update, true);
    join_to(sum, run[Gpu::block - 1]);
    __syncthreads();
  }
}

template <class Functor, class Value>
void parallel_scan(const char* name, RangePolicy<Gpu> range, const Functor& functor, Value& total) {
  static_assert(std::is_trivially_copyable_v<Value> && std::is_trivially_copyable_v<Functor>);
  const std::int64_t count = range.end - range.begin, pieces = sum_pieces(count);
  auto* const partial = GpuScratch::values<Value>(pieces + 1);
  launch(name, pieces, &sum_pieces_of_range<Value, TermsOf<Functor>>, range.begin, count, {functor}, partial);
  launch(name, 1, &scan_pieces<Value>, pieces, partial);
  launch(name, pieces, &scan_range<Value, Functor>, range.begin, count, functor, partial);
  require_gpu(PINBALL_GPU(Memcpy)(&total, partial + pieces, sizeof(Value), PINBALL_GPU(MemcpyDeviceToHost)), name);
}

}  // namespace pinball

#undef PINBALL_GPU
#endif

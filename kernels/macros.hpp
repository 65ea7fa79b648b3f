#pragma once

/// Where a compiler of device code reads, for host and device: one thread works on one lane.
#if defined(__CUDACC__) || defined(__HIPCC__)
#define PINBALL_DEVICE_COMPILER 1
#endif

/// PINBALL_FUNCTION marks every function that a device will have to run: it is inlined into the calling loop, so that a
/// kernel over packs becomes one straight piece of vector code, and it is compiled for host and device by nvcc and
/// hipcc. (Tests define it to see each function by itself.)
#if defined(PINBALL_FUNCTION)
#elif defined(PINBALL_DEVICE_COMPILER)
#define PINBALL_FUNCTION __host__ __device__ inline __attribute__((always_inline))
#else
#define PINBALL_FUNCTION [[gnu::always_inline]] inline
#endif

/// The same for what is long, used by few scenes and in many kernels: compiled once, and called.
#if defined(PINBALL_OUTLINED)
#elif defined(PINBALL_DEVICE_COMPILER)
#define PINBALL_OUTLINED __host__ __device__ __attribute__((noinline)) inline
#else
#define PINBALL_OUTLINED [[gnu::noinline]] inline
#endif

/// A whole kernel, which a loop calls for each pack. Inlined by force it would be optimised anew in every function
/// between it and the loop, which is a third of its compiling, and spill more. Static: a source has its own, so that no
/// linker takes that of a test, which is optimised less, for that of the library. On a device it is a part of its loop.
#if defined(PINBALL_DEVICE_COMPILER)
#define PINBALL_KERNEL PINBALL_FUNCTION
#else
#define PINBALL_KERNEL [[gnu::noinline]] static
#endif

/// Of the host: called, and there once in machine code, for every caller the same bits. (GCC may keep a copy of a
/// function for some of its callers.)
#if defined(__clang__) || defined(PINBALL_DEVICE_COMPILER)
#define PINBALL_ONE_COPY __attribute__((noinline))
#else
#define PINBALL_ONE_COPY __attribute__((noinline, noclone))
#endif

/// At the beginning of the rounds of a loop of the host that may be cut anywhere: they are made one by one. Were
/// several made at once, those left over at the ends of a part would be of other machine code, and this, too, may fuse
/// other multiplications and additions.
#define PINBALL_ONE_BY_ONE __asm__ volatile("")

/// Loops over corners, modes and tensor components have constant bounds and are unrolled completely, so that their
/// arrays live in registers.
#if defined(PINBALL_DEVICE_COMPILER)
#define PINBALL_UNROLL _Pragma("unroll")
#elif defined(__clang__)
#define PINBALL_UNROLL _Pragma("clang loop unroll(full)")
#else
#define PINBALL_UNROLL _Pragma("GCC unroll 16")
#endif

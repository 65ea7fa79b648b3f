#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "macros.hpp"

#if !defined(PINBALL_DEVICE_COMPILER)
#include <experimental/simd>
#endif
#if defined(__AVX512VL__) && !defined(PINBALL_DEVICE_COMPILER)
#include <immintrin.h>
#endif

#if defined(_GLIBCXX_RELEASE) && _GLIBCXX_RELEASE <= 14 && !defined(PINBALL_DEVICE_COMPILER)
/// libstdc++ fills a pack with one number by a function for each lane that it does not mark as to be inlined. Where
/// such a one is called in those that are, GCC inlines it last of all, in every copy of them: 40,000 calls in three
/// kernels, half of the time of compiling them. These are the same in one piece.
namespace std::experimental {
inline namespace parallelism_v2 {
#define PINBALL_FILLED(T, W, ...)                                                               \
  template <>                                                                                   \
  [[gnu::always_inline]] inline constexpr __vector_type_t<T, W> __vector_broadcast<W, T>(T x) { \
    return __vector_type_t<T, W>{__VA_ARGS__};                                                  \
  }
PINBALL_FILLED(double, 2, x, x)
PINBALL_FILLED(float, 4, x, x, x, x)
#if defined(__AVX__)
PINBALL_FILLED(double, 4, x, x, x, x)
PINBALL_FILLED(float, 8, x, x, x, x, x, x, x, x)
#endif
#if defined(__AVX512F__)
PINBALL_FILLED(double, 8, x, x, x, x, x, x, x, x)
PINBALL_FILLED(float, 16, x, x, x, x, x, x, x, x, x, x, x, x, x, x, x, x)
#endif
#undef PINBALL_FILLED
}  // namespace parallelism_v2
}  // namespace std::experimental
#endif

/// Number types of the kernels. A kernel is a template over its number type T: `double`, `float`, or a pack of W lanes
/// (`Pack<double, W>`), each lane being one element, node or pair. The same source is the scalar reference, the vector
/// code of the processor, and the code of one thread of a GPU.
///
/// Rules: no branch on a lane's value; a mask and `select` take its place, with the replaced `if` in a comment.
namespace pinball {

/// Traits of a scalar: one lane, masks are bool.
template <class T>
struct NumberTraits {
  using Scalar = T;
  using Mask = bool;
  static constexpr int width = 1;
};

template <class T>
using ScalarOf = typename NumberTraits<T>::Scalar;
template <class T>
using MaskOf = typename NumberTraits<T>::Mask;
template <class T>
inline constexpr int width_of = NumberTraits<T>::width;

PINBALL_FUNCTION double select(bool mask, double if_true, double if_false) { return mask ? if_true : if_false; }
PINBALL_FUNCTION float select(bool mask, float if_true, float if_false) { return mask ? if_true : if_false; }
PINBALL_FUNCTION double square_root(double a) { return ::sqrt(a); }
PINBALL_FUNCTION float square_root(float a) { return ::sqrtf(a); }
/// NaN in either operand may give either: a NaN is found by the checks of the step, not carried by minimum or maximum.
PINBALL_FUNCTION double minimum(double a, double b) { return b < a ? b : a; }
PINBALL_FUNCTION float minimum(float a, float b) { return b < a ? b : a; }
PINBALL_FUNCTION double maximum(double a, double b) { return a < b ? b : a; }
PINBALL_FUNCTION float maximum(float a, float b) { return a < b ? b : a; }
PINBALL_FUNCTION double absolute(double a) { return a < 0 ? -a : a; }
PINBALL_FUNCTION float absolute(float a) { return a < 0 ? -a : a; }
PINBALL_FUNCTION bool any_lane(bool mask) { return mask; }
PINBALL_FUNCTION int count_lanes(bool mask) { return mask ? 1 : 0; }
/// Bit i is set where lane i of the mask of a number of type T is.
template <class T>
PINBALL_FUNCTION unsigned lane_bits(const MaskOf<T>& mask) {
  if constexpr (width_of<T> == 1) {
    return mask ? 1U : 0U;
  } else {
#if !defined(PINBALL_DEVICE_COMPILER)
    constexpr unsigned all = (1ULL << width_of<T>)-1;
    return static_cast<unsigned>(mask.__to_bitset().to_ullong()) & all;
#endif
  }
}
PINBALL_FUNCTION double lane_sum(double a) { return a; }
PINBALL_FUNCTION float lane_sum(float a) { return a; }
PINBALL_FUNCTION double lane_maximum(double a) { return a; }
PINBALL_FUNCTION float lane_maximum(float a) { return a; }
PINBALL_FUNCTION double lane_minimum(double a) { return a; }
PINBALL_FUNCTION float lane_minimum(float a) { return a; }
PINBALL_FUNCTION double lane(double a, int) { return a; }
PINBALL_FUNCTION float lane(float a, int) { return a; }

#if defined(PINBALL_DEVICE_COMPILER)

/// One thread of a device works on one lane.
template <class T, int W>
struct PackType {
  static_assert(W == 1, "a device has no packs: one thread is one lane");
  using Type = T;
};
template <class T>
inline constexpr int native_width = 1;

#else

namespace stdx = std::experimental;

template <class T, int W>
struct PackType {
  using Type = stdx::simd<T, stdx::simd_abi::deduce_t<T, W>>;
};
template <class T>
struct PackType<T, 1> {
  using Type = T;
};

template <class T, class Abi>
struct NumberTraits<stdx::simd<T, Abi>> {
  using Scalar = T;
  using Mask = stdx::simd_mask<T, Abi>;
  static constexpr int width = stdx::simd<T, Abi>::size();
};

/// Lanes of the widest register that the compiler may use; 1 in the build without vectorization.
#if defined(PINBALL_SIMD_WIDTH_BYTES) && PINBALL_SIMD_WIDTH_BYTES == 0
template <class T>
inline constexpr int native_width = 1;
#else
template <class T>
inline constexpr int native_width = stdx::native_simd<T>::size();
#endif

#if defined(__AVX512VL__)
namespace detail {
template <class P>
PINBALL_FUNCTION P blend(unsigned long long bits, const P& a, const P& b) {
  constexpr bool is_double = sizeof(typename P::value_type) == 8;
  if constexpr (sizeof(P) == 64 && is_double) {
    return P(_mm512_mask_blend_pd(static_cast<__mmask8>(bits), static_cast<__m512d>(a), static_cast<__m512d>(b)));
  } else if constexpr (sizeof(P) == 64) {
    return P(_mm512_mask_blend_ps(static_cast<__mmask16>(bits), static_cast<__m512>(a), static_cast<__m512>(b)));
  } else if constexpr (sizeof(P) == 32 && is_double) {
    return P(_mm256_mask_blend_pd(static_cast<__mmask8>(bits), static_cast<__m256d>(a), static_cast<__m256d>(b)));
  } else if constexpr (sizeof(P) == 32) {
    return P(_mm256_mask_blend_ps(static_cast<__mmask8>(bits), static_cast<__m256>(a), static_cast<__m256>(b)));
  } else if constexpr (is_double) {
    return P(_mm_mask_blend_pd(static_cast<__mmask8>(bits), static_cast<__m128d>(a), static_cast<__m128d>(b)));
  } else {
    return P(_mm_mask_blend_ps(static_cast<__mmask8>(bits), static_cast<__m128>(a), static_cast<__m128>(b)));
  }
}
}  // namespace detail
#endif

template <class T, class Abi>
PINBALL_FUNCTION stdx::simd<T, Abi> select(const stdx::simd_mask<T, Abi>& mask, const stdx::simd<T, Abi>& if_true,
                                           const stdx::simd<T, Abi>& if_false) {
#if defined(__AVX512VL__)
  // Of libstdc++'s masked assignment with AVX-512 mask registers Clang 14 makes nothing, and GCC the same after long: a
  // blend by hand.
  if constexpr (sizeof(if_true) == 64 || sizeof(if_true) == 32 || sizeof(if_true) == 16) {
    return detail::blend<stdx::simd<T, Abi>>(mask.__to_bitset().to_ullong(), if_false, if_true);
  }
#endif
  stdx::simd<T, Abi> result = if_false;
  stdx::where(mask, result) = if_true;
  return result;
}
template <class T, class Abi>
PINBALL_FUNCTION stdx::simd<T, Abi> square_root(const stdx::simd<T, Abi>& a) {
  return stdx::sqrt(a);
}
template <class T, class Abi>
PINBALL_FUNCTION stdx::simd<T, Abi> minimum(const stdx::simd<T, Abi>& a, const stdx::simd<T, Abi>& b) {
  return select(b < a, b, a);
}
template <class T, class Abi>
PINBALL_FUNCTION stdx::simd<T, Abi> maximum(const stdx::simd<T, Abi>& a, const stdx::simd<T, Abi>& b) {
  return select(a < b, b, a);
}
template <class T, class Abi>
PINBALL_FUNCTION stdx::simd<T, Abi> absolute(const stdx::simd<T, Abi>& a) {
  return stdx::abs(a);
}
template <class T, class Abi>
PINBALL_FUNCTION bool any_lane(const stdx::simd_mask<T, Abi>& mask) {
  return stdx::any_of(mask);
}
/// Not stdx::popcount: GCC 12 stores a mask of 8 lanes in one byte and may count the bits of four.
template <class T, class Abi>
PINBALL_FUNCTION int count_lanes(const stdx::simd_mask<T, Abi>& mask) {
  return static_cast<int>(stdx::reduce(select(mask, stdx::simd<T, Abi>(T(1)), stdx::simd<T, Abi>(T(0)))));
}
/// Sum over the lanes in lane order: the same bits on every instruction set for a given width.
template <class T, class Abi>
PINBALL_FUNCTION T lane_sum(const stdx::simd<T, Abi>& a) {
  T sum = a[0];
  for (std::size_t i = 1; i < a.size(); ++i) sum += a[i];
  return sum;
}
template <class T, class Abi>
PINBALL_FUNCTION T lane_maximum(const stdx::simd<T, Abi>& a) {
  return stdx::hmax(a);
}
template <class T, class Abi>
PINBALL_FUNCTION T lane_minimum(const stdx::simd<T, Abi>& a) {
  return stdx::hmin(a);
}
template <class T, class Abi>
PINBALL_FUNCTION T lane(const stdx::simd<T, Abi>& a, int i) {
  return a[i];
}

#endif

template <class T, int W>
using Pack = typename PackType<T, W>::Type;

/// Lanes of the widest register of any processor that this is written for. What is summed in rows of so many has the
/// same bits for packs of any width.
template <class T>
inline constexpr int widest_pack = 64 / sizeof(T);

/// A constant in all lanes, rounded to the precision of T. (A pack of floats cannot be built from a double.)
template <class T>
PINBALL_FUNCTION T number(double value) {
  return T(static_cast<ScalarOf<T>>(value));
}

/// Loads width_of<T> consecutive values; `source` is aligned to the pack.
template <class T>
PINBALL_FUNCTION T load(const ScalarOf<T>* source) {
  if constexpr (width_of<T> == 1) {
    return *source;
  } else {
#if !defined(PINBALL_DEVICE_COMPILER)
    return T(source, stdx::vector_aligned);
#endif
  }
}

/// Stores width_of<T> consecutive values; `target` is aligned to the pack.
template <class T>
PINBALL_FUNCTION void store(const T& value, ScalarOf<T>* target) {
  if constexpr (width_of<T> == 1) {
    *target = value;
  } else {
#if !defined(PINBALL_DEVICE_COMPILER)
    value.copy_to(target, stdx::vector_aligned);
#endif
  }
}

/// The lane numbers 0, 1, ... W-1.
template <class T>
PINBALL_FUNCTION T lane_numbers() {
  if constexpr (width_of<T> == 1) {
    return T(0);
  } else {
#if !defined(PINBALL_DEVICE_COMPILER)
    return T([](auto i) { return static_cast<ScalarOf<T>>(static_cast<int>(i)); });
#endif
  }
}

}  // namespace pinball

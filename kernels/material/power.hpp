#pragma once

#include <cstdint>

#include "../simd.hpp"

/// Logarithm, exponential function and power of all lanes at once: the same operations for packs of any width and on
/// any device, where each library has its own (and those of the processor take lane after lane).
///
/// Of x = 2^k m, sqrt(1/2) <= m < sqrt(2), the logarithm is k ln 2 + 2 atanh(f), f = (m - 1)/(m + 1), by the series of
/// the latter; e^x is 2^k e^r, |r| <= ln(2)/2, by the series of e^r. Terms are as many as the last digit needs:
/// logarithm and e^x are within a few units of their last digit, a^b within that times |b ln a| (tests/kernels/
/// power_test.cpp). Numbers below the smallest normal one count as zero.
namespace pinball {

namespace detail {

/// The unsigned integers of the width of T's scalars, lane by lane.
template <class T>
struct BitsOf;
template <>
struct BitsOf<double> {
  using Type = std::uint64_t;
};
template <>
struct BitsOf<float> {
  using Type = std::uint32_t;
};
#if !defined(PINBALL_DEVICE_COMPILER)
template <class S, class Abi>
struct BitsOf<stdx::simd<S, Abi>> {
  using Type = stdx::rebind_simd_t<typename BitsOf<S>::Type, stdx::simd<S, Abi>>;
};
#endif

template <class To, class From>
PINBALL_FUNCTION To same_bits(From from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  __builtin_memcpy(static_cast<void*>(&to), &from, sizeof(To));
  return to;
}

/// How a scalar is laid out.
template <class S>
struct Layout;
template <>
struct Layout<double> {
  using Bits = std::uint64_t;
  static constexpr int digits = 52;
  static constexpr Bits root_half = 0x3FE6A09E667F3BCDULL;  ///< sqrt(1/2)
  static constexpr Bits one = 0x3FF0000000000000ULL;
  static constexpr Bits whole = 0x4330000000000000ULL;  ///< 2^52: the last digits of what is beyond are an integer
  static constexpr double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;
  static constexpr double smallest = 0x1p-1022, lowest_exponent = -708.0, highest_exponent = 709.0;
  static constexpr int terms_of_logarithm = 11, terms_of_exponential = 13;
};
template <>
struct Layout<float> {
  using Bits = std::uint32_t;
  static constexpr int digits = 23;
  static constexpr Bits root_half = 0x3F3504F3U;
  static constexpr Bits one = 0x3F800000U;
  static constexpr Bits whole = 0x4B000000U;  ///< 2^23
  static constexpr float ln2_high = 0x1.62e3p-1F, ln2_low = 0x1.2fefa2p-17F;
  static constexpr float smallest = 0x1p-126F, lowest_exponent = -87.0F, highest_exponent = 88.0F;
  static constexpr int terms_of_logarithm = 5, terms_of_exponential = 7;
};

}  // namespace detail

/// Natural logarithm. Of zero and less: of the smallest normal number; of what is not finite: no number.
template <class T>
PINBALL_FUNCTION T logarithm(const T& x) {
  using S = ScalarOf<T>;
  using L = detail::Layout<S>;
  using Bits = typename detail::BitsOf<T>::Type;
  const Bits bits = detail::same_bits<Bits>(maximum(x, T(L::smallest)));
  // 2^k of m: exponents are counted from that of sqrt(1/2) on, so that the difference is k + 2^(digits of one).
  const Bits shifted = bits - Bits(L::root_half) + Bits(L::one);
  const Bits exponent = shifted >> L::digits;
  const T k =
      detail::same_bits<T>(Bits(exponent | Bits(L::whole))) - T(detail::same_bits<S>(L::whole) + (L::one >> L::digits));
  const Bits mantissa = bits - Bits((exponent - Bits(L::one >> L::digits)) << L::digits);
  const T m = detail::same_bits<T>(mantissa);
  const T f = (m - T(1)) / (m + T(1)), f2 = f * f;
  T sum = T(S(1) / S(2 * L::terms_of_logarithm - 1));
  PINBALL_UNROLL
  for (int i = L::terms_of_logarithm - 1; i > 0; --i) sum = sum * f2 + T(S(1) / S(2 * i - 1));
  const T no_number = x - x;  // zero, but where x is none
  return k * T(L::ln2_high) + (k * T(L::ln2_low) + T(2) * f * sum) + no_number;
}

namespace detail {

/// e^x = 2^k e^r of x within the exponents of numbers.
template <class T>
struct ExponentialFactors {
  T power_of_two;  ///< 2^k
  T rest;          ///< e^r - 1
};

template <class T>
PINBALL_FUNCTION ExponentialFactors<T> factors_of_exponential(const T& x) {
  using S = ScalarOf<T>;
  using L = Layout<S>;
  using Bits = typename BitsOf<T>::Type;
  const T bounded = minimum(maximum(x, T(L::lowest_exponent)), T(L::highest_exponent));
  // The sum with 1.5 times 2^digits is rounded to a whole number, which its last digits then are.
  const S half_more = S(1.5) * same_bits<S>(L::whole);
  const T rounded = bounded * number<T>(1.4426950408889634074) + T(half_more);
  const T k = rounded - T(half_more);
  const T r = (bounded - k * T(L::ln2_high)) - k * T(L::ln2_low);
  T sum = T(1);
  PINBALL_UNROLL
  for (int i = L::terms_of_exponential; i > 1; --i) sum = T(1) + sum * r * T(S(1) / S(i));
  return {same_bits<T>(Bits((same_bits<Bits>(rounded) << L::digits) + Bits(L::one))), sum * r};
}

}  // namespace detail

/// e^x; zero where that is below the smallest normal number, and where it is beyond the largest, about that. Of what is
/// not finite: no number.
template <class T>
PINBALL_FUNCTION T exponential(const T& x) {
  const detail::ExponentialFactors<T> factors = detail::factors_of_exponential(x);
  const T value = (T(1) + factors.rest) * factors.power_of_two, no_number = x - x;
  return select(x < T(detail::Layout<ScalarOf<T>>::lowest_exponent), T(0), value) + no_number;
}

/// ln(1 + x), as accurate where x is small: the logarithm of the rounded sum, and what rounding has taken of it.
template <class T>
PINBALL_FUNCTION T logarithm_of_one_and(const T& x) {
  const T sum = T(1) + x;
  const T rest = x - (sum - T(1));
  return logarithm(sum) + rest / maximum(sum, T(detail::Layout<ScalarOf<T>>::smallest));
}

/// e^x - 1, as accurate where x is small; not for x beyond the exponents of numbers.
template <class T>
PINBALL_FUNCTION T exponential_less_one(const T& x) {
  const detail::ExponentialFactors<T> factors = detail::factors_of_exponential(x);
  const T no_number = x - x;
  return factors.power_of_two * factors.rest + (factors.power_of_two - T(1)) + no_number;
}

/// base^exponent of a base that is not negative: zero of zero, also with an exponent of zero.
template <class T>
PINBALL_FUNCTION T power(const T& base, ScalarOf<T> exponent) {
  const T value = exponential(T(exponent) * logarithm(base));
  return select(base > T(0), value, base - base);
}

}  // namespace pinball

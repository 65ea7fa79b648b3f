#pragma once

#include <cstdint>

#include "macros.hpp"

#if defined(__AVX512VL__) && !defined(PINBALL_DEVICE_COMPILER)
#include <immintrin.h>
#endif

/// What a mask tells, written one after the other: lists that grow by a pack at a time, without a branch per lane.
///
/// Contract: there is room for `lanes` numbers at `to`, whatever the mask; what is written beyond those that it tells
/// is of no use. Returns how many it tells.
namespace pinball {

/// Number of the lowest bit that is set; some bit has to be.
PINBALL_FUNCTION int lowest_bit(unsigned bits) {
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__)
  return __ffs(bits) - 1;
#else
  return __builtin_ctz(bits);
#endif
}

namespace detail {

#if defined(__AVX512VL__) && !defined(PINBALL_DEVICE_COMPILER)
inline constexpr bool has_compress = true;
PINBALL_FUNCTION void compress_8(unsigned bits, const std::int32_t* from, std::int32_t* to) {
  const __m256i all = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), all));
}
PINBALL_FUNCTION void compress_8(unsigned bits, const double* from, double* to) {
  _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(bits), _mm512_loadu_pd(from)));
}
PINBALL_FUNCTION void compress_8(unsigned bits, const float* from, float* to) {
  _mm256_storeu_ps(to, _mm256_maskz_compress_ps(static_cast<__mmask8>(bits), _mm256_loadu_ps(from)));
}
/// Numbers made in a register: from memory they would have to wait for eight stores.
PINBALL_FUNCTION void compress_numbers_8(unsigned bits, std::int32_t first, std::int32_t* to) {
  const __m256i all = _mm256_add_epi32(_mm256_set1_epi32(first), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), all));
}
#else
inline constexpr bool has_compress = false;
#endif

}  // namespace detail

/// Writes from[i] for each bit i, in rising order.
template <int lanes, class Value>
PINBALL_FUNCTION int write_lanes(unsigned bits, const Value* from, Value* to) {
  const int count = __builtin_popcount(bits);
  if constexpr (detail::has_compress && lanes % 8 == 0) {
#if defined(__AVX512VL__) && !defined(PINBALL_DEVICE_COMPILER)
    for (int first = 0; first < lanes; first += 8) {
      const unsigned eight = bits >> first & 0xFFU;
      detail::compress_8(eight, from + first, to);
      to += __builtin_popcount(eight);
    }
#endif
  } else {
    for (; bits != 0; bits &= bits - 1) *to++ = from[lowest_bit(bits)];
  }
  return count;
}

/// Writes first + i for each bit i, in rising order.
template <int lanes>
PINBALL_FUNCTION int write_numbers(unsigned bits, std::int32_t first, std::int32_t* to) {
  const int count = __builtin_popcount(bits);
  if constexpr (detail::has_compress && lanes % 8 == 0) {
#if defined(__AVX512VL__) && !defined(PINBALL_DEVICE_COMPILER)
    for (int eight = 0; eight < lanes; eight += 8) {
      detail::compress_numbers_8(bits >> eight & 0xFFU, first + eight, to);
      to += __builtin_popcount(bits >> eight & 0xFFU);
    }
#endif
  } else {
    for (; bits != 0; bits &= bits - 1) *to++ = first + lowest_bit(bits);
  }
  return count;
}

}  // namespace pinball

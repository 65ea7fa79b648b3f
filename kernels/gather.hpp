#pragma once

#include <cstdint>

#include "record.hpp"
#include "simd.hpp"
#include "tensor.hpp"

/// Access to node records by index.
///
/// Positions, velocities and forces of nodes are stored as records of four numbers (x, y, z, spare), so that a lane
/// fetches a whole vector with one load of 32 bytes (16 in single precision) and a pack is filled by transposing W of
/// them in registers. This replaces 3 W scalar loads by W and needs no hardware scatter. Adding forces goes the other
/// way, lane after lane, so that lanes that share a node add up correctly and in a fixed order; records may have more
/// digits than what is added.
///
/// Contract: base is aligned to four scalars; index holds width_of<T> valid record numbers, which may repeat.
#if defined(__AVX512F__) && !defined(PINBALL_DEVICE_COMPILER)
#include <immintrin.h>
#endif

namespace pinball {

namespace detail {

#if defined(__AVX512F__)
inline constexpr bool has_512_bits = true;
#else
inline constexpr bool has_512_bits = false;
#endif

template <class T>
PINBALL_FUNCTION void gather_lanes(const ScalarOf<T>* base, const std::int32_t* index, T& a, T& b, T& c, T& d) {
  if constexpr (width_of<T> == 1) {
    const ScalarOf<T>* const of = record(base, index[0]);
    a = of[0];
    b = of[1];
    c = of[2];
    d = of[3];
  } else {
    for (int i = 0; i < width_of<T>; ++i) {
      const ScalarOf<T>* const of = record(base, index[i]);
      a[i] = of[0];
      b[i] = of[1];
      c[i] = of[2];
      d[i] = of[3];
    }
  }
}

template <class N, class T>
PINBALL_FUNCTION void add_lanes(N* base, const std::int32_t* index, const T& a, const T& b, const T& c, const T& d) {
  for (int i = 0; i < width_of<T>; ++i) {
    N* const of = record(base, index[i]);
    of[0] += lane(a, i);
    of[1] += lane(b, i);
    of[2] += lane(c, i);
    of[3] += lane(d, i);
  }
}

#if defined(__AVX2__) && !defined(PINBALL_DEVICE_COMPILER)

// Transposes in the compilers' vector types: __builtin_shufflevector(a, b, i...) picks elements of the pair (a, b).
using Double4 = double __attribute__((vector_size(32)));
using Float4 = float __attribute__((vector_size(16)));
using Float8 = float __attribute__((vector_size(32)));

template <class V, class S>
PINBALL_FUNCTION V load_record(const S* base, std::int32_t index) {
  return *reinterpret_cast<const V*>(record(base, index));
}
template <class V, class S>
PINBALL_FUNCTION void add_record(S* base, std::int32_t index, V value) {
  *reinterpret_cast<V*>(record(base, index)) += value;
}
PINBALL_FUNCTION void add_record(double* base, std::int32_t index, Float4 value) {
  // GCC 12 makes two conversions and an insertion of __builtin_convertvector.
  add_record(base, index, Double4(_mm256_cvtps_pd(__m128(value))));
}

// Four records of four doubles, or in each 128-bit chunk of a row four floats: a plain 4 x 4 transpose.
PINBALL_FUNCTION void transpose_4(Double4& r0, Double4& r1, Double4& r2, Double4& r3) {
  const Double4 ac01 = __builtin_shufflevector(r0, r1, 0, 4, 2, 6), bd01 = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
  const Double4 ac23 = __builtin_shufflevector(r2, r3, 0, 4, 2, 6), bd23 = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
  r0 = __builtin_shufflevector(ac01, ac23, 0, 1, 4, 5);
  r1 = __builtin_shufflevector(bd01, bd23, 0, 1, 4, 5);
  r2 = __builtin_shufflevector(ac01, ac23, 2, 3, 6, 7);
  r3 = __builtin_shufflevector(bd01, bd23, 2, 3, 6, 7);
}
PINBALL_FUNCTION void transpose_4(Float8& r0, Float8& r1, Float8& r2, Float8& r3) {
  const Float8 ab01 = __builtin_shufflevector(r0, r1, 0, 8, 1, 9, 4, 12, 5, 13);
  const Float8 cd01 = __builtin_shufflevector(r0, r1, 2, 10, 3, 11, 6, 14, 7, 15);
  const Float8 ab23 = __builtin_shufflevector(r2, r3, 0, 8, 1, 9, 4, 12, 5, 13);
  const Float8 cd23 = __builtin_shufflevector(r2, r3, 2, 10, 3, 11, 6, 14, 7, 15);
  r0 = __builtin_shufflevector(ab01, ab23, 0, 1, 8, 9, 4, 5, 12, 13);
  r1 = __builtin_shufflevector(ab01, ab23, 2, 3, 10, 11, 6, 7, 14, 15);
  r2 = __builtin_shufflevector(cd01, cd23, 0, 1, 8, 9, 4, 5, 12, 13);
  r3 = __builtin_shufflevector(cd01, cd23, 2, 3, 10, 11, 6, 7, 14, 15);
}
PINBALL_FUNCTION void gather_wide(const double* base, const std::int32_t* index, Double4& a, Double4& b, Double4& c,
                                  Double4& d) {
  a = load_record<Double4>(base, index[0]);
  b = load_record<Double4>(base, index[1]);
  c = load_record<Double4>(base, index[2]);
  d = load_record<Double4>(base, index[3]);
  transpose_4(a, b, c, d);
}
PINBALL_FUNCTION void add_wide(double* base, const std::int32_t* index, Double4 a, Double4 b, Double4 c, Double4 d) {
  transpose_4(a, b, c, d);
  add_record(base, index[0], a);
  add_record(base, index[1], b);
  add_record(base, index[2], c);
  add_record(base, index[3], d);
}
PINBALL_FUNCTION Float8 join(Float4 low, Float4 high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
PINBALL_FUNCTION Float8 load_row(const float* base, const std::int32_t* index) {
  return join(load_record<Float4>(base, index[0]), load_record<Float4>(base, index[4]));
}
PINBALL_FUNCTION void gather_wide(const float* base, const std::int32_t* index, Float8& a, Float8& b, Float8& c,
                                  Float8& d) {
  a = load_row(base, index);
  b = load_row(base, index + 1);
  c = load_row(base, index + 2);
  d = load_row(base, index + 3);
  transpose_4(a, b, c, d);
}
PINBALL_FUNCTION Float4 low_half(Float8 a) { return __builtin_shufflevector(a, a, 0, 1, 2, 3); }
PINBALL_FUNCTION Float4 high_half(Float8 a) { return __builtin_shufflevector(a, a, 4, 5, 6, 7); }
template <class N>
PINBALL_FUNCTION void add_wide(N* base, const std::int32_t* index, Float8 a, Float8 b, Float8 c, Float8 d) {
  transpose_4(a, b, c, d);
  // Lane after lane: the order of the sums is that of the scalar kernel.
  add_record(base, index[0], low_half(a));
  add_record(base, index[1], low_half(b));
  add_record(base, index[2], low_half(c));
  add_record(base, index[3], low_half(d));
  add_record(base, index[4], high_half(a));
  add_record(base, index[5], high_half(b));
  add_record(base, index[6], high_half(c));
  add_record(base, index[7], high_half(d));
}
template <class T>
inline constexpr bool has_wide_records = width_of<T> * sizeof(ScalarOf<T>) == 32 ||
                                         (has_512_bits && width_of<T> * sizeof(ScalarOf<T>) == 64);
template <class S, int W>
struct WideType;
template <>
struct WideType<double, 4> {
  using Type = Double4;
};
template <>
struct WideType<float, 8> {
  using Type = Float8;
};

#else

template <class T>
inline constexpr bool has_wide_records = false;

#endif

#if defined(__AVX512F__) && !defined(PINBALL_DEVICE_COMPILER)

using Double8 = double __attribute__((vector_size(64)));
using Float16 = float __attribute__((vector_size(64)));
template <>
struct WideType<double, 8> {
  using Type = Double8;
};
template <>
struct WideType<float, 16> {
  using Type = Float16;
};

// Eight records of four doubles. Loading records (0,2) (1,3) (4,6) (5,7) as pairs makes the transposed lanes come out
// in natural order after one unpack and one shuffle.
PINBALL_FUNCTION Double8 load_pair(const double* base, std::int32_t low, std::int32_t high) {
  // vinsertf64x4 with its second operand in memory; from a shuffle GCC makes a load and a shuffle.
  const __m512d first = _mm512_castpd256_pd512(_mm256_load_pd(record(base, low)));
  return Double8(_mm512_insertf64x4(first, _mm256_load_pd(record(base, high)), 1));
}
PINBALL_FUNCTION void gather_wide(const double* base, const std::int32_t* index, Double8& a, Double8& b, Double8& c,
                                  Double8& d) {
  const Double8 r02 = load_pair(base, index[0], index[2]), r13 = load_pair(base, index[1], index[3]);
  const Double8 r46 = load_pair(base, index[4], index[6]), r57 = load_pair(base, index[5], index[7]);
  const Double8 ac0 = __builtin_shufflevector(r02, r13, 0, 8, 2, 10, 4, 12, 6, 14);
  const Double8 bd0 = __builtin_shufflevector(r02, r13, 1, 9, 3, 11, 5, 13, 7, 15);
  const Double8 ac1 = __builtin_shufflevector(r46, r57, 0, 8, 2, 10, 4, 12, 6, 14);
  const Double8 bd1 = __builtin_shufflevector(r46, r57, 1, 9, 3, 11, 5, 13, 7, 15);
  a = __builtin_shufflevector(ac0, ac1, 0, 1, 4, 5, 8, 9, 12, 13);
  b = __builtin_shufflevector(bd0, bd1, 0, 1, 4, 5, 8, 9, 12, 13);
  c = __builtin_shufflevector(ac0, ac1, 2, 3, 6, 7, 10, 11, 14, 15);
  d = __builtin_shufflevector(bd0, bd1, 2, 3, 6, 7, 10, 11, 14, 15);
}
PINBALL_FUNCTION void add_wide(double* base, const std::int32_t* index, Double8 a, Double8 b, Double8 c, Double8 d) {
  const Double8 ab_even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const Double8 ab_odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  const Double8 cd_even = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
  const Double8 cd_odd = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  const Double8 r02 = __builtin_shufflevector(ab_even, cd_even, 0, 1, 8, 9, 2, 3, 10, 11);
  const Double8 r13 = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 8, 9, 2, 3, 10, 11);
  const Double8 r46 = __builtin_shufflevector(ab_even, cd_even, 4, 5, 12, 13, 6, 7, 14, 15);
  const Double8 r57 = __builtin_shufflevector(ab_odd, cd_odd, 4, 5, 12, 13, 6, 7, 14, 15);
  // Lane after lane: the order of the sums is that of the scalar kernel.
  add_record(base, index[0], __builtin_shufflevector(r02, r02, 0, 1, 2, 3));
  add_record(base, index[1], __builtin_shufflevector(r13, r13, 0, 1, 2, 3));
  add_record(base, index[2], __builtin_shufflevector(r02, r02, 4, 5, 6, 7));
  add_record(base, index[3], __builtin_shufflevector(r13, r13, 4, 5, 6, 7));
  add_record(base, index[4], __builtin_shufflevector(r46, r46, 0, 1, 2, 3));
  add_record(base, index[5], __builtin_shufflevector(r57, r57, 0, 1, 2, 3));
  add_record(base, index[6], __builtin_shufflevector(r46, r46, 4, 5, 6, 7));
  add_record(base, index[7], __builtin_shufflevector(r57, r57, 4, 5, 6, 7));
}

// Sixteen records of four floats as two halves of eight.
PINBALL_FUNCTION Float16 join(Float8 low, Float8 high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}
// As of eight floats, in each 128-bit chunk of a row.
PINBALL_FUNCTION void transpose_4(Float16& r0, Float16& r1, Float16& r2, Float16& r3) {
  const auto low = [](Float16 a, Float16 b) {
    return __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
  };
  const auto high = [](Float16 a, Float16 b) {
    return __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
  };
  const auto low_pairs = [](Float16 a, Float16 b) {
    return __builtin_shufflevector(a, b, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29);
  };
  const auto high_pairs = [](Float16 a, Float16 b) {
    return __builtin_shufflevector(a, b, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31);
  };
  const Float16 ab01 = low(r0, r1), cd01 = high(r0, r1), ab23 = low(r2, r3), cd23 = high(r2, r3);
  r0 = low_pairs(ab01, ab23);
  r1 = high_pairs(ab01, ab23);
  r2 = low_pairs(cd01, cd23);
  r3 = high_pairs(cd01, cd23);
}

PINBALL_FUNCTION Float8 low_half(Float16 a) { return __builtin_shufflevector(a, a, 0, 1, 2, 3, 4, 5, 6, 7); }
PINBALL_FUNCTION Float8 high_half(Float16 a) { return __builtin_shufflevector(a, a, 8, 9, 10, 11, 12, 13, 14, 15); }
PINBALL_FUNCTION void gather_wide(const float* base, const std::int32_t* index, Float16& a, Float16& b, Float16& c,
                                  Float16& d) {
  Float8 low[4], high[4];
  gather_wide(base, index, low[0], low[1], low[2], low[3]);
  gather_wide(base, index + 8, high[0], high[1], high[2], high[3]);
  a = join(low[0], high[0]);
  b = join(low[1], high[1]);
  c = join(low[2], high[2]);
  d = join(low[3], high[3]);
}
template <class N>
PINBALL_FUNCTION void add_wide(N* base, const std::int32_t* index, Float16 a, Float16 b, Float16 c, Float16 d) {
  add_wide(base, index, low_half(a), low_half(b), low_half(c), low_half(d));
  add_wide(base, index + 8, high_half(a), high_half(b), high_half(c), high_half(d));
}

#endif

}  // namespace detail

/// a, b, c, d <- the four numbers of records index[0 .. W-1].
template <class T>
PINBALL_FUNCTION void gather_records(const ScalarOf<T>* base, const std::int32_t* index, T& a, T& b, T& c, T& d) {
  if constexpr (detail::has_wide_records<T>) {
#if defined(__AVX2__) && !defined(PINBALL_DEVICE_COMPILER)
    typename detail::WideType<ScalarOf<T>, width_of<T>>::Type ra, rb, rc, rd;
    detail::gather_wide(base, index, ra, rb, rc, rd);
    a = T(ra), b = T(rb), c = T(rc), d = T(rd);
#endif
  } else {
    detail::gather_lanes(base, index, a, b, c, d);
  }
}

/// The first three numbers of records index[0 .. W-1].
template <class T>
PINBALL_FUNCTION Vec3<T> gather_vectors(const ScalarOf<T>* base, const std::int32_t* index) {
  Vec3<T> v;
  T spare;
  gather_records(base, index, v.x, v.y, v.z, spare);
  return v;
}

/// records index[0 .. W-1] += (a, b, c, d), lane after lane, in the precision of the records.
template <class N, class T>
PINBALL_FUNCTION void add_to_records(N* base, const std::int32_t* index, const T& a, const T& b, const T& c,
                                     const T& d) {
  if constexpr (detail::has_wide_records<T>) {
#if defined(__AVX2__) && !defined(PINBALL_DEVICE_COMPILER)
    using Wide = typename detail::WideType<ScalarOf<T>, width_of<T>>::Type;
    detail::add_wide(base, index, static_cast<Wide>(a), static_cast<Wide>(b), static_cast<Wide>(c),
                     static_cast<Wide>(d));
#endif
  } else {
    detail::add_lanes(base, index, a, b, c, d);
  }
}

}  // namespace pinball

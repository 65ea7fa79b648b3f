#pragma once

#include <cstdint>

#include "gather.hpp"

/// Mixed precision: nodes in double, the work of elements in single precision.
///
/// What an element needs of its corners are differences, so these are taken before anything is rounded: an element far
/// from the origin, or in fast flight, loses nothing. Corners 1, 3, 4 and 7 are taken against corner 0, corners 2, 5
/// and 6 against corner 1, and 1 against 0 is added in single precision. So in a row of elements along the first axis,
/// each of which has corner 1 where the next has corner 0, the differences of 2, 5 and 6 are those of 3, 4 and 7 of the
/// next, bit by bit (a row can be fetched by its nodes, not by its corners).
namespace pinball {

namespace detail {

/// value - origin of one lane, rounded.
template <class E, class N>
PINBALL_FUNCTION Vec3<E> difference(const N* of, const N* origin) {
  return {static_cast<E>(of[0] - origin[0]), static_cast<E>(of[1] - origin[1]), static_cast<E>(of[2] - origin[2])};
}

template <class T, int L, class N>
PINBALL_FUNCTION void differences_by_lanes(const N* base, const std::int32_t* corner, Vec3<T> (&value)[8]) {
  using E = ScalarOf<T>;
  for (int i = 0; i < 8; ++i) {
    const int origin = i == 2 || i == 5 || i == 6 ? 1 : 0;
    for (int l = 0; l < width_of<T>; ++l) {
      const Vec3<E> d = difference<E>(record(base, corner[i * L + l]), record(base, corner[origin * L + l]));
      if constexpr (width_of<T> == 1) {
        value[i] = d;
      } else {
        value[i].x[l] = d.x;
        value[i].y[l] = d.y;
        value[i].z[l] = d.z;
      }
    }
  }
}

template <class T, class N>
inline constexpr bool has_wide_differences = false;

#if defined(__AVX2__) && !defined(PINBALL_DEVICE_COMPILER)

template <>
inline constexpr bool has_wide_differences<Pack<float, 8>, double> = true;

// GCC 12 makes two conversions and an insertion of __builtin_convertvector.
PINBALL_FUNCTION Double4 widened(Float4 a) { return Double4(_mm256_cvtps_pd(__m128(a))); }
PINBALL_FUNCTION Float4 narrowed(Double4 a) { return Float4(_mm256_cvtpd_ps(__m256d(a))); }

/// Records of the eight lanes of a pack of floats at one corner, in double; row k has those of lanes k and k + 4.
struct RowsOf8 {
#if defined(__AVX512F__)
  Double8 row[4];
  PINBALL_FUNCTION RowsOf8(const double* base, const std::int32_t* index)
      : row{load_pair(base, index[0], index[4]), load_pair(base, index[1], index[5]),
            load_pair(base, index[2], index[6]), load_pair(base, index[3], index[7])} {}
  PINBALL_FUNCTION Float8 minus(const RowsOf8& origin, int k) const {
    return Float8(_mm512_cvtpd_ps(__m512d(row[k] - origin.row[k])));
  }
#else
  Double4 low[4], high[4];
  PINBALL_FUNCTION RowsOf8(const double* base, const std::int32_t* index)
      : low{load_record<Double4>(base, index[0]), load_record<Double4>(base, index[1]),
            load_record<Double4>(base, index[2]), load_record<Double4>(base, index[3])},
        high{load_record<Double4>(base, index[4]), load_record<Double4>(base, index[5]),
             load_record<Double4>(base, index[6]), load_record<Double4>(base, index[7])} {}
  PINBALL_FUNCTION Float8 minus(const RowsOf8& origin, int k) const {
    return join(narrowed(low[k] - origin.low[k]), narrowed(high[k] - origin.high[k]));
  }
#endif
};

template <int W>
struct RowsOf {
  using Type = RowsOf8;
};

PINBALL_FUNCTION void set_differences(const RowsOf8& of, const RowsOf8& origin, Vec3<Pack<float, 8>>& value) {
  Float8 r0 = of.minus(origin, 0), r1 = of.minus(origin, 1), r2 = of.minus(origin, 2), r3 = of.minus(origin, 3);
  transpose_4(r0, r1, r2, r3);
  using T = Pack<float, 8>;
  value = {T(r0), T(r1), T(r2)};
}

PINBALL_FUNCTION void add_wide(double* base, const std::int32_t* index, Float8 a, Float8 b, Float8 c, Float8 d) {
  transpose_4(a, b, c, d);
  add_record(base, index[0], widened(low_half(a)));
  add_record(base, index[1], widened(low_half(b)));
  add_record(base, index[2], widened(low_half(c)));
  add_record(base, index[3], widened(low_half(d)));
  add_record(base, index[4], widened(high_half(a)));
  add_record(base, index[5], widened(high_half(b)));
  add_record(base, index[6], widened(high_half(c)));
  add_record(base, index[7], widened(high_half(d)));
}

#endif

#if defined(__AVX512F__) && !defined(PINBALL_DEVICE_COMPILER)

template <>
inline constexpr bool has_wide_differences<Pack<float, 16>, double> = true;

struct RowsOf16 {
  RowsOf8 low, high;
  PINBALL_FUNCTION RowsOf16(const double* base, const std::int32_t* index) : low(base, index), high(base, index + 8) {}
  PINBALL_FUNCTION Float16 minus(const RowsOf16& origin, int k) const {
    return join(low.minus(origin.low, k), high.minus(origin.high, k));
  }
};

template <>
struct RowsOf<16> {
  using Type = RowsOf16;
};
PINBALL_FUNCTION Float16 lanes_of(const Pack<float, 16>& a) { return static_cast<Float16>(a); }

/// The same as of eight floats, in each 128-bit chunk of a row.
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

PINBALL_FUNCTION void set_differences(const RowsOf16& of, const RowsOf16& origin, Vec3<Pack<float, 16>>& value) {
  Float16 r0 = of.minus(origin, 0), r1 = of.minus(origin, 1), r2 = of.minus(origin, 2), r3 = of.minus(origin, 3);
  transpose_4(r0, r1, r2, r3);
  using T = Pack<float, 16>;
  value = {T(r0), T(r1), T(r2)};
}

/// Elements of a pack of 16 behind which no other follows in a row along their first axis, in which each has its
/// corners 1, 2, 5 and 6 where the next has 0, 3, 4 and 7: the last of all, and where rows end. Bit i: element i.
PINBALL_FUNCTION unsigned ends_of_rows(const std::int32_t* corner) {
  const auto equal = [corner](int of, int of_next) {
    // Of the last element the next number is that of another corner: it does not count.
    return _mm512_cmpeq_epi32_mask(_mm512_load_si512(corner + 16 * of), _mm512_loadu_si512(corner + 16 * of_next + 1));
  };
  return 0xffffu & ~(0x7fffu & equal(1, 0) & equal(2, 3) & equal(5, 4) & equal(6, 7));
}
inline constexpr int most_ends = 6;  ///< of rows in a pack, for which it pays to fetch rows

/// Of each element what the next one has.
PINBALL_FUNCTION Vec3<Pack<float, 16>> of_next(const Vec3<Pack<float, 16>>& value) {
  using T = Pack<float, 16>;
  const auto shifted = [](const T& a) {
    const Float16 lanes = lanes_of(a);
    return T(__builtin_shufflevector(lanes, lanes, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 15));
  };
  return {shifted(value.x), shifted(value.y), shifted(value.z)};
}

/// What the elements of rows have in common is fetched once. The same bits as of elements that lie anywhere.
PINBALL_FUNCTION void gather_rows(const double* base, const std::int32_t* corner, unsigned ends,
                                  Vec3<Pack<float, 16>> (&value)[8]) {
  const RowsOf16 at_0(base, corner);
  set_differences(RowsOf16(base, corner + 16), at_0, value[1]);
  set_differences(RowsOf16(base, corner + 3 * 16), at_0, value[3]);
  set_differences(RowsOf16(base, corner + 4 * 16), at_0, value[4]);
  set_differences(RowsOf16(base, corner + 7 * 16), at_0, value[7]);
  constexpr int near[3] = {3, 4, 7}, far[3] = {2, 5, 6};
  PINBALL_UNROLL
  for (int i = 0; i < 3; ++i) value[far[i]] = of_next(value[near[i]]);
  for (; ends != 0; ends &= ends - 1) {
    const int lane = __builtin_ctz(ends);
    const __mmask16 mask = 1u << lane;
    const Double4 origin = load_record<Double4>(base, corner[16 + lane]);
    PINBALL_UNROLL
    for (int i = 0; i < 3; ++i) {
      const Double4 of = load_record<Double4>(base, corner[16 * far[i] + lane]);
      const __m128 d = _mm256_cvtpd_ps(of - origin);
      Vec3<Pack<float, 16>>& v = value[far[i]];
      const auto put = [mask](Pack<float, 16>& to, __m128 number) {
        to = Pack<float, 16>(_mm512_mask_broadcastss_ps(__m512(lanes_of(to)), mask, number));
      };
      put(v.x, d);
      put(v.y, _mm_movehdup_ps(d));
      put(v.z, _mm_unpackhi_ps(d, d));
    }
  }
}

template <int chunk>
PINBALL_FUNCTION Double4 widened(Float16 a) {
  return widened(__builtin_shufflevector(a, a, 4 * chunk, 4 * chunk + 1, 4 * chunk + 2, 4 * chunk + 3));
}
template <int chunk>
PINBALL_FUNCTION void add_chunk(double* base, const std::int32_t* index, Float16 a, Float16 b, Float16 c, Float16 d) {
  add_record(base, index[4 * chunk], widened<chunk>(a));
  add_record(base, index[4 * chunk + 1], widened<chunk>(b));
  add_record(base, index[4 * chunk + 2], widened<chunk>(c));
  add_record(base, index[4 * chunk + 3], widened<chunk>(d));
}
PINBALL_FUNCTION void add_wide(double* base, const std::int32_t* index, Float16 a, Float16 b, Float16 c, Float16 d) {
  transpose_4(a, b, c, d);
  add_chunk<0>(base, index, a, b, c, d);
  add_chunk<1>(base, index, a, b, c, d);
  add_chunk<2>(base, index, a, b, c, d);
  add_chunk<3>(base, index, a, b, c, d);
}

#endif

#if defined(__AVX2__) && !defined(PINBALL_DEVICE_COMPILER)

template <class T, int L>
PINBALL_FUNCTION void gather_wide_differences(const double* base, const std::int32_t* corner, Vec3<T> (&value)[8]) {
  using Rows = typename RowsOf<width_of<T>>::Type;
#if defined(__AVX512F__)
  if constexpr (width_of<T> == 16 && L == 16) {
    const unsigned ends = ends_of_rows(corner);
    if (__builtin_popcount(ends) <= most_ends) {
      gather_rows(base, corner, ends, value);
      return;
    }
  }
#endif
  const Rows at_0(base, corner), at_1(base, corner + L);
  set_differences(at_1, at_0, value[1]);
  set_differences(Rows(base, corner + 3 * L), at_0, value[3]);
  set_differences(Rows(base, corner + 2 * L), at_1, value[2]);
  set_differences(Rows(base, corner + 4 * L), at_0, value[4]);
  set_differences(Rows(base, corner + 5 * L), at_1, value[5]);
  set_differences(Rows(base, corner + 7 * L), at_0, value[7]);
  set_differences(Rows(base, corner + 6 * L), at_1, value[6]);
}

#endif

}  // namespace detail

/// Whether most elements of a pack have their corners 1, 2, 5 and 6 where others of it have 0, 3, 4 and 7. False where
/// that takes longer to find out than it is worth. corner: in rows of W.
template <class T>
PINBALL_FUNCTION bool lie_in_rows([[maybe_unused]] const std::int32_t* corner) {
#if defined(__AVX512F__) && !defined(PINBALL_DEVICE_COMPILER)
  if constexpr (width_of<T> == 16) return __builtin_popcount(detail::ends_of_rows(corner)) <= detail::most_ends;
#endif
  return false;
}

/// The numbers of the records at the corners of a pack's elements, less those at corner 0, where nodes have more digits
/// than elements; as they are where they have the same. L: of the rows (ElementView).
template <class T, int L, class N>
PINBALL_FUNCTION void gather_corners(const N* base, const std::int32_t* corner, Vec3<T> (&value)[8]) {
  if constexpr (sizeof(N) == sizeof(ScalarOf<T>)) {
    PINBALL_UNROLL
    for (int i = 0; i < 8; ++i) value[i] = gather_vectors<T>(base, corner + i * L);
  } else {
    value[0] = {T(0), T(0), T(0)};
    if constexpr (detail::has_wide_differences<T, N>) {
#if defined(__AVX2__) && !defined(PINBALL_DEVICE_COMPILER)
      detail::gather_wide_differences<T, L>(base, corner, value);
#endif
    } else {
      detail::differences_by_lanes<T, L>(base, corner, value);
    }
    value[2] = value[2] + value[1];
    value[5] = value[5] + value[1];
    value[6] = value[6] + value[1];
  }
}

namespace detail {

/// -(a_1 + ... + a_7) in double, of one component of the forces of corners 0 to 7.
template <class N, class T>
PINBALL_FUNCTION void balance_by_lanes(const T (&a)[8], N* sum) {
  for (int l = 0; l < width_of<T>; ++l) {
    sum[l] = lane(a[1], l);
    for (int i = 2; i < 8; ++i) sum[l] += lane(a[i], l);
    sum[l] = -sum[l];
  }
}

#if defined(__AVX512F__) && !defined(PINBALL_DEVICE_COMPILER)
PINBALL_FUNCTION void balance_wide(const Pack<float, 16> (&a)[8], Double8& low, Double8& high) {
  const auto wide = [](Float8 half) { return Double8(_mm512_cvtps_pd(__m256(half))); };
  low = wide(low_half(lanes_of(a[1])));
  high = wide(high_half(lanes_of(a[1])));
  PINBALL_UNROLL
  for (int i = 2; i < 8; ++i) {
    low += wide(low_half(lanes_of(a[i])));
    high += wide(high_half(lanes_of(a[i])));
  }
  low = -low, high = -high;
}
#endif

}  // namespace detail

/// Adds the forces of corner 0 to records index[0 .. W-1]: not those that are given, but what balances those of corners
/// 1 to 7, to the last digit of the records. What is rounded in the elements then moves no centre of mass.
template <class N, class T>
PINBALL_FUNCTION void add_balance_to_records(N* base, const std::int32_t* index, const Vec3<T> (&value)[8]) {
  const T x[8] = {value[0].x, value[1].x, value[2].x, value[3].x, value[4].x, value[5].x, value[6].x, value[7].x};
  const T y[8] = {value[0].y, value[1].y, value[2].y, value[3].y, value[4].y, value[5].y, value[6].y, value[7].y};
  const T z[8] = {value[0].z, value[1].z, value[2].z, value[3].z, value[4].z, value[5].z, value[6].z, value[7].z};
#if defined(__AVX512F__) && !defined(PINBALL_DEVICE_COMPILER)
  if constexpr (detail::has_wide_differences<T, N> && width_of<T> == 16) {
    detail::Double8 low[3], high[3];
    detail::balance_wide(x, low[0], high[0]);
    detail::balance_wide(y, low[1], high[1]);
    detail::balance_wide(z, low[2], high[2]);
    const detail::Double8 none{};
    detail::add_wide(base, index, low[0], low[1], low[2], none);
    detail::add_wide(base, index + 8, high[0], high[1], high[2], none);
    return;
  }
#endif
  N sum[3][width_of<T>];
  detail::balance_by_lanes(x, sum[0]);
  detail::balance_by_lanes(y, sum[1]);
  detail::balance_by_lanes(z, sum[2]);
  for (int l = 0; l < width_of<T>; ++l) {
    for (int k = 0; k < 3; ++k) record(base, index[l])[k] += sum[k][l];
  }
}

/// records index[0 .. W-1] += (a, b, c, d), lane after lane, in the precision of the records.
template <class N, class T>
PINBALL_FUNCTION void add_forces_to_records(N* base, const std::int32_t* index, const T& a, const T& b, const T& c,
                                            const T& d) {
  if constexpr (sizeof(N) == sizeof(ScalarOf<T>)) {
    add_to_records(base, index, a, b, c, d);
  } else if constexpr (detail::has_wide_differences<T, N>) {
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

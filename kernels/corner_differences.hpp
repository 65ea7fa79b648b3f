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

template <class Rows, class T>
PINBALL_FUNCTION void set_differences(const Rows& of, const Rows& origin, Vec3<T>& value) {
  auto r0 = of.minus(origin, 0), r1 = of.minus(origin, 1), r2 = of.minus(origin, 2), r3 = of.minus(origin, 3);
  transpose_4(r0, r1, r2, r3);
  value = {T(r0), T(r1), T(r2)};
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

/// Elements of a pack of 16 behind which no other follows in a row along their first axis, in which each has its
/// corners 1, 2, 5 and 6 where the next has 0, 3, 4 and 7: the last of all, and where rows end. Bit i: element i.
PINBALL_FUNCTION unsigned ends_of_rows(const std::int32_t* corner) {
  const auto equal = [corner](int of, int of_next) {
    // The last element's next number is that of another corner, or behind the pack: it is not fetched.
    const __m512i next = _mm512_maskz_loadu_epi32(0x7fff, corner + 16 * of_next + 1);
    return _mm512_mask_cmpeq_epi32_mask(0x7fff, _mm512_load_si512(corner + 16 * of), next);
  };
  return 0xffffu & ~unsigned(equal(1, 0) & equal(2, 3) & equal(5, 4) & equal(6, 7));
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

/// -(a_1 + ... + a_7) in double, of a component of the forces of corners 0 to 7, lane after lane.
template <class N, class T>
PINBALL_FUNCTION void balance_by_lanes(const Vec3<T> (&value)[8], T Vec3<T>::*component, N* sum) {
  for (int l = 0; l < width_of<T>; ++l) {
    sum[l] = lane(value[1].*component, l);
    for (int i = 2; i < 8; ++i) sum[l] += lane(value[i].*component, l);
    sum[l] = -sum[l];
  }
}

#if defined(__AVX512F__) && !defined(PINBALL_DEVICE_COMPILER)

/// Of eight lanes.
template <class Half>
PINBALL_FUNCTION Double8 balance_of_half(const Vec3<Pack<float, 16>> (&value)[8],
                                         Pack<float, 16> Vec3<Pack<float, 16>>::*component, const Half& half) {
  const auto wide = [&](int i) { return Double8(_mm512_cvtps_pd(__m256(half(lanes_of(value[i].*component))))); };
  Double8 sum = wide(1);
  PINBALL_UNROLL
  for (int i = 2; i < 8; ++i) sum += wide(i);
  return -sum;
}

#endif

}  // namespace detail

/// Adds the forces of corner 0 to records index[0 .. W-1]: not those that are given, but what balances those of corners
/// 1 to 7, to the last digit of the records. What is rounded in the elements then moves no centre of mass.
template <class N, class T>
PINBALL_FUNCTION void add_balance_to_records(N* base, const std::int32_t* index, const Vec3<T> (&value)[8]) {
  using V = Vec3<T>;
#if defined(__AVX512F__) && !defined(PINBALL_DEVICE_COMPILER)
  if constexpr (detail::has_wide_differences<T, N> && width_of<T> == 16) {
    const auto add_half = [&](const std::int32_t* of_half, const auto& half) __attribute__((always_inline)) {
      detail::add_wide(base, of_half, detail::balance_of_half(value, &V::x, half),
                       detail::balance_of_half(value, &V::y, half), detail::balance_of_half(value, &V::z, half),
                       detail::Double8{});
    };
    add_half(index, [](detail::Float16 a) { return detail::low_half(a); });
    add_half(index + 8, [](detail::Float16 a) { return detail::high_half(a); });
    return;
  }
#endif
  N sum[3][width_of<T>];
  detail::balance_by_lanes(value, &V::x, sum[0]);
  detail::balance_by_lanes(value, &V::y, sum[1]);
  detail::balance_by_lanes(value, &V::z, sum[2]);
  for (int l = 0; l < width_of<T>; ++l) {
    for (int k = 0; k < 3; ++k) record(base, index[l])[k] += sum[k][l];
  }
}

}  // namespace pinball

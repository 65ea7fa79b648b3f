#pragma once

#include <cstdint>

#include "gather.hpp"
#include "macros.hpp"
#include "simd.hpp"
#include "tensor.hpp"

/// Contact constraints enforced by impulses: find p >= 0 such that
///
///     u_i = sum_I G_iI . v_I + r_i <= 0 ,   p_i >= 0 ,   p_i u_i = 0 ,     v_I = v*_I - sum_i M_I^-1 G_iI p_i ,
///
/// G_iI = w_iI a_i (contact_row.hpp). r_i: the rate at which an open gap may still close (negative) or a penetration is
/// to be pushed out (positive). M_I^-1 is a tensor: a constraint leaves its node no mobility along its direction.
///
/// v is unique: it is the nearest to v* in the norm of the mass among those that close no gap. p is not where more rows
/// meet than nodes can follow, as in any flat contact; the sweeps below do not mind.
///
/// Rows lie in packs: W rows that share no node. A kernel works on one pack, each lane being a row; velocities are
/// records of four numbers, the fourth of which is scratch of the projection and else zero.
namespace pinball {

/// M^-1 of a node.
struct ImpulseNode {
  double inverse_mass[6];  ///< xx yy zz xy yz zx [1/mass]
  bool held;               ///< in some direction: else the tensor is a number
};

/// The numbers of a row, each of them a pack.
enum RowNumber : int {
  row_direction = 0,  ///< a, three numbers
  row_rate = 3,       ///< r [length/time]
  row_inverse_mass,   ///< G M^-1 G^T [1/mass]
  row_mass,           ///< its inverse [mass]
  row_impulse,        ///< p; where the sweeps begin
  row_numbers
};

/// A pack of rows. What a row lacks is filled so that it changes nothing: entries beyond those of the row have its
/// first node and zeros, lanes without a row the first node of the pack and zeros throughout.
struct RowPack {
  int entries;               ///< nodes per row
  bool held;                 ///< at least one of the nodes is, in some direction
  const std::int32_t* node;  ///< [entries][W], of the velocities
  /// [entries][2][W]: w, w/m; or, where a node is held, [entries][7][W]: w and w M^-1 as xx yy zz xy yz zx.
  const double* entry;
  double* number;    ///< [row_numbers][W]
  double* friction;  ///< [friction_numbers][W] (contact_friction.hpp), or null

  PINBALL_FUNCTION int stride() const { return held ? 7 : 2; }  ///< packs of numbers per entry
};

template <class T>
PINBALL_FUNCTION T row_number(const RowPack& row, int which) {
  return load<T>(row.number + which * width_of<T>);
}
template <class T>
PINBALL_FUNCTION T entry_number(const RowPack& row, int entry, int which) {
  return load<T>(row.entry + (entry * row.stride() + which) * width_of<T>);
}
template <class T>
PINBALL_FUNCTION Vec3<T> direction_of(const RowPack& row) {
  return {row_number<T>(row, row_direction), row_number<T>(row, row_direction + 1),
          row_number<T>(row, row_direction + 2)};
}
/// w M^-1 of an entry of held nodes.
template <class T>
PINBALL_FUNCTION Symmetric<T> entry_mobility(const RowPack& row, int entry) {
  return {entry_number<T>(row, entry, 1), entry_number<T>(row, entry, 2), entry_number<T>(row, entry, 3),
          entry_number<T>(row, entry, 4), entry_number<T>(row, entry, 5), entry_number<T>(row, entry, 6)};
}

/// A row by itself has no lanes to fill: there the components of a vector do.
template <class T>
inline constexpr bool lanes_are_components = width_of<T> == 1 && native_width<double> >= 4;
using NodeRecord = Pack<double, native_width<double> >= 4 ? 4 : 1>;

/// sum_I w_I v_I: what the sides of a row move towards each other.
template <class T>
PINBALL_FUNCTION Vec3<T> approach(const RowPack& row, const double* velocity) {
  Vec3<T> sum{T(0), T(0), T(0)};
  if constexpr (lanes_are_components<T>) {
    NodeRecord all = 0;
    for (int k = 0; k < row.entries; ++k) {
      all += entry_number<T>(row, k, 0) * load<NodeRecord>(velocity + 4 * static_cast<std::int64_t>(row.node[k]));
    }
    return {lane(all, 0), lane(all, 1), lane(all, 2)};
  }
  for (int k = 0; k < row.entries; ++k) {
    sum = sum + entry_number<T>(row, k, 0) * gather_vectors<T>(velocity, row.node + k * width_of<T>);
  }
  return sum;
}

/// sum_I G_I . v_I.
template <class T>
PINBALL_FUNCTION T closing_rate(const RowPack& row, const double* velocity) {
  return dot(direction_of<T>(row), approach<T>(row, velocity));
}

/// v_I <- v_I - w_I M_I^-1 b. b: impulse of each row, a vector.
template <class T>
PINBALL_FUNCTION void take_impulse(const RowPack& row, const Vec3<T>& b, double* velocity) {
  if constexpr (lanes_are_components<T>) {
    if (!row.held) {
      alignas(sizeof(NodeRecord)) const double components[4] = {b.x, b.y, b.z, 0};
      const NodeRecord all = load<NodeRecord>(components);
      for (int k = 0; k < row.entries; ++k) {
        double* const v = velocity + 4 * static_cast<std::int64_t>(row.node[k]);
        store(load<NodeRecord>(v) - entry_number<T>(row, k, 1) * all, v);
      }
      return;
    }
  }
  for (int k = 0; k < row.entries; ++k) {
    const std::int32_t* node = row.node + k * width_of<T>;
    Vec3<T> change;
    if (row.held) {
      change = entry_mobility<T>(row, k) * b;
    } else {
      change = entry_number<T>(row, k, 1) * b;
    }
    add_to_records(velocity, node, T(0) - change.x, T(0) - change.y, T(0) - change.z, T(0));
  }
}

/// Gives the rows their impulses p.
template <class T>
PINBALL_FUNCTION void apply_impulses(const RowPack& row, double* velocity) {
  const T impulse = row_number<T>(row, row_impulse);
  if (any_lane(impulse != T(0))) take_impulse(row, impulse * direction_of<T>(row), velocity);
}

/// Projected Gauss-Seidel: each row closes its gap no more. Returns the change of the closing velocities; repeated over
/// all packs until that is small, this solves the coupled system.
template <class T>
PINBALL_FUNCTION T sweep_rows(const RowPack& row, double* velocity) {
  const Vec3<T> direction = direction_of<T>(row);
  const T closing = dot(direction, approach<T>(row, velocity)) + row_number<T>(row, row_rate);
  const T before = row_number<T>(row, row_impulse);
  const T impulse = maximum(T(0), before + closing * row_number<T>(row, row_mass));
  const T change = impulse - before;
  if (!any_lane(change != T(0))) return T(0);
  take_impulse(row, change * direction, velocity);
  store(impulse, row.number + row_impulse * width_of<T>);
  return absolute(change) * row_number<T>(row, row_inverse_mass);
}

/// Velocity projection: all rows see the same velocities, and each gives the share of its impulse that keeps their sum
/// from overshooting (a Jacobi sweep with |G M^-1 G^T| summed over the row, bounded node by node, in the place of the
/// diagonal). Exact where neighbours close alike; takes out energy, never adds it (but for r). Three functions, each of
/// them called for all packs before the next, and then apply_impulses.
///
/// The first: p is for now the closing velocity.
template <class T>
PINBALL_FUNCTION void find_closing(const RowPack& row, const double* velocity) {
  const T closing = closing_rate<T>(row, velocity) + row_number<T>(row, row_rate);
  store(maximum(T(0), closing), row.number + row_impulse * width_of<T>);
}
/// The second: sums |w| of the rows that close at each node.
template <class T>
PINBALL_FUNCTION void add_shares(const RowPack& row, double* velocity) {
  const T zero(0);
  const T closing = row_number<T>(row, row_impulse);
  if (!any_lane(closing > zero)) return;
  for (int k = 0; k < row.entries; ++k) {
    const T share = select(closing > zero, absolute(entry_number<T>(row, k, 0)), zero);
    add_to_records(velocity, row.node + k * width_of<T>, zero, zero, zero, share);
  }
}
/// The third: p.
template <class T>
PINBALL_FUNCTION void share_impulses(const RowPack& row, const double* velocity) {
  const T zero(0);
  const T closing = row_number<T>(row, row_impulse);
  if (!any_lane(closing > zero)) return;
  const Vec3<T> direction = direction_of<T>(row);
  T sum = zero;
  for (int k = 0; k < row.entries; ++k) {
    Vec3<T> push, v;
    if (row.held) {
      push = entry_mobility<T>(row, k) * direction;
    } else {
      push = entry_number<T>(row, k, 1) * direction;
    }
    T share;
    gather_records(velocity, row.node + k * width_of<T>, v.x, v.y, v.z, share);
    sum += share * square_root(dot(push, push));
  }
  const T impulse = closing / select(closing > zero, sum, T(1));
  store(impulse, row.number + row_impulse * width_of<T>);
}

}  // namespace pinball

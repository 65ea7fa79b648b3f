#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <kernels/contact_impulse.hpp>
#include <solver/base/records.hpp>
#include <solver/contact/surface/rigid_sides.hpp>

#include "contact_rows.hpp"

/// Rows whose nodes are of rigid bodies. Of all its nodes I on a body an impulse b of row i is
///
///     the impulse W b and the moment R x b about its centre,    W = sum_I w_iI ,   R = sum_I w_iI r_I ,
///
/// and its part of G M^-1 G^T along a is  m = W a . T (W a) + (R x a) . S (R x a)  with the mobilities T and S of the
/// body (rigid_sides.hpp), and 2 W a . C (R x a) more where its joints couple both. Of two rows that share a body, or
/// have bodies that hang together by joints, |G_i M^-1 G_j^T| is at most sqrt(m_i m_j).
namespace pinball {

/// The rigid bodies of those who own nodes, and the arms of the places that are of one.
struct RigidPlaces {
  const RigidSides* sides = nullptr;
  const double* arm = nullptr;  ///< records, per place: from the centre of its body [length]

  explicit operator bool() const { return sides != nullptr; }
  const RigidSide& side(std::int32_t body) const { return sides->bodies[body]; }
  std::int32_t first_of(std::int32_t body) const { return sides->first_of(body); }
  Vec3<double> arm_of(std::int32_t place) const { return vector_of(record(arm, place)); }
};

inline Vec3<double> coupled(const RigidSide& side, const Vec3<double>& moment) { return side.coupling * moment; }
inline Vec3<double> coupled_back(const RigidSide& side, const Vec3<double>& p) {
  return p.x * side.coupling[0] + p.y * side.coupling[1] + p.z * side.coupling[2];
}

/// What a row has of a rigid body.
struct RigidEntry {
  std::int32_t body = -1;
  double weight = 0;          ///< W [-]
  Vec3<double> arm{0, 0, 0};  ///< R [length]

  /// m along a direction, not below zero where rounding would have it there: roots are taken of it [1/mass].
  double along(const RigidSide& side, const Vec3<double>& a) const {
    const Vec3<double> turning = cross(arm, a);
    const double apart = weight * weight * dot(a, side.translation * a) + dot(turning, side.rotation * turning);
    if (side.mechanism < 0) return std::max(0.0, apart);
    return std::max(0.0, apart + 2 * weight * dot(a, coupled(side, turning)));
  }
  /// m along any direction, from above [1/mass].
  double most(const RigidSide& side) const {
    const double apart = weight * weight * side.most_translation + dot(arm, arm) * side.most_rotation;
    return side.mechanism < 0 ? apart : 2 * apart;
  }
};

/// Calls visit(entry) for each rigid body that moves and that a row has nodes of. nodes: per place.
template <class Visit>
void for_rigid_entries(const RowView& row, const ImpulseNode* nodes, const RigidPlaces& rigid, const Visit& visit) {
  for (int e = 0; e < row.nodes; ++e) {
    const std::int32_t body = nodes[row.node[e]].body;
    if (body < 0) continue;
    bool is_first = true;
    for (int before = 0; before < e && is_first; ++before) is_first = nodes[row.node[before]].body != body;
    if (!is_first) continue;
    RigidEntry entry{body};
    for (int i = e; i < row.nodes; ++i) {
      if (nodes[row.node[i]].body != body) continue;
      entry.weight += row.weight[i];
      entry.arm = entry.arm + row.weight[i] * rigid.arm_of(row.node[i]);
    }
    visit(entry);
  }
}

/// Change of velocity by an impulse p at an arm r from the centre: T p + (S (r x p)) x r, as a tensor.
inline Symmetric<double> mobility_at(const RigidSide& side, const Vec3<double>& r) {
  const auto of = [&](const Vec3<double>& p) {
    const Vec3<double> own = side.translation * p + cross(side.rotation * cross(r, p), r);
    if (side.mechanism < 0) return own;
    return own + coupled(side, cross(r, p)) + cross(coupled_back(side, p), r);
  };
  const Vec3<double> x = of({1, 0, 0}), y = of({0, 1, 0}), z = of({0, 0, 1});
  return {x.x, y.y, z.z, 0.5 * (x.y + y.x), 0.5 * (y.z + z.y), 0.5 * (z.x + x.z)};
}

}  // namespace pinball

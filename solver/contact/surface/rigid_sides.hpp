#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <kernels/tensor.hpp>

namespace pinball {

/// A tensor by its rows.
using RowTensor = std::array<Vec3<double>, 3>;

inline Vec3<double> operator*(const RowTensor& rows, const Vec3<double>& v) {
  return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
}

/// How a rigid body answers an impulse at the present place. Impulse P and moment D about its centre change the
/// velocity of the centre by `translation` P, and the angular velocity by `rotation` D; directions that are held or
/// moved as prescribed have no mobility. Where it is jointed these are with all that its joints move and hold, and the
/// changes are more by `coupling` D and its transpose times P.
///
/// A node at the arm r has the velocity v + w x r at the present time. On the way of a step it turns, and its mean
/// velocity, by which gaps close and nodes slide, is another one: v + w x r + way r. To first order in the step that is
/// dt/2 w x (w x r), towards the axis in the coming step and from it in the step just made.
struct RigidSide {
  Vec3<double> centre{};            ///< [length]
  Symmetric<double> translation{};  ///< 1/M where it is free [1/mass]
  Symmetric<double> rotation{};     ///< I^-1 where it is free [1/(mass length^2)]
  double most_translation = 0;      ///< largest principal value [1/mass]
  double most_rotation = 0;         ///< the same [1/(mass length^2)]
  std::int32_t mechanism = -1;      ///< number of what it is jointed with; -1: it has no joints
  std::int32_t in_mechanism = 0;    ///< number among its bodies
  RowTensor coupling{};             ///< [1/(mass length)]
  RowTensor way_before{};           ///< of the step just made [1/time]
  RowTensor way_after{};            ///< of the coming one, without contact [1/time]

  bool is_mobile() const { return most_translation > 0 || most_rotation > 0; }
};

/// Bodies that hang together by joints. What an impulse on one of them does to another contact has to know: `mobility`
/// is the matrix of all, six rows and columns a body, of velocity and angular velocity over impulse and moment.
struct RigidMechanism {
  std::vector<std::int32_t> bodies;  ///< ascending
  std::vector<double> mobility;      ///< row by row
};

/// The rigid bodies of whoever owns nodes, as contact sees them.
struct RigidSides {
  std::vector<std::int32_t> body_of_node;  ///< per node of the store; -1: it moves by itself
  std::vector<RigidSide> bodies;           ///< brought up to date before each step
  std::vector<RigidMechanism> mechanisms;  ///< the same

  /// The first body of all that hang together with this one.
  std::int32_t first_of(std::int32_t body) const {
    const std::int32_t mechanism = bodies[body].mechanism;
    return mechanism < 0 ? body : mechanisms[mechanism].bodies.front();
  }
};

}  // namespace pinball

#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include <solver/scene_rigid.hpp>

#include "rigid_body_motion.hpp"

/// What a joint asks of two bodies A and B, as rows g = 0. With the place p = c + R a of the joint on each of them, p_A
/// and p_B, and with directions d = R d_0 that are fixed in them, a row is one of
///
///     g = d_A . (p_B - p_A)      they stay together along a direction of A ,
///     g = u_A . w_B              a direction of A and one of B stay at right angles ,
///
/// spherical: three of the first kind; cylindrical: two, across the axis e_3, and of the second e_1 . e_3 and e_2 .
/// e_3; revolute: the rows of both; translational: two of the first kind across the axis, and e_1 . e_2, e_2 . e_3 and
/// e_3 . e_1; locking: these and all three; universal: three of the first kind and that the two axes stay at right
/// angles (Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, 1989, chapter 9).
///
/// The gradient of a row is a force f on B and -f on A along one line, or opposite moments, so that whatever a joint
/// does leaves both momenta of the two together:
///
///     f = d_A ,   m_B = (p_B - c_B) x d_A ,   m_A = -(p_B - c_A) x d_A ;      f = 0 ,   m_A = u_A x w_B = -m_B .
namespace pinball {

/// Where a body is; the ground by default.
struct BodyPlace {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< from the start
};
BodyPlace place_of(const RigidBodyMotion& motion);

/// The directions of a row at the start, of A and of B.
struct JointRow {
  bool turns = false;  ///< it is of the second kind
  Eigen::Vector3d first = Eigen::Vector3d::Zero(), second = Eigen::Vector3d::Zero();
};
/// joint: of a checked scene.
std::vector<JointRow> joint_rows(const Joint& joint);

/// The gradient of a row in space.
struct RowGradient {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< f
  Eigen::Vector3d first = Eigen::Vector3d::Zero();  ///< m_A
  Eigen::Vector3d second = Eigen::Vector3d::Zero();
};

/// A joint between two places; arms: a of A and B [length].
struct JointGeometry {
  BodyPlace first, second;
  Eigen::Vector3d arm_first, arm_second;

  Eigen::Vector3d place() const { return second.centre + second.rotation * arm_second; }  ///< p_B
  double value(const JointRow& row) const;
  RowGradient gradient(const JointRow& row) const;
};

}  // namespace pinball

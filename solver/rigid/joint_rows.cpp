#include "joint_rows.hpp"

#include "eigen_points.hpp"
#include "rigid_rotation.hpp"

namespace pinball {

BodyPlace place_of(const RigidBodyMotion& motion) { return {eigen(motion.state().centre), eigen(motion.rotation())}; }

std::vector<JointRow> joint_rows(const Joint& joint) {
  std::array<Eigen::Vector3d, 1> axis{eigen(joint.axis.value_or(Point{0, 0, 1}))};
  const Eigen::Matrix3d basis = axes_of(axis).basis;
  const Eigen::Vector3d e1 = basis.col(1), e2 = basis.col(2), e3 = basis.col(0);
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  const JointRow along_1{false, e1, none}, along_2{false, e2, none}, along_3{false, e3, none};
  switch (joint.kind) {
    case JointKind::spherical:
      return {along_1, along_2, along_3};
    case JointKind::revolute:
      return {along_1, along_2, along_3, {true, e1, e3}, {true, e2, e3}};
    case JointKind::cylindrical:
      return {along_1, along_2, {true, e1, e3}, {true, e2, e3}};
    case JointKind::translational:
      return {along_1, along_2, {true, e1, e2}, {true, e2, e3}, {true, e3, e1}};
    case JointKind::universal:
      return {along_1, along_2, along_3, {true, e3, eigen(joint.second_axis.value_or(Point{1, 0, 0}))}};
    case JointKind::locking:
      return {along_1, along_2, along_3, {true, e1, e2}, {true, e2, e3}, {true, e3, e1}};
  }
  return {};
}

double JointGeometry::value(const JointRow& row) const {
  const Eigen::Vector3d direction = first.rotation * row.first;
  if (row.turns) return direction.dot(second.rotation * row.second);
  return direction.dot(place() - (first.centre + first.rotation * arm_first));
}

RowGradient JointGeometry::gradient(const JointRow& row) const {
  const Eigen::Vector3d direction = first.rotation * row.first;
  if (row.turns) {
    const Eigen::Vector3d moment = direction.cross(second.rotation * row.second);
    return {Eigen::Vector3d::Zero(), moment, -moment};
  }
  return {direction, -(place() - first.centre).cross(direction), (place() - second.centre).cross(direction)};
}

}  // namespace pinball

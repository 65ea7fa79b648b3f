#pragma once

#include <string>
#include <vector>

#include <tests/support/solver_case.hpp>

/// Scenes with rigid bodies.
namespace pinball::test {

inline const std::vector<Point> all_directions{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// A body that is a rigid body by itself.
inline RigidBody rigid(const std::string& body) {
  RigidBody of;
  of.name = body;
  of.bodies = {body};
  return of;
}

/// The nodes of a body at a height move with the rigid body of this name.
inline AttachedNodes attached_at(const std::string& rigid_body, const std::string& body, double height) {
  AttachedNodes attached;
  attached.rigid_body = rigid_body;
  attached.nodes.body = body;
  attached.nodes.plane = Plane{{0, 0, height}, {0, 0, 1}};
  return attached;
}

}  // namespace pinball::test

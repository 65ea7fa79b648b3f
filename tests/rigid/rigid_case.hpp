#pragma once

#include <string>

#include <tests/support/solver_case.hpp>

/// Scenes with rigid bodies.
namespace pinball::test {

/// A body that is a rigid body by itself.
inline RigidBody rigid(const std::string& body) {
  RigidBody of;
  of.name = body;
  of.bodies = {body};
  return of;
}

}  // namespace pinball::test

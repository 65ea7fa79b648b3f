#pragma once

#include <string>
#include <vector>

#include <solver/model/model.hpp>
#include <solver/results.hpp>

namespace pinball {

/// What planes of symmetry with a name exert on the rigid bodies that they hold: the parts of the reactions of these
/// along their normals. Where several planes, or `held` of the body, hold along one direction the first plane has all
/// of it.
class RigidAtPlanes {
 public:
  template <class S>
  explicit RigidAtPlanes(const Model<S>& model);

  /// Adds them to the forces by name. bodies: results of all rigid bodies of the scene.
  void add_forces(const std::vector<RigidBodyResult>& bodies, std::vector<ForceResult>& forces) const;

 private:
  struct Hold {
    std::size_t body;
    std::string name;
    Point normal;
    Point part;  ///< times the reaction: what the plane exerts along its normal
  };
  void add_body(const Scene& scene, std::size_t body, const std::vector<std::size_t>& planes);

  std::vector<Hold> holds_;
};

}  // namespace pinball

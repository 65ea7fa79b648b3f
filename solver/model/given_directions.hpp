#pragma once

#include <cstdint>
#include <vector>

#include <solver/base/point.hpp>

#include "model.hpp"

namespace pinball {

/// A direction in which the velocity of a node is given, before those of one node are made orthogonal.
struct GivenDirection {
  std::int32_t node = 0;   ///< of the scene
  Point direction{};       ///< of unit length
  double speed = 0;        ///< along it [length/time]; of a prescribed velocity as its quantity has it
  std::int32_t table = 0;  ///< number of the prescribed velocity, or of the constraint, those of planes first
  bool held = false;       ///< a constraint
  TimeSpan when{};         ///< when it counts
};

/// The directions of one node, made orthonormal in the order in which they come, so that removing one leaves the others
/// removed: the first counts most.
class NodeDirections {
 public:
  struct Own {
    Point direction;  ///< of unit length
    double speed;     ///< along it; 0 where it is held
    const GivenDirection* given;
  };

  /// Both have to stay where they are.
  explicit NodeDirections(const Scene& scene) : scene_(&scene) {}

  /// false: it is along those before it, which decide. Throws InputError for a speed along a direction that is neither
  /// along nor across those in which the node moves.
  bool add(const GivenDirection& given);
  const std::vector<Own>& all() const { return all_; }
  void clear();

 private:
  void require_across(const GivenDirection& given) const;

  const Scene* scene_;
  std::vector<Point> basis_;
  std::vector<Own> all_;
};

/// Those of all nodes, of all times: constraints first, then prescribed velocities, each in the order of the scene.
/// Throws InputError for a selection without nodes.
std::vector<GivenDirection> given_directions(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball

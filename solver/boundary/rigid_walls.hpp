#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <solver/base/external_work.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/model/model.hpp>
#include <solver/results.hpp>

namespace pinball {

/// Planes that no node crosses ([[rigid_wall]]). A node that would lie behind the plane after the
/// step gets the normal force that puts it on the plane:
///
///     N = -g / (dt_(n+1/2) (dt_(n-1/2) + dt_(n+1/2))/2 / m) ,  g = n.(x_(n+1) - p) < 0 without the wall.
///
/// It is released by itself when it is pulled away, for then it would not lie behind. A node that hits the wall loses
/// the energy of its normal velocity, as in a plastic impact of its mass: less with each refinement of the mesh.
///
/// Friction: the force across the normal that stops the node within the step, at most friction times N. Along
/// directions in which constraints or prescribed velocities hold a node at rest it has nothing to stop.
///
/// Where constraints hold a node, only the part of the reaction along its free directions moves it. Several walls act
/// one after the other: where their normals are not perpendicular, a node in the corner may for a step be behind the
/// earlier ones.
template <class S>
class RigidWalls {
 public:
  /// Throws InputError that names a node that lies behind a wall at the start.
  explicit RigidWalls(const Model<S>& model);

  bool any() const { return !walls_.empty(); }

  /// Adds the reactions to the forces of the nodes, after everything else that acts on them.
  void apply(Model<S>& model, const StepLengths& step);
  /// Work of the reactions that apply() has set; to be called when all forces are known.
  ExternalWork work(const Model<S>& model, const StepLengths& step) const;

  void persist(StateArchive& archive) {
    for (WallResult& wall : results_) archive(wall.force, wall.force_max, wall.impulse);
  }
  const std::vector<WallResult>& results() const { return results_; }
  std::size_t bytes() const;

 private:
  struct Wall {
    S point[3], normal[3];
    S friction;
    std::vector<std::int32_t> nodes;     ///< the last ones have a free direction of their own
    std::vector<std::array<S, 3>> free;  ///< projection of the normal, for the last nodes
    std::vector<S> reaction;             ///< per node [force]
    std::vector<std::array<S, 3>> drag;  ///< friction per node, only where there is any [force]

    /// Direction in which the wall can push its i-th node.
    const S* direction(std::size_t i) const {
      const std::size_t plain = nodes.size() - free.size();
      return i < plain ? normal : free[i - plain].data();
    }
  };
  static std::array<S, 3> drag(const Wall& wall, S reaction, const S* v, const S* f, S step, S inverse_mass);

  std::vector<Wall> walls_;
  std::vector<WallResult> results_;
};

}  // namespace pinball

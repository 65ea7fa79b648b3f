#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/contact/surface/node_bound.hpp>
#include <solver/model/initial_overlap.hpp>
#include <solver/model/model.hpp>
#include <solver/results.hpp>

#include "space/boundary_kernels.hpp"
#include "wall_motion.hpp"

namespace pinball {

/// Planes that no node crosses ([[rigid_wall]]). A node that would lie behind the plane after the
/// step gets the normal force that puts it on the plane:
///
///     N = -g / (dt_(n+1/2) (dt_(n-1/2) + dt_(n+1/2))/2 / m) ,  g = n.(x_(n+1) - p) < 0 without the wall.
///
/// It is released by itself when it is pulled away, for then it would not lie behind. A node that hits the wall loses
/// the energy of its normal velocity, as in a plastic impact of its mass: less with each refinement of the mesh.
///
/// Friction: the force across the normal that stops the node within the step, at most friction times N.
///
/// Where constraints or prescribed velocities hold a node, only the part of reaction and friction along its free
/// directions moves it, and they take up the rest. Several walls act one after the other: where their normals are not
/// perpendicular, a node in the corner may for a step be behind the earlier ones.
///
/// A wall with an end, in space or in time, takes the nodes that come from its free side; those that have gone past it
/// are left alone. A node is above a rectangle where its foot on the plane is, before the step.
template <class S>
class RigidWalls {
 public:
  /// Throws InputError that names a node that lies behind a wall at the start, by more than meshes are rounded: up to
  /// that the wall stands back.
  RigidWalls(const Model<S>& model, const BoundaryKernels<S>& kernels);

  bool any() const { return !walls_.empty(); }

  /// Those that constraints and prescribed velocities of the model have now.
  void take_held_directions(const Model<S>& model);
  /// The planes that will stop nodes in the coming step, node by node in the order of `of`; a wall that is pushed is
  /// taken to go on as it does.
  std::vector<NodeBound> bounds(const NodeArrays<S>& nodes, std::span<const std::int32_t> of, double time,
                                const StepLengths& step) const;
  /// Adds the reactions to the forces of the nodes, after everything else that acts on them; time: of the forces.
  void apply(const NodeArrays<S>& nodes, double time, const StepLengths& step);
  /// Whether the reactions have parts that nodes do not follow, since they are held.
  bool push_held_nodes() const { return pushes_held_; }
  /// Adds these to the forces of the nodes: before what holds them takes them up.
  void add_held_parts(const NodeArrays<S>& nodes, double time);
  /// Work of the reactions that apply() has set; to be called when all forces are known.
  ExternalWork work(const NodeArrays<S>& nodes, const StepLengths& step) const;

  /// Fastest of the nodes that will come to a wall in a step like the last one [length/time].
  double closing() const { return closing_; }
  /// Largest change of the velocity of walls that move as given, from the step before `time` to that from `later` on
  /// [length/time].
  double leap(double time, double later, const StepLengths& step) const;
  /// Whether any begins to act after `from` and by `to`; and the fastest at which nodes will come to these walls within
  /// the steps, of length dt, that begin by `to`, if they go on as they do at `time` [length/time].
  bool begin(double from, double to) const {
    return std::ranges::any_of(walls_, [=](const Wall& wall) { return begins(wall, from, to); });
  }
  double leap_of_begun(const Model<S>& model, double from, double time, double to, double dt) const;
  /// Nodes that walls let alone because they lie behind them when these begin to act, after `from` and by `to`: an
  /// entry for each wall, `second`, and body, `first`. Below a rectangle only bodies count that lie on both sides of
  /// it.
  std::vector<InitialOverlap> passed_by_begun(const Model<S>& model, double from, double to) const;

  void persist(StateArchive& archive) {
    for (WallResult& wall : results_)
      archive(wall.force, wall.force_max, wall.impulse, wall.displacement, wall.row_displacement, wall.velocity);
    archive(closing_);
  }
  const std::vector<WallResult>& results() const { return results_; }
  std::size_t bytes() const;

 private:
  struct Wall {
    WallPlane<S> plane;
    TimeSpan when;
    WallMotion motion;
    std::unique_ptr<WallKernels<S>> nodes;
    std::vector<std::uint8_t> takes;  ///< per node of the store, whether it is one of these; empty without contact
  };
  static bool begins(const Wall& wall, double from, double to) {
    return wall.when.start > std::max(0.0, from) && wall.when.start <= to;
  }
  static Wall wall_of(const Model<S>& model, const RigidWall& given, const BoundaryKernels<S>& kernels);
  static void stand_back(const Model<S>& model, const RigidWall& given, WallPlane<S>& plane);
  void react(const NodeArrays<S>& nodes, Wall& wall, WallResult& result, double time, const StepLengths& step);

  std::vector<Wall> walls_;
  std::vector<WallResult> results_;
  double closing_ = 0;
  bool pushes_held_ = false;
};

}  // namespace pinball

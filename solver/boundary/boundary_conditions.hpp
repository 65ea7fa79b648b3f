#pragma once

#include <cstdint>
#include <vector>

#include <solver/base/external_work.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/model/model.hpp>
#include <solver/model/node_spans.hpp>
#include <solver/results.hpp>

#include "rigid_walls.hpp"

namespace pinball {

/// What acts on the nodes from outside: loads (the scene's and the host's), damping, constraints, prescribed velocities
/// and rigid walls, in this order, each of them with the last word over those before. All of them act through the force
/// of a node, so that integration and energies need not know of them.
template <class S>
class BoundaryConditions {
 public:
  /// Throws InputError for a selection without nodes and for a node behind a wall.
  explicit BoundaryConditions(const Model<S>& model);

  /// Whether the scene has any of it.
  bool any() const { return any_; }

  // In this order, after the forces of elements and springs are known and before the integration; time: of the forces.

  /// Adds loads and damping to the forces of the nodes.
  void add_loads(Model<S>& model, double time);
  /// Constraints and prescribed velocities: changes forces and, in constrained directions, velocities; once more where
  /// contact has added forces since. due: what is integrated then.
  void hold(Model<S>& model, double time, const StepLengths& step, const DueSpans& due = {});
  /// Adds the reactions of the walls, and counts the work of all.
  void add_wall_reactions(Model<S>& model, const StepLengths& step);

  double work() const { return done_ + last_.now; }  ///< done on the model up to the time of the forces [energy]
  /// Counts work that was done between two steps.
  void add_work(double work) { done_ += work; }
  /// Forces that a host adds in every step, in records of four like those of the nodes; zero at first, and then what
  /// the host writes. They are no part of the state that is saved.
  AlignedArray<S>& host_forces(const Model<S>& model);
  void persist(StateArchive& archive) {
    archive(done_, last_);
    walls_.persist(archive);
  }
  const std::vector<WallResult>& walls() const { return walls_.results(); }
  std::size_t bytes() const;

 private:
  struct Load {
    Point force{};
    TimeTable table;
    std::vector<std::int32_t> nodes;
    std::vector<S> share;        ///< of the force, per node [-]
    std::array<S, 3> present{};  ///< total, at the time of the forces [force]
  };
  void add_nodal_loads(Model<S>& model, double time);
  void add_host_forces(Model<S>& model) const;
  void add_damping(Model<S>& model);
  void add_gravity(Model<S>& model, double time);
  void constrain(Model<S>& model, const DueSpans& due) const;
  void prescribe(Model<S>& model, double time, const StepLengths& step);
  ExternalWork work_of_step(const Model<S>& model, const StepLengths& step) const;

  bool any_ = false, acts_ = false;               ///< acts_: does work
  std::vector<std::size_t> constraints_of_span_;  ///< first of each span of nodes; spans + 1 entries
  std::vector<Load> loads_;
  AlignedArray<S> host_forces_;  ///< empty until asked for [force]
  double damping_ = 0;           ///< [1/time]
  std::vector<Gravity> gravities_;
  Point gravity_{};  ///< the sum of them at the time of the forces [length/time^2]
  std::vector<TimeTable> velocity_tables_;
  std::vector<MotionQuantity> quantities_;  ///< of the tables
  std::vector<S> reaction_;                 ///< per NodePrescription of the model [force]
  RigidWalls<S> walls_;
  double done_ = 0;  ///< work of all steps before the last
  ExternalWork last_;
};

}  // namespace pinball

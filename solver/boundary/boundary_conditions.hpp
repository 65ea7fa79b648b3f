#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/model/model.hpp>
#include <solver/results.hpp>

#include "face_pressures.hpp"
#include "gravity_loads.hpp"
#include "named_forces.hpp"
#include "prescribed_motions.hpp"
#include "rigid_walls.hpp"
#include "space/boundary_kernels.hpp"

namespace pinball {

/// What acts on the nodes from outside: loads (the scene's and the host's), pressures, gravity, damping, constraints,
/// prescribed velocities and rigid walls, in this order, each of them with the last word over those before; but along
/// one direction of a node, of constraints and prescribed velocities the first one counts. All of them act through the
/// force of a node, so that integration and energies need not know of them.
template <class S>
class BoundaryConditions {
 public:
  /// Throws InputError for a selection without nodes and for a node behind a wall.
  BoundaryConditions(const Model<S>& model, std::unique_ptr<const BoundaryKernels<S>> kernels);

  /// Whether the scene has any of it.
  bool any() const { return any_; }

  // In this order, after the forces of elements and springs are known and before the integration. nodes: of the space
  // of the kernels; time: of the forces.

  /// Takes the constraints and prescribed velocities that act at this time; whether they are others than before.
  bool follow(Model<S>& model, const NodeArrays<S>& nodes, double time, const StepLengths& step);
  /// Whether follow() has anything to do.
  bool changes(double time) const { return past(time) != changed_; }
  /// Adds loads and damping to the forces of the nodes. ends_cycle: all elements are updated in this step, and what
  /// comes next belongs to another cycle.
  void add_loads(const NodeArrays<S>& nodes, double time, const StepLengths& step, bool ends_cycle = true);
  /// Whether hold() has anything to do at present.
  bool holds() const { return constrains_ || prescribes_; }
  /// Constraints and prescribed velocities: changes forces and, in constrained directions, velocities; once more where
  /// contact has added forces since. due: what is integrated then.
  void hold(const NodeArrays<S>& nodes, double time, const StepLengths& step, const DueSpans& due = {});
  /// What walls will keep some nodes from: for contact, which acts before them.
  std::vector<NodeBound> bounds(const NodeArrays<S>& nodes, std::span<const std::int32_t> of, double time,
                                const StepLengths& step) const {
    return walls_.bounds(nodes, of, time, step);
  }
  /// Adds the reactions of walls to the forces of the nodes; what these have along directions in which nodes are held
  /// is taken up by what holds these.
  void add_wall_reactions(const NodeArrays<S>& nodes, double time, const StepLengths& step, const DueSpans& due);
  /// Whether add_wall_reactions() holds nodes once more: somebody asks for the forces, or the work, of what holds them.
  bool walls_push_held_nodes() const {
    return walls_.push_held_nodes() && (prescribes_ || (constrains_ && named_.of_constraints()));
  }
  /// Whether it exerts forces on nodes that are tied, whose accelerations count_work() needs then.
  bool loads_tied_nodes() const {
    return !loads_.empty() || pressures_.any() || of_host_ || gravity_.loads_tied_nodes();
  }
  /// Counts the work of all, when all forces are known.
  void count_work(const NodeArrays<S>& nodes, const StepLengths& step);

  double work() const { return done_ + last_.now; }  ///< done on the model up to the time of the forces [energy]
  /// Counts work that was done between two steps.
  void add_work(double work) { done_ += work; }
  /// Forces that a host adds in every step, in records of four like those of the nodes; zero at first, and then what
  /// the host writes. They are no part of the state that is saved.
  Array<S>& host_forces(const Model<S>& model);
  /// Reading gives the model the constraints and prescribed velocities of the state, which are no part of it.
  void persist(StateArchive& archive, Model<S>& model);
  const std::vector<WallResult>& walls() const { return walls_.results(); }
  // Leaps: largest change of velocity that nodes undergo at once [length/time].

  /// At the start, by what moves or holds them.
  double leap_at_start() const { return motions_.leap_at_start(); }
  /// The same with the mean velocities over the first step, of length dt.
  double leap_at_start(const Model<S>& model, double dt) const {
    return motions_.leap_of(model, {model.constraints, model.prescribed}, 0, {0, dt});
  }
  /// By walls, to which nodes come within two steps.
  double closing() const { return walls_.closing(); }
  /// By motions and walls that act, from the step before `time` to that from `later` on.
  double leap(double time, double later, const StepLengths& step) const {
    return std::max(motions_.leap(time, later, step), walls_.leap(time, later, step));
  }
  /// Whether constraints, motions or walls begin or end by `to` that did not at `from`; then leap_of_begun() has to see
  /// the model.
  bool changes(double from, double to) const { return past(to) != changed_ || walls_.begin(from, to); }
  /// Whether rigid walls begin to act after `from` and by `to`; and what lies behind these then.
  bool walls_begin(double from, double to) const { return walls_.begin(from, to); }
  std::vector<InitialOverlap> passed_by_begun_walls(const Model<S>& model, double from, double to) const {
    return walls_.passed_by_begun(model, from, to);
  }
  double leap_of_begun(const Model<S>& model, double from, double time, double to, double dt) const {
    const double of_walls = walls_.leap_of_begun(model, from, time, to, dt);
    if (past(to) == changed_) return of_walls;
    return std::max(of_walls, motions_.leap_of(model, held_nodes(model, to), to, {dt, dt}));
  }
  /// Kinetic energy that constraints have taken as they began, since the last call; not by forces, so that nobody else
  /// knows of it [energy].
  double take_stopped() { return std::exchange(stopped_, 0.0); }
  std::vector<PressureResult> pressures() const { return pressures_.results(); }
  /// What constraints, prescribed velocities and accelerations with a name exert on the nodes in the step just made, by
  /// name: the mean over the steps of the cycle, in one of which a large element gives a constraint the impulse of
  /// many.
  std::vector<ForceResult> forces(const Model<S>& model) const;
  const std::vector<std::string>& force_names() const { return named_.names(); }
  std::size_t bytes() const;

 private:
  struct Load {
    NodalLoad given;
    std::unique_ptr<NodeForceKernels<S>> nodes;
  };
  std::vector<Point> named_forces(const Model<S>& model) const;
  /// Adds those of constraints and prescribed velocities in the step just made.
  void add_held_forces(std::vector<Point>& sums) const;
  static Load load_of(const Model<S>& model, const NodalLoad& given, const BoundaryKernels<S>& kernels);
  void find_changes(const Scene& scene);
  void set_present(Model<S>& model, double time);
  void take_constraints(const Model<S>& model);
  ExternalWork work_of_step(const NodeArrays<S>& nodes, const StepLengths& step);

  bool any_ = false, acts_ = false;  ///< acts_: does work
  std::size_t past(double time) const { return std::ranges::upper_bound(changes_, time) - changes_.begin(); }

  std::vector<double> changes_;  ///< when constraints or prescribed velocities begin or end, in order
  std::uint64_t changed_ = 0;    ///< how many of them are past
  double stopped_ = 0;           ///< see take_stopped() [energy]
  std::unique_ptr<const BoundaryKernels<S>> kernels_;
  std::vector<Load> loads_;
  Array<S> host_forces_;                          ///< empty until asked for [force]
  std::unique_ptr<NodeForceKernels<S>> of_host_;  ///< null: until then
  std::unique_ptr<NodeForceKernels<S>> damping_;  ///< null: there is none
  NamedForces named_;
  std::optional<std::vector<Point>> forces_read_;  ///< with a state, up to its next step: by name [force]
  bool cycle_ends_ = true;                         ///< with the step just made
  std::int32_t steps_before_ = 0;                  ///< it, in its cycle
  std::vector<Point> forces_before_;               ///< sums over these: by name [force]
  GravityLoads<S> gravity_;
  PrescribedMotions motions_;
  std::unique_ptr<HeldNodeKernels<S>> held_;
  bool constrains_ = false, prescribes_ = false;  ///< at present
  FacePressures<S> pressures_;
  RigidWalls<S> walls_;
  double done_ = 0;  ///< work of all steps before the last
  ExternalWork last_;
};

}  // namespace pinball

#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/boundary/boundary_conditions.hpp>
#include <solver/boundary/equations.hpp>
#include <solver/boundary/symmetry_walls.hpp>
#include <solver/device/step_space.hpp>
#include <solver/elements/internal_forces.hpp>
#include <solver/elements/schedule.hpp>
#include <solver/model/initial_overlap.hpp>
#include <solver/model/model.hpp>
#include <solver/model/unseen_balls.hpp>
#include <solver/parallel/subdomain.hpp>
#include <solver/results.hpp>
#include <solver/results/probes.hpp>
#include <solver/results/timers.hpp>
#include <solver/rigid/rigid_at_planes.hpp>
#include <solver/rigid/rigid_bodies.hpp>

#include "begun_overlaps.hpp"
#include "changed_velocities.hpp"
#include "contact_stage.hpp"
#include "energy/body_energies.hpp"
#include "energy_ledger.hpp"
#include "energy_watch.hpp"
#include "guards.hpp"
#include "impact_speed.hpp"
#include "inside_out.hpp"
#include "run_counts.hpp"
#include "step_clock.hpp"
#include "tied_stage.hpp"
#include "unequal_velocities.hpp"

namespace pinball {

/// Central-difference solution of one scene (report figure 4). Owns the model; no global state, no files. What it can
/// tell of itself is in report.hpp.
///
/// After step() number n the forces, stresses and energies belong to time t_n, the positions to t_(n+1), the velocities
/// to the middle between them. finish() ends with a step of no length, after which everything belongs to one time.
///
/// With subcycling, step() makes the steps of a cycle, of the smallest elements, and ends with the one in which all
/// elements are updated; what is said above then holds for the steps that step() ends with.
template <class S>
class Solver {
 public:
  /// ranks: those that run the scene together; null: this process is alone. Each of them makes a solver of the same
  /// scene; then rank 0 is told what to do, and the others follow_rank_0().
  explicit Solver(const Scene& scene, Ranks* ranks = nullptr);
  Solver(const Solver&) = delete;  // guards look at its other members
  Solver& operator=(const Solver&) = delete;

  /// One step, or one cycle of them, at most to the end of the scene's time. Throws RunError for a state that cannot be
  /// continued.
  void step() {
    if (domain_) domain_->order(RankOrder::step);
    advance(false);
  }
  /// Forces and energies at the present positions, velocities brought to the same time.
  void finish();
  /// What each of several ranks does with its part of the state when rank 0 asks it to; it gets a number of rank 0, and
  /// returns what that is to know.
  using Answer = std::function<std::string(std::int64_t)>;
  /// Does what rank 0 does, until that has no more to do.
  void follow_rank_0(const Answer& answer = {});
  /// On rank 0: what all say, in the order of the ranks.
  std::vector<std::string> ask_ranks(std::int64_t number, const Answer& answer) { return domain_->ask(number, answer); }
  /// Of which rank each element of the scene is; empty: this process is alone.
  std::vector<std::int32_t> rank_of_elements() const;
  int rank() const { return domain_ ? domain_->rank() : 0; }
  /// The model as far as this rank works it; what is another's may be old.
  const Model<S>& own_model() const {
    if (domain_) domain_->bring_own();
    return model_;
  }
  /// Whether time.end or time.steps of the scene is reached; then finish() is due.
  bool at_end() const { return clock_.at_end(schedule_.cycle_steps()); }

  /// What no step changes; of a run on a device nothing is copied for it.
  const Scene& scene() const { return model_.scene; }
  const ModelMesh& mesh() const { return model_.mesh; }
  const Look& look() const { return model_.look; }
  /// Of the fastest impact that is expected, with a body, a wall, or what holds or moves a body's end [length/time].
  double impact_speed() const { return std::max(look().impact_speed, boundary_.leap_at_start()); }
  std::int64_t element_count() const { return model_.element_count(); }
  /// Of a run on a device the mirror on the host, of one on several ranks the whole of it, brought up to date: the
  /// state is copied where the last steps have changed it.
  const Model<S>& model() const {
    space_->bring_back();
    return model_;
  }
  /// The same without its state: what no step changes. Nothing is copied for it.
  const Model<S>& layout() const { return model_; }
  /// To change it between steps: the next step works all elements, also those at rest.
  Model<S>& change_model();
  /// To change velocities at the time of the next step's forces, as impulses do, whose work comes from outside; before
  /// the first step they are what the run begins with. Throws InputError for a scene with subcycling, in which nodes
  /// have several velocities.
  Array<S>& change_velocities();
  /// Forces that a host adds in every step (BoundaryConditions). Throws InputError where the program has none of them.
  Array<S>& host_forces();

  double time() const { return clock_.time(); }
  double force_time() const { return clock_.force_time(); }
  double dt() const { return clock_.dt(); }
  /// How far the position of a node of the store is ahead of the forces: the way of its own last step [length].
  Point way_ahead(std::int32_t node) const;
  std::int64_t steps() const { return clock_.steps(); }
  const Energies& energies() const { return ledger_.energies(); }
  double balance_error() const { return ledger_.balance_error(); }
  double balance_error_in_motion() const { return ledger_.balance_error_in_motion(); }
  double initial_energy() const { return ledger_.initial(); }
  Point initial_momentum() const { return initial_momentum_; }

  const StepClock& clock() const { return clock_; }
  const EnergyLedger& ledger() const { return ledger_; }
  const EnergyWatch& watch() const { return watch_; }
  const InsideOutWatch& inside_out() const { return inside_out_; }
  const RunCounts& counts() const { return counts_; }
  const ContactAlgorithm<S>* contact() const { return contact_.contact(); }
  const TiedStage<S>& tied() const { return tied_; }
  const RigidBodies<S>& rigid() const { return rigid_; }
  const std::vector<PairResult>& contact_pairs() const { return contact_.pairs(); }
  const BoundaryConditions<S>& boundary() const { return boundary_; }
  const Subcycling<S>* subcycling() const { return schedule_.subcycling(); }
  const Probes<S>& probes() const { return probes_; }
  const BodyEnergies<S>& body_energies() const { return body_energies_; }

  // For output: sums where the state lies, and copies of what is watched alone.

  /// Sum over all nodes, with what bodies of a given centre have above it [mass length/time].
  Point momentum() const;
  /// What no step changes of the bodies' results.
  const std::vector<BodyResult>& bodies_at_start() const { return bodies_at_start_; }
  std::vector<BodySum> body_sums() const { return space_->body_sums(); }
  std::vector<BodyShare> body_shares() const;
  /// In the order of Probes::columns().
  std::vector<double> probe_values() const;
  std::vector<ProbeResult> probe_results() const;

  const std::vector<InitialOverlap>& initial_overlaps() const { return initial_overlaps_; }
  /// Of bodies whose contact began later, when it did.
  const std::vector<InitialOverlap>& begun_overlaps() const { return begun_overlaps_.found(); }
  /// Forces by name of what holds and moves nodes, and of planes of symmetry that hold rigid bodies [force].
  std::vector<ForceResult> named_forces() const;
  /// Nodes of bodies, `first`, behind rigid walls, `second`, that began later, when they did.
  const std::vector<InitialOverlap>& passed_walls() const { return begun_overlaps_.passed_walls(); }
  /// After finish(), where nothing has eroded: erosion exposes what lies deep inside others.
  const InitialOverlap& overlap_at_end() const { return overlap_at_end_; }
  const std::optional<UnseenBalls>& unseen_balls() const { return unseen_balls_; }
  /// Selections that nodes lie near to and that do not take them, a sentence each.
  const std::vector<std::string>& near_nodes() const { return near_nodes_; }
  /// What makes hourglass forces unstable from the start, as a sentence; empty: nothing.
  const std::string& unstable_hourglass() const { return unstable_hourglass_; }
  /// How many steps there are, as a sentence, where they are more than anybody is likely to want; else empty.
  const std::string& many_steps() const { return many_steps_; }
  /// The part of the energy in motion up to which contact may swallow it; 0 where the scene asks for what does [-].
  double sound_swallowing() const { return sound_swallowing_; }
  SharedWork shared_work() const { return domain_ ? domain_->work() : SharedWork(); }
  const Timers& timers() const { return timers_; }
  Timers& timers() { return timers_; }
  std::size_t bytes() const;  ///< of everything of the size of the mesh

  /// The state between steps; what the scene gives is not in it. After reading, the run goes on with the same bits as
  /// the solver that wrote it, if it was built from the same scene; else this throws InputError, or fingerprint()
  /// differs.
  void persist(StateArchive& archive);

 private:
  void check_places(const StateArchive& archive) const;
  void choose_common_nodes();
  void advance(bool last);
  void make_cycle(bool last);
  void take_first_velocities();
  void take_velocities_of_host();
  void begin_change_of_velocities();
  void end_change_of_velocities();
  void make_step(const Due& due);
  void look_at_begun_contact();
  /// Calls look() while the mesh has the present places of its nodes.
  template <class Look>
  void look_at_present_mesh(const Look& look) {
    model();
    std::vector<Point> places;
    for (const std::int32_t n : model_.node_of_scene_node) {
      const S* x = model_.nodes.position_of(n);
      places.push_back({x[0], x[1], x[2]});
    }
    std::swap(model_.mesh.nodes, places);
    look();
    std::swap(model_.mesh.nodes, places);
  }
  std::unique_ptr<StepSpace<S>> make_space();

  InternalForceResult<S> internal_forces(const Due& due);
  ContactWork update_ties();
  ComingStep coming_step(const Due& due, const InternalForceResult<S>& element) const;
  ContactWork contact_before_constraints(const Due& due, const InternalForceResult<S>& element);
  void choose_time_step(const Due& due, const InternalForceResult<S>& element, const ContactWork& springs);
  void boundary_forces(const Due& due);
  void hold(const Due& due);
  void follow_constraints();
  void look_ahead(bool first);
  double leap_of_motions(const StepLengths& step, int ahead) const;
  double leap(const Due& due, const InternalForceResult<S>& element, const ContactWork& springs);
  Point watched_way_ahead(std::int32_t node) const;
  void add_equation_forces(const Due& due);
  bool may_break_equations() const;
  void look_at_equations();
  void share_rigid_forces();
  ContactWork contact_after_constraints(const Due& due);
  void wall_reactions(const Due& due);
  MotionEnergy integrate(const Due& due);
  bool may_reflect() const { return counts_.eroded_elements() > 0 && symmetry_walls_.any(); }
  void reflect_at_symmetry_planes(const Due& due);
  void follow_ties();
  void move_rigid_bodies();
  void keep_accounts(const Due& due, const InternalForceResult<S>& element, const ContactWork& contact,
                     const MotionEnergy& motion);
  void watch_corners(std::int64_t inside_out);
  void watch_energies();

  Model<S> model_;                        ///< of a run on a device a mirror
  std::unique_ptr<Subdomain<S>> domain_;  ///< null: no other rank has any
  InternalForces<S> internal_forces_;
  Schedule<S> schedule_;
  std::unique_ptr<StepSpace<S>> space_;
  SymmetryWalls<S> symmetry_walls_;
  BoundaryConditions<S> boundary_;
  Equations<S> equations_;
  Probes<S> probes_;
  BodyEnergies<S> body_energies_;
  std::unique_ptr<NodeMotionKernels<S>> motion_;  ///< of all nodes
  TiedStage<S> tied_;
  RigidBodies<S> rigid_;
  ContactStage<S> contact_;
  RigidImpacts<S> rigid_impacts_;
  StepClock clock_;
  EnergyLedger ledger_;
  EnergyWatch watch_{contact_.contact() != nullptr};
  InsideOutWatch inside_out_;
  RunCounts counts_;
  Timers timers_;
  Guards<S> guards_;
  Point initial_momentum_{};
  std::vector<BodyResult> bodies_at_start_;
  InitialOverlap overlap_at_end_;
  std::vector<InitialOverlap> initial_overlaps_;  ///< only looked for in a scene with contact
  BegunOverlaps begun_overlaps_;
  RigidAtPlanes rigid_at_planes_;
  std::optional<UnseenBalls> unseen_balls_;  ///< only looked for where the gap is that of balls
  std::vector<std::string> near_nodes_;
  std::string unstable_hourglass_, many_steps_;
  double sound_swallowing_ = 0;
  ChangedVelocities<S> changed_velocities_;
  double smallest_step_ = 0;      ///< stable, of all elements at the start [time]
  double leap_of_begun_ = 0;      ///< see look_ahead() [length/time]
  UnequalVelocities given_leap_;  ///< that the run begins with in this step, or that a host has given
};

}  // namespace pinball

#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <kernels/boundary/external_work.hpp>
#include <solver/base/iteration_counts.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/contact/contact_settings.hpp>
#include <solver/contact/impulses/impulse_solver.hpp>
#include <solver/contact/surface/surface.hpp>
#include <solver/contact/surface/surface_source.hpp>

#include "pinball_kernels.hpp"

namespace pinball {

/// What contact has done in a step or in a stage of it.
struct ContactWork {
  double stored = 0;        ///< energy in the penalty springs [energy]
  double eroded = 0;        ///< energy of the springs that went with eroded elements [energy]
  double damped_power = 0;  ///< power of the damping between pinballs [power]
  /// Energy taken out since the step before by impulses, or by the damping of a slideline and its springs that ended or
  /// jumped [energy].
  double dissipated = 0;
  double penetration_ratio = 0;  ///< largest penetration over the size of the pair, R1 + R2 [-]
  std::int64_t pairs = 0;        ///< pairs in contact
  double frequency2 = 0;         ///< bound on the square of the contact frequency [1/time^2]
  /// Largest change of velocity that impulses will give to what comes to touch in the coming steps [length/time].
  double expected_change = 0;
  IterationCounts iterations;  ///< for impulses by lagrange
  std::int32_t deepest = -1;   ///< a node of the pair of the largest penetration; negative: there is none

  /// Of two stages of one step together.
  ContactWork& operator+=(const ContactWork& other) {
    stored += other.stored;
    eroded += other.eroded;
    damped_power += other.damped_power;
    dissipated += other.dissipated;
    if (other.penetration_ratio > penetration_ratio) {
      penetration_ratio = other.penetration_ratio;
      deepest = other.deepest;
    }
    pairs += other.pairs;
    frequency2 = std::max(frequency2, other.frequency2);
    expected_change = std::max(expected_change, other.expected_change);
    iterations += other.iterations;
    return *this;
  }
  friend ContactWork operator+(ContactWork a, const ContactWork& b) { return a += b; }
};

/// Lists of what may touch.
struct ListSize {
  std::int64_t owners = 0;   ///< pinballs that have a list, or slave nodes
  std::int64_t entries = 0;  ///< pairs
  std::int64_t places = 0;   ///< of pairs: entries, and the padding to whole packs
};

/// What the coming step may bring that neither the velocities at its beginning nor the step just made tell.
struct ComingStep {
  double dt = 0;       ///< as long as it is taken to be, where the step just made was shorter [time]
  double leap = 0;     ///< by which given motions may change velocities as it begins [length/time]
  bool stops = false;  ///< some nodes are held, or moved, from now on, and may lose any velocity that they have
};

/// An algorithm of contact, for whoever fills a SurfaceSource. Each step calls its stages in this order:
///
///     update_surface, search, before_step, add_forces      then loads, constraints and the length of the coming step,
///     after_constraints                                    then accelerations.
///
/// Contact is enforced either by springs, whose forces follow from positions and from velocities before the step, or by
/// impulses, which act on the velocities that all other forces leave for it. The stage that is not due does nothing and
/// returns zeros, so that a step need not know which it is.
template <class S>
class ContactAlgorithm {
 public:
  /// settings: those of all steps; a copy is kept.
  ContactAlgorithm(const ContactSettings& settings, const SurfaceSource<S>& source, InitialSurface& start);
  virtual ~ContactAlgorithm() = default;
  ContactAlgorithm(const ContactAlgorithm&) = delete;
  ContactAlgorithm& operator=(const ContactAlgorithm&) = delete;

  /// Chooses the pairs that may touch at a time, that of the forces of the coming step.
  void set_time(double time) {
    if (pairs_ && pairs_->set_time(time)) lists_outdated_ = true;
  }
  /// Whether rows are found by what closes in the coming step.
  virtual bool looks_ahead() const { return false; }
  /// What the coming step may bring, for the next search and before_step.
  void expect(const ComingStep& coming) { coming_ = coming; }
  /// Which nodes are tied. ties: has to stay where it is; changed: others than when the lists were made.
  void set_ties(const TiedNodes<S>& ties, bool changed) {
    if (pairs_) pairs_->set_tied(ties.ties_of_nodes());
    if (impulses_) impulses_->set_ties(&ties);
    lists_outdated_ = lists_outdated_ || changed;
  }
  /// The lists hold no longer: they were built for other velocities.
  void forget_lists() { lists_outdated_ = true; }
  /// sides: null, or kept by whoever keeps this: the rigid bodies that nodes are of.
  void set_rigid_sides(const RigidSides* sides) {
    if (impulses_) impulses_->set_rigid_sides(sides);
  }
  /// Takes eroded elements out and brings up to date what the other stages read of the surface. eroded: slots of those
  /// that eroded since the last call, ascending; padding and elements that are out already may be among them.
  virtual void update_surface(const SurfaceSource<S>& source, const std::vector<std::int64_t>& eroded) = 0;
  /// Before the first step: has the loops of a step run where these kernels are, and reads the motion of nodes in the
  /// host's memory after SurfaceSource::before_search alone, but for that of read_nodes(), where the algorithm and what
  /// acts with it can do that. Returns whether it does.
  virtual bool work_with(std::unique_ptr<PinballKernels<S>>& /*kernels*/) { return false; }
  /// After work_with: the nodes of which the stages of a step whose lists hold read and change numbers in the host's
  /// memory, each once; in a step with erosion that of any node of the surface.
  virtual std::span<const std::int32_t> read_nodes() const { return {}; }
  /// How often these have been chosen; before the first time it is that of any node.
  virtual std::int64_t choices_of_read_nodes() const { return 0; }
  /// Lists of what may touch, unless the lists still hold. dt: the step just made.
  virtual void search(const SurfaceSource<S>& source, double dt) = 0;

  /// Springs: the forces of all pairs in contact, for add_forces. Impulses: the constraints of the coming step.
  /// dt: the step just made.
  ContactWork before_step(const SurfaceSource<S>& source, double dt);
  /// Springs: adds their forces to the nodes and bounds the contact frequency. work: of before_step.
  void add_forces(const SurfaceSource<S>& source, ContactWork& work);
  /// Impulses: adds the forces that keep gaps from closing in the coming step; after all other forces and the
  /// constraints. bounds: what will stop nodes of impulse_nodes() after that, in their order.
  ContactWork after_constraints(const SurfaceSource<S>& source, const StepLengths& step,
                                std::span<const NodeBound> bounds = {});
  /// Whether something stops nodes to which it added: then their work is known when that has been done.
  bool was_bounded() const { return impulses_ && impulses_->was_bounded(); }
  /// Then. step: of after_constraints.
  void follow_bounds(const SurfaceSource<S>& source, const StepLengths& step) {
    impulses_->follow_bounds(source, step);
  }
  /// Whether after_constraints adds forces: what it adds in held directions the constraints have to take up again.
  bool acts_on_velocities() const { return impulses_ != nullptr; }

  /// Others than before, from the next after_constraints on.
  void take_held_directions(HeldDirections held) {
    if (impulses_) impulses_->take_held_directions(std::move(held));
  }

  virtual const char* name() const = 0;
  /// Adds the contact force of the last step on each node of the store [force]. For output.
  virtual void add_node_forces(std::span<Point> node_force) const = 0;
  /// Radius of the pinball of each slot [length], where there is one. For output.
  virtual void put_radii(const SurfaceSource<S>& source, std::vector<double>& slot_radius) const = 0;
  /// Adds to the force on the first side of each pair that of the last step [force].
  void add_pair_forces(std::vector<Point>& sums) const {
    if (impulses_) {
      impulses_->add_pair_forces(sums);
    } else {
      add_pair_forces_of_springs(sums);
    }
  }
  virtual const Surface& surface() const = 0;
  std::int32_t surface_elements() const { return surface().exposed_count(); }  ///< that take part
  /// Nodes to which add_forces adds after a before_step with pairs in contact, some perhaps several times; none with
  /// impulses.
  const std::vector<std::int32_t>& spring_nodes();
  /// Nodes to which after_constraints adds, each once; none with springs.
  const std::vector<std::int32_t>& impulse_nodes() const;
  /// The nodes whose velocities are read in a step whose lists hold; null: all of the surface. Their positions are read
  /// of all of the surface, and lists do not hold where one is not a number.
  virtual const std::vector<std::int32_t>* listed_nodes() const { return nullptr; }
  /// The nodes with which the surface moves, and what waits behind it: nothing is read of others until
  /// SurfaceSource::before_motion. Some perhaps several times.
  virtual std::vector<std::int32_t> nodes() const = 0;
  virtual ListSize listed() const = 0;
  virtual std::size_t bytes() const = 0;
  /// source: with its own state read before. What can be rebuilt with the same bits is; lists cannot, because a list of
  /// another time has other pairs, over which energies are summed in another order, and lasts for another time.
  virtual void persist(StateArchive& archive, const SurfaceSource<S>& source) {
    archive(searches_, searches_skipped_, lists_outdated_);
    if (pairs_) pairs_->persist(archive);
    if (impulses_) impulses_->persist(archive, source);
  }
  std::int64_t searches() const { return searches_; }
  std::int64_t searches_skipped() const { return searches_skipped_; }

 protected:
  // What the stages above do where they are due.
  virtual ContactWork spring_forces(const SurfaceSource<S>& source, S dt) = 0;
  virtual void add_spring_forces(const SurfaceSource<S>& source, ContactWork& work) = 0;
  virtual const std::vector<std::int32_t>& nodes_of_springs() = 0;
  virtual void collect_impulses(const SurfaceSource<S>& source, double dt) = 0;
  virtual void add_pair_forces_of_springs(std::vector<Point>& sums) const = 0;
  /// Whether lists that hold by themselves may be kept: they may last, and no other pairs may touch than before.
  bool may_keep_lists(const SurfaceSource<S>& source) const { return source.lists_last && !lists_outdated_; }

  const ContactSettings settings_;
  std::unique_ptr<ContactPairs> pairs_;  ///< none: all may touch all
  ComingStep coming_;
  bool lists_outdated_ = false;                 ///< others may touch than when the lists were made
  std::unique_ptr<ImpulseSolver<S>> impulses_;  ///< only with enforcement by impulses
  double damping_factor_ = 1;                   ///< of the squared frequency of the springs, for their damping
  std::int64_t searches_ = 0, searches_skipped_ = 0;
};

/// The algorithm that the settings name, which may not be none.
template <class S>
std::unique_ptr<ContactAlgorithm<S>> make_contact(const ContactSettings& settings, const SurfaceSource<S>& source,
                                                  InitialSurface start);

}  // namespace pinball

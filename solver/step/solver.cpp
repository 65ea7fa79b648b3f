#include "solver.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <solver/base/built_features.hpp>
#include <solver/boundary/space/model_arrays.hpp>
#include <solver/device/device_run.hpp>
#include <solver/model/initial_stresses.hpp>
#include <solver/model/selection/near_nodes.hpp>
#include <solver/results/sound_bounds.hpp>

#include "energy/drift_energy.hpp"
#include "host_step.hpp"
#include "marked_times.hpp"
#include "places.hpp"
#include "report.hpp"
#include "require_built.hpp"
#include "start_checks.hpp"

namespace pinball {

namespace {

/// Part of the energy of common motion that rounding may take or give in a run: of what is less nothing is known.
template <class S>
constexpr double rounding = sizeof(S) == sizeof(double) ? 1e-9 : 1e-3;

/// See Solver::sound_swallowing. Plastic bodies, rigid ones that meet, friction, springs that are damped more than by
/// default, and damping of all that moves are meant to swallow.
double sound_swallowing_of(const Scene& scene) {
  const ContactSettings& contact = scene.contact;
  const bool springs = contact.enforcement == Enforcement::penalty;
  const bool damped = scene.damping.mass > 0 || (springs && contact.damping > ContactSettings().damping);
  const std::vector<std::size_t> materials = material_of_bodies(scene);
  const bool plastic = std::any_of(materials.begin(), materials.end(),
                                   [&scene](std::size_t material) { return scene.materials[material].plastic; });
  const bool rubs = std::any_of(scene.contact_pairs.begin(), scene.contact_pairs.end(),
                                [](const ContactPair& pair) { return pair.static_friction > 0; });
  const bool stop_dead = !springs && scene.rigid_bodies.size() > 1;
  return damped || plastic || stop_dead || rubs || contact.static_friction > 0 ? 0.0 : sound::contact_swallowed;
}

/// Names, elements and masses of the bodies.
template <class S>
std::vector<BodyResult> bodies_of(const Model<S>& model) {
  std::vector<BodyResult> bodies(model.mesh.body_names.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) bodies[b].name = model.mesh.body_names[b];
  for (std::size_t e = 0; e < model.element_mass.size(); ++e) {
    BodyResult& body = bodies[model.mesh.body[e]];
    ++body.elements;
    body.mass_initial += model.element_mass[e];
    if (!model.added_mass.empty()) body.mass_added += model.added_mass[e];
  }
  return bodies;
}

}  // namespace

template <class S>
Solver<S>::Solver(const Scene& scene, Ranks* ranks)
    : model_(build_model<S>(scene)),
      domain_(ranks == nullptr ? nullptr : std::make_unique<Subdomain<S>>(model_, *ranks)),
      internal_forces_(model_, domain_.get()),
      schedule_(model_, domain_.get()),
      space_(make_space()),
      symmetry_walls_(model_, *space_->boundary_kernels()),
      boundary_(model_, space_->boundary_kernels()),
      equations_(model_),
      probes_(model_),
      body_energies_(model_, *space_->boundary_kernels()),
      motion_(space_->boundary_kernels()->motion(model_.nodes.count)),
      tied_(model_),
      rigid_(model_),
      contact_(model_, *space_),
      rigid_impacts_(model_, contact() != nullptr),
      clock_(model_.scene.time, model_.scene.damping.mass),
      guards_(model_, clock_),
      rigid_at_planes_(model_) {
  clock_.mark(marked_times(model_.scene));
  if (contact() != nullptr) {
    clock_.limit_by_impact_speed(longest_contact_step(model_));
    initial_overlaps_ = find_initial_overlaps(model_.scene, model_.mesh);
    unseen_balls_ = find_unseen_balls(model_.scene, model_.mesh);
    sound_swallowing_ = sound_swallowing_of(model_.scene);
  }
  require_built(model_, boundary_.any() || equations_.any());
  const SmallestStep smallest = check_against_steps(model_.scene, model_.mesh, clock_.longest_impact_step());
  smallest_step_ = smallest.step;
  clock_.expect_impacts(smallest.rate_of_closing);
  many_steps_ = find_many_steps(model_.scene, model_.mesh, smallest);
  near_nodes_ = find_near_nodes(model_.scene, model_.mesh);
  if (std::string eroded = find_eroded_at_start(model_.scene, model_.mesh); !eroded.empty()) {
    model_.look.unlikely.push_back(std::move(eroded));
  }
  unstable_hourglass_ = find_unstable_hourglass(model_.scene, model_.mesh);
  guards_.set_cause(unstable_hourglass_.empty() ? model_.look.cause : unstable_hourglass_);
  initial_momentum_ = momentum();
  const std::vector<double> stored = initial_strain_energies(model_);
  ledger_.begin_with(std::accumulate(stored.begin(), stored.end(), 0.0));
  body_energies_.begin_with(stored);
  bodies_at_start_ = bodies_of(model_);
  if (rigid_.any()) contact_.set_rigid_sides(rigid_.sides());
  choose_common_nodes();
  if (domain_) domain_->connect(model_, fingerprint(model_));
}

template <class S>
std::unique_ptr<StepSpace<S>> Solver<S>::make_space() {
  if (model_.scene.device != Device::none) {
    return std::make_unique<DeviceRun<S>>(model_, internal_forces_, schedule_, domain_.get());
  }
  return std::make_unique<HostStep<S>>(model_, internal_forces_, schedule_, domain_.get());
}

template <class S>
void Solver<S>::make_cycle(bool last) {
  if (changed_velocities_.any() && clock_.steps() == 0) take_first_velocities();
  const bool first = clock_.steps() == 0;
  const std::int32_t cycle_steps = first ? 1 : schedule_.cycle_steps();
  if (!last) look_ahead(first);
  for (std::int32_t step = 1; step < cycle_steps; ++step) make_step({step, false, false});
  make_step({0, first, last});
}

template <class S>
void Solver<S>::finish() {
  if (domain_) domain_->order(RankOrder::finish);
  advance(true);
  if (contact() == nullptr || counts_.eroded_elements() > 0) return;
  look_at_present_mesh(
      [this] { overlap_at_end_ = find_overlap_at(clock_.time(), model_.scene, model_.mesh, sound::depth_at_end); });
}

/// The explicit step of the report's figure 4, with its figure 3 for contact: the program's table of contents. Each
/// stage is timed (Phase). Node forces are zero between steps.
template <class S>
void Solver<S>::make_step(const Due& due) {
  look_at_begun_contact();  // tells of bodies that overlap when contact between them begins
  if (domain_) domain_->begin_step();
  const InternalForceResult<S> element = internal_forces(due);           // 3    f -= B^T sigma V, and the stable step
  const ContactWork ties = update_ties();                                //      which nodes are tied from now on
  const ContactWork springs = contact_before_constraints(due, element);  // 4    f += penalty of contact
  choose_time_step(due, element, springs);                               //      dt_(n+1/2)
  boundary_forces(due);                                         // 1-2  f += loads, damping; ties; constraints, given v
  add_equation_forces(due);                                     //      f += what keeps equations of displacements
  share_rigid_forces();                                         //      f of rigid bodies: those of their common motion
  const ContactWork impulses = contact_after_constraints(due);  //      f += impulses of contact; the last two again
  wall_reactions(due);                                          //      f += rigid walls
  look_at_equations();                         //      which contact and walls have to leave as they are
  const MotionEnergy motion = integrate(due);  // 5-6  v += dt f/m, x += dt v, f = 0
  reflect_at_symmetry_planes(due);             //      what erosion has set free
  schedule_.end_step(model_.nodes);            //      means of velocities, with subcycling alone
  follow_ties();                               //      tied nodes go where their faces do
  move_rigid_bodies();                         //      nodes of rigid bodies go where these do
  keep_accounts(due, element, ties + springs + impulses, motion);  //      energies, counts, guards
  clock_.advance(due);
}

template <class S>
InternalForceResult<S> Solver<S>::internal_forces(const Due& due) {
  const ElementStep<S> step{static_cast<S>(clock_.dt()), S(1), static_cast<S>(clock_.time())};
  const bool more_forces =
      boundary_.any() || equations_.any() || contact() != nullptr || tied_.any() || rigid_.any() || may_reflect();
  return timers_.measure(Phase::internal_forces, [&] {
    const auto of_rigid_bodies = [this](const auto& put) {
      if (!rigid_.has_common_nodes()) return;
      space_->show(NodeNumbers::motion);
      put();
      space_->take(NodeNumbers::motion);
    };
    if (changed_velocities_.any()) changed_velocities_.exchange(model_);
    of_rigid_bodies([this] { rigid_.put_ways(model_, clock_.dt()); });
    const InternalForceResult<S> result = space_->update_elements(due, step, more_forces);
    of_rigid_bodies([this] { rigid_.put_velocities(model_); });
    if (may_reflect()) symmetry_walls_.keep_forces(space_->nodes(NodeNumbers::none));
    if (changed_velocities_.any()) begin_change_of_velocities();
    return result;
  });
}

/// After what erodes in this step is known, before contact looks at what may touch.
template <class S>
ContactWork Solver<S>::update_ties() {
  ContactWork work;
  if (!tied_.any()) return work;
  timers_.measure(Phase::boundary_conditions, [&] {
    space_->eroded_slots();  // elements of faces
    space_->show(NodeNumbers::motion);
    if (!tied_.update(model_, clock_.time())) return;
    space_->take(NodeNumbers::motion);
    space_->take_masses();
    contact_.set_ties(tied_.nodes(), true);
  });
  work.dissipated = tied_.take_lost_energy();
  given_leap_.join({0, work.dissipated});
  return work;
}

template <class S>
ContactWork Solver<S>::contact_before_constraints(const Due& due, const InternalForceResult<S>& element) {
  rigid_.begin_step(clock_.time(), clock_.dt());
  const ComingStep coming = contact_.acts_on_velocities() ? coming_step(due, element) : ComingStep();
  const ContactWork work = contact_.before_constraints(model_, clock_.time(), clock_.dt(), coming, timers_, counts_);
  end_change_of_velocities();
  return work;
}

/// The last word on tied nodes: whatever constraints, walls and planes of symmetry do, they do to the corners.
template <class S>
void Solver<S>::follow_ties() {
  if (!tied_.any()) return;
  timers_.measure(Phase::integration, [&] {
    space_->show(NodeNumbers::motion);
    tied_.follow(model_);
    space_->take(NodeNumbers::motion);
  });
}

/// Ties come when all forces on tied nodes are known, and before constraints: these then act on corners with the forces
/// and masses of what is tied to them.
template <class S>
void Solver<S>::boundary_forces(const Due& due) {
  const bool acts = built::boundary_conditions && boundary_.any();
  if (!acts && !tied_.any()) return;
  timers_.measure(Phase::boundary_conditions, [&] {
    if (acts) follow_constraints();
    if (acts) boundary_.add_loads(space_->nodes(NodeNumbers::force), clock_.time(), clock_.lengths(), due.all());
    if (tied_.any()) {
      space_->show(NodeNumbers::force);
      tied_.distribute(model_);
      space_->take(NodeNumbers::force);
    }
    if (acts) hold(due);
  });
}

template <class S>
void Solver<S>::hold(const Due& due) {
  if (!boundary_.holds()) return;
  boundary_.hold(space_->nodes(NodeNumbers::all), clock_.time(), clock_.lengths(), schedule_.due_spans(due));
}

/// Constraints have acted, so that the velocities which the forces of now lead to are known; they act once more on what
/// equations add along held directions.
template <class S>
void Solver<S>::add_equation_forces(const Due& due) {
  if (!equations_.any()) return;
  timers_.measure(Phase::boundary_conditions, [&] {
    space_->show(NodeNumbers::all);
    equations_.add_forces(model_, clock_.lengths());
    space_->take(NodeNumbers::force);
    hold(due);
    if (!may_break_equations()) return;
    space_->show(NodeNumbers::force);
    equations_.keep_forces(model_);
  });
}

/// What acts on nodes behind their equations.
template <class S>
bool Solver<S>::may_break_equations() const {
  return equations_.any() && (contact_.acts_on_velocities() || !model_.scene.rigid_walls.empty());
}

template <class S>
void Solver<S>::look_at_equations() {
  if (!may_break_equations()) return;
  timers_.measure(Phase::boundary_conditions, [&] {
    space_->show(NodeNumbers::force);
    equations_.require_kept_forces(model_, clock_.lengths());
  });
}

template <class S>
void Solver<S>::share_rigid_forces() {
  if (!rigid_.any()) return;
  timers_.measure(Phase::boundary_conditions, [&] {
    space_->show(NodeNumbers::force);
    rigid_.share_forces(model_, clock_.time(), clock_.lengths());
    space_->take(NodeNumbers::force);
  });
}

template <class S>
ContactWork Solver<S>::contact_after_constraints(const Due& due) {
  if (!contact_.impulse_nodes().empty()) timers_.measure(Phase::contact_forces, [&] { contact_.show_impulse_nodes(); });
  const std::vector<NodeBound> bounds =
      boundary_.bounds(node_arrays(model_), contact_.impulse_nodes(), clock_.time(), clock_.lengths());
  const ContactWork work = contact_.after_constraints(model_, clock_.lengths(), bounds, timers_);
  if (contact_.acts_on_velocities()) {  // they may have loaded nodes that are held
    timers_.measure(Phase::boundary_conditions, [&] { hold(due); });
    share_rigid_forces();
  }
  return work;
}

template <class S>
void Solver<S>::wall_reactions(const Due& due) {
  if (!built::boundary_conditions || !boundary_.any()) return;
  timers_.measure(Phase::boundary_conditions, [&] {
    const NodeNumbers changes = boundary_.walls_push_held_nodes() ? NodeNumbers::all : NodeNumbers::force;
    boundary_.add_wall_reactions(space_->nodes(changes), clock_.time(), clock_.lengths(), schedule_.due_spans(due));
    if (tied_.any() && boundary_.loads_tied_nodes()) {
      space_->show(NodeNumbers::force);
      tied_.put_accelerations(model_);
      space_->take(NodeNumbers::force);
    }
    boundary_.count_work(space_->nodes(NodeNumbers::none), clock_.lengths());
  });
  if (contact_.was_bounded()) {
    timers_.measure(Phase::contact_forces, [&] { contact_.follow_bounds(model_, clock_.lengths()); });
  }
}

/// Returns the energies of the nodes that are integrated in this step of the cycle.
template <class S>
MotionEnergy Solver<S>::integrate(const Due& due) {
  return timers_.measure(Phase::integration, [&] {
    if (due.all() && body_energies_.any()) {
      body_energies_.take_kinetic(space_->nodes(NodeNumbers::none), clock_.lengths());
    }
    MotionEnergy motion = space_->integrate(due, clock_.lengths());
    if (rigid_.any()) motion.kinetic += rigid_.kinetic_beside(clock_.lengths());
    return motion;
  });
}

/// The last word on their nodes.
template <class S>
void Solver<S>::move_rigid_bodies() {
  if (!rigid_.any()) return;
  timers_.measure(Phase::integration, [&] {
    space_->show(NodeNumbers::motion);
    rigid_.move(model_, clock_.lengths());
    space_->take(NodeNumbers::motion);
  });
}

/// Before the velocities of the step are counted for the means of subcycling.
template <class S>
void Solver<S>::reflect_at_symmetry_planes(const Due& due) {
  if (!may_reflect()) return;
  timers_.measure(Phase::integration, [&] {
    boundary_.add_work(symmetry_walls_.reflect(space_->nodes(NodeNumbers::motion), clock_.lengths(), due.all(),
                                               schedule_.due_spans(due)));
  });
}

/// The total of the energies is checked where all elements are at one time.
template <class S>
void Solver<S>::keep_accounts(const Due& due, const InternalForceResult<S>& element, const ContactWork& contact,
                              const MotionEnergy& motion) {
  ledger_.book(element, contact, boundary_.work() + equations_.work() + rigid_.work(), clock_.dt_before());
  if (body_energies_.any()) body_energies_.book(space_->work_of_bodies());
  counts_.count(due, element, contact, contact_.surface_elements(), model_.element_count(), clock_.force_time());
  const double energy = motion.kinetic + energies().total();
  if (element.inverted_count > 0 || !std::isfinite(energy)) model();  // where is looked for on the host, in all of it
  guards_.check_volumes(element);
  watch_corners(element.inside_out_count);
  guards_.check_finite(energy);
  if (!due.all()) return;
  if (due.first) ledger_.set_drift(drift_energy(model_, initial_momentum_), rounding<S>, energy_at_rest(model_));
  ledger_.close(due.first, motion.kinetic);
  clock_.take_change(motion.change + boundary_.take_stopped() + std::exchange(given_leap_, {}).energy,
                     ledger_.in_motion());
  watch_energies();
  guards_.check_energy(ledger_);
  guards_.check_time_step();
}

/// Where the first corner has turned over is looked for once, and where one is to stop the run.
template <class S>
void Solver<S>::watch_corners(std::int64_t inside_out) {
  const bool first = inside_out_.look(inside_out, clock_.force_time());
  if (inside_out == 0) return;
  if (first) inside_out_.set_first(most_folded(model(), clock_.dt(), false).slot);
  if (may_stop_inside_out(model_.scene)) {
    model();
    guards_.check_inside_out(inside_out);
  }
}

/// Where an energy is beyond its bound is looked for once, when it goes there.
template <class S>
void Solver<S>::watch_energies() {
  watch_.look(ledger_, sound_swallowing_, clock_.force_time());
  for (const Watched kind : {Watched::balance, Watched::kinetic_below_zero, Watched::internal_below_zero}) {
    if (watch_.just_beyond(kind)) watch_.set_place(kind, clock_.limiting_slot());
  }
  for (const Watched kind : {Watched::contact_created, Watched::contact_swallowed}) {
    if (watch_.just_beyond(kind)) watch_.set_place(kind, most_pushed_node(model_, *contact()));
  }
  for (const Watched kind : {Watched::hourglass_created, Watched::hourglass_large, Watched::hourglass_plastic}) {
    if (watch_.just_beyond(kind)) watch_.set_place(kind, most_hourglassed_slot(model()));
  }
}

template class Solver<double>;
template class Solver<float>;

}  // namespace pinball

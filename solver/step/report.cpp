#include "report.hpp"

#include <fmt/core.h>

#include <algorithm>

#include <kernels/exec.hpp>
#include <solver/base/state_hash.hpp>
#include <solver/base/version.h>
#include <solver/device/devices.hpp>
#include <solver/model/place_names.hpp>

#include "report_soundness.hpp"

namespace pinball {

template <class S>
std::string element_name(const Model<S>& model, std::int64_t slot) {
  const std::int32_t element = slot < 0 ? -1 : model.element_of_slot[slot];
  if (element < 0) return "no element";
  return element_name(model.mesh, element);
}

template <class S>
std::vector<BodyResult> body_results(const Solver<S>& solver) {
  std::vector<BodyResult> results = solver.bodies_at_start();
  const std::vector<BodySum> sums = solver.body_sums();
  for (std::size_t b = 0; b < results.size(); ++b) {
    BodyResult& r = results[b];
    r.eroded_elements = sums[b].eroded;
    r.mass_remaining = sums[b].mass;
    r.max_plastic_strain = sums[b].plastic_strain;
    for (std::size_t k = 0; k < 3; ++k) {
      r.velocity[k] = r.mass_remaining > 0 ? sums[b].momentum[k] / r.mass_remaining : 0.0;
    }
  }
  return results;
}

template <class S>
std::vector<Point> contact_forces_on_nodes(const Solver<S>& solver) {
  const Model<S>& model = solver.layout();
  Array<Point> in_store(model.mesh.nodes.size());
  solver.contact()->add_node_forces({in_store.data(), in_store.size()});
  std::vector<Point> force(in_store.size());
  parallel_for("contact forces of nodes", RangePolicy<>{0, std::ssize(force)},
               [&](std::int64_t n) { force[n] = in_store[model.node_of_scene_node[n]]; });
  return force;
}

template <class S>
ProgressState progress_state(const Solver<S>& solver) {
  const std::int64_t elements = solver.element_count();
  return {solver.steps(),
          solver.force_time(),
          solver.dt(),
          solver.balance_error(),
          elements - solver.counts().eroded_elements(),
          elements,
          solver.contact() != nullptr ? solver.counts().pairs() : -1};
}

/// Temperatures and damage, where any material has them; of eroded elements those at rest.
template <class S>
void take_material_numbers(const Model<S>& model, FieldSnapshot& s) {
  const auto take = [&](std::vector<double>& field, int MaterialPlaces::*kept, const auto& at_rest) {
    const auto has = [&](const ElementConstants<S>& constants) { return constants.places.*kept >= 0; };
    if (std::none_of(model.constants.begin(), model.constants.end(), has)) return;
    field.resize(s.hexahedra.size());
    for (std::size_t t = 0; t + 1 < model.tile_packs.size(); ++t) {
      const std::size_t part = model.tile_part[t];
      const int place = model.constants[part].places.*kept;
      const double rest = at_rest(model.scene.materials[model.parts[part].material]);
      for (const std::int64_t slot : model.slots_of(t)) {
        const std::int32_t element = model.element_of_slot[slot];
        if (element < 0) continue;
        field[element] =
            rest + (place < 0 || !model.elements.alive(slot) ? 0.0 : model.elements.material_number(slot, place));
      }
    }
  };
  take(s.temperature, &MaterialPlaces::temperature,
       [](const Material& m) { return m.johnson_cook ? m.johnson_cook->room_temperature : 0.0; });
  take(s.damage, &MaterialPlaces::damage, [](const Material&) { return 0.0; });
}

/// Rigid bodies turn, and their nodes do not come back on straight ways.
template <class S>
void put_rigid_positions(const Solver<S>& solver, std::vector<Point>& position) {
  if (!solver.rigid().any()) return;
  const Model<S>& model = solver.layout();
  std::vector<Point> in_store(position.size());
  for (std::size_t n = 0; n < position.size(); ++n) in_store[model.node_of_scene_node[n]] = position[n];
  solver.rigid().put_positions_of_forces(in_store);
  for (std::size_t n = 0; n < position.size(); ++n) position[n] = in_store[model.node_of_scene_node[n]];
}

namespace {

/// model: the solver's, brought up to date.
template <class S>
FieldSnapshot snapshot_of(const Solver<S>& solver, const Model<S>& model) {
  FieldSnapshot s;
  s.step = solver.steps();
  s.time = solver.force_time();
  s.hexahedra = model.mesh.hexahedra;
  s.body = model.mesh.body;
  const std::size_t nodes = model.mesh.nodes.size(), elements = s.hexahedra.size();
  s.position.resize(nodes);
  s.velocity.resize(nodes);
  s.contact_force.assign(nodes, Point{});
  parallel_for("nodes of a snapshot", RangePolicy<>{0, std::ssize(s.position)}, [&](std::int64_t n) {
    const std::int32_t node = model.node_of_scene_node[n];
    const S *const x = model.nodes.position_of(node), *const v = model.nodes.velocity_of(node);
    const Point ahead = solver.way_ahead(node);  // of the stresses: back to their time
    for (int k = 0; k < 3; ++k) {
      s.velocity[n][k] = v[k];
      s.position[n][k] = x[k] - ahead[k];
    }
  });
  put_rigid_positions(solver, s.position);
  s.stress.resize(elements);
  s.plastic_strain.assign(elements, 0.0);
  take_material_numbers(model, s);
  s.pinball_radius.assign(elements, 0.0);
  s.alive.resize(elements);
  parallel_for("elements of a snapshot", RangePolicy<>{0, std::ssize(s.hexahedra)}, [&](std::int64_t e) {
    const std::int64_t slot = model.slot_of_element[e];
    for (int c = 0; c < 6; ++c) s.stress[e][c] = model.elements.stress_of(slot, c);
    if (!model.elements.plastic_strain.empty()) {
      s.plastic_strain[e] = model.elements.plastic_strain[slot];
    }
    s.alive[e] = model.elements.alive(slot) ? 1 : 0;
  });
  if (solver.contact() != nullptr) {
    std::vector<double> radius(model.elements.slots, 0.0);
    s.contact_force = contact_forces_on_nodes(solver);
    solver.contact()->put_radii(ModelSurface<S>(model), radius);
    for (std::size_t e = 0; e < elements; ++e) {
      s.pinball_radius[e] = radius[model.slot_of_element[e]];
    }
  }
  return s;
}

}  // namespace

template <class S>
FieldSnapshot snapshot(const Solver<S>& solver) {
  return snapshot_of(solver, solver.model());
}

template <class S>
FieldSnapshot own_snapshot(const Solver<S>& solver) {
  return snapshot_of(solver, solver.own_model());
}

template <class S>
std::uint64_t state_hash(const Model<S>& model) {
  // In the order of the scene, so that the hash does not depend on how the stores are laid out.
  StateHash hash;
  for (const std::int32_t n : model.node_of_scene_node) {
    hash.add(std::span<const S>(model.nodes.position_of(n), 3));
    hash.add(std::span<const S>(model.nodes.velocity_of(n), 3));
  }
  for (const std::int64_t slot : model.slot_of_element) {
    model.elements.stress.visit([&]<class E>(const Array<E>& stress) {
      E components[6];
      for (int c = 0; c < 6; ++c) components[c] = stress[model.elements.at(slot, c, 6)];
      hash.add(std::span<const E>(components));
    });
  }
  return hash.value();
}

template <class S>
Energies reported_energies(const Solver<S>& solver) {
  Energies energies = solver.energies();
  energies.kinetic_below_zero = std::min(0.0, energies.kinetic);
  energies.kinetic = std::max(0.0, energies.kinetic);
  return energies;
}

template <class S>
void fill_summary(const Solver<S>& solver, RunSummary& summary) {
  const Model<S>& model = solver.model();
  const Scene& scene = model.scene;
  const StepClock& clock = solver.clock();
  const RunCounts& counts_so_far = solver.counts();
  const ContactAlgorithm<S>* contact = solver.contact();
  summary.version = PINBALL_VERSION;
  summary.threads = DefaultExecutionSpace::concurrency();
  summary.scene = scene.name;
  summary.title = scene.title;
  summary.units = scene.units;
  summary.precision = name_of(scene.precision);
  summary.device = device_name(scene.device);
  summary.simd_width = model.elements.width;
  const SharedWork shared = solver.shared_work();
  summary.parallel = {shared.ranks,          shared.records,   shared.messages, shared.common_nodes,
                      shared.bytes_per_step, shared.imbalance, shared.devices};
  summary.elements = model.element_count();
  summary.nodes = model.mesh.nodes.size();
  summary.steps = clock.steps();
  summary.end_time = clock.force_time();
  summary.dt_min = clock.dt_min();
  summary.dt_max = clock.dt_max();
  summary.dt_limited_by = step_limit(model, clock);
  for (std::size_t p = 0; p < phase_names.size(); ++p) {
    summary.phases.push_back({phase_names[p], solver.timers().seconds(static_cast<Phase>(p))});
  }
  WorkCounts counts = counts_so_far.work();
  const std::int64_t all_element_steps = model.element_count() * clock.steps();
  counts.rigid_element_steps = model.rigid_element_count() * clock.steps();
  summary.element_steps_rigid = counts.rigid_element_steps;
  summary.element_steps_eroded = counts.eroded_element_steps;
  summary.element_steps_resting = counts.resting_element_steps;
  summary.element_steps_subcycled = counts.subcycled_element_steps;
  summary.element_steps = all_element_steps - counts.eroded_element_steps - counts.resting_element_steps -
                          counts.subcycled_element_steps - counts.rigid_element_steps;
  summary.energy = reported_energies(solver);
  summary.initial_total = solver.initial_energy();
  summary.final_total = solver.energies().total();
  summary.balance_error_max = solver.ledger().balance_error_max();
  summary.momentum_initial = solver.initial_momentum();
  summary.momentum_final = solver.momentum();
  summary.bodies = body_results(solver);
  for (const double added : model.added_mass) summary.mass_added += added;
  for (const double mass : model.point_mass) summary.point_mass += mass;
  summary.rigid_bodies = solver.rigid().results();
  summary.joints = solver.rigid().joint_results();
  summary.walls = solver.boundary().walls();
  summary.pressures = solver.boundary().pressures();
  summary.probes = solver.probe_results();
  summary.tied = model.tie_counts;
  summary.contact_method = contact != nullptr ? contact->name() : "none";
  summary.contact_enforcement = contact != nullptr ? enforcement_name(scene.contact.enforcement) : "none";
  if (contact != nullptr) {
    const bool balls = scene.contact.method == ContactMethod::pinball && scene.contact.gap == ContactGap::pinball;
    summary.contact_gap = balls ? "pinball" : "face";
    summary.contact_pairs = solver.contact_pairs();
    summary.pinballs = contact->surface_elements();
    summary.searches = contact->searches();
    summary.searches_skipped = contact->searches_skipped();
  }
  summary.iterations = counts.iterations;
  counts.searches = summary.searches;
  counts.searches_skipped = summary.searches_skipped;
  summary.inner_element_steps = counts.inner_element_steps;
  summary.bytes_not_stored = static_cast<std::int64_t>(bytes_not_stored(model.elements));
  summary.skipped_seconds = estimate_skipped(counts, solver.timers(), all_element_steps);
  summary.pairs_max = counts_so_far.pairs_max();
  fill_soundness(solver, summary);
  summary.state_hash = state_hash(model);
  const std::int64_t bytes = solver.bytes();
  summary.bytes_per_element = bytes / std::max<std::int64_t>(1, summary.elements);
}

template <class S>
std::uint64_t fingerprint(const Model<S>& model) {
  StateHash hash;
  const auto add = [&hash](const auto& array) { hash.add(array.data(), array.size() * sizeof(array[0])); };
  add(model.elements.corner);
  if (model.masses_without_ties == nullptr) {
    add(model.nodes.inverse_mass);
    add(model.node_mass);
  } else {  // ties move masses in the course of a run
    std::vector<double> mass = model.node_mass;
    for (const auto& [n, without] : *model.masses_without_ties) mass[n] = without;
    add(mass);
  }
  add(model.element_mass);
  add(model.element_of_slot);
  add(model.tile_packs);
  add(model.tile_part);
  add(model.tile_colours.items);
  for (const RigidNodes& rigid : model.rigid) add(rigid.nodes);
  return hash.value();
}

template <class S>
std::string step_limit(const Model<S>& model, const StepClock& clock) {
  switch (clock.limited_by()) {
    case StepLimit::element:
      return element_name(model, clock.limiting_slot());
    case StepLimit::contact:
      return "contact";
    case StepLimit::impact_speed:
      return "the speed of impact";
    case StepLimit::rigid_bodies:
      return "rigid bodies";
    case StepLimit::none:
      break;
  }
  return "";
}

template std::string element_name(const Model<double>&, std::int64_t);
template std::string element_name(const Model<float>&, std::int64_t);
template std::string step_limit(const Model<double>&, const StepClock&);
template std::string step_limit(const Model<float>&, const StepClock&);
template std::vector<BodyResult> body_results(const Solver<double>&);
template std::vector<BodyResult> body_results(const Solver<float>&);
template std::uint64_t state_hash(const Model<double>&);
template std::uint64_t state_hash(const Model<float>&);
template std::uint64_t fingerprint(const Model<double>&);
template std::uint64_t fingerprint(const Model<float>&);
template ProgressState progress_state(const Solver<double>&);
template ProgressState progress_state(const Solver<float>&);
template FieldSnapshot snapshot(const Solver<double>&);
template FieldSnapshot snapshot(const Solver<float>&);
template FieldSnapshot own_snapshot(const Solver<double>&);
template FieldSnapshot own_snapshot(const Solver<float>&);
template Energies reported_energies(const Solver<double>&);
template Energies reported_energies(const Solver<float>&);
template void fill_summary(const Solver<double>&, RunSummary&);
template void fill_summary(const Solver<float>&, RunSummary&);

}  // namespace pinball

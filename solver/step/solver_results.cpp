#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include <kernels/exec.hpp>
#include <solver/base/version.h>
#include <solver/results/state_hash.hpp>

#include "solver.hpp"

namespace pinball {

template <class S>
bool Solver<S>::at_end() const {
  const TimeSettings& limits = model_.scene.time;
  // What finish() has still to do of the present cycle
  const std::int64_t steps = subcycling_ && steps_ > 0 ? subcycling_->cycle_steps() - 1 : 0;
  return time_ + static_cast<double>(steps) * dt_ >= limits.end * (1 - 1e-12) ||
         (limits.steps >= 0 && steps_ + steps >= limits.steps);
}

template <class S>
double Solver<S>::balance_error() const {
  const double difference = energies_.total() - initial_energy_;
  const double scale = std::max(initial_energy_, external_max_);
  return scale > 0 ? difference / scale : difference == 0 ? 0.0 : std::copysign(1.0, difference);
}

template <class S>
Point Solver<S>::momentum() const {
  Point sum{};
  for (std::size_t n = 0; n < model_.node_mass.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += model_.node_mass[n] * static_cast<double>(model_.nodes.velocity[4 * n + k]);
    }
  }
  return sum;
}

template <class S>
std::string Solver<S>::element_name(std::int64_t slot) const {
  const std::int32_t element = slot < 0 ? -1 : model_.element_of_slot[static_cast<std::size_t>(slot)];
  if (element < 0) return "no element";
  const auto body = static_cast<std::size_t>(model_.mesh.body[static_cast<std::size_t>(element)]);
  return fmt::format("element {} of body {}", element, model_.mesh.body_names[body]);
}

template <class S>
std::vector<BodyResult> Solver<S>::body_results() const {
  std::vector<BodyResult> results(model_.mesh.body_names.size());
  for (std::size_t b = 0; b < results.size(); ++b) results[b].name = model_.mesh.body_names[b];
  for (std::int64_t slot = 0; slot < model_.elements.slots; ++slot) {  // in the order of memory
    const auto i = static_cast<std::size_t>(slot);
    if (model_.element_of_slot[i] < 0) continue;
    const auto e = static_cast<std::size_t>(model_.element_of_slot[i]);
    BodyResult& r = results[static_cast<std::size_t>(model_.mesh.body[e])];
    ++r.elements;
    r.mass_initial += model_.element_mass[e];
    if (!(model_.elements.mass[i] > S(0))) {
      ++r.eroded_elements;
      continue;
    }
    r.mass_remaining += model_.element_mass[e];
    for (int corner = 0; corner < 8; ++corner) {
      const auto n = 4 * static_cast<std::size_t>(model_.elements.corner[ElementStore<S>::at(slot, corner, 8)]);
      for (std::size_t k = 0; k < 3; ++k) {
        r.velocity[k] += model_.element_mass[e] / 8 * static_cast<double>(model_.nodes.velocity[n + k]);
      }
    }
    if (!model_.elements.plastic_strain.empty()) {
      r.max_plastic_strain = std::max(r.max_plastic_strain, static_cast<double>(model_.elements.plastic_strain[i]));
    }
  }
  for (BodyResult& r : results) {
    for (double& v : r.velocity) v = r.mass_remaining > 0 ? v / r.mass_remaining : 0.0;
  }
  return results;
}

template <class S>
std::vector<std::string> Solver<S>::more_columns() const {
  std::vector<std::string> columns;
  for (const WallResult& wall : boundary_.walls()) {
    for (const char* quantity : {"force", "impulse"}) columns.push_back(fmt::format("{}_{}", wall.name, quantity));
  }
  const std::vector<std::string> of_probes = probes_.columns();
  columns.insert(columns.end(), of_probes.begin(), of_probes.end());
  return columns;
}

template <class S>
ProgressState Solver<S>::progress_state() const {
  return {steps_, force_time_, dt_, balance_error(), model_.element_count() - eroded_elements_};
}

template <class S>
HistoryRow Solver<S>::history_row() const {
  HistoryRow row;
  row.step = steps_;
  row.time = force_time_;
  row.dt = dt_ > 0 ? dt_ : dt_before_;
  row.energy = energies_;
  row.balance_error = balance_error();
  row.momentum = momentum();
  row.bodies = body_results();
  for (const WallResult& wall : boundary_.walls()) {
    row.more.push_back(wall.force);
    row.more.push_back(wall.impulse);
  }
  const std::vector<double> of_probes = probes_.values(model_, dt_);
  row.more.insert(row.more.end(), of_probes.begin(), of_probes.end());
  return row;
}

template <class S>
void Solver<S>::snapshot(FieldSnapshot& s) const {
  s.step = steps_;
  s.time = force_time_;
  s.hexahedra = model_.mesh.hexahedra;
  s.body = model_.mesh.body;
  const std::size_t nodes = model_.mesh.nodes.size(), elements = s.hexahedra.size();
  s.position.resize(nodes);
  s.velocity.resize(nodes);
  s.contact_force.assign(nodes, Point{});
  for (std::size_t n = 0; n < nodes; ++n) {
    const auto store_node = static_cast<std::size_t>(model_.node_of_scene_node[n]);
    for (std::size_t k = 0; k < 3; ++k) {
      s.velocity[n][k] = static_cast<double>(model_.nodes.velocity[4 * store_node + k]);
      // Positions are one step ahead of the stresses: back to their time.
      s.position[n][k] = static_cast<double>(model_.nodes.position[4 * store_node + k]) - dt_ * s.velocity[n][k];
    }
  }
  s.stress.resize(elements);
  s.plastic_strain.assign(elements, 0.0);
  s.pinball_radius.assign(elements, 0.0);
  s.alive.resize(elements);
  for (std::size_t e = 0; e < elements; ++e) {
    const std::int64_t slot = model_.slot_of_element[e];
    for (int c = 0; c < 6; ++c) {
      s.stress[e][static_cast<std::size_t>(c)] =
          static_cast<double>(model_.elements.stress[ElementStore<S>::at(slot, c, 6)]);
    }
    if (!model_.elements.plastic_strain.empty()) {
      s.plastic_strain[e] = static_cast<double>(model_.elements.plastic_strain[static_cast<std::size_t>(slot)]);
    }
    s.alive[e] = model_.elements.mass[static_cast<std::size_t>(slot)] > S(0) ? 1 : 0;
  }
  if (contact_) {
    std::vector<Point> force(nodes, Point{});
    std::vector<double> radius(static_cast<std::size_t>(model_.elements.slots), 0.0);
    contact_->report(ModelSurface<S>(model_), force, radius);
    for (std::size_t n = 0; n < nodes; ++n) {
      s.contact_force[n] = force[static_cast<std::size_t>(model_.node_of_scene_node[n])];
    }
    for (std::size_t e = 0; e < elements; ++e) {
      s.pinball_radius[e] = radius[static_cast<std::size_t>(model_.slot_of_element[e])];
    }
  }
}

template <class S>
std::uint64_t Solver<S>::state_hash() const {
  // In the order of the scene, so that the hash does not depend on how the stores are laid out.
  StateHash hash;
  for (const std::int32_t n : model_.node_of_scene_node) {
    hash.add(std::span<const S>(&model_.nodes.position[4 * static_cast<std::size_t>(n)], 3));
    hash.add(std::span<const S>(&model_.nodes.velocity[4 * static_cast<std::size_t>(n)], 3));
  }
  for (const std::int64_t slot : model_.slot_of_element) {
    S stress[6];
    for (int c = 0; c < 6; ++c) stress[c] = model_.elements.stress[ElementStore<S>::at(slot, c, 6)];
    hash.add(std::span<const S>(stress, 6));
  }
  return hash.value();
}

template <class S>
void Solver<S>::fill_summary(RunSummary& summary) const {
  const Scene& scene = model_.scene;
  summary.version = PINBALL_VERSION;
  summary.threads = DefaultExecutionSpace::concurrency();
  summary.scene = scene.name;
  summary.title = scene.title;
  summary.units = scene.units;
  summary.precision = sizeof(S) == sizeof(double) ? "double" : "float";
  summary.simd_width = ElementStore<S>::width;
  summary.elements = model_.element_count();
  summary.nodes = static_cast<std::int64_t>(model_.mesh.nodes.size());
  summary.steps = steps_;
  summary.end_time = force_time_;
  summary.dt_min = dt_min_;
  summary.dt_max = dt_max_;
  summary.dt_limited_by = dt_limited_by_;
  for (std::size_t p = 0; p < phase_names.size(); ++p) {
    summary.phases.push_back({phase_names[p], timers_.seconds(static_cast<Phase>(p))});
  }
  const std::int64_t all_element_steps = model_.element_count() * steps_;
  summary.element_steps_eroded = counts_.eroded_element_steps;
  summary.element_steps_resting = counts_.resting_element_steps;
  summary.element_steps_subcycled = counts_.subcycled_element_steps;
  summary.element_steps = all_element_steps - counts_.eroded_element_steps - counts_.resting_element_steps -
                          counts_.subcycled_element_steps;
  summary.energy = energies_;
  summary.initial_total = initial_energy_;
  summary.final_total = energies_.total();
  summary.balance_error_max = balance_error_max_;
  summary.momentum_initial = initial_momentum_;
  summary.momentum_final = momentum();
  summary.bodies = body_results();
  summary.walls = boundary_.walls();
  summary.probes = probes_.results(model_, dt_);
  summary.contact_method = contact_ ? contact_->name() : "none";
  summary.contact_enforcement = contact_ ? enforcement_name(scene.contact.enforcement) : "none";
  if (contact_) {
    summary.pinballs = contact_->surface_elements();
    summary.searches = contact_->searches();
    summary.searches_skipped = contact_->searches_skipped();
  }
  WorkCounts counts = counts_;
  counts.searches = summary.searches;
  counts.searches_skipped = summary.searches_skipped;
  summary.inner_element_steps = counts.inner_element_steps;
  summary.bytes_not_stored = static_cast<std::int64_t>(bytes_not_stored(model_.elements));
  summary.skipped_seconds = estimate_skipped(counts, timers_, all_element_steps);
  summary.pairs_max = pairs_max_;
  summary.max_penetration_ratio = penetration_ratio_max_;
  if (initial_overlap_.points > 0) {
    summary.overlapping_bodies = fmt::format("{} and {}", initial_overlap_.first, initial_overlap_.second);
  }
  summary.state_hash = state_hash();
  const std::size_t bytes = model_.bytes() + internal_forces_.bytes() + (contact_ ? contact_->bytes() : 0) +
                            symmetry_walls_.bytes() + boundary_.bytes() + (subcycling_ ? subcycling_->bytes() : 0);
  summary.bytes_per_element = static_cast<std::int64_t>(bytes) / std::max<std::int64_t>(1, summary.elements);
}

template class Solver<double>;
template class Solver<float>;

}  // namespace pinball

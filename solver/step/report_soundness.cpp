#include "report_soundness.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <vector>

#include <solver/model/place_names.hpp>
#include <solver/results/sound_bounds.hpp>

#include "places.hpp"
#include "report.hpp"

namespace pinball {

namespace {

template <class S>
WatchedShare watched_share(const Solver<S>& solver, Watched kind) {
  const EnergyWatch& watch = solver.watch();
  WatchedShare share{watch.share(kind), watch.since(kind), ""};
  const std::int64_t place = watch.place(kind);
  if (place < 0) return share;
  const bool node = kind == Watched::contact_created || kind == Watched::contact_swallowed;
  share.place = node ? node_name(solver.model(), place) : element_name(solver.model(), place);
  return share;
}

template <class S>
std::string sentence_of(const Model<S>& model, const UnseenBalls& unseen) {
  const auto element = [&model](std::int64_t e) { return element_name(model, model.slot_of_element[e]); };
  const std::string first = element(unseen.first), second = element(unseen.second);
  const std::string balls = unseen.first == unseen.second
                                ? fmt::format("where it folds, the balls of elements like {}", first)
                                : fmt::format("the balls of {} and {}", first, second);
  return unseen.depth < 1
             ? fmt::format("{} meet when faces are already {:.3g} % of an element inside", balls, 100 * unseen.depth)
             : fmt::format("{} may pass between each other", balls);
}

/// The body that has most added to it, and taken from it, where that is more than is sound.
template <class S>
std::string large_added_mass(const Model<S>& model) {
  if (model.added_mass.empty()) return "";
  std::vector<double> changed(model.mesh.body_names.size(), 0.0), material(changed.size(), 0.0);
  for (std::size_t e = 0; e < model.added_mass.size(); ++e) {
    const std::size_t body = model.mesh.body[e];
    changed[body] += std::abs(model.added_mass[e]);
    material[body] += model.material_mass(e);
  }
  std::size_t worst = 0;
  for (std::size_t b = 0; b < changed.size(); ++b) {
    if (changed[b] * material[worst] > changed[worst] * material[b]) worst = b;
  }
  const double share = changed[worst] / material[worst];
  if (!(share > sound::added_mass)) return "";
  return fmt::format(
      "time.smallest_step = {:.6g} {} body {} by {:.3g} % of it, more than {:.3g} %: what it does in time is another, "
      "try a smaller one, or larger elements",
      model.scene.time.smallest_step,
      model.scene.time.mass_scaling == MassScaling::all ? "changes the mass of" : "raises the mass of",
      model.mesh.body_names[worst], 100 * share, 100 * sound::added_mass);
}

OverlapResult overlap_result(const ModelMesh& mesh, const InitialOverlap& found) {
  OverlapResult overlap;
  overlap.first = found.first;
  overlap.second = found.second;
  overlap.points = found.points;
  overlap.nodes = found.nodes;
  overlap.depth = found.depth;
  overlap.share = found.share;
  overlap.time = found.time;
  if (found.node >= 0) overlap.place = node_name(mesh, found.node);
  return overlap;
}

template <class S>
void add_overlaps(const Solver<S>& solver, RunSummary& summary) {
  for (const InitialOverlap& found : solver.initial_overlaps()) {
    if (summary.overlaps.empty()) summary.overlapping_bodies = fmt::format("{} and {}", found.first, found.second);
    summary.overlaps.push_back(overlap_result(solver.mesh(), found));
  }
  for (const InitialOverlap& found : solver.begun_overlaps()) {
    summary.overlaps.push_back(overlap_result(solver.mesh(), found));
  }
  for (const InitialOverlap& found : solver.passed_walls()) {
    summary.overlaps.push_back(overlap_result(solver.mesh(), found));
    summary.overlaps.back().rigid_wall = true;
  }
}

}  // namespace

template <class S>
void fill_soundness(const Solver<S>& solver, RunSummary& summary) {
  const EnergyLedger& ledger = solver.ledger();
  summary.energy_in_motion = ledger.in_motion();
  summary.balance_error_in_motion = watched_share(solver, Watched::balance);
  summary.balance_error_in_motion.largest = ledger.balance_error_in_motion_max();
  summary.contact_created = watched_share(solver, Watched::contact_created);
  summary.contact_swallowed = watched_share(solver, Watched::contact_swallowed);
  summary.contact_swallowed_sound = solver.sound_swallowing();
  summary.hourglass_created = watched_share(solver, Watched::hourglass_created);
  summary.hourglass_large = watched_share(solver, Watched::hourglass_large);
  summary.hourglass_plastic = watched_share(solver, Watched::hourglass_plastic);
  summary.kinetic_below_zero = watched_share(solver, Watched::kinetic_below_zero);
  summary.internal_below_zero = watched_share(solver, Watched::internal_below_zero);
  const InsideOutWatch& corners = solver.inside_out();
  summary.inside_out = {corners.now(), corners.most(), corners.first_time(),
                        corners.most() > 0 ? element_name(solver.model(), corners.first_slot()) : ""};
  const RunCounts& counts = solver.counts();
  summary.max_penetration_ratio = counts.penetration_ratio_max();
  summary.max_penetration_time = counts.deepest_time();
  summary.max_penetration_place = node_name(solver.model(), counts.deepest_node());
  add_overlaps(solver, summary);
  const InitialOverlap& now = solver.overlap_at_end();
  if (now.points > 0) {
    summary.overlap_at_end = fmt::format("{} and {}, by {} of their nodes, and points or edges of elements", now.first,
                                         now.second, now.points);
  }
  summary.mesh_warnings = solver.mesh().warnings;
  summary.unlikely = solver.look().unlikely;
  if (!solver.many_steps().empty()) summary.unlikely.push_back(solver.many_steps());
  summary.expected_impact = solver.impact_speed();
  summary.contact_because = solver.look().contact_because;
  summary.near_nodes = solver.near_nodes();
  summary.unstable_hourglass = solver.unstable_hourglass();
  summary.large_added_mass = large_added_mass(solver.model());
  if (solver.unseen_balls()) summary.unseen_balls = sentence_of(solver.model(), *solver.unseen_balls());
}

template void fill_soundness(const Solver<double>&, RunSummary&);
template void fill_soundness(const Solver<float>&, RunSummary&);

}  // namespace pinball

#include "warnings.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "energy_checks.hpp"
#include "sound_bounds.hpp"

namespace pinball {

namespace {

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

/// What the chosen form of contact is known not to do, by tests/contact/trials.
void add_limits_of_contact(const RunSummary& s, std::vector<std::string>& found) {
  const char* const instead = s.contact_gap == "face" && s.contact_method == "pinball"
                                  ? "choose contact.enforcement = \"lagrange\", which takes as long"
                                  : "choose contact.method = \"pinball\" with contact.enforcement = \"lagrange\" and "
                                    "contact.gap = \"face\"";
  if (s.contact_method == "slideline") {
    found.push_back(fmt::format(
        "the slideline does not see edges that cross, which go into each other by up to an element, nor a "
        "surface that folds onto itself within two elements{}: {}",
        s.contact_enforcement == "penalty" ? ", nor what is much smaller than the faces that it hits" : "", instead));
  } else if (s.contact_method == "pinball" && s.contact_gap == "face" && s.contact_enforcement == "projection") {
    found.push_back(
        fmt::format("one projection of velocities is not enough for bodies that meet at edges and corners: their "
                    "rebound may be 30 % "
                    "off, and contact may make up to 10 % of their energy: {}",
                    instead));
  }
}

}  // namespace

std::vector<std::string> warnings(const RunSummary& summary) {
  std::vector<std::string> found;
  for (const EnergyCheck& check : energy_checks(summary)) {
    if (!check.sound()) found.push_back(check.warning);
  }
  // Erosion exposes what lies deep inside others, which is no fault of the contact.
  const bool eroded = std::any_of(summary.bodies.begin(), summary.bodies.end(),
                                  [](const BodyResult& body) { return body.eroded_elements > 0; });
  const bool springs = summary.contact_enforcement == "penalty", balls = summary.contact_gap == "pinball";
  const double bound = springs || balls ? sound::penetration : sound::penetration_of_faces;
  if (!eroded && summary.max_penetration_ratio > bound) {
    const std::string& place = summary.max_penetration_place;
    found.push_back(
        fmt::format("bodies went into each other by up to {} of the radii of their pinballs, at time {:.6g}{}: "
                    "try {}, finer meshes, or bodies that do not overlap at the start",
                    percent(summary.max_penetration_ratio), summary.max_penetration_time,
                    place.empty() ? "" : " at " + place, springs ? "a larger contact.beta" : "a smaller time.cfl"));
  }
  if (!summary.overlap_at_end.empty()) {
    found.push_back(
        fmt::format("bodies are in each other at the end, at time {:.6g}, more than {} of an element deep: {}; "
                    "contact has let them in",
                    summary.end_time, percent(sound::depth_at_end), summary.overlap_at_end));
  }
  if (static_cast<double>(summary.sweeps.unsolved) > sound::unsolved * static_cast<double>(summary.sweeps.solutions)) {
    found.push_back(fmt::format(
        "the impulses of contact were not solved for in {} of {} steps with contact, where {} sweeps were not enough: "
        "try a smaller time.cfl, or contact.enforcement = \"projection\"",
        summary.sweeps.unsolved, summary.sweeps.solutions, summary.sweeps.largest));
  }
  for (const std::string& warning : start_warnings(summary)) found.push_back(warning);
  return found;
}

std::string added_mass_text(const RunSummary& summary) {
  if (summary.mass_added == 0) return "";
  double all = 0;
  std::string bodies;
  for (const BodyResult& body : summary.bodies) {
    all += body.mass_initial - body.mass_added;
    if (body.mass_added == 0) continue;
    bodies += fmt::format("{} {} {:.6g} ({:.3g} %)", bodies.empty() ? ": body" : ", body", body.name, body.mass_added,
                          100 * body.mass_added / (body.mass_initial - body.mass_added));
  }
  return fmt::format("mass added for time.smallest_step: {:.6g}, {:.3g} % of all{}", summary.mass_added,
                     100 * summary.mass_added / all, bodies);
}

std::vector<std::string> start_warnings(const RunSummary& summary) {
  std::vector<std::string> found = summary.mesh_warnings;
  if (!summary.overlapping_bodies.empty()) {
    found.push_back(fmt::format("bodies {} overlap at the start: contact cannot tell from which side they came",
                                summary.overlapping_bodies));
  }
  if (!summary.unseen_balls.empty()) {
    found.push_back(
        fmt::format("{}: choose contact.enforcement = \"lagrange\" with contact.gap = \"face\", or meshes "
                    "of near-cubes of one size",
                    summary.unseen_balls));
  }
  if (!summary.unstable_hourglass.empty()) found.push_back(summary.unstable_hourglass);
  if (!summary.large_added_mass.empty()) found.push_back(summary.large_added_mass);
  for (const TiedResult& tied : summary.tied) {
    if (tied.nodes > 0) continue;
    found.push_back(fmt::format("contact.tied {}: try a larger tolerance, or other sides", tied_text(tied)));
  }
  found.insert(found.end(), summary.near_nodes.begin(), summary.near_nodes.end());
  add_limits_of_contact(summary, found);
  return found;
}

std::string tied_text(const TiedResult& tied) {
  std::string text = fmt::format("{}: {} node{} tied", tied.name, tied.nodes, tied.nodes == 1 ? " is" : "s are");
  if (tied.near > 0)
    text += fmt::format(", {} within five times the tolerance {} not", tied.near, tied.near == 1 ? "is" : "are");
  if (tied.held > 0) text += fmt::format(", {} held or moved {} not", tied.held, tied.held == 1 ? "is" : "are");
  if (tied.taken > 0)
    text += fmt::format(", {} tied already or tied to {} not", tied.taken, tied.taken == 1 ? "is" : "are");
  return text;
}

}  // namespace pinball

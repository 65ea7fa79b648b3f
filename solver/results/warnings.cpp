#include "warnings.hpp"

#include <fmt/core.h>

#include <algorithm>

#include <solver/base/counted.hpp>

#include "energy_checks.hpp"
#include "percent.hpp"
#include "sound_bounds.hpp"

namespace pinball {

namespace {

/// Impulses that are not those of the coupled system: faces that should close no gap do, or are pushed askew.
void add_unconverged_contact(const IterationCounts& counts, std::vector<std::string>& found) {
  const double share = static_cast<double>(counts.at_bound) / static_cast<double>(counts.solutions);
  if (!(share > sound::unconverged)) return;
  found.push_back(fmt::format(
      "the impulses of contact did not converge in {} with contact ({}), within {}: up to "
      "{:.3g} of "
      "a velocity was left, {} of the largest that contact had to change in its step: try a smaller time.cfl, meshes "
      "that fit where bodies meet, or contact.enforcement = \"projection\"",
      counted_of(counts.at_bound, counts.solutions, "step"), percent(share), counted(counts.largest, "iteration"),
      counts.residual, percent(counts.relative)));
}

/// "bodies pin and plate overlap at the start, by 32 of their nodes, deepest at node 17 of body pin, which lies 0.5
/// deep (5 % of ...)"
std::string overlap_text(const OverlapResult& overlap) {
  std::string text = fmt::format(
      "bodies {} and {} overlap {}", overlap.first, overlap.second,
      overlap.time > 0 ? fmt::format("when their contact begins, at time {:.6g}", overlap.time) : "at the start");
  if (overlap.nodes == 0) {
    return text + fmt::format(", by {} or edges of their elements, although no node of one lies in the other",
                              counted(overlap.points, "point"));
  }
  return text + fmt::format(", by {} of their nodes, deepest at {}, which lies {:.4g} deep ({} of an element)",
                            overlap.nodes, overlap.place, overlap.depth, percent(overlap.share));
}

/// What contact makes of an overlap, and what may be done.
std::string overlap_advice(const RunSummary& summary, const OverlapResult& overlap) {
  const bool late = overlap.time > 0, springs = summary.contact_enforcement == "penalty";
  if (late && springs) {
    return ": springs push them apart at once, with energy that nobody gave: begin it before they meet, or keep them "
           "apart till then";
  }
  if (overlap.nodes == 0 || overlap.share > (late ? sound::late_overlap_held : sound::overlap_held)) {
    return std::string(": contact cannot tell from which side they came, and lets such nodes pass: ") +
           (late ? "begin it before they meet, or keep them apart till then" : "move the bodies apart");
  }
  if (late) return ": contact keeps them as they are, without stress: begin it before they meet";
  return ": contact keeps them as they are, without stress: contact.overlap = \"adjust\" puts the nodes on the surface";
}

/// The deepest overlaps first; many of them are reported by their number. late: of contact that begins after the start.
void add_overlaps(const RunSummary& summary, bool late, std::vector<std::string>& found) {
  constexpr std::size_t most_reported = 5;
  std::vector<OverlapResult> overlaps = summary.overlaps;
  std::erase_if(overlaps,
                [late](const OverlapResult& overlap) { return overlap.rigid_wall || (overlap.time > 0) != late; });
  std::stable_sort(overlaps.begin(), overlaps.end(),
                   [](const OverlapResult& a, const OverlapResult& b) { return a.share > b.share; });
  for (std::size_t i = 0; i < std::min(overlaps.size(), most_reported); ++i) {
    found.push_back(overlap_text(overlaps[i]) + overlap_advice(summary, overlaps[i]));
  }
  if (overlaps.size() > most_reported) {
    found.push_back(fmt::format(
        "{} {}, less deep: contact.overlaps of summary.json has them all",
        counted(overlaps.size() - most_reported, "more pair of bodies overlaps", "more pairs of bodies overlap"),
        late ? "when contact begins" : "at the start"));
  }
}

/// Nodes behind rigid walls that begin later.
void add_passed_walls(const RunSummary& summary, std::vector<std::string>& found) {
  for (const OverlapResult& overlap : summary.overlaps) {
    if (!overlap.rigid_wall) continue;
    found.push_back(fmt::format(
        "rigid wall {} begins, at time {:.6g}, when {} of body {} {} behind it, the deepest, {}, by {:.4g} ({} of an "
        "element): it lets them go on; begin it before they pass, or keep them on its free side till then",
        overlap.second, overlap.time, counted(overlap.nodes, "node"), overlap.first,
        overlap.nodes == 1 ? "lies" : "lie", overlap.place, overlap.depth, percent(overlap.share)));
  }
}

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
  const InsideOutCount& corners = summary.inside_out;
  if (corners.most > 0) {
    found.push_back(fmt::format(
        "elements were inside out at a corner: {} at the end, up to {} at once, first {} at time {:.6g}: try a smaller "
        "time.cfl, a finer mesh there, or element.inside_out = \"erode\"",
        corners.elements, corners.most, corners.first_place, corners.first_time));
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
  add_overlaps(summary, true, found);
  add_passed_walls(summary, found);
  add_unconverged_contact(summary.iterations, found);
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
  found.insert(found.end(), summary.unlikely.begin(), summary.unlikely.end());
  add_overlaps(summary, false, found);
  if (!summary.unseen_balls.empty()) {
    found.push_back(
        fmt::format("{}: choose contact.enforcement = \"lagrange\" with contact.gap = \"face\", or meshes "
                    "of near-cubes of one size",
                    summary.unseen_balls));
  }
  if (!summary.unstable_hourglass.empty()) found.push_back(summary.unstable_hourglass);
  if (!summary.large_added_mass.empty()) found.push_back(summary.large_added_mass);
  for (const TiedResult& tied : summary.tied) {
    if (tied.nodes == 0) {
      found.push_back(fmt::format("contact.tied {}: try a larger tolerance, or other sides", tied_text(tied)));
    } else if (static_cast<double>(tied.open) > sound::open_tie * static_cast<double>(tied.nodes)) {
      found.push_back(fmt::format(
          "contact.tied {}, and {} of its second side {} on its first side with nothing that follows: name the side "
          "with the finer mesh as first",
          tied_text(tied), counted(tied.open, "node"), tied.open == 1 ? "lies" : "lie"));
    }
    if (tied.free > 0) {
      found.push_back(fmt::format(
          "contact.tied {}, and {} of these {} held in directions in which the faces that they follow may move, which "
          "decide: hold the nodes of the faces",
          tied_text(tied), tied.free, tied.free == 1 ? "is" : "are"));
    }
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

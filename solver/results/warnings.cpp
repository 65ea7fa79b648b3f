#include "warnings.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace pinball {

std::vector<std::string> warnings(const RunSummary& summary) {
  constexpr double sound_balance = 0.1, sound_penetration = 0.25;
  std::vector<std::string> found;
  if (summary.balance_error_max > sound_balance) {
    found.push_back(fmt::format("the energy balance was off by up to {:.3g} %: try a smaller time.cfl{}",
                                100 * summary.balance_error_max,
                                summary.contact_method == "none" ? "" : " or contact.beta"));
  }
  if (!summary.overlapping_bodies.empty()) {
    found.push_back(fmt::format("bodies {} overlap at the start: contact cannot tell from which side they came",
                                summary.overlapping_bodies));
  }
  // Erosion exposes pinballs that lie deep inside others, which is no fault of the contact.
  const bool eroded = std::any_of(summary.bodies.begin(), summary.bodies.end(),
                                  [](const BodyResult& body) { return body.eroded_elements > 0; });
  if (!eroded && summary.max_penetration_ratio > sound_penetration) {
    found.push_back(
        fmt::format("bodies went into each other by up to {:.3g} % of the radii of their pinballs: try a larger "
                    "contact.beta, finer meshes, or bodies that do not overlap at the start",
                    100 * summary.max_penetration_ratio));
  }
  constexpr double few_unsolved = 0.1;
  if (static_cast<double>(summary.sweeps.unsolved) > few_unsolved * static_cast<double>(summary.sweeps.solutions)) {
    found.push_back(fmt::format(
        "the impulses of contact were not solved for in {} of {} steps with contact, where {} sweeps were not enough: "
        "try a smaller time.cfl, or contact.enforcement = \"projection\"",
        summary.sweeps.unsolved, summary.sweeps.solutions, summary.sweeps.largest));
  }
  return found;
}

}  // namespace pinball

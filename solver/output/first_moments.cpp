#include "first_moments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "progress.hpp"

namespace pinball {

namespace {

constexpr double moments = 0.1, between_notes = 0.005;  // [s]
/// Runs that end before anybody has read the line need none.
constexpr double worth_saying = 2;  // [s]
/// Part of the elements that lie on the surface, of bodies that are neither thin nor large [-].
constexpr double usual_surface = 0.5;

}  // namespace

FirstMoments::FirstMoments(const Simulation& simulation, double impact_speed)
    : forecast_(simulation.scene(), impact_speed,
                simulation.scene().contact.method == ContactMethod::none ? 0.0 : usual_surface),
      said_(simulation.steps() > 0) {}

std::string FirstMoments::expected(const Simulation& simulation) {
  if (said_) return "";
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  if (noted_ > 0 && seconds - noted_ < between_notes) return "";
  noted_ = seconds;
  forecast_.take({simulation.time(), simulation.dt(), simulation.steps(), seconds, simulation.progress().pairs > 0});
  if (seconds < moments || simulation.at_end()) return "";
  said_ = true;
  const RunSummary summary = simulation.summary();
  const double at_once =
      static_cast<double>(summary.elements) * static_cast<double>(std::max<std::int64_t>(1, summary.steps));
  const ExpectedRun run = forecast_.expected(summary.element_steps_resting / at_once);
  if (run.seconds < worth_saying) return "";
  return fmt::format("expected: {:.2g} steps, {}", run.steps, readable_duration(run.seconds));
}

}  // namespace pinball

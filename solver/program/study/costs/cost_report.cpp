#include "cost_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include <solver/program/info/info_devices.hpp>
#include <solver/program/study/convergence_report.hpp>
#include <solver/program/text_table.hpp>

namespace pinball {

namespace {

constexpr double usual_error = 0.01;
constexpr std::size_t few = 4;           ///< quantities that have room in a table of runs
constexpr double least_reported = 1e-9;  ///< errors below say nothing

/// "; finer than 0.02 % is chance"; empty: the study can tell errors as small as numbers have digits.
std::string limit_text(const std::optional<KnownTo>& known) {
  if (!known || !(known->error > least_reported)) return "";
  const std::string error = percent_cell(known->error);
  return known->chance ? fmt::format("; finer than {} is chance", error)
                       : fmt::format("; what finer meshes say is known to {}", error);
}

std::string joined_names(const ConvergenceStudy& study) {
  std::vector<std::string> names;
  for (const StudyQuantity& quantity : study.quantities) names.push_back(named_with_unit(quantity));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The best point of the frontier, whose error is the least.
std::string best_text(const std::vector<CostPoint>& points, std::size_t quantity) {
  const auto best = frontier(points, quantity);
  return best.empty() ? "" : cost_text(points[best.back()], *points[best.back()].held[quantity]);
}

/// Why no settings reach the error in all quantities.
std::string not_reached(const ConvergenceStudy& study, double error) {
  for (const StudyQuantity& quantity : study.quantities) {
    const auto known = known_to(study, quantity);
    if (!known)
      return fmt::format("{} {}", quantity.name, quantity.convergence ? verdict_word(quantity) : "has no band");
    if (known->error > error && known->chance) {
      return fmt::format("chance alone moves {} by {}", quantity.name, percent_cell(known->error));
    }
    if (known->error > error) {
      return fmt::format("what finer meshes say of {} is known to {}", quantity.name, percent_cell(known->error));
    }
  }
  return "finer meshes do not fit into the time, or there are none";
}

bool is_left_out(const StudyRun* run) { return !run->left_out.empty(); }

std::string best_in_time(const ConvergenceStudy& study) {
  const auto finest = std::find_if(study.meshes.rbegin(), study.meshes.rend(),
                                   [](const StudyMesh& mesh) { return mesh.run.results.has_value(); });
  if (finest == study.meshes.rend()) return "";
  const auto runs = study.runs();
  const auto left_out = std::count_if(runs.begin(), runs.end(), is_left_out);
  std::string text = fmt::format("in {} the finest mesh is {} ({})", duration_cell(*study.limits.seconds),
                                 finest->factor.text(), finest->counts);
  if (left_out > 0) text += fmt::format("; {} run{} did not fit", left_out, left_out == 1 ? "" : "s");
  return text;
}

std::string run_lines(const ConvergenceStudy& study, const std::vector<CostPoint>& points) {
  std::vector<std::vector<std::string>> lines{{"run", "seconds", "memory"}};
  std::vector<Align> align{Align::left, Align::right, Align::right};
  for (const StudyQuantity& quantity : study.quantities) {
    lines.front().push_back("error of " + quantity.name);
    align.push_back(Align::right);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CostPoint& point = points[i];
    if (point.of_chance) continue;
    lines.push_back({point.settings, fmt::format("{:.3g}", point.seconds), readable_bytes(point.bytes)});
    for (std::size_t q = 0; q < study.quantities.size(); ++q) {
      const auto best = frontier(points, q);
      const bool on_it = std::find(best.begin(), best.end(), i) != best.end();
      lines.back().push_back(point.errors[q] ? percent_cell(*point.errors[q]) + (on_it ? " *" : "  ") : "-  ");
    }
  }
  return text_table(lines, align) + "* no other run is both faster and better\n";
}

}  // namespace

double error_of_report(const ConvergenceStudy& study) { return study.limits.error.value_or(usual_error); }

std::string cost_text(const CostPoint& point, double error) {
  return fmt::format("{}: {}, {}, errs by {}", point.settings, duration_cell(point.seconds),
                     readable_bytes(point.bytes), percent_cell(error));
}

std::string cost_sentence(const ConvergenceStudy& study, const std::vector<CostPoint>& points, std::size_t quantity) {
  const StudyQuantity& of = study.quantities[quantity];
  const auto known = known_to(study, of);
  if (!known) return "";
  const double error = error_of_report(study);
  const std::string name = fmt::format("{} of {}", percent_cell(error), named_with_unit(of));
  if (known->error > error) return fmt::format("{}: not known{}", name, limit_text(known));
  if (const auto found = cheapest(points, {quantity}, error)) {
    return fmt::format("for {} take {}{}", name, cost_text(points[*found], *points[*found].held[quantity]),
                       limit_text(known));
  }
  return fmt::format("{}: not reached; the best is {}{}", name, best_text(points, quantity), limit_text(known));
}

std::string search_sentence(const ConvergenceStudy& study) {
  if (study.quantities.empty()) return "";
  if (!study.limits.error) return study.limits.seconds ? best_in_time(study) : "";
  const double error = *study.limits.error;
  std::vector<std::size_t> all(study.quantities.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::string name = fmt::format("{} of {}", percent_cell(error), joined_names(study));
  const auto points = cost_points(study);
  const auto found = cheapest(points, all, error);
  const bool known = std::all_of(study.quantities.begin(), study.quantities.end(), [&](const StudyQuantity& quantity) {
    const auto to = known_to(study, quantity);
    return to && to->error <= error;
  });
  if (!found || !known) return fmt::format("{} is not reached: {}", name, not_reached(study, error));
  const CostPoint& point = points[*found];
  return fmt::format("for {} take {} ({})", name, cost_text(point, *worst_error(point, all)), point.what);
}

std::string costs_text(const ConvergenceStudy& study) {
  const std::vector<CostPoint> points = cost_points(study);
  std::string text;
  for (std::size_t q = 0; q < study.quantities.size(); ++q) {
    const std::string sentence = cost_sentence(study, points, q);
    if (!sentence.empty()) text += sentence + '\n';
  }
  if (text.empty()) return "";
  if (study.quantities.size() <= few) text = run_lines(study, points) + '\n' + text;
  return '\n' + text;
}

}  // namespace pinball

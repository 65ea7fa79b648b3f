#include "sources_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <solver/program/text_table.hpp>
#include <solver/scene/schema/choices.hpp>

#include "convergence_report.hpp"

namespace pinball {

namespace {

constexpr double least_moved = 1e-6;  ///< of the scale of a quantity: what moves it less is not named

std::optional<std::size_t> place_of_chance(const ConvergenceStudy& study) {
  for (std::size_t s = 0; s < study.sources.size(); ++s) {
    if (study.sources[s].source == ErrorSource::chance) return s;
  }
  return std::nullopt;
}

/// What the columns are, and which runs failed.
std::string source_notes(const ConvergenceStudy& study) {
  std::string text;
  for (const StudySource& source : study.sources) {
    text += fmt::format("  {}: {}{}\n", source.name, source.what,
                        source.source == ErrorSource::chance ? "; their standard deviation" : "");
    for (const StudyRun& run : source.runs) {
      if (!run.failure.empty()) text += fmt::format("  {} failed: {}\n", source.name, run.failure);
      if (!run.left_out.empty()) text += fmt::format("  {} left out: {}\n", source.name, run.left_out);
    }
  }
  return text;
}

std::string body_notes(const ConvergenceStudy& study) {
  std::string text;
  for (const StudyQuantity& quantity : study.quantities) {
    const std::string refine = body_to_refine(study, quantity);
    if (!refine.empty()) text += fmt::format("{}: {}\n", quantity.name, refine);
  }
  return text;
}

std::string chance_notes(const ConvergenceStudy& study) {
  std::string text;
  for (const StudyQuantity& quantity : study.quantities) {
    if (!chance_rules(study, quantity)) continue;
    text +=
        fmt::format("{}: chance decides, {:.6g} +- {:.3g}, more than the error of the mesh: no finer mesh says more\n",
                    quantity.name, *quantity.mean_of_chance, *quantity.moved[*place_of_chance(study)]);
  }
  return text;
}

}  // namespace

std::optional<double> error_of_mesh(const ConvergenceStudy& study, const StudyQuantity& quantity) {
  const auto& value = quantity.values[study.sources_mesh];
  if (!value || !quantity.convergence) return std::nullopt;
  const GridConvergence& c = *quantity.convergence;
  if (!c.has_band()) return c.high - c.low;
  return std::max(std::abs(*value - c.low), std::abs(*value - c.high));
}

std::optional<double> error_together(const ConvergenceStudy& study, const StudyQuantity& quantity) {
  const auto of_mesh = error_of_mesh(study, quantity);
  if (!of_mesh || !quantity.convergence->has_band()) return std::nullopt;
  std::map<ErrorSource, double> largest;
  for (std::size_t s = 0; s < study.sources.size(); ++s) {
    const StudySource& source = study.sources[s];
    const bool is_worse = source.source == ErrorSource::precision && source.name != schema::name_of(Precision::float64);
    if (!quantity.moved[s] || source.source == ErrorSource::body || is_worse) continue;
    const double deviations = source.source == ErrorSource::chance ? 2 : 1;
    largest[source.source] = std::max(largest[source.source], deviations * std::abs(*quantity.moved[s]));
  }
  double sum = *of_mesh;
  for (const auto& [source, size] : largest) sum += size;
  return sum;
}

std::string largest_source(const ConvergenceStudy& study, const StudyQuantity& quantity) {
  std::string name;
  double largest = least_moved * quantity.scale;
  const auto look = [&](const std::string& source, const std::optional<double>& size) {
    if (!size || !(std::abs(*size) > largest)) return;
    largest = std::abs(*size);
    name = source;
  };
  look("mesh", error_of_mesh(study, quantity));
  for (std::size_t s = 0; s < study.sources.size(); ++s) {
    if (study.sources[s].source != ErrorSource::body)
      look(study.sources[s].name, quantity.moved[s]);  // part of the mesh
  }
  return name;
}

std::string body_to_refine(const ConvergenceStudy& study, const StudyQuantity& quantity) {
  std::vector<std::pair<double, std::string>> moved;
  for (std::size_t s = 0; s < study.sources.size(); ++s) {
    if (study.sources[s].source != ErrorSource::body || !quantity.moved[s]) continue;
    const std::string& name = study.sources[s].name;
    moved.emplace_back(std::abs(*quantity.moved[s]), name.substr(0, name.find(' ')));
  }
  std::sort(moved.rbegin(), moved.rend());
  if (moved.size() < 2 || !(moved.front().first > least_moved * quantity.scale)) return "";
  std::vector<std::string> more, less;
  for (const auto& [size, body] : moved) (2 * size >= moved.front().first ? more : less).push_back(body);
  const std::string refine = fmt::format("refine {}", fmt::join(more, " and "));
  return less.empty() ? refine : fmt::format("{}, not {}", refine, fmt::join(less, " or "));
}

bool chance_rules(const ConvergenceStudy& study, const StudyQuantity& quantity) {
  const auto chance = place_of_chance(study);
  const auto of_mesh = error_of_mesh(study, quantity);
  if (!chance || !of_mesh || !quantity.moved[*chance]) return false;
  return *quantity.moved[*chance] > std::max(*of_mesh, least_moved * quantity.scale);
}

std::string sources_sentence(const ConvergenceStudy& study) {
  if (study.sources.empty()) return "";
  std::map<std::string, int> counts;
  for (const StudyQuantity& quantity : study.quantities) {
    const std::string source = largest_source(study, quantity);
    if (!source.empty()) ++counts[source];
  }
  std::vector<std::pair<std::string, int>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<std::string> parts;
  for (const auto& [source, count] : sorted) parts.push_back(fmt::format("{} for {}", source, count));
  return parts.empty() ? "" : fmt::format("the largest source of error is: {}", fmt::join(parts, ", "));
}

std::string sources_text(const ConvergenceStudy& study) {
  if (study.sources.empty()) return "";
  std::vector<std::vector<std::string>> lines{{"what moves it", "mesh"}};
  std::vector<Align> align{Align::left, Align::right};
  for (const StudySource& source : study.sources) {
    lines.front().push_back(source.name);
    align.push_back(Align::right);
  }
  lines.front().emplace_back("together");
  align.push_back(Align::right);
  lines.front().emplace_back("largest");
  align.push_back(Align::left);
  for (const StudyQuantity& quantity : study.quantities) {
    lines.push_back({named_with_unit(quantity), number_cell(error_of_mesh(study, quantity), "{:.3g}")});
    for (const auto& moved : quantity.moved) lines.back().push_back(number_cell(moved, "{:.3g}"));
    lines.back().push_back(number_cell(error_together(study, quantity), "{:.3g}"));
    lines.back().push_back(largest_source(study, quantity));
  }
  return fmt::format("on mesh {}:\n{}{}{}", study.meshes[study.sources_mesh].factor.text(), text_table(lines, align),
                     source_notes(study), body_notes(study) + chance_notes(study));
}

}  // namespace pinball

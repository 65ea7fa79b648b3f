#include "convergence_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include <solver/program/text_table.hpp>

#include "costs/cost_report.hpp"
#include "sources_report.hpp"

namespace pinball {

namespace {

std::string order_cell(const GridConvergence& convergence) {
  if (!convergence.observed_order) return "-";
  if (!(*convergence.observed_order < 10)) return "> 10";
  return fmt::format("{:.2f}", *convergence.observed_order);
}

/// A spread is no band, and in brackets.
std::string band_cell(const GridConvergence& convergence) {
  const std::string range = fmt::format("{:.6g} .. {:.6g}", convergence.low, convergence.high);
  return convergence.has_band() ? range : '(' + range + ')';
}

std::string percent_of(double error, const StudyQuantity& quantity) {
  const double value = std::abs(quantity.convergence->extrapolated);
  if (!(value > small_value * quantity.scale)) return "";
  return percent_cell(error / value);
}

std::string error_cell(const ConvergenceStudy& study, const StudyQuantity& quantity) {
  const auto error = own_error(study, quantity);
  if (!error) return "-";
  const std::string percent = percent_of(*error, quantity);
  return fmt::format("{:.3g}{}", *error, percent.empty() ? "" : " (" + percent + ")");
}

/// The quantity whose error is the largest part of its scale.
const StudyQuantity* worst_quantity(const ConvergenceStudy& study) {
  const StudyQuantity* worst = nullptr;
  double largest = 1e-9;  // below is round-off
  for (const StudyQuantity& quantity : study.quantities) {
    const auto error = own_error(study, quantity);
    if (!error || !(quantity.scale > 0) || std::abs(*error) / quantity.scale <= largest) continue;
    largest = std::abs(*error) / quantity.scale;
    worst = &quantity;
  }
  return worst;
}

std::string count_of(std::ptrdiff_t count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

/// "3 of 4 quantities converge, 1 oscillates".
std::string counted_verdicts(const ConvergenceStudy& study) {
  const auto count = [&study](Convergence verdict) {
    return std::count_if(study.quantities.begin(), study.quantities.end(), [verdict](const StudyQuantity& quantity) {
      return quantity.convergence && quantity.convergence->verdict == verdict;
    });
  };
  const std::string all = count_of(std::ssize(study.quantities), "quantity", "quantities");
  std::string text = fmt::format("of {} {}", all, count_of(count(Convergence::monotone), "converges", "converge"));
  if (const auto n = count(Convergence::constant); n > 0) text += ", " + count_of(n, "is constant", "are constant");
  if (const auto n = count(Convergence::oscillating); n > 0) text += ", " + count_of(n, "oscillates", "oscillate");
  if (const auto n = count(Convergence::diverging); n > 0) text += ", " + count_of(n, "diverges", "diverge");
  return text;
}

std::string seconds_cell(const StudyRun& run) {
  if (!run.results) return run.left_out.empty() ? "failed" : "left out";
  return fmt::format("{:.3g}", run.results->value("wall_seconds").value_or(0));
}

std::string mesh_lines(const ConvergenceStudy& study) {
  std::vector<std::vector<std::string>> lines{{"mesh", "elements", "steps", "seconds", "of them"}};
  for (const StudyMesh& mesh : study.meshes) {
    lines.push_back({mesh.factor.text()});
    for (const char* key : {"elements", "steps"}) {
      lines.back().push_back(mesh.run.results ? fmt::format("{}", mesh.run.results->value(key).value_or(0)) : "-");
    }
    lines.back().push_back(seconds_cell(mesh.run));
    lines.back().push_back(mesh.counts);
  }
  return text_table(lines, {Align::right, Align::right, Align::right, Align::right, Align::left});
}

std::string quantity_lines(const ConvergenceStudy& study) {
  std::vector<std::string> head{"quantity"};
  std::vector<Align> align{Align::left};
  const auto add_column = [&](const std::string& title, Align side) {
    head.push_back(title);
    align.push_back(side);
  };
  for (const StudyMesh& mesh : study.meshes) add_column("mesh " + mesh.factor.text(), Align::right);
  for (const char* title : {"order", "extrapolated", "band (or spread)"}) add_column(title, Align::right);
  if (study.own_mesh()) add_column("error of mesh 1", Align::right);
  add_column("verdict", Align::left);
  std::vector<std::vector<std::string>> lines{head};
  for (const StudyQuantity& quantity : study.quantities) {
    lines.push_back({named_with_unit(quantity)});
    std::vector<std::string>& line = lines.back();
    for (const auto& value : quantity.values) line.push_back(number_cell(value, "{:.6g}"));
    const auto& c = quantity.convergence;
    line.push_back(c ? order_cell(*c) : "-");
    line.push_back(c && c->has_band() ? number_cell(c->extrapolated, "{:.6g}") : "-");
    line.push_back(c ? band_cell(*c) : "-");
    if (study.own_mesh()) line.push_back(error_cell(study, quantity));
    line.push_back(verdict_word(quantity));
  }
  return text_table(lines, align);
}

}  // namespace

std::string verdict_word(const StudyQuantity& quantity) {
  if (!quantity.convergence) return "";
  switch (quantity.convergence->verdict) {
    case Convergence::constant:
      return "constant";
    case Convergence::monotone:
      return quantity.convergence->order_is_bounded() ? "converges, not in order yet" : "converges";
    case Convergence::oscillating:
      return "oscillates";
    case Convergence::diverging:
      return "diverges";
  }
  return "";
}

std::string named_with_unit(const StudyQuantity& quantity) {
  return quantity.unit.empty() ? quantity.name : fmt::format("{} [{}]", quantity.name, quantity.unit);
}

std::optional<double> own_error(const ConvergenceStudy& study, const StudyQuantity& quantity) {
  const auto own = study.own_mesh();
  if (!own || !quantity.convergence || !quantity.convergence->has_band() || !quantity.values[*own]) return std::nullopt;
  if (quantity.convergence->verdict == Convergence::constant) return 0;
  return *quantity.values[*own] - quantity.convergence->extrapolated;
}

std::string convergence_sentence(const ConvergenceStudy& study) {
  if (study.quantities.empty()) {
    const bool any = std::any_of(study.meshes.begin(), study.meshes.end(),
                                 [](const StudyMesh& mesh) { return mesh.run.results.has_value(); });
    return any ? "energies, velocities, forces and probes are all zero; --of names other quantities"
               : "no run came to its end, nothing can be said of its error";
  }
  std::string text = counted_verdicts(study);
  if (const std::string sources = sources_sentence(study); !sources.empty()) text += "; " + sources;
  const StudyQuantity* worst = worst_quantity(study);
  if (worst == nullptr) return text;
  const std::string percent = percent_of(*own_error(study, *worst), *worst);
  const auto& c = *worst->convergence;
  return text +
         fmt::format("; the scene's own mesh errs most in {}: {:.6g}, which with finer meshes is {:.6g} .. {:.6g}{}",
                     named_with_unit(*worst), *worst->values[*study.own_mesh()], c.low, c.high,
                     percent.empty() ? "" : ", off by " + percent);
}

std::string convergence_text(const ConvergenceStudy& study) {
  std::string text = fmt::format("{}: {}\n", study.scene, convergence_sentence(study));
  if (const std::string found = search_sentence(study); !found.empty()) text += found + '\n';
  text += '\n' + mesh_lines(study);
  for (const StudyMesh& mesh : study.meshes) {
    const std::string name = mesh.factor.text();
    if (!mesh.run.failure.empty()) text += fmt::format("mesh {} failed: {}\n", name, mesh.run.failure);
    if (!mesh.run.left_out.empty()) text += fmt::format("mesh {} left out: {}\n", name, mesh.run.left_out);
  }
  if (!study.quantities.empty()) text += '\n' + quantity_lines(study);
  if (!study.sources.empty() && !study.quantities.empty()) text += '\n' + sources_text(study);
  return text + costs_text(study);
}

}  // namespace pinball

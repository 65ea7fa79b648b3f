#include <fmt/format.h>

#include "convergence_report.hpp"
#include "costs/error_costs.hpp"

namespace pinball {

namespace {

/// As readers of tables take it: in quotes where it has a comma or quotes in it.
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string csv_number(const std::optional<double>& value) { return value ? fmt::format("{:.17g}", *value) : ""; }

/// What all runs say of a quantity: extrapolated,low,high,verdict.
std::string csv_verdict(const StudyQuantity& quantity) {
  const auto& c = quantity.convergence;
  if (!c) return ",,,";
  const auto extrapolated = c->has_band() ? std::optional(c->extrapolated) : std::nullopt;
  return fmt::format("{},{},{},{}", csv_number(extrapolated), csv_number(c->low), csv_number(c->high),
                     csv_cell(verdict_word(quantity)));
}

}  // namespace

std::string convergence_csv(const ConvergenceStudy& study) {
  std::string text = "quantity,unit,run,mesh,elements,seconds,bytes,value,error,extrapolated,low,high,verdict\n";
  const std::vector<CostPoint> points = cost_points(study);
  for (std::size_t q = 0; q < study.quantities.size(); ++q) {
    const StudyQuantity& quantity = study.quantities[q];
    for (const CostPoint& point : points) {
      text +=
          fmt::format("{},{},{},{},{:.0f},{:.9g},{:.0f},{},{},{}\n", csv_cell(quantity.name), csv_cell(quantity.unit),
                      csv_cell(point.settings), point.factor.text(), point.elements, point.seconds, point.bytes,
                      csv_number(point.values[q]), csv_number(point.errors[q]), csv_verdict(quantity));
    }
  }
  return text;
}

}  // namespace pinball

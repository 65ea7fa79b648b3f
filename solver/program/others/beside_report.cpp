#include "beside_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include <solver/program/text_table.hpp>

#include "curve_difference.hpp"

namespace pinball {

namespace {

using OrderedJson = nlohmann::ordered_json;

double mass_of(const VariantRuns& variant) {
  double mass = 0;
  for (const BodyResult& body : variant.repeats.front().bodies) mass += body.mass_initial;
  return mass;
}

std::vector<CurveDifference> differences(const VariantRuns& variant, const OtherHistory& other) {
  return curve_differences(variant.curves, other, mass_of(variant));
}

std::string share_cell(const std::optional<double>& share) {
  return share ? fmt::format("{:.3g} %", 100 * *share) : "-";
}

OrderedJson optional_json(const std::optional<double>& value) {
  return value ? OrderedJson(*value) : OrderedJson(nullptr);
}

/// Numbers with seven digits, null for what is none.
std::string numbers_json(const std::vector<double>& values) {
  std::string text = "[";
  for (const double value : values) {
    if (text.size() > 1) text += ',';
    text += std::isfinite(value) ? fmt::format("{:.7g}", value) : "null";
  }
  return text + ']';
}

}  // namespace

std::string beside_table(const std::vector<VariantRuns>& runs, const std::vector<OtherHistory>& others) {
  std::string words;
  for (const OtherHistory& other : others) {
    std::vector<std::vector<std::string>> lines{
        {"quantity", "here", "at time", "here", "there", "difference", "largest", "at time", "root mean square"}};
    if (runs.size() > 1) lines.front().insert(lines.front().begin() + 1, "variant");
    for (const VariantRuns& variant : runs) {
      for (const CurveDifference& d : differences(variant, other)) {
        lines.push_back({d.name, d.columns, fmt::format("{:.6g}", d.end_time), fmt::format("{:.6g}", d.here),
                         fmt::format("{:.6g}", d.there), share_cell(d.at_end), share_cell(d.largest),
                         fmt::format("{:.4g}", d.largest_time), share_cell(d.root_mean_square)});
        if (runs.size() > 1) lines.back().insert(lines.back().begin() + 1, name_of(variant.settings));
      }
    }
    std::vector<Align> align(lines.front().size(), Align::right);
    std::fill(align.begin(), align.begin() + (runs.size() > 1 ? 3 : 2), Align::left);
    words += fmt::format("\nbeside {} ({}, {} times from {:.6g} to {:.6g}); differences over the largest size there\n",
                         other.path, other.kind, other.times.size(), other.times.front(), other.times.back());
    words += lines.size() > 1 ? text_table(lines, align) : "no quantity that this run has at the same times\n";
    const std::vector<std::string> left_out = without_meaning(runs.front().curves, other);
    if (!left_out.empty()) words += fmt::format("not compared: {}\n", fmt::join(left_out, ", "));
  }
  return words;
}

OrderedJson beside_json(const std::vector<VariantRuns>& runs, const std::vector<OtherHistory>& others) {
  OrderedJson all = OrderedJson::array();
  for (const OtherHistory& other : others) {
    OrderedJson quantities = OrderedJson::array();
    for (const OtherCurve& curve : other.curves) {
      OrderedJson variants = OrderedJson::array();
      std::string columns;
      for (const VariantRuns& variant : runs) {
        OrderedJson row = nullptr;
        for (const CurveDifference& d : differences(variant, other)) {
          if (d.name != curve.name) continue;
          columns = d.columns;
          row = {{"time", d.end_time},
                 {"here", d.here},
                 {"there", d.there},
                 {"difference", optional_json(d.at_end)},
                 {"largest_difference", optional_json(d.largest)},
                 {"largest_time", d.largest_time},
                 {"root_mean_square", optional_json(d.root_mean_square)}};
        }
        variants.push_back(row);
      }
      if (!columns.empty()) {
        quantities.push_back({{"name", curve.name}, {"columns", columns}, {"variants", variants}});
      }
    }
    all.push_back({{"file", other.path},
                   {"kind", other.kind},
                   {"times", other.times.size()},
                   {"first_time", other.times.front()},
                   {"last_time", other.times.back()},
                   {"quantities", quantities},
                   {"not_compared", without_meaning(runs.front().curves, other)}});
  }
  return all;
}

std::string beside_curves_json(const std::vector<VariantRuns>& runs, const std::vector<OtherHistory>& others) {
  std::string all;
  for (const OtherHistory& other : others) {
    std::string curves;
    for (const OtherCurve& curve : other.curves) {
      std::string variants;
      for (const VariantRuns& variant : runs) {
        const std::vector<double> values = values_of(variant.curves, curve.meaning, mass_of(variant));
        if (!values.empty()) variants += (variants.empty() ? "" : ",") + numbers_json(values);
      }
      if (variants.empty()) continue;
      curves += fmt::format("{}{{\"name\":{},\"values\":{},\"variants\":[{}]}}", curves.empty() ? "" : ",",
                            OrderedJson(curve.name).dump(-1, ' ', false, OrderedJson::error_handler_t::replace),
                            numbers_json(curve.values), variants);
    }
    const std::string file = std::filesystem::path(other.path).filename().string();
    all += fmt::format("{}{{\"file\":{},\"times\":{},\"curves\":[{}]}}", all.empty() ? "" : ",",
                       OrderedJson(file).dump(-1, ' ', false, OrderedJson::error_handler_t::replace),
                       numbers_json(other.times), curves);
  }
  return '[' + all + ']';
}

}  // namespace pinball

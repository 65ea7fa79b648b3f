#include "beside_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <span>

#include <solver/program/momentum_error.hpp>
#include <solver/program/text_table.hpp>

#include "curve_difference.hpp"
#include "last_state.hpp"

namespace pinball {

namespace {

using OrderedJson = nlohmann::ordered_json;

std::vector<CurveDifference> differences(const VariantRuns& variant, const OtherHistory& other) {
  return curve_differences(variant.curves, other, initial_mass(variant.repeats.front()));
}

std::string share_cell(const std::optional<double>& share) {
  return share ? fmt::format("{:.3g} %", 100 * *share) : "-";
}

OrderedJson optional_json(const std::optional<double>& value) {
  return value ? OrderedJson(*value) : OrderedJson(nullptr);
}

/// What means nothing here, and what has no number at a time that a run has, too. Nodes that are compared as they are
/// at the end count as compared.
std::vector<std::string> not_compared(const std::vector<VariantRuns>& runs, const OtherHistory& other) {
  std::vector<std::string> names = without_meaning(runs.front().curves, other);
  std::set<std::string> known(names.begin(), names.end());
  for (const VariantRuns& variant : runs) {
    for (const CurveDifference& d : differences(variant, other)) known.insert(d.name);
  }
  for (const OtherCurve& curve : other.curves) {
    if (!known.contains(curve.name)) names.push_back(curve.name);
  }
  const std::vector<StateDifference> states = state_differences(runs.front().last, other);
  std::erase_if(names, [&](const std::string& name) {
    const auto of = numbered_quantity(name);
    return of && !of->of_element &&
           std::ranges::any_of(states, [&](const StateDifference& d) { return of->quantity.starts_with(d.quantity); });
  });
  return names;
}

/// As many as one reads; of what is more the number.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 20;
  const std::span<const std::string> first(names.data(), std::min(most, names.size()));
  const std::size_t more = names.size() - first.size();
  return fmt::format("{}{}", fmt::join(first, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

bool has_nodes(const OtherHistory& other) {
  return std::ranges::any_of(other.curves, [](const OtherCurve& curve) {
    const auto of = numbered_quantity(curve.name);
    return of && !of->of_element;
  });
}

/// Of nodes by number at the end of the runs; empty: the other program has none.
std::string state_table(const std::vector<VariantRuns>& runs, const OtherHistory& other) {
  if (!has_nodes(other)) return "";
  std::vector<std::vector<std::string>> lines{
      {"last state", "at time", "nodes", "longest there", "largest difference", "at node", "root mean square"}};
  if (runs.size() > 1) lines.front().insert(lines.front().begin() + 1, "variant");
  for (const VariantRuns& variant : runs) {
    for (const StateDifference& d : state_differences(variant.last, other)) {
      lines.push_back({d.quantity, fmt::format("{:.6g}", variant.last.time), fmt::format("{}", d.nodes),
                       fmt::format("{:.6g}", d.scale), share_cell(d.largest), fmt::format("{}", d.largest_node),
                       share_cell(d.root_mean_square)});
      if (runs.size() > 1) lines.back().insert(lines.back().begin() + 1, pinball::name_of(variant.settings));
    }
  }
  if (lines.size() == 1) {
    return fmt::format("no last state beside it: expected its nodes at time {:.6g}, at which this run ends\n",
                       runs.front().last.time);
  }
  std::vector<Align> align(lines.front().size(), Align::right);
  std::fill(align.begin(), align.begin() + (runs.size() > 1 ? 2 : 1), Align::left);
  return text_table(lines, align);
}

OrderedJson states_json(const std::vector<VariantRuns>& runs, const OtherHistory& other) {
  OrderedJson all = OrderedJson::array();
  for (const VariantRuns& variant : runs) {
    OrderedJson state = {{"time", variant.last.time}};
    for (const StateDifference& d : state_differences(variant.last, other)) {
      state[d.quantity] = {{"nodes", d.nodes},
                           {"longest", d.scale},
                           {"largest_difference", optional_json(d.largest)},
                           {"largest_node", d.largest_node},
                           {"root_mean_square", optional_json(d.root_mean_square)}};
    }
    all.push_back(state);
  }
  return all;
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
    const std::vector<std::string> left_out = not_compared(runs, other);
    words += state_table(runs, other);
    if (!left_out.empty()) words += fmt::format("not compared: {}\n", listed(left_out));
  }
  return words;
}

OrderedJson beside_json(const std::vector<VariantRuns>& runs, const std::vector<OtherHistory>& others) {
  OrderedJson all = OrderedJson::array();
  for (const OtherHistory& other : others) {
    std::map<std::string, OrderedJson> found;  // by the names of curves
    for (std::size_t v = 0; v < runs.size(); ++v) {
      for (const CurveDifference& d : differences(runs[v], other)) {
        OrderedJson& quantity = found[d.name];
        if (quantity.is_null())
          quantity = {{"name", d.name}, {"columns", d.columns}, {"variants", OrderedJson(runs.size(), nullptr)}};
        quantity["variants"][v] = {{"time", d.end_time},
                                   {"here", d.here},
                                   {"there", d.there},
                                   {"difference", optional_json(d.at_end)},
                                   {"largest_difference", optional_json(d.largest)},
                                   {"largest_time", d.largest_time},
                                   {"root_mean_square", optional_json(d.root_mean_square)}};
      }
    }
    OrderedJson quantities = OrderedJson::array();
    for (const OtherCurve& curve : other.curves) {
      if (found.contains(curve.name)) quantities.push_back(found[curve.name]);
    }
    all.push_back({{"file", other.path},
                   {"kind", other.kind},
                   {"times", other.times.size()},
                   {"first_time", other.times.front()},
                   {"last_time", other.times.back()},
                   {"quantities", quantities},
                   {"last_state", states_json(runs, other)},
                   {"not_compared", not_compared(runs, other)}});
  }
  return all;
}

std::string beside_curves_json(const std::vector<VariantRuns>& runs, const std::vector<OtherHistory>& others) {
  std::string all;
  for (const OtherHistory& other : others) {
    std::vector<const OtherCurve*> shown;
    for (const OtherCurve& curve : other.curves) {
      if (has_columns(runs.front().curves, curve.meaning)) shown.push_back(&curve);
    }
    Curves there{{"time"}, {}, other.times.size()};
    for (const OtherCurve* curve : shown) there.columns.push_back(curve->name);
    for (std::size_t i = 0; i < other.times.size(); ++i) {
      std::vector<double>& row = there.rows.emplace_back(1, other.times[i]);
      for (const OtherCurve* curve : shown) row.push_back(curve->values[i]);
    }
    thin(there, most_rows_of_page);
    std::string here;
    for (const VariantRuns& variant : runs) {
      Curves curves{{}, std::vector<std::vector<double>>(variant.curves.rows.size()), variant.curves.rows.size()};
      for (const OtherCurve* curve : shown) {
        curves.columns.push_back(curve->name);
        const std::vector<double> values =
            values_of(variant.curves, curve->meaning, initial_mass(variant.repeats.front()));
        for (std::size_t row = 0; row < values.size(); ++row) curves.rows[row].push_back(values[row]);
      }
      here += (here.empty() ? "" : ",") + curves_json(curves);
    }
    const std::string file = std::filesystem::path(other.path).filename().string();
    all += fmt::format("{}{{\"file\":{},\"there\":{},\"here\":[{}]}}", all.empty() ? "" : ",",
                       OrderedJson(file).dump(-1, ' ', false, OrderedJson::error_handler_t::replace),
                       curves_json(there), here);
  }
  return '[' + all + ']';
}

}  // namespace pinball

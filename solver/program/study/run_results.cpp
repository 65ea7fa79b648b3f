#include "run_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include <solver/base/error.hpp>
#include <solver/output/history.hpp>
#include <solver/output/run_files.hpp>
#include <solver/scene_rules.hpp>
#include <solver/summary.hpp>

namespace pinball {

namespace {

using Json = nlohmann::json;

constexpr std::string_view curve_ending = ":curve";
constexpr double small_part = 1e-3;  ///< of the scale of a column: what a curve that is smaller is measured by

/// "length(tail,rim)" as {"tail", "rim"}.
std::optional<std::pair<std::string, std::string>> probes_of_length(const std::string& name) {
  const std::string begin = "length(";
  const std::size_t comma = name.find(',');
  if (!name.starts_with(begin) || !name.ends_with(')') || comma == std::string::npos) return std::nullopt;
  return std::pair(name.substr(begin.size(), comma - begin.size()), name.substr(comma + 1, name.size() - comma - 2));
}

/// The number of each leaf by its path.
void add_numbers(const Json& json, const std::string& path, std::map<std::string, double>& numbers) {
  if (json.is_number()) numbers[path] = json.get<double>();
  const auto below = [&path](const std::string& key) { return path.empty() ? key : path + '.' + key; };
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) add_numbers(value, below(key), numbers);
  }
  if (!json.is_array()) return;
  const bool vector = json.size() == 3 && json.front().is_number();
  for (std::size_t i = 0; i < json.size(); ++i) {
    const bool named = json[i].is_object() && json[i].contains("name") && json[i]["name"].is_string();
    const std::string key = vector ? std::string(1, "xyz"[i]) : fmt::format("{}", i);
    add_numbers(json[i], below(named ? json[i]["name"].get<std::string>() : key), numbers);
  }
}

/// What a run has no number for yet it may have one for later.
void replace_nulls(Json& json) {
  if (json.is_null()) json = 0;
  if (!json.is_structured()) return;
  for (Json& part : json) replace_nulls(part);
}

void read_summary_file(const std::string& path, RunResults& results) {
  std::ifstream file(path);
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object()) throw RunError(path + ": expected the summary of a run");
  results.status = json.value("status", "");
  for (const Json& warning : json.value("warnings", Json::array())) results.warnings.push_back(warning);
  add_numbers(json, "", results.numbers);
}

void read_history_file(const std::string& path, RunResults& results) {
  std::ifstream file(path);
  std::string line, cell;
  if (!std::getline(file, line)) throw RunError(path + ": expected the history of a run");
  for (std::istringstream head(line); std::getline(head, cell, ',');) {
    results.columns.push_back(cell);
    results.rows[cell];
  }
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    for (const std::string& column : results.columns) {
      if (!std::getline(cells, cell, ',')) throw RunError(path + ": a row is cut off");
      results.rows[column].push_back(std::strtod(cell.c_str(), nullptr));
    }
  }
}

double integral_of(const std::vector<double>& times, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t i = 1; i < values.size(); ++i) sum += 0.5 * (values[i] + values[i - 1]) * (times[i] - times[i - 1]);
  return sum;
}

double largest_size(const std::vector<double>& values) {
  double largest = 0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  return largest;
}

/// "bar_velocity_z" as {"bar_velocity", true}.
std::pair<std::string, bool> without_axis(const std::string& column) {
  for (const std::string_view axes : {"_x", "_y", "_z", "_xx", "_yy", "_zz", "_xy", "_yz", "_zx"}) {
    if (column.ends_with(axes)) return {column.substr(0, column.size() - axes.size()), true};
  }
  return {column, false};
}

/// Of a value, and of its integral over time.
struct QuantityUnit {
  std::string of_value, of_integral;
};

QuantityUnit unit_of_length(const Units& units) { return {units.length, units.length + " " + units.time}; }

/// By the last word of a name, of columns and of paths in the summary; the first that fits.
QuantityUnit unit_of_word(std::string_view name, const Units& units) {
  const auto product = [](const std::string& a, const std::string& b) { return a + ' ' + b; };
  const auto by_time = [&](const std::string& unit) { return QuantityUnit{unit, product(unit, units.time)}; };
  const QuantityUnit length = unit_of_length(units), velocity{units.velocity, units.length};
  const QuantityUnit force{units.force, units.momentum}, momentum = by_time(units.momentum);
  const QuantityUnit mass = by_time(units.mass), time = by_time(units.time);
  const std::pair<std::string_view, QuantityUnit> known[]{
      {"angular_velocity", {"1/" + units.time, ""}},
      {"angular_momentum", by_time(product(units.momentum, units.length))},
      {"velocity", velocity},
      {"residual_max", velocity},
      {"displacement", length},
      {"position", length},
      {"centre", length},
      {"point", length},
      {"place", length},
      {"depth", length},
      {"stress", by_time(units.stress)},
      {"force", force},
      {"force_max", force},
      {"moment", {product(units.force, units.length), product(units.momentum, units.length)}},
      {"impulse", momentum},
      {"momentum", momentum},
      {"momentum.initial", momentum},
      {"momentum.final", momentum},
      {"mass", mass},
      {"mass_remaining", mass},
      {"mass_initial", mass},
      {"mass_added", mass},
      {"mass_scaling.added", mass},
      {"point_mass", mass},
      {"inertia", by_time(product(units.mass, units.length + "^2"))},
      {"time", time},
      {"dt", time},
      {"dt.min", time},
      {"dt.max", time},
      {"work", by_time(units.energy)}};
  for (const auto& [ending, unit] : known) {
    if (!name.ends_with(ending)) continue;
    const std::string_view before = name.substr(0, name.size() - ending.size());
    if (before.empty() || before.ends_with('_') || before.ends_with('.')) return unit;
  }
  return {};
}

bool names_energy_of_body(std::string_view name) {
  return std::ranges::any_of(std::array{"_kinetic", "_internal", "_hourglass", "_bulk_viscosity"},
                             [name](const char* energy) { return name.ends_with(energy); });
}

/// Of an energy as a number of the summary, not a share of it.
bool is_energy_number(const std::string& path) {
  return path.starts_with("energy.") && !path.ends_with("_share") && path.find("balance_error") == std::string::npos;
}

}  // namespace

RunResults read_run_results(const std::string& folder) {
  RunResults results;
  read_summary_file(in_folder(folder, summary_name), results);
  read_history_file(in_folder(folder, history_name), results);
  return results;
}

RunResults results_to_come(const Simulation& simulation) {
  RunResults results;
  results.columns = history_column_names(names_of(simulation.scene().bodies), simulation.history_columns());
  for (const std::string& column : results.columns) results.rows[column] = {0};
  Json json = Json::parse(summary_json(simulation.summary()));
  replace_nulls(json);
  add_numbers(json, "", results.numbers);
  return results;
}

bool is_curve(const std::string& quantity) { return quantity.ends_with(curve_ending); }

std::optional<std::vector<double>> RunResults::column(const std::string& name) const {
  const auto found = rows.find(name);
  if (found != rows.end()) return found->second.empty() ? std::nullopt : std::optional(found->second);
  const auto probes = probes_of_length(name);
  if (!probes) return std::nullopt;
  std::vector<double> lengths(rows.count("time") ? rows.at("time").size() : 0, 0.0);
  for (const char* axis : {"_position_x", "_position_y", "_position_z"}) {
    const auto a = rows.find(probes->first + axis), b = rows.find(probes->second + axis);
    if (a == rows.end() || b == rows.end()) return std::nullopt;
    for (std::size_t i = 0; i < lengths.size(); ++i) lengths[i] = std::hypot(lengths[i], a->second[i] - b->second[i]);
  }
  return lengths.empty() ? std::nullopt : std::optional(lengths);
}

std::optional<TimeCurve> RunResults::curve(const std::string& quantity) const {
  if (!is_curve(quantity)) return std::nullopt;
  const auto values = column(quantity.substr(0, quantity.size() - curve_ending.size()));
  return values ? std::optional(TimeCurve{rows.at("time"), *values}) : std::nullopt;
}

std::optional<double> RunResults::value(const std::string& quantity) const {
  const std::size_t colon = std::min(quantity.find(':'), quantity.size());
  if (const auto values = column(quantity.substr(0, colon))) {
    const std::string what = colon == quantity.size() ? "last" : quantity.substr(colon + 1);
    if (what == "last") return values->back();
    if (what == "max") return *std::max_element(values->begin(), values->end());
    if (what == "min") return *std::min_element(values->begin(), values->end());
    if (what == "integral") return integral_of(rows.at("time"), *values);
    return std::nullopt;
  }
  const auto number = numbers.find(quantity);
  return number == numbers.end() ? std::nullopt : std::optional(number->second);
}

double RunResults::scale(const std::string& quantity) const {
  if (const auto whole = curve(quantity)) {
    const double of_column = scale(quantity.substr(0, quantity.size() - curve_ending.size()));
    return std::max(norm(*whole), small_part * of_column);
  }
  double largest = std::abs(value(quantity).value_or(0));
  const std::string column = quantity.substr(0, quantity.find(':'));
  const bool energy = is_energy_column(column) || is_energy_number(column), integral = quantity.ends_with(":integral");
  const auto [vector, has_axis] = without_axis(column);
  const double duration = rows.count("time") && !rows.at("time").empty() ? rows.at("time").back() : 0;
  for (const auto& [name, values] : rows) {
    const bool kin = energy     ? is_energy_column(name)
                     : has_axis ? without_axis(name) == std::pair(vector, true)
                                : name == column;
    if (kin) largest = std::max(largest, largest_size(values) * (integral ? duration : 1));
  }
  return largest;
}

double RunResults::seconds() const {
  return std::max(0.0, value("wall_seconds").value_or(0) - value("phase_seconds.output").value_or(0));
}

std::vector<std::string> RunResults::known() const {
  std::vector<std::string> names = columns;
  for (const auto& [path, number] : numbers) names.push_back(path);
  return names;
}

std::string unit_of_quantity(const std::string& quantity, const Units& units) {
  if (!units.known()) return {};
  std::string name = quantity.substr(0, quantity.find(':'));
  const bool integral = quantity.ends_with(":integral");
  const auto ends_in_one_of = [&name](const char* characters) {
    return name.size() > 2 && name[name.size() - 2] == '.' && std::strchr(characters, name.back()) != nullptr;
  };
  if (ends_in_one_of("xyz")) name.resize(name.size() - 2);
  if (ends_in_one_of("012")) name.resize(name.size() - 2);  // the row of an inertia
  name = without_axis(name).first;
  const bool energy = is_energy_column(name) || is_energy_number(name) || names_energy_of_body(name);
  const QuantityUnit unit = probes_of_length(name) ? unit_of_length(units)
                            : energy               ? QuantityUnit{units.energy, units.energy + " " + units.time}
                                                   : unit_of_word(name, units);
  return integral ? unit.of_integral : unit.of_value;
}

}  // namespace pinball

#include "curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <tuple>

namespace pinball {

namespace {

/// Cells of the line of names, which may be in quotes.
std::vector<std::string> split_names(const std::string& line) {
  std::vector<std::string> names{""};
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      names.emplace_back();
    } else if (c != '\r') {
      names.back() += c;
    }
  }
  return names;
}

std::vector<double> split_numbers(const std::string& line) {
  std::vector<double> numbers;
  const char *at = line.data(), *const end = at + line.size();
  while (at < end) {
    double value = 0;
    const auto read = std::from_chars(at, end, value);
    if (read.ec == std::errc::invalid_argument) return {};
    if (read.ec != std::errc()) value = std::numeric_limits<double>::quiet_NaN();
    numbers.push_back(value);
    at = read.ptr + 1;  // beyond the comma
  }
  return numbers;
}

/// Smallest and largest number of a column in some rows, in the order in which they are there. NaN are left out.
std::pair<double, double> extremes(const std::vector<std::vector<double>>& rows, std::size_t begin, std::size_t end,
                                   std::size_t column) {
  std::size_t low = begin, high = begin;
  for (std::size_t row = begin; row < end; ++row) {
    const double value = rows[row][column];
    if (std::isnan(value)) continue;
    if (!(rows[low][column] <= value)) low = row;
    if (!(rows[high][column] >= value)) high = row;
  }
  if (low > high) std::swap(low, high);
  return {rows[low][column], rows[high][column]};
}

std::string number_text(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "null";
}

}  // namespace

Curves read_history(const std::string& path) {
  Curves curves;
  std::ifstream file(path, std::ios::binary);
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || line.front() == '#') continue;
    if (curves.columns.empty()) {
      curves.columns = split_names(line);
    } else if (std::vector<double> row = split_numbers(line); row.size() == curves.columns.size()) {
      curves.rows.push_back(std::move(row));
    }
  }
  curves.all_rows = curves.rows.size();
  return curves;
}

void thin(Curves& curves, std::size_t most) {
  const std::vector<std::vector<double>> all = std::move(curves.rows);
  curves.rows.clear();
  const std::size_t groups = (most - 2) / 2, inner = all.size() - std::min<std::size_t>(all.size(), 2);
  if (all.size() <= most) {
    curves.rows = all;
    return;
  }
  const auto time = std::find(curves.columns.begin(), curves.columns.end(), "time") - curves.columns.begin();
  curves.rows.push_back(all.front());
  for (std::size_t group = 0; group < groups; ++group) {
    const std::size_t begin = 1 + group * inner / groups, end = 1 + (group + 1) * inner / groups;
    std::vector<double> first = all[begin], second = all[end - 1];
    for (std::size_t column = 0; column < first.size(); ++column) {
      if (static_cast<std::ptrdiff_t>(column) == time) continue;
      std::tie(first[column], second[column]) = extremes(all, begin, end, column);
    }
    curves.rows.push_back(std::move(first));
    if (end - begin > 1) curves.rows.push_back(std::move(second));
  }
  curves.rows.push_back(all.back());
}

std::string curves_json(const Curves& curves) {
  using Json = nlohmann::json;
  std::string data;
  for (std::size_t column = 0; column < curves.columns.size(); ++column) {
    data += column == 0 ? "[" : ",[";
    const int digits = curves.columns[column] == "time" ? 9 : 7;
    for (std::size_t row = 0; row < curves.rows.size(); ++row) {
      if (row > 0) data += ',';
      data += number_text(curves.rows[row][column], digits);
    }
    data += ']';
  }
  const std::string columns = Json(curves.columns).dump(-1, ' ', false, Json::error_handler_t::replace);
  return fmt::format("{{\"columns\":{},\"all_rows\":{},\"data\":[{}]}}", columns, curves.all_rows, data);
}

}  // namespace pinball

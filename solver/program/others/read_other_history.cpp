#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/formats/deck/number_text.hpp>

#include "history_rows.hpp"
#include "other_history.hpp"
#include "read_binout.hpp"
#include "read_calculix.hpp"
#include "read_d3plot.hpp"
#include "read_t01.hpp"

namespace pinball {

namespace {

constexpr const char* node_heading = "n o d a l   p r i n t   o u t";

/// Numbers in scientific notation, which may stand without a blank between them: -1.2E+00-3.4E+00.
std::vector<double> numbers_of_fields(const std::string& line, std::size_t begin) {
  std::vector<double> numbers;
  std::string number;
  const auto end_number = [&] {
    if (!number.empty()) numbers.push_back(deck_number(number).value_or(not_there));
    number.clear();
  };
  for (std::size_t i = begin; i < line.size(); ++i) {
    const char c = line[i];
    const bool sign = c == '-' || c == '+';
    const bool in_exponent = !number.empty() && (number.back() == 'E' || number.back() == 'e');
    if (std::isspace(static_cast<unsigned char>(c)) != 0 || (sign && !in_exponent)) end_number();
    if (std::isspace(static_cast<unsigned char>(c)) == 0) number += c;
  }
  end_number();
  return numbers;
}

/// " kinetic energy.........................  1.254E+04": name and value; an empty name where it is no such line.
std::pair<std::string, std::string> split_dots(const std::string& line) {
  const auto dots = line.find("..");
  if (dots == std::string::npos) return {};
  const auto value = line.find_first_not_of('.', dots);
  if (value == std::string::npos) return {};
  const std::string_view text(line);
  return {std::string(trimmed(text.substr(0, dots))), std::string(trimmed(text.substr(value)))};
}

bool is_glstat(const std::vector<std::string>& lines) {
  return std::any_of(lines.begin(), lines.begin() + std::min<std::ptrdiff_t>(lines.size(), 200),
                     [](const std::string& line) { return split_dots(line).first == "time"; });
}

bool is_nodout(const std::vector<std::string>& lines) {
  return std::any_of(lines.begin(), lines.begin() + std::min<std::ptrdiff_t>(lines.size(), 200),
                     [](const std::string& line) { return line.find(node_heading) != std::string::npos; });
}

void read_glstat(const std::vector<std::string>& lines, OtherHistory& history) {
  history.kind = "glstat of LS-DYNA";
  Rows rows(history);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto [name, text] = split_dots(lines[i]);
    if (name.empty()) continue;
    const std::optional<double> value = deck_number(text);
    if (name == "time") {
      if (!value) {
        throw InputError(fmt::format("{}:{}: expected a time, got {}", history.path, i + 1, text));
      }
      rows.begin(*value);
    } else if (value && !rows.empty()) {
      rows.set(name, *value, meaning_in_glstat);
    }
  }
}

/// Blocks of a time each: a line of heading with the time, one with names, and a line for each node with displacements,
/// velocities, accelerations and coordinates. Those of turning nodes have another line of names, and are left out.
void read_nodout(const std::vector<std::string>& lines, OtherHistory& history) {
  history.kind = "nodout of LS-DYNA";
  constexpr std::string_view at_time = "at time";
  Rows rows(history);
  bool of_motion = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    if (line.find(node_heading) != std::string::npos) {
      const auto at = line.find(at_time);
      const std::string text = at == std::string::npos ? "" : line.substr(at + at_time.size());
      const std::optional<double> time = deck_number(trimmed(std::string_view(text).substr(0, text.find(')'))));
      if (!time) {
        throw InputError(
            fmt::format("{}:{}: expected 'at time' and a number, got '{}'", history.path, i + 1, trimmed(line)));
      }
      if (rows.empty() || *time != history.times.back()) rows.begin(*time);
      of_motion = false;
      continue;
    }
    if (line.find("nodal point") != std::string::npos) {
      of_motion = line.find("x-disp") != std::string::npos;
      continue;
    }
    const auto number = line.find_first_not_of(' ');
    if (!of_motion || rows.empty() || number == std::string::npos) continue;
    const auto end = std::min(line.find_first_not_of("0123456789", number), line.size());
    const std::vector<double> values = numbers_of_fields(line, end);
    if (end == number || values.size() < 6) continue;
    for (std::size_t k = 0; k < 6; ++k) {
      const std::string column = fmt::format("node_{}_{}_{}", line.substr(number, end - number),
                                             k < 3 ? "displacement" : "velocity", "xyz"[k % 3]);
      rows.set(column, values[k], meaning_of_column);
    }
  }
}

/// Cells of a line of a table; separator ' ': any number of blanks and tabs. What is in quotes stays together.
std::vector<std::string> split_cells(const std::string& line, char separator) {
  std::vector<std::string> cells{""};
  bool quoted = false;
  for (const char c : line) {
    const bool ends = !quoted && (separator == ' ' ? c == ' ' || c == '\t' || c == '\r' : c == separator);
    if (c == '"') {
      quoted = !quoted;
    } else if (!ends) {
      cells.back() += c;
    } else if (separator != ' ' || !cells.back().empty()) {
      cells.emplace_back();
    }
  }
  if (trimmed(cells.back()).empty()) cells.pop_back();  // th_to_csv ends lines with a comma
  for (std::string& cell : cells) cell = std::string(trimmed(cell));
  return cells;
}

char separator_of(const std::string& heading) {
  for (const char c : {',', ';', '\t'}) {
    if (heading.find(c) != std::string::npos) return c;
  }
  return ' ';
}

bool is_time(const std::string& name) {
  const std::string plain = plain_name(name);
  return plain == "time" || plain == "t" || plain == "x";  // X: of Abaqus' XY reports
}

/// Cells of a table that are no numbers, nor what programs write where there is none.
class TextCells {
 public:
  explicit TextCells(const std::vector<std::string>& names) : columns_(names.size()) {}

  void take(std::size_t column, const std::string& cell, bool is_number, std::size_t line) {
    Column& c = columns_[column];
    c.has_numbers = c.has_numbers || is_number;
    if (!is_number && c.text.empty() && !is_none(cell)) c = {c.has_numbers, cell, line};
  }
  /// Throws InputError where a column has numbers and texts, such as "3,5": what they were to be is not known.
  void check(const std::vector<std::string>& names, const std::string& path) const {
    for (std::size_t k = 0; k < names.size(); ++k) {
      const Column& c = columns_[k];
      if (c.has_numbers && !c.text.empty())
        throw InputError(fmt::format("{}:{}: column {}: expected a number, got '{}'", path, c.line, names[k], c.text));
    }
  }

 private:
  struct Column {
    bool has_numbers = false;
    std::string text{};    ///< the first one
    std::size_t line = 0;  ///< of it
  };
  static bool is_none(const std::string& cell) {
    std::string plain = cell;
    for (char& c : plain) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    constexpr std::string_view names[] = {"", "nan", "inf", "infinity", "n/a", "na", "none", "null", "novalue"};
    return std::ranges::count(names, plain) > 0 || cell.find_first_not_of("+-*") == std::string::npos ||
           ((cell.front() == '+' || cell.front() == '-') && is_none(cell.substr(1)));
  }

  std::vector<Column> columns_;
};

/// Throws InputError where two columns have one name: which of them is meant is not known.
void require_own_names(const std::vector<std::string>& names, const std::string& where) {
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::size_t first = std::ranges::find(names, names[k]) - names.begin();
    if (first < k && !names[k].empty()) {
      throw InputError(fmt::format("{}: expected columns with a name each, columns {} and {} are both '{}'", where,
                                   first + 1, k + 1, names[k]));
    }
  }
}

void read_table(const std::vector<std::string>& lines, OtherHistory& history) {
  history.kind = "table";
  const auto is_told = [](const std::string& line) {
    const std::string_view text = trimmed(line);
    return !text.empty() && text.front() != '#';
  };
  const auto heading = std::find_if(lines.begin(), lines.end(), is_told);
  if (heading == lines.end()) throw InputError(fmt::format("{}: expected a history, got an empty file", history.path));
  const char separator = separator_of(*heading);
  const std::vector<std::string> names = split_cells(*heading, separator);
  const auto time = std::find_if(names.begin(), names.end(), is_time);
  if (time == names.end()) {
    throw InputError(
        fmt::format("{}:{}: expected the names of columns, one of them time, or LS-DYNA's glstat or nodout, or "
                    "CalculiX' .dat, got '{}'",
                    history.path, heading - lines.begin() + 1, trimmed(std::string_view(*heading).substr(0, 60))));
  }
  require_own_names(names, fmt::format("{}:{}", history.path, heading - lines.begin() + 1));
  Rows rows(history);
  TextCells texts(names);
  for (auto line = heading + 1; line != lines.end(); ++line) {
    if (!is_told(*line)) continue;
    const std::vector<std::string> cells = split_cells(*line, separator);
    std::vector<std::optional<double>> values;
    for (const std::string& cell : cells) values.push_back(deck_number(cell));
    const std::size_t of_time = time - names.begin();
    if (cells.size() < names.size() && line + 1 == lines.end()) break;  // still being written
    if (cells.size() != names.size() || !values[of_time]) {
      throw InputError(fmt::format("{}:{}: expected {} numbers, a time among them, got '{}'", history.path,
                                   line - lines.begin() + 1, names.size(),
                                   trimmed(std::string_view(*line).substr(0, 60))));
    }
    rows.begin(*values[of_time]);
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (k == of_time) continue;
      rows.set(names[k], values[k].value_or(not_there), meaning_of_column);
      texts.take(k, cells[k], values[k].has_value(), line - lines.begin() + 1);
    }
  }
  texts.check(names, history.path);
}

std::vector<std::string> lines_of(const std::string& bytes) {
  std::vector<std::string> lines;
  std::istringstream text(bytes);
  for (std::string line; std::getline(text, line); lines.push_back(std::move(line))) {
  }
  return lines;
}

}  // namespace

OtherHistory read_other_history(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("{}: cannot be read", path));
  std::ostringstream all;
  all << file.rdbuf();
  const std::string bytes = std::move(all).str();
  OtherHistory history{path, "", {}, {}};
  std::size_t least = 2;
  if (is_t01(bytes)) {
    read_t01(bytes, history);
  } else if (is_binout(bytes)) {
    read_binout(bytes, history);
  } else if (is_d3plot(bytes)) {
    read_d3plot(bytes, history);
    least = 1;
  } else if (bytes.find('\0') != std::string::npos) {
    throw InputError(
        fmt::format("{}: expected text, a binout or a d3plot of LS-DYNA or a T01 file of Radioss, got another binary "
                    "file",
                    path));
  } else if (const std::vector<std::string> lines = lines_of(bytes); is_glstat(lines)) {
    read_glstat(lines, history);
  } else if (is_nodout(lines)) {
    read_nodout(lines, history);
  } else if (is_calculix_dat(lines)) {
    read_calculix_dat(lines, history);
    least = 1;  // one state is enough to be laid beside the last one
  } else {
    read_table(lines, history);
  }
  if (history.times.size() < least) {
    throw InputError(fmt::format("{}: expected {} at least, got {}", path, least == 1 ? "one state" : "two times",
                                 history.times.size()));
  }
  return history;
}

}  // namespace pinball

#include "read_calculix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include <solver/base/error.hpp>
#include <solver/formats/deck/number_text.hpp>

#include "history_rows.hpp"

namespace pinball {

namespace {

/// Whose numbers a table has.
enum class Of { node, set, element };

/// A table by the words that it begins with, and what its numbers are here. Points of integration have their number
/// behind that of the element.
struct KnownTable {
  std::string_view words;
  Of of;
  std::array<std::string_view, 6> names;
};

constexpr std::array<KnownTable, 5> known_tables{{
    {"displacements", Of::node, {"displacement_x", "displacement_y", "displacement_z"}},
    {"velocities", Of::node, {"velocity_x", "velocity_y", "velocity_z"}},
    {"total force", Of::set, {"force_x", "force_y", "force_z"}},
    {"stresses", Of::element, {"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_zx", "stress_yz"}},
    {"equivalent plastic strain", Of::element, {"plastic_strain"}},
}};

/// " displacements (vx,vy,vz) for set NALL and time  0.1000000E+01"
struct Heading {
  std::string_view words, set, time;
};

std::optional<Heading> heading_of(std::string_view line) {
  constexpr std::string_view of_set = " for set ", at_time = " and time ";
  const auto set = line.find(of_set), time = line.rfind(at_time);
  if (set == std::string_view::npos || time == std::string_view::npos || time < set) return std::nullopt;
  const std::string_view words = line.substr(0, std::min(set, line.find('(')));
  const std::size_t begin = set + of_set.size();
  return Heading{trimmed(words), time > begin ? trimmed(line.substr(begin, time - begin)) : "",
                 trimmed(line.substr(time + at_time.size()))};
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (!(line = trimmed(line)).empty()) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

class DatReader {
 public:
  DatReader(const std::vector<std::string>& lines, OtherHistory& history)
      : lines_(lines), history_(history), rows_(history) {}

  void read() {
    for (line_ = 0; line_ < lines_.size(); ++line_) {
      const std::string_view text = trimmed(lines_[line_]);
      if (const auto heading = heading_of(lines_[line_])) {
        begin(*heading);
      } else if (table_ != nullptr && !text.empty()) {
        take(words_of(text));
      }
    }
    end_element();
  }

 private:
  [[noreturn]] void fail(const std::string& expected, std::string_view got) const {
    throw InputError(fmt::format("{}:{}: expected {}, got '{}'", history_.path, line_ + 1, expected, got));
  }

  void begin(const Heading& heading) {
    end_element();
    const auto* const known =
        std::ranges::find_if(known_tables, [&](const KnownTable& t) { return t.words == heading.words; });
    table_ = known == known_tables.end() ? nullptr : known;
    set_ = heading.set;
    const std::optional<double> time = deck_number(heading.time);
    if (!time) fail("a time behind 'and time'", heading.time);
    if (rows_.empty() || *time != history_.times.back()) rows_.begin(*time);
  }

  std::size_t count() const {
    return std::ranges::count_if(table_->names, [](std::string_view name) { return !name.empty(); });
  }

  /// A row of the table; the banner of a step, "S T E P 2", ends it.
  void take(const std::vector<std::string_view>& words) {
    if (words.front() == "S" || words.front() == "INCREMENT") {
      end_element();
      table_ = nullptr;
      return;
    }
    if (words.back() == "L") return;  // in a system of its own
    const std::size_t numbers = table_->of == Of::element ? 2 : table_->of == Of::node ? 1 : 0;
    const bool numbered = std::ranges::all_of(words.begin(), words.begin() + std::min(numbers, words.size()),
                                              [](std::string_view word) { return deck_integer(word).has_value(); });
    if (words.size() != numbers + count() || !numbered) {
      fail(fmt::format("a row of {}: {} numbers", table_->words, numbers + count()), trimmed(lines_[line_]));
    }
    const std::string of(words.front());
    if (table_->of == Of::element && of != element_) {
      end_element();
      element_ = of;
    }
    for (std::size_t k = 0; k < count(); ++k) {
      const double value = deck_number(words[numbers + k]).value_or(not_there);
      if (table_->of == Of::element) {
        sums_[k] += value;
      } else {
        set(table_->of == Of::node ? "node_" + of : set_, k, value);
      }
    }
    ++points_;
  }

  /// What is of an element is known with its last integration point.
  void end_element() {
    for (std::size_t k = 0; !element_.empty() && k < count(); ++k) set("element_" + element_, k, sums_[k] / points_);
    element_.clear();
    sums_ = {};
    points_ = 0;
  }

  void set(const std::string& of, std::size_t k, double value) {
    rows_.set(fmt::format("{}_{}", of, table_->names[k]), value, meaning_of_column);
  }

  const std::vector<std::string>& lines_;
  OtherHistory& history_;
  Rows rows_;
  std::size_t line_ = 0;
  const KnownTable* table_ = nullptr;  ///< of the lines that follow; null: they are passed over
  std::string set_, element_;
  std::array<double, 6> sums_{};  ///< over the points of the element
  int points_ = 0;
};

}  // namespace

bool is_calculix_dat(const std::vector<std::string>& lines) {
  return std::any_of(lines.begin(), lines.begin() + std::min<std::ptrdiff_t>(lines.size(), 200),
                     [](const std::string& line) { return heading_of(line).has_value(); });
}

void read_calculix_dat(const std::vector<std::string>& lines, OtherHistory& history) {
  history.kind = "dat of CalculiX";
  DatReader(lines, history).read();
}

}  // namespace pinball

#include "text_table.hpp"

#include <algorithm>
#include <cmath>

#include <solver/output/progress.hpp>

namespace pinball {

std::string text_table(const std::vector<std::vector<std::string>>& lines, const std::vector<Align>& align) {
  std::vector<std::size_t> width(align.size(), 0);
  for (const auto& line : lines) {
    for (std::size_t c = 0; c < line.size(); ++c) width[c] = std::max(width[c], line[c].size());
  }
  std::string text;
  for (const auto& line : lines) {
    std::string row;
    for (std::size_t c = 0; c < line.size(); ++c) {
      if (c > 0) row += "  ";
      row += align[c] == Align::right ? fmt::format("{:>{}}", line[c], width[c])
                                      : fmt::format("{:<{}}", line[c], width[c]);
    }
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + '\n';
  }
  return text;
}

std::string number_cell(const std::optional<double>& value, fmt::format_string<const double&> format) {
  return value ? fmt::format(format, *value) : "-";
}

std::string percent_cell(double share) {
  const double percent = 100 * std::abs(share);
  return percent < 99.5 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
}

std::string duration_cell(double seconds) {
  return seconds < 60 ? fmt::format("{:.2g} s", seconds) : readable_duration(seconds);
}

}  // namespace pinball

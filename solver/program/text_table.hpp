#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

namespace pinball {

enum class Align { left, right };

/// Lines of cells, in columns as wide as their widest cell with two blanks between them; no blanks at the ends of
/// lines. align: one per column.
std::string text_table(const std::vector<std::vector<std::string>>& lines, const std::vector<Align>& align);

/// "-" where there is none.
std::string number_cell(const std::optional<double>& value, fmt::format_string<const double&> format);

/// A share as "0.12 %", "230 %".
std::string percent_cell(double share);

/// "0.35 s", "3 min 05 s".
std::string duration_cell(double seconds);

}  // namespace pinball

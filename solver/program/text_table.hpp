#pragma once

#include <string>
#include <vector>

namespace pinball {

enum class Align { left, right };

/// Lines of cells, in columns as wide as their widest cell with two blanks between them; no blanks at the ends of
/// lines. align: one per column.
std::string text_table(const std::vector<std::vector<std::string>>& lines, const std::vector<Align>& align);

}  // namespace pinball

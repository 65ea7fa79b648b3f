#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pinball {

/// What a run was over time: the rows of history.csv, or fewer.
struct Curves {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  ///< each as long as columns
  std::size_t all_rows = 0;               ///< before they were thinned
};

/// A page has room for so many rows.
inline constexpr std::size_t most_rows_of_page = 2000;

/// The rows of a history.csv that are whole; none where it cannot be read.
Curves read_history(const std::string& path);

/// At most `most` rows (>= 4). The first and the last stay as they are; of each group of rows in between two are left,
/// at the times of its first and its last, which hold for every column its smallest and its largest number, in the
/// order in which they were: no peak is lost, and none moves by more than a group.
void thin(Curves& curves, std::size_t most);

/// {"columns": [...], "all_rows": n, "data": [[...] per column]}: 7 digits, null for what is not finite.
std::string curves_json(const Curves& curves);

}  // namespace pinball

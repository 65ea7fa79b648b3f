#include "text_distance.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pinball {

int edit_distance(std::string_view a, std::string_view b) {
  // Optimal string alignment: three rows of the table suffice, a swap looks two rows back.
  std::vector<int> before(b.size() + 1), previous(b.size() + 1), current(b.size() + 1);
  std::iota(previous.begin(), previous.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min({replaced, previous[j] + 1, current[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        current[j] = std::min(current[j], before[j - 2] + 1);
      }
    }
    std::swap(before, previous);
    std::swap(previous, current);
  }
  return previous[b.size()];
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  // The distance takes the product of both lengths: of words that nobody types the beginning has to do.
  constexpr std::size_t most = 100;
  std::string best;
  int fewest = std::numeric_limits<int>::max();
  for (const auto& candidate : candidates) {
    const int slips = edit_distance(word.substr(0, most), std::string_view(candidate).substr(0, most));
    if (slips < fewest) {
      fewest = slips;
      best = candidate;
    }
  }
  return best;
}

}  // namespace pinball

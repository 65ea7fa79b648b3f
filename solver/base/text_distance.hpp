#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pinball {

/// How many typing slips lie between two words: a letter missing, added, replaced, or two neighbours swapped.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate with the fewest slips to `word`, the earlier one on a tie; empty if there are no candidates.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace pinball

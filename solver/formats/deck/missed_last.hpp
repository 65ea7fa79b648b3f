#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "deck_place.hpp"

namespace pinball {

/// A range "first, last, step" whose last number no step hits: it is likely to be meant, and is left out. Adds a note
/// of it, once; keyword: as messages name it. step > 0.
inline void note_missed_last(std::string_view keyword, const DeckPlace& place, std::int64_t first, std::int64_t last,
                             std::int64_t step, std::vector<std::string>& notes) {
  if (last <= first || (last - first) % step == 0) return;
  std::string note = fmt::format("{} ({}): from {} in steps of {} it ends at {}, {} is not hit", keyword, place.text(),
                                 first, step, last - (last - first) % step, last);
  if (std::ranges::find(notes, note) == notes.end()) notes.push_back(std::move(note));
}

}  // namespace pinball

#pragma once

#include <fmt/format.h>

#include <solver/formats/radioss/layouts/radioss_mesh_cards.hpp>
#include <solver/formats/radioss/scan/radioss_fields.hpp>

namespace pinball {

inline constexpr std::size_t deepest_radioss_group = 64;  ///< of groups in groups; deeper, one is in itself

/// Calls read(number, place) for each number of the lines of a list. Throws InputError for one below 0, which takes
/// away.
template <class Read>
void for_each_radioss_member(const RadiossBlock& block, const Read& read) {
  RadiossLines lines(block);
  while (const auto line = lines.next_filled()) {
    const RadiossFields f(*line, block, radioss::members);
    for (std::size_t i = 0; i < radioss::members.size(); ++i) {
      const std::int64_t number = f.integer(i);
      if (number < 0) f.fail(f.name(i), fmt::format("expected numbers > 0, got {}: give what is left", number));
      if (number != 0) read(number, line->place);
    }
  }
}

}  // namespace pinball

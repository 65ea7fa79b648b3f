#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Words and numbers as decks write them.
namespace pinball {

std::string lower_case(std::string_view text);
std::string upper_case(std::string_view text);
std::string_view trimmed(std::string_view text);

/// A whole or a decimal number as decks write it: also "7.34000-4", "1.D-3", "+5" and, for whole numbers, "5." and
/// "5.0". None: it is not one.
std::optional<std::int64_t> deck_integer(std::string_view text);
std::optional<double> deck_number(std::string_view text);

/// Whole numbers beyond this are none, so that their sums with the offsets of *INCLUDE_TRANSFORM are numbers, too.
inline constexpr double largest_integer = 9e15;

}  // namespace pinball

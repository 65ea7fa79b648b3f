#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "keyword_block.hpp"
#include "parameters.hpp"

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

inline constexpr std::array<int, 8> eight_by_ten{10, 10, 10, 10, 10, 10, 10, 10};

/// The fields of a card: columns of given widths, or, where the card has a comma, what stands between commas. Blank
/// fields, and those behind the end of the card, have their defaults. All that read throw InputError with the place of
/// the card, the name of the field and what was expected. The card has to outlive them.
class Fields {
 public:
  Fields(const Card& card, const Parameters& parameters, std::span<const int> widths = eight_by_ten);
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;
  /// Writes down which fields nobody has asked for.
  ~Fields();

  std::string text(std::size_t field) const;
  bool blank(std::size_t field) const { return raw(field).empty(); }
  std::int64_t integer(std::size_t field, const char* name, std::optional<std::int64_t> otherwise = {}) const;
  double number(std::size_t field, const char* name, std::optional<double> otherwise = {}) const;
  const DeckPlace& place() const { return place_; }

 private:
  void cut_at_commas(std::string_view rest);
  std::string_view raw(std::size_t field) const;
  [[noreturn]] void fail(std::size_t field, const char* name, const std::string& expected) const;

  static constexpr std::size_t most_fields = 20;
  std::array<std::string_view, most_fields> fields_{};
  std::size_t count_ = 0;
  const Parameters* parameters_;
  const DeckPlace& place_;
  ReadingLog* log_;
  const char* line_;
  mutable std::uint32_t asked_ = 0;  ///< fields by their bits
};

}  // namespace pinball

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <solver/base/point.hpp>

#include "cards/card_field.hpp"
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

/// What stands in a line: in columns, or, where it has a comma, between commas. Blank fields, and those behind the end
/// of the line, have defaults. All that read throw InputError with the place of the line, its keyword, the name of the
/// field and what was expected. The card has to outlive them.
class LineFields {
 public:
  LineFields(const LineFields&) = delete;
  LineFields& operator=(const LineFields&) = delete;

  std::string text(std::size_t field) const;
  bool blank(std::size_t field) const { return raw(field).empty(); }
  /// otherwise: the default; none: a blank field is an error.
  std::int64_t integer(std::size_t field, std::string_view name, std::optional<std::int64_t> otherwise = {}) const;
  double number(std::size_t field, std::string_view name, std::optional<double> otherwise = {}) const;
  const DeckPlace& place() const { return place_; }
  /// "*NODE: TC: expected 0 to 7, got 9", at its place.
  [[noreturn]] void fail(std::string_view name, const std::string& problem) const;

 protected:
  /// parameters: null: the text has none.
  LineFields(const Card& card, const Parameters* parameters);
  ~LineFields() = default;

  bool cut_at_commas(std::string_view line);
  void add(std::string_view field) { fields_[count_++] = trimmed(field); }
  /// Writes down those of which nobody has asked for what they say. layout: null: 0 says nothing, as a blank.
  void write_down(const CardLayout* layout) const;
  const KeywordBlock* block() const { return block_; }
  /// As it stands, which is asking for it.
  std::string_view raw(std::size_t field) const {
    if (field >= count_) return {};
    asked_ |= 1U << field;
    return fields_[field];
  }

  static constexpr std::size_t most_fields = 20;
  std::size_t count_ = 0;

 private:
  [[noreturn]] void fail_to_read(std::size_t field, std::string_view name, const std::string& expected) const;

  std::array<std::string_view, most_fields> fields_{};
  const Parameters* parameters_;
  const KeywordBlock* block_;
  const DeckPlace& place_;
  ReadingLog* log_;
  const char* line_;
  mutable std::uint32_t asked_ = 0;  ///< fields by their bits
};

/// The fields of a card of LS-DYNA by their names in its layout, which has their columns, defaults, bounds and units:
/// numbers are in those of the deck.
class Fields : public LineFields {
 public:
  Fields(const Card& card, const Parameters& parameters, const CardLayout& layout);
  ~Fields() { write_down(layout_); }
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;

  using LineFields::blank;
  using LineFields::text;
  std::string text(std::string_view name) const { return text(place_of(name)); }
  bool blank(std::string_view name) const { return blank(place_of(name)); }
  std::int64_t integer(std::string_view name) const { return integer(place_of(name)); }
  double number(std::string_view name) const { return number(place_of(name)); }
  // By their places: of many of one kind.
  std::int64_t integer(std::size_t field) const;
  double number(std::size_t field) const;

  /// The three numbers that begin with this one.
  Point point(std::string_view first) const;
  std::string_view name(std::size_t field) const { return (*layout_)[field].name; }

 private:
  void cut_columns(std::string_view line);
  std::size_t place_of(std::string_view name) const;
  void require_bounds(const CardField& one, double value) const;

  const CardLayout* layout_;
};

}  // namespace pinball

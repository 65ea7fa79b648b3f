#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <solver/base/point.hpp>
#include <solver/formats/deck/line_fields.hpp>
#include <solver/formats/lsdyna/layouts/card_field.hpp>

#include "keyword_block.hpp"
#include "parameters.hpp"

namespace pinball {

/// The fields of a card of LS-DYNA by their names in its layout, which has their columns, defaults, bounds and units:
/// numbers are in those of the deck.
class Fields final : public LineFields {
 public:
  Fields(const Card& card, const Parameters& parameters, const CardLayout& layout);
  ~Fields();
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
  std::string meant(std::string_view given) const override;
  std::string keyword() const override;
  void cut_columns(std::string_view line);
  std::size_t place_of(std::string_view name) const;
  void require_bounds(const CardField& one, double value) const;

  const Parameters* parameters_;
  const KeywordBlock* block_;
  const CardLayout* layout_;
};

}  // namespace pinball

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <solver/base/point.hpp>

#include "card_field.hpp"
#include "line_fields.hpp"

namespace pinball {

/// The fields of a line by their names in its layout, which has their columns, defaults and bounds.
class LayoutFields : public LineFields {
 public:
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

 protected:
  LayoutFields(const DataLine& line, const CardLayout& layout) : LineFields(line), layout_(&layout) {}
  ~LayoutFields() = default;

  const CardLayout& layout() const { return *layout_; }
  std::size_t place_of(std::string_view name) const;
  /// Writes down those of which nobody has asked for what they say: for the end of a class of these.
  void write_down_unread() const;
  /// In a line of columns nobody knows what columns a tab stands for.
  void require_no_tab(std::string_view line) const;

 private:
  /// What a number of a dimension is multiplied by.
  virtual double factor(Dimension) const { return 1; }
  void require_bounds(const CardField& one, double value) const;

  const CardLayout* layout_;
};

}  // namespace pinball

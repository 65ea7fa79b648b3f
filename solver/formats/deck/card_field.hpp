#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string_view>

/// What the manual says of the fields of a card, and what becomes of each here. Cards are read by these tables, and by
/// nothing else: names, columns, defaults, bounds and units stand here once.
namespace pinball {

enum class FieldUse : std::uint8_t {
  used,      ///< asked for; what a deck says and nobody has asked for is reported all the same
  reported,  ///< never asked for: what a deck says other than the default is reported by name
  rejected   ///< the same ends the program, by name
};

enum class FieldType : std::uint8_t { whole, number, text };

/// Of a number: what it is multiplied by in an included file of other units.
enum class Dimension : std::uint8_t { none, mass, time, length, density, stress, rate, velocity, specific_heat };

struct CardField {
  std::string_view name;  ///< as in the manual; empty: there is none in these columns
  FieldType type = FieldType::number;
  FieldUse use = FieldUse::used;
  Dimension dimension = Dimension::none;
  bool required = false;    ///< no default: a blank one is an error
  int width = 10;           ///< columns
  double otherwise = 0;     ///< default of a number
  std::string_view word{};  ///< default of a text
  double least = -std::numeric_limits<double>::infinity(), most = -least;
  std::string_view remark{};  ///< why it is not used, or what to do in its place

  /// wide: numbers of nodes and elements have ten columns. twenty: all fields have twenty.
  constexpr std::size_t columns_of(bool wide, bool twenty) const {
    if (twenty) return 20;
    return wide && width == 8 && type == FieldType::whole ? 10 : width;
  }
  constexpr CardField reported(std::string_view why = {}) const { return with(FieldUse::reported, why); }
  constexpr CardField rejected(std::string_view why) const { return with(FieldUse::rejected, why); }
  constexpr CardField of(Dimension what) const {
    CardField field = *this;
    field.dimension = what;
    return field;
  }
  constexpr CardField always() const {
    CardField field = *this;
    field.required = true;
    return field;
  }
  constexpr CardField from(double low, double high) const {
    CardField field = *this;
    field.least = low;
    field.most = high;
    return field;
  }
  constexpr CardField at_least(double low) const { return from(low, std::numeric_limits<double>::infinity()); }
  constexpr CardField columns(int count) const {
    CardField field = *this;
    field.width = count;
    return field;
  }

 private:
  constexpr CardField with(FieldUse what, std::string_view why) const {
    CardField field = *this;
    field.use = what;
    field.remark = why;
    return field;
  }
};

namespace layout {

constexpr CardField whole(std::string_view name, double otherwise = 0) {
  CardField field{name, FieldType::whole};
  field.otherwise = otherwise;
  return field;
}
constexpr CardField number(std::string_view name, double otherwise = 0) {
  CardField field{name};
  field.otherwise = otherwise;
  return field;
}
constexpr CardField text(std::string_view name, std::string_view otherwise = {}) {
  CardField field{name, FieldType::text};
  field.word = otherwise;
  return field;
}
inline constexpr CardField gap{};

}  // namespace layout

/// One line of a keyword.
class CardLayout {
 public:
  static constexpr std::size_t most = 10;

  constexpr CardLayout(std::initializer_list<CardField> fields) {
    for (const CardField& field : fields) fields_[count_++] = field;
  }
  constexpr std::size_t size() const { return count_; }
  constexpr const CardField& operator[](std::size_t i) const { return fields_[i]; }
  constexpr const CardField* begin() const { return fields_.data(); }
  constexpr const CardField* end() const { return begin() + count_; }
  /// The place of a field; size(): none has this name.
  constexpr std::size_t find(std::string_view name) const {
    std::size_t i = 0;
    while (i < count_ && fields_[i].name != name) ++i;
    return i;
  }

 private:
  std::array<CardField, most> fields_{};
  std::size_t count_ = 0;
};

}  // namespace pinball

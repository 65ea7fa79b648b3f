#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pinball {

enum class Dimension { length, time, mass, force, stress, energy };

/// A unit that has a name.
struct NamedUnit {
  std::string name;  ///< as it is printed
  Dimension dimension;
  double si;  ///< how many m, s, kg, N, Pa or J it is
};

/// The unit of a usual name: exactly as written ("Mg" and "mg" are two), or, where that is the unit of no other, in
/// other cases and in the plural ("KG", "Inches").
std::optional<NamedUnit> named_unit(std::string_view text);

/// The name of a force, a stress or an energy of this size; empty: it has none.
std::string name_of_unit(Dimension dimension, double si);

/// "a length", "a time", ...
const char* in_words(Dimension dimension);

}  // namespace pinball

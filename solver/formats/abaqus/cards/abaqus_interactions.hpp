#pragma once

#include <map>
#include <string>

#include "abaqus_parts.hpp"

namespace pinball {

/// Coulomb's coefficients of an interaction.
struct AbaqusFriction {
  double sliding = 0, at_rest = 0, decay = 0;
};

/// SURFACE INTERACTION of a deck by their labels, with FRICTION and SURFACE BEHAVIOR of each.
class AbaqusInteractions {
 public:
  /// data has to stay.
  explicit AbaqusInteractions(AbaqusData& data);

  /// Friction of an interaction that something has. What its surface behavior is taken for is reported then, or
  /// refused. Throws InputError where it is not there.
  const AbaqusFriction& use(const std::string& name, const DeckPlace& place);

 private:
  struct Interaction {
    AbaqusFriction friction;
    const AbaqusBlock* behavior = nullptr;  ///< until it is told
  };

  AbaqusData& data_;
  std::map<std::string, Interaction> interactions_;
};

}  // namespace pinball

#pragma once

#include <string>

#include "deck_scene.hpp"

namespace pinball {

/// Hourglass control and bulk viscosity of a part, as a scene has them.
struct DeckElement {
  std::string hourglass;
  double coefficient = 0, quadratic_viscosity = 0, linear_viscosity = 0;

  bool operator==(const DeckElement&) const = default;
};

/// [element] of the scene, and that of a body which has its own.
void set_element(const DeckElement& element, const DeckKeys<ElementSettings>& keys);
void set_body_element(const DeckElement& element, const DeckKeys<Body>& keys);

}  // namespace pinball

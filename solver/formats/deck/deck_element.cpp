#include "deck_element.hpp"

namespace pinball {

namespace {

template <class Keys>
void set_keys(const DeckElement& element, Keys& keys) {
  keys.set("hourglass", element.hourglass);
  keys.set("hourglass_coefficient", element.coefficient);
  keys.set("quadratic_viscosity", element.quadratic_viscosity);
  keys.set("linear_viscosity", element.linear_viscosity);
}

}  // namespace

void set_element(const DeckElement& element, const DeckKeys<ElementSettings>& keys) { set_keys(element, keys); }

void set_body_element(const DeckElement& element, const DeckKeys<Body>& keys) {
  InnerKeys<ElementSettings> inner;
  set_keys(element, inner);
  keys.set("element", inner.value());
}

}  // namespace pinball

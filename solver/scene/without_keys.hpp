#pragma once

#include <solver/scene_rules.hpp>

namespace pinball {

/// What an object is where no key is given. Some values follow from keys that are.
template <class T>
T without_keys(const T&) {
  return T{};
}

inline ElementSettings without_keys(const ElementSettings& element) {
  ElementSettings without;
  without.hourglass = element.hourglass;
  complete(without);
  without.hourglass = ElementSettings{}.hourglass;
  return without;
}

inline ContactSettings without_keys(const ContactSettings& contact) {
  ContactSettings without;
  without.enforcement = contact.enforcement;
  without.friction = contact.friction;  // at rest it is the same, if not given
  complete(without);
  without.friction = 0;
  without.enforcement = ContactSettings{}.enforcement;
  return without;
}

}  // namespace pinball

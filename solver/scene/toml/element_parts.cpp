#include <solver/scene/schema/settings.hpp>

#include "parts.hpp"
#include "read_keys.hpp"

namespace pinball {

ElementSettings read_element(const SceneTable& table, const ElementSettings& otherwise) {
  ElementSettings element = otherwise;
  if (table.has("hourglass")) {
    element.hourglass_coefficient = ElementSettings{}.hourglass_coefficient;
  } else if (table.has("hourglass_coefficient")) {
    // A coefficient that was meant for one form would mean something else to another.
    table.fail("hourglass_coefficient", "needs hourglass beside it, the form that it is a coefficient of");
  }
  read_keys(table, element);
  complete(element);
  return element;
}

}  // namespace pinball

#include "deck_element.hpp"

#include <fmt/format.h>

namespace pinball {

void write_element(const DeckElement& element, TomlText& scene) {
  scene.table("element");
  scene.key("hourglass", element.hourglass);
  scene.key("hourglass_coefficient", element.coefficient);
  scene.key("quadratic_viscosity", element.quadratic_viscosity);
  scene.key("linear_viscosity", element.linear_viscosity);
}

void write_body_element(const DeckElement& element, TomlText& scene) {
  scene.raw("element", fmt::format("{{ hourglass = {}, hourglass_coefficient = {}, quadratic_viscosity = {}, "
                                   "linear_viscosity = {} }}",
                                   toml(element.hourglass), toml(element.coefficient),
                                   toml(element.quadratic_viscosity), toml(element.linear_viscosity)));
}

}  // namespace pinball

#include <solver/scene/parts.hpp>

namespace pinball {

ElementSettings read_element(const SceneTable& table, const ElementSettings& otherwise) {
  ElementSettings element = otherwise;
  if (table.has("hourglass")) {
    element.hourglass =
        table.choice<HourglassControl>("hourglass", {{"none", HourglassControl::none},
                                                     {"viscous", HourglassControl::viscous},
                                                     {"stiffness", HourglassControl::stiffness},
                                                     {"assumed_strain", HourglassControl::assumed_strain}});
    element.hourglass_coefficient = ElementSettings{}.hourglass_coefficient;
  } else if (table.has("hourglass_coefficient")) {
    // A coefficient that was meant for one form would mean something else to another.
    table.fail("hourglass_coefficient", "needs hourglass beside it, the form that it is a coefficient of");
  }
  element.bulk_viscosity = table.boolean("bulk_viscosity", element.bulk_viscosity);
  table.numbers_into(element);
  if (table.has("negative_volume")) {
    element.negative_volume = table.choice<NegativeVolume>(
        "negative_volume", {{"stop", NegativeVolume::stop}, {"erode", NegativeVolume::erode}});
  }
  if (table.has("inside_out")) {
    element.inside_out = table.choice<InsideOut>(
        "inside_out", {{"warn", InsideOut::warn}, {"erode", InsideOut::erode}, {"stop", InsideOut::stop}});
  }
  complete(element);
  return element;
}

}  // namespace pinball

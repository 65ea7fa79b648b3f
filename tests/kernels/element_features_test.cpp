#include "element_fixture.hpp"

/// Every combination of the compile-time features of the element kernel.
namespace pinball {
namespace {

using namespace test;

/// A feature that is compiled out gives what the full scalar kernel gives with its constants at zero (or infinity).
template <bool plastic, bool erosion, bool viscosity, HourglassKind hourglass>
void compare_features() {
  SCOPED_TRACE(::testing::Message() << plastic << erosion << viscosity << int(hourglass));
  constexpr ElementFeatures features{plastic, erosion, viscosity, hourglass};
  constexpr ElementFeatures full{true, true, true,
                                 hourglass == HourglassKind::none ? HourglassKind::stiffness : hourglass};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ElementScene scene = random_element_scene();
  if (!plastic) {
    scene.constants.material.yield_stress = scene.constants.material.ultimate_stress = infinity;
    scene.constants.failure.plastic_strain = infinity;  // strain stays zero
    scene.constants.never_yields = true;                // else the full kernel has a rate law
    for (ElementState& s : scene.element) s.plastic_strain = 0;
  }
  if (!erosion) {
    scene.constants.failure.plastic_strain = infinity;
    scene.constants.failure.negative_volume = false;
  }
  if (!viscosity) {
    scene.constants.viscosity.linear = scene.constants.viscosity.quadratic = 0;
    for (ElementState& s : scene.element) s.viscous_stress = 0;
  }
  if (hourglass == HourglassKind::none) {
    scene.constants.hourglass.coefficient = 0;
    for (ElementState& s : scene.element) s.hourglass_state = {};
  }
  ElementOutcome expected = advance<double, full>(scene);
  if (!erosion) expected.eroded = 0;
  expect_equal(advance<double, features>(scene), expected, features, 64 * epsilon<double>);
}
template <bool plastic, bool erosion, bool viscosity>
void compare_hourglass_kinds() {
  compare_features<plastic, erosion, viscosity, HourglassKind::none>();
  compare_features<plastic, erosion, viscosity, HourglassKind::viscous>();
  compare_features<plastic, erosion, viscosity, HourglassKind::stiffness>();
  compare_features<plastic, erosion, viscosity, HourglassKind::assumed_strain>();
}
TEST(ElementFeatures, CompiledOutEqualSwitchedOff) {
  compare_hourglass_kinds<false, false, false>();
  compare_hourglass_kinds<false, false, true>();
  compare_hourglass_kinds<false, true, false>();
  compare_hourglass_kinds<false, true, true>();
  compare_hourglass_kinds<true, false, false>();
  compare_hourglass_kinds<true, false, true>();
  compare_hourglass_kinds<true, true, false>();
  compare_hourglass_kinds<true, true, true>();
}

}  // namespace
}  // namespace pinball

#include "element_fixture.hpp"

/// Every combination of the compile-time features of the element kernel.
namespace pinball::element_features_test {
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

/// Where rare cases are compiled out, elements that may fold are left as they are, and all others are worked the same.
TEST(ElementFeatures, RareCasesAreLeftForAnotherKernel) {
  constexpr ElementFeatures all{true, true, true, HourglassKind::stiffness};
  constexpr ElementFeatures usual{true, true, true, HourglassKind::stiffness, YieldLaw::linear, false};
  ElementScene scene = random_element_scene();
  for (std::size_t n = 0; n < 64; ++n) {
    Vec3<double>& x = scene.position[n];
    const Vec3<double> regular{std::round(x.x), std::round(x.y), std::round(x.z)};
    x = regular + 0.2 * (x - regular);
  }
  scene.position[0] = {0.7, 0.7, 0.7};  // of the first element alone
  ElementOutcome expected = advance<double, all>(scene);
  const ElementOutcome found = advance<double, usual>(scene);
  int left = 0;
  for (std::size_t e = 0; e < scene.element.size(); ++e) {
    const ElementState& before = scene.element[e];
    if (before.mass == 0 || found.element[e].internal_energy != before.internal_energy) continue;
    ++left;
    EXPECT_EQ(found.element[e].mass, before.mass);
    EXPECT_EQ(found.element[e].stress.xy, before.stress.xy);
    EXPECT_EQ(found.element[e].plastic_strain, before.plastic_strain);
    expected.element[e] = before;
    for (const std::int32_t node : scene.corner[e]) {
      const auto n = static_cast<std::size_t>(node);
      expected.force[n] = found.force[n];
    }
  }
  EXPECT_EQ(left, 1);
  for (std::size_t e = 0; e < scene.element.size(); ++e) {
    SCOPED_TRACE(e);
    EXPECT_EQ(found.element[e].mass == 0, expected.element[e].mass == 0);
    EXPECT_SYMMETRIC_NEAR(found.element[e].stress, expected.element[e].stress, 1e-13);
    EXPECT_NEAR(found.element[e].internal_energy, expected.element[e].internal_energy, 1e-13);
  }
  for (std::size_t n = 0; n < scene.position.size(); ++n) {
    EXPECT_VECTOR_NEAR(found.force[n], expected.force[n], 1e-12);
  }
}

}  // namespace
}  // namespace pinball::element_features_test

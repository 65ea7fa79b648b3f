#include "element_fixture.hpp"
#include "material/hardening_case.hpp"

/// What is switched off at run time, in the kernels that the program has (solver/elements/element_features.hpp), leaves
/// the bits of a kernel that is compiled without it. Compiled without fused multiplication and addition, which the
/// compiler finds in other places in another kernel.
namespace pinball::element_switches_test {
namespace {

using namespace test;

ElementScene without_viscosity() {
  ElementScene scene = random_element_scene();
  scene.constants.viscosity.linear = scene.constants.viscosity.quadratic = 0;
  return scene;
}

template <bool plastic, bool erosion, HourglassKind kind>
void expect_bits_without_viscosity(const ElementScene& scene) {
  SCOPED_TRACE(::testing::Message() << plastic << erosion << int(kind));
  constexpr ElementFeatures all{plastic, erosion, true, kind};
  expect_equal(advance<double, all>(scene), advance<double, ElementFeatures{plastic, erosion, false, kind}>(scene), all,
               0);
}

template <HourglassKind kind>
void expect_bits_without_viscosity() {
  const ElementScene scene = without_viscosity();
  expect_bits_without_viscosity<false, false, kind>(scene);
  expect_bits_without_viscosity<true, true, kind>(scene);
}

TEST(ElementSwitches, ViscosityWithoutCoefficientsLeavesTheBitsOfAKernelWithout) {
  expect_bits_without_viscosity<HourglassKind::viscous>();
  expect_bits_without_viscosity<HourglassKind::stiffness>();
  expect_bits_without_viscosity<HourglassKind::assumed_strain>();
}

TEST(ElementSwitches, ViscosityWithoutCoefficientsNeedsNoArray) {
  ElementScene scene = without_viscosity();
  scene.has_viscous_stress = false;
  constexpr ElementFeatures all{true, true, true, HourglassKind::assumed_strain};
  EXPECT_EQ((advance<double, all>(scene).viscous), 0);
}

TEST(ElementSwitches, ACoefficientOfEitherKindIsViscosity) {
  constexpr ElementFeatures all{true, true, true, HourglassKind::assumed_strain};
  const double none = advance<double, all>(without_viscosity()).viscous;
  EXPECT_EQ(none, 0);
  ElementScene linear = without_viscosity(), quadratic = without_viscosity();
  linear.constants.viscosity.linear = 0.06;
  quadratic.constants.viscosity.quadratic = 1.2;
  EXPECT_NE((advance<double, all>(linear).viscous), 0);
  EXPECT_NE((advance<double, all>(quadratic).viscous), 0);
}

template <HourglassKind kind>
void expect_bits_without_erosion() {
  SCOPED_TRACE(int(kind));
  const HardeningCase hardening = linear_case(4, 10, 0.5, 4.5);
  ElementScene scene = random_element_scene();
  scene.constants.hardening = hardening.constants;
  scene.constants.failure.plastic_strain = std::numeric_limits<double>::infinity();
  scene.constants.failure.negative_volume = false;
  scene.has_internal_energy = false;
  constexpr ElementFeatures without{true, false, true, kind, YieldLaw::general};
  expect_equal(advance<double, ElementFeatures{true, true, true, kind, YieldLaw::general}>(scene),
               advance<double, without>(scene), without, 0);
}

TEST(ElementSwitches, ErosionThatNeverComesLeavesTheBitsOfAGeneralKernelWithout) {
  expect_bits_without_erosion<HourglassKind::viscous>();
  expect_bits_without_erosion<HourglassKind::assumed_strain>();
}

}  // namespace
}  // namespace pinball::element_switches_test

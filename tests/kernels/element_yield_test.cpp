#include "element_fixture.hpp"
#include "material/hardening_case.hpp"

/// The element kernel with YieldLaw::general.
namespace pinball::element_yield_test {
namespace {

using namespace test;

template <HourglassKind kind>
constexpr ElementFeatures general{true, true, true, kind, YieldLaw::general};
template <HourglassKind kind>
constexpr ElementFeatures linear{true, true, true, kind};

/// random_element_scene with back stresses.
ElementScene hardening_scene(const HardeningCase& hardening) {
  ElementScene scene = random_element_scene();
  Random random(45);
  for (ElementState& state : scene.element) {
    if (state.mass == 0) continue;  // eroded
    for (std::size_t c = 0; c < 5; ++c) state.material[c] = uniform(random, -1, 1);
  }
  scene.constants.hardening = hardening.constants;
  return scene;
}

template <HourglassKind kind>
void expect_isotropic_as_linear() {
  const HardeningCase hardening = linear_case(4, 10, 0, 4.5);  // as random_element_scene has it
  ElementScene scene = random_element_scene();
  scene.constants.hardening = hardening.constants;
  const ElementOutcome expected = advance<double, linear<kind>>(scene), found = advance<double, general<kind>>(scene);
  expect_equal(found, expected, linear<kind>, 1e-13);
  for (const ElementState& state : found.element) {
    for (const double number : state.material) EXPECT_EQ(number, 0);
  }
}

TEST(GeneralYieldOfElements, IsThatOfMaterialConstantsWhereItIsLinearAndIsotropic) {
  expect_isotropic_as_linear<HourglassKind::none>();
  expect_isotropic_as_linear<HourglassKind::viscous>();
  expect_isotropic_as_linear<HourglassKind::stiffness>();
  expect_isotropic_as_linear<HourglassKind::assumed_strain>();
}

template <HourglassKind kind>
void expect_packs_as_lanes(const HardeningCase& hardening) {
  const ElementScene scene = hardening_scene(hardening);
  const ElementOutcome expected = advance<double, general<kind>>(scene);
  const ElementOutcome found = advance<Pack<double, 8>, general<kind>>(scene);
  expect_equal(found, expected, general<kind>, 1e-13);
  bool moved = false;
  for (std::size_t e = 0; e < expected.element.size(); ++e) {
    for (std::size_t c = 0; c < material_numbers; ++c) {
      EXPECT_NEAR(found.element[e].material[c], expected.element[e].material[c], 1e-13);
    }
    moved = moved || expected.element[e].plastic_strain > scene.element[e].plastic_strain;
  }
  EXPECT_TRUE(moved);
}

TEST(GeneralYieldOfElements, PacksGiveWhatTheirLanesGive) {
  HardeningCase rates = curve_case({0, 0.01, 0.1}, {2, 3, 4});
  rates.constants.measure = StrainRateMeasure::plastic;
  rates.constants.rate_constant = 3, rates.constants.rate_exponent = 4;
  const HardeningCase mixed = linear_case(3, 4, 6);
  for (const HardeningCase* hardening : {&std::as_const(rates), &mixed}) {
    expect_packs_as_lanes<HourglassKind::none>(*hardening);
    expect_packs_as_lanes<HourglassKind::viscous>(*hardening);
    expect_packs_as_lanes<HourglassKind::stiffness>(*hardening);
    expect_packs_as_lanes<HourglassKind::assumed_strain>(*hardening);
  }
}

TEST(GeneralYieldOfElements, MayHaveNoBackStress) {
  const HardeningCase hardening = linear_case(4, 10, 0, 4.5);
  ElementScene scene = random_element_scene();
  scene.constants.hardening = hardening.constants;
  const ElementOutcome with = advance<double, general<HourglassKind::assumed_strain>>(scene);
  scene.has_material_state = false;
  expect_equal(advance<double, general<HourglassKind::assumed_strain>>(scene), with,
               general<HourglassKind::assumed_strain>, 0);
}

TEST(BackStress, TurnsWithARigidRotation) {
  const HardeningCase hardening = linear_case(1e3, 4, 6);
  constexpr ElementFeatures features{true, false, false, HourglassKind::none, YieldLaw::general};
  Random random(46);
  const Corners x0 = random_hexahedron(random);
  const Vec3<double> axis = random_direction(random);
  ElementScene scene;
  Corners still;
  still.fill({0, 0, 0});
  ElementState state;
  state.mass = 3 * quadrature_gradient(x0).volume;
  state.stress = random_symmetric(random, 100);
  state.material = {3, -5, 2, 7, -4};
  scene.add(x0, still, state);
  scene.constants = element_constants();
  scene.constants.hardening = hardening.constants;
  constexpr double angle = 0.7;
  ElementOutcome out;
  for (int n = 1; n <= 50; ++n) {
    const Tensor<double> r = rotation_matrix(axis, n * angle);
    for (std::size_t i = 0; i < 8; ++i) {
      const Vec3<double> next = r * x0[i];
      scene.velocity[i] = (1 / scene.dt) * (next - scene.position[i]);
      scene.position[i] = next;
    }
    out = advance<double, features>(scene);
    scene.element = out.element;
  }
  const Symmetric<double> back{3, -5, 2, 2, 7, -4};
  const Symmetric<double> expected = rotate(Rotation<double>{rotation_matrix(axis, 50 * angle)}, back);
  const std::array<double, material_numbers>& found = out.element[0].material;
  EXPECT_SYMMETRIC_NEAR((Symmetric<double>{found[0], found[1], -(found[0] + found[1]), found[2], found[3], found[4]}),
                        expected, 1e-11);
  EXPECT_SYMMETRIC_NEAR(out.element[0].stress,
                        rotate(Rotation<double>{rotation_matrix(axis, 50 * angle)}, state.stress), 1e-10);
  EXPECT_EQ(out.element[0].plastic_strain, 0);
}

/// A step of no length has no strains, and would ask for rates that are not those of the stress.
TEST(GeneralYieldOfElements, AStepOfNoLengthChangesNothing) {
  HardeningCase hardening = linear_case(1, 0, 6);
  hardening.constants.measure = StrainRateMeasure::plastic;
  hardening.constants.rate_constant = 3, hardening.constants.rate_exponent = 4;
  ElementScene scene = hardening_scene(hardening);
  scene.dt = 0;
  scene.constants.failure.negative_volume = false;
  const ElementOutcome out = advance<double, general<HourglassKind::assumed_strain>>(scene);
  for (std::size_t e = 0; e < 9; ++e) {
    const ElementState &now = out.element[e], &before = scene.element[e];
    if (now.mass == 0) continue;  // eroded
    EXPECT_SYMMETRIC_NEAR(now.stress, before.stress, 0);
    EXPECT_EQ(now.plastic_strain, before.plastic_strain);
    for (std::size_t c = 0; c < 5; ++c) EXPECT_NEAR(now.material[c], before.material[c], 1e-15);
  }
}

}  // namespace
}  // namespace pinball::element_yield_test

#include "one_element.hpp"

/// Elements that erode, and those that have lost their volume.
namespace pinball::element_erosion_test {
namespace {

using namespace test;

constexpr ElementFeatures elastic{false, false, false, HourglassKind::none};
constexpr ElementFeatures eroding{true, true, true, HourglassKind::stiffness};

TEST(ElementErosion, ReleasesTheElementAndItsEnergy) {
  Random random(136);
  ElementScene scene = one_element(random_hexahedron(random));
  scene.constants.failure.plastic_strain = 0.5;
  scene.constants.hourglass.coefficient = 0.1;
  scene.element[0].stress = random_symmetric(random, 10);
  scene.element[0].hourglass_state.fill({1, 2, 3});
  scene.element[0].internal_energy = 7;
  scene.element[0].plastic_strain = 0.5;  // not above: stays
  ElementOutcome out = advance<double, eroding>(scene);
  EXPECT_EQ(out.eroded_count, 0);
  EXPECT_EQ(out.eroded, 0);
  EXPECT_GT(out.element[0].mass, 0);
  scene.element[0].plastic_strain = 0.5001;
  out = advance<double, eroding>(scene);  // at rest: no work in the step
  EXPECT_EQ(out.eroded_count, 1);
  EXPECT_EQ(out.inverted_count, 0);
  // With the element goes what its hourglass modes store: 8/3 V_0/(kappa M) sum_a Z_a.Z_a, M = 2 mu + lambda
  const double stored = 8.0 / 3.0 * scene.element[0].mass / 3 / (0.1 * 310) * 4 * 14;
  EXPECT_NEAR(out.eroded, 7 + stored, 1e-13 * stored);
  EXPECT_NEAR(out.hourglass, -stored, 1e-13 * stored);
  EXPECT_EQ(out.element[0].mass, 0);
  EXPECT_EQ(norm(out.element[0].stress), 0);
  for (const Vec3<double>& q : out.element[0].hourglass_state) EXPECT_EQ(norm(q), 0);
  for (const Vec3<double>& f : out.force) EXPECT_EQ(norm(f), 0);
  EXPECT_GT(out.time_step, 1e300);  // does not limit the step

  // And does nothing from then on.
  scene.element = out.element;
  for (Vec3<double>& v : scene.velocity) v = random_vector(random, 100);
  out = advance<double, eroding>(scene);
  EXPECT_EQ(out.eroded_count, 0);
  EXPECT_EQ(out.eroded, 0);
  EXPECT_EQ(out.internal, 0);
  EXPECT_EQ(out.hourglass, 0);
  for (const Vec3<double>& f : out.force) EXPECT_EQ(norm(f), 0);
}

TEST(ElementErosion, CountsTheWorkOfItsLastStep) {
  ElementScene scene = one_element(box(1, 1, 1));
  scene.constants.failure.plastic_strain = 0.1;
  scene.element[0].plastic_strain = 0.2;
  scene.element[0].internal_energy = 7;
  scene.element[0].stress = {10, 0, 0, 0, 0, 0};
  move_to(scene, box(1.01, 1, 1));
  const ElementOutcome out = advance<double, eroding>(scene);
  const double work = 1.005 * 0.5 * 10 * (0.01 / 1.005);  // mid-step volume, half the old stress, strain
  EXPECT_NEAR(out.internal, work, 1e-15);
  EXPECT_NEAR(out.eroded, 7 + work, 1e-14);
}

TEST(ElementInversion, IsErodedOrCountedAsTheSceneSays) {
  Corners x = box(1, 1, 1);
  for (std::size_t i = 0; i < 4; ++i) std::swap(x[i], x[i + 4]);
  ElementScene scene = one_element(x);
  scene.element[0].mass = 3;
  scene.constants.failure.negative_volume = true;
  ElementOutcome out = advance<double, eroding>(scene);
  EXPECT_EQ(out.eroded_count, 1);
  EXPECT_EQ(out.inverted_count, 0);
  EXPECT_EQ(out.element[0].mass, 0);
  scene.constants.failure.negative_volume = false;
  out = advance<double, eroding>(scene);
  EXPECT_EQ(out.eroded_count, 0);
  EXPECT_EQ(out.inverted_count, 1);
  EXPECT_EQ(out.element[0].mass, 3);
  scene.constants.failure.negative_volume = true;  // without erosion compiled in: counted
  EXPECT_EQ((advance<double, elastic>(scene).inverted_count), 1);
}

TEST(ElementInversion, OfNoVolumeLeavesNothingBad) {
  ElementScene scene = one_element(box(1, 1, 1));
  scene.constants.hourglass.coefficient = 0.1;
  scene.constants.viscosity.linear = 0.06, scene.constants.viscosity.quadratic = 1.2;
  scene.constants.failure.negative_volume = true;
  scene.element[0].stress = {1, 2, 3, 4, 5, 6};
  scene.element[0].plastic_strain = 0.25;
  scene.element[0].internal_energy = 7;
  move_to(scene, box(1, 1, 0));
  const ElementOutcome out = advance<double, eroding>(scene);
  EXPECT_EQ(out.eroded_count, 1);
  EXPECT_EQ(norm(out.element[0].stress), 0);
  EXPECT_EQ(out.internal, 0);
  EXPECT_EQ(out.hourglass, 0);
  EXPECT_EQ(out.viscous, 0);
  EXPECT_EQ(out.eroded, 7);
  EXPECT_TRUE(std::isfinite(out.element[0].plastic_strain));
  for (const Vec3<double>& f : out.force) EXPECT_EQ(norm(f), 0);
}

TEST(ElementInversion, OfAVolumeThatIsNotANumberIsReportedAndNotEroded) {
  Corners x = box(1, 1, 1);
  x[3].y = std::numeric_limits<double>::quiet_NaN();
  ElementScene scene = one_element(box(1, 1, 1));
  scene.constants.failure.negative_volume = true;
  move_to(scene, x);
  const ElementOutcome out = advance<double, eroding>(scene);
  EXPECT_EQ(out.eroded_count, 0);
  EXPECT_EQ(out.inverted_count, 1);
}

}  // namespace
}  // namespace pinball::element_erosion_test

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/model/mesh_rounding.hpp>
#include <solver/model/model.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/solver_case.hpp>

/// Meshes that a precision cannot hold where they lie.
namespace pinball::mesh_rounding_test {
namespace {

using namespace test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double h = 0.025;

Scene block_at(const Point& place, Precision precision) {
  Scene scene = scene_of({block("a", {4, 4, 4}, h, place)}, 1e-4, false);
  scene.precision = precision;
  return scene;
}

std::string refusal(const Scene& scene) {
  return error_of([&] { build_mesh(scene); });
}

TEST(MeshRounding, OfACubeFollowsFromItsPlaceAndItsSize) {
  const double x = 1000, low = 0.5 * h;
  std::array<Point, 8> corners{};
  for (int i = 0; i < 8; ++i) {
    const int bit_x = (i & 1) ^ (i >> 1 & 1), bit_y = i >> 1 & 1, bit_z = i >> 2;
    corners[i] = {x + (bit_x - 0.5) * h, (bit_y - 0.5) * h, (bit_z - 0.5) * h};
  }
  const double expected = (x + 3 * low) / h;
  EXPECT_NEAR(relative_rounding(corners, Precision::float64), 0x1p-52 * expected, 1e-6 * 0x1p-52 * expected);
  EXPECT_NEAR(relative_rounding(corners, Precision::float32), 0x1p-23 * expected, 1e-6 * 0x1p-23 * expected);
}

/// What is thin across a direction in which it does not lie far away is held well.
TEST(MeshRounding, AThinPlateMayLieFarAwayInItsPlane) {
  Scene scene = scene_of({block("a", {1, 1, 1}, 1, {100, 0, 0})}, 1e-4, false);
  scene.precision = Precision::float32;
  scene.bodies[0].mesh = BlockMesh{{1, 1, 1e-4}, {1, 1, 1}};
  EXPECT_EQ(refusal(scene), no_error);
  scene.bodies[0].position = {0, 0, 100};
  EXPECT_THAT(refusal(scene), HasSubstr("too small for a place so far from the origin"));
}

TEST(MeshRounding, PlacesThatChangeTheMassAreRefused) {
  for (const double x : {1e10, 1e12, 1e14, 1e15, 1e20, 1e200, 1e308}) {
    EXPECT_THAT(refusal(block_at({x, 0, 0}, Precision::float64)),
                AllOf(HasSubstr("body a: element 0 at ("), HasSubstr("double precision"), HasSubstr("move the origin"),
                      Not(HasSubstr("or choose"))))
        << x;
  }
  for (const double x : {3e2, 3e5, 1e30, 1e300}) {
    EXPECT_THAT(refusal(block_at({0, x, x}, Precision::float32)),
                AllOf(HasSubstr("single precision"), HasSubstr("precision = \"double\"")))
        << x;
  }
}

TEST(MeshRounding, PlacesAMillionElementsAwayAreTaken) {
  for (const double sizes : {1.0, 1e3, 1e6, 1e8}) {
    const Scene scene = block_at({sizes * h, -sizes * h, sizes * h}, Precision::float64);
    EXPECT_EQ(refusal(scene), no_error);
    double volume = 0;
    const ModelMesh mesh = build_mesh(scene);
    for (std::size_t e = 0; e < 64; ++e) volume += element_volume(mesh, e);
    EXPECT_NEAR(volume, 1e-3, 1e-9);
  }
  EXPECT_EQ(refusal(block_at({1000 * h, 1000 * h, 0}, Precision::float32)), no_error);
  EXPECT_EQ(refusal(block_at({1e8 * h, 1e8 * h, 0}, Precision::mixed)), no_error) << "nodes are as in double";
}

std::string refusal(double size, Precision precision) {
  Scene scene = block_at({0, 0, 0}, precision);
  scene.bodies[0].mesh = BlockMesh{{size, size, size}, {1, 1, 1}};
  return refusal(scene);
}

TEST(MeshRounding, VolumesHaveToBeHeldByThePrecision) {
  for (const double size : {1e-300, 1e-60, 1e60, 1e100, 1e300}) {
    EXPECT_THAT(refusal(size, Precision::float64), HasSubstr("expected another unit of length")) << size;
  }
  for (const double size : {1e-40, 1e-7, 1e7, 1e30}) {
    EXPECT_THAT(refusal(size, Precision::float32), HasSubstr("or precision = \"double\"")) << size;
    EXPECT_THAT(refusal(size, Precision::mixed), HasSubstr("or precision = \"double\"")) << size;
    EXPECT_EQ(refusal(size, Precision::float64), no_error) << size;
  }
  for (const double size : {1e-6, 1.0, 1e6}) EXPECT_EQ(refusal(size, Precision::float32), no_error) << size;
}

TEST(MeshRounding, MaterialsHaveToBeHeldByThePrecision) {
  const auto refused = [](auto change, auto build) {
    Scene scene = block_at({0, 0, 0}, Precision::float32);
    change(scene.materials[0]);
    return error_of([&] { build(scene); });
  };
  const auto in_double = [](const Scene& scene) { build_model<double>(scene); };
  const auto in_float = [](const Scene& scene) { build_model<float>(scene); };
  const auto soft = [](Material& m) { m.bulk_modulus = m.shear_modulus = 1e-100; };
  EXPECT_THAT(refused(soft, in_float), HasSubstr("material.steel: bulk_modulus = 1e-100 is beyond single precision"));
  EXPECT_EQ(refused(soft, in_double), no_error);
  const auto stiff = [](Material& m) { m.shear_modulus = 1e39; };
  EXPECT_THAT(refused(stiff, in_float), HasSubstr("shear_modulus = 1e+39"));
  EXPECT_EQ(refused(stiff, in_double), no_error);
  const auto light = [](Material& m) { m.density = 1e-310; };
  EXPECT_THAT(refused(light, in_double),
              HasSubstr("density = 1e-310 is beyond double precision: expected other units"));
}

TEST(MeshRounding, AFlatElementIsCalledFlat) {
  Scene scene = block_at({1e3, 0, 0}, Precision::float64);
  scene.bodies[0].mesh = BlockMesh{{1, 1, 1e-13}, {1, 1, 1}};
  EXPECT_THAT(refusal(scene), HasSubstr("inverted or flat: its volume is 1e-13, expected more than 2.83e-12, 1e-12 of "
                                        "the cube of its size 1.41"));
}

}  // namespace
}  // namespace pinball::mesh_rounding_test

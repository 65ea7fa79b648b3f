#include "element_fixture.hpp"

/// The element kernel over packs against its scalar instantiation: every width, padding, bad numbers.
namespace pinball::element_update_pack_test {
namespace {

using namespace test;

constexpr ElementFeatures everything{true, true, true, HourglassKind::stiffness};
constexpr ElementFeatures viscous{false, false, false, HourglassKind::viscous};

/// The last pack is wider than any register: it lives in memory.
using Types = ::testing::Types<double, float, Pack<double, 2>, Pack<double, 4>, Pack<double, 8>, Pack<float, 4>,
                               Pack<float, 8>, Pack<float, 16>, Pack<double, 16>>;
template <class T>
class ElementPack : public ::testing::Test {};
TYPED_TEST_SUITE(ElementPack, Types);

TYPED_TEST(ElementPack, EqualsTheScalarKernel) {
  using T = TypeParam;
  const ElementScene scene = random_element_scene();
  const double tolerance = 64 * epsilon<ScalarOf<T>>;
  const ElementOutcome expected = advance<double, everything>(scene);
  EXPECT_EQ(expected.eroded_count, 4);
  expect_equal(advance<T, everything>(scene), expected, everything, tolerance);
  expect_equal(advance<T, viscous>(scene), advance<double, viscous>(scene), viscous, tolerance);
}

TYPED_TEST(ElementPack, DoesNotDependOnItsPadding) {
  ElementScene scene = random_element_scene();
  const ElementOutcome with_nan = advance<TypeParam, everything>(scene);
  for (const double padding : {0.0, 1e30, std::numeric_limits<double>::infinity()}) {
    scene.padding = padding;
    expect_equal(advance<TypeParam, everything>(scene), with_nan, everything, 0);  // to the bit
  }
}

TYPED_TEST(ElementPack, GivesNaNForNaN) {  // a bad node stays visible, and only where it belongs
  ElementScene scene = random_element_scene();
  scene.constants.failure.negative_volume = false;
  const ElementOutcome good = advance<TypeParam, everything>(scene);
  scene.position.back().x = std::numeric_limits<double>::quiet_NaN();  // of the element by itself
  const ElementOutcome bad = advance<TypeParam, everything>(scene);
  EXPECT_EQ(bad.inverted_count, 1);
  EXPECT_TRUE(std::isnan(bad.element.back().stress.xx));
  EXPECT_TRUE(std::isnan(bad.force.back().x));
  for (std::size_t n = 0; n < 64; ++n) EXPECT_VECTOR_NEAR(bad.force[n], good.force[n], 0);
  EXPECT_EQ(bad.time_step, good.time_step);
}

}  // namespace
}  // namespace pinball::element_update_pack_test

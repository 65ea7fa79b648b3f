#include <kernels/pinball.hpp>
#include <tests/support/support.hpp>

namespace pinball::pinball_test {
namespace {

using namespace test;
using V = Vec3<double>;

constexpr V none{0, 0, 0}, up{0, 0, 1}, down{0, 0, -1};

V unit(const V& v) { return (1 / norm(v)) * v; }

/// Independent scalar implementation of the rule for the direction, with branches and angles.
V expected_direction(const V& d, const V& n1, const V& n2) {
  const V mean = 0.5 * (n2 - n1);
  if (norm(mean) < 0.2) return unit(d);
  return dot(unit(mean), unit(d)) >= std::sqrt(0.9045) ? unit(mean) : unit(d);  // 18 degrees
}

/// Whether the normals let the pair touch: they do not look the same way, or each looks at the other.
bool opposed(const V& d, const V& n1, const V& n2) {
  if (dot(n1, n2) <= 0.3) return true;
  return dot(n1, unit(-1.0 * d)) > 0.2 && dot(n2, unit(d)) > 0.2;
}

TEST(Penetration, MovesTheBallsApartToTheirReach) {  // |d + g n| = R1 + R2
  Random random(91);
  int active = 0, along_normals = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const V d = random_vector(random, 1.2), n1 = random_direction(random), n2 = random_direction(random);
    const double reach = uniform(random, 0.5, 1.5);
    const Penetration<double> p = penetration(d, reach, n1, n2);
    ASSERT_TRUE(std::isfinite(p.depth));
    ASSERT_NEAR(norm(p.direction), 1, 1e-15);
    ASSERT_EQ(p.active, norm(d) < reach && opposed(d, n1, n2));
    if (!p.active) continue;
    ++active;
    ASSERT_GT(p.depth, 0);
    ASSERT_NEAR(norm(d + p.depth * p.direction), reach, 1e-14);
    ASSERT_NEAR(norm(p.direction - expected_direction(d, n1, n2)), 0, 1e-14);
    const V apart = d + p.depth * p.direction;  // reach times e
    ASSERT_NEAR(norm(p.gradient - (1 / dot(apart, p.direction)) * apart), 0, 1e-13);
    along_normals += norm(p.direction - unit(d)) > 1e-6;
  }
  EXPECT_GT(active, 2000);
  EXPECT_GT(along_normals, 100);
}

TEST(Penetration, EqualsTheWorkedExample) {
  const Penetration<double> p = penetration(V{.3, .1, 1}, 1.3, down, up);
  EXPECT_TRUE(p.active);
  EXPECT_NEAR(p.depth, std::sqrt(1.59) - 1, 1e-15);  // b = 1, c = -0.59
  EXPECT_VECTOR_NEAR(p.direction, up, 0);
}

TEST(Penetration, UsesTheNormalsWithin18DegreesOfTheLineOfCentres) {
  for (const double cosine : {0.95, 0.952}) {
    const V d{0.5 * std::sqrt(1 - cosine * cosine), 0, 0.5 * cosine};
    const Penetration<double> p = penetration(d, 1.0, down, up);
    EXPECT_TRUE(p.active);
    EXPECT_VECTOR_NEAR(p.direction, cosine > 0.951 ? up : unit(d), 1e-15);
  }
}

TEST(Penetration, GradientIsTheDerivativeOfTheDepth) {  // gdot = -gradient.(V1 - V2), by central differences
  const V d{.3, .1, 1}, v{.4, -.2, -.5};
  const double h = 1e-6;
  const double later = penetration(d + h * v, 1.3, down, up).depth,
               before = penetration(d - h * v, 1.3, down, up).depth;
  const Penetration<double> p = penetration(d, 1.3, down, up);
  EXPECT_NEAR(-dot(p.gradient, v), (later - before) / (2 * h), 1e-9);
  EXPECT_NEAR(-dot(p.gradient, v), 0.4207, 5e-5);  // the exact rate of the worked example; (3.10) gives 0.5
}

TEST(Penetration, HeadOnIsTheOverlap) {
  for (const double gap : {1e-12, 1e-6, 0.1, 0.9}) {
    const Penetration<double> p = penetration(V{0, 0, 1 - gap}, 1.0, down, up);
    EXPECT_TRUE(p.active);
    EXPECT_NEAR(p.depth, gap, 4e-16);
  }
}

TEST(Penetration, NeedsOverlapAlsoWhereTheLineMissesTheBall) {
  for (const double distance : {1.0, 1.0000001, 2.0, 1e6}) {  // b = 0: b^2 - c is negative
    const Penetration<double> p = penetration(V{distance, 0, 0}, 1.0, down, up);
    EXPECT_FALSE(p.active);
    EXPECT_FALSE(std::isnan(p.depth));
  }
  EXPECT_FALSE(penetration(V{0, 0, 1}, 1.0, down, up).active);  // they only touch
  EXPECT_TRUE(penetration(V{0, 0, std::nextafter(1.0, 0.0)}, 1.0, down, up).active);
}

TEST(Penetration, IsAccurateInSinglePrecision) {
  Random random(92);
  for (int trial = 0; trial < 5000; ++trial) {
    const double reach = uniform(random, 0.5, 1.5);
    const Vec3<float> d{float(uniform(random, -.3, .3) * reach), float(uniform(random, -.3, .3) * reach),
                        float(uniform(random, 0.3, 1) * reach)};
    const Penetration<float> p = penetration(d, float(reach), {0.f, 0.f, -1.f}, {0.f, 0.f, 1.f});
    const Penetration<double> q = penetration(V{d.x, d.y, d.z}, double(float(reach)), down, up);
    if (!p.active || !q.active) continue;
    EXPECT_NEAR(p.depth, q.depth, 4 * epsilon<float> * reach);
  }
}

TEST(Penetration, OfCoincidentCentres) {
  EXPECT_FALSE(penetration(none, 1.0, none, none).active);  // no direction at all
  const Penetration<double> p = penetration(none, 1.0, down, up);
  EXPECT_TRUE(p.active);
  EXPECT_NEAR(p.depth, 1, 1e-15);
  EXPECT_VECTOR_NEAR(p.direction, up, 0);
}

TEST(Penetration, IgnoresNormalsThatLookTheSameWay) {
  EXPECT_FALSE(penetration(V{0.1, 0, 0.5}, 1.0, up, up).active);
  const auto at = [](double cosine) { return V{std::sqrt(1 - cosine * cosine), 0, cosine}; };
  EXPECT_FALSE(penetration(V{0.1, 0, 0.5}, 1.0, at(0.31), up).active);
  EXPECT_TRUE(penetration(V{0.1, 0, 0.5}, 1.0, at(0.29), up).active);
  EXPECT_TRUE(penetration(V{0.1, 0, 0.5}, 1.0, down, up).active);
}

TEST(Penetration, TakesCornersThatMeetFaceToFace) {
  // The outermost elements of two equal blocks, one on the other: edges with n1.n2 = 0, corners with 1/3, and those of
  // elements twice as tall as wide, whose normals are area-weighted, with 7/9.
  const V d{0, 0, 0.9};
  for (const double height : {1.0, 2.0}) {
    const V lower = unit(V{height, height, 1}), upper = unit(V{height, height, -1});
    EXPECT_TRUE(penetration(d, 1.0, upper, lower).active);
    EXPECT_FALSE(penetration(-1.0 * d, 1.0, upper, lower).active);  // back to back
  }
}

TEST(Penetration, WithoutNormalsIsAlongTheLineOfCentres) {
  Random random(93);
  for (int trial = 0; trial < 100; ++trial) {
    const double distance = uniform(random, 0.01, 0.99);
    const V d = distance * random_direction(random);
    const Penetration<double> p = penetration(d, 1.0, none, none);
    EXPECT_TRUE(p.active);
    EXPECT_NEAR(p.depth, 1 - distance, 1e-15);
    EXPECT_VECTOR_NEAR(p.direction, unit(d), 1e-15);
  }
}

TEST(Penetration, WithOneNormalIsAlongIt) {
  const Penetration<double> p = penetration(V{0.1, 0, 0.4}, 1.0, none, up);
  EXPECT_TRUE(p.active);
  EXPECT_VECTOR_NEAR(p.direction, up, 0);
  EXPECT_VECTOR_NEAR(penetration(V{0.1, 0, 0.4}, 1.0, down, none).direction, up, 0);
}

TEST(Penetration, OfCentresThatHavePassedIsAlongTheLineOfCentres) {  // never pushed through
  const Penetration<double> p = penetration(V{0, 0, -0.3}, 1.0, down, up);
  EXPECT_TRUE(p.active);
  EXPECT_NEAR(p.depth, 0.7, 1e-15);
  EXPECT_VECTOR_NEAR(p.direction, down, 1e-15);
}

TEST(Penetration, IsTheSameToTheBitFromBothSides) {
  Random random(94);
  for (int trial = 0; trial < 5000; ++trial) {
    const V d = random_vector(random, 0.6), n1 = random_direction(random), n2 = random_direction(random);
    const Penetration<double> a = penetration(d, 1.0, n1, n2), b = penetration(-1.0 * d, 1.0, n2, n1);
    ASSERT_EQ(a.active, b.active);
    ASSERT_EQ(a.depth, b.depth);
    ASSERT_EQ(a.direction.x, -b.direction.x);
    ASSERT_EQ(a.direction.y, -b.direction.y);
    ASSERT_EQ(a.direction.z, -b.direction.z);
  }
}

// Faces: xi-, xi+, eta-, eta+, zeta-, zeta+ of a box of edges 2, 3, 5: areas 15, 10, 6.
PinballNormal<double> box_normal(std::initializer_list<int> faces, double bar = 0) {
  double exposed[6] = {0, 0, 0, 0, 0, 0};
  for (const int f : faces) exposed[f] = 1;
  return pinball_normal(modes<double>(box(2, 3, 5)), exposed, bar);
}
void expect_normal(const PinballNormal<double>& n, const V& outward, const V& two_sided) {
  EXPECT_VECTOR_NEAR(n.outward, outward, 2e-14);
  EXPECT_VECTOR_NEAR(n.two_sided, two_sided, 2e-14);
}

TEST(PinballNormal, FollowsFromTheExposedFaces) {
  {
    SCOPED_TRACE("interior");
    expect_normal(box_normal({}), none, none);
  }
  {
    SCOPED_TRACE("one face each");
    expect_normal(box_normal({0}), {-15, 0, 0}, none);
    expect_normal(box_normal({1}), {15, 0, 0}, none);
    expect_normal(box_normal({2}), {0, -10, 0}, none);
    expect_normal(box_normal({3}), {0, 10, 0}, none);
    expect_normal(box_normal({4}), {0, 0, -6}, none);
    expect_normal(box_normal({5}), {0, 0, 6}, none);
  }
  {
    SCOPED_TRACE("edge and corner");
    expect_normal(box_normal({1, 3}), {15, 10, 0}, none);
    expect_normal(box_normal({0, 3, 4}), {-15, 10, -6}, none);
  }
  {
    SCOPED_TRACE("plate one element thick: inside, at an edge, at a corner");
    expect_normal(box_normal({4, 5}), none, {0, 0, 6});
    expect_normal(box_normal({4, 5, 1}), {15, 0, 0}, {0, 0, 6});
    expect_normal(box_normal({4, 5, 1, 2}), {15, -10, 0}, {0, 0, 6});
  }
  {
    SCOPED_TRACE("bar one element thick: inside, at its end");
    expect_normal(box_normal({2, 3, 4, 5}), none, none);
    expect_normal(box_normal({2, 3, 4, 5, 0}), {-15, 0, 0}, none);
  }
  {
    SCOPED_TRACE("the same of a bar that erosion has not made");
    expect_normal(box_normal({2, 3, 4, 5}, 1), none, none);
    expect_normal(box_normal({2, 3, 4, 5, 0}, 1), {-15, 0, 0}, {15, 0, 0});
  }
  {
    SCOPED_TRACE("single element");
    expect_normal(box_normal({0, 1, 2, 3, 4, 5}), none, none);
    expect_normal(box_normal({0, 1, 2, 3, 4, 5}, 1), none, none);
  }
}

TEST(PinballNormal, OfADistortedFaceIsItsAreaVector) {
  Random random(95);
  for (int trial = 0; trial < 20; ++trial) {
    const Corners x = random_hexahedron(random);
    const double exposed[6] = {0, 0, 0, 0, 0, 1};
    const PinballNormal<double> n = pinball_normal(modes<double>(x), exposed);
    EXPECT_VECTOR_NEAR(n.outward, 0.5 * cross(x[6] - x[4], x[7] - x[5]), 2e-15);
  }
}

TEST(UnitNormal, OfAPlateLooksAtThePartner) {
  const PinballNormal<double> plate = box_normal({4, 5});
  EXPECT_VECTOR_NEAR(unit_normal_towards(plate, V{5, 1, 0.1}), up, 1e-15);
  EXPECT_VECTOR_NEAR(unit_normal_towards(plate, V{5, 1, -0.1}), down, 1e-15);
  const PinballNormal<double> edge = box_normal({4, 5, 1});
  EXPECT_VECTOR_NEAR(unit_normal_towards(edge, V{0, 0, 1}), unit({15, 0, 6}), 1e-15);
  EXPECT_VECTOR_NEAR(unit_normal_towards(edge, V{0, 0, -1}), unit({15, 0, -6}), 1e-15);
}

/// Two bars whose ends are flush lie on each other.
TEST(UnitNormal, OfTheEndOfABarIsForPartnersInFrontAlone) {
  const PinballNormal<double> end = box_normal({2, 3, 4, 5, 1}, 1);
  for (const V& front : {V{1, 0, 0}, V{0.1, 2, 3}}) {
    EXPECT_VECTOR_NEAR(unit_normal_towards(end, front), (V{1, 0, 0}), 1e-15);
  }
  for (const V& beside : {V{0, 0, 1}, V{0, -1, 2}, V{-0.1, 1, 0}, V{-1, 0, 0}}) {
    EXPECT_VECTOR_NEAR(unit_normal_towards(end, beside), none, 0);
  }
  const V d{0, 0, 5};
  const Penetration<double> flush =
      penetration(d, 6.0, unit_normal_towards(end, (-1.0) * d), unit_normal_towards(end, d));
  EXPECT_TRUE(flush.active);
  EXPECT_NEAR(flush.depth, 1, 1e-12);
  EXPECT_VECTOR_NEAR(flush.direction, (V{0, 0, 1}), 1e-15);
}

TEST(UnitNormal, OfASurfaceDoesNotDependOnThePartner) {
  const PinballNormal<double> face = box_normal({3});
  for (const V& to : {V{0, 1, 0}, V{0, -1, 0}, V{1, 2, 3}, none}) {
    EXPECT_VECTOR_NEAR(unit_normal_towards(face, to), (V{0, 1, 0}), 1e-15);
  }
  EXPECT_VECTOR_NEAR(unit_normal_towards(PinballNormal<double>{none, none}, V{1, 2, 3}), none, 0);
}

template <class T>
class PinballPack : public ::testing::Test {};
TYPED_TEST_SUITE(PinballPack, NumberTypes);

TYPED_TEST(PinballPack, EqualsTheScalarKernelLaneByLane) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  Random random(96);
  std::vector<V> d, n1, n2;
  for (int i = 0; i < width_of<T>; ++i) {
    d.push_back(i == 1 ? none : random_vector(random, 0.8));  // one lane of coincident centres, one without normals
    n1.push_back(i <= 2 ? none : random_direction(random));
    n2.push_back(i <= 2 ? none : random_direction(random));
  }
  const Vec3<T> dp = vector_from_lanes<T>([&](int i) { return d[std::size_t(i)]; });
  const Vec3<T> n1p = vector_from_lanes<T>([&](int i) { return n1[std::size_t(i)]; });
  const Vec3<T> n2p = vector_from_lanes<T>([&](int i) { return n2[std::size_t(i)]; });
  const Penetration<T> p = penetration(dp, T(1), n1p, n2p);
  const Vec3<T> towards = unit_normal_towards(PinballNormal<T>{n1p, n2p}, dp);
  const T active = select(p.active, T(1), T(0));
  for (int i = 0; i < width_of<T>; ++i) {
    const Penetration<S> q = penetration(lane_of(dp, i), S(1), lane_of(n1p, i), lane_of(n2p, i));
    EXPECT_EQ(lane(active, i) == S(1), q.active);
    EXPECT_NEAR(lane(p.depth, i), q.depth, 16 * epsilon<S>);
    EXPECT_VECTOR_NEAR(lane_of(p.direction, i), q.direction, 8 * epsilon<S>);
    EXPECT_VECTOR_NEAR(lane_of(towards, i),
                       unit_normal_towards(PinballNormal<S>{lane_of(n1p, i), lane_of(n2p, i)}, lane_of(dp, i)),
                       8 * epsilon<S>);
  }
}

TYPED_TEST(PinballPack, NormalsOfDifferentFaces) {
  using T = TypeParam;
  const HexahedronModes<T> x = modes_from_lanes<T>(std::vector<Corners>(width_of<T>, box(2, 3, 5)));
  T exposed[6];
  for (int f = 0; f < 6; ++f) exposed[f] = from_lanes<T>([f](int i) { return (i * 11 + 5) >> f & 1; });
  const PinballNormal<T> n = pinball_normal(x, exposed);
  for (int i = 0; i < width_of<T>; ++i) {
    double faces[6];
    for (int f = 0; f < 6; ++f) faces[f] = (i * 11 + 5) >> f & 1;
    const PinballNormal<double> expected = pinball_normal(modes<double>(box(2, 3, 5)), faces);
    EXPECT_VECTOR_NEAR(lane_of(n.outward, i), expected.outward, 64 * epsilon<ScalarOf<T>>);
    EXPECT_VECTOR_NEAR(lane_of(n.two_sided, i), expected.two_sided, 64 * epsilon<ScalarOf<T>>);
  }
}

}  // namespace
}  // namespace pinball::pinball_test

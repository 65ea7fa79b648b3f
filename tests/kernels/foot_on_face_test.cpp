#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <kernels/face_projection.hpp>
#include <tests/support/support.hpp>

/// Feet of packs of nodes on packs of faces: against the projection of one node, and lane by lane.
namespace pinball::foot_on_face_test {
namespace {

using namespace test;
using V = Vec3<double>;

struct Case {
  std::array<V, 4> face;
  V node;
};

template <class T>
class FootOnFace : public testing::Test {};
using DoubleTypes = testing::Types<double, Pack<double, 2>, Pack<double, 4>, Pack<double, 8>>;
TYPED_TEST_SUITE(FootOnFace, DoubleTypes);

/// Compiled once, so that all companies of a lane meet the same instructions.
template <class T>
[[gnu::noinline]] std::vector<FaceProjection<double>> feet_of(const std::vector<Case>& lanes) {
  const auto lane_from = [&](const auto& point) {
    return vector_from_lanes<T>([&](int i) { return point(lanes[i]); });
  };
  Vec3<T> corner[4];
  for (std::size_t k = 0; k < 4; ++k) {
    corner[k] = lane_from([k](const Case& c) { return c.face[k]; });
  }
  const FaceProjection<T> at = foot_on_face(corner, lane_from([](const Case& c) { return c.node; }));
  std::vector<FaceProjection<double>> feet(lanes.size());
  for (int i = 0; i < width_of<T>; ++i) {
    FaceProjection<double>& foot = feet[i];
    foot.xi = lane(at.xi, i);
    foot.eta = lane(at.eta, i);
    for (int k = 0; k < 4; ++k) foot.weight[k] = lane(at.weight[k], i);
    foot.normal = lane_of(at.normal, i);
    foot.gap = lane(at.gap, i);
    foot.outside = lane(at.outside, i);
  }
  return feet;
}

FaceProjection<double> projection_of(const Case& c) {
  const V face[4] = {c.face[0], c.face[1], c.face[2], c.face[3]};
  return project_onto_face(face, c.node, 0.0, 0.0);
}

V point_of(const Case& c, double xi, double eta) {
  double w[4];
  face_weights_at(xi, eta, w);
  return w[0] * c.face[0] + w[1] * c.face[1] + w[2] * c.face[2] + w[3] * c.face[3];
}

constexpr std::array<V, 4> square = {V{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

/// How the corners of a square are moved.
enum class Shape { flat, skewed, warped, distorted, strongly_distorted, triangle };
constexpr std::array all_shapes = {
    Shape::flat, Shape::skewed, Shape::warped, Shape::distorted, Shape::strongly_distorted, Shape::triangle};

std::array<V, 4> random_face(Random& random, Shape shape) {
  std::array<V, 4> face = square;
  const double skew = uniform(random, -0.7, 0.7), length = uniform(random, 0.3, 3), warp = uniform(random, -0.3, 0.3);
  for (std::size_t k = 0; k < 4; ++k) {
    V& x = face[k];
    if (shape == Shape::skewed) x = {length * x.x + skew * x.y, x.y, 0.5 * skew * x.x};
    if (shape == Shape::warped) x.z += k % 2 == 0 ? warp : -warp;
    if (shape == Shape::distorted) x = x + random_vector(random, 0.15);
    if (shape == Shape::strongly_distorted) x = x + random_vector(random, 0.4);
  }
  if (shape == Shape::triangle) face[3] = face[2];
  return face;
}

/// A node above or below a face of any shape, or beside it.
Case random_case(Random& random, Shape shape) {
  Case c{random_face(random, shape), {}};
  c.node = point_of(c, uniform(random, -1.5, 1.5), uniform(random, -1.5, 1.5)) + V{0, 0, uniform(random, -0.5, 0.5)};
  return c;
}

template <class T>
std::vector<Case> random_lanes(Random& random, Shape shape) {
  std::vector<Case> lanes;
  for (int i = 0; i < width_of<T>; ++i) lanes.push_back(random_case(random, shape));
  return lanes;
}

template <class T>
std::vector<Case> random_lanes_of_all_shapes(Random& random) {
  std::vector<Case> lanes;
  for (std::size_t i = 0; i < std::size_t{width_of<T>}; ++i) {
    lanes.push_back(random_case(random, all_shapes[(i + random()) % all_shapes.size()]));
  }
  return lanes;
}

void expect_same_foot(const FaceProjection<double>& foot, const FaceProjection<double>& expected, double tolerance) {
  EXPECT_NEAR(foot.xi, expected.xi, tolerance);
  EXPECT_NEAR(foot.eta, expected.eta, tolerance);
  EXPECT_NEAR(foot.gap, expected.gap, tolerance);
  EXPECT_NEAR(foot.outside, expected.outside, tolerance);
  EXPECT_VECTOR_NEAR(foot.normal, expected.normal, tolerance);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(foot.weight[k], expected.weight[k], tolerance);
}

void expect_same_bits(const FaceProjection<double>& foot, const FaceProjection<double>& expected) {
  const auto bits_of = [](const FaceProjection<double>& f) {
    return std::bit_cast<std::array<std::uint64_t, 11>>(std::array{f.xi, f.eta, f.weight[0], f.weight[1], f.weight[2],
                                                                   f.weight[3], f.normal.x, f.normal.y, f.normal.z,
                                                                   f.gap, f.outside});
  };
  EXPECT_EQ(bits_of(foot), bits_of(expected));
}

TYPED_TEST(FootOnFace, IsThatOfTheProjectionOfOneNode) {
  for (const Shape shape : all_shapes) {
    SCOPED_TRACE(testing::Message() << "shape " << static_cast<int>(shape));
    Random random(23);
    int inside = 0, beside = 0;
    for (int n = 0; n < 2000; n += width_of<TypeParam>) {
      const std::vector<Case> lanes = random_lanes<TypeParam>(random, shape);
      const auto feet = feet_of<TypeParam>(lanes);
      for (std::size_t i = 0; i < lanes.size(); ++i) {
        const FaceProjection<double> expected = projection_of(lanes[i]);
        // A foot far out is anywhere, or nowhere.
        if (!(std::abs(expected.xi) < 2 && std::abs(expected.eta) < 2 && expected.outside < INFINITY)) continue;
        expect_same_foot(feet[i], expected, 1e-9);
        inside += expected.outside == 0;
        beside += expected.outside > 0;
      }
    }
    EXPECT_GT(inside, 500);
    EXPECT_GT(beside, 500);
  }
}

TYPED_TEST(FootOnFace, IsWhereAGapWasPutOnTheFace) {
  Random random(29);
  for (int n = 0; n < 2000; n += width_of<TypeParam>) {
    std::vector<Case> lanes;
    std::vector<FaceProjection<double>> expected;
    for (int i = 0; i < width_of<TypeParam>; ++i) {
      Case c{random_face(random, (n + i) % 2 == 0 ? Shape::distorted : Shape::warped), {}};
      FaceProjection<double> foot;
      foot.xi = uniform(random, -1, 1);
      foot.eta = uniform(random, -1, 1);
      foot.gap = uniform(random, -0.2, 0.2);
      face_weights_at(foot.xi, foot.eta, foot.weight);
      const double e = 1e-4;  // differences of a bilinear face are exact but for round-off
      const V along_xi = point_of(c, foot.xi + e, foot.eta) - point_of(c, foot.xi - e, foot.eta);
      const V along_eta = point_of(c, foot.xi, foot.eta + e) - point_of(c, foot.xi, foot.eta - e);
      const V area = cross(along_xi, along_eta);
      foot.normal = (1 / norm(area)) * area;
      c.node = point_of(c, foot.xi, foot.eta) + foot.gap * foot.normal;
      lanes.push_back(c);
      expected.push_back(foot);
    }
    const auto feet = feet_of<TypeParam>(lanes);
    for (std::size_t i = 0; i < lanes.size(); ++i) expect_same_foot(feet[i], expected[i], 1e-9);
  }
}

TYPED_TEST(FootOnFace, DependsOnNoOtherLane) {
  Random random(31);
  for (int n = 0; n < 300; ++n) {
    std::vector<Case> lanes = random_lanes_of_all_shapes<TypeParam>(random);
    const auto before = feet_of<TypeParam>(lanes);
    const std::size_t own = random() % lanes.size();
    const Case kept = lanes[own];
    lanes = random_lanes_of_all_shapes<TypeParam>(random);
    lanes[own] = kept;
    expect_same_bits(feet_of<TypeParam>(lanes)[own], before[own]);
    for (Case& other : lanes) other = kept;
    for (const auto& foot : feet_of<TypeParam>(lanes)) expect_same_bits(foot, before[own]);
  }
}

/// Nodes and faces for which there is no foot.
std::vector<Case> without_foot() {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const V node{0.4, 0.3, 0.1};
  std::vector<Case> cases = {{{V{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}}, node},
                             {{V{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, node},
                             {{V{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, node},
                             {{V{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, node},
                             {square, {infinity, 0.3, 0.1}},
                             {square, {0.4, 0.3, -infinity}}};
  for (double V::*const component : {&V::x, &V::y, &V::z}) {
    cases.push_back({square, node});
    cases.back().node.*component = nan;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      cases.push_back({square, node});
      cases.back().face[corner].*component = nan;
    }
  }
  return cases;
}

TYPED_TEST(FootOnFace, IsNowhereForWhatIsNotANumberOrHasNoAreaAndOtherLanesDoNotMind) {
  Random random(37);
  const std::vector<Case> cases = without_foot();
  for (std::size_t number = 0; number < cases.size(); ++number) {
    SCOPED_TRACE(testing::Message() << "case " << number);
    for (std::size_t own = 0; own < std::size_t{width_of<TypeParam>}; ++own) {
      std::vector<Case> lanes = random_lanes_of_all_shapes<TypeParam>(random);
      const auto before = feet_of<TypeParam>(lanes);
      lanes[own] = cases[number];
      const auto feet = feet_of<TypeParam>(lanes);
      for (std::size_t i = 0; i < lanes.size(); ++i) {
        if (i == own) {
          EXPECT_EQ(feet[i].outside, std::numeric_limits<double>::infinity());
        } else {
          expect_same_bits(feet[i], before[i]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace pinball::foot_on_face_test

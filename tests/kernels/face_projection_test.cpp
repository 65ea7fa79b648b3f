#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <kernels/face_projection.hpp>

namespace pinball::face_projection_test {
namespace {

using V = Vec3<double>;

V point_of(const V (&x)[4], double xi, double eta) {
  double w[4];
  face_weights_at(xi, eta, w);
  return w[0] * x[0] + w[1] * x[1] + w[2] * x[2] + w[3] * x[3];
}

V point_at(const V (&x)[4], const double (&w)[4]) { return w[0] * x[0] + w[1] * x[1] + w[2] * x[2] + w[3] * x[3]; }

double distance(const V& a, const V& b) { return std::sqrt(dot(a - b, a - b)); }

/// A face of size h, warped and distorted at random.
void random_face(std::mt19937& generator, double distortion, V (&x)[4]) {
  std::uniform_real_distribution<double> uniform(-distortion, distortion);
  const double square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int i = 0; i < 4; ++i) {
    x[i] = {square[i][0] + uniform(generator), square[i][1] + uniform(generator), uniform(generator)};
  }
}

TEST(FaceProjection, FootOnAPlaneFaceIsExact) {
  const V x[4] = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  const FaceProjection<double> p = project_onto_face(x, V{1.5, 0.25, -0.125}, 0.0, 0.0);
  EXPECT_DOUBLE_EQ(p.xi, 0.5);
  EXPECT_DOUBLE_EQ(p.eta, -0.5);
  EXPECT_DOUBLE_EQ(p.gap, -0.125);
  EXPECT_EQ(p.outside, 0);
  EXPECT_DOUBLE_EQ(p.normal.z, 1);
  const double expected[4] = {0.1875, 0.5625, 0.1875, 0.0625};
  for (int i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(p.weight[i], expected[i]);
}

TEST(FaceProjection, FootBesideTheFaceIsMovedToItsEdge) {
  const V x[4] = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  const FaceProjection<double> p = project_onto_face(x, V{2.3, 0.5, 0.2}, 0.0, 0.0);
  EXPECT_NEAR(p.xi, 1.3, 1e-14);
  EXPECT_NEAR(p.outside, 0.3, 1e-14);
  EXPECT_NEAR(p.gap, 0.2, 1e-15);
  EXPECT_NEAR(p.weight[1] + p.weight[2], 1, 1e-15);
}

TEST(FaceProjection, FindsThePointAtWhichAGapWasPutOnDistortedFaces) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int n = 0; n < 2000; ++n) {
    V x[4];
    random_face(generator, 0.2, x);
    const double xi = uniform(generator), eta = uniform(generator), gap = 0.3 * uniform(generator);
    const V area = cross(face_tangent(x, 0, eta), face_tangent(x, 1, xi));
    const V normal = (1 / std::sqrt(dot(area, area))) * area;
    const V node = point_of(x, xi, eta) + gap * normal;
    const FaceProjection<double> p = project_onto_face(x, node, 0.0, 0.0);
    EXPECT_NEAR(p.xi, xi, 1e-11);
    EXPECT_NEAR(p.eta, eta, 1e-11);
    EXPECT_NEAR(p.gap, gap, 1e-12);
    EXPECT_LT(p.outside, 1e-11);
    EXPECT_NEAR(p.weight[0] + p.weight[1] + p.weight[2] + p.weight[3], 1, 1e-14);
  }
}

template <class S>
void expect_feet_far_from_the_origin(double tolerance) {
  std::mt19937 generator(13);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double far : {1e1, 1e2, 1e3, 1e4}) {
    for (int n = 0; n < 300; ++n) {
      V x[4];
      random_face(generator, 0.1, x);
      const V origin{far * uniform(generator), far * uniform(generator), far * uniform(generator)};
      const V node = origin + V{0.5, 0.5, 0} + 0.2 * V{uniform(generator), uniform(generator), uniform(generator)};
      Vec3<S> moved[4];
      for (int i = 0; i < 4; ++i) {
        const V place = origin + x[i];
        moved[i] = {S(place.x), S(place.y), S(place.z)};
      }
      const FaceProjection<double> near = project_onto_face(x, node - origin, 0.0, 0.0);
      const Vec3<S> moved_node{S(node.x), S(node.y), S(node.z)};
      const FaceProjection<S> p = project_onto_face(moved, moved_node, S(0), S(0));
      EXPECT_EQ(p.outside, 0) << "at " << far << " sizes of the face";
      EXPECT_NEAR(p.gap, near.gap, tolerance * far);  // places are rounded to that
    }
  }
}

TEST(FaceProjection, FindsFeetFarFromTheOrigin) {
  expect_feet_far_from_the_origin<double>(1e-15);
  expect_feet_far_from_the_origin<float>(1e-6);
}

TEST(FaceProjection, NoPointOfTheFaceIsNearerThanTheFoot) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-0.4, 1.4);
  int inside = 0;
  for (int n = 0; n < 500; ++n) {
    V x[4];
    random_face(generator, 0.15, x);
    const V node{uniform(generator), uniform(generator), 0.5 * (uniform(generator) - 0.5)};
    const FaceProjection<double> p = project_onto_face(x, node, 0.0, 0.0);
    ASSERT_TRUE(std::isfinite(p.outside));
    if (p.outside > 0) continue;
    ++inside;
    for (double xi = -1; xi <= 1; xi += 0.05) {
      for (double eta = -1; eta <= 1; eta += 0.05) {
        EXPECT_GE(distance(node, point_of(x, xi, eta)), std::abs(p.gap) - 1e-12);
      }
    }
  }
  EXPECT_GT(inside, 100);
}

TEST(FaceProjection, GapIsTheGradientOfItsWeights) {
  // d gap = n . dx - sum_I N_I n . dx_I: what makes a penalty on the gap conserve energy.
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  V x[4];
  random_face(generator, 0.2, x);
  const V node{0.4, 0.6, 0.15};
  const FaceProjection<double> p = project_onto_face(x, node, 0.0, 0.0);
  const double e = 1e-6;
  V moved[4], direction[4];
  const V node_direction{uniform(generator), uniform(generator), uniform(generator)};
  double expected = dot(p.normal, node_direction);
  for (int i = 0; i < 4; ++i) {
    direction[i] = {uniform(generator), uniform(generator), uniform(generator)};
    expected -= p.weight[i] * dot(p.normal, direction[i]);
  }
  double gap[2];
  for (int side = 0; side < 2; ++side) {
    const double step = side == 0 ? -e : e;
    for (int i = 0; i < 4; ++i) moved[i] = x[i] + step * direction[i];
    gap[side] = project_onto_face(moved, node + step * node_direction, p.xi, p.eta).gap;
  }
  EXPECT_NEAR((gap[1] - gap[0]) / (2 * e), expected, 1e-8);
}

TEST(FaceProjection, ATriangleIsAFaceToo) {
  const V x[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}};
  const FaceProjection<double> p = project_onto_face(x, V{0.25, 0.25, 0.1}, 0.0, 0.0);
  EXPECT_EQ(p.outside, 0);
  EXPECT_NEAR(p.gap, 0.1, 1e-14);
}

/// A triangle with the two corners in one place that end and begin side k, and its other corners.
struct Triangle {
  V corner[4];
  V twice, first, second;
};

Triangle random_triangle(std::mt19937& generator, int k) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  V x[4];
  random_face(generator, 0.2, x);
  x[(k + 1) % 4] = x[k];
  return {{x[0], x[1], x[2], x[3]}, x[k], x[(k + 2) % 4], x[(k + 3) % 4]};
}

/// Points of a triangle at which Newton's iteration goes round in circles or has no tangents, and some at random.
std::vector<V> points_of(const Triangle& t, std::mt19937& generator) {
  const V middle = (1 / 3.0) * (t.twice + t.first + t.second);
  std::vector<V> points = {t.twice, t.first, t.second, middle};
  for (const double part : {0.25, 0.5, 0.75}) {
    points.push_back(part * t.twice + (1 - part) * t.first);
    points.push_back(part * t.first + (1 - part) * t.second);
    points.push_back(part * t.second + (1 - part) * t.twice);
  }
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int n = 0; n < 200; ++n) {
    const double a = uniform(generator), b = (1 - a) * uniform(generator);
    points.push_back(a * t.twice + b * t.first + (1 - a - b) * t.second);
  }
  return points;
}

TEST(FaceProjection, EachPointOfATriangleHasItsFootWhicheverCornersAreOne) {
  std::mt19937 generator(29);
  for (int n = 0; n < 80; ++n) {
    const Triangle t = random_triangle(generator, n % 4);
    const V area = cross(t.first - t.twice, t.second - t.twice), normal = (1 / std::sqrt(dot(area, area))) * area;
    for (const V& point : points_of(t, generator)) {
      for (const double gap : {-0.1, 0.0, 0.3}) {
        const V node = point + gap * normal;
        FaceProjection<double> packed = foot_on_face(t.corner, node);
        move_to_nearest_side(t.corner, node, packed);
        for (const FaceProjection<double>& p : {project_onto_face(t.corner, node, 0.0, 0.0), packed}) {
          ASSERT_LT(p.outside, 1e-7);
          EXPECT_NEAR(p.gap, gap, 1e-8);
          EXPECT_NEAR(distance(p.normal, normal), 0, 1e-8);
          EXPECT_NEAR(distance(point_at(t.corner, p.weight), point), 0, 1e-7);
        }
      }
    }
  }
}

TEST(FaceProjection, BeyondTheCornerThatATriangleHasTwiceItIsTheFoot) {
  std::mt19937 generator(31);
  for (int n = 0; n < 80; ++n) {
    const Triangle t = random_triangle(generator, n % 4);
    const V node = t.twice + 0.1 * (t.twice - 0.5 * (t.first + t.second));
    FaceProjection<double> foot = foot_on_face(t.corner, node);
    move_to_nearest_side(t.corner, node, foot);
    EXPECT_NEAR(foot.outside, distance(node, t.twice), 1e-9);
    EXPECT_NEAR(distance(point_at(t.corner, foot.weight), t.twice), 0, 1e-9);
  }
}

TEST(FaceProjection, AFaceWithoutAreaHasNoFoot) {
  const V x[4] = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  EXPECT_TRUE(std::isinf(project_onto_face(x, V{0.5, 0.1, 0.1}, 0.0, 0.0).outside));
  const double nan = std::nan("");
  EXPECT_TRUE(std::isinf(project_onto_face(x, V{nan, 0.1, 0.1}, 0.0, 0.0).outside));
}

TEST(FaceProjection, FloatAgreesWithDouble) {
  const Vec3<float> x[4] = {{0, 0, 0}, {1, 0.1F, 0.05F}, {1.1F, 1, -0.05F}, {0, 0.9F, 0.1F}};
  const V y[4] = {{0, 0, 0}, {1, 0.1, 0.05}, {1.1, 1, -0.05}, {0, 0.9, 0.1}};
  const FaceProjection<float> p = project_onto_face(x, Vec3<float>{0.3F, 0.4F, 0.2F}, 0.0F, 0.0F);
  const FaceProjection<double> q = project_onto_face(y, V{0.3, 0.4, 0.2}, 0.0, 0.0);
  EXPECT_NEAR(p.xi, q.xi, 2e-6);
  EXPECT_NEAR(p.eta, q.eta, 2e-6);
  EXPECT_NEAR(p.gap, q.gap, 1e-6);
}

/// Nearest among many points of the sides.
double distance_by_samples(const V (&x)[4], const V& node) {
  double least = INFINITY;
  for (int k = 0; k < 4; ++k) {
    for (int i = 0; i <= 4000; ++i) {
      const double s = i / 4000.0;
      least = std::min(least, distance(node, (1 - s) * x[k] + s * x[(k + 1) % 4]));
    }
  }
  return least;
}

TEST(FaceProjection, FootBeyondASideIsMovedToItsNearestPoint) {
  std::mt19937 generator(19);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int moved = 0;
  for (int n = 0; n < 500; ++n) {
    V x[4];
    random_face(generator, 0.2, x);
    const V node = V{0.5 + 1.2 * uniform(generator), 0.5 + 1.2 * uniform(generator), 0.3 * uniform(generator)};
    FaceProjection<double> foot = foot_on_face(x, node);
    const bool inside = foot.outside == 0;
    if (!(std::abs(foot.xi) < 2 && std::abs(foot.eta) < 2)) continue;
    move_to_nearest_side(x, node, foot);
    V to = node;
    for (int k = 0; k < 4; ++k) to = to - foot.weight[k] * x[k];
    EXPECT_NEAR(dot(to, foot.normal), foot.gap, 1e-12);
    EXPECT_NEAR(std::hypot(foot.gap, foot.outside), std::sqrt(dot(to, to)), 1e-12);
    if (inside) continue;
    ++moved;
    EXPECT_NEAR(std::sqrt(dot(to, to)), distance_by_samples(x, node), 1e-3);
  }
  EXPECT_GT(moved, 100);
}

TEST(FaceProjection, FootIsMovedToWhereTheNodeSeesItAlongADirection) {
  std::mt19937 generator(23);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int n = 0; n < 500; ++n) {
    V x[4];
    random_face(generator, 0.2, x);
    const V node = point_of(x, uniform(generator), uniform(generator)) + V{0, 0, 0.2 * uniform(generator)};
    FaceProjection<double> foot = foot_on_face(x, node);
    V direction = foot.normal + 0.5 * V{uniform(generator), uniform(generator), uniform(generator)};
    direction = (1 / std::sqrt(dot(direction, direction))) * direction;
    V to = node;
    for (int k = 0; k < 4; ++k) to = to - foot.weight[k] * x[k];
    const double gap = move_to_line(x, to, direction, foot.weight);
    to = node;
    for (int k = 0; k < 4; ++k) to = to - foot.weight[k] * x[k];
    EXPECT_NEAR(distance(to, gap * direction), 0, 1e-14);
    EXPECT_NEAR(foot.weight[0] + foot.weight[1] + foot.weight[2] + foot.weight[3], 1, 1e-14);
  }
}

}  // namespace
}  // namespace pinball::face_projection_test

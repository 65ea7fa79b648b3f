#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <solver/contact/spheres/nearest_on_face.hpp>

namespace pinball::nearest_on_face_test {
namespace {

using Vector = Vec3<double>;

double length(const Vector& v) { return std::sqrt(dot(v, v)); }

/// Least distance over a fine grid of points of the four triangles.
double by_trial(const Vector (&x)[4], const Vector& point) {
  constexpr int n = 60;
  const Vector middle = 0.25 * (x[0] + x[1] + x[2] + x[3]);
  double least = HUGE_VAL;
  for (int k = 0; k < 4; ++k) {
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; i + j <= n; ++j) {
        const double a = static_cast<double>(i) / n, b = static_cast<double>(j) / n;
        least = std::min(least, length((1 - a - b) * middle + a * x[k] + b * x[(k + 1) % 4] - point));
      }
    }
  }
  return least;
}

void expect_nearest(const Vector (&x)[4], const Vector& point) {
  const NearestOnFace<double> at = nearest_on_face(x, point);
  Vector foot{0, 0, 0};
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    EXPECT_GE(at.weight[k], -1e-12);
    sum += at.weight[k];
    foot = foot + at.weight[k] * x[k];
  }
  EXPECT_NEAR(sum, 1, 1e-14);
  EXPECT_NEAR(length(point - foot - at.away), 0, 1e-13);
  EXPECT_NEAR(length(at.away), at.distance, 1e-14);
  const double trial = by_trial(x, point);
  EXPECT_LT(at.distance, trial + 1e-12);
  EXPECT_GT(at.distance, trial - 0.04);
  for (int k = 0; k < 4; ++k) {
    const bool of_rim = k == at.rim[0] || k == at.rim[1];
    if (at.rim[0] >= 0 && !of_rim) {
      EXPECT_LT(at.weight[k], 1e-5);
    }
  }
}

TEST(NearestOnFace, IsNoFurtherThanAnyOtherPoint) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> any(-0.4, 0.4), far(-2, 2);
  for (int i = 0; i < 300; ++i) {
    const auto near = [&](double a, double b) {
      return Vector{a + any(generator), b + any(generator), any(generator)};
    };
    const Vector x[4] = {near(-1, -1), near(1, -1), near(1, 1), near(-1, 1)};
    expect_nearest(x, {far(generator), far(generator), far(generator)});
  }
}

TEST(NearestOnFace, KnowsTheRim) {
  const Vector x[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto rim = [&x](const Vector& point) {
    const NearestOnFace<double> at = nearest_on_face(x, point);
    return std::pair(std::min(at.rim[0], at.rim[1]), std::max(at.rim[0], at.rim[1]));
  };
  EXPECT_EQ(rim({0.3, 0.4, 0.5}), std::pair(-1, -1));
  EXPECT_EQ(rim({0.5, 0.5, 0}), std::pair(-1, -1)) << "on the face";
  EXPECT_EQ(rim({0.5, -0.1, 0.5}), std::pair(0, 1));
  EXPECT_EQ(rim({1.5, 0.5, 0.5}), std::pair(1, 2));
  EXPECT_EQ(rim({-0.5, 0.5, 0}), std::pair(0, 3));
  EXPECT_EQ(rim({1, 1, 0.2}), std::pair(2, 2)) << "right over a corner";
  EXPECT_EQ(rim({-1, 2, -0.2}), std::pair(3, 3));
  EXPECT_EQ(rim({0.5, 1, 0.2}), std::pair(2, 3)) << "right over an edge";
}

TEST(NearestOnFace, TakesCollapsedFaces) {
  const Vector triangle[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}};
  const Vector line[4] = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  const Vector point[4] = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  for (const Vector& p : {Vector{0.7, 0.2, 0.4}, {2, 2, 0}, {-1, 0.5, 1}, {0.5, 0, 0}}) {
    expect_nearest(triangle, p);
    expect_nearest(line, p);
    expect_nearest(point, p);
  }
}

}  // namespace
}  // namespace pinball::nearest_on_face_test

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <kernels/contact_row.hpp>

namespace pinball {
namespace {

/// Corners of a box.
void box(Vec3<double> (&x)[8], const Vec3<double>& low, const Vec3<double>& size) {
  for (int i = 0; i < 8; ++i) {
    const int a = (i == 1 || i == 2 || i == 5 || i == 6) ? 1 : 0, b = (i == 2 || i == 3 || i == 6 || i == 7) ? 1 : 0;
    x[i] = {low.x + a * size.x, low.y + b * size.y, low.z + (i >= 4 ? size.z : 0.0)};
  }
}

ContactRow row_between(const Vec3<double> (&x1)[8], const Vec3<double> (&x2)[8]) {
  Vec3<double> d{0, 0, 0};
  for (int i = 0; i < 8; ++i) d = d + 0.125 * (x1[i] - x2[i]);
  return face_row(face_towards(x1, 0x3F, -1.0 * d), face_towards(x2, 0x3F, d));
}

/// Total force and moment of a row about the origin.
void resultant(const ContactRow& row, const Vec3<double> (&x1)[8], const Vec3<double> (&x2)[8], Vec3<double>& force,
               Vec3<double>& moment) {
  force = moment = {0, 0, 0};
  for (int i = 0; i < row.nodes1; ++i) {
    force = force + row.weight1[i] * row.direction;
    moment = moment + cross(x1[row.corner1[i]], row.weight1[i] * row.direction);
  }
  for (int i = 0; i < row.nodes2; ++i) {
    force = force - row.weight2[i] * row.direction;
    moment = moment - cross(x2[row.corner2[i]], row.weight2[i] * row.direction);
  }
}

TEST(ContactRow, FlatFacesTouchWhereTheyAre) {
  Vec3<double> x1[8], x2[8];
  box(x1, {0.3, 0.2, 1.0}, {1, 1, 1});
  for (const double gap : {-0.1, 0.0, 0.2}) {
    box(x2, {0, 0, -gap}, {1, 1, 1});
    const ContactRow row = row_between(x1, x2);
    ASSERT_EQ(row.nodes1, 4);
    EXPECT_NEAR(row.depth, -gap, 1e-15);
    EXPECT_NEAR(row.direction.z, 1, 1e-15);
  }
}

TEST(ContactRow, ForcesOfFacesHaveNoResultant) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  int met = 0;
  for (int trial = 0; trial < 500; ++trial) {
    Vec3<double> x1[8], x2[8];
    const double size = 1 + 0.5 * number(random);
    box(x1, {0.7 * number(random), 0.7 * number(random), 1.0}, {size, size, size});
    box(x2, {0, 0, 0}, {1, 1, 1});
    for (int i = 0; i < 8; ++i) {  // tilted, but with flat faces: a warped face moves the point off its nodes
      x1[i].z += 0.15 * x1[i].x - 0.1 * x1[i].y;
      x2[i].z += 0.05 * x2[i].x;
    }
    const ContactRow row = row_between(x1, x2);
    if (row.nodes1 == 0) continue;
    ++met;
    Vec3<double> force, moment;
    resultant(row, x1, x2, force, moment);
    EXPECT_LT(std::sqrt(dot(force, force)), 1e-14);
    // The points that the forces act at are the projections of the common point along each face's own normal: off the
    // line of action by the angle between the two faces times the depth.
    EXPECT_LT(std::sqrt(dot(moment, moment)), 0.2 * std::abs(row.depth) + 1e-12);
    double sum = 0;
    for (int i = 0; i < 4; ++i) sum += row.weight1[i] - row.weight2[i];
    EXPECT_NEAR(sum, 0, 1e-14);
  }
  EXPECT_GT(met, 100);
}

TEST(ContactRow, ParallelFacesHaveOneLineOfAction) {
  Vec3<double> x1[8], x2[8];
  box(x1, {0.4, -0.3, 0.95}, {1, 1.2, 1});
  box(x2, {0, 0, 0}, {1, 1, 1});
  const ContactRow row = row_between(x1, x2);
  ASSERT_EQ(row.nodes1, 4);
  Vec3<double> force, moment;
  resultant(row, x1, x2, force, moment);
  EXPECT_LT(std::sqrt(dot(moment, moment)), 1e-14);
}

TEST(ContactRow, FacesThatDoNotLookAtEachOtherGiveNone) {
  Vec3<double> x1[8], x2[8];
  box(x1, {0, 0, 1.2}, {1, 1, 1});
  box(x2, {0, 0, 0}, {1, 1, 1});
  const Vec3<double> up{0, 0, 1}, down{0, 0, -1};
  const unsigned top = 1U << 5, bottom = 1U << 4;
  EXPECT_EQ(face_row(face_towards(x1, bottom, down), face_towards(x2, top, up)).nodes1, 4);
  EXPECT_EQ(face_towards(x1, top, down).face, -1);  // the face that is exposed looks away
  EXPECT_EQ(face_row(face_towards(x1, top, down), face_towards(x2, top, up)).nodes1, 0);
  EXPECT_EQ(face_row(face_towards(x1, top, up), face_towards(x2, top, up)).nodes1, 0);
}

TEST(ContactRow, BesideEachOtherFacesGiveNone) {
  Vec3<double> x1[8], x2[8];
  box(x1, {1.9, 0, 1.0}, {1, 1, 1});
  box(x2, {0, 0, 0}, {1, 1, 1});
  const Vec3<double> up{0, 0, 1}, down{0, 0, -1};
  EXPECT_EQ(face_row(face_towards(x1, 0x3F, down), face_towards(x2, 0x3F, up)).nodes1, 0);
}

TEST(ContactRow, BallsAgreeWithThePenaltyWhereTheyOverlap) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3<double> d{number(random), number(random), number(random)};
    Vec3<double> n1{number(random), number(random), number(random)}, n2 = -1.0 * n1;
    n1 = (1 / std::sqrt(dot(n1, n1))) * n1;
    n2 = (1 / std::sqrt(dot(n2, n2))) * n2;
    const double reach = 1.2;
    const Penetration<double> p = penetration(d, reach, n1, n2);
    const ContactRow row = pinball_row(d, reach, n1, n2);
    if (!p.active) continue;
    ASSERT_EQ(row.nodes1, 8);
    EXPECT_NEAR(row.depth, p.depth, 1e-14);
    EXPECT_NEAR(row.direction.x, p.gradient.x, 1e-12);
    EXPECT_NEAR(row.direction.y, p.gradient.y, 1e-12);
    EXPECT_NEAR(row.direction.z, p.gradient.z, 1e-12);
  }
}

TEST(ContactRow, OpenGapOfBallsIsNegative) {
  const ContactRow row = pinball_row({0, 0, 1.5}, 1.2, {0, 0, -1}, {0, 0, 1});
  ASSERT_EQ(row.nodes1, 8);
  EXPECT_NEAR(row.depth, -0.3, 1e-15);
}

}  // namespace
}  // namespace pinball

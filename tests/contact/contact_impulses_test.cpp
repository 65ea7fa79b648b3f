#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "impact_case.hpp"

/// Contact by impulses (projection, Lagrange multiplier) of whole bodies, through the solver.
namespace pinball::contact_impulses_test {
namespace {

using namespace test;

struct Variant {
  Enforcement enforcement;
  ContactGap gap;
};

class ContactByImpulses : public testing::TestWithParam<Variant> {
 protected:
  Scene impulses(Scene scene) const {
    scene.contact.enforcement = GetParam().enforcement;
    scene.contact.gap = GetParam().gap;
    return scene;
  }
  /// A little more than the distance of two flat faces, over the size of their elements, at which contact begins.
  double just_apart() const { return GetParam().gap == ContactGap::face ? 0.01 : 1.01 * touching_gap; }
};

INSTANTIATE_TEST_SUITE_P(All, ContactByImpulses,
                         testing::Values(Variant{Enforcement::projection, ContactGap::face},
                                         Variant{Enforcement::projection, ContactGap::pinball},
                                         Variant{Enforcement::lagrange, ContactGap::face},
                                         Variant{Enforcement::lagrange, ContactGap::pinball}),
                         [](const auto& test) {
                           return std::string(enforcement_name(test.param.enforcement)) +
                                  (test.param.gap == ContactGap::face ? "_face" : "_pinball");
                         });

TEST_P(ContactByImpulses, HeadOnImpactKeepsMomentumAndClosesItsBalance) {
  Solver<double> solver(impulses(head_on_impact(just_apart())));
  double worst = 0;
  run_to_end(solver, [&] {
    worst = std::max(worst, std::abs(solver.balance_error()));
    for (const double p : solver.momentum()) ASSERT_NEAR(p, 0, 1e-12 * 7850 * 0.027 * 10);
  });
  // What the impulses take out is counted exactly; what remains is that of the elements.
  EXPECT_LT(worst, 2e-3);
  EXPECT_GT(solver.energies().contact_damped, 0);
  // Not above the speed of approach. The impulses of balls move whole elements at once: so few elements keep less of
  // it.
  EXPECT_LT(velocity_of_body(solver, 0)[2], GetParam().gap == ContactGap::face ? -7 : -4);
  EXPECT_GT(velocity_of_body(solver, 0)[2], -10);
  EXPECT_NEAR(velocity_of_body(solver, 0)[2], -velocity_of_body(solver, 1)[2], 1e-9);
}

TEST_P(ContactByImpulses, ObliqueImpactsKeepMomentumAndEnergy) {
  const auto with = [this](const Scene& scene) { return impulses(scene); };
  expect_oblique_impacts_conserve(with, 0.01, [](const Solver<double>& solver, double /*energy*/) {
    EXPECT_GT(solver.energies().contact_damped, 0) << "they are to touch";
  });
}

TEST_P(ContactByImpulses, BodiesAtRestStayAtRest) {
  const double h = 0.1;
  Solver<double> solver(
      impulses(scene_of({block("a", {2, 2, 2}, h, {0, 0, 0}), block("b", {3, 3, 1}, 0.07, {0.01, 0.02, 0.2})}, 1e-4)));
  run_to_end(solver);
  EXPECT_EQ(kinetic_energy(solver), 0);
}

TEST_P(ContactByImpulses, StaysWithinAPlaneOfSymmetry) {
  // An impact beside the plane y = 0, whose nodes have no mobility along y.
  const double h = 0.1;
  Scene scene = impulses(scene_of(
      {block("a", {4, 2, 2}, h, {0, 0, 0}), block("b", {2, 2, 2}, h, {0.05, 0, (2 + just_apart()) * h}, {0, 5, -50})},
      3e-4));
  scene.constraints.push_back({{0, 0, 0}, {0, 1, 0}, ""});
  Solver<double> solver(scene);
  run_to_end(solver);
  EXPECT_GT(solver.energies().contact_damped, 0);
  EXPECT_LT(std::abs(solver.balance_error()), 0.01);
  const ModelMesh& mesh = solver.mesh();
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (mesh.nodes[n][1] == 0) {
      EXPECT_EQ(position_of(solver, n)[1], 0);
    }
  }
}

TEST(ImpulseSolver, FacesStayApartByTheirOwnGap) {
  // A block thrown flat onto a wider one of another mesh, between planes of symmetry all around: the faces touch, and
  // not the balls that stick out of them.
  const double h = 0.1;
  Scene scene =
      scene_of({block("a", {4, 4, 4}, h, {0, 0, 0}), block("b", {3, 3, 3}, 0.4 / 3, {0, 0, 0.402}, {0, 0, -20})}, 3e-4);
  scene.contact.gap = ContactGap::face;
  for (const Enforcement enforcement : {Enforcement::projection, Enforcement::lagrange}) {
    scene.contact.enforcement = enforcement;
    Solver<double> solver(scene);
    double least = 1, when_pressed = 1;
    run_to_end(solver, [&] {
      double top = 0, bottom = 0;
      int tops = 0, bottoms = 0;
      const ModelMesh& mesh = solver.mesh();
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const double z = position_of(solver, n)[2];
        if (mesh.body_of_node[n] == 0 && mesh.nodes[n][2] > 0.399) top += z, ++tops;
        if (mesh.body_of_node[n] == 1 && mesh.nodes[n][2] < 0.403) bottom += z, ++bottoms;
      }
      least = std::min(least, bottom / bottoms - top / tops);
      if (solver.energies().contact_damped > 0) when_pressed = std::min(when_pressed, bottom / bottoms - top / tops);
    });
    EXPECT_GT(least, -0.01 * h);
    EXPECT_LT(when_pressed, 0.01 * h);
  }
}

/// What is open closes within the step, and no more: the faces of two blocks that meet flat are in each other by
/// round-off, in any precision.
template <class S>
class ClosingFaces : public testing::Test {};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(ClosingFaces, Precisions);

TYPED_TEST(ClosingFaces, MeetAndGoNoFurther) {
  double largest = 0;  // gap that was closed in a step, over what would have been gone
  for (const double gap : {0.02, 0.021, 0.022, 0.023}) {
    Scene scene = head_on_impact(gap);
    scene.contact.enforcement = Enforcement::lagrange;
    scene.contact.gap = ContactGap::face;
    Solver<TypeParam> solver(scene);
    // Between the nodes of the upper side of the lower block, and those of the lower side of the upper one.
    const auto least_gap = [&] {
      double top = -1, bottom = 1;
      for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
        const auto z = static_cast<double>(solver.model().nodes.position_of(solver.model().node_of_scene_node[n])[2]);
        const double start = solver.mesh().nodes[n][2];
        if (std::abs(start - 0.3) < 1e-6) top = std::max(top, z);
        if (std::abs(start - (3 + gap) * impact_h) < 1e-6) bottom = std::min(bottom, z);
      }
      return bottom - top;
    };
    double before = 0;
    while (!solver.at_end() && solver.counts().pairs() == 0) {
      before = least_gap();
      solver.step();
    }
    ASSERT_GT(solver.counts().pairs(), 0);
    const double way = 20 * solver.dt();
    EXPECT_NEAR(least_gap(), 0, 1e-3 * way + 2e-7);
    largest = std::max(largest, before / way);
  }
  EXPECT_GT(largest, 0.5);
}

/// Two elements, the lower one with a level upper side; that of the other rises from its edge on the lower's nodes. up:
/// 1, or -1 for what a mirror on the ground shows.
Scene wedge_on_a_cube(bool wedge_first, double up) {
  static const std::vector<double> cube{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
  static const std::vector<double> wedge = [] {
    constexpr double rise = 1.0 / 16;
    return std::vector<double>{0, 0, 1, 1, 0, 1 + rise, 1, 1, 1 + rise, 0, 1, 1, 0, 0, 2, 1, 0, 2, 1, 1, 2, 0, 1, 2};
  }();
  static const std::vector<std::int32_t> corners{0, 1, 2, 3, 4, 5, 6, 7}, mirrored{4, 5, 6, 7, 0, 1, 2, 3};
  const auto body = [up](const std::string& name, const std::vector<double>& nodes, double speed) {
    const auto places = std::make_shared<std::vector<double>>(nodes);
    for (std::size_t i = 2; i < places->size(); i += 3) (*places)[i] *= up;
    Body one = block(name, {1, 1, 1}, 1, {0, 0, 0}, {0, 0, up * speed});
    one.mesh = ArrayMesh{view_records(places->data(), 8, 3), view_records((up > 0 ? corners : mirrored).data(), 1, 8),
                         0, places};
    return one;
  };
  Scene scene = scene_of({body("cube", cube, 10), body("wedge", wedge, -10)}, 1);
  if (wedge_first) std::swap(scene.bodies[0], scene.bodies[1]);
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  return scene;
}

/// Node on node: along the mean of the normals of both, so that it does not matter which of them is the first.
TEST(ContactByImpulsesOfNodes, NodesThatMeetPushTheSameWhicheverIsTheFirst) {
  std::vector<double> aside;
  for (const double up : {1.0, -1.0}) {
    for (const bool wedge_first : {false, true}) {
      Solver<double> solver(wedge_on_a_cube(wedge_first, up));
      solver.step();
      const Point of_cube = velocity_of_body(solver, wedge_first ? 1 : 0);
      const double down = 10 - up * of_cube[2];
      ASSERT_GT(down, 1);
      aside.push_back(of_cube[0] / down);
      EXPECT_NEAR(aside.back(), aside[0], 1e-9) << up << ' ' << wedge_first;
    }
  }
  EXPECT_GT(aside[0], 0.005) << "the sides are not parallel";
}

}  // namespace
}  // namespace pinball::contact_impulses_test

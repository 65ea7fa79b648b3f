#include <gtest/gtest.h>

#include "rigid_case.hpp"

/// Rigid bodies whose given inertia is a small part of that of their nodes: springs turn them fast.
namespace pinball::light_rigid_test {
namespace {

using namespace test;

/// A cube falls beside the middle of a floor that gives way. share: of its inertia.
Scene fall(ContactMethod method, double share) {
  constexpr double h = 0.1;
  Scene scene = scene_of({block("floor", {6, 6, 2}, h, {-0.3, -0.3, -0.2}),
                          block("cube", {2, 2, 2}, h, {-0.06, -0.07, 0.02}, {0, 0, -20})},
                         2e-3);
  scene.contact.method = method;
  scene.contact.gap = method == ContactMethod::pinball ? ContactGap::pinball : ContactGap::not_set;
  scene.guard.energy_error = 1e9;
  scene.rigid_bodies = {rigid("cube")};
  const double inertia = share * 7850 * 8 * h * h * h * 1.5 * (4 * h * h) / 6;  // of masses in the corners of elements
  for (std::size_t k = 0; k < 3; ++k) scene.rigid_bodies[0].inertia[k][k] = inertia;
  return scene;
}

/// Without a bound a hundredth of the inertia leaves the balance by 300 %, and a ten thousandth by 1e5 %. What is left
/// is of the step that falls where they touch.
TEST(LightRigid, BodiesOfLittleInertiaGetNoEnergyFromSprings) {
  struct Case {
    double share, by_balls, by_slideline;  ///< error of the balance, at most
  };
  for (const ContactMethod method : {ContactMethod::pinball, ContactMethod::slideline}) {
    Solver<double> whole(fall(method, 1));
    const double usual = worst_balance_of_run(whole);
    EXPECT_LT(usual, 0.03);
    for (const auto& [share, by_balls, by_slideline] :
         {Case{0.1, 0.02, 0.05}, Case{1e-2, 0.02, 0.06}, Case{1e-3, 0.07, 0.15}}) {
      Solver<double> solver(fall(method, share));
      const double most = method == ContactMethod::pinball ? by_balls : by_slideline;
      EXPECT_LT(worst_balance_of_run(solver), most) << share;
      EXPECT_LT(solver.clock().dt_min(), whole.clock().dt_min()) << share << ": springs bound the step";
    }
  }
}

TEST(LightRigid, TheInertiaOfTheNodesLeavesTheStepAsItIs) {
  for (const ContactMethod method : {ContactMethod::pinball, ContactMethod::slideline}) {
    Scene scene = fall(method, 1), without = scene;
    without.rigid_bodies[0].inertia = {};
    Solver<double> given(scene), own(without);
    EXPECT_FALSE(own.rigid().any_light());
    EXPECT_FALSE(given.rigid().any_light());
    run(given);
    run(own);
    EXPECT_NEAR(given.clock().dt_min(), own.clock().dt_min(), 1e-9 * own.clock().dt_min());
  }
}

}  // namespace
}  // namespace pinball::light_rigid_test

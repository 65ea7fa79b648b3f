#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <tests/support/solver_case.hpp>

/// Impacts of two blocks that every algorithm of contact has to get right: scenes, with the contact at its default, and
/// checks. Elements have a size of 0.1; gaps are in elements.
namespace pinball::test {

inline constexpr double impact_h = 0.1;

inline Point velocity_of_body(const Solver<double>& solver, std::size_t body) {
  return history_row(solver).bodies[body].velocity;
}

/// Two equal blocks that meet face to face with velocities of +-10.
inline Scene head_on_impact(double gap) {
  const double h = impact_h;
  return scene_of(
      {block("a", {3, 3, 3}, h, {0, 0, 0}, {0, 0, 10}), block("b", {3, 3, 3}, h, {0, 0, (3 + gap) * h}, {0, 0, -10})},
      6e-4);
}

/// A block that hits the middle of a plate of one layer of elements, from above (sign 1) or below (-1).
inline Scene impact_on_plate(double sign, double gap) {
  const double h = impact_h, corner = sign > 0 ? (1 + gap) * h : -(2 + gap) * h;
  return scene_of({block("plate", {6, 6, 1}, h, {-0.3, -0.3, 0}),
                   block("block", {2, 2, 2}, h, {-0.1, -0.1, corner}, {0, 0, -sign * 20})},
                  1e-3);
}

/// A block on its way down to a target, whose upper layer erode_upper_layer() takes away.
inline Scene impact_on_eroding_target(double gap) {
  const double h = impact_h;
  Scene scene = scene_of(
      {block("target", {4, 4, 4}, h, {0, 0, 0}), block("block", {2, 2, 2}, h, {0.1, 0.1, (4 + gap) * h}, {0, 0, -50})},
      6e-3);
  scene.materials = {plastic_material("steel", 1e10, 1.0)};
  return scene;
}

/// In the coming step.
inline void erode_upper_layer(Solver<double>& solver) {
  std::vector<std::size_t> top;
  for (std::size_t e = 48; e < 64; ++e) top.push_back(e);
  strain_to_failure(solver, top);
}

/// A corner, an edge and a face of a block meet another block off its centre. Momentum, energy and angular momentum are
/// kept, the latter to 1 % of what the block may have about an axis 0.3 away.
/// with(scene): the scene with its contact; balance_error: bound on that of the energy at the end; at_end(solver,
/// kinetic energy at the start): what else is to hold.
template <class With, class AtEnd>
void expect_oblique_impacts_conserve(const With& with, double balance_error, const AtEnd& at_end) {
  const double h = impact_h;
  for (const Point& axis : {Point{1, 0.9, 1.1}, Point{0, 1, 1.2}, Point{0.1, 0.05, 1}}) {
    Scene scene = with(scene_of({block("a", {4, 4, 3}, h, {-0.2, -0.2, 0}, {0, 0, 10}),
                                 block("b", {3, 3, 3}, h, {0.05, 0.02, 0.65}, {10, -5, -70})},
                                8e-3));
    scene.bodies[1].axis = axis;
    scene.bodies[1].angular_velocity = {30, 10, -20};
    Solver<double> solver(scene);
    const Point momentum_before = solver.momentum(), before = angular_momentum(solver);
    const double energy = kinetic_energy(solver);
    bool touched = false;
    run_to_end(solver, [&] { touched = touched || solver.counts().pairs() > 0; });
    EXPECT_TRUE(touched);
    EXPECT_LT(std::abs(solver.balance_error()), balance_error);
    const Point after = angular_momentum(solver);
    const double scale = 7850 * 0.027 * 70;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(solver.momentum()[k], momentum_before[k], 1e-11 * scale);
      EXPECT_NEAR(after[k], before[k], 0.01 * scale * 0.3);
    }
    at_end(solver, energy);
  }
}

}  // namespace pinball::test

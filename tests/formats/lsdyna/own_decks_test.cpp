#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "own_deck.hpp"

namespace pinball::test::own_decks_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

TEST(OwnDecks, AllAreListed) {
  std::ifstream file(own_deck("README.md"));
  const std::string page((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  for (const std::string& name : all_own_decks()) EXPECT_THAT(page, HasSubstr("| `" + name + "` |"));
}

TEST(OwnDecks, FormsFallsAsItShould) {
  const Simulation s = run_deck("forms.k");
  EXPECT_EQ(s.elements(), 8);
  EXPECT_DOUBLE_EQ(s.bodies()[0].mass_initial, 8 * 7.85e-9);
  EXPECT_NEAR(s.bodies()[0].velocity[2], -9.81 * 1e-3, 1e-9);
  EXPECT_NEAR(s.bodies()[0].velocity[0], 0, 1e-12);
  EXPECT_NEAR(run_deck("forms.k", {.chosen_case = 2, .lenient = false, .name_in_scene = ""}).bodies()[0].velocity[0],
              100, 1e-9);
}

TEST(OwnDecks, CasesHaveTheirVelocities) {
  const Simulation both = run_deck("cases.k", {.chosen_case = 101, .lenient = false, .name_in_scene = ""});
  EXPECT_NEAR(both.bodies()[0].mass_initial, 8e-9, 1e-20);
  EXPECT_NEAR(both.bodies()[1].mass_initial, 64e-9, 1e-19);
  EXPECT_NEAR(both.bodies()[1].velocity[1], 7, 1e-12) << "of two keywords the last one counts";
  const Simulation first = run_deck("cases.k", {.chosen_case = 1, .lenient = false, .name_in_scene = ""});
  EXPECT_NEAR(first.bodies()[0].velocity[0], 5, 1e-12);
  EXPECT_NEAR(run_deck("cases.k").bodies()[0].velocity[0], 0, 1e-12);
}

/// Uniaxial strain by small steps of ln(height): K ln(h) and the deviator with a return to the yield surface.
struct UniaxialStrain {
  double (*radius)(double plastic_strain);  ///< of the yield surface, as a stress
  double shift_modulus = 0;                 ///< of the back stress, over the plastic strain
  double plastic_strain = 0, shift = 0, deviator = 0, work = 0;

  void stretch(double from, double to) {
    constexpr int steps = 20000;
    constexpr double young = 210000, poisson = 0.3, bulk = young / 3 / (1 - 2 * poisson),
                     shear = young / 2 / (1 + poisson);
    for (int i = 0; i < steps; ++i) {
      const double h0 = from + (to - from) * i / steps, h1 = from + (to - from) * (i + 1) / steps;
      const double before = bulk * std::log(h0) + deviator;
      deviator += 4.0 / 3 * shear * std::log(h1 / h0);
      const double effective = 1.5 * std::abs(deviator - shift), excess = effective - radius(plastic_strain);
      if (excess > 0) {
        const double slope = (radius(plastic_strain + 1e-7) - radius(plastic_strain)) / 1e-7;
        const double flow = excess / (3 * shear + slope + shift_modulus), sign = deviator > shift ? 1 : -1;
        plastic_strain += flow;
        deviator -= sign * 2 * shear * flow;
        shift += sign * 2.0 / 3 * shift_modulus * flow;
      }
      work += 0.5 * (before + bulk * std::log(h1) + deviator) * (h1 - h0);
    }
  }
};

TEST(OwnDecks, MaterialsYieldAsAnIndependentIntegrationDoes) {
  constexpr double slope = 210000.0 * 21000 / (210000 - 21000);
  UniaxialStrain kinematic{[](double p) { return 400 + 0.5 * slope * p; }, 0.5 * slope};
  UniaxialStrain curve{[](double p) { return p < 0.002 ? 400 + 25000 * p : 450 + (p - 0.002) * 200 / 0.998; }};
  for (UniaxialStrain* one : {&kinematic, &curve}) {
    one->stretch(1, 1.01);
    one->stretch(1.01, 1);
  }
  const Simulation s = run_deck("materials.k");
  EXPECT_EQ(s.bodies()[0].max_plastic_strain, 0);
  EXPECT_NEAR(s.bodies()[1].max_plastic_strain / kinematic.plastic_strain, 1, 2e-3);
  EXPECT_NEAR(s.bodies()[2].max_plastic_strain / curve.plastic_strain, 1, 2e-3);
  EXPECT_NEAR(s.energies().internal / (kinematic.work + curve.work), 1, 2e-3);
}

TEST(OwnDecks, MotionIsThatOfItsCurves) {
  const Simulation s = run_deck("motion.k");
  std::vector<double> begun(24), moved(24);
  s.copy(NodeField::initial_position, view_records(begun.data(), 8, 3));
  s.copy(NodeField::position, view_records(moved.data(), 8, 3));
  for (std::size_t n = 0; n < 8; ++n) {
    EXPECT_NEAR(moved[3 * n] - begun[3 * n], 1.8, 1e-9) << n;
    EXPECT_NEAR(moved[3 * n + 1] - begun[3 * n + 1], 2.4, 1e-9) << n;
    EXPECT_NEAR(moved[3 * n + 2] - begun[3 * n + 2], 0, 1e-9) << n;
  }
}

TEST(OwnDecks, VelocitiesOfLaterKeywordsCount) {
  const Simulation s = run_deck("velocities.k");
  const Point left = s.bodies()[0].velocity, right = s.bodies()[1].velocity;
  EXPECT_NEAR(left[0], 0.5, 1e-12);
  EXPECT_NEAR(left[2], 1.5, 1e-12);
  EXPECT_NEAR(right[0], 8.0 / 8, 1e-12);
  EXPECT_NEAR(right[1], 2 * 7.0 / 8, 1e-12);
}

/// A mesh of 40 elements rounds the front of a wave: some of the energy stays in waves behind it.
TEST(OwnDecks, ABarReboundsFromAWallAsTheWaveEquationSays) {
  const Simulation s = run_deck("wall.k");
  constexpr double mass = 40e-9, velocity = 10;
  const double impulse = s.summary().walls.at(0).impulse;
  EXPECT_NEAR(s.bodies()[0].velocity[2] / velocity, 1, 0.05);
  EXPECT_NEAR(impulse / (2 * mass * velocity), 1, 0.025);
  EXPECT_NEAR(impulse, mass * (velocity + s.bodies()[0].velocity[2]), 1e-9 * impulse) << "momentum";
}

TEST(OwnDecks, LoadsAccelerateAFreeCube) {
  const Point velocity = run_deck("loads.k").bodies()[0].velocity;
  EXPECT_NEAR(velocity[0], 27 * 0.001 / 8e-6, 1e-6);
  EXPECT_NEAR(velocity[1], -0.001 / 8e-6, 1e-6);
  EXPECT_NEAR(velocity[2], -20, 1e-9);
}

TEST(OwnDecks, BarsSwapTheirVelocities) {
  const Simulation s = run_deck("contact.k");
  EXPECT_NEAR(s.bodies()[0].velocity[2], -10, 0.4);
  EXPECT_NEAR(s.bodies()[1].velocity[2], 0, 0.4);
  EXPECT_NEAR(s.bodies()[0].velocity[2] + s.bodies()[1].velocity[2], -10, 1e-9) << "momentum";
}

TEST(OwnDecks, CouplesOfSetsSwapTheirVelocitiesAndOthersGoThrough) {
  const Simulation s = run_deck("pairs.k");
  const auto velocity = [&](std::size_t body) { return s.bodies()[body].velocity[2]; };
  for (const std::size_t struck : {0, 2}) {
    EXPECT_NEAR(velocity(struck), -10, 0.4) << struck;
    EXPECT_NEAR(velocity(struck) + velocity(struck + 1), -10, 1e-9) << struck;
  }
  EXPECT_NEAR(velocity(4), 0, 1e-12) << "the contact has ended";
  EXPECT_NEAR(velocity(5), -10, 1e-12);
}

TEST(OwnDecks, WhatIsTiedStaysTogether) {
  const Simulation s = run_deck("tied.k");
  constexpr double mass = 1e-6, force = 4 * 0.0015, time = 0.01;
  double momentum = 0;
  for (std::size_t b = 0; b < 4; ++b) momentum += mass * s.bodies()[b].velocity[2];
  EXPECT_DOUBLE_EQ(s.bodies()[2].mass_initial, mass) << "its nodes are put on the faces";
  EXPECT_NEAR(momentum / (-force * time), 1, 1e-9);
  EXPECT_EQ(s.bodies()[3].velocity[2], 0) << "tied to nothing";
  std::vector<double> places(3 * 32);
  s.copy(NodeField::position, view_records(places.data(), 32, 3));
  for (std::size_t node : {4, 5, 6, 7, 12, 13, 14, 15}) {
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(places[3 * node + k], places[3 * (node + 4) + k], 1e-12) << node << k;
  }
  EXPECT_THAT(s.summary().mesh_warnings,
              UnorderedElementsAre(
                  HasSubstr("bodies tied_by_nodes and free: 4 pairs of nodes lie on each other"),
                  AllOf(HasSubstr("contact.tied has moved 4 nodes"), HasSubstr("tied_by_nodes"), HasSubstr("11.1 %"))));
}

TEST(OwnDecks, PressureGivesItsMomentum) {
  Simulation s(scene_of_deck(own_deck("pressure.k")));
  while (!s.at_end()) s.step();
  const double of_last_half_step = s.dt() * s.dt() / 8 * 2e5;  // it has the value at its end, of 2e5 t
  s.run();
  const Point expected[3] = {{0, 0, -10}, {10, 2.5 + of_last_half_step, 0}, {0, 0, 0}};
  for (std::size_t b = 0; b < 3; ++b) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(s.bodies()[b].velocity[k], expected[b][k], 1e-6) << b << k;
  }
}

TEST(OwnDecks, WallsStopTheirNodesAndSlowDown) {
  const Simulation s = run_deck("walls.k");
  constexpr double bar = 20e-9, ram = 40e-9, speed = 10, time = 1.2e-4;
  const double impedance = std::sqrt(100 * 1e-9);  // rho c A
  const WallResult floor = s.summary().walls.at(0), moving = s.summary().walls.at(1);
  EXPECT_NEAR(floor.impulse / (impedance * speed * time), 1, 0.025);
  EXPECT_NEAR(floor.impulse, bar * (speed + s.bodies()[0].velocity[2]), 1e-9 * floor.impulse) << "momentum";
  EXPECT_NEAR(s.bodies()[1].velocity[2], -speed, 1e-12) << "no wall is for it";
  EXPECT_NEAR(moving.velocity / speed, std::exp(-impedance * time / ram), 0.02);
  EXPECT_NEAR((ram * moving.velocity + bar * s.bodies()[2].velocity[2]) / (ram * speed), 1, 1e-9) << "momentum";
}

TEST(OwnDecks, SetsHaveTheirMembers) {
  const Simulation s = run_deck("sets.k");
  EXPECT_NEAR(s.bodies()[0].velocity[2], 3.0 / 4, 1e-3) << "the free layer has a quarter of the mass";
}

TEST(OwnDecks, RigidPartsMoveAsTheirCardsSay) {
  const Simulation s = run_deck("rigid.k");
  const std::vector<RigidBodyResult> rigid = s.summary().rigid_bodies;
  ASSERT_EQ(rigid.size(), 3U);
  constexpr double time = 1e-2;
  const Point thrown{0.5 + 100 * time, 0.4 + 200 * time, 0.7 + 300 * time}, lifted{5.5, 0.5, 1 + 2 * 1.5};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(rigid[0].centre[k], thrown[k], 1e-9) << k;
    EXPECT_NEAR(rigid[1].centre[k], lifted[k], 1e-9) << k;
  }
  EXPECT_NEAR(rigid[0].angular_momentum[2], 50 * 4e-9, 1e-18);
  EXPECT_NEAR(rigid[2].velocity[2], -9810 * time, 1e-9);
  EXPECT_NEAR(rigid[2].centre[2], 0.5 - 9810 * time * time / 2, 1e-3);
  std::vector<double> places(3 * static_cast<std::size_t>(s.nodes()));
  s.copy(NodeField::position, view_records(places.data(), s.nodes(), 3));
  const double angle = 2, x = std::cos(angle) - std::sin(angle), y = std::sin(angle) + std::cos(angle);
  bool found = false;
  for (std::size_t n = 0; n < places.size(); n += 3)
    found = found || std::hypot(places[n] - 5.5 - 0.5 * x, places[n + 1] - 0.5 - 0.5 * y, places[n + 2] - 5) < 1e-9;
  EXPECT_TRUE(found) << "the corner that was at (6, 1, 2)";
}

TEST(OwnDecks, ControlsAreThoseOfTheRun) {
  const Scene scene = scene_of_deck(own_deck("controls.k"));
  EXPECT_EQ(scene.output.interval, 0.05);
  EXPECT_EQ(scene.output.field_interval, 0.5);
  Simulation s(scene);
  s.run();
  EXPECT_NEAR(s.bodies()[0].velocity[2], 10 * std::exp(-2.0), 2e-3);
  EXPECT_EQ(s.probes().at(0).name, "node_17");
}

/// The deck holds the places of nodes that one build has found; where another rounds otherwise, so does all that
/// follows.
TEST(OwnDecks, TheTaylorBarIsThatOfItsSceneToTheLastBit) {
  Scene of_deck = scene_of_deck(own_deck("taylor_bar.k"));
  Scene of_scene = read_scene(PINBALL_SOURCE_DIR "/data/scenes/taylor_bar.toml");
  of_deck.time.steps = of_scene.time.steps = 300;
  Simulation deck(of_deck), scene(of_scene);
  const auto nodes = static_cast<std::size_t>(scene.nodes());
  ASSERT_EQ(deck.nodes(), scene.nodes());
  std::vector<double> given(3 * nodes), made(3 * nodes);
  deck.copy(NodeField::initial_position, view_records(given.data(), deck.nodes(), 3));
  scene.copy(NodeField::initial_position, view_records(made.data(), scene.nodes(), 3));
  for (std::size_t i = 0; i < made.size(); ++i) ASSERT_NEAR(given[i], made[i], 1e-14 * 32.4) << i;
  deck.run();
  scene.run();
  if (given == made) {
    EXPECT_EQ(deck.state_hash(), scene.state_hash());
  }
  EXPECT_EQ(deck.steps(), scene.steps());
  EXPECT_NEAR(deck.bodies()[0].velocity[2], scene.bodies()[0].velocity[2], 1e-9 * 227);
  EXPECT_NEAR(deck.bodies()[0].max_plastic_strain, scene.bodies()[0].max_plastic_strain, 1e-9);
}

/// Yield curves and linear hardening are kernels of their own: the last digits differ, and then what erodes first.
TEST(OwnDecks, TheRodGoesThroughThePlateAsInItsScene) {
  const Simulation deck = run_deck("rod_plate.k");
  Simulation scene(
      read_scene(PINBALL_SOURCE_DIR "/data/scenes/rod_plate.toml", SceneOverrides{{{"contact.enforcement=lagrange"}}}));
  scene.run();
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_NEAR(static_cast<double>(deck.bodies()[b].eroded_elements),
                static_cast<double>(scene.bodies()[b].eroded_elements), 4);
    EXPECT_NEAR(deck.bodies()[b].mass_initial / scene.bodies()[b].mass_initial, 1, 1e-12);
    EXPECT_NEAR(deck.bodies()[b].velocity[0], scene.bodies()[b].velocity[0], 0.004 * 55566);
    EXPECT_NEAR(deck.bodies()[b].velocity[2], scene.bodies()[b].velocity[2], 0.004 * 55566);
  }
}

}  // namespace
}  // namespace pinball::test::own_decks_test

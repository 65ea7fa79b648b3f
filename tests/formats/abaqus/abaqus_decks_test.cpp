#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <solver/formats/abaqus/cards/abaqus_scene.hpp>
#include <tests/support/solver_case.hpp>

/// The decks in data/decks/abaqus, one per group of keywords, against what is known of each.
namespace pinball::test::abaqus_decks_test {
namespace {

class AbaqusDecks : public testing::Test {
 protected:
  /// A deck that has run to its end.
  const Solver<double>& run_of(const std::string& name) {
    const std::string path = PINBALL_SOURCE_DIR "/data/decks/abaqus/" + name + ".inp";
    solver_.emplace(read_scene(translate_abaqus(path).source(path)));
    run_to_end(*solver_);
    return *solver_;
  }
  static double stress(const Solver<double>& solver, std::size_t element) {
    const auto s = stress_of(solver, element);
    return s[2] - (s[0] + s[1]) / 2;  // drawn along z
  }
  static RunSummary summarize(const Solver<double>& solver) {
    RunSummary summary;
    fill_summary(solver, summary);
    return summary;
  }
  static Point velocity(const Solver<double>& solver, std::size_t body) {
    return summarize(solver).bodies[body].velocity;
  }

  std::optional<Solver<double>> solver_;
};

/// The strain is the logarithm of the length; what of it is not elastic is plastic, and the stress is that of the
/// table.
TEST_F(AbaqusDecks, TensionFollowsTheTable) {
  const Solver<double>& solver = run_of("tension");
  const double strain = summarize(solver).bodies[0].max_plastic_strain;
  EXPECT_NEAR(strain, std::log(1.1) - stress(solver, 0) / 210000, 2e-5);
  EXPECT_NEAR(stress(solver, 0), 400 + 30 * (strain - 0.08) / 0.12, 0.5);
}

/// One rate in all: 100 over the length, which has become 1.05.
TEST_F(AbaqusDecks, RatesRaiseTheYieldStress) {
  const Solver<double>& solver = run_of("rates");
  const double rate = 100 / 1.05;
  const auto strain = [&](std::size_t body) { return summarize(solver).bodies[body].max_plastic_strain; };
  EXPECT_NEAR(stress(solver, 0) / (1e6 * (1 + std::pow(rate / 40, 0.2))), 1, 0.01);
  EXPECT_NEAR(stress(solver, 1) / (1e6 * (1 + rate / 200)), 1, 0.01);
  EXPECT_NEAR(stress(solver, 2) / (1e6 + 2e6 * rate / 200 + 1e7 * strain(2)), 1, 0.01);
  EXPECT_NEAR(stress(solver, 3) / (1e6 + 1e7 * strain(3)), 1, 0.01);
  EXPECT_NEAR(stress(solver, 4) / ((1e6 + 3e6 * std::sqrt(strain(4))) * (1 + 0.1 * std::log(rate / 2))), 1, 0.01);
}

/// Plastic work warms both: the first one softens as its yield stress over strain and temperature says, the second one,
/// of a constant yield stress, grows as its energy does.
TEST_F(AbaqusDecks, HeatSoftensAndExpands) {
  const Solver<double>& solver = run_of("heat");
  const double strain = summarize(solver).bodies[0].max_plastic_strain, heat_capacity = 7.85e-9 * 4.6e8;
  double warmer = 0, yield = 0;
  constexpr int steps = 100000;
  for (int i = 0; i < steps; ++i) {
    const double middle = strain * (i + 0.5) / steps;
    yield = (800 + 600 * std::pow(middle, 0.25)) * (1 - std::pow(warmer / 1520, 1.1));
    warmer += 0.8 * yield * strain / steps / heat_capacity;
  }
  EXPECT_GT(warmer, 100) << "which takes 5 % of the strength";
  EXPECT_NEAR(stress(solver, 0) / yield, 1, 1e-3);
  // p = K mu + gamma e = -q/3, the energy e that of the stress q, at most 1000, along the logarithm of the length.
  const double bulk = 175000, gamma = 3 * bulk * 5e-5 * 0.9 / heat_capacity;
  double energy = 0, volume = 1;
  for (int i = 0; i < steps; ++i) {
    const double q = std::min(1000.0, 210000 * std::log(1.5) * i / steps);
    energy += q * volume * std::log(1.5) / steps;
    volume = 1 / (1 - (q / 3 + gamma * energy) / bulk);
  }
  const Point far = position_of(solver, 14), near = position_of(solver, 8);
  EXPECT_GT(std::log(volume), 0.015);
  EXPECT_NEAR(std::log((far[0] - near[0]) * (far[1] - near[1]) * (far[2] - near[2])) / std::log(volume), 1, 2e-3);
}

/// What acts on a free body, integrated over time, over its mass.
TEST_F(AbaqusDecks, LoadsGiveTheirMomentum) {
  const Solver<double>& solver = run_of("loads");
  const Point expected[3] = {{0.06, 0, -0.1}, {2, -1, -0.1}, {0, -0.04, -0.1}};
  for (std::size_t body = 0; body < 3; ++body) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(velocity(solver, body)[k], expected[body][k], 1e-9) << body << k;
  }
}

/// Both move as one, damped by exp(-alpha t); wedges have half of a cube each.
TEST_F(AbaqusDecks, SectionsStayJoined) {
  const Solver<double>& solver = run_of("sections");
  EXPECT_NEAR(summarize(solver).bodies[0].mass_initial, 8e-9, 1e-20);
  EXPECT_NEAR(summarize(solver).bodies[1].mass_initial, 2e-9, 1e-20);
  EXPECT_EQ(solver.mesh().nodes.size(), 12u);
  for (const std::size_t body : {0, 1}) EXPECT_NEAR(velocity(solver, body)[2], 1000 * std::exp(-0.1), 1e-3) << body;
}

/// Equal bars exchange their velocities, but for what the front of the wave loses to viscosity.
TEST_F(AbaqusDecks, ImpactExchangesVelocities) {
  const Solver<double>& solver = run_of("impact");
  EXPECT_NEAR(velocity(solver, 0)[2] + velocity(solver, 1)[2], -10000, 1e-6);
  EXPECT_NEAR(velocity(solver, 0)[2], -10000, 400);
}

/// The same by a pair of surfaces, while a third bar goes through one of them.
TEST_F(AbaqusDecks, PairsTouchAndOthersDoNot) {
  const Solver<double>& solver = run_of("pairs");
  EXPECT_NEAR(velocity(solver, 0)[2] + velocity(solver, 1)[2], -10000, 1e-6);
  EXPECT_NEAR(velocity(solver, 0)[2], -10000, 400);
  EXPECT_NEAR(velocity(solver, 2)[2], 10000, 1e-6);
}

/// And by general contact, where one pair of bars is excluded.
TEST_F(AbaqusDecks, WhatIsExcludedGoesThrough) {
  const Solver<double>& solver = run_of("exclusions");
  EXPECT_NEAR(velocity(solver, 0)[2] + velocity(solver, 1)[2], -10000, 1e-6);
  EXPECT_NEAR(velocity(solver, 0)[2], -10000, 400);
  EXPECT_NEAR(velocity(solver, 2)[2], 10000, 1e-6);
}

/// Nodes and an element by their instances.
TEST_F(AbaqusDecks, HistoryWatchesNodesAndElements) {
  const std::vector<ProbeResult> probes = summarize(run_of("history")).probes;
  ASSERT_EQ(probes.size(), 3u);
  const auto value = [](const ProbeResult& probe, const std::string& quantity) {
    for (const ProbeValue& one : probe.values) {
      if (one.quantity == quantity) return one.value;
    }
    return std::nan("");
  };
  EXPECT_EQ(probes[0].name, "node_A_7");
  EXPECT_NEAR(value(probes[0], "displacement_x"), 0.02, 1e-12);
  EXPECT_EQ(probes[1].name, "node_B_2");
  EXPECT_NEAR(value(probes[1], "displacement_z"), -0.04, 1e-12);
  EXPECT_EQ(probes[2].name, "element_B_1");
  EXPECT_EQ(value(probes[2], "plastic_strain"), 0);
}

/// What the second step lets go goes on as it was, and what it moves follows its amplitude, which begins with it.
TEST_F(AbaqusDecks, StepsFollowEachOther) {
  const Solver<double>& solver = run_of("steps");
  EXPECT_NEAR(velocity(solver, 0)[0], 3, 1e-9);
  EXPECT_NEAR(velocity(solver, 0)[2], 4, 1e-9);
  EXPECT_NEAR(position_of(solver, 0)[0], 3 * 0.02 / 2, 1e-3);
  EXPECT_NEAR(position_of(solver, 0)[2], 4 * 0.03, 1e-9);
}

/// What is tied stays together, and keeps its momentum.
TEST_F(AbaqusDecks, TiedBarsStayTogether) {
  const Solver<double>& solver = run_of("tied");
  EXPECT_NEAR(velocity(solver, 0)[2] + velocity(solver, 1)[2], 10000, 1e-6);
  const std::size_t tip = 80, base = 84;  // the first nodes of the last layer of one, and of the first of the other
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(position_of(solver, tip + i)[2], position_of(solver, base + i)[2], 1e-9) << i;
  EXPECT_GT(position_of(solver, base)[2], 10.01) << "both have been drawn";
}

/// Pressure times area over time, against the outward normal.
TEST_F(AbaqusDecks, PressureGivesItsMomentum) {
  const Solver<double>& solver = run_of("pressure");
  const Point expected[3] = {{0, 0, -0.015}, {-0.02, 0, 0}, {0, 0, -0.1}};
  for (std::size_t body = 0; body < 3; ++body) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(velocity(solver, body)[k], expected[body][k], 1e-7) << body << k;
  }
}

/// What falls is all that hangs together; what is moved goes its way.
TEST_F(AbaqusDecks, RigidElementsWeighWhatTheirReferenceNodesDo) {
  const RunSummary summary = summarize(run_of("rigid_elements"));
  const double cube = 7.85e-9, hammer = 5e-9, time = 1e-3, gravity = 9810;
  const auto of = [&](const std::string& name) {
    return *std::ranges::find(summary.rigid_bodies, name, &RigidBodyResult::name);
  };
  EXPECT_NEAR(of("Hammer_Sides").mass, hammer + cube / 2, 1e-9 * hammer);
  const double plate = of("Plate_All").mass, falling = -(hammer + cube) * gravity * time;
  EXPECT_NEAR(summary.momentum_final[2] - plate * 200, falling, 1e-3 * std::abs(falling));
  EXPECT_NEAR(of("Hammer_Sides").velocity[2], -gravity * time, 2e-3 * gravity * time) << "the cube swings below it";
  const double behind = 0.25 * (2 + std::sqrt(2.0)) / 3 / 2;  // half of the layer
  EXPECT_NEAR(of("Plate_All").centre[2], 200 * time - behind, 1e-9);
}

/// The punch goes by the integral of a velocity that grows, and stops; the third one's centre is half a length and a
/// half from its reference node.
TEST_F(AbaqusDecks, RigidBodiesMoveAsTheirReferenceNodes) {
  const std::vector<RigidBodyResult> rigid = summarize(run_of("rigid")).rigid_bodies;
  ASSERT_EQ(rigid.size(), 3U);
  const auto of = [&](const std::string& name) { return *std::ranges::find(rigid, name, &RigidBodyResult::name); };
  const Point pushed{0.5, 0.5, 0.5 - 300 * 0.01 / 2}, turning{6, 1, 0.5},
      flying{10.5 + 100 * 0.02, 0.5 + 150 * 0.02, 0.5};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(of("Punch").centre[k], pushed[k], k == 2 ? 300 * 2e-5 + 1e-9 : 1e-9) << k << ": it stops within a step";
    EXPECT_NEAR(of("Punch").velocity[k], 0, 1e-9) << k;
    EXPECT_NEAR(of("Turning").centre[k], turning[k], 1e-12) << k;
    EXPECT_NEAR(of("Flying").centre[k], flying[k], 1e-9) << k;
  }
  EXPECT_NEAR(of("Flying").angular_velocity[2], 50, 1e-9);
  EXPECT_NEAR(of("Turning").angular_velocity[2], 3 / 0.02, 1e-6);
}

}  // namespace
}  // namespace pinball::test::abaqus_decks_test

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <solver/results/warnings.hpp>
#include <solver/step/energy_watch.hpp>
#include <solver/step/report.hpp>
#include <tests/support/solver_case.hpp>

/// What a run is watched for: each warning in a scene made for it, with number, time and place.
namespace pinball::soundness_test {
namespace {

using namespace test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;

RunSummary summary_of(const Solver<double>& solver) {
  RunSummary summary;
  fill_summary(solver, summary);
  return summary;
}

RunSummary result_of(const Scene& scene) {
  Solver<double> solver(scene);
  run(solver);
  return summary_of(solver);
}

/// Two blocks of 3 x 3 x 3 elements that meet at 40 m/s.
Scene impact(const Point& boost = {}) {
  const double gap = touching_gap * 0.025 * 1.05;
  Scene scene = scene_of({block("lower", {3, 3, 3}, 0.025, {0, 0, 0}, {boost[0], boost[1], boost[2] + 20}),
                          block("upper", {3, 3, 3}, 0.025, {0, 0, 0.075 + gap}, {boost[0], boost[1], boost[2] - 20})},
                         1e-4);
  return scene;
}

TEST(Soundness, ABoostHidesNothing) {
  Scene scene = impact(), boosted = impact({300, -500, 800});
  scene.contact.beta = boosted.contact.beta = 3;  // springs too stiff for the step in which they begin
  scene.guard.energy_error = boosted.guard.energy_error = 10;
  const RunSummary at_rest = result_of(scene), flying = result_of(boosted);
  EXPECT_GT(at_rest.balance_error_max, 0.02);
  EXPECT_LT(flying.balance_error_max, 0.01 * at_rest.balance_error_max);
  EXPECT_NEAR(at_rest.balance_error_in_motion.largest, at_rest.balance_error_max, 1e-12);
  EXPECT_NEAR(flying.balance_error_in_motion.largest, at_rest.balance_error_max, 1e-3 * at_rest.balance_error_max);
  EXPECT_NEAR(flying.energy_in_motion, at_rest.energy_in_motion, 1e-6 * at_rest.energy_in_motion);
}

/// Two bodies that overlap at the start, and two bars that cross without a node inside.
TEST(Soundness, OverlapsAtTheStartHaveBodiesDepthAndPlace) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 1, {0, 0, 0}), block("b", {2, 2, 2}, 1, {0.3, 0.4, 1.6})}, 1);
  const RunSummary of_blocks = summary_of(Solver<double>(scene));
  ASSERT_EQ(of_blocks.overlaps.size(), 1U);
  const OverlapResult& blocks = of_blocks.overlaps[0];
  EXPECT_EQ(blocks.first + ", " + blocks.second, "a, b");
  EXPECT_EQ(of_blocks.overlapping_bodies, "a and b");
  EXPECT_EQ(blocks.nodes, 8);
  EXPECT_NEAR(blocks.depth, 0.4, 1e-12);
  EXPECT_NEAR(blocks.share, 0.4, 1e-12);
  EXPECT_THAT(blocks.place, MatchesRegex("node [0-9]+ of body [ab]"));
  scene.bodies[0].mesh = BlockMesh{{4, 1, 1}, {1, 1, 1}};
  scene.bodies[1].mesh = BlockMesh{{1, 4, 1}, {1, 1, 1}};
  scene.bodies[1].position = {1.5, -1.5, 0.3};
  const RunSummary of_bars = summary_of(Solver<double>(scene));
  ASSERT_EQ(of_bars.overlaps.size(), 1U);
  EXPECT_EQ(of_bars.overlaps[0].nodes, 0);
  EXPECT_GT(of_bars.overlaps[0].points, 0);
  EXPECT_EQ(of_bars.overlaps[0].place, "");
}

/// One element that vibrates at the step's own frequency: velocities before and after are opposite at the turning
/// points.
TEST(Soundness, KineticEnergyBelowZeroIsReportedApart) {
  Scene scene = scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, 0})}, 1e-3, false);
  scene.bodies[0].velocity_gradient = {{{10, 0, 0}, {0, 10, 0}, {0, 0, 10}}};
  Solver<double> solver(scene);
  double least = 0;
  for (int step = 0; step < 50 && !solver.at_end(); ++step) {
    solver.step();
    const Energies kept = solver.energies(), reported = history_row(solver).energy;
    EXPECT_EQ(reported.kinetic, std::max(0.0, kept.kinetic));
    EXPECT_EQ(reported.kinetic_below_zero, std::min(0.0, kept.kinetic));
    EXPECT_EQ(reported.total(), kept.total());
    EXPECT_EQ(summary_of(solver).energy.kinetic_below_zero, reported.kinetic_below_zero);
    least = std::min(least, reported.kinetic_below_zero);
  }
  EXPECT_LT(least, -1e-3 * solver.initial_energy());
}

TEST(Soundness, ABodyThatFliesAloneHasNoError) {
  Scene scene = scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0}, {1000, 200, 1})}, 1e-3, false);
  EXPECT_LT(result_of(scene).balance_error_in_motion.largest, 1e-3);
  Solver<float> solver(scene);
  run(solver);
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-2);
}

TEST(Soundness, AgainstAWallAllOfItIsInMotion) {
  Scene scene = scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0}, {7, 0, -100})}, 1e-5, false);
  scene.rigid_walls = {{"floor", {{0, 0, 0}, {0, 0, 1}}, "", "here"}};
  const double mass = 7850 * 0.027;
  EXPECT_NEAR(result_of(scene).energy_in_motion, 0.5 * mass * 1e4, 1e-6 * mass * 1e4) << "but for the flight along it";
  scene.rigid_walls[0].friction = 0.1;
  EXPECT_NEAR(result_of(scene).energy_in_motion, 0.5 * mass * (1e4 + 49), 1e-6 * mass * 1e4);
}

TEST(Soundness, TheGuardOfTheEnergySeesWhatABoostHides) {
  Scene scene = impact({0, 0, 1000});
  scene.guard.energy_error = 0.1;
  Solver<double> solver(scene);
  solver.step();
  auto& velocity = solver.change_model().nodes.velocity;
  for (std::size_t n = 0; n < 64; ++n) velocity[4 * n] += 30;
  EXPECT_THROW(solver.step(), RunError);
  EXPECT_LT(std::abs(solver.balance_error()), 1e-2);
}

TEST(Soundness, AnErrorOfTheBalanceHasATimeAndAnElement) {
  Scene scene = impact();
  scene.contact.beta = 30;
  scene.guard.energy_error = 10;
  EXPECT_THAT(
      warnings(result_of(scene)),
      testing::Contains(MatchesRegex("the energy balance was off by up to .* % of the energy in motion, beyond 10 "
                                     "% since time .*the step was set by element .* of body .*")));
}

TEST(Soundness, SoftSpringsHaveATimeAndANode) {
  Scene scene = impact();
  scene.contact.beta = 1e-3;
  scene.time.end = 6e-4;
  EXPECT_THAT(
      warnings(result_of(scene)),
      testing::Contains(MatchesRegex("bodies went into each other by up to .* % of the radii of their pinballs, at "
                                     "time .* at node .* of body .*: try a larger contact.beta.*")));
  EXPECT_THAT(warnings(result_of(impact())), IsEmpty());
}

TEST(Soundness, ADepthThatWasNotSeenComingIsSeen) {
  Scene scene = scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0}), block("b", {3, 3, 3}, 0.1, {0.02, 0.03, 0.28})}, 1e-5);
  scene.contact.method = ContactMethod::slideline;
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  const RunSummary result = result_of(scene);
  const double radius = std::cbrt(3 / (4 * M_PI)) * 0.1;
  EXPECT_GT(result.max_penetration_ratio, 0.9 * 0.02 / (2 * radius));
  EXPECT_THAT(result.max_penetration_place, MatchesRegex("node .* of body [ab]"));
  EXPECT_THAT(warnings(result), testing::Contains(HasSubstr("bodies went into each other")));
}

TEST(Soundness, BodiesThatAreInEachOtherAtTheEndAreSeenByTheirPlaces) {
  Scene scene = impact();
  scene.contact.beta = 1e-4;
  scene.time.end = 6e-4;
  EXPECT_THAT(
      warnings(result_of(scene)),
      testing::Contains(MatchesRegex("bodies are in each other at the end, at time 0.0006, more than 20 % of an "
                                     "element deep: lower and upper, by .* of their nodes.*")));
  EXPECT_EQ(result_of(impact()).overlap_at_end, "");
  scene.contact_pairs = {{.name = "p", .first = {.bodies = {"lower"}}, .second = {.bodies = {"upper"}}}};
  EXPECT_NE(result_of(scene).overlap_at_end, "");
  scene.contact_pairs[0].end = 1e-4;
  EXPECT_EQ(result_of(scene).overlap_at_end, "") << "contact is over";
  scene.contact_pairs.clear();
  scene.contact.method = ContactMethod::none;
  EXPECT_EQ(result_of(scene).overlap_at_end, "") << "they are meant to";
}

/// A block that flies into another before contact between them begins.
Scene begun_late(double start) {
  Scene scene = scene_of(
      {block("a", {2, 2, 2}, 0.1, {0, 0, 0}), block("b", {2, 2, 2}, 0.1, {0.03, 0.04, 0.21}, {0, 0, -100})}, 8e-4);
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  scene.contact_pairs = {{.name = "p", .first = {.bodies = {"a"}}, .second = {.bodies = {"b"}}}};
  scene.contact_pairs[0].start = start;
  return scene;
}

TEST(Soundness, OverlapsWhereContactBeginsLaterAreToldWithTheirTime) {
  Solver<double> solver(begun_late(4e-4));
  while (solver.force_time() < 4e-4) {
    EXPECT_TRUE(solver.begun_overlaps().empty()) << solver.time();
    solver.step();
  }
  const double time = solver.force_time();
  const RunSummary summary = summary_of(solver);
  ASSERT_EQ(summary.overlaps.size(), 1U);
  const OverlapResult& found = summary.overlaps[0];
  EXPECT_EQ(found.first + ", " + found.second, "a, b");
  EXPECT_EQ(found.nodes, 8);
  EXPECT_EQ(found.time, time);
  EXPECT_NEAR(found.depth, 100 * time - 0.01, 1e-9);
  EXPECT_NEAR(found.share, found.depth / 0.1, 1e-9);
  EXPECT_EQ(summary.overlapping_bodies, "") << "at the start";
  EXPECT_THAT(warnings(summary), testing::Contains(MatchesRegex(
                                     "bodies a and b overlap when their contact begins, at time 0.0004.*, by 8 of "
                                     "their nodes, deepest at node [0-9]+ of body [ab], which lies 0.03.* deep "
                                     "\\(3.* % of an element\\): contact cannot tell from which side they "
                                     "came.*")));
  EXPECT_TRUE(start_warnings(summary).empty());
}

TEST(Soundness, ContactThatBeginsBeforeBodiesMeetIsNotTold) {
  EXPECT_TRUE(result_of(begun_late(5e-5)).overlaps.empty());
  Scene over = begun_late(4e-4);
  over.contact_pairs[0].end = 3e-4;
  EXPECT_TRUE(result_of(over).overlaps.empty()) << "it never begins";
}

TEST(Soundness, OverlapsThatWereToldAreSavedWithTheState) {
  Solver<double> solver(begun_late(4e-4)), later(begun_late(4e-4));
  while (solver.force_time() < 5e-4) solver.step();
  StateBytes bytes;
  StateArchive::save(bytes, [&](StateArchive& archive) { solver.persist(archive); });
  StateArchive archive = StateArchive::reading({bytes.data(), static_cast<std::size_t>(bytes.size())});
  later.persist(archive);
  ASSERT_EQ(later.begun_overlaps().size(), 1U);
  EXPECT_EQ(later.begun_overlaps()[0].depth, solver.begun_overlaps()[0].depth);
  EXPECT_EQ(later.begun_overlaps()[0].first, "a");
}

/// A block that flies through the plane of a rigid wall before this begins, and one above it that stays there.
Scene wall_begun_late(double start) {
  Scene scene = scene_of(
      {block("a", {2, 2, 2}, 0.1, {0, 0, 0.01}, {0, 0, -100}), block("b", {2, 2, 2}, 0.1, {1, 0, 1})}, 8e-4, false);
  RigidWall& wall = scene.rigid_walls.emplace_back();
  wall.name = "floor";
  wall.where = "rigid_wall.0";
  wall.plane = {{0, 0, 0}, {0, 0, 1}};
  wall.when.start = start;
  return scene;
}

TEST(Soundness, NodesBehindAWallThatBeginsLaterAreTold) {
  Solver<double> solver(wall_begun_late(4e-4));
  while (solver.force_time() < 4e-4) {
    EXPECT_TRUE(solver.passed_walls().empty()) << solver.time();
    solver.step();
  }
  const double time = solver.force_time();
  const RunSummary summary = summary_of(solver);
  ASSERT_EQ(summary.overlaps.size(), 1U);
  const OverlapResult& found = summary.overlaps[0];
  EXPECT_EQ(found.first + ", " + found.second, "a, floor");
  EXPECT_TRUE(found.rigid_wall);
  EXPECT_EQ(found.nodes, 9);
  EXPECT_EQ(found.time, time);
  EXPECT_NEAR(found.depth, 100 * time - 0.01, 1e-9);
  EXPECT_NEAR(found.share, found.depth / 0.1, 1e-9);
  EXPECT_THAT(warnings(summary), testing::Contains(MatchesRegex(
                                     "rigid wall floor begins, at time 0.0004.*, when 9 nodes of body a lie behind it, "
                                     "the deepest, node [0-9]+ of body a, by 0.03.* \\(3.* % of an element\\).*")));
  EXPECT_THAT(summary.unlikely,
              testing::Contains(MatchesRegex("rigid_wall.0 begins at time 0.0004, when 9 nodes will lie behind it, the "
                                             "deepest, node [0-9]+ of body a, by 0.029[0-9]* or more.*")));
  StateBytes bytes;
  StateArchive::save(bytes, [&](StateArchive& archive) { solver.persist(archive); });
  Solver<double> later(wall_begun_late(4e-4));
  StateArchive archive = StateArchive::reading({bytes.data(), static_cast<std::size_t>(bytes.size())});
  later.persist(archive);
  ASSERT_EQ(later.passed_walls().size(), 1U);
  EXPECT_EQ(later.passed_walls()[0].depth, found.depth);
}

TEST(Soundness, AWallThatBeginsBeforeNodesPassItIsNotTold) {
  const auto told = [](const Scene& scene) {
    const RunSummary summary = result_of(scene);
    return !summary.overlaps.empty() || !summary.unlikely.empty();
  };
  EXPECT_FALSE(told(wall_begun_late(5e-5)));
  Scene scene = wall_begun_late(4e-4);
  EXPECT_TRUE(told(scene));
  scene.rigid_walls[0].when.end = 3e-4;
  EXPECT_TRUE(result_of(scene).overlaps.empty()) << "it never begins";
  scene.rigid_walls[0].when.end = 6e-4;
  scene.rigid_walls[0].nodes.body = "b";
  EXPECT_FALSE(told(scene)) << "not for it to stop";
  scene.rigid_walls[0].nodes.body = "";
  scene.rigid_walls[0].edge = Point{1, 0, 0};
  scene.rigid_walls[0].plane.point = {0.5, 0, 0};
  scene.rigid_walls[0].size = {1, 1};
  EXPECT_FALSE(told(scene)) << "beside it";
  scene.rigid_walls[0].plane.point = {0, 0, 0};
  EXPECT_EQ(result_of(scene).overlaps.size(), 1U);
  scene.bodies[0].position[2] -= 1;
  EXPECT_FALSE(told(scene)) << "below it altogether";
}

TEST(Soundness, ABendOfOneLayerIsAllHourglassEnergy) {
  Scene scene = scene_of({block("beam", {8, 1, 1}, 0.1, {0, 0, 0})}, 4e-3, false);
  scene.element.hourglass_coefficient = 1;
  FixedConstraint fixed;
  fixed.nodes.plane = Plane{{0, 0, 0}, {1, 0, 0}};
  fixed.directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene.fixed_constraints = {fixed};
  NodalLoad load;
  load.nodes.plane = Plane{{0.8, 0, 0}, {1, 0, 0}};
  load.force = {0, 0, 1e4};
  scene.loads = {load};
  EXPECT_THAT(
      warnings(result_of(scene)),
      ElementsAre(MatchesRegex("hourglass energy reached .* % of the internal energy, beyond 10 % since time .*most "
                               "of it in element . of body beam.*")));
}

TEST(Soundness, ABodyAtRestIsSound) {
  const RunSummary result = result_of(scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0})}, 1e-4, false));
  EXPECT_THAT(warnings(result), IsEmpty());
  EXPECT_EQ(result.hourglass_large.largest, 0);
}

/// Energies that no sound scene has.
class Ledger {
 public:
  Ledger() {
    ledger_.set_drift(50, 1e-9);
    ledger_.close(true, 150);
    watch_.look(ledger_, 0.1, 0);
  }
  void book(double hourglass, double contact, double internal, double time) {
    ElementWork elements;
    elements.hourglass = hourglass;
    elements.internal = internal;
    ContactWork work;
    work.dissipated = contact;
    ledger_.book(elements, work, 0, 1);
    ledger_.close(false,
                  150 - ledger_.energies().contact() - ledger_.energies().hourglass - ledger_.energies().internal);
    watch_.look(ledger_, 0.1, time);
  }
  EnergyLedger ledger_;
  EnergyWatch watch_;
};

TEST(EnergyWatch, EnergyOutOfContactIsFoundWhenItGoesBeyondItsBound) {
  Ledger run;
  run.book(0, -0.5, 0, 1);
  EXPECT_FALSE(run.watch_.just_beyond(Watched::contact_created)) << "0.5 % of the 100 in motion";
  run.book(0, -5.5, 0, 2);
  EXPECT_TRUE(run.watch_.just_beyond(Watched::contact_created));
  run.book(0, 1, 0, 3);
  EXPECT_FALSE(run.watch_.just_beyond(Watched::contact_created));
  EXPECT_DOUBLE_EQ(run.watch_.share(Watched::contact_created), 0.06);
  EXPECT_EQ(run.watch_.since(Watched::contact_created), 2);
}

TEST(EnergyWatch, WhatContactGivesBackItHasNotSwallowed) {
  Ledger run;
  run.book(0, 12, 0, 1);
  EXPECT_TRUE(run.watch_.just_beyond(Watched::contact_swallowed));
  run.book(0, -8, 0, 2);
  EXPECT_DOUBLE_EQ(run.watch_.share(Watched::contact_swallowed), 0.04);
  run.book(0, 20, 0, 3);
  EXPECT_DOUBLE_EQ(run.watch_.share(Watched::contact_swallowed), 0.24);
  EXPECT_EQ(run.watch_.since(Watched::contact_swallowed), 3);
}

TEST(EnergyWatch, HourglassEnergyIsComparedWithTheLargestInternalEnergy) {
  Ledger run;
  run.book(0.05, 0, 0, 1);
  EXPECT_DOUBLE_EQ(run.watch_.share(Watched::hourglass_large), 0.05) << "of a hundredth of what is in motion";
  run.book(0.95, 0, 8, 2);
  EXPECT_TRUE(run.watch_.just_beyond(Watched::hourglass_large));
  EXPECT_DOUBLE_EQ(run.watch_.share(Watched::hourglass_large), 1.0 / 8);
  run.book(-1.2, 0, -6, 3);
  EXPECT_TRUE(run.watch_.just_beyond(Watched::hourglass_created));
  EXPECT_DOUBLE_EQ(run.watch_.share(Watched::hourglass_created), 0.2 / 8);
}

}  // namespace
}  // namespace pinball::soundness_test

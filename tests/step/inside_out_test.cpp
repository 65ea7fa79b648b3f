#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solver/results/warnings.hpp>
#include <solver/step/inside_out.hpp>
#include <solver/step/report.hpp>
#include <tests/support/pressed_block.hpp>
#include <tests/support/saved_state.hpp>

/// Elements whose corners turn over: what keeps them from it, and what is told where nothing does.
namespace pinball::inside_out_test {
namespace {

using namespace test;
using testing::HasSubstr;

template <class S>
RunSummary summary_of(Solver<S>& solver) {
  run(solver);
  RunSummary summary;
  fill_summary(solver, summary);
  return summary;
}

RunSummary result(const Scene& scene) {
  Solver<double> solver(scene);
  return summary_of(solver);
}

/// Bodies of one element, one corner of each pushed down along its edge, of one more than of the others.
TEST(InsideOut, AnyElementMayBeTheOneThatIsMostFolded) {
  constexpr std::size_t count = 4;
  Scene scene = scene_of({}, 1e-3, false);
  for (std::size_t b = 0; b < count; ++b) {
    scene.bodies.push_back(block("body" + std::to_string(b), {1, 1, 1}, 1, {2.0 * static_cast<double>(b), 0, 0}));
  }
  scene.element.inside_out = InsideOut::stop;
  scene.bodies[0].element = scene.element;
  scene.bodies[0].element->inside_out = InsideOut::warn;
  for (std::size_t most = 0; most < count; ++most) {
    Model<double> model = build_model<double>(scene);
    for (std::size_t b = 0; b < count; ++b) {
      const std::int32_t corner = model.mesh.hexahedra[b][4];
      const double down = b == most ? 0.75 : 0.125 * static_cast<double>(1 + (b + 1) % count);
      model.nodes.position[4 * static_cast<std::size_t>(model.node_of_scene_node[corner]) + 2] -= down;
    }
    const FoldedElement found = most_folded(model, 0.0, false);
    EXPECT_EQ(found.slot, model.slot_of_element[most]) << most;
    EXPECT_NEAR(found.share, 0.25 / (1 - 0.75 / 4), 1e-12) << "of its volume that is left";
    const FoldedElement of_those = most_folded(model, 0.0, true);
    EXPECT_NE(of_those.slot, model.slot_of_element[0]) << "its body does not stop";
    EXPECT_EQ(of_those.slot == model.slot_of_element[most], most != 0);
    model.elements.mass[static_cast<std::size_t>(model.slot_of_element[most])] = 0;
    EXPECT_NE(most_folded(model, 0.0, false).slot, model.slot_of_element[most]) << "eroded";
  }
}

TEST(InsideOut, ABlockThatIsCrushedDoesNotFold) {
  const RunSummary summary = result(pressed_block(ElementSettings{}.folding_resistance));
  EXPECT_EQ(summary.inside_out.most, 0);
  EXPECT_EQ(summary.inside_out.first_place, "");
  EXPECT_GT(summary.energy.folding, 0);
  EXPECT_LT(std::abs(summary.final_total - summary.initial_total), 1e-3 * summary.energy.external)
      << "what corners store is part of the balance";
  EXPECT_THAT(warnings(summary), testing::Not(testing::Contains(HasSubstr("inside out"))));
}

TEST(InsideOut, NorDoesItInSinglePrecision) {
  Solver<float> solver(pressed_block(ElementSettings{}.folding_resistance));
  EXPECT_EQ(summary_of(solver).inside_out.most, 0);
}

TEST(InsideOut, WhereNothingResistsElementsAreCountedAndTheFirstIsTold) {
  Solver<double> solver(pressed_block(0));
  double first = 0;
  while (!solver.at_end()) {
    solver.step();
    if (first == 0 && solver.inside_out().now() > 0) first = solver.force_time();
  }
  const RunSummary summary = summary_of(solver);
  EXPECT_GE(summary.inside_out.most, 12);
  EXPECT_EQ(summary.inside_out.elements, solver.inside_out().now());
  EXPECT_EQ(summary.inside_out.first_time, first);
  EXPECT_THAT(summary.inside_out.first_place, HasSubstr(" of body b"));
  EXPECT_EQ(summary.energy.folding, 0);
  EXPECT_THAT(warnings(summary), testing::Contains(HasSubstr("elements were inside out at a corner: ")));
}

TEST(InsideOut, ItMayErode) {
  Scene scene = pressed_block(0);
  scene.element.inside_out = InsideOut::erode;
  const RunSummary summary = result(scene);
  EXPECT_GT(summary.bodies[0].eroded_elements, 0);
  EXPECT_EQ(summary.inside_out.most, 0);
  EXPECT_LT(std::abs(summary.final_total - summary.initial_total), 0.02 * summary.energy.external);
}

TEST(InsideOut, ItMayStopTheRun) {
  Scene scene = pressed_block(0);
  scene.element.inside_out = InsideOut::stop;
  EXPECT_THAT(error_of<RunError>([&] { result(scene); }),
              testing::AllOf(HasSubstr("elements are inside out at a corner in step "), HasSubstr(" of body b: try")));
  // Those of another body may.
  scene.element.inside_out = InsideOut::warn;
  scene.bodies.push_back(block("other", {1, 1, 1}, 5e-3, {1, 1, 1}));
  scene.bodies.back().element = scene.element;
  scene.bodies.back().element->inside_out = InsideOut::stop;
  EXPECT_GT(result(scene).inside_out.most, 0);
}

TEST(InsideOut, ARunGoesOnWithWhatItHasCounted) {
  const Scene scene = pressed_block(0);
  Solver<double> whole(scene), rest(scene);
  while (whole.inside_out().now() < 3) whole.step();
  const StateBytes state = saved(whole);
  EXPECT_EQ(load(rest, state), 0U);
  const RunSummary a = summary_of(whole), b = summary_of(rest);
  EXPECT_EQ(b.inside_out.elements, a.inside_out.elements);
  EXPECT_EQ(b.inside_out.most, a.inside_out.most);
  EXPECT_EQ(b.inside_out.first_time, a.inside_out.first_time);
  EXPECT_EQ(b.inside_out.first_place, a.inside_out.first_place);
  EXPECT_EQ(b.energy.hourglass_plastic, a.energy.hourglass_plastic);
}

/// Round-off may be all that moves it: places and stresses stay what they are.
TEST(InsideOut, AMeshThatBeginsPoorlyIsLeftAsItIs) {
  const std::vector<double> nodes{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0.45, 0.45, 0.45, 0, 1, 1};
  const std::vector<std::int32_t> corners{0, 1, 2, 3, 4, 5, 6, 7};
  Body body;
  body.name = "b";
  body.material = "steel";
  body.mesh = ArrayMesh{view_records(nodes.data(), 8, 3), view_records(corners.data(), 1, 8), 0, {}};
  Scene scene = scene_of({body}, 1e-2, false);
  scene.element = ElementSettings{};
  Solver<double> solver(scene);
  run(solver);
  EXPECT_EQ(solver.energies().folding, 0);
  EXPECT_LT(kinetic_energy(solver), 1e-15);
}

TEST(InsideOut, WhatHourglassModesLoseByYieldingIsPartOfTheInternalEnergy) {
  const RunSummary summary = result(pressed_block(ElementSettings{}.folding_resistance));
  EXPECT_GT(summary.energy.hourglass_plastic, 10 * summary.energy.hourglass);
  EXPECT_LT(summary.energy.hourglass_plastic, summary.energy.internal);
}

}  // namespace
}  // namespace pinball::inside_out_test

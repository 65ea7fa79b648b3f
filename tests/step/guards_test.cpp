#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <tests/support/error_of.hpp>
#include <tests/support/solver_case.hpp>

/// What ends a run that has gone wrong, and what it says.
namespace pinball {
namespace {

using namespace test;
using testing::AllOf;
using testing::HasSubstr;

/// What a step fails with.
template <class S>
std::string failure(Solver<S>& solver) {
  return error_of<RunError>([&] { solver.step(); });
}

Scene two_bodies() {
  return scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0}), block("b", {3, 2, 2}, 0.1, {1, 0, 0})}, 1e-3, false);
}

template <class S>
void expect_element_named() {
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Solver<S> solver(two_bodies());
    for (int i = 0; i < 5; ++i) solver.step();
    auto& model = solver.change_model();
    // Elements are numbered through all bodies.
    model.elements.stress[ElementStore<S>::at(model.slot_of_element[11], 4, 6)] = static_cast<S>(value);
    EXPECT_THAT(failure(solver), AllOf(HasSubstr("the stress of element 11 of body b is not finite in step 5"),
                                       HasSubstr("try a smaller time.cfl")));
  }
}

TEST(Guards, TheElementIsNamedInWhichANumberIsNotFinite) {
  expect_element_named<double>();
  expect_element_named<float>();
}

TEST(Guards, AnElementBesideAVelocityThatIsNotFiniteIsNamed) {
  Scene scene = two_bodies();
  NodalLoad load;
  load.nodes.body = "b";
  load.force = {std::numeric_limits<double>::infinity(), 0, 0};
  scene.loads = {load};
  Solver<double> solver(scene);
  EXPECT_THAT(failure(solver), AllOf(HasSubstr("a node of element 8 of body b"), HasSubstr("not finite in step 0"),
                                     HasSubstr("look at loads")));
}

TEST(Guards, AnEnergyThatOverflowsIsFound) {
  Scene scene = two_bodies();
  scene.bodies[0].velocity = {1e200, 0, 0};
  Solver<double> solver(scene);
  EXPECT_THAT(failure(solver), HasSubstr("the energy is not finite in step 0"));
}

TEST(Guards, TheElementWithTheLeastVolumeIsNamed) {
  Scene scene = two_bodies();
  scene.guard.energy_error = 1e30;
  Solver<double> solver(scene);
  solver.step();
  auto& model = solver.change_model();
  const auto& corners = model.mesh.hexahedra[9];
  const auto node = [&](std::size_t i) {
    return 4 * static_cast<std::size_t>(model.node_of_scene_node[static_cast<std::size_t>(corners[i])]);
  };
  for (std::size_t i = 0; i < 4; ++i) {  // its faces change places, its neighbours get longer
    for (std::size_t k = 0; k < 4; ++k) {
      std::swap(model.nodes.position[node(i) + k], model.nodes.position[node(i + 4) + k]);
    }
  }
  EXPECT_THAT(failure(solver),
              AllOf(HasSubstr("elements have no volume left in step 1"),
                    HasSubstr(" of body b: try a smaller time.cfl"), HasSubstr("element.negative_volume=\"erode\"")));
}

TEST(Guards, TheEnergyBalanceHasABound) {
  Scene scene = two_bodies();
  scene.bodies[0].velocity = {1, 0, 0};
  scene.guard.energy_error = 1e-3;
  Solver<double> solver(scene);
  solver.step();
  solver.change_model().nodes.velocity[0] *= 2;
  EXPECT_THAT(failure(solver), AllOf(HasSubstr("the energy balance is off by"),
                                     HasSubstr("guard.energy_error = 0.1 %; the time step is set by element "),
                                     HasSubstr(": try a smaller time.cfl")));
}

TEST(Guards, ACollapsedStepNamesItsElement) {
  Scene scene = two_bodies();
  scene.element.negative_volume = NegativeVolume::stop;
  scene.element.folding_resistance = 0;  // else the elements beside it, whose corners turn over, set the step
  scene.guard.energy_error = 1e30;
  scene.guard.time_step_collapse = 0.5;
  Solver<double> solver(scene);
  solver.step();
  auto& model = solver.change_model();
  const auto flatten = [&](std::size_t i, std::size_t onto) {
    const auto& corners = model.mesh.hexahedra[19];  // the last one, at a corner of its body
    const auto at = [&](std::size_t corner) {
      return 4 * static_cast<std::size_t>(model.node_of_scene_node[static_cast<std::size_t>(corners[corner])]) + 2;
    };
    model.nodes.position[at(onto)] = model.nodes.position[at(i)] + 1e-3;
  };
  for (std::size_t i = 0; i < 4; ++i) flatten(i, i + 4);
  EXPECT_THAT(failure(solver),
              AllOf(HasSubstr("the stable step has collapsed to"), HasSubstr("guard.time_step_collapse = 0.5"),
                    HasSubstr("set by element 19 of body b: try an erosion_strain")));
}

}  // namespace
}  // namespace pinball

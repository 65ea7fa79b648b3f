#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <solver/step/guards.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/solver_case.hpp>

/// What ends a run that has gone wrong, and what it says.
namespace pinball::guards_test {
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
    model.elements.stress[model.elements.at(model.slot_of_element[11], 4, 6)] = value;
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
  EXPECT_THAT(failure(solver), AllOf(HasSubstr("elements have no volume left in step 1"),
                                     HasSubstr("first of all element 9 of body b: try a smaller time.cfl"),
                                     HasSubstr("element.negative_volume=\"erode\"")));
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

/// What a guard says of a model by itself.
template <class S, class Check>
std::string said_of(const Model<S>& model, const Check& check) {
  const StepClock clock(model.scene.time);
  const Guards<S> guards(model, clock);
  return error_of<RunError>([&] { check(guards); });
}

template <class S>
std::string not_finite(const Model<S>& model) {
  return said_of(model, [](const Guards<S>& guards) { guards.check_finite(std::nan("")); });
}

/// With all arrays that an element may have.
Scene with_all_of_an_element() {
  Scene scene = two_bodies();
  scene.materials = {plastic_material("steel", 3e8, 0.5)};
  scene.materials[0].isotropic_share = 0.5;
  scene.element.bulk_viscosity = true;
  return scene;
}

TEST(Guards, EveryNumberOfAnElementIsLookedAt) {
  const Model<double> sound = build_model<double>(with_all_of_an_element());
  EXPECT_THAT(not_finite(sound), HasSubstr("the energy is not finite in step 0 at time 0, though all elements are"));
  struct Part {
    RealArray ElementStore::*array;
    int components;
    const char* name;
  };
  using Store = ElementStore;
  for (const Part& part :
       {Part{&Store::stress, 6, "stress"}, Part{&Store::plastic_strain, 1, "plastic strain"},
        Part{&Store::hourglass_state, 12, "hourglass force"}, Part{&Store::viscous_stress, 1, "bulk viscosity"},
        Part{&Store::internal_energy, 1, "internal energy"}, Part{&Store::material_state, 5, "back stress"}}) {
    for (int component = 0; component < part.components; ++component) {
      const std::size_t element = static_cast<std::size_t>(component) % 2 == 0 ? 0 : 19;  // the first and the last
      Model<double> model = build_model<double>(with_all_of_an_element());
      RealArray& array = model.elements.*part.array;
      ASSERT_FALSE(array.empty()) << part.name;
      array[model.elements.at(model.slot_of_element[element], component, part.components)] = std::nan("");
      EXPECT_THAT(not_finite(model), AllOf(HasSubstr("the " + std::string(part.name) + " of element "),
                                           HasSubstr(element == 0 ? "element 0 of body a is" : "element 19 of body b")))
          << component;
    }
  }
}

TEST(Guards, NumbersOfAMaterialAreToldByTheirNames) {
  Scene scene = with_all_of_an_element();
  Material& m = scene.materials[0];
  m.isotropic_share = 1;
  m.plastic_modulus = 0;
  m.johnson_cook = JohnsonCookSettings{0, 1, 0, 1, 1, 1000, 300, 450, 1, {0.1, 0.1, 0, 0, 0}};
  m.equation_of_state.emplace();
  m.equation_of_state->sound_speed = 4000;
  const MaterialPlaces places = build_model<double>(scene).constants[0].places;
  ASSERT_EQ(places.numbers, 3);
  for (const auto& [place, name] : {std::pair{places.temperature, "temperature"},
                                    {places.energy, "energy of the equation of state"},
                                    {places.damage, "damage"}}) {
    Model<double> model = build_model<double>(scene);
    model.elements.material_state[model.elements.at(model.slot_of_element[19], place, 3)] = std::nan("");
    EXPECT_THAT(not_finite(model), HasSubstr("the " + std::string(name) + " of element 19 of body b"));
  }
}

TEST(Guards, EveryPlaceAndVelocityOfACornerIsLookedAt) {
  for (std::size_t component = 0; component < 3; ++component) {
    for (const bool place : {true, false}) {
      Model<double> model = build_model<double>(two_bodies());
      const std::int32_t corner = model.mesh.hexahedra[19][6];  // of no other element
      const std::size_t at = 4 * static_cast<std::size_t>(model.node_of_scene_node[corner]) + component;
      (place ? model.nodes.position : model.nodes.velocity)[at] = std::numeric_limits<double>::infinity();
      EXPECT_THAT(not_finite(model), HasSubstr("a node of element 19 of body b has a velocity that is not finite"));
    }
  }
}

/// Squeezes bodies of one element, one of them more than the others.
TEST(Guards, AnyElementMayBeTheOneWithTheLeastVolume) {
  constexpr std::size_t count = 5;
  Scene scene = scene_of({}, 1e-3, false);
  for (std::size_t b = 0; b < count; ++b) {
    scene.bodies.push_back(block("body" + std::to_string(b), {1, 1, 1}, 0.1, {static_cast<double>(b), 0, 0}));
  }
  InternalForceResult<double> found;
  found.inverted_count = 3;
  const auto squeezed = [&](std::size_t least) {
    Model<double> model = build_model<double>(scene);
    for (std::size_t b = 0; b < count; ++b) {
      for (const std::int32_t node : model.mesh.hexahedra[b]) {
        model.nodes.position[4 * static_cast<std::size_t>(model.node_of_scene_node[node]) + 2] *=
            b == least ? -0.5 : 0.1 * static_cast<double>(b + 1);
      }
    }
    return model;
  };
  const auto said = [&](const Model<double>& model) {
    return said_of(model, [&](const Guards<double>& guards) { guards.check_volumes(found); });
  };
  for (std::size_t least = 0; least < count; ++least) {
    const std::string name = std::to_string(least);
    EXPECT_THAT(said(squeezed(least)), HasSubstr("3 of 5 elements have no volume left in step 0 at time 0, first of "
                                                 "all element " +
                                                 name + " of body body" + name + ":"));
  }
  Model<double> model = squeezed(0);
  model.elements.mass[static_cast<std::size_t>(model.slot_of_element[0])] = 0;
  EXPECT_THAT(said(model), HasSubstr("element 1 of body body1:")) << "what is eroded has none to lose";
  found.inverted_count = 0;
  EXPECT_EQ(said(model), no_error);
}

TEST(Guards, AStepThatMovesTheTimeNoFurtherEndsTheRun) {
  const Model<double> model = build_model<double>(two_bodies());
  TimeSettings time = model.scene.time;
  StepClock clock(time);
  const Guards<double> guards(model, clock);
  clock.choose({}, {1e-6, model.slot_of_element[3]}, 0);
  EXPECT_EQ(error_of<RunError>([&] { guards.check_time_step(); }), no_error);
  StepClock lost(time);
  lost.choose({}, {1e-30, model.slot_of_element[3]}, 0);
  EXPECT_THAT(error_of<RunError>([&] { Guards<double>(model, lost).check_time_step(); }),
              AllOf(HasSubstr("no number of steps of "), HasSubstr("reaches time.end = 0.001"),
                    HasSubstr("the step is set by element 3 of body a")));
}

/// What holds a rigid body against its weight moves it by nothing but rounding, whose energies balance by chance.
TEST(Guards, DoNotStopWhatRoundingMoves) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.5, {0, 0, 0})}, 15);
  RigidBody rigid;
  rigid.name = "a";
  rigid.bodies = {"a"};
  scene.rigid_bodies = {rigid};
  RigidMotion held;
  held.rigid_body = "a";
  held.direction = Point{0, 0, -1};
  scene.rigid_motions = {held};
  scene.gravities = {{{0, 0, -0.02}, {}}};
  scene.time.steps = 50;
  Solver<double> solver(scene);
  EXPECT_NO_THROW(run(solver));
  EXPECT_LT(solver.ledger().balance_error_in_motion_max(), 1e-9);
}

}  // namespace
}  // namespace pinball::guards_test

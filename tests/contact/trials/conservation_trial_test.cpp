#include <vector>

#include "trial.hpp"
#include "turned_body.hpp"

/// What contact has to keep: angular momentum and energy.
namespace pinball::conservation_trial_test {
namespace {

using namespace test;

class ConservationTrial : public TrialTest {};
INSTANTIATE_TEST_SUITE_P(All, ConservationTrial, testing::ValuesIn(variants), variant_name);

constexpr double h = 0.1;

/// Change of the total angular momentum over what the bodies have exchanged, the sum of its changes from step to step.
double angular_momentum_error(const Matrix& rotation, double friction, const Variant& variant) {
  const Body target = block("target", {5, 4, 3}, h, {-0.25, -0.2, -0.3}, {1, 2, 0});
  const double reach = reach_down({0.21, 0.21, 0.28}, rotation);
  Body striker;
  striker.name = "striker";
  striker.material = "steel";
  striker.mesh = BlockMesh{{0.21, 0.21, 0.28}, {3, 3, 4}};
  striker = turned(striker, rotation, {0.113, 0.071, reach + 0.3 * h});
  striker.velocity = {8, -3, -30};
  Scene scene = trial_scene({target, striker}, 2.5e-3);
  scene.contact.friction = friction;
  Solver<double> solver(with_contact(scene, variant));
  const auto total = [&] {
    Point sum = angular_momentum_of_body(solver, 0);
    const Point other = angular_momentum_of_body(solver, 1);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += other[k];
    return sum;
  };
  const Point before = total();
  Point last = angular_momentum_of_body(solver, 1);
  double exchanged = 0;
  while (!solver.at_end()) {
    solver.step();
    const Point now = angular_momentum_of_body(solver, 1);
    exchanged += norm(minus(now, last));
    last = now;
  }
  return norm(minus(total(), before)) / exchanged;
}

TEST_P(ConservationTrial, AngularMomentumIsKept) {
  also_holds({"slideline_lagrange"});
  const std::vector<std::pair<const char*, Matrix>> attitudes{{"flat", turn(2, 11)},
                                                              {"nearly flat", times(turn(0, 3), turn(1, 5))},
                                                              {"a little tilted", times(turn(0, 12), turn(1, 9))},
                                                              {"tilted", times(turn(0, 31), turn(1, 22))}};
  for (const auto& [name, rotation] : attitudes) {
    for (const double friction : {0.0, 0.3}) {
      if (friction > 0 && GetParam().enforcement == Enforcement::penalty) continue;  // springs have none
      const std::string trial = fmt::format("angular momentum, {}, friction {}", name, friction);
      at_most(trial, run_of(trial, [&] { return angular_momentum_error(rotation, friction, GetParam()); }), 1e-6);
    }
  }
}

/// Largest energy in motion and in the elements on the way, over that at the start, and the least energy of the
/// contact.
struct EnergyMade {
  double mechanical = 0, contact = 0;
};
EnergyMade energy_made(const Scene& scene) {
  Solver<double> solver(scene);
  EnergyMade most;
  run_to_end(solver, [&] {
    const Energies& e = solver.energies();
    const double start = solver.initial_energy();
    most.mechanical = std::max(most.mechanical, (e.kinetic + e.internal + e.hourglass) / start);
    most.contact = std::min(most.contact, e.contact() / start);
  });
  return most;
}

/// Two blocks that touch from the start, with other meshes.
Scene touching(double together, double towards) {
  Body upper;
  upper.name = "upper";
  upper.material = "steel";
  upper.mesh = BlockMesh{{0.4, 0.4, 0.3}, {5, 5, 3}};
  upper.velocity = {together, 0.3 * together, 0.7 * together - towards};
  Body lower = block("lower", {4, 4, 3}, h, {0, 0, -0.3}, {together, 0.3 * together, 0.7 * together + towards});
  return trial_scene({lower, upper}, 2e-3);
}

TEST_P(ConservationTrial, BlocksThatTouchMakeNoEnergy) {
  also_holds({"pinball_projection_face", "pinball_penalty_balls", "slideline_penalty", "slideline_projection",
              "slideline_lagrange"});
  struct Case {
    const char* name;
    double together, towards;
    bool held;
  };
  for (const Case& c : {Case{"fly together", 10, 0, false}, Case{"are pressed by their motion", 0, 1, false},
                        Case{"are pressed between held ends", 0, 1, true}}) {
    const std::string trial = fmt::format("blocks that {}", c.name);
    Scene scene = with_contact(touching(c.together, c.towards), GetParam());
    if (c.held) scene.fixed_constraints = {held_at("lower", -0.3), held_at("upper", 0.3)};
    const EnergyMade found = run_of(trial, [&] { return energy_made(scene); });
    at_most(trial + ", energy", found.mechanical, 1.001);
    at_least(trial + ", contact", found.contact, -1e-3);
  }
}

/// Two blocks of other meshes at rest, which touch and are pressed together by two forces. What they have beyond the
/// work of these contact has made.
TEST_P(ConservationTrial, BlocksThatAreHeldTogetherGetTheWorkOfTheForces) {
  also_holds({"pinball_projection_face", "pinball_penalty_balls", "slideline_projection", "slideline_lagrange"});
  Scene scene = touching(0, 0);
  for (const double side : {-1.0, 1.0}) {
    NodalLoad load;
    load.nodes.plane = Plane{{0, 0, side * 0.3}, {0, 0, 1}};
    load.force = {0, 0, -side * 1e6};
    scene.loads.push_back(load);
  }
  const double made = run_of("blocks held together", [&] {
    Solver<double> solver(with_contact(scene, GetParam()));
    double most = 0, work = 0;
    run_to_end(solver, [&] {
      const Energies& e = solver.energies();
      work = std::max(work, e.external);
      most = std::max(most, e.kinetic + e.internal + e.hourglass - e.external);
    });
    return most / work;
  });
  at_most("blocks held together, energy made/work", made, 1e-3);
}

TEST_P(ConservationTrial, ACornerOnANodeMakesNoEnergy) {
  also_holds({"pinball_projection_face", "pinball_penalty_balls", "slideline_penalty", "slideline_lagrange"});
  struct Case {
    const char* name;
    Matrix rotation;
  };
  const double third = 1 / std::sqrt(3.0);
  for (const Case& c : {Case{"corner", shortest_turn({0, 0, 1}, {third, third, third})},
                        Case{"tilted corner", times(turn(2, 17), times(turn(0, 31), turn(1, 52)))}}) {
    Body cube = block("cube", {3, 3, 3}, h, {});
    const Point low = lowest_point({3 * h, 3 * h, 3 * h}, c.rotation);
    cube = turned(cube, c.rotation, {-low[0], -low[1], 0.02 * h - low[2]});
    cube.velocity = {0, 0, -20};
    Scene scene = trial_scene({block("plate", {6, 6, 2}, h, {-0.3, -0.3, -0.2}), cube}, 2e-3);
    scene.fixed_constraints = {held_at("plate", -0.2)};
    const std::string trial = fmt::format("a {} on a node", c.name);
    const EnergyMade found = run_of(trial, [&] { return energy_made(with_contact(scene, GetParam())); });
    at_most(trial + ", energy", found.mechanical, 1.001);
    at_least(trial + ", contact", found.contact, -1e-3);
  }
}

}  // namespace
}  // namespace pinball::conservation_trial_test

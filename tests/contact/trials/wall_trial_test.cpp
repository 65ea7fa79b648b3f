#include "trial.hpp"
#include "turned_body.hpp"

/// Nodes that are pressed between a body and a rigid wall.
namespace pinball::wall_trial_test {
namespace {

using namespace test;

class WallTrial : public TrialTest {};
INSTANTIATE_TEST_SUITE_P(All, WallTrial, testing::Values(variants[0], variants[1]), variant_name);

constexpr double h = 0.1;

/// Two blocks on a floor, with faces that lean: that of the one that comes overhangs the foot of the other, and presses
/// its nodes down as it pushes them on.
Scene overhang(double lean, double over, int elements, double friction) {
  const auto leaning = [&](const std::string& name, double by, const Point& corner) {
    return mapped(block(name, {2 * elements, elements, elements}, h / elements, {}), [&](const Point& x) {
      return Point{corner[0] + x[0] - by * x[2], corner[1] + x[1], corner[2] + x[2]};
    });
  };
  Body struck = leaning("struck", lean, {}), striker = leaning("striker", over, {2 * h + 0.001, 0.013, 0.001});
  striker.velocity = {-20, 0, 0};
  Scene scene = trial_scene({struck, striker}, 1.5e-3);
  scene.rigid_walls = {floor_of(friction)};
  return scene;
}

/// Projection left it by up to 27 % while its work was counted with velocities from before walls have acted.
TEST_P(WallTrial, NodesBetweenABodyAndAWallKeepTheBalance) {
  also_holds({"pinball_projection_face"});
  struct Case {
    double lean, over;
    int elements;
  };
  for (const Case& c : {Case{1, 0.5, 1}, {1, 0.5, 3}, {1, 0.8, 2}, {0.5, 0.4, 3}}) {
    const std::string trial = fmt::format("overhang, {} over {}, {} elements", c.over, c.lean, c.elements);
    const double balance = run_of(trial, [&] {
      Solver<double> solver(with_contact(overhang(c.lean, c.over, c.elements, 0), GetParam()));
      return worst_balance_of_run(solver);
    });
    at_most(trial + ", balance", balance, 5e-5);
  }
}

/// The wall may also come to the bodies.
TEST_P(WallTrial, NodesBetweenABodyAndAWallThatMovesKeepTheBalance) {
  also_holds({"pinball_projection_face"});
  Scene scene = overhang(1, 0.5, 3, 0);
  scene.rigid_walls[0].speed = 2;
  const double balance = run_of("moving wall", [&] {
    Solver<double> solver(with_contact(scene, GetParam()));
    return worst_balance_of_run(solver);
  });
  at_most("overhang on a wall that moves, balance", balance, 5e-5);
}

// ---- Friction at the wall -------------------------------------------------------------------------------------------

Scene rubbed_overhang(double lean, double over, int elements, double at_wall, double between) {
  Scene scene = overhang(lean, over, elements, at_wall);
  scene.contact.friction = scene.contact.static_friction = between;
  return scene;
}

/// Before contact knew of friction at walls: 6 to 23 %. Work of contact is counted with the velocities that nodes have,
/// so that projection, too, keeps the balance.
TEST_P(WallTrial, NodesThatABodyPressesOnAWallThatRubsKeepTheBalance) {
  also_holds({"pinball_projection_face"});
  struct Case {
    double lean, over;
    int elements;
    double at_wall, between;
  };
  for (const Case& c : {Case{1, 0.5, 1, 0.3, 0},
                        {1, 0.5, 3, 0.3, 0},
                        {1, 0.8, 2, 0.3, 0.3},
                        {0.5, 0.4, 3, 0.3, 0.3},
                        {1, 0.5, 3, 0.1, 0.4}}) {
    const std::string trial = fmt::format("overhang, {} over {}, {} elements, {} at the wall, {} between", c.over,
                                          c.lean, c.elements, c.at_wall, c.between);
    const double balance = run_of(trial, [&] {
      const Scene scene = rubbed_overhang(c.lean, c.over, c.elements, c.at_wall, c.between);
      Solver<double> solver(with_contact(scene, GetParam()));
      return worst_balance_of_run(solver);
    });
    at_most(trial + ", balance", balance, 5e-5);
  }
}

/// Walls that move, that end, that hold what touches them, beside nodes that are held or moved as given, and two walls
/// at a node.
TEST_P(WallTrial, AllKindsOfWallsThatRubKeepTheBalance) {
  also_holds({"pinball_projection_face"});
  const auto worst = [&](const std::string& trial, const auto& change) {
    const double balance = run_of(trial, [&] {
      Scene scene = rubbed_overhang(1, 0.5, 3, 0.3, 0.3);
      change(scene);
      Solver<double> solver(with_contact(scene, GetParam()));
      return worst_balance_of_run(solver);
    });
    at_most("overhang, " + trial + ", balance", balance, 5e-5);
  };
  const auto add_side = [](Scene& scene, const Plane& plane) {
    scene.rigid_walls.push_back(floor_of(0.3));
    scene.rigid_walls[1].name = "side";
    scene.rigid_walls[1].plane = plane;
    scene.bodies[1].velocity = {-20, -3, 0};
  };
  worst("moving wall", [](Scene& scene) { scene.rigid_walls[0].speed = 2; });
  worst("wall of finite size", [](Scene& scene) {
    scene.rigid_walls[0].plane.point = {-0.5, -0.5, 0};
    scene.rigid_walls[0].edge = Point{1, 0, 0};
    scene.rigid_walls[0].size = {2, 2};
  });
  worst("wall that holds", [](Scene& scene) {
    scene.rigid_walls[0].friction = 0;
    scene.rigid_walls[0].sliding = false;
  });
  worst("held obliquely", [](Scene& scene) {
    FixedConstraint held;
    held.nodes.body = "struck";
    held.directions = {{0, 0.96, 0.28}};
    scene.fixed_constraints = {held};
  });
  worst("drawn aside", [](Scene& scene) {
    PrescribedVelocity drawn;
    drawn.nodes.body = "struck";
    drawn.direction = Point{0, 1, 0};
    drawn.velocity = {0, 3, 0};
    scene.prescribed_velocities = {drawn};
  });
  worst("oblique wall beside it", [&](Scene& scene) { add_side(scene, Plane{{0, -0.02, 0}, {0, 0.8, 0.6}}); });
  worst("upright wall beside it", [&](Scene& scene) { add_side(scene, Plane{{0, -1e-6, 0}, {0, 1, 0}}); });
}

/// A wall that is pushed away, or goes away by itself, goes on to stop the nodes that are pressed on it.
TEST_P(WallTrial, NodesThatABodyPressesOnAWallThatGoesAwayKeepTheBalance) {
  for (const double friction : {0.0, 0.3}) {
    for (const double mass : {500.0, 0.0}) {
      const std::string trial = fmt::format("overhang on a wall of mass {} with friction {}", mass, friction);
      const double balance = run_of(trial, [&] {
        Scene scene = rubbed_overhang(1, 0.5, 3, friction, 0);
        scene.rigid_walls[0].mass = mass;
        if (mass == 0) {
          scene.rigid_walls[0].speed = -10;
          for (Body& body : scene.bodies) body.velocity[2] = -10;
        }
        Solver<double> solver(with_contact(scene, GetParam()));
        return worst_balance_of_run(solver);
      });
      at_most(trial + ", balance", balance, 1e-3);
    }
  }
}

/// A held body of other elements in place of the wall, and shorter steps, tell what the blocks should come to: 2,270 J.
TEST_P(WallTrial, FrictionAtAWallIsThatOnABodyInItsPlace) {
  const auto kinetic_at_end = [&](const std::string& trial, const Scene& scene) {
    return run_of(trial, [&] {
      Solver<double> solver(with_contact(scene, GetParam()));
      run_to_end(solver);
      return solver.energies().kinetic;
    });
  };
  Scene on_wall = rubbed_overhang(1, 0.5, 3, 0.3, 0.3), on_body = on_wall;
  on_body.rigid_walls = {};
  on_body.bodies.push_back(block("floor", {14, 8, 1}, 0.07, {-0.4, -0.2, -0.07}));
  on_body.fixed_constraints = {held("floor")};
  const double expected = kinetic_at_end("overhang on a body", on_body);
  compare("overhang on a wall that rubs, kinetic energy", kinetic_at_end("overhang on a wall", on_wall) / expected, 1,
          2e-3);
  on_wall.time.cfl *= 0.25;
  compare("overhang, steps of a quarter, kinetic energy", kinetic_at_end("overhang, short steps", on_wall) / expected,
          1, 4e-3);
}

}  // namespace
}  // namespace pinball::wall_trial_test

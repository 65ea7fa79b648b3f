#include <tests/support/scene_fixture.hpp>

/// Reading of what acts on a scene from outside.
namespace pinball::scene_boundary_test {
namespace {

using namespace test;

using SceneBoundaryTest = SceneTest;

TEST_F(SceneBoundaryTest, ReadsEveryKey) {
  const Scene scene = read(with({R"([[constraint]]
type = "fixed"
directions = ["x", [0, 3, 4]]
plane = { point = [1, 0, 0], normal = [2, 0, 0] }
body = "bar"
[[constraint]]
type = "fixed"
directions = "all"
frame = "cylindrical"
axis = { point = [1, 2, 3], direction = [0, 0, 2] }
line = { direction = [0, 1, 0] }
[[constraint]]
type = "symmetry"
normal = [0, 1, 0]
[[rigid_wall]]
name = "anvil"
point = [0, 0, -1]
normal = [0, 0, 5]
body = "bar"
[[rigid_wall]]
normal = [0, 1, 0]
[[prescribed_velocity]]
box = { low = [0, 0, 0], high = [1, 1, 0] }
velocity = [1, 2, 3]
times = [0, 1]
factors = [0, 2]
[[prescribed_velocity]]
nearest = [0, 0, 1]
direction = [0, 0, -2]
speed = 4
[[load]]
body = "bar"
force = [1, 2, 3]
times = [1]
factors = [2]
[[initial_velocity]]
body = "bar"
velocity = [7, 8, 9]
[damping]
mass = 3
[[probe]]
name = "tip"
point = [1, 1, 1]
[[probe]]
name = "middle"
kind = "element"
point = [0, 0, 0]
body = "bar"
quantities = ["plastic_strain", "stress"]
[output]
interval = "step")"}));
  ASSERT_EQ(scene.fixed_constraints.size(), 2u);
  const FixedConstraint& flat = scene.fixed_constraints[0];
  EXPECT_EQ(flat.frame, Frame::global);
  EXPECT_EQ(flat.directions, (std::vector<Point>{{1, 0, 0}, {0, 0.6, 0.8}}));
  EXPECT_EQ(flat.nodes.plane.value().point, (Point{1, 0, 0}));
  EXPECT_EQ(flat.nodes.plane.value().normal, (Point{1, 0, 0}));
  EXPECT_EQ(flat.nodes.body, "bar");
  EXPECT_EQ(flat.nodes.where, file_ + ":15:1: constraint.0");
  const FixedConstraint& round = scene.fixed_constraints[1];
  EXPECT_EQ(round.frame, Frame::cylindrical);
  EXPECT_EQ(round.directions.size(), 3u);
  EXPECT_EQ(round.axis.point, (Point{1, 2, 3}));
  EXPECT_EQ(round.axis.direction, (Point{0, 0, 1}));
  EXPECT_EQ(round.nodes.line.value().point, (Point{0, 0, 0}));
  EXPECT_EQ(round.nodes.line.value().direction, (Point{0, 1, 0}));
  ASSERT_EQ(scene.constraints.size(), 1u);
  EXPECT_EQ(scene.constraints[0].normal, (Point{0, 1, 0}));
  ASSERT_EQ(scene.rigid_walls.size(), 2u);
  EXPECT_EQ(scene.rigid_walls[0].name, "anvil");
  EXPECT_EQ(scene.rigid_walls[0].plane.point, (Point{0, 0, -1}));
  EXPECT_EQ(scene.rigid_walls[0].plane.normal, (Point{0, 0, 1}));
  EXPECT_EQ(scene.rigid_walls[0].body, "bar");
  EXPECT_EQ(scene.rigid_walls[1].name, "wall_1");
  ASSERT_EQ(scene.prescribed_velocities.size(), 2u);
  EXPECT_FALSE(scene.prescribed_velocities[0].direction);
  EXPECT_EQ(scene.prescribed_velocities[0].velocity, (Point{1, 2, 3}));
  EXPECT_EQ(scene.prescribed_velocities[0].table.factors, (std::vector<double>{0, 2}));
  EXPECT_EQ(scene.prescribed_velocities[0].nodes.box.value().high, (Point{1, 1, 0}));
  EXPECT_EQ(scene.prescribed_velocities[1].direction.value(), (Point{0, 0, -1}));
  EXPECT_EQ(scene.prescribed_velocities[1].velocity, (Point{0, 0, -4}));
  EXPECT_EQ(scene.prescribed_velocities[1].nodes.nearest.value(), (Point{0, 0, 1}));
  ASSERT_EQ(scene.loads.size(), 1u);
  EXPECT_EQ(scene.loads[0].force, (Point{1, 2, 3}));
  EXPECT_EQ(scene.loads[0].table.times, (std::vector<double>{1}));
  ASSERT_EQ(scene.initial_velocities.size(), 1u);
  EXPECT_EQ(scene.initial_velocities[0].velocity, (Point{7, 8, 9}));
  EXPECT_EQ(scene.damping.mass, 3.0);
  ASSERT_EQ(scene.probes.size(), 2u);
  EXPECT_EQ(scene.probes[0].kind, ProbeKind::node);
  EXPECT_EQ(scene.probes[0].quantities, (std::vector<std::string>{"position", "displacement", "velocity"}));
  EXPECT_EQ(scene.probes[1].kind, ProbeKind::element);
  EXPECT_EQ(scene.probes[1].quantities, (std::vector<std::string>{"plastic_strain", "stress"}));
  EXPECT_TRUE(scene.output.every_step);
}

TEST_F(SceneBoundaryTest, ReadsWhatEndsMovesAndPresses) {
  const Scene scene = read(with({R"([[constraint]]
type = "fixed"
directions = "all"
body = "bar"
tolerance = 0.25
start = 1
end = 2
[[constraint]]
type = "symmetry"
normal = [0, 1, 0]
set = "cut"
tolerance = 0.5
[[rigid_wall]]
normal = [0, 0, 5]
set = "skin"
without = "edge"
box = { low = [0, 0, 0], high = [1, 1, 0] }
sliding = false
mass = 4
speed = -3
edge = [2, 0, 0]
size = [1, 0]
end = 7
[[rigid_wall]]
normal = [0, 1, 0]
speed = 1
times = [0, 1]
factors = [0, 2]
[[prescribed_velocity]]
body = "bar"
velocity = [1, 2, 3]
start = 0.5
[[pressure]]
name = "gas"
body = "bar"
plane = { normal = [1, 0, 0] }
pressure = 5
times = [0, 1]
factors = [0, 2]
start = 3
[[pressure]]
faces = [[1, 2, 3, 4], [5, 6, 7, 7]]
file = "bar.k"
pressure = -1
[[gravity]]
acceleration = [0, 0, -1]
bodies = ["bar"]
[[initial_velocity]]
body = "bar"
angular_velocity = [7, 8, 9]
centre = [1, 1, 1]
components = ["x", "z"])"}));
  EXPECT_EQ(scene.fixed_constraints.at(0).nodes.tolerance, 0.25);
  EXPECT_EQ(scene.fixed_constraints[0].when.start, 1);
  EXPECT_EQ(scene.fixed_constraints[0].when.end, 2);
  EXPECT_EQ(scene.constraints.at(0).set, "cut");
  EXPECT_EQ(scene.constraints[0].tolerance, 0.5);
  const RigidWall& wall = scene.rigid_walls.at(0);
  EXPECT_EQ(wall.nodes.set, "skin");
  EXPECT_EQ(wall.nodes.without, "edge");
  EXPECT_EQ(wall.nodes.box.value().high, (Point{1, 1, 0}));
  EXPECT_FALSE(wall.sliding);
  EXPECT_EQ(wall.mass, 4);
  EXPECT_EQ(wall.speed, -3);
  EXPECT_EQ(wall.edge.value(), (Point{1, 0, 0}));
  EXPECT_EQ(wall.size, (std::array<double, 2>{1, 0}));
  EXPECT_EQ(wall.when.end, 7);
  EXPECT_EQ(scene.rigid_walls[1].table.factors, (std::vector<double>{0, 2}));
  EXPECT_EQ(scene.prescribed_velocities.at(0).when.start, 0.5);
  EXPECT_EQ(scene.pressures.at(0).name, "gas");
  EXPECT_EQ(scene.pressures[0].pressure, 5);
  EXPECT_EQ(scene.pressures[0].start, 3);
  EXPECT_TRUE(scene.pressures[0].faces.plane);
  EXPECT_EQ(scene.pressures[1].name, "pressure_1");
  EXPECT_EQ(scene.pressures[1].corners.at(1), (std::array<std::int64_t, 4>{5, 6, 7, 7}));
  EXPECT_EQ(scene.pressures[1].faces.file, "bar.k");
  EXPECT_EQ(scene.gravities.at(0).bodies, (std::vector<std::string>{"bar"}));
  EXPECT_EQ(scene.initial_velocities.at(0).angular_velocity, (Point{7, 8, 9}));
  EXPECT_EQ(scene.initial_velocities[0].centre, (Point{1, 1, 1}));
  EXPECT_EQ(scene.initial_velocities[0].components, (std::array<bool, 3>{true, false, true}));
}

TEST_F(SceneBoundaryTest, WhatDoesNotGoTogetherIsNamed) {
  const auto wall = [&](const std::vector<std::string>& keys) {
    std::vector<std::string> lines{"[[rigid_wall]]", "normal = [0, 0, 1]"};
    lines.insert(lines.end(), keys.begin(), keys.end());
    return error(with(lines));
  };
  EXPECT_EQ(wall({"mass = 1", "times = [0, 1]", "factors = [0, 1]"}),
            "18:9: rigid_wall.0.times: a wall with a mass moves as it is pushed, expected either mass or times");
  EXPECT_EQ(wall({"sliding = false", "friction = 0.5"}),
            "18:12: rigid_wall.0.friction: expected either friction or sliding = false, got both");
  EXPECT_EQ(wall({"size = [1, 1]"}),
            "15:1: rigid_wall.0.edge: missing, expected the direction of the first side beside size");
  EXPECT_EQ(wall({"size = [1, 1]", "edge = [0, 0, 3]"}),
            "18:8: rigid_wall.0.edge: expected a direction across the normal, got one along it");
  EXPECT_EQ(wall({"start = 2", "end = 1"}), "18:7: rigid_wall.0.end: expected a time > start and > 0, got 1");
  EXPECT_EQ(error(with({"[[pressure]]", "pressure = 1"})),
            "15:1: pressure.0.body: missing, expected at least one of body, plane, line, box, nearest, set and nodes");
  EXPECT_EQ(error(with({"[[pressure]]", "pressure = 1", "faces = [[1, 2, 3]]"})),
            "17:10: pressure.0.faces[0]: expected an array of 4 integers, got an array of 3 values");
  EXPECT_EQ(error(with({"[[gravity]]", "acceleration = [0, 0, 1]", "bodies = [\"baar\"]"})),
            "17:11: gravity.0.bodies[0]: expected \"bar\", got \"baar\"");
  EXPECT_EQ(error(with({"[[gravity]]", "acceleration = [0, 0, 1]", "bodies = []"})),
            "17:10: gravity.0.bodies: expected at least one of \"bar\", got none");
  EXPECT_EQ(error(with({"[[initial_velocity]]", "body = \"bar\"", "velocity = [0, 0, 1]", "components = []"})),
            "18:14: initial_velocity.0.components: expected at least one of \"x\", \"y\" or \"z\", got none");
}

TEST_F(SceneBoundaryTest, MissingAndWrongValues) {
  EXPECT_EQ(error(with({"[[rigid_wall]]", "normal = [0, 0, 0]"})),
            "16:10: rigid_wall.0.normal: expected a vector of non-zero, finite length, got [0, 0, 0]");
  EXPECT_EQ(error(with({"[[rigid_wall]]", "normal = [0, 0, 1]", "body = \"baar\""})),
            "17:8: rigid_wall.0.body: no body is named \"baar\", nearest is \"bar\"");
  EXPECT_EQ(error(with({"[[rigid_wall]]", "name = \"a\"", "normal = [0, 0, 1]", "[[rigid_wall]]", "name = \"a\"",
                        "normal = [0, 0, 1]"})),
            "19:8: rigid_wall.a.name: expected a name of its own, got \"a\" a second time; the first is in line 16");
  EXPECT_EQ(error(with({"[[constraint]]", "type = \"fixd\""})),
            "16:8: constraint.0.type: expected \"symmetry\" or \"fixed\", got \"fixd\"");
  EXPECT_EQ(error(with({"[[constraint]]", "type = \"fixed\"", "body = \"bar\""})),
            "15:1: constraint.0.directions: missing, expected \"all\" or an array of directions, each \"x\", \"y\", "
            "\"z\" or 3 numbers");
  EXPECT_EQ(error(with({"[[constraint]]", "type = \"fixed\"", "body = \"bar\"", "directions = [\"radial\"]"})),
            "18:15: constraint.0.directions: expected \"all\" or an array of directions, each \"x\", \"y\", \"z\" or 3 "
            "numbers, got \"radial\"");
  for (const std::string none : {"[0, 0, 0]", "[1.7e+308, 1.7e+308, 1.7e+308]"}) {
    const std::string directions = "directions = [\"x\", " + none + "]";
    EXPECT_EQ(error(with({"[[constraint]]", "type = \"fixed\"", "body = \"bar\"", directions})),
              "18:20: constraint.0.directions: expected a vector of non-zero, finite length, got " + none);
  }
  EXPECT_EQ(error(with({"[[constraint]]", "type = \"fixed\"", "directions = \"all\""})),
            "15:1: constraint.0.body: missing, expected at least one of body, plane, line, box, "
            "nearest, set and nodes");
  EXPECT_EQ(error(with({"[[constraint]]", "type = \"fixed\"", "body = \"bar\"", "directions = \"all\"",
                        "frame = \"cylindrical\""})),
            "15:1: constraint.0.axis: missing, expected a table { point = ..., direction = ... }");
  EXPECT_EQ(error(with({"[[constraint]]", "type = \"fixed\"", "body = \"bar\"", "directions = \"all\"",
                        "axis = { direction = [0, 0, 1] }"})),
            "19:8: constraint.0.axis: not used where frame is not \"cylindrical\"");
  EXPECT_EQ(error(with({"[[constraint]]", "type = \"symmetry\"", "normal = [1, 0, 0]", "directions = \"all\""}))
                .substr(0, 46),
            "18:1: constraint.0.directions: unknown key, ne");
  EXPECT_EQ(
      error(with({"[[load]]", "body = \"bar\"", "force = [1, 0, 0]", "times = [0, 1, 1]", "factors = [0, 1, 2]"})),
      "18:9: load.0.times: expected increasing times, got 1 after 1");
  EXPECT_EQ(error(with({"[[load]]", "body = \"bar\"", "force = [1, 0, 0]", "times = [0, 1]", "factors = [0]"})),
            "19:11: load.0.factors: expected one number for each of the 2 times, got 1");
  EXPECT_EQ(error(with({"[[load]]", "force = [1, 0, 0]", "box = { low = [0, 0, 1], high = [1, 1, 0] }"})),
            "17:33: load.0.box.high: expected numbers >= low, got 0 < 1");
  EXPECT_EQ(error(with({"[[prescribed_velocity]]", "body = \"bar\""})),
            "15:1: prescribed_velocity.0.velocity: missing, expected an array of 3 numbers");
  EXPECT_EQ(error(with({"[[prescribed_velocity]]", "body = \"bar\"", "velocity = [1, 0, 0]", "speed = 1"})),
            "17:12: prescribed_velocity.0.velocity: expected either velocity or direction and speed, got both");
  EXPECT_EQ(error(with({"[[probe]]", "name = \"bar\"", "point = [0, 0, 0]"})),
            "16:8: probe.bar.name: expected a name of its own, got \"bar\" a second time");
  EXPECT_EQ(error(with({"[[probe]]", "name = \"p\"", "point = [0, 0, 0]", "quantities = [\"stress\"]"})),
            "18:15: probe.p.quantities[0]: expected \"position\", \"displacement\" or \"velocity\", got \"stress\"");
  EXPECT_EQ(error(with({"[output]", "interval = \"steps\""})),
            "16:12: output.interval: expected \"step\", got \"steps\"");
}

TEST_F(SceneBoundaryTest, KeysCanBeSet) {
  const auto lines = with({"[[rigid_wall]]", "normal = [0, 0, 1]", "[[probe]]", "name = \"tip\"", "point = [0, 0, 0]"});
  const Scene scene = read(lines, {.set = {"rigid_wall.0.point=[0, 0, 2]", "probe.tip.point=[1, 2, 3]"}});
  EXPECT_EQ(scene.rigid_walls[0].plane.point, (Point{0, 0, 2}));
  EXPECT_EQ(scene.probes[0].point, (Point{1, 2, 3}));
}

}  // namespace
}  // namespace pinball::scene_boundary_test

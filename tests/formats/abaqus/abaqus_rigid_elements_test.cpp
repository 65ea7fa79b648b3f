#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include <solver/formats/abaqus/mesh/abaqus_mesh.hpp>
#include <solver/simulation.hpp>

#include "abaqus_case.hpp"

/// Rigid elements, R3D4 and R3D3, of a *RIGID BODY, and masses and moments of its reference node.
namespace pinball::test::abaqus_rigid_elements_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

constexpr double mass = 3e-9;

/// A box of R3D4 from -1 to 1 about a reference node at a height, seen from outside; nodes 101 to 108.
std::string box(double z, const std::string& option = "", const std::string& thickness = "") {
  std::string nodes;
  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j < 4; ++j)
      nodes +=
          fmt::format("{}, {}, {}, {}\n", 101 + 4 * k + j, j == 1 || j == 2 ? 1 : -1, j > 1 ? 1 : -1, z + 2 * k - 1);
  }
  return "*NODE\n" + nodes + fmt::format("200, 0., 0., {}\n", z) +
         "*ELEMENT, TYPE=R3D4, ELSET=Box\n101, 101, 104, 103, 102\n102, 105, 106, 107, 108\n103, 101, 102, 106, 105\n"
         "104, 102, 103, 107, 106\n105, 103, 104, 108, 107\n106, 104, 101, 105, 108\n"
         "*RIGID BODY, REF NODE=200, ELSET=Box" +
         option + "\n" + thickness;
}
const std::string weight =
    "*ELEMENT, TYPE=MASS, ELSET=Point\n301, 200\n*MASS, ELSET=Point\n3e-9,\n"
    "*ELEMENT, TYPE=ROTARYI, ELSET=Turns\n302, 200\n*ROTARY INERTIA, ELSET=Turns\n2e-9, 3e-9, 4e-9\n";

/// A plate of two by two rigid elements of 2 mm at z = 0, one of them two triangles.
std::string plate(const std::string& more, const std::string& option = "", const std::string& thickness = "") {
  std::string nodes;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) nodes += fmt::format("{}, {}, {}, 0.\n", 101 + i + 3 * j, -1.5 + 2 * i, -1.5 + 2 * j);
  }
  return "*NODE\n" + nodes +
         "*ELEMENT, TYPE=R3D4, ELSET=Plate\n101, 101, 102, 105, 104\n102, 102, 103, 106, 105\n103, 104, 105, 108, 107\n"
         "*ELEMENT, TYPE=R3D3, ELSET=Plate\n104, 105, 106, 109\n105, 105, 109, 108\n"
         "*RIGID BODY, REF NODE=105, ELSET=Plate" +
         option + "\n" + thickness + more;
}

/// The cube of the other tests, its corner at a height.
std::string cube_at(double z) {
  std::string nodes;
  for (int k = 0; k < 2; ++k) nodes += square_lines(1 + 4 * k, z + k);
  return "*NODE\n" + nodes +
         "*ELEMENT, TYPE=C3D8R, ELSET=Cube\n10, 1, 2, 3, 4, 5, 6, 7, 8\n*NSET, NSET=base\n1, 2, 3, 4\n"
         "*NSET, NSET=all\n1, 2, 3, 4, 5, 6, 7, 8\n*SOLID SECTION, ELSET=Cube, MATERIAL=Steel\n,\n";
}
std::string step_of(double period, const std::string& keywords = "") {
  return fmt::format("*STEP\n*DYNAMIC, EXPLICIT\n, {}\n", period) + keywords + "*END STEP\n";
}

class AbaqusRigidElements : public AbaqusTest {
 protected:
  RigidBodyResult body_of(const std::string& text) { return Simulation(scene(text)).summary().rigid_bodies.at(0); }
  RunSummary after(const std::string& text) {
    Simulation simulation(scene(text));
    simulation.run();
    return simulation.summary();
  }
};

TEST_F(AbaqusRigidElements, WeighWhatIsAtTheirReferenceNode) {
  const RigidBodyResult ball = body_of(cube_at(9) + box(5) + weight + abaqus_steel + abaqus_step());
  EXPECT_NEAR(ball.mass, mass, 1e-12 * mass);
  EXPECT_NEAR(norm(minus(ball.centre, {0, 0, 5})), 0, 1e-12);
  EXPECT_NEAR(ball.inertia[0][0], 2e-9, 1e-20);
  EXPECT_NEAR(ball.inertia[1][1], 3e-9, 1e-20);
  EXPECT_NEAR(ball.inertia[2][2], 4e-9, 1e-20);
}

/// By sets that list the elements of one node, and where two of them are at the node.
TEST_F(AbaqusRigidElements, WeighByTheSetsOfTheirMasses) {
  const std::string listed =
      "*ELEMENT, TYPE=MASS\n301, 200\n302, 200\n*ELSET, ELSET=Both\n301, 302\n*MASS, ELSET=Both\n1e-9,\n"
      "*ELEMENT, TYPE=ROTARYI\n303, 200\n*ELSET, ELSET=One, GENERATE\n303, 304\n*ROTARY INERTIA, ELSET=One\n1., 1., "
      "1.\n";
  const RigidBodyResult ball = body_of(cube_at(9) + box(5) + listed + abaqus_steel + abaqus_step());
  EXPECT_NEAR(ball.mass, 2e-9, 1e-20);
  EXPECT_NEAR(ball.inertia[0][0], 1, 1e-12);
}

/// z = z0 + v t + g t^2/2 of the centre, which is the reference node.
TEST_F(AbaqusRigidElements, FallFreely) {
  const double period = 1e-3, speed = 100, gravity = -1e6;
  const RunSummary summary =
      after(cube_at(20) + box(5) + weight + abaqus_steel + "*INITIAL CONDITIONS, TYPE=VELOCITY\n200, 3, 100.\n" +
            step_of(period, "*DLOAD\n, GRAV, 1e6, 0., 0., -1.\n"));
  const RigidBodyResult& ball = summary.rigid_bodies.at(0);
  EXPECT_NEAR(ball.centre[2], 5 + speed * period + gravity * period * period / 2, 1e-3 * 0.4);
  EXPECT_NEAR(ball.velocity[2], speed + gravity * period, 1e-3 * std::abs(gravity * period));
}

/// A free top that turns about its axis of the largest moment goes on so: the angle is that of its spin.
TEST_F(AbaqusRigidElements, TurnWithTheirMoments) {
  const RunSummary summary = after(cube_at(20) + box(5) + weight + abaqus_steel +
                                   "*INITIAL CONDITIONS, TYPE=VELOCITY\n200, 6, 500.\n" + step_of(1e-3));
  EXPECT_NEAR(summary.rigid_bodies.at(0).angular_velocity[2], 500, 1e-6 * 500);
  EXPECT_NEAR(summary.energy.kinetic, 0.5 * 4e-9 * 500 * 500, 1e-6 * 5e-4);
}

/// A box that hits a cube at rest: the momentum is that before, and neither goes through the other.
TEST_F(AbaqusRigidElements, HitAndKeepTheMomentum) {
  const std::string contact = "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n";
  const RunSummary summary =
      after(cube_at(-1.1) + box(1) + weight + abaqus_steel +
            "*INITIAL CONDITIONS, TYPE=VELOCITY\n200, 3, -1e4\n*BOUNDARY\n200, 4, 6\n" + step_of(3e-5, contact));
  const double cube_mass = 7.85e-9, before = -mass * 1e4;
  const Point of_box = summary.rigid_bodies.at(0).velocity;
  EXPECT_NEAR(summary.momentum_final[2], before, 1e-9 * std::abs(before));
  EXPECT_LT(summary.bodies.at(0).velocity[2], of_box[2]) << "the cube flies ahead";
  EXPECT_NEAR(mass * of_box[2] + cube_mass * summary.bodies.at(0).velocity[2], before, 1e-9 * std::abs(before));
  EXPECT_LT(summary.max_penetration_ratio, 0.01);
}

/// The face that is met is where the elements are, where surfaces have that side of them; else half a layer before it.
TEST_F(AbaqusRigidElements, AreMetWhereTheirSurfaceIs) {
  const std::string pair =
      "*SURFACE, NAME=Plate\nPlate, {}\n*SURFACE, NAME=Block\nCube,\n*SURFACE INTERACTION, NAME=I\n";
  const std::string held = "*BOUNDARY\n105, ENCASTRE\n", meets = "*CONTACT PAIR, INTERACTION=I\nBlock, Plate\n";
  const auto z_of = [&](const std::string& side, double corner, const std::string& thickness) {
    const std::string deck =
        cube_at(corner) + plate(fmt::format(fmt::runtime(pair), side), "", thickness) + abaqus_steel + held;
    const MeshFile mesh = abaqus_mesh(parse_abaqus_deck(deck + step_of(1e-6, meets), "deck.inp")).file;
    EXPECT_EQ(error(deck + step_of(1e-6, meets)), no_error);
    std::vector<double> heights;
    for (const FaceSet& set : mesh.face_sets) {
      if (set.name != "Plate") continue;
      EXPECT_THAT(set.faces, SizeIs(5));
      for (const auto& face : set.faces) heights.push_back(mesh.mesh.nodes[face[0]][2]);
    }
    return heights;
  };
  const double e = 1e-12;
  using testing::DoubleNear;
  using testing::Each;
  EXPECT_THAT(z_of("SPOS", 0.01, ""), Each(DoubleNear(0, e)));
  EXPECT_THAT(z_of("SNEG", -1.01, ""), Each(DoubleNear(0, e)));
  EXPECT_THAT(z_of("SPOS", 0.5, "0.2\n"), Each(DoubleNear(0.1, e)));
  EXPECT_THAT(z_of("SNEG", -1.5, "0.2\n"), Each(DoubleNear(-0.1, e)));
}

TEST_F(AbaqusRigidElements, StopWhatMeetsTheirSurface) {
  const std::string surfaces =
      "*SURFACE, NAME=Plate\nPlate, SPOS\n*SURFACE, NAME=Block\nCube,\n*SURFACE INTERACTION, NAME=I\n";
  const RunSummary summary = after(cube_at(0.01) + plate(surfaces) + abaqus_steel + "*BOUNDARY\n105, ENCASTRE\n" +
                                   "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 3, -1e4\n" +
                                   step_of(4e-6, "*CONTACT PAIR, INTERACTION=I\nBlock, Plate\n"));
  EXPECT_GT(summary.bodies.at(0).velocity[2], 0) << "it has come back";
  EXPECT_LT(summary.max_penetration_ratio, 0.01);
}

/// Nodes of a part that deforms go along; a pin holds all that nodes of solids have.
TEST_F(AbaqusRigidElements, TakeTiedNodesAlong) {
  for (const std::string option : {", TIE NSET=base", ", PIN NSET=base"}) {
    const std::string deck = cube_at(0) + plate("", option) + abaqus_steel;
    const Scene s = scene(deck + "*BOUNDARY\n105, ENCASTRE\n" + abaqus_step());
    ASSERT_THAT(s.attached_nodes, SizeIs(1));
    EXPECT_EQ(s.attached_nodes[0].rigid_body, s.rigid_bodies.at(0).name);
    EXPECT_THAT(s.attached_nodes[0].nodes.nodes, ElementsAre(1, 2, 3, 4));
  }
  const std::string point = "*ELEMENT, TYPE=MASS, ELSET=Point\n301, 105\n*MASS, ELSET=Point\n3e-9,\n";
  const RunSummary thrown =
      after(cube_at(0) + plate(point, ", TIE NSET=all") + abaqus_steel + "*BOUNDARY\n105, 4, 6\n" +
            "*INITIAL CONDITIONS, TYPE=VELOCITY\n105, 1, 10.\n" + step_of(1e-6));
  EXPECT_NEAR(thrown.momentum_final[0], (mass + 7.85e-9) * 10, 1e-9 * 1e-7);
  EXPECT_NEAR(thrown.rigid_bodies.at(0).mass, mass + 7.85e-9, 1e-9 * mass);
}

/// The cube of solids with a mass at its reference node 1 mm beside its centre: both weigh, and the centre is between
/// them. I = I_cube + m M/(m + M) d^2 + the given one, about axes across the way between.
TEST_F(AbaqusRigidElements, SolidsHaveTheMassesOfTheirReferenceNodeToo) {
  const std::string deck = cube_at(0) + "*NODE\n200, 1.5, 0.5, 0.5\n*RIGID BODY, REF NODE=200, ELSET=Cube\n" + weight +
                           abaqus_steel + abaqus_step();
  const RigidBodyResult body = body_of(deck);
  const double cube = 7.85e-9, of_nodes = cube * 0.5, reduced = cube * mass / (cube + mass);
  EXPECT_NEAR(body.mass, cube + mass, 1e-12 * cube);
  EXPECT_NEAR(body.centre[0], (0.5 * cube + 1.5 * mass) / (cube + mass), 1e-9);
  EXPECT_NEAR(body.inertia[0][0], of_nodes + 2e-9, 1e-9 * cube);
  EXPECT_NEAR(body.inertia[1][1], of_nodes + 3e-9 + reduced, 1e-9 * cube);
  EXPECT_NEAR(body.inertia[2][2], of_nodes + 4e-9 + reduced, 1e-9 * cube);
}

TEST_F(AbaqusRigidElements, MoveAsTheirReferenceNodeIsMoved) {
  const RunSummary summary = after(cube_at(9) + box(5) + abaqus_steel + "*BOUNDARY\n200, 1, 2\n200, 4, 6\n" +
                                   step_of(1e-5, "*BOUNDARY, TYPE=VELOCITY\n200, 3, 3, -40.\n"));
  EXPECT_NEAR(summary.rigid_bodies.at(0).centre[2], 5 - 40 * 1e-5, 1e-9);
}

/// Held twice in the first of two steps, it is not held in the second one.
TEST_F(AbaqusRigidElements, WithoutMassAreHeldOrMovedAllTheTime) {
  const std::string begin =
      cube_at(9) + box(5) + abaqus_steel + "*BOUNDARY\n200, ENCASTRE\n200, 1, 6\n" + step_of(1e-6);
  const auto then = [&](const std::string& lines) {
    return error(begin + step_of(1e-6, "*BOUNDARY, OP=NEW\n" + lines));
  };
  EXPECT_THAT(then("5, 1\n"), HasSubstr("*RIGID BODY of rigid elements without mass"));
  EXPECT_THAT(then("200, 1, 5\n"), HasSubstr("*RIGID BODY of rigid elements without mass"));
  EXPECT_EQ(then("200, 1, 6\n"), no_error);
}

TEST_F(AbaqusRigidElements, AreToldAndRefusedByName) {
  const std::string rest = abaqus_steel + abaqus_step();
  EXPECT_THAT(
      translate(cube_at(9) + box(5) + weight + rest).understood,
      Contains(AllOf(HasSubstr("its rigid elements are a layer of solids 0.1 thick, half of it on each side"))));
  EXPECT_THAT(error(cube_at(9) + box(5) + rest), AllOf(HasSubstr("*RIGID BODY of rigid elements without mass")));
  std::string no_moments = weight;
  no_moments.resize(no_moments.find("*ELEMENT, TYPE=ROTARYI"));
  EXPECT_THAT(error(cube_at(9) + box(5) + no_moments + rest), HasSubstr("without moments of inertia"));
  EXPECT_EQ(error(cube_at(9) + box(5) + no_moments + "*BOUNDARY\n200, 4, 6\n" + rest), no_error);
  EXPECT_THAT(
      error(cube_at(9) + box(5) + weight + "*ELEMENT, TYPE=MASS, ELSET=More\n401, 5\n*MASS, ELSET=More\n1.\n" + rest),
      no_error);
  EXPECT_THAT(error(cube_at(9) +
                    "*NODE\n101, 5, 5, 5\n102, 6, 5, 5\n103, 5, 6, 5\n*ELEMENT, TYPE=R3D3\n11, 101, 102, 103\n" + rest),
              HasSubstr("element 11, a rigid one, is of no *RIGID BODY"));
  EXPECT_THAT(error(cube_at(9) + box(5) + "*SURFACE, NAME=S\nBox, S1\n*TIE, NAME=T\nS, S\n" + weight + rest),
              HasSubstr("expected SPOS or SNEG of a rigid element"));
  std::string products = weight;
  products.replace(products.find("4e-9\n"), 4, "4e-9, 1e-9");
  EXPECT_THAT(error(cube_at(9) + box(5) + products + rest), HasSubstr("*ROTARY INERTIA with products of inertia"));
  EXPECT_THAT(translate(cube_at(9) + box(5) + "*BOUNDARY\n200, ENCASTRE\n" + rest).understood,
              Contains(HasSubstr("the deck gives it no mass")));
}

}  // namespace
}  // namespace pinball::test::abaqus_rigid_elements_test

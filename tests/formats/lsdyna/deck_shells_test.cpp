#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include <solver/formats/lsdyna/mesh/keyword_mesh.hpp>
#include <solver/simulation.hpp>

#include "deck_case.hpp"

/// Shells of rigid parts: bodies of the thickness that they have, which are met from both sides.
namespace pinball::test::deck_shells_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

constexpr double density = 7.85e-9, thickness = 0.2, pi = 3.141592653589793;

std::string node(int number, double x, double y, double z) {
  return fmt::format("{},{:.9g},{:.9g},{:.9g}\n", number, x, y, z);
}

/// A cube of 1 mm that flies to a height, and whatever else is rigid: part 2.
std::string deck(const std::string& nodes, const std::string& shells, double corner, double speed,
                 const std::string& more = "") {
  std::string cubes;
  for (int k = 0; k < 2; ++k) cubes += square_lines(1 + 4 * k, corner + k);
  return "*NODE\n" + cubes + nodes + "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n*ELEMENT_SHELL\n" + shells +
         "*SECTION_SOLID\n1,1\n*SECTION_SHELL\n2,2\n0.2,0.2,0.2,0.2\n" + elastic + ends +
         "*MAT_RIGID\n2,7.85E-9,210000.,0.3\n\n\n*PART\ncube\n1,1,1\n*PART\nplate\n2,2,2\n" +
         fmt::format("*INITIAL_VELOCITY_GENERATION\n1,2,0.,0.,0.,{}\n\n", speed) + more;
}

/// A square of 4 mm at z = 0, of 2 x 2 shells, of which one is turned over, and one is two triangles.
std::string square_nodes() {
  std::string nodes;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) nodes += node(11 + i + 3 * j, -1.5 + 2 * i, -1.5 + 2 * j, 0);
  }
  return nodes;
}
const std::string square_shells =
    "11,2,11,12,15,14\n12,2,12,15,16,13\n13,2,14,15,18,17\n14,2,15,16,19,19\n15,2,15,19,18\n";

class DeckShells : public DeckTest {};

TEST_F(DeckShells, HaveTheMassAndInertiaOfShells) {
  const TranslatedDeck translated = translate(deck(square_nodes(), square_shells, 5, 0));
  const RigidBodyResult plate = Simulation(read_scene(translated.source(path_))).summary().rigid_bodies.at(0);
  const double mass = density * 16 * thickness;
  EXPECT_NEAR(plate.mass, mass, 1e-12 * mass);
  EXPECT_NEAR(plate.centre[2], 0, 1e-15);
  // Masses of nodes in the place of a surface: by the number n of shells along an edge 1 + 2/n^2 of the moment.
  EXPECT_NEAR(plate.inertia[2][2], mass * 32 / 12 * 1.5, 0.05 * mass * 32 / 12);
}

TEST_F(DeckShells, AreMetFromBothSidesAtTheirFaces) {
  for (const double side : {1.0, -1.0}) {
    const double gap = 0.001, corner = side > 0 ? thickness / 2 + gap : -thickness / 2 - gap - 1;
    const std::string contact = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n\n\n\n";
    Simulation s(scene(deck(square_nodes(), square_shells, corner, -1e4 * side, contact)));
    s.run();
    const RunSummary summary = s.summary();
    EXPECT_LT(side * summary.rigid_bodies.at(0).velocity[2], -100) << "it has been struck";
    EXPECT_LT(summary.max_penetration_ratio, 0.01);
  }
}

/// A tube of 24 shells of radius 5 and a height of 2, and a box of five sides: volumes between their faces.
TEST_F(DeckShells, ThatMeetAtAnAngleKeepTheirThickness) {
  std::string nodes, shells;
  const int around = 24;
  for (int i = 0; i < around; ++i) {
    const double a = 2 * pi * i / around;
    nodes += node(100 + i, 5 * std::cos(a), 5 * std::sin(a), 0) + node(200 + i, 5 * std::cos(a), 5 * std::sin(a), 2);
    const int j = (i + 1) % around;
    shells += i % 3 == 0 ? fmt::format("{},2,{},{},{},{}\n", 50 + i, 100 + i, 200 + i, 200 + j, 100 + j)
                         : fmt::format("{},2,{},{},{},{}\n", 50 + i, 100 + i, 100 + j, 200 + j, 200 + i);
  }
  const double chord = 10 * std::sin(pi / around);
  const auto mass = [&](const std::string& text) { return Simulation(scene(text)).summary().rigid_bodies.at(0).mass; };
  EXPECT_NEAR(mass(deck(nodes, shells, 20, 0)), density * around * chord * 2 * thickness,
              1e-9 * density * around * chord);
  const std::string box = node(11, 0, 0, 0) + node(12, 2, 0, 0) + node(13, 2, 2, 0) + node(14, 0, 2, 0) +
                          node(15, 0, 0, 2) + node(16, 2, 0, 2) + node(17, 2, 2, 2) + node(18, 0, 2, 2);
  const std::string sides =
      "11,2,11,12,13,14\n12,2,11,12,16,15\n13,2,12,13,17,16\n14,2,13,14,18,17\n15,2,14,11,15,18\n";
  const double outer = 2 + thickness, inner = 2 - thickness, up = 2 + thickness / 2, hollow = 2 - thickness / 2;
  EXPECT_NEAR(mass(deck(box, sides, 20, 0)), density * (outer * outer * up - inner * inner * hollow),
              0.02 * density * 20 * thickness);
}

/// Three that meet in one edge, as a T.
TEST_F(DeckShells, MayMeetThreeByThree) {
  const std::string nodes = node(11, 0, 0, 0) + node(12, 0, 1, 0) + node(13, 1, 0, 0) + node(14, 1, 1, 0) +
                            node(15, -1, 0, 0) + node(16, -1, 1, 0) + node(17, 0, 0, 1) + node(18, 0, 1, 1);
  const Scene s = scene(deck(nodes, "11,2,11,13,14,12\n12,2,11,12,16,15\n13,2,11,12,18,17\n", 5, 0));
  EXPECT_NEAR(Simulation(s).summary().rigid_bodies.at(0).mass, density * 3 * thickness, 1e-12 * density);
}

TEST_F(DeckShells, HaveJointsAtTheirNodesAndSetsOfThem) {
  const std::string text = deck(
      square_nodes() + node(50, 2.5, 2.5, 0) + node(51, 3.5, 2.5, 0) + node(52, 3.5, 3.5, 0) + node(53, 2.5, 3.5, 0),
      square_shells + "21,3,50,51,52,53\n", 5, 0,
      "*PART\nother\n3,2,2\n*CONSTRAINED_JOINT_SPHERICAL\n19,50\n*SET_NODE_LIST\n4\n11,12,13\n"
      "*SET_SEGMENT\n5\n11,12,15,14\n19,18,15,15\n");
  const Scene s = scene(text);
  EXPECT_EQ(s.joints.at(0).point.value(), (Point{2.5, 2.5, 0}));
  const MeshFile file = keyword_mesh(parse_keyword_deck("*KEYWORD\n" + text + "*END\n", "a.k"));
  ASSERT_EQ(file.node_sets.size(), 1U);
  EXPECT_EQ(file.node_sets[0].members.size(), 6U);
  EXPECT_EQ(file.face_sets.at(0).faces.size(), 4U) << "a triangle may begin at any of its nodes";
}

/// The cube stands on the plate, with its lower nodes.
TEST_F(DeckShells, MoveNodesThatTheyShareWithSolids) {
  const Scene s = scene(deck("", "11,2,1,2,3,4\n", 5, -1e4));
  ASSERT_EQ(s.attached_nodes.size(), 1U);
  EXPECT_EQ(s.attached_nodes[0].rigid_body, "plate");
  EXPECT_EQ(s.attached_nodes[0].nodes.nodes.size(), 4U);
  const RigidBodyResult plate = Simulation(s).summary().rigid_bodies.at(0);
  EXPECT_NEAR(plate.mass, density * (thickness + 0.5), 1e-12 * density) << "with half of the cube";
}

TEST_F(DeckShells, ThatDeformOrHaveNoThicknessAreRefused) {
  std::string text = deck(square_nodes(), square_shells, 5, 0);
  std::string soft = text;
  soft.replace(soft.find("plate\n2,2,2\n"), 12, "plate\n2,2,1\n");
  EXPECT_THAT(error(soft), AllOf(HasSubstr("*ELEMENT_SHELL of parts that deform"), HasSubstr("5")));
  std::string thin = text;
  thin.replace(thin.find("0.2,0.2,0.2,0.2"), 15, "0.0,0.0,0.0,0.0");
  EXPECT_THAT(error(thin), HasSubstr("element 11 has no thickness: expected T1 > 0 of the *SECTION_SHELL 2"));
  std::string uneven = text;
  uneven.replace(uneven.find("0.2,0.2,0.2,0.2"), 15, "0.2,0.2,0.3,0.2");
  EXPECT_THAT(error(uneven), HasSubstr("T3: expected the thickness of T1"));
  std::string offset = text;
  offset.replace(offset.find("0.2,0.2,0.2,0.2"), 15, "0.2,,,,1.");
  EXPECT_THAT(error(offset), HasSubstr("NLOC"));
  std::string lost = text;
  lost.replace(lost.find("14,2,15,16,19,19"), 16, "14,2,15,16,99,99");
  EXPECT_THAT(error(lost), HasSubstr("element 14 has node 99, which is not there"));
}

}  // namespace
}  // namespace pinball::test::deck_shells_test

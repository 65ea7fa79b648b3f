#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include <solver/base/face_corners.hpp>
#include <solver/model/interfaces/contact_sides.hpp>
#include <tests/support/cube_text.hpp>
#include <tests/support/folder_case.hpp>
#include <tests/support/solver_case.hpp>

/// Sides of contact pairs that are sets of a mesh file, and bodies that share nodes.
namespace pinball::contact_sides_test {
namespace {

using namespace test;
using testing::HasSubstr;

/// Two cubes of part 1 one above the other with common nodes, of which the upper one is part 2; and a third, of part 3,
/// just above them, that comes down.
class ContactSides : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    path_ = (folder_ / "cubes.k").string();
    std::ofstream file(path_);
    file << "*KEYWORD\n*NODE\n" << cube_lines(1) << square_lines(9, 2) << square_lines(13, 2.01) << square_lines(17, 3);
    file << "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n2,2,5,6,7,8,9,10,11,12\n3,3,13,14,15,16,17,18,19,20\n"
            "*SET_SOLID\n5\n2\n*SET_SEGMENT\n6\n13,14,15,16\n*SET_NODE_LIST\n7\n13,14\n*SET_SOLID\n8\n77\n*END\n";
  }

  Scene scene() const {
    std::vector<Body> bodies;
    for (const char* part : {"1", "2", "3"}) {
      Body body;
      body.name = std::string("part_") + part;
      body.material = "steel";
      body.mesh = FileMesh{MeshFormat::keyword, path_, part, 1.0};
      bodies.push_back(body);
    }
    bodies[2].velocity = {0, 0, -20};
    Scene made = scene_of(bodies, 1.5e-3);
    made.contact.enforcement = Enforcement::lagrange;
    made.contact.gap = ContactGap::face;
    return made;
  }
  /// Part 3 may touch another one, and nothing else.
  Scene scene_with(const ContactSide& other) const {
    Scene made = scene();
    ContactPair pair;
    pair.where = "here";
    pair.first.bodies = {"part_3"};
    pair.second = other;
    made.contact_pairs = {pair};
    return made;
  }
  static double impulse(const Scene& scene) {
    Solver<double> solver(scene);
    run(solver);
    return solver.contact_pairs().at(0).impulse[2];
  }

  std::string path_;
};

TEST_F(ContactSides, MayBeSets) {
  Scene s = scene_with({.bodies = {"part_2"}});
  const double all = impulse(s);
  EXPECT_GT(all, 0);
  s.contact_pairs[0].second = {.elements = {{"5"}}};
  EXPECT_EQ(impulse(s), all) << "the element of part 2";
  s.contact_pairs[0].first = {.faces = {{"6"}}};
  EXPECT_EQ(impulse(s), all) << "the lower face of part 3";
  s.contact_pairs[0].first = {.nodes = {{"7"}}};
  const double half = impulse(s);
  EXPECT_GT(half, 0.05 * all);
  EXPECT_LT(half, 0.95 * all) << "two of four nodes, and the cube turns";
}

/// A wedge has another corner of its triangle twice than the set.
TEST_F(ContactSides, OfATriangleAreFoundWhicheverCornerItHasTwice) {
  std::ofstream file(path_);
  file << "*KEYWORD\n*NODE\n" << cube_lines(1) << square_lines(9, 2) << square_lines(13, 2.01) << square_lines(17, 3);
  file << "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n2,2,5,6,7,8,9,10,11,12\n3,3,13,13,14,15,17,17,18,19\n"
          "*SET_SEGMENT\n6\n13,13,14,15\n*SET_SEGMENT\n7\n13,14,15\n*END\n";
  file.close();
  Scene s = scene_with({.bodies = {"part_2"}});
  s.contact_pairs[0].first = {.faces = {{"6"}}};
  const double as_the_solid_has_it = impulse(s);
  EXPECT_GT(as_the_solid_has_it, 0);
  s.contact_pairs[0].first = {.faces = {{"7"}}};
  EXPECT_EQ(impulse(s), as_the_solid_has_it);
}

/// Part 2 shares four nodes with part 1: these belong to both.
TEST_F(ContactSides, OfBodiesThatShareNodesKeepTheirNodes) {
  const Scene s = scene_with({.bodies = {"part_1"}});
  EXPECT_EQ(impulse(s), 0) << "part 1 is hidden behind part 2";
  const Model<double> model = build_model<double>(s);
  const auto pairs = make_contact_pairs(model);
  pairs->set_time(0);
  const auto may = [&](std::int32_t node, std::int64_t element, std::int32_t face) {
    const std::array<std::int32_t, 4> corners = face_of(model.mesh.hexahedra[element], face);
    std::array<std::int32_t, 4> in_store{};
    for (std::size_t k = 0; k < 4; ++k) in_store[k] = model.node_of_scene_node[corners[k]];
    return pairs->node_and_face(model.node_of_scene_node[node], model.slot_of_element[element], face, in_store).may;
  };
  EXPECT_TRUE(may(4, 2, 4)) << "a node of both";
  EXPECT_FALSE(may(8, 2, 4)) << "one of part 2 alone";
  EXPECT_TRUE(may(12, 0, 5)) << "a node of part 3 and a face of part 1";
  EXPECT_FALSE(may(12, 1, 5));
}

TEST_F(ContactSides, ThatAreNotThereAreNamed) {
  EXPECT_THAT(input_error_of(scene_with({.elements = {{"9"}}})), HasSubstr("has no set of elements \"9\", nearest is"));
  EXPECT_THAT(input_error_of(scene_with({.elements = {{"8"}}})), HasSubstr("77"));
  EXPECT_THAT(input_error_of(scene_with({.faces = {{"6", "other.k"}}})),
              HasSubstr("no body is from a mesh file other.k"));
}

}  // namespace
}  // namespace pinball::contact_sides_test

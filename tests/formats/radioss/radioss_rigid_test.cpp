#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/support/run_hash.hpp>

#include "radioss_card_decks.hpp"

namespace pinball::test::radioss_rigid_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

class RadiossRigid : public RadiossTest {
 protected:
  /// Two cubes, one 1 to 1 and one 1.5 to 2.5 high, with these keywords more.
  static std::string two_cubes(const std::string& material, const std::string& more) {
    std::string text = radioss_begin + material + radioss_property;
    for (const std::string& block : common_radioss_blocks()) {
      const std::string header = block.substr(0, block.find('\n'));
      const bool is_used = header == "/NODE" || header.starts_with("/PART/") || header.starts_with("/BRICK/");
      if (is_used && more.find(header + "\n") == std::string::npos) text += block;
    }
    return text + "/SUBSET/3\nsome\n" + more;
  }
  static std::string body(const char* main, double mass, const char* group, const char* centre, double inertia = 0,
                          const char* sphere = "0") {
    return "/RBODY/1\nr\n" +
           fmt::format("{:>10}{:>10}{:>10}{:>10}{:>20.10g}{:>10}{:>10}{:>10}\n", main, 0, 0, sphere, mass, group, 0,
                       centre) +
           twenty({inertia, inertia, inertia}) + "\n\n";
  }
  void expect_error(const std::string& text, const std::vector<std::string>& words) {
    const std::string message = error(text);
    for (const std::string& word : words) EXPECT_THAT(message, HasSubstr(word));
  }
  static std::string springs(const std::string& property) {
    return of_radioss::two_rigid_cubes() + "/SPRING/3\n" + ten({"70", "96", "97"}) + property;
  }
};

TEST_F(RadiossRigid, EachPartOfLaw13IsABody) {
  const Scene made = scene(two_cubes("/MAT/LAW13/1\nrigid\n" + twenty({7.85e-9, 0}) + twenty({210000, 0.3}), ""));
  ASSERT_EQ(made.rigid_bodies.size(), 2U);
  EXPECT_EQ(made.rigid_bodies[0].bodies, std::vector<std::string>{"lower"});
  EXPECT_EQ(made.rigid_bodies[1].bodies, std::vector<std::string>{"upper"});
  EXPECT_FALSE(made.materials.at(0).plastic);
}

TEST_F(RadiossRigid, APartOfLaw13ThatIsOfARigidBodyIsNoneByItself) {
  const std::string rigid = "/MAT/RIGID/1\nrigid\n" + twenty({7.85e-9, 0}) + twenty({210000, 0.3});
  const Scene made = scene(two_cubes(
      rigid, "/GRNOD/PART/6\nboth\n" + ten({"1", "2"}) + "/RBODY/1\nr\n" + ten({"99", "0", "0", "0", "-", "-", "6"})));
  ASSERT_EQ(made.rigid_bodies.size(), 1U);
  EXPECT_EQ(made.rigid_bodies[0].bodies.size(), 2U);
  expect_error(two_cubes(rigid, "/GRNOD/NODE/6\nsome\n" + ten({"1"}) + "/RBODY/1\nr\n" +
                                    ten({"99", "0", "0", "0", "-", "-", "6"})),
               {"/MAT/RIGID/1: node 1 is of /RBODY/1, too"});
}

/// A cube of mass m has m/2 about each axis through its centre, its masses at its corners.
TEST_F(RadiossRigid, MassAndInertiaAreThoseOfNodesAndMainNode) {
  const double m = 7.85e-9;
  const std::string group = "/GRNOD/PART/6\nupper\n" + ten({"2"});
  RigidBody own = scene(two_cubes(radioss_steel, group + body("99", m, "6", "1"))).rigid_bodies.at(0);
  EXPECT_NEAR(own.mass, 2 * m, 1e-15 * m);
  EXPECT_EQ(*own.centre, (Point{0.25, 0.25, 1}));  // between (0.5, 0.5, 2) and the origin
  EXPECT_NEAR(own.inertia[0][0], m * (0.5 + (0.25 + 4) / 2), 1e-12 * m);
  EXPECT_NEAR(own.inertia[2][0], -m * 0.5, 1e-12 * m);

  own = scene(two_cubes(radioss_steel, group + body("99", 0, "6", "3", 2 * m))).rigid_bodies.at(0);
  EXPECT_EQ(own.mass, 0);
  EXPECT_EQ(*own.centre, (Point{0, 0, 0}));
  EXPECT_NEAR(own.inertia[0][0], m * (0.5 + 4.25 + 2), 1e-12 * m);
  EXPECT_NEAR(own.inertia[2][2], m * (0.5 + 0.5 + 2), 1e-12 * m);

  own = scene(two_cubes(radioss_steel, group + body("99", 0, "6", "3", 0, "1"))).rigid_bodies.at(0);
  EXPECT_NEAR(own.inertia[2][2], m * (1.5 + 9) / 3, 1e-12 * m);  // the mean
  EXPECT_NEAR(own.inertia[2][0], 0, 1e-12 * m);

  own = scene(two_cubes(radioss_steel, group + body("99", 3 * m, "6", "4", 2 * m))).rigid_bodies.at(0);
  EXPECT_NEAR(own.mass, 3 * m, 1e-9 * m);
  EXPECT_DOUBLE_EQ(own.inertia[1][1], 2 * m);
  EXPECT_EQ(own.inertia[1][0], 0);
  expect_error(two_cubes(radioss_steel, group + body("99", 0, "6", "4", 2 * m)), {"Mass", "above 0", "ICoG 4"});
  expect_error(two_cubes(radioss_steel, "/GRNOD/NODE/6\nn\n" + ten({"9", "10"}) + body("99", m, "6", "1")),
               {"/RBODY with Mass and nodes of bodies that deform"});
}

/// Masses that are added to main nodes are as their own ones: type 0 gives each node of the group all of it, type 1 a
/// share.
TEST_F(RadiossRigid, MassesAreAddedToMainNodes) {
  const double m = 7.85e-9;
  const std::string groups =
      "/GRNOD/PART/6\nupper\n" + ten({"2"}) + "/GRNOD/NODE/8\nm\n" + ten({"99"}) + body("99", 0, "6", "1");
  const auto added = [&](int type, double mass, const char* group) {
    return fmt::format("/ADMAS/{}/1\nmore\n{:>20.10g}{:>10}\n", type, mass, group);
  };
  for (const int type : {0, 1}) {
    const RigidBody own = scene(two_cubes(radioss_steel, groups + added(type, m, "8"))).rigid_bodies.at(0);
    EXPECT_NEAR(own.mass, 2 * m, 1e-9 * m);
    EXPECT_NEAR(norm(minus(*own.centre, Point{0.25, 0.25, 1})), 0, 1e-9);
    EXPECT_NEAR(own.inertia[0][0], m * (0.5 + (0.25 + 4) / 2), 1e-9 * m);
  }
  expect_error(two_cubes(radioss_steel,
                         groups + added(0, m, "8") + "/ADMAS/0/2\nmore\n" + fmt::format("{:>20.10g}{:>10}\n", m, "6")),
               {"/ADMAS of nodes of an /RBODY whose main node has a mass or an inertia", "cube_0000.rad:"});
  expect_error(two_cubes(radioss_steel, groups + added(5, m, "8")), {"/ADMAS/5/1 of another type than 0 and 1"});
}

/// Of other nodes they are masses of these: of solids that deform, and of a rigid body in its own.
TEST_F(RadiossRigid, MassesAreAddedToOtherNodes) {
  const double m = 4e-9;
  const auto added = [&](int type, const char* group) {
    return fmt::format("/ADMAS/{}/1\nmore\n{:>20.10g}{:>10}\n", type, m, group);
  };
  const std::string groups = "/GRNOD/NODE/8\nn\n" + ten({"7", "8"}) + "/GRNOD/NODE/9\nn\n" + ten({"99"}),
                    moving = fmt::format("/INIVEL/TRA/1\nv\n{:>20}{:>20}{:>20}{:>10}\n", 0, 0, -100, 8);
  const std::string deforms = two_cubes(radioss_steel, groups + moving);
  for (const int type : {0, 1}) {
    Scene own = scene(deforms);
    const Scene made = scene(two_cubes(radioss_steel, groups + moving + added(type, "8")));
    ASSERT_EQ(made.point_masses.size(), 1U);
    EXPECT_THAT(made.point_masses[0].nodes.nodes, ElementsAre(7, 8));
    EXPECT_TRUE(made.point_masses[0].each);
    EXPECT_EQ(made.point_masses[0].mass, type == 0 ? m : m / 2);
    PointMass point;
    point.nodes.plane = Plane{{0, 0, 1}, {0, 0, 1}};
    point.nodes.line = Line{{0, 1, 1}, {1, 0, 0}};
    point.mass = type == 0 ? 2 * m : m;
    own.point_masses = {point};
    EXPECT_EQ(hash_of<double>(made), hash_of<double>(own));
    EXPECT_NE(hash_of<double>(made), hash_of<double>(scene(deforms)));
  }
  expect_error(two_cubes(radioss_steel, groups + added(0, "9")),
               {"/ADMAS of nodes that no solid has, and no main nodes of an /RBODY", "cube_0000.rad:"});
  const std::string rigid = "/GRNOD/PART/6\nlower\n" + ten({"1"}) + body("99", 0, "6", "1");
  const Solver<double> solver(scene(two_cubes(radioss_steel, groups + rigid + added(0, "8"))));
  EXPECT_NEAR(solver.rigid().results().at(0).mass, 7.85e-9 + 2 * m, 1e-20);
}

/// Forces on a main node that is no centre of its nodes act there all the same.
TEST_F(RadiossRigid, AForceOnAMainNodeActsAtTheCentre) {
  const Scene made =
      scene(two_cubes(radioss_steel, "/GRNOD/PART/6\nupper\n" + ten({"2"}) + "/GRNOD/NODE/8\nm\n" + ten({"99"}) +
                                         body("99", 0, "6", "3") + "/FUNCT/5\nf\n" + twenty({0, 1}) + twenty({1, 1}) +
                                         "/CLOAD/1\nl\n" + ten({"5", "Y", "0", "0", "8"})));
  Point sum{}, moment{};
  for (const NodalLoad& load : made.loads) {
    ASSERT_EQ(load.nodes.nodes.size(), 1U);
    const std::int64_t node = load.nodes.nodes[0] - 9;  // of the upper cube
    const Point place{node % 4 == 1 || node % 4 == 2 ? 1.0 : 0.0, node % 4 >= 2 ? 1.0 : 0.0, node >= 4 ? 2.5 : 1.5};
    const Point of_force = cross(place, load.force);
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += load.force[k];
      moment[k] += of_force[k];
    }
  }
  EXPECT_NEAR(sum[0], 0, 1e-14);
  EXPECT_NEAR(sum[1], 1, 1e-14);
  EXPECT_NEAR(norm(moment), 0, 1e-14);
}

/// They have no share of the force, and nothing is told of them as of nodes that would have one.
TEST_F(RadiossRigid, AForceOnAMainNodeIsOfNodesOfSolids) {
  const auto load_on = [this](const std::string& group) {
    return scene(two_cubes(radioss_steel, "/NODE\n" + square_nodes(1, 0) + square_nodes(5, 1) + square_nodes(9, 1.5) +
                                              square_nodes(13, 2.5) + ten({"98"}) + ten({"99"}) +
                                              "/GRNOD/NODE/6\ntop\n" + group + "/GRNOD/NODE/8\nm\n" + ten({"99"}) +
                                              body("99", 0, "6", "1") + "/FUNCT/5\nf\n" + twenty({0, 1}) +
                                              twenty({1, 1}) + "/CLOAD/1\nl\n" + ten({"5", "Y", "0", "0", "8"})))
        .loads.at(0);
  };
  EXPECT_EQ(load_on(ten({"13", "14", "15", "16"})).nodes.set, "6");
  const NodalLoad load = load_on(ten({"13", "14", "15", "16", "98"}));
  EXPECT_FALSE(load.each);
  EXPECT_EQ(load.nodes.set, "");
  EXPECT_THAT(load.nodes.nodes, ElementsAre(13, 14, 15, 16));
}

TEST_F(RadiossRigid, OfSeveralTurnsTheLastCounts) {
  const std::string more = "/GRNOD/PART/6\nupper\n" + ten({"2"}) + "/GRNOD/NODE/8\nm\n" + ten({"99"}) +
                           body("99", 0, "6", "1") + "/INIVEL/ROT/1\nx\n" +
                           fmt::format("{:>20}{:>20}{:>20}{:>10}\n", 3, 0, 0, 8) + "/INIVEL/ROT/2\ny\n" +
                           fmt::format("{:>20}{:>20}{:>20}{:>10}\n", 0, 4, 0, 8);
  EXPECT_EQ(scene(two_cubes(radioss_steel, more)).rigid_bodies.at(0).angular_velocity, (Point{0, 4, 0}));
  EXPECT_THAT(translate(two_cubes(radioss_steel, more), {}).understood, Contains(HasSubstr("takes the place")));
}

TEST_F(RadiossRigid, AKjoint2HoldsTwoBodies) {
  const std::string text = springs("/PROP/TYPE45/2\nj\n" + ten({"1"}) + "\n\n\n\n\n\n\n\n\n");
  const Scene made = scene(two_cubes(radioss_steel, text));
  ASSERT_EQ(made.joints.size(), 1U);
  EXPECT_EQ(made.joints[0].kind, JointKind::spherical);
  EXPECT_EQ(*made.joints[0].point, (Point{0.5, 0.5, 1.25}));
  EXPECT_EQ(scene(two_cubes(radioss_steel, springs("/PROP/KJOINT2/2\nj\n" + ten({"8"})))).joints.at(0).kind,
            JointKind::locking);
}

TEST_F(RadiossRigid, WhatAJointIsNotIsRefused) {
  const auto with = [](const std::string& property) { return two_cubes(radioss_steel, springs(property)); };
  expect_error(with("/PROP/TYPE45/2\nj\n" + ten({"2"})), {"/PROP/TYPE45/2 with Type 2"});
  expect_error(with("/PROP/TYPE45/2\nj\n" + ten({"11"})), {"cube_0000.rad:", "Type", "1 to 9", "11"});
  expect_error(with("/PROP/TYPE4/2\nj\n\n"), {"/SPRING", "springs and dampers"});
  expect_error(with("/PROP/TYPE45/2\nj\n" + ten({"1"}) + twenty({1e6})), {"stiffness that counts"});
  expect_error(with("/PROP/TYPE45/2\nj\n" + ten({"8"}) + "/SPRING/3\n" + ten({"70", "96", "97"})),
               {"spring 70", "twice"});
  expect_error(with("/PROP/TYPE45/2\nj\n" + ten({"8"}) + "/SPRING/3\n" + ten({"71", "96", "1"})),
               {"does not join two /RBODY"});
  expect_error(with("/PROP/TYPE45/2\nj\n" + ten({"1"}) + "\n\n\n\n\n\n\n\n\n/SPRING/3\n" + ten({"71", "96", "9"})),
               {"nodes lie apart"});
}

}  // namespace
}  // namespace pinball::test::radioss_rigid_test

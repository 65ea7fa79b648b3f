#include <gmock/gmock.h>

#include <fstream>

#include <solver/simulation.hpp>

#include "deck_case.hpp"

/// Rigid parts of decks: what they become, and what is refused of them.
namespace pinball::test::deck_rigid_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Three cubes of 1 mm one above the other: parts 1, 2 and 3; 2 and 3 are rigid and have a face in common, 1 deforms.
const std::string cubes = "*NODE\n" + cube_lines(1) + square_lines(11, 1.5) + square_lines(15, 2.5) +
                          square_lines(19, 3.5) +
                          "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n2,2,11,12,13,14,15,16,17,18\n"
                          "3,3,15,16,17,18,19,20,21,22\n*SECTION_SOLID\n1,1\n" +
                          elastic + ends;
const std::string parts = "*PART\nsoft\n1,1,1\n*PART\nhard\n2,1,2\n*PART\nhat\n3,1,2\n",
                  rigid = "*MAT_RIGID\n2,7.85E-9,210000.,0.3\n", free_rigid = rigid + "\n\n",
                  merged = "*CONSTRAINED_RIGID_BODIES\n2,3\n", joined = cubes + parts + free_rigid + merged;

std::string with_held(const std::string& card) { return cubes + parts + rigid + card + "\n\n" + merged; }

class DeckRigid : public DeckTest {
 protected:
  std::string error_at_start(const std::string& text) {
    const Scene made = scene(text);
    return without_folder(error_of([&] { Simulation{made}; }));
  }
};

TEST_F(DeckRigid, EachPartOfItIsABodyOfItsOwn) {
  std::string apart = cubes + parts + free_rigid;
  const std::string third = "3,3,15,16,17,18,19,20,21,22";
  apart.replace(apart.find(third), third.size(), "3,3,31,32,33,34,35,36,37,38");
  const Scene s = scene(apart + "*NODE\n" + square_lines(31, 2.6) + square_lines(35, 3.5));
  ASSERT_EQ(s.rigid_bodies.size(), 2U);
  EXPECT_EQ(s.rigid_bodies[0].name, "hard");
  EXPECT_THAT(s.rigid_bodies[0].bodies, ElementsAre("hard"));
  EXPECT_THAT(s.rigid_bodies[1].bodies, ElementsAre("hat"));
  EXPECT_THAT(s.rigid_bodies[0].held, IsEmpty());
  EXPECT_EQ(s.bodies[1].material, "mat_2");
  EXPECT_EQ(s.materials.at(1).density, 7.85e-9);
}

TEST_F(DeckRigid, MergedPartsAreOne) {
  const Scene s = scene(joined);
  ASSERT_EQ(s.rigid_bodies.size(), 1U);
  EXPECT_THAT(s.rigid_bodies[0].bodies, ElementsAre("hard", "hat"));
  const Model<double> model = build_model<double>(s);
  EXPECT_EQ(model.rigid.at(0).nodes.size(), 12U);
  EXPECT_THAT(scene(cubes + parts + free_rigid + "*CONSTRAINED_RIGID_BODIES\n3,2\n").rigid_bodies.at(0).bodies,
              ElementsAre("hat", "hard"));
  EXPECT_EQ(error(cubes + parts + free_rigid),
            "deck.k:41: *PART: the rigid parts 2 and 3 have nodes in common: merge them by *CONSTRAINED_RIGID_BODIES");
  EXPECT_THAT(error(joined + "*CONSTRAINED_RIGID_BODIES\n3,2\n"), HasSubstr("is merged into itself"));
  EXPECT_THAT(error(joined + "*CONSTRAINED_RIGID_BODIES\n3,1\n"),
              HasSubstr("part 1 is not rigid: give it a *MAT_RIGID"));
  EXPECT_THAT(error(joined + "*CONSTRAINED_RIGID_BODIES\n3,7\n"), HasSubstr("no *PART has the number 7"));
  EXPECT_THAT(error(joined + merged), HasSubstr("what the rigid part 3 is merged into is given twice"));
}

/// The codes of CON1 and CON2.
TEST_F(DeckRigid, IsHeldAsItsMaterialSays) {
  const Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const std::vector<std::vector<Point>> of_code{{}, {x}, {y}, {z}, {x, y}, {y, z}, {x, z}, {x, y, z}};
  for (std::size_t code = 0; code < 8; ++code) {
    const RigidBody body = scene(with_held(fmt::format("1.,{},{}", code, 7 - code))).rigid_bodies.at(0);
    EXPECT_EQ(body.held, of_code[code]) << code;
    EXPECT_EQ(body.held_rotations, of_code[7 - code]) << code;
  }
  const std::string system = "*DEFINE_COORDINATE_VECTOR\n4,0.,1.,0.,-1.,0.,0.\n";
  const RigidBody local = scene(with_held("-1.,4,100011") + system).rigid_bodies.at(0);
  ASSERT_EQ(local.held.size(), 1U);
  EXPECT_EQ(local.held[0], y);
  ASSERT_EQ(local.held_rotations.size(), 2U);
  EXPECT_EQ(local.held_rotations[0], (Point{-1, 0, 0}));
  EXPECT_EQ(local.held_rotations[1], z);
  EXPECT_THAT(error(with_held("1.,8,0")), HasSubstr("CON1: expected 0 to 7, got 8"));
  EXPECT_THAT(error(with_held("-1.,0,200000")), HasSubstr("CON2: expected six digits of 0 and 1, got 200000"));
  EXPECT_THAT(error(with_held("0.5,0,0")), HasSubstr("CMO: expected 1, 0 or -1"));
  EXPECT_THAT(translate(with_held("0.,7,7")).understood, Contains(HasSubstr("not used: *MAT_RIGID: CON1, CON2")));
}

TEST_F(DeckRigid, WhatHoldsAMergedPartIsTold) {
  std::string text = cubes + parts + free_rigid + merged + "*MAT_RIGID\n3,7.85E-9,210000.,0.3\n1.,7,7\n\n";
  text.replace(text.find("3,1,2\n"), 6, "3,1,3\n");
  const TranslatedDeck deck = translate(text);
  EXPECT_THAT(read_scene(deck.source(path_)).rigid_bodies.at(0).held, IsEmpty());
  EXPECT_THAT(deck.understood, Contains(AllOf(HasSubstr("not used: *MAT_RIGID: CON1, CON2"), HasSubstr("merged"))));
}

TEST_F(DeckRigid, NodesAreNotHeldOneByOne) {
  const std::string refused = "of nodes of the rigid part 2 (deck.k:49): hold the part by CMO, CON1 and CON2",
                    set = "*SET_NODE_LIST\n5\n5,6,15,16\n";
  EXPECT_THAT(error(joined + "*BOUNDARY_SPC_NODE\n15,0,0,0,1\n"), HasSubstr("*BOUNDARY_SPC_NODE " + refused));
  EXPECT_THAT(error(joined + "*BOUNDARY_SPC_SET\n5,0,0,0,1\n" + set), HasSubstr("*BOUNDARY_SPC_SET " + refused));
  EXPECT_EQ(error(joined + "*BOUNDARY_SPC_NODE\n5,0,0,0,1\n"), no_error);
  std::string with_code = joined;
  with_code.replace(with_code.find("15,0,0,2.5\n"), 11, "15,0,0,2.5,7\n");
  EXPECT_THAT(error(with_code), HasSubstr("TC of *NODE of nodes of the rigid part 2 (deck.k:2)"));
}

TEST_F(DeckRigid, TakesExtraNodes) {
  const std::string card = "*CONSTRAINED_EXTRA_NODES_NODE\n", of_set = "*CONSTRAINED_EXTRA_NODES_SET\n",
                    set = "*SET_NODE_LIST\n5\n1,2,3\n", idle = "*NODE\n99,7.,7.,7.\n";
  const Scene one = scene(joined + card + "3,1\n2,2\n");
  ASSERT_EQ(one.attached_nodes.size(), 2U);
  EXPECT_EQ(one.attached_nodes[0].rigid_body, "hard") << "that its part is merged into";
  EXPECT_THAT(one.attached_nodes[0].nodes.nodes, ElementsAre(1));
  EXPECT_EQ(scene(joined + of_set + "2,5\n" + set).attached_nodes.at(0).nodes.set, "5");
  EXPECT_EQ(error(joined + of_set + "2,5\n" + set), no_error);
  EXPECT_THAT(error(joined + card + "1,1\n"), HasSubstr("part 1 is not rigid: give it a *MAT_RIGID"));
  EXPECT_THAT(error_at_start(joined + card + "2,77\n"),
              HasSubstr("*CONSTRAINED_EXTRA_NODES_NODE: rigid_nodes.0: deck.k has no node 77"));
  EXPECT_THAT(error_at_start(joined + of_set + "2,77\n"),
              HasSubstr("*CONSTRAINED_EXTRA_NODES_SET: rigid_nodes.0: deck.k has no set of nodes"));
  const TranslatedDeck deck = translate(joined + idle + card + "2,99\n2,1,1\n");
  EXPECT_THAT(deck.understood, Contains(HasSubstr("they are nodes of no solid")));
  EXPECT_THAT(deck.understood, Contains(HasSubstr("IFLAG")));
  EXPECT_EQ(read_scene(deck.source(path_)).attached_nodes.size(), 1U);
}

TEST_F(DeckRigid, WhatOnlyDeformingPartsHaveIsTold) {
  std::string text = joined + "*HOURGLASS\n4,9,0.1\n*MAT_ADD_EROSION\n2,0.,900.\n\n\n\n\n";
  text.replace(text.find("2,1,2\n"), 6, "2,7,2,0,4\n");
  const TranslatedDeck deck = translate(text + "*SECTION_SOLID\n7,13\n");
  EXPECT_THAT(deck.understood, Contains(HasSubstr("HGID of rigid parts")));
  EXPECT_THAT(deck.understood, Contains(HasSubstr("rigid parts have no stress, and do not erode")));
  EXPECT_EQ(read_scene(deck.source(path_)).materials.at(1).erosion, std::nullopt);
}

TEST_F(DeckRigid, WallsAndTiesAreRefusedByTheirCards) {
  EXPECT_THAT(error_in_cards(joined + "*RIGIDWALL_PLANAR\n0\n0,0,-1,0,0,0\n"),
              AllOf(HasSubstr("deck.k:48: *RIGIDWALL_PLANAR"), HasSubstr("rigid walls know no rigid bodies")));
}

const std::string rising = "*DEFINE_CURVE\n1\n0.,0.\n1.E-6,1.\n";

TEST_F(DeckRigid, MovesAsItsCardsSay) {
  const std::string vector = "*DEFINE_VECTOR\n9,0.,0.,0.,0.,3.,4.\n", card = "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n";
  const auto motions = [&](const std::string& line) {
    return scene(joined + rising + vector + card + line + '\n').rigid_motions;
  };
  const RigidMotion along = motions("3,2,2,1,5.,0,8.E-7,1.E-7").at(0);
  EXPECT_EQ(along.rigid_body, "hard") << "that its part is merged into";
  EXPECT_EQ(along.direction.value(), (Point{0, 1, 0}));
  EXPECT_EQ(along.quantity, MotionQuantity::displacement);
  EXPECT_EQ(along.speed, 1);
  EXPECT_THAT(along.table.factors, ElementsAre(0., 5.));
  EXPECT_THAT(along.table.times, ElementsAre(1e-7, 1e-6 + 1e-7)) << "the curve begins at the birth";
  EXPECT_EQ(along.when.start, 1e-7);
  EXPECT_EQ(along.when.end, 8e-7);
  EXPECT_EQ(motions("2,7,0,1").at(0).axis.value(), (Point{0, 0, 1}));
  EXPECT_EQ(motions("2,7,0,1").at(0).angular_speed, 1);
  EXPECT_EQ(motions("2,4,1,1,1.,9").at(0).direction.value(), (Point{0, 0.6, 0.8}));
  EXPECT_EQ(motions("2,8,0,1,1.,9").at(0).axis.value(), (Point{0, 0.6, 0.8}));
  const std::vector<RigidMotion> held = motions("2,-4,0,1,1.,9");
  ASSERT_EQ(held.size(), 3U);
  EXPECT_EQ(held[1].speed, 0);
  EXPECT_NEAR(dot(cross(*held[0].direction, *held[1].direction), *held[2].direction), 1, 1e-12);
  for (const char* line : {"2,9,0,1\n0.,0.", "2,-1,0,1", "2,1,3,1"})
    EXPECT_THAT(error(joined + rising + card + line + '\n'), HasSubstr("*BOUNDARY_PRESCRIBED_MOTION_RIGID with "))
        << line;
  EXPECT_THAT(
      error(joined + rising + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n15,1,0,1\n"),
      HasSubstr("of nodes of the rigid part 2 (deck.k:53): move the part by *BOUNDARY_PRESCRIBED_MOTION_RIGID"));
  EXPECT_THAT(error_at_start(with_held("1.,1,0") + rising + card + "2,1,0,1\n"),
              AllOf(HasSubstr("deck.k:53: *BOUNDARY_PRESCRIBED_MOTION_RIGID"), HasSubstr("at right angles")));
  EXPECT_EQ(scene(joined + rising + card + "1,1,0,1\n").prescribed_velocities.at(0).nodes.body, "soft");
}

TEST_F(DeckRigid, BeginsWithTheVelocityOfItsCentre) {
  const std::string nodes = "*INITIAL_VELOCITY\n\n7.,0.,0.\n",
                    centre = "*INITIAL_VELOCITY_RIGID_BODY\n3,1.,2.,3.,4.,5.,6.\n";
  Simulation s(scene(joined + centre + nodes));
  const RigidBodyResult body = s.summary().rigid_bodies.at(0);
  EXPECT_EQ(body.velocity, (Point{1, 2, 3}));
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(body.angular_velocity[k], 4.0 + static_cast<double>(k), 1e-12);
  EXPECT_NEAR(s.bodies()[0].velocity[0], 7, 1e-12) << "the part that deforms";
  const std::string system = "*DEFINE_COORDINATE_VECTOR\n4,0.,1.,0.,-1.,0.,0.\n";
  const RigidBody local =
      scene(joined + system + "*INITIAL_VELOCITY_RIGID_BODY\n2,1.,0.,0.,0.,1.,0.,4\n").rigid_bodies[0];
  EXPECT_EQ(local.velocity.value(), (Point{0, 1, 0}));
  EXPECT_EQ(local.angular_velocity.value(), (Point{-1, 0, 0}));
  EXPECT_THAT(error(joined + "*INITIAL_VELOCITY_RIGID_BODY\n1,1.\n"), HasSubstr("part 1 is not rigid"));
  EXPECT_THAT(error(joined + centre + centre), HasSubstr("the velocity of the rigid part 2 is given twice"));
}

TEST_F(DeckRigid, VelocitiesOfPartsAreThoseOfAllThatIsMerged) {
  const auto generated = [&](const char* merged_too) {
    return joined + "*INITIAL_VELOCITY_GENERATION\n2,2,1.E3,1.,2.,3.," + merged_too + "\n0.5,0.5,2.,0.,0.,1.\n";
  };
  EXPECT_THAT(error_at_start(generated("0")), HasSubstr("are no motion of the rigid body hard"));
  const RigidBodyResult body = Simulation(scene(generated("1"))).summary().rigid_bodies.at(0);
  EXPECT_NEAR(body.velocity[1], 2, 1e-12);
  EXPECT_NEAR(body.angular_velocity[2], 1e3, 1e-9);
}

const std::string inertia_of_2 =
    "*PART\nsoft\n1,1,1\n*PART\nhat\n3,1,2\n*PART_INERTIA\nhard\n2,1,2\n0.5,0.4,2.6,2.E-8\n4.E-9,1.E-10,2.E-10,5.E-9,3."
    "E-10,"
    "6.E-9\n1.,2.,3.,4.,5.,6.\n";

TEST_F(DeckRigid, HasTheInertiaOfItsPart) {
  const std::string deck = cubes + inertia_of_2 + free_rigid + merged;
  const RigidBody given = scene(deck).rigid_bodies.at(0);
  EXPECT_EQ(given.mass, 2e-8);
  EXPECT_EQ(given.centre.value(), (Point{0.5, 0.4, 2.6}));
  EXPECT_EQ(given.inertia, (std::array<Point, 3>{{{4e-9, 1e-10, 2e-10}, {1e-10, 5e-9, 3e-10}, {2e-10, 3e-10, 6e-9}}}));
  EXPECT_EQ(given.velocity.value(), (Point{1, 2, 3}));
  const RigidBodyResult body = Simulation(scene(deck + "*INITIAL_VELOCITY\n\n7.\n")).summary().rigid_bodies.at(0);
  EXPECT_NEAR(body.mass, 2e-8, 1e-20);
  EXPECT_EQ(body.centre, given.centre.value());
  EXPECT_NEAR(body.angular_momentum[0], 4e-9 * 4 + 1e-10 * 5 + 2e-10 * 6, 1e-20);
  EXPECT_EQ(body.velocity, given.velocity.value()) << "whatever those of its nodes";
  const TranslatedDeck thrown = translate(deck + "*INITIAL_VELOCITY_RIGID_BODY\n2,9.\n*DATABASE_MATSUM\n1.E-7\n");
  EXPECT_EQ(read_scene(thrown.source(path_)).rigid_bodies.at(0).velocity.value(), (Point{9, 0, 0}));
  EXPECT_THAT(thrown.understood, Contains(HasSubstr("not used: *PART_INERTIA: VTX to VRZ")));
  EXPECT_THAT(thrown.understood, Contains(HasSubstr("not used: *DATABASE_MATSUM")));
}

TEST_F(DeckRigid, InertiaMayBeOfANodeAndInALocalSystem) {
  std::string deck = cubes + inertia_of_2 + free_rigid + merged;
  deck.replace(deck.find("0.5,0.4,2.6,2.E-8\n"), 18, "0.,0.,0.,2.E-8,1,17\n");
  deck.replace(deck.find("4.,5.,6.\n"), 9, "4.,5.,6.\n0.,2.,0.,-1.,1.,0.\n");
  const RigidBody given = scene(deck).rigid_bodies.at(0);
  EXPECT_EQ(given.centre.value(), (Point{1, 1, 2.5}));
  const std::array<Point, 3> expected{{{5e-9, -1e-10, -3e-10}, {-1e-10, 4e-9, 2e-10}, {-3e-10, 2e-10, 6e-9}}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(given.inertia[i][j], expected[i][j], 1e-24) << i << j;
  }
}

TEST_F(DeckRigid, InertiaThatCannotBeIsRefused) {
  const std::string deck = cubes + inertia_of_2 + free_rigid;
  EXPECT_THAT(error(deck + "*CONSTRAINED_RIGID_BODIES\n2,3,1\n"),
              HasSubstr("with IFLAG 1 of a part with *PART_INERTIA"));
  EXPECT_THAT(error(deck + "*CONSTRAINED_RIGID_BODIES\n3,2\n"), HasSubstr("*PART_INERTIA of a merged part"));
  EXPECT_THAT(error(deck + merged + "*INITIAL_VELOCITY\n0,0,0,1\n7.\n"), HasSubstr("*INITIAL_VELOCITY with IRIGID"));
  std::string other = deck + merged;
  other.replace(other.find("2.E-8"), 5, "0.0");
  EXPECT_THAT(error(other), HasSubstr("TM: expected a mass > 0, got 0"));
  other = deck + merged;
  other.replace(other.find("4.E-9"), 5, "4.E-8");
  EXPECT_THAT(error_in_cards(other),
              AllOf(HasSubstr("deck.k:"), HasSubstr("*PART_INERTIA"), HasSubstr("expected that of a body")));
  EXPECT_THAT(translate(cubes + "*PART\nhat\n3,1,2\n*PART\nhard\n2,1,2\n*PART_INERTIA\nsoft\n1,1,1\n0.,0.,0.,1.\n\n\n" +
                        free_rigid + merged)
                  .understood,
              Contains(HasSubstr("*PART_INERTIA: XC to VRZ of part 1")));
}

/// The same scene without a deck moves to the same bits.
TEST_F(DeckRigid, IsTheSceneThatSaysTheSame) {
  const std::string contact = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n\n0.1,0.1\n\n";
  Simulation of_deck(scene(with_held("1.,1,7") + contact + "*INITIAL_VELOCITY_GENERATION\n1,2,0.,1000.,0.,4.E6\n\n"));
  const std::string file = folder_ / "scene.toml";
  const auto body = [&](const std::string& name, int part, const std::string& more) {
    return fmt::format(
        "[[body]]\nname = \"{}\"\nmaterial = \"mat_{}\"\nmesh = {{ type = \"keyword\", file = \"{}\", part = \"{}\" "
        "}}\n{}",
        name, part == 1 ? 1 : 2, path_, part, more);
  };
  const std::string steel = "model = \"elastic\"\ndensity = 7.85e-9\nyoung_modulus = 210000.0\npoisson_ratio = 0.3\n";
  std::ofstream(file)
      << "title = \"\"\n[time]\nend = 1.0e-6\ncfl = 0.9\n"
         "[element]\nhourglass = \"viscous\"\nhourglass_coefficient = 0.025\n"
         "quadratic_viscosity = 1.224744871391589\nlinear_viscosity = 0.06\n"
         "[contact]\nenforcement = \"lagrange\"\ngap = \"face\"\nfriction = 0.1\nstatic_friction = 0.1\n"
         "[[material]]\nname = \"mat_1\"\n"
      << steel << "[[material]]\nname = \"mat_2\"\n"
      << steel << body("soft", 1, "velocity = [1000.0, 0.0, 4.0e6]\n") << body("hard", 2, "") << body("hat", 3, "")
      << "[[rigid_body]]\nbodies = [\"hard\", \"hat\"]\nheld = [\"x\"]\nheld_rotations = \"all\"\n";
  Simulation of_scene(read_scene(file));
  of_deck.run();
  of_scene.run();
  EXPECT_GT(of_deck.bodies()[2].velocity[2], 1e5) << "it has been struck";
  EXPECT_EQ(of_deck.state_hash(), of_scene.state_hash());
}

}  // namespace
}  // namespace pinball::test::deck_rigid_test

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include <solver/formats/deck_reader.hpp>
#include <solver/formats/mesh_reader.hpp>
#include <solver/mesh/quality.hpp>
#include <solver/mesh/tetrahedra.hpp>
#include <tests/formats/ten_nodes_case.hpp>

#include "radioss_case.hpp"

namespace pinball::test::radioss_deck_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

TEST_F(RadiossTest, ACubeBecomesAScene) {
  const Scene made = scene(cube_with(""));
  expect_cube(made, "cube");
  EXPECT_EQ(made.time.cfl, 0.9);
  EXPECT_EQ(made.element.quadratic_viscosity, 1.1);
  EXPECT_EQ(made.element.linear_viscosity, 0.05);
  EXPECT_EQ(made.element.hourglass_coefficient, 0.025);
}

TEST_F(RadiossTest, TheEnginesInputMayStandInTheSameFile) {
  engine_ = "";
  const std::string text = "/RUN/cube/1\n2.0E-6\n/VERS/2022\n/END/ENGINE\n" + cube_with("");
  EXPECT_EQ(scene(text).time.end, 2e-6);
}

TEST_F(RadiossTest, WhatStandsBehindTheEndIsTold) {
  const auto told = Contains(HasSubstr("what stands behind /END"));
  EXPECT_THAT(translate(cube_with("/END\n# end\n\n")).understood, Not(told));
  EXPECT_THAT(translate(cube_with("/END\n# end\n/GRNOD/NODE/5\n")).understood, told);
}

TEST_F(RadiossTest, WithoutAnEnginesFileTheEndIsAskedFor) {
  engine_ = "/VERS/2022\n";
  EXPECT_THAT(error(cube_with("")), HasSubstr("expected /RUN with the time of the end in the file of the engine"));
  std::filesystem::remove(folder_ / "cube_0001.rad");
  EXPECT_THAT(error_of([&] { translate_radioss(path_); }), HasSubstr("NAME_0001.rad beside NAME_0000.rad"));
}

TEST_F(RadiossTest, AnEnginesFileThatGoesOnIsTold) {
  const auto note = Contains(HasSubstr("cube_0002.rad, with which the run would go on, is not read"));
  EXPECT_THAT(translate(cube_with("")).understood, Not(note));
  std::ofstream((folder_ / "cube_0002.rad").string()) << "/RUN/cube/2\n2.0E-6\n";
  EXPECT_THAT(translate(cube_with("")).understood, note);
  EXPECT_EQ(scene(cube_with("")).time.end, 1e-6);
}

TEST_F(RadiossTest, TheEnginesFileByItselfIsNamed) {
  std::ofstream(path_) << radioss_run;
  EXPECT_THAT(error_of([&] { translate_radioss(path_); }),
              HasSubstr("expected the file of the starter, NAME_0000.rad, this is one of the engine"));
}

TEST_F(RadiossTest, AKeywordBehindBlanksIsRefusedAndNotReadAsData) {
  EXPECT_THAT(error(cube_with(" /GRAV/1\nheavy\n")),
              HasSubstr("a keyword begins in the first column, and blanks stand before /GRAV/1"));
  EXPECT_EQ(error(cube_with("#  /GRAV/1\n")), "no error") << "a comment";
}

TEST_F(RadiossTest, SolidsThatAreGivenTheOtherWayRoundAreTurned) {
  const std::string begin = radioss_begin + radioss_steel + radioss_property + "/PART/1\ncube\n" +
                            ten({"1", "1", "0"}) + "/NODE\n" + square_nodes(1, 0) + square_nodes(5, 1);
  const auto volume_of = [&](const std::string& solids) {
    const Scene made = scene(begin + solids);
    const auto& mesh = std::get<FileMesh>(made.bodies.at(0).mesh);
    return measure_quality(read_mesh_file(mesh, {}).mesh).volume;
  };
  const auto note = Contains(HasSubstr("1 solid of negative volume: the order of its nodes is turned round"));
  const std::string brick = "/BRICK/1\n" + ten({"10", "5", "6", "7", "8", "1", "2", "3", "4"}),
                    wedge = "/PENTA6/1\n" + ten({"10", "5", "6", "7", "1", "2", "3"}),
                    tetrahedron = "/TETRA4/1\n" + ten({"10", "1", "3", "2", "5"}),
                    ten_nodes = "/TETRA10/1\n" + ten({"10"}) + ten({"1", "3", "2", "5", "0", "0", "0", "0", "0", "0"});
  EXPECT_DOUBLE_EQ(volume_of(brick), 1.0);
  EXPECT_DOUBLE_EQ(volume_of(wedge), 0.5);
  EXPECT_NEAR(volume_of(tetrahedron), 1.0 / 6, 1e-12);
  EXPECT_NEAR(volume_of(ten_nodes), 1.0 / 6, 1e-12);
  EXPECT_THAT(translate(begin + brick).understood, note);
  EXPECT_THAT(translate(cube_with("")).understood, Not(note));
}

TEST_F(RadiossTest, OtherProgramsInputIsNamed) {
  std::ofstream(path_) << "*KEYWORD\n*NODE\n";
  EXPECT_THAT(error_of([&] { translate_radioss(path_); }), HasSubstr("cube_0000.rad:1: expected Radioss input"));
  const std::string other = (folder_ / "cube.k").string();
  std::ofstream(other) << "#RADIOSS STARTER\n/BEGIN\n";
  EXPECT_THAT(error_of([&] { translate_any_deck(other, {}); }), HasSubstr("this is Radioss input: name it .rad"));
}

TEST_F(RadiossTest, FormsBefore51AreRefused) {
  const std::string old = "/BEGIN\ncube\n" + ten({"44", "0"});
  EXPECT_THAT(error(old), HasSubstr("cube_0000.rad:4: /BEGIN: Invers: input of version 44 is not read"));
  EXPECT_THAT(error("/TITLE\ncube\n"), HasSubstr("expected /BEGIN with the version of the input"));
}

TEST_F(RadiossTest, WhatIsNotDoneIsRefusedAtOnce) {
  const std::string message = error(cube_with("/SHELL/2\n/SPRING/3\n/SPRING/4\n/INTER/TYPE20/1\nx\n/NOTHING/7\n"));
  EXPECT_THAT(message, HasSubstr("/SHELL of a part that deforms (cube_0000.rad:"));
  EXPECT_THAT(message, HasSubstr("/SPRING (2 times, first in cube_0000.rad:"));
  EXPECT_THAT(message, HasSubstr("/INTER/TYPE20 (cube_0000.rad:"));
  EXPECT_THAT(message, HasSubstr("/NOTHING/7 (cube_0000.rad:"));
}

TEST_F(RadiossTest, OtherMaterialsRefuseWhereAPartHasThem) {
  EXPECT_EQ(error(cube_with("/MAT/LAW70/2\nrubber\n1\n/PROP/SPRING/3\nx\n")), no_error);
  const std::string text = radioss_begin + "/MAT/LAW70/1\nrubber\n1\n" + radioss_property + radioss_cube;
  EXPECT_THAT(error(text), HasSubstr("/MAT/LAW70/1 (cube_0000.rad:7)"));
}

TEST_F(RadiossTest, WrongValuesHaveTheirPlace) {
  const std::string bcs = "/GRNOD/NODE/5\ng\n" + ten({"1"});
  EXPECT_THAT(error(cube_with(bcs + "/BCS/1\nb\n   121 000         0         5\n")),
              HasSubstr("cube_0000.rad:37: /BCS/1: Trarot: expected 0 or 1"));
  EXPECT_THAT(error(cube_with("/BCS/1\nb\n   111 000         0         5\n")), HasSubstr("no /GRNOD has the number 5"));
  EXPECT_THAT(error(cube_with("/GRNOD/NODE/5\ng\n" + ten({"99"}) + "/BCS/1\nb\n   111 000         0         5\n")),
              HasSubstr("/GRNOD/NODE/5: node 99 is not there"));
  EXPECT_THAT(error(cube_with("/PART/1\nagain\n" + ten({"1", "1"}))), HasSubstr("part 1 is given twice, first in"));
  EXPECT_THAT(error(cube_with("/NODE\n" + square_nodes(8, 3))), HasSubstr("node 8 is given twice, first in"));
  EXPECT_THAT(error(cube_with("/RANDOM\n" + twenty({0.1}))), HasSubstr("/RANDOM with Xalea"));
}

/// Columns of the starter count what stands in them, a tab as one, where words stay whole and each in a field of its
/// own; between fields of the engine a tab is a blank.
TEST_F(RadiossTest, TabsAreColumnsOrRefusedInColumnsAlone) {
  const std::string held = "/BCS/1\nb\n   111 000         0         5\n";
  for (const std::string keyword : {"/BRICK/1\n", "/NODE\n", "/GRNOD/NODE/5\ng\n"})
    EXPECT_THAT(error(cube_with(held + keyword + "\t11\t1\t2\t3\t4\t5\t6\t7\t8\n")),
                HasSubstr("there is a tab in a card of columns"))
        << keyword;
  const std::string group = "/GRNOD/NODE/5\ng\n";
  EXPECT_EQ(error(cube_with(held + group + "\t1         2         3         4\n")), no_error)
      << "columns 2, 12, 22, 32";
  EXPECT_EQ(error(cube_with(held + group + "         1\t        2\n")), no_error) << "the tab is the eleventh";
  EXPECT_THAT(error(cube_with(held + group + "\t1       12\n")), HasSubstr("there is a tab")) << "12 is cut in two";
  engine_ = radioss_run + "/DT/NODA/CST\n0.5\t1E-9\n";
  const TimeSettings time = scene(cube_with("")).time;
  EXPECT_EQ(time.cfl, 0.5);
  EXPECT_EQ(time.smallest_step, 1e-9);
}

TEST_F(RadiossTest, AccelerometersAreOutput) {
  EXPECT_THAT(translate(cube_with("/ACCEL/7\na\n" + ten({"5", "0", "100"})), {}).ignored,
              testing::Contains(HasSubstr("/ACCEL/7")));
}

TEST_F(RadiossTest, TheStepOfSolidsCountsBeforeThatOfAll) {
  engine_ = radioss_run + "/DT\n0.9 0\n/DT/BRICK/STOP\n0.5 0\n";
  EXPECT_EQ(scene(cube_with("")).time.cfl, 0.5);
  engine_ += "/DT/NODA\n0.7 0\n";
  EXPECT_EQ(scene(cube_with("")).time.cfl, 0.7);
  engine_ = radioss_run + "/DT/BRICK/CST/0\n0.6 1.0E-9\n/DT/INTER/CST\n0.9 1.0E-9\n";
  const TranslatedDeck deck = translate(cube_with(""));
  EXPECT_EQ(scene(cube_with("")).time.cfl, 0.6);
  EXPECT_THAT(deck.understood, testing::Contains(HasSubstr("/DT/BRICK/CST/0: Tmin")));
  EXPECT_THAT(deck.ignored, testing::Contains(HasSubstr("/DT/INTER/CST")));
}

/// Points of a + b e^n, so near to each other that lines between them are the law; from a strain of 4 on it goes on
/// straight.
TEST_F(RadiossTest, APowerOfTheStrainIsACurve) {
  const Material made = scene(radioss_begin + "/MAT/PLAS_JOHNS/1\nsteel\n" + twenty({7.85e-9, 0}) +
                              twenty({210000, 0.3}) + twenty({400, 500, 0.3}) + radioss_property + radioss_cube)
                            .materials.at(0);
  ASSERT_EQ(made.yield_curves.size(), 1U);
  const auto& [rate, strain, stress] = made.yield_curves[0];
  const auto law = [](double e) { return 400 + 500 * std::pow(e, 0.3); };
  EXPECT_EQ(strain.back(), 4);
  for (std::size_t i = 0; i < strain.size(); ++i) {
    EXPECT_NEAR(stress[i], law(strain[i]), 1e-9);
    if (i < 2) continue;
    const double between = 0.5 * (strain[i - 1] + strain[i]);
    EXPECT_NEAR(0.5 * (stress[i - 1] + stress[i]), law(between), 2e-3 * law(between)) << between;
  }
}

/// A fourth node that is left out, or the third once more.
TEST_F(RadiossTest, SegmentsOfThreeNodesAreTriangles) {
  translate(cube_with("/SURF/SEG/4\ns\n" + ten({"1", "5", "6", "7"}) + ten({"2", "5", "6", "7", "7"}) +
                      ten({"3", "5", "6", "7", "8"})));
  const MeshFile file = read_mesh_file({.format = MeshFormat::radioss, .file = path_, .part = {}}, {});
  using Face = std::array<std::int32_t, 4>;
  EXPECT_THAT(file.face_sets.at(0).faces, testing::ElementsAre(Face{4, 5, 6, 6}, Face{4, 5, 6, 6}, Face{4, 5, 6, 7}));
}

/// Any node that is missing: of the first solid, of the last one.
TEST_F(RadiossTest, GravityOfPartOfAPartIsRefused) {
  const std::string gravity = "/GRAV/1\ng\n" + ten({"0", "Z", "0", "0", "5", "-"}).substr(0, 60) + twenty({1, -9810});
  const auto group = [&](int missing) {
    std::string line;
    for (int n = 1; n <= 8; ++n) line += n == missing ? "" : fmt::format("{:>10}", n);
    return error(cube_with("/GRNOD/NODE/5\ng\n" + line + "\n" + gravity));
  };
  EXPECT_EQ(group(0), no_error);
  for (int missing = 1; missing <= 8; ++missing)
    EXPECT_THAT(group(missing), HasSubstr("of nodes that are not all of some parts")) << missing;
}

TEST_F(RadiossTest, TetrahedraAreBricksOfFourNodesOrSolidsOfTheirOwn) {
  std::ofstream(path_) << "#RADIOSS STARTER\n"
                       << cube_with("/BRICK/1\n" + ten({"11", "1", "2", "4", "4", "5", "5", "5", "5"}) + "/TETRA4/1\n" +
                                    ten({"12", "2", "3", "4", "7"}))
                       << "/END\n";
  const MeshFile file = read_mesh_file({.format = MeshFormat::radioss, .file = path_, .part = ""}, {});
  ASSERT_EQ(file.mesh.hexahedra.size(), 3u);
  EXPECT_EQ(file.mesh.hexahedra[1], tetrahedron(0, 1, 3, 4));
  EXPECT_EQ(file.mesh.hexahedra[2], tetrahedron(1, 2, 3, 6));
  EXPECT_DOUBLE_EQ(measure_quality(file.mesh).volume, 1 + 2.0 / 6);
  EXPECT_THAT(error(cube_with("/BRICK/1\n" + ten({"11", "1", "2", "3", "4", "1", "2", "3", "4"}))),
              HasSubstr("/BRICK: solid 11 has four nodes or less, and fills no tetrahedron"));
  EXPECT_THAT(error(cube_with("/TETRA4/1\n" + ten({"10", "2", "3", "4", "7"}))), HasSubstr("solid 10 is given twice"));
}

TEST_F(RadiossTest, TetrahedraOfTenNodesAreEightOfFour) {
  std::string nodes = "/NODE\n";
  for (const auto& [number, x] : ten_nodes_nodes)
    nodes += fmt::format("{:>10}{:>20}{:>20}{:>20}\n", 100 + number, x[0], x[1], 3 + x[2]);
  const auto of = [](std::array<int, 10> numbers, int edges) {
    std::string line;
    for (std::size_t i = 0; i < 10; ++i)
      line += fmt::format("{:>10}", static_cast<int>(i) < 4 + edges ? 100 + numbers[i] : 0);
    return line + "\n";
  };
  const std::string part = "/PART/2\ntwo\n" + ten({"1", "1", "0"}) + nodes + "/TETRA10/2\n" + ten({"11"});
  const std::string text = part + of(ten_nodes_elements[0], 6) + ten({"12"}) + of(ten_nodes_elements[1], 6);
  EXPECT_THAT(translate(cube_with(text)).understood,
              testing::Contains(HasSubstr("2 tetrahedra of ten nodes, each as eight of four nodes")));
  const MeshFile file = read_mesh_file({.format = MeshFormat::radioss, .file = path_, .part = "2"}, {"2"});
  EXPECT_EQ(elements_of_part(file, "2").size(), 16u);
  // Without nodes on edges it is one of four nodes.
  EXPECT_EQ(error(cube_with(part + of(ten_nodes_elements[0], 0))), no_error);
  EXPECT_THAT(error(cube_with(part + of(ten_nodes_elements[0], 2))),
              HasSubstr("/TETRA10: solid 11 has nodes on 2 of its six edges: expected all, or none"));
  EXPECT_THAT(error(cube_with(text + ten({"11"}) + of(ten_nodes_elements[0], 6))),
              HasSubstr("solid 11 is given twice, first in cube_0000.rad:"));
}

TEST_F(RadiossTest, OtherUnitsAreRefused) {
  const std::string units = "/UNIT/4\nmetres\n                  kg                   m                   s\n";
  const std::string text = radioss_begin + units + "/MAT/ELAST/1/4\nsteel\n" + twenty({7850, 0}) +
                           twenty({2.1e11, 0.3}) + radioss_property + radioss_cube;
  EXPECT_THAT(error(text), HasSubstr("/MAT/ELAST/1/4 in units other than those of /BEGIN"));
  const std::string small = "/UNIT/4\nmilligrams\n                  mg                  mm                   s\n";
  EXPECT_THAT(error(radioss_begin + small + text.substr(text.find("/MAT/ELAST"))),
              HasSubstr("/MAT/ELAST/1/4 in units"));
  std::string nodes = cube_with(units);
  nodes.replace(nodes.find("/NODE"), 5, "/NODE/4");
  EXPECT_THAT(error(nodes), HasSubstr("/NODE/4 in units other than those of /BEGIN"));
  EXPECT_EQ(error(nodes.replace(nodes.find(units), units.size(),
                                "/UNIT/4\nown\n                  Mg                  mm"
                                "                   s\n")),
            no_error);
}

TEST_F(RadiossTest, GroupsAreThoseOfTheirKinds) {
  translate(cube_with("/SUBSET/2\nall\n/GRNOD/SUBSET/1\na\n" + ten({"2"}) + "/GRNOD/BOX/2\nb\n" + ten({"1"}) +
                      "/BOX/RECTA/1\nbox\n\n" + twenty({-1, -1, 0.5}) + twenty({2, 2, 2}) + "/GRNOD/GENE/3\nc\n" +
                      ten({"2", "4"}) + "/SURF/PART/EXT/4\nd\n" + ten({"1"}) + "/GRNOD/SURF/5\ne\n" + ten({"4"})));
  const MeshFile file = read_mesh_file({.format = MeshFormat::radioss, .file = path_, .part = {}}, {});
  EXPECT_EQ(file.node_sets.at(1).members.size(), 4U);
  EXPECT_EQ(file.node_sets.at(2).members.size(), 3U);
  EXPECT_EQ(file.node_sets.at(3).members.size(), 8U);
  EXPECT_EQ(file.face_sets.at(0).faces.size(), 6U);
}

TEST_F(RadiossTest, ATitleMayBeTheNameOfAPartWithoutOne) {
  std::string titled = cube_with("/PART/2\n\n" + ten({"1", "1", "0"}) + "/NODE\n" + square_nodes(11, 2) + "/BRICK/2\n" +
                                 ten({"11", "5", "6", "7", "8", "11", "12", "13", "14"}));
  titled.replace(titled.find("/PART/1\ncube"), 12, "/PART/1\npart_2");
  const Scene two = scene(titled);
  ASSERT_EQ(two.bodies.size(), 2U);
  EXPECT_EQ(two.bodies[0].name, "part_2");
  EXPECT_EQ(two.bodies[1].name, "part_2_2");
}

/// The surface of a set of solids goes round these, also where others are beside them; that of contact does not.
TEST_F(RadiossTest, NodesOfTheSurfaceOfAPartAreAllAroundIt) {
  std::string nodes = "/NODE\n", layers;
  const auto at = [](int x, int y, int z) { return 100 + x + 3 * (y + 3 * z); };
  for (int n = 0; n < 27; ++n) nodes += fmt::format("{:>10}{:>20}{:>20}{:>20}\n", 100 + n, n % 3, n / 3 % 3, 3 + n / 9);
  for (int e = 0; e < 8; ++e) {
    const int x = e % 2, y = e / 2 % 2, z = e / 4;
    if (e % 4 == 0)
      layers += fmt::format("/PART/{}\nlayer\n", 2 + z) + ten({"1", "1", "0"}) + fmt::format("/BRICK/{}\n", 2 + z);
    layers += fmt::format("{:>10}", 20 + e);
    for (const int up : {z, z + 1})
      layers += fmt::format("{:>10}{:>10}{:>10}{:>10}", at(x, y, up), at(x + 1, y, up), at(x + 1, y + 1, up),
                            at(x, y + 1, up));
    layers += "\n";
  }
  const std::string groups = "/GRBRIC/PART/3\ng\n" + ten({"3"}) + "/SURF/GRBRIC/EXT/4\ns\n" + ten({"3"}) +
                             "/SURF/PART/EXT/5\ns\n" + ten({"2"}) + "/SURF/PART/EXT/6\ns\n" + ten({"2", "3"}) +
                             "/GRNOD/SURF/4\ng\n" + ten({"4"}) + "/GRNOD/SURF/5\ng\n" + ten({"5"}) +
                             "/GRNOD/SURF/6\ng\n" + ten({"6"});
  translate(cube_with(nodes + layers + groups));
  const MeshFile file = read_mesh_file({.format = MeshFormat::radioss, .file = path_, .part = {}}, {});
  const std::array<std::size_t, 3> faces{12, 12, 24}, of_surface{18, 18, 26};
  for (std::size_t set = 0; set < 3; ++set) {
    EXPECT_EQ(file.face_sets.at(set).faces.size(), faces[set]);
    EXPECT_EQ(file.node_sets.at(set).members.size(), of_surface[set]) << set;
  }
  EXPECT_EQ(std::ranges::count_if(file.notes,
                                  [](const std::string& note) {
                                    return note.ends_with(
                                        "4 faces that other solids have, too, not in it: nothing touches there");
                                  }),
            2);
}

TEST_F(RadiossTest, ARigidBodyOfNodesAloneHasTheirCentre) {
  const std::string text =
      cube_with("/NODE\n" + ten({"99"}) + "/GRNOD/NODE/1\ntop\n" + ten({"5", "6", "7", "8"}) + "/RBODY/1\ntop\n" +
                ten({"99", "0", "0", "0", "-", "-", "1"}) + "/GRNOD/NODE/2\nmain\n" + ten({"99"}) +
                "/BCS/1\nb\n   110 111         0         2\n");
  const Scene made = scene(text);
  ASSERT_EQ(made.rigid_bodies.size(), 1U);
  EXPECT_TRUE(made.rigid_bodies[0].bodies.empty());
  EXPECT_EQ(made.rigid_bodies[0].held.size(), 2U);
  EXPECT_EQ(made.rigid_bodies[0].held_rotations.size(), 3U);
  EXPECT_EQ(made.attached_nodes.size(), 1U);
  EXPECT_EQ(build_model<double>(made).rigid.at(0).nodes.size(), 4U);
}

/// A second one of the same number would add to the first.
TEST_F(RadiossTest, WhatActsHasItsNumberOnce) {
  const std::string line = ten({"0", "Z", "0", "0", "0", "-"}), factors = twenty({0, -9.81});
  const auto gravity = [&](const std::string& number) {
    return "/GRAV/" + number + "\nweight\n" + line.substr(0, 60) + factors;
  };
  EXPECT_EQ(scene(cube_with(gravity("1") + gravity("2"))).gravities.size(), 2u);
  EXPECT_THAT(error(cube_with(gravity("1") + gravity("1"))),
              HasSubstr("/GRAV/1 is given twice, first in cube_0000.rad:"));
  const std::string thrown = "/INIVEL/TRA/3\nflight\n" + twenty({1, 0, 0});
  EXPECT_EQ(error(cube_with(thrown)), no_error);
  EXPECT_THAT(error(cube_with(thrown + thrown)), HasSubstr("/INIVEL/3 is given twice"));
  const auto held = [](const char* group) {
    return "/BCS/5\nheld\n" + ten({"111 000", "0", group}) + "/GRNOD/NODE/" + group + "\ng\n" + ten({group});
  };
  const TranslatedDeck twice = translate(cube_with(held("1") + held("2")));
  EXPECT_THAT(twice.understood, testing::Contains(HasSubstr("stands there once more, and holds beside the other")));
  EXPECT_EQ(scene(cube_with(held("1") + held("2"))).fixed_constraints.size(), 2u);
}

TEST_F(RadiossTest, WhatNothingNamesIsReportedOnceForEachKeyword) {
  const std::string function = "/FUNCT/{}\nf\n" + twenty({0, 1}) + twenty({1, 1});
  const auto functions = [&](const char* one, const char* other) {
    return fmt::format(fmt::runtime(function), one) + fmt::format(fmt::runtime(function), other);
  };
  const std::string skew = "/SKEW/FIX/3\ns\n" + twenty({0, 0, 0}) + twenty({0, 1, 0}) + twenty({0, 0, 1});
  const auto lines = [&](const std::string& more) { return translate(cube_with(more)).understood; };
  EXPECT_THAT(lines(functions("7", "8")),
              Contains(HasSubstr("not used: /FUNCT that nothing of what is read names (2 times, first in ")));
  EXPECT_THAT(lines(skew), Contains(HasSubstr("not used: /SKEW/FIX that nothing of what is read names")));
  const std::string load = "/GRNOD/NODE/1\ntop\n" + ten({"5", "6", "7", "8"}) + "/CLOAD/1\nl\n" +
                           ten({"7", "X", "3", "0", "1"}) + twenty({1, 2});
  EXPECT_THAT(lines(functions("7", "8") + skew + load),
              AllOf(Contains(HasSubstr("/FUNCT that nothing of what is read names (")),
                    Not(Contains(HasSubstr("2 times, first"))), Not(Contains(HasSubstr("/SKEW/FIX that nothing")))));
}

TEST_F(RadiossTest, ALastNumberThatNoStepHitsIsReportedOnce) {
  const auto lines = [&](const char* last) {
    return translate(cube_with("/GRNOD/GEN_INCR/3\nc\n" + ten({"1", last, "3"}) + "/GRNOD/GRNOD/4\nd\n" + ten({"3"})))
        .understood;
  };
  EXPECT_EQ(std::ranges::count_if(lines("8"),
                                  [](const std::string& line) {
                                    return line.ends_with("): from 1 in steps of 3 it ends at 7, 8 is not hit");
                                  }),
            1);
  EXPECT_THAT(lines("7"), Not(Contains(HasSubstr("is not hit"))));
}

}  // namespace
}  // namespace pinball::test::radioss_deck_test

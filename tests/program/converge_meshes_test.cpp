#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <tuple>

#include <tests/program/converge_case.hpp>

/// The meshes of a study: bodies refined apart, meshes of files, lists of numbers.
namespace pinball::converge_meshes_test {
namespace {

using test::Converge;
using test::Finished;
using test::Json;
using test::run;
using testing::HasSubstr;

TEST_F(Converge, BodiesAreRefinedApart) {
  write_scene("type = \"block\", size = [1, 1, 2], elements = [2, 2, 4]",
              "[[body]]\nname = \"far\"\nmaterial = \"m\"\nposition = [9, 0, 0]\n"
              "mesh = { type = \"block\", size = [1, 1, 2], elements = [1, 1, 2] }\n");
  const Finished f = converge(std::string(coarse) + "--of bar_velocity_z --refine bar=2 --refine far=2 --refine 2");
  ASSERT_EQ(f.status, 0) << f.text;
  const Json table = json();
  ASSERT_EQ(table["sources"].size(), 2);
  EXPECT_EQ(table["sources"][0]["name"], "bar 2 times finer");
  EXPECT_EQ(table["sources"][0]["what"], "bar: elements 8 x 8 x 16; far: elements 2 x 2 x 4");
  EXPECT_EQ(of(table, "bar_velocity_z")["refine"], "refine bar, not far");
  EXPECT_EQ(of(table, "bar_velocity_z")["largest_source"], "mesh");
  EXPECT_THAT(f.text, HasSubstr("bar_velocity_z: refine bar, not far"));
  // What does not fit into the time is known before it runs.
  EXPECT_EQ(converge(std::string(coarse) + "--of bar_velocity_z --refine bar=200 --refine 2 --budget 3s").status, 0);
  EXPECT_THAT(json()["sources"][0]["runs"][0]["left_out"].get<std::string>(), HasSubstr("expected to take"));
  const std::string folder = (folder_ / "run").string();
  const std::string finer = "--set body.bar.mesh.elements=[8,8,16] --set body.far.mesh.elements=[2,2,4]";
  ASSERT_EQ(run(fmt::format("run {} --quiet --threads 1 --out {} {}", scene(), folder, finer)).status, 0);
  EXPECT_EQ(hash(out() + "/mesh_1_bar_2"), hash(folder));
}

/// The same bar from a file, split in eight and again, and as a block of as many elements.
TEST_F(Converge, AMeshOfAFileIsSplitAsABlockIsRefined) {
  write_scene("type = \"block\", size = [1, 1, 2], elements = [1, 1, 2]");
  ASSERT_EQ(converge("--quiet --only mesh --meshes 1,2,4").status, 0);
  const Json of_block = json();
  std::string deck = "*KEYWORD\n*NODE\n";
  for (int i = 0; i < 12; ++i) deck += fmt::format("{},{},{},{}\n", i + 1, i % 2, i / 2 % 2, i / 4);
  deck += "*ELEMENT_SOLID\n1,1,1,2,4,3,5,6,8,7\n2,1,5,6,8,7,9,10,12,11\n*END\n";
  std::ofstream(folder_ / "bar.k") << deck;
  write_scene("type = \"keyword\", file = \"bar.k\"");
  const Finished f = converge("--quiet --only mesh");
  ASSERT_EQ(f.status, 0) << f.text;
  const Json of_file = json();
  EXPECT_EQ(of_file["meshes"][2]["counts"], "bar: bar.k, each element in 64");
  EXPECT_EQ(of_file["meshes"][2]["elements"], 128);
  for (const char* name : {"energy.kinetic", "bar_velocity_z", "wall_impulse", "tail_displacement_z:min"}) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double value = of(of_block, name)["values"][i];
      EXPECT_NEAR(of(of_file, name)["values"][i], value, 1e-9 * std::abs(value)) << name;
    }
  }
  EXPECT_EQ(converge("--quiet --only mesh").status, 0);
  EXPECT_TRUE(json()["meshes"][0]["was_there"]);
  std::ofstream(folder_ / "bar.k") << deck << "$ another file\n";
  EXPECT_EQ(converge("--quiet --only mesh").status, 0);
  EXPECT_FALSE(json()["meshes"][0]["was_there"]);
}

/// Nodes and faces that are listed by their numbers are the sets of the same nodes and faces, on all meshes.
TEST_F(Converge, ListsOfNumbersGoWithMeshesThatAreSplit) {
  std::string deck = "*KEYWORD\n*NODE\n";
  for (int i = 0; i < 12; ++i) deck += fmt::format("{},{},{},{}\n", 10 * i + 7, i % 2, i / 2 % 2, i / 4);
  deck += "*ELEMENT_SOLID\n1,1,7,17,37,27,47,57,77,67\n2,1,47,57,77,67,87,97,117,107\n";
  deck += "*SET_NODE_LIST\n5\n7,17,27,37\n*SET_SEGMENT\n6\n87,97,117,107\n*END\n";
  std::ofstream(folder_ / "bar.k") << deck;
  const std::string mesh = "type = \"keyword\", file = \"bar.k\"",
                    pressed = "[[pressure]]\nname = \"push\"\npressure = 5\n",
                    held = "[[constraint]]\ntype = \"fixed\"\ndirections = [\"x\", \"y\"]\n",
                    probe = "[[probe]]\nname = \"corner\"\nnode = 87\nquantities = [\"displacement\"]\n";
  write_scene(mesh, held + "nodes = [7, 17, 27, 37]\n" + pressed + "faces = [[87, 97, 117, 107]]\n" + probe);
  const Finished by_numbers = converge("--quiet --ensemble 1 --only mesh --only chance");
  ASSERT_EQ(by_numbers.status, 0) << by_numbers.text;
  const Json listed = json();
  EXPECT_EQ(listed["meshes"][2]["elements"], 128);
  write_scene(mesh, held + "set = \"5\"\n" + pressed + "set = \"6\"\n" + probe);
  ASSERT_EQ(converge("--quiet --ensemble 1 --only mesh --only chance").status, 0);
  EXPECT_FALSE(json()["meshes"][1]["was_there"]);
  EXPECT_EQ(json()["quantities"], listed["quantities"]);
  ASSERT_FALSE(of(listed, "corner_displacement_z:min").is_null() && of(listed, "corner_displacement_z").is_null());

  write_scene(mesh, held + "nodes = [7, 18]\n");
  test::expect_bad_input(command("--quiet --only mesh"), "no node 18");
}

/// The top of a bar moves with a rigid body, by the numbers of its nodes: new nodes do, too.
TEST_F(Converge, RigidNodesThatAreListedGoWithMeshesThatAreSplit) {
  std::string deck = "*KEYWORD\n*NODE\n";
  for (int i = 0; i < 12; ++i) deck += fmt::format("{},{},{},{}\n", i + 1, i % 2, i / 2 % 2, i / 4);
  deck += "*ELEMENT_SOLID\n1,1,1,2,4,3,5,6,8,7\n2,1,5,6,8,7,9,10,12,11\n*SET_NODE_LIST\n3\n9,10,11,12\n*END\n";
  std::ofstream(folder_ / "bar.k") << deck;
  const auto displacements = [&](const std::string& nodes) {
    std::ofstream(scene()) << "[time]\nend = 4e-3\n[[material]]\nname = \"m\"\nmodel = \"elastic\"\n"
                              "density = 1e-3\nyoung_modulus = 1e3\npoisson_ratio = 0.25\n"
                              "[[body]]\nname = \"bar\"\nmaterial = \"m\"\n"
                              "mesh = { type = \"keyword\", file = \"bar.k\" }\n"
                              "[[rigid_body]]\nname = \"top\"\nvelocity = [3, 0, 0]\n"
                              "[[rigid_nodes]]\nrigid_body = \"top\"\n"
                           << nodes << "[[probe]]\nname = \"corner\"\nnode = 9\nquantities = [\"displacement\"]\n";
    const Finished done = converge("--quiet --only mesh --of corner_displacement_x");
    EXPECT_EQ(done.status, 0) << done.text;
    return of(json(), "corner_displacement_x")["values"];
  };
  const Json listed = displacements("nodes = [9, 10, 11, 12]\n");
  EXPECT_EQ(displacements("set = \"3\"\n"), listed);
}

/// What chance does is known of scenes in which bodies, or nodes of bodies that deform, are rigid.
TEST_F(Converge, ChanceMovesWhatIsRigid) {
  std::string text =
      "units = \"g-mm-ms\"\n[time]\nend = 4e-3\n[contact]\nmethod = \"pinball\"\n"
      "[[material]]\nname = \"m\"\nmodel = \"elastic\"\ndensity = 1e-3\nyoung_modulus = 1e3\npoisson_ratio = 0.25\n";
  for (const auto& [name, height, speed] :
       {std::tuple{"bar", 0.0, 0.0}, std::tuple{"ram", 1.3, -20.0}, std::tuple{"rest", -1.3, 0.0}}) {
    text += fmt::format(
        "[[body]]\nname = \"{}\"\nmaterial = \"m\"\nposition = [0, 0, {}]\nvelocity = [0, 0, {}]\n"
        "mesh = {{ type = \"block\", size = [1, 1, 1], elements = [2, 2, 2] }}\n",
        name, height, speed);
  }
  text +=
      "[[rigid_body]]\nname = \"ram\"\nbodies = [\"ram\"]\n[[rigid_body]]\nname = \"foot\"\n"
      "[[rigid_nodes]]\nrigid_body = \"foot\"\nbody = \"rest\"\n"
      "plane = { point = [0, 0, -1.3], normal = [0, 0, 1] }\n";
  std::ofstream(scene()) << text;
  const Finished done =
      converge("--quiet --ensemble 2 --only mesh --only chance --of ram_velocity_z --of rest_velocity_z");
  ASSERT_EQ(done.status, 0) << done.text;
  EXPECT_EQ(done.text.find("chance failed"), std::string::npos) << done.text;
  const Json table = json();
  for (const char* quantity : {"ram_velocity_z", "rest_velocity_z"}) {
    const Json moved = of(table, quantity)["moved_by"]["chance"];
    ASSERT_FALSE(moved.is_null()) << quantity;
    EXPECT_GT(moved, 0) << quantity;
  }
}

}  // namespace
}  // namespace pinball::converge_meshes_test

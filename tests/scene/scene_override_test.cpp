#include <cmath>
#include <cstdlib>

#include <solver/base/text_distance.hpp>
#include <tests/support/scene_fixture.hpp>

namespace pinball::scene_override_test {
namespace {

using namespace test;

namespace fs = std::filesystem;

using SceneOverrideTest = SceneTest;

TEST_F(SceneOverrideTest, Overrides) {
  const Scene scene = read(minimal, {.set = {"contact.method=pinball", "time.end=1e-5", "body.bar.velocity=[0,0,1]",
                                             "body.bar.mesh.elements=[5, 6, 7]", "material.copper.density=8.31e-3",
                                             "title=a = b", "time.cfl=.5", "guard.energy_error=1."}});
  EXPECT_EQ(scene.contact.method, ContactMethod::pinball);
  EXPECT_EQ(scene.time.end, 1e-5);
  EXPECT_EQ(scene.time.cfl, 0.5);
  EXPECT_EQ(scene.guard.energy_error, 1.0);
  EXPECT_EQ(scene.bodies[0].velocity, (Point{0, 0, 1}));
  EXPECT_EQ(std::get<BlockMesh>(scene.bodies[0].mesh).elements, (std::array<int, 3>{5, 6, 7}));
  EXPECT_EQ(scene.materials[0].density, 8.31e-3);
  EXPECT_EQ(scene.title, "a = b");
  // The last one wins, and an override may supply what the file lacks.
  EXPECT_EQ(read(with(3, ""), {.set = {"time.end=1", "time.end=2"}}).time.end, 2.0);
  const auto constrained = with({"[[constraint]]", "type = \"symmetry\"", "normal = [0, 1, 0]"});
  EXPECT_EQ(read(constrained, {.set = {"constraint.0.normal=[2, 0, 0]"}}).constraints[0].normal, (Point{1, 0, 0}));
  EXPECT_EQ(read(minimal, {.precision = Precision::float32}).precision, Precision::float32);
}

TEST_F(SceneOverrideTest, VariedKeysComeAfterSetOnesAndErrorsNameThem) {
  EXPECT_EQ(read(minimal, {.set = {"time.end=2"}, .vary = {"time.end=3"}}).time.end, 3.0);
  EXPECT_EQ(error(minimal, {.vary = {"contact.betta=2"}}),
            "--vary contact.betta=2: unknown key, nearest is contact.beta");
  EXPECT_EQ(error(minimal, {.vary = {"time.end=-1"}}), "--vary time.end=-1: expected a number > 0, got -1");
  EXPECT_EQ(error(minimal, {.vary = {"variant=fast"}}), "--vary variant=fast: the scene has no variants, got \"fast\"");
}

TEST_F(SceneOverrideTest, OverrideErrorsNameTheOverride) {
  EXPECT_EQ(set_error("contact.betta=2"), "--set contact.betta=2: unknown key, nearest is contact.beta");
  EXPECT_EQ(set_error("contcat.beta=2"), "--set contcat.beta=2: contcat: unknown key, nearest is contact");
  EXPECT_EQ(set_error("time.end=-1"), "--set time.end=-1: expected a number > 0, got -1");
  EXPECT_EQ(set_error("time.end=late"), "--set time.end=late: expected a number > 0, got \"late\"");
  EXPECT_EQ(set_error("time.end="), "--set time.end=: expected a number > 0, got \"\"");
  EXPECT_EQ(set_error("time.end=1\ncfl = 0.1").substr(0, 14), "--set time.end");
  EXPECT_EQ(set_error("body.bar.velocity=[0, x, 0]"),
            "--set body.bar.velocity=[0, x, 0]: expected an array of 3 numbers, got \"[0, x, 0]\"");
  EXPECT_EQ(set_error("body.bar.velocity=[0, true, 0]"),
            "--set body.bar.velocity=[0, true, 0]: body.bar.velocity[1]: expected a finite number, got true");
  EXPECT_EQ(set_error("material.coper.density=1"),
            "--set material.coper.density=1: no material is named \"coper\", nearest is \"copper\"");
  EXPECT_EQ(set_error("body.bar.mesh.sise=1"),
            "--set body.bar.mesh.sise=1: unknown key, nearest is body.bar.mesh.size");
  EXPECT_EQ(set_error("body.bar.mesh={ type = \"block\" }"),
            "--set body.bar.mesh={ type = \"block\" }: body.bar.mesh.size: missing, expected an array of 3 numbers");
  EXPECT_EQ(set_error("body.bar=1"), "--set body.bar=1: expected body.NAME.KEY");
  EXPECT_EQ(set_error("constraint.0.normal=1"), "--set constraint.0.normal=1: the scene has no [[constraint]]");
  EXPECT_EQ(set_error("pressure.0.pressure=1"), "--set pressure.0.pressure=1: the scene has no [[pressure]]");
  EXPECT_EQ(set_error("gravity.0.name=g"), "--set gravity.0.name=g: the scene has no [[gravity]]");
  EXPECT_EQ(set_error("time.end.x=1"), "--set time.end.x=1: end is no table, it is 1");
  EXPECT_EQ(set_error("time.end"), "--set time.end: expected KEY=VALUE, as in contact.beta=2");
  EXPECT_EQ(set_error("time..end=1"), "--set time..end=1: expected a key such as contact.beta, got \"time..end\"");
  EXPECT_EQ(set_error("=1"), "--set =1: expected KEY=VALUE, as in contact.beta=2");
}

TEST_F(SceneOverrideTest, Variants) {
  const auto lines =
      with({"[variant.heavy]", "\"time.end\" = 3", "\"material.copper.density\" = 1e6", "\"contact.beta\" = 0.5",
            "[variant.slow]", "\"body.bar.velocity\" = [0, 0, 1]", "\"time.end\" = 9"});
  EXPECT_EQ(read(lines).materials[0].density, 8930.0);
  const Scene heavy = read(lines, {.set = {"time.end=4", "variant=heavy"}});
  EXPECT_EQ(heavy.materials[0].density, 1e6);
  EXPECT_EQ(heavy.contact.beta, 0.5);
  EXPECT_EQ(heavy.time.end, 4.0) << "--set comes after the variant";
  const Scene both = read(lines, {.set = {"variant=heavy", "variant=slow"}});
  EXPECT_EQ(both.time.end, 9.0);
  EXPECT_EQ(both.materials[0].density, 1e6);
  EXPECT_EQ(both.bodies[0].velocity, (Point{0, 0, 1}));

  EXPECT_EQ(error(lines, {.set = {"variant=fast"}}),
            "--set variant=fast: expected \"heavy\" or \"slow\", got \"fast\"");
  EXPECT_EQ(set_error("variant=fast"), "--set variant=fast: the scene has no variants, got \"fast\"");
  EXPECT_EQ(set_error("variant=3"), "--set variant=3: expected the name of a variant");
}

TEST_F(SceneOverrideTest, UnusedVariantsAreChecked) {
  EXPECT_EQ(error(with({"[variant.v]", "\"contact.betta\" = 2"})),
            "16:1: contact.betta: unknown key, nearest is contact.beta (in variant v)");
  EXPECT_EQ(error(with({"[variant.v]", "\"time.end\" = \"x\""})),
            "16:14: time.end: expected a number > 0, got \"x\" (in variant v)");
  EXPECT_EQ(error(with({"[variant.v]", "\"material.coper.density\" = 2"})),
            "16:1: material.coper.density: no material is named \"coper\", nearest is \"copper\" (in variant v)");
  EXPECT_EQ(error(with(1, "variant = 3")), "1:11: variant: expected tables [variant.NAME], got 3");
  // A file that lacks a key is still complete with --set; other overrides do not disturb the check.
  auto lines = with({"[variant.v]", "\"contact.beta\" = 2"});
  lines[2] = "";
  EXPECT_EQ(error(lines, {.set = {"time.end=1"}}), "no error");
}

TEST_F(SceneOverrideTest, RefineMultipliesCounts) {
  Scene scene = read(minimal, {.refine = 3});
  EXPECT_EQ(scene.refine, 3);
  EXPECT_EQ(std::get<BlockMesh>(scene.bodies[0].mesh).elements, (std::array<int, 3>{6, 9, 12}));
  scene = read(with(14, "mesh = { type = \"round_nosed_rod\", length = 1, radius = 0.1, layers = 5 }"), {.refine = 2});
  const auto& rod = std::get<RoundNosedRodMesh>(scene.bodies[0].mesh);
  EXPECT_EQ(rod.core, (std::array<int, 2>{4, 4}));
  EXPECT_EQ(rod.ring, 2);
  EXPECT_EQ(rod.layers, 10);
  EXPECT_EQ(error(minimal, {.refine = 0}), "--refine 0: expected an integer >= 1, got 0");
  EXPECT_NE(error(minimal, {.refine = 2000000000}), "no error");
}

TEST_F(SceneOverrideTest, FindsScenes) {
  read(minimal);
  EXPECT_EQ(find_scene(file_), file_);
  EXPECT_EQ(find_scene("rod_plate"), PINBALL_SOURCE_DIR "/data/scenes/rod_plate.toml");
  EXPECT_EQ(find_scene("rod_plate.toml"), PINBALL_SOURCE_DIR "/data/scenes/rod_plate.toml");
  try {
    find_scene("rod_plat");
    FAIL() << "expected an InputError";
  } catch (const InputError& problem) {
    const std::string text = problem.what();
    EXPECT_NE(text.find("nearest is rod_plate;"), std::string::npos) << text;
    EXPECT_NE(text.find("two_blocks"), std::string::npos) << text;
  }
  // The folder that the user names comes first.
  fs::create_directories(folder_ / "scenes");
  fs::copy_file(file_, folder_ / "scenes" / "rod_plate.toml");
  ::setenv("PINBALL_DATA", folder_.c_str(), 1);
  EXPECT_EQ(find_scene("rod_plate"), (folder_ / "scenes" / "rod_plate.toml").string());
  EXPECT_EQ(find_scene("block"), PINBALL_SOURCE_DIR "/data/scenes/block.toml");
  ::unsetenv("PINBALL_DATA");
}

TEST(SceneFiles, AllCanBeRead) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(PINBALL_SOURCE_DIR "/data/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    EXPECT_NO_THROW(read_scene(entry.path().string())) << entry.path();
  }
  EXPECT_GE(count, 3);
}

TEST(SceneFiles, RodAndPlateAreTheReports) {
  const std::string path = find_scene("rod_plate");
  const Scene scene = read_scene(path);
  EXPECT_EQ(scene.units, "in-lbf-s");
  EXPECT_EQ(scene.materials.at(0).density, 8.31e-4);
  EXPECT_EQ(scene.materials.at(1).density, 7.34e-4);
  const auto& rod = std::get<RoundNosedRodMesh>(scene.bodies.at(0).mesh);
  const int cap = rod.core[0] * rod.core[1];
  EXPECT_EQ((cap + rod.ring * (rod.core[0] + 2 * rod.core[1])) * rod.layers + rod.ring * cap, 414);
  const auto& plate = std::get<BlockMesh>(scene.bodies.at(1).mesh);
  EXPECT_EQ(plate.elements[0] * plate.elements[1] * plate.elements[2], 1428);
  EXPECT_EQ(scene.bodies[1].position[2] + plate.size[2], 0.0);
  // Nose first: the rod's axis points along its flight.
  const Point& velocity = scene.bodies[0].velocity;
  const double speed = std::hypot(velocity[0], velocity[1], velocity[2]);
  EXPECT_NEAR(speed, 78582.0, 1.0);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR((*scene.bodies[0].axis)[i], velocity[i] / speed, 1e-12);

  const Scene printed = read_scene(path, {.set = {"variant=as_printed"}});
  EXPECT_EQ(printed.materials.at(0).density, 8.31e-3);
  EXPECT_EQ(printed.materials.at(1).density, 7.34e-3);
}

TEST(TextDistance, CountsSlips) {
  EXPECT_EQ(edit_distance("", ""), 0);
  EXPECT_EQ(edit_distance("beta", "beta"), 0);
  EXPECT_EQ(edit_distance("betta", "beta"), 1);
  EXPECT_EQ(edit_distance("bta", "beta"), 1);
  EXPECT_EQ(edit_distance("bate", "beta"), 2);
  EXPECT_EQ(edit_distance("layres", "layers"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(nearest("coper", {"steel", "copper", "cooper"}), "copper");
  EXPECT_EQ(nearest("x", {}), "");
}

}  // namespace
}  // namespace pinball::scene_override_test

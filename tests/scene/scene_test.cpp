#include <gmock/gmock.h>

#include <limits>

#include <solver/scene/machine.hpp>
#include <tests/support/scene_fixture.hpp>

namespace pinball::scene_test {
namespace {

using namespace test;

TEST_F(SceneTest, FillsInDefaults) {
  const Scene scene = read(minimal);
  EXPECT_EQ(scene.name, "scene");
  EXPECT_EQ(scene.path, file_);
  EXPECT_EQ(scene.units, "SI");
  EXPECT_EQ(scene.precision, Precision::float64);
  EXPECT_EQ(scene.refine, 1);
  EXPECT_EQ(scene.time.end, 1.0);
  EXPECT_EQ(scene.time.cfl, 0.9);
  EXPECT_EQ(scene.time.steps, -1);
  EXPECT_EQ(scene.element.hourglass, HourglassControl::assumed_strain);
  EXPECT_EQ(scene.element.hourglass_coefficient, 1.0);
  EXPECT_FALSE(scene.element.negative_volume);
  EXPECT_EQ(scene.contact.method, ContactMethod::not_set);
  EXPECT_EQ(scene.contact.enforcement, Enforcement::lagrange);
  EXPECT_EQ(scene.contact.gap, ContactGap::face);
  EXPECT_EQ(scene.contact.beta, 1.0);
  EXPECT_EQ(scene.contact.search, ContactSearch::automatic);
  EXPECT_TRUE(scene.skip.contact_search);
  EXPECT_TRUE(scene.skip.resting);
  EXPECT_EQ(scene.output.fields.size(), 7u);
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_TRUE(scene.materials[0].plastic);
  EXPECT_EQ(scene.materials[0].density, 8930.0);
  EXPECT_EQ(scene.materials[0].ultimate_stress, std::numeric_limits<double>::infinity());
  EXPECT_EQ(scene.materials[0].erosion_strain, 0.0);
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_FALSE(scene.bodies[0].axis);
  const auto& mesh = std::get<BlockMesh>(scene.bodies[0].mesh);
  EXPECT_EQ(mesh.size, (Point{1, 2, 3}));
  EXPECT_EQ(mesh.elements, (std::array<int, 3>{2, 3, 4}));
}

TEST_F(SceneTest, ReadsEveryKey) {
  const Scene scene = read({R"(
title = "all of it"
units = "ms-mm-g"
precision = "float"
time = { end = 2, cfl = 1.2, steps = 7, subcycling = false }
contact = { method = "pinball", enforcement = "penalty", gap = "pinball", beta = 2, damping = 0, radius = "current", self = false, search = "hash", skin = 0.25 }
skip = { contact_search = false, resting = false }
guard = { energy_error = 0.1 }
output = { interval = 0.5, field_interval = 1, field_times = [2, 0.5, 0], fields = ["alive", "stress"] }
[element]
hourglass = "viscous"
hourglass_coefficient = 0.1
bulk_viscosity = false
linear_viscosity = 0.05
quadratic_viscosity = 1.1
negative_volume = "erode"
[[material]]
name = "m"
model = "von_mises"
density = 1
young_modulus = 2.6
poisson_ratio = 0.3
yield_stress = 3
plastic_modulus = 4
ultimate_stress = 5
erosion_strain = 6
[[body]]
name = "b"
material = "m"
position = [1, 2, 3]
axis = [3, 0, -4]
velocity = [4, 5, 6]
angular_velocity = [7, 8, 9]
velocity_gradient = [[1, 2, 3], [4, 5, 6], [7, 8, 9]]
velocity_noise = 0.5
[body.mesh]
type = "round_nosed_rod"
length = 4.9
radius = 0.5
half = false
core = [4, 3]
ring = 2
layers = 41
[[constraint]]
type = "symmetry"
point = [1, 0, 0]
normal = [0, -2, 0]
body = "b"
)"});
  EXPECT_EQ(scene.title, "all of it");
  EXPECT_EQ(scene.units, "ms-mm-g");
  EXPECT_EQ(scene.precision, Precision::float32);
  EXPECT_EQ(scene.time.end, 2.0);
  EXPECT_EQ(scene.time.cfl, 1.2);
  EXPECT_EQ(scene.time.steps, 7);
  EXPECT_EQ(scene.element.hourglass, HourglassControl::viscous);
  EXPECT_EQ(scene.element.hourglass_coefficient, 0.1);
  EXPECT_FALSE(scene.element.bulk_viscosity);
  EXPECT_EQ(scene.element.linear_viscosity, 0.05);
  EXPECT_EQ(scene.element.quadratic_viscosity, 1.1);
  EXPECT_EQ(scene.element.negative_volume, NegativeVolume::erode);
  EXPECT_EQ(scene.contact.method, ContactMethod::pinball);
  EXPECT_EQ(scene.contact.beta, 2.0);
  EXPECT_EQ(scene.contact.damping, 0.0);
  EXPECT_EQ(scene.contact.radius, ContactRadius::current);
  EXPECT_FALSE(scene.contact.self);
  EXPECT_EQ(scene.contact.search, ContactSearch::hash);
  EXPECT_EQ(scene.contact.skin, 0.25);
  EXPECT_FALSE(scene.skip.contact_search);
  EXPECT_FALSE(scene.skip.resting);
  EXPECT_EQ(scene.guard.energy_error, 0.1);
  EXPECT_EQ(scene.output.interval, 0.5);
  EXPECT_EQ(scene.output.field_interval, 1.0);
  EXPECT_EQ(scene.output.field_times, (std::vector<double>{0, 0.5, 2}));
  EXPECT_EQ(scene.output.fields, (std::vector<std::string>{"alive", "stress"}));
  const Material& material = scene.materials.at(0);
  EXPECT_DOUBLE_EQ(material.bulk_modulus, 2.6 / 1.2);
  EXPECT_DOUBLE_EQ(material.shear_modulus, 1.0);
  EXPECT_EQ(material.yield_stress, 3.0);
  EXPECT_EQ(material.plastic_modulus, 4.0);
  EXPECT_EQ(material.ultimate_stress, 5.0);
  EXPECT_EQ(material.erosion_strain, 6.0);
  const Body& body = scene.bodies.at(0);
  EXPECT_EQ(body.position, (Point{1, 2, 3}));
  ASSERT_TRUE(body.axis);
  EXPECT_EQ(*body.axis, (Point{0.6, 0, -0.8}));
  EXPECT_EQ(body.velocity, (Point{4, 5, 6}));
  EXPECT_EQ(body.angular_velocity, (Point{7, 8, 9}));
  EXPECT_EQ(body.velocity_gradient[1], (Point{4, 5, 6}));
  EXPECT_EQ(body.velocity_noise, 0.5);
  const auto& rod = std::get<RoundNosedRodMesh>(body.mesh);
  EXPECT_EQ(rod.length, 4.9);
  EXPECT_EQ(rod.radius, 0.5);
  EXPECT_FALSE(rod.half);
  EXPECT_EQ(rod.core, (std::array<int, 2>{4, 3}));
  EXPECT_EQ(rod.ring, 2);
  EXPECT_EQ(rod.layers, 41);
  EXPECT_EQ(scene.constraints.at(0).point, (Point{1, 0, 0}));
  EXPECT_EQ(scene.constraints.at(0).normal, (Point{0, -1, 0}));
  EXPECT_EQ(scene.constraints.at(0).body, "b");
}

TEST_F(SceneTest, UnknownKeysNameTheNearest) {
  EXPECT_EQ(error(with(3, "end = 1.0\nstep = 3")), "4:1: time.step: unknown key, nearest is time.steps");
  EXPECT_EQ(error(with(7, "denisty = 8930")),
            "7:1: material.copper.denisty: unknown key, nearest is material.copper.density");
  for (const char* type : {"file", "keyword", "vtk"}) {
    EXPECT_EQ(error(with(14, std::string("mesh = { type = \"") + type + "\", path = \"bar.k\" }")),
              "14:" + std::to_string(21 + std::string(type).size()) +
                  ": body.bar.mesh.path: unknown key, nearest is body.bar.mesh.file");
  }
  EXPECT_EQ(error(with(14, "mesh = { type = \"gmsh\", file = \"bar.msh\", part = \"bar\" }")),
            "14:43: body.bar.mesh.part: unknown key, nearest is body.bar.mesh.physical");
  EXPECT_EQ(error(with(14, "mesh = { type = \"exodus\", file = \"bar.g\", physical = \"bar\" }")),
            "14:43: body.bar.mesh.physical: unknown key, nearest is body.bar.mesh.part");
  EXPECT_EQ(error(with({"[contct]", "beta = 1"})), "15:2: contct: unknown key, nearest is contact");
  EXPECT_EQ(error(with({"[contact]", "hourglass = \"none\""})),
            "16:1: contact.hourglass: unknown key, nearest is element.hourglass");
  // Not the tables without a name that pairs of contact are made of, which have it, too.
  EXPECT_EQ(error(with({"[contact]", "elements = 3"})),
            "16:1: contact.elements: unknown key, nearest is body.NAME.elements");
  EXPECT_EQ(error(with(14, "mesh = { type = \"block\", sizes = [1, 2, 3], elements = [2, 3, 4] }")),
            "14:26: body.bar.mesh.sizes: unknown key, nearest is body.bar.mesh.size");
  // A key of the other kind of mesh is unknown too.
  EXPECT_EQ(
      error(with(14, "mesh = { type = \"block\", size = [1, 2, 3], elements = [2, 3, 4], layers = 2 }")).substr(0, 42),
      "14:66: body.bar.mesh.layers: unknown key, ");
}

TEST_F(SceneTest, MissingKeys) {
  EXPECT_EQ(error(with(3, "")), "2:1: time.end: missing, expected a number > 0");
  auto lines = minimal;
  lines[1] = lines[2] = "";
  EXPECT_EQ(error(lines), "1:1: time.end: missing, expected a number > 0");
  EXPECT_EQ(error(with(5, "")), "4:1: material.0.name: missing, expected a text in quotes");
  EXPECT_EQ(error(with(6, "")), "4:1: material.copper.model: missing, expected \"elastic\" or \"von_mises\"");
  EXPECT_EQ(error(with(7, "")), "4:1: material.copper.density: missing, expected a number > 0");
  EXPECT_EQ(error(with(9, "")), "4:1: material.copper.shear_modulus: missing, expected a number > 0");
  EXPECT_EQ(error(with(10, "")), "4:1: material.copper.yield_stress: missing, expected a number > 0");
  EXPECT_EQ(error(with(13, "")), "11:1: body.bar.material: missing, expected a text in quotes");
  EXPECT_EQ(error(with(14, "mesh = { type = \"block\", size = [1, 2, 3] }")),
            "14:8: body.bar.mesh.elements: missing, expected an array of 3 integers >= 1");
  EXPECT_EQ(error({minimal.begin(), minimal.begin() + 10}), "1:1: body: missing, expected at least one [[body]]");
}

TEST_F(SceneTest, WrongTypesAndValues) {
  EXPECT_EQ(error(with(3, "end = \"soon\"")), "3:7: time.end: expected a number > 0, got \"soon\"");
  EXPECT_EQ(error(with(3, "end = 0")), "3:7: time.end: expected a number > 0, got 0");
  EXPECT_EQ(error(with(3, "end = nan")), "3:7: time.end: expected a number > 0, got nan");
  EXPECT_EQ(error(with(3, "end = inf")), "3:7: time.end: expected a number > 0, got inf");
  EXPECT_EQ(error(with(3, "end = 1\ncfl = 1.3")), "4:7: time.cfl: expected a number > 0 and <= 1.2, got 1.3");
  EXPECT_EQ(error(with(3, "end = 1\nsteps = 0")),
            "4:9: time.steps: expected an integer >= 1, or -1 for no limit, got 0");
  EXPECT_EQ(error(with(3, "end = 1\nsteps = 1.5")), "4:9: time.steps: expected an integer >= -1, got 1.5");
  EXPECT_EQ(error(with(7, "density = -1")), "7:11: material.copper.density: expected a number > 0, got -1");
  EXPECT_EQ(error(with({"[contact]", "self = 1"})), "16:8: contact.self: expected true or false, got 1");
  EXPECT_EQ(error(with({"[contact]", "beta = -1"})), "16:8: contact.beta: expected a number >= 0, got -1");
  EXPECT_EQ(error(with(1, "contact = 3")), "1:11: contact: expected a table, got 3");
  EXPECT_EQ(error(with({"velocity = [1, 2]"})),
            "15:12: body.bar.velocity: expected an array of 3 numbers, got an array of 2 values");
  EXPECT_EQ(error(with({"velocity = [1, nan, 2]"})), "15:16: body.bar.velocity[1]: expected a finite number, got nan");
  EXPECT_EQ(error(with({"velocity_gradient = [[1, 2, 3], [4, 5, 6], [7, \"8\", 9]]"})),
            "15:48: body.bar.velocity_gradient[2][1]: expected a finite number, got \"8\"");
  EXPECT_EQ(error(with({"axis = [0, 0, 0]"})),
            "15:8: body.bar.axis: expected a vector of non-zero, finite length, got [0, 0, 0]");
  EXPECT_EQ(error(with({"[[constraint]]", "type = \"symmetry\"", "normal = [0, 0, 0.0]"})),
            "17:10: constraint.0.normal: expected a vector of non-zero, finite length, got [0, 0, 0]");
  EXPECT_EQ(error({"time = { end = 1 }", "body = [4]"}), "2:9: body[0]: expected tables [[body]], got 4");
}

TEST_F(SceneTest, MeshesOfNoSize) {
  EXPECT_EQ(error(with(14, "mesh = { type = \"block\", size = [1, 0, 3], elements = [2, 3, 4] }")),
            "14:37: body.bar.mesh.size[1]: expected a number > 0, got 0");
  EXPECT_EQ(error(with(14, "mesh = { type = \"block\", size = [1, 2, 3], elements = [2, 3, 0] }")),
            "14:62: body.bar.mesh.elements[2]: expected an integer >= 1, got 0");
  EXPECT_EQ(error(with(14, "mesh = { type = \"round_nosed_rod\", length = 1, radius = -0.5, layers = 2 }")),
            "14:57: body.bar.mesh.radius: expected a number > 0, got -0.5");
  EXPECT_EQ(error(with(14, "mesh = { type = \"round_nosed_rod\", length = 0.5, radius = 0.5, layers = 2 }")),
            "14:45: body.bar.mesh.length: expected a number > radius = 0.5, the depth of the nose, got 0.5");
  EXPECT_EQ(error(with(14, "mesh = { type = \"round_nosed_rod\", length = 1, radius = 0.5, layers = 2, ring = 0 }")),
            "14:81: body.bar.mesh.ring: expected an integer >= 1, got 0");
  EXPECT_EQ(error(with(14, "mesh = { type = \"block\", size = [1, 2, 3], elements = [2000, 2000, 2000] }")),
            "14:55: body.bar.mesh.elements: 8e+09 elements are more than a mesh can hold");
  const std::string too_many = " elements in one direction are more than a mesh can hold";
  EXPECT_EQ(error(with(14, "mesh = { type = \"block\", size = [1, 2, 3], elements = [1, 2, 2147483648] }")),
            "14:55: body.bar.mesh.elements: 2147483648" + too_many);
  EXPECT_EQ(error(with(14, "mesh = { type = \"round_nosed_rod\", length = 1, radius = 0.5, layers = 2147483648 }")),
            "14:71: body.bar.mesh.layers: 2147483648" + too_many);
  EXPECT_EQ(error(with(14, "mesh = { type = \"round_nosed_rod\", length = 1, radius = 0.5, core = [2, 2147483648] }")),
            "14:69: body.bar.mesh.core: 2147483648" + too_many);
  EXPECT_EQ(error(with(14, "mesh = { type = \"sphere\", radius = 1, core = 2147483648 }")),
            "14:46: body.bar.mesh.core: 2147483648" + too_many);
  EXPECT_EQ(error(with(14, "mesh = { type = \"sphere\", radius = 1, core = 2147483646 }"), {.refine = 2}),
            "14:46: body.bar.mesh.core: 4294967292" + too_many);
  if (memory_bytes() < 700 * 3.43e8) {
    EXPECT_THAT(
        error(with(14, "mesh = { type = \"block\", size = [1, 2, 3], elements = [700, 700, 700] }")),
        testing::StartsWith("14:55: body.bar.mesh.elements: 3.43e+08 elements are more than this machine's memory"));
  }
  EXPECT_EQ(error(with(14, "mesh = { type = \"ball\" }")),
            "14:17: body.bar.mesh.type: expected \"block\", \"round_nosed_rod\", \"cylinder\", \"sphere\", "
            "\"file\", \"gmsh\", \"keyword\", \"exodus\", \"vtk\", \"abaqus\" or \"radioss\", got \"ball\"");
}

TEST_F(SceneTest, CylindersAndSpheres) {
  const auto mesh = [this](const std::string& text, int refine = 1) {
    return read(with(14, "mesh = { " + text + " }"), {.refine = refine}).bodies[0].mesh;
  };
  const auto full =
      std::get<CylinderMesh>(mesh("type = \"cylinder\", radius = 2, length = 5, core = 3, layers = 7", 2));
  EXPECT_EQ(full.section, Section::full);
  EXPECT_EQ(full.radius, 2);
  EXPECT_EQ(full.length, 5);
  EXPECT_EQ(full.core, 6);
  EXPECT_EQ(full.ring, 2);
  EXPECT_EQ(full.layers, 14);
  const auto wedge = std::get<CylinderMesh>(
      mesh("type = \"cylinder\", section = \"wedge\", angle = 10, radius = 2, length = 5, radial = 4, layers = 7", 3));
  EXPECT_EQ(wedge.section, Section::wedge);
  EXPECT_EQ(wedge.angle, 10);
  EXPECT_EQ(wedge.radial, 12);
  const auto half =
      std::get<SphereMesh>(mesh("type = \"sphere\", section = \"half\", radius = 2, core = 4, ring = 3", 2));
  EXPECT_EQ(half.section, Section::half);
  EXPECT_EQ(half.core, (std::array{8, 8}));
  EXPECT_EQ(half.ring, 6);
  EXPECT_EQ(half.grading, 1);
  const auto slice = std::get<SphereMesh>(
      mesh("type = \"sphere\", section = \"wedge\", angle = 10, radius = 5, core = [11, 17], ring = 8, grading = 0.2"));
  EXPECT_EQ(slice.core, (std::array{11, 17}));
  EXPECT_EQ(slice.grading, 0.2);

  const auto bad = [this](const std::string& text) { return error(with(14, "mesh = { " + text + " }")); };
  EXPECT_EQ(bad("type = \"sphere\", radius = 1, core = 3, section = \"quarter\""),
            "14:46: body.bar.mesh.core: expected an even integer, since the section is cut through it, got 3");
  EXPECT_EQ(bad("type = \"sphere\", radius = 1, core = 4, angle = 10"),
            "14:57: body.bar.mesh.angle: not used where section is not \"wedge\"");
  EXPECT_EQ(bad("type = \"sphere\", radius = 1, core = [4, 4], section = \"wedge\", angle = 90"),
            "14:81: body.bar.mesh.angle: expected a number > 0 and <= 60, got 90");
  EXPECT_EQ(bad("type = \"cylinder\", radius = 1, length = 1, core = 4, section = \"wedge\", angle = 9, layers = 2"),
            "14:60: body.bar.mesh.core: not used where section = \"wedge\", which has radial");
  EXPECT_EQ(bad("type = \"sphere\", radius = 1, core = 4, layers = 2").substr(0, 33),
            "14:49: body.bar.mesh.layers: unkn");
}

TEST_F(SceneTest, Materials) {
  EXPECT_EQ(error(with(10, "yield_stress = 4e8\nultimate_stress = 3e8")),
            "11:19: material.copper.ultimate_stress: expected a number >= yield_stress = 400000000, got 300000000");
  EXPECT_EQ(error(with(9, "young_modulus = 1")),
            "9:17: material.copper.young_modulus: expected either bulk_modulus and shear_modulus or young_modulus and "
            "poisson_ratio, got keys of both");
  auto lines = with(8, "young_modulus = 3");
  for (const std::string nu : {"-1", "0.5", "0.6"}) {
    lines[8] = "poisson_ratio = " + nu;
    EXPECT_EQ(error(lines), "9:17: material.copper.poisson_ratio: expected a number > -1 and < 0.5, got " + nu);
  }
  lines[8] = "poisson_ratio = 0";
  const Scene scene = read(lines);
  EXPECT_DOUBLE_EQ(scene.materials[0].bulk_modulus, 1.0);
  EXPECT_DOUBLE_EQ(scene.materials[0].shear_modulus, 1.5);
  // An elastic material keeps nothing of plasticity.
  const Scene elastic =
      read(with(10, "yield_stress = 4e8\nerosion_strain = 1"), {.set = {"material.copper.model=elastic"}});
  EXPECT_FALSE(elastic.materials[0].plastic);
  EXPECT_EQ(elastic.materials[0].erosion_strain, 0.0);
}

TEST_F(SceneTest, ChoicesListWhatIsAllowed) {
  EXPECT_EQ(
      error(with({"[element]", "hourglass = \"vicsous\""})),
      "16:13: element.hourglass: expected \"none\", \"viscous\", \"stiffness\" or \"assumed_strain\", got \"vicsous\"");
  EXPECT_EQ(error(with(1, "precision = \"half\"")),
            "1:13: precision: expected \"double\", \"float\" or \"mixed\", got \"half\"");
  EXPECT_EQ(error(with({"[output]", "fields = [\"stress\", \"stres\"]"})),
            "16:21: output.fields[1]: expected \"velocity\", \"contact_force\", \"stress\", \"plastic_strain\", "
            "\"pinball_radius\", \"alive\", \"displacement\", \"pressure\", \"corner_share\", \"triaxiality\", "
            "\"temperature\" or \"damage\", got \"stres\"");
}

TEST_F(SceneTest, AMisspeltContactIsRejected) {
  EXPECT_EQ(error(with({"[contact]", "method = \"sideline\""})),
            "16:10: contact.method: expected \"none\", \"pinball\" or \"slideline\", got \"sideline\"");
}

TEST_F(SceneTest, WhatThisVersionLacksIsSaid) {
  EXPECT_EQ(error(with({"[contact]", "enforcement = \"penalty\"", "gap = \"face\""})),
            "17:7: contact.gap: \"face\" needs enforcement = \"projection\" or \"lagrange\" in this version");
}

TEST_F(SceneTest, AHourglassCoefficientBelongsToAForm) {
  EXPECT_EQ(
      set_error("element.hourglass_coefficient=0.05"),
      "--set element.hourglass_coefficient=0.05: needs hourglass beside it, the form that it is a coefficient of");
}

TEST_F(SceneTest, BlocksInSections) {
  const Scene scene = read(with(14, "mesh = { type = \"block\", size = [1, [2, 0.5], 3], elements = [2, [3, 4], 5] }"));
  const auto& mesh = std::get<BlockMesh>(scene.bodies[0].mesh);
  EXPECT_EQ(mesh.size, (Point{1, 2.5, 3}));
  EXPECT_EQ(mesh.elements, (std::array<int, 3>{2, 7, 5}));
  EXPECT_TRUE(mesh.sections[0].empty());
  ASSERT_EQ(mesh.sections[1].size(), 2);
  EXPECT_EQ(mesh.sections[1][1].length, 0.5);
  EXPECT_EQ(mesh.sections[1][1].elements, 4);
  EXPECT_EQ(error(with(14, "mesh = { type = \"block\", size = [1, [2, 0.5], 3], elements = [2, 3, 5] }")),
            "14:62: body.bar.mesh.elements: expected as many sections as of size along y, 2, got 1");
  EXPECT_EQ(error(with(14, "mesh = { type = \"block\", size = [1, [], 3], elements = [2, 3, 5] }")),
            "14:37: body.bar.mesh.size[1]: expected at least one number, got none");
  EXPECT_EQ(error(with(14, "mesh = { type = \"block\", size = [1, [2, 0], 3], elements = [2, [3, 1], 5] }")),
            "14:41: body.bar.mesh.size[1][1]: expected a number > 0, got 0");
}

TEST_F(SceneTest, NamesAndReferences) {
  EXPECT_EQ(error(with(13, "material = \"cooper\"")),
            "13:12: body.bar.material: no material is named \"cooper\", nearest is \"copper\"");
  EXPECT_EQ(error(with(5, "name = \"a.b\"")),
            "5:8: material.a.b.name: expected a name of letters, digits, \"_\" and \"-\", got \"a.b\"");
  auto lines = minimal;
  for (std::size_t i = 10; i < 14; ++i) lines.push_back(minimal[i]);
  EXPECT_EQ(error(lines),
            "16:8: body.bar.name: expected a name of its own, got \"bar\" a second time; the first is in line 12");
  lines = minimal;
  for (std::size_t i = 3; i < 10; ++i) lines.push_back(minimal[i]);
  EXPECT_EQ(
      error(lines),
      "16:8: material.copper.name: expected a name of its own, got \"copper\" a second time; the first is in line 5");
  EXPECT_EQ(error(with({"[[constraint]]", "type = \"symmetry\"", "normal = [0, 1, 0]", "body = \"baar\""})),
            "18:8: constraint.0.body: no body is named \"baar\", nearest is \"bar\"");
}

TEST_F(SceneTest, Syntax) {
  EXPECT_EQ(error(with(3, "end = = 2")).substr(0, 21), "3:7: not valid TOML: ");
  // What stands twice is told with both lines, in one table and in two.
  EXPECT_THAT(error(with({"[output]", "interval = 1", "fields = []", "interval = 2"})),
              testing::AllOf(testing::StartsWith("18:"), testing::EndsWith("'interval'; the first is in line 16")));
  EXPECT_THAT(error(with({"[element]", "[output]", "interval = 1", "[element]"})),
              testing::AllOf(testing::StartsWith("18:"), testing::EndsWith("; the first is in line 15")));
  EXPECT_EQ(error(with(3, "end = 1\nend = 2")).substr(0, 2), "4:");
  EXPECT_THROW(read_scene((folder_ / "none.toml").string()), InputError);
  EXPECT_THROW(read_scene(folder_.string()), InputError);
}

}  // namespace
}  // namespace pinball::scene_test

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include <solver/scene/toml/listing.hpp>
#include <solver/scene/toml/table.hpp>
#include <solver/scene_rules.hpp>

namespace pinball::listing_test {
namespace {

/// A scene in which every kind of table is.
Scene example() {
  Scene scene;
  scene.time.end = 2.0;
  scene.materials = {{.name = "steel",
                      .plastic = true,
                      .density = 1,
                      .bulk_modulus = 2,
                      .shear_modulus = 1,
                      .yield_stress = 0.1,
                      .yield_curves = {},
                      .power_hardening = {},
                      .johnson_cook = {},
                      .johnson_holmquist = {},
                      .drucker_prager = {},
                      .crushable_foam = {},
                      .mooney_rivlin = {},
                      .ogden = {},
                      .orthotropic = {},
                      .fluid = {},
                      .equation_of_state = {},
                      .erosion = {}}};
  Body body;
  body.name = "bar";
  body.material = "steel";
  body.mesh = BlockMesh{{1, 1, 1}, {1, 2, 3}};
  body.velocity = {0, 0, 7};
  scene.bodies = {body};
  scene.contact.method = ContactMethod::pinball;
  scene.contact.friction = 0.25;
  scene.rigid_walls.emplace_back().plane.normal = {0, 0, 1};
  return checked_scene(scene);
}

std::vector<SceneEntry> in_table(const std::vector<SceneEntry>& all, const std::string& table) {
  std::vector<SceneEntry> found;
  for (const SceneEntry& entry : all) {
    if (entry.table == table) found.push_back(entry);
  }
  return found;
}

SceneEntry entry_of(const std::string& table, const std::string& key) {
  for (const SceneEntry& entry : list_scene(example())) {
    if (entry.table == table && entry.key == key) return entry;
  }
  return {"", "", "missing", "", false};
}

TEST(SceneListing, HasEveryKeyOfTheTablesThatAllScenesHave) {
  const std::vector<SceneEntry> all = list_scene(example());
  const std::set<std::string> apart{
      "name",      "use",           "young_modulus", "poisson_ratio", "mesh",
      "pair",      "tied",          "times",  // otherwise
      "box",       "set",           "nodes",         "file",          "without",
      "tolerance", "mooney_rivlin", "ogden",         "orthotropic"};  // where they are given
  for (const auto& [kind, table] :
       std::vector<std::pair<std::string, std::string>>{{"time", "time"},
                                                        {"element", "element"},
                                                        {"contact", "contact"},
                                                        {"skip", "skip"},
                                                        {"guard", "guard"},
                                                        {"output", "output"},
                                                        {"damping", "damping"},
                                                        {"material", "material.steel"},
                                                        {"body", "body.bar"},
                                                        {"block", "body.bar.mesh"},
                                                        {"rigid_wall", "rigid_wall.wall_0"}}) {
    const auto of_kind = std::find_if(scene_keys().begin(), scene_keys().end(),
                                      [&](const TableKeys& keys) { return keys.kind == kind; });
    ASSERT_NE(of_kind, scene_keys().end()) << kind;
    const std::vector<SceneEntry> entries = in_table(all, table);
    for (const std::string_view key : of_kind->keys) {
      if (apart.contains(std::string(key))) continue;
      EXPECT_EQ(std::count_if(entries.begin(), entries.end(), [&](const SceneEntry& e) { return e.key == key; }), 1)
          << table << '.' << key;
    }
  }
}

TEST(SceneListing, TellsWhatIsDefault) {
  EXPECT_FALSE(entry_of("contact", "friction").is_default);
  EXPECT_EQ(entry_of("contact", "friction").value, "0.25");
  EXPECT_TRUE(entry_of("contact", "static_friction").is_default) << "it follows from friction";
  EXPECT_EQ(entry_of("contact", "static_friction").value, "0.25");
  EXPECT_TRUE(entry_of("contact", "gap").is_default);
  EXPECT_EQ(entry_of("contact", "gap").value, "\"face\"");
  EXPECT_FALSE(entry_of("contact", "method").is_default);
  EXPECT_TRUE(entry_of("element", "hourglass_coefficient").is_default);
  EXPECT_EQ(entry_of("element", "hourglass_coefficient").value, "1");
  EXPECT_FALSE(entry_of("time", "end").is_default);
  EXPECT_TRUE(entry_of("time", "cfl").is_default);
}

TEST(SceneListing, TellsWhetherAProbeWatchesAllThatItMay) {
  for (const ProbeKind kind : {ProbeKind::node, ProbeKind::element}) {
    const std::vector<std::string> all = probe_quantities(kind), first{all.front()};
    for (const auto& given : {std::vector<std::string>{}, all, first}) {
      Scene scene = example();
      scene.probes = {{"tip", kind, {0, 0, 0}, "", given}};
      bool found = false;
      for (const SceneEntry& entry : list_scene(scene)) {
        if (entry.table != "probe.tip" || entry.key != "quantities") continue;
        found = true;
        EXPECT_EQ(entry.is_default, given != first);
        const std::string second = '"' + all[1] + '"';
        EXPECT_EQ(entry.value.find(second) != std::string::npos, given != first) << entry.value;
        EXPECT_NE(entry.value.find('"' + first[0] + '"'), std::string::npos) << entry.value;
      }
      EXPECT_TRUE(found);
    }
  }
}

TEST(SceneListing, HasWhatOnlyAHostCanGive) {
  Scene scene = example();
  scene.rigid_walls[0].nodes.plane = Plane{{1, 2, 3}, {0, 1, 0}};
  std::vector<std::string> keys;
  for (const SceneEntry& entry : in_table(list_scene(scene), "rigid_wall.wall_0")) keys.push_back(entry.key);
  EXPECT_THAT(keys, testing::IsSupersetOf({"plane.point", "plane.normal"}));
  EXPECT_EQ(std::count(keys.begin(), keys.end(), "body"), 1);
}

/// Studies go on with a run whose scene is listed as it was.
TEST(SceneListing, TellsAsManyOtherNumbersApart) {
  const auto listed = [](std::vector<std::int64_t> numbers) {
    Scene scene = example();
    scene.fixed_constraints.emplace_back().nodes.nodes = std::move(numbers);
    std::string text;
    for (const SceneEntry& entry : list_scene(scene)) text += entry.key == "nodes" ? entry.value : "";
    return text;
  };
  std::vector<std::int64_t> many(100);
  std::iota(many.begin(), many.end(), 1);
  const std::string first = listed(many);
  many[50] = 1000;
  EXPECT_EQ(listed({3, 5, 9}), "[3, 5, 9]");
  EXPECT_EQ(first.substr(0, 11), "100 numbers");
  EXPECT_NE(first, listed(many));
}

TEST(SceneListing, WritesValuesAsASceneHasThem) {
  EXPECT_EQ(entry_of("body.bar", "velocity").value, "[0, 0, 7]");
  EXPECT_EQ(entry_of("body.bar", "velocity").unit, "L/T");
  EXPECT_EQ(entry_of("body.bar", "velocity_gradient").value, "[[0, 0, 0], [0, 0, 0], [0, 0, 0]]");
  EXPECT_EQ(entry_of("body.bar.mesh", "elements").value, "[1, 2, 3]");
  EXPECT_EQ(entry_of("material.steel", "ultimate_stress").value, "infinite");
  EXPECT_EQ(entry_of("output", "interval").value, "0.01") << "200 rows of a run to 2";
  EXPECT_EQ(entry_of("rigid_wall.wall_0", "normal").value, "[0, 0, 1]");
}

}  // namespace
}  // namespace pinball::listing_test

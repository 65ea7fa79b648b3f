#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include <solver/mesh/file/input_file.hpp>
#include <solver/output/history.hpp>
#include <solver/results/warnings.hpp>
#include <solver/scene/given/given_scene.hpp>
#include <solver/scene/given/toml_file.hpp>
#include <solver/scene/schema/kinds.hpp>
#include <solver/scene/schema/scene.hpp>
#include <solver/scene/toml/list_keys.hpp>
#include <solver/scene/without_keys.hpp>
#include <solver/simulation.hpp>
#include <tests/support/output_case.hpp>

#include "key_effects_scenes.hpp"
#include "silent_by_nature.hpp"

/// Each key of the format does something, is told or is refused, in each of some scenes: it is set to another value,
/// and either what comes of the scene is another, or a sentence names the key.
namespace pinball::key_effects_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// Two cubes in a row along x, of a keyword file: a set of nodes on y = 0.
const std::string cubes = R"(*KEYWORD
*NODE
       1             0.0             0.0             0.0
       2             0.0             0.5             0.0
       3             0.0             0.5             0.5
       4             0.0             0.0             0.5
       5             0.5             0.0             0.0
       6             0.5             0.5             0.0
       7             0.5             0.5             0.5
       8             0.5             0.0             0.5
       9             1.0             0.0             0.0
      10             1.0             0.5             0.0
      11             1.0             0.5             0.5
      12             1.0             0.0             0.5
*ELEMENT_SOLID
       1       1       5       6       2       1       8       7       3       4
       2       1       9      10       6       5      12      11       7       8
*SET_NODE_LIST
         7
         1         4         5         8         9        12
*END
)";

/// What comes of a scene.
struct Outcome {
  std::vector<double> numbers;  ///< of all rows of the history
  std::vector<std::string> columns;
  std::uint64_t hash = 0;
  std::string told;  ///< why it is refused, or what is told of it

  bool same_results(const Outcome& other) const {
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    return hash == other.hash && columns == other.columns && std::ranges::equal(numbers, other.numbers, same);
  }
};

constexpr int most_steps = 40;

class Runner {
 public:
  Runner() {
    std::ofstream(folder_ / "cubes.k") << cubes;
    std::ofstream(folder_ / "tube.k") << cubes;
  }

  Outcome outcome(const GivenTable& table) const {
    Outcome result;
    try {
      const auto given = std::make_shared<GivenScene>();
      given->table = table;
      Simulation simulation(read_scene(SceneSource{folder_ / "scene.toml", "", {}, given}));
      result.columns = simulation.history_columns();
      do {
        const std::vector<double> row = history_numbers(simulation.history_row());
        result.numbers.insert(result.numbers.end(), row.begin(), row.end());
      } while (simulation.steps() < most_steps && simulation.step());
      result.hash = simulation.state_hash();
      const RunSummary summary = simulation.summary();
      for (const std::string& warning : start_warnings(summary)) result.told += warning + '\n';
      for (const std::string& warning : summary.near_nodes) result.told += warning + '\n';
      const FieldSnapshot fields = simulation.snapshot();
      for (const auto* field : {&fields.temperature, &fields.damage, &fields.pinball_radius})
        result.numbers.insert(result.numbers.end(), field->begin(), field->end());
    } catch (const std::exception& error) {
      result.told = error.what();
      result.hash = 1;
    }
    return result;
  }

 private:
  test::TemporaryFolder folder_{"key_effects"};
};

std::string text_of(const GivenTable& table, const std::string& key) {
  const GivenValue* value = table.find(key);
  return value != nullptr && value->as<std::string>() != nullptr ? *value->as<std::string>() : "";
}

/// As the format names tables of the same keys (schema/kinds.hpp).
std::string kind_of(const std::string& parent, const std::string& key, const GivenTable& table) {
  if (parent == "contact" && (key == "pair" || key == "tied")) return "contact_" + key;
  return key == "mesh" || key == "constraint" ? text_of(table, "type") : key;
}

/// Calls visit(kind, table) for each table of a scene. Visit may change it.
template <class Table, class Visit>
void for_each_table(Table& table, const std::string& kind, const Visit& visit) {
  visit(kind, table);
  for (auto& entry : table.entries()) {
    if (entry.key == "variant") continue;
    if (auto* inner = entry.value.template as<GivenTable>()) {
      for_each_table(*inner, kind_of(kind, entry.key, *inner), visit);
    }
    if (auto* list = entry.value.template as<GivenArray>()) {
      for (auto& value : *list) {
        if (auto* inner = value.template as<GivenTable>())
          for_each_table(*inner, kind_of(kind, entry.key, *inner), visit);
      }
    }
  }
}

std::string toml_of(const GivenValue& value) {
  GivenTable table;
  table.set("value", value);
  const std::string text = write_toml(table);
  return text.substr(text.find("value"));
}

/// Of each key of each kind of table the values that every_key.toml has.
std::map<std::string, std::map<std::string, std::vector<GivenValue>>> every_value() {
  const std::string path = PINBALL_SOURCE_DIR "/tests/scene/every_key.toml";
  const GivenTable scene = parse_toml(bytes_of_file(path), path);
  std::map<std::string, std::map<std::string, std::vector<GivenValue>>> all;
  for_each_table(scene, "scene", [&](const std::string& kind, const GivenTable& table) {
    for (const GivenEntry& entry : table.entries()) {
      const auto* list = entry.value.as<GivenArray>();
      if (kind == "scene" && (entry.value.is_table() || (list && !list->empty() && list->front().is_table()))) continue;
      std::vector<GivenValue>& values = all[kind][entry.key];
      const auto same = [&](const GivenValue& one) { return toml_of(one) == toml_of(entry.value); };
      if (std::ranges::none_of(values, same)) values.push_back(entry.value);
    }
  });
  return all;
}

/// The text of a value, numbers as numbers whatever their form.
std::string plain_text(const GivenValue& value) {
  if (const auto number = value.number()) return toml_text(*number);
  if (const auto* text = value.as<std::string>()) return toml_text(*text);
  if (const auto* truth = value.as<bool>()) return toml_text(*truth);
  const auto* list = value.as<GivenArray>();
  if (list == nullptr) return "";
  std::string all;
  for (const GivenValue& one : *list) all += (all.empty() ? "" : ", ") + plain_text(one);
  return list->empty() || all.ends_with(", ") ? "" : '[' + all + ']';
}

bool same_value(const GivenValue& one, const GivenValue& other) {
  return toml_of(one) == toml_of(other) || (!plain_text(one).empty() && plain_text(one) == plain_text(other));
}

/// What keys are where they are not given, by kind and key.
using Defaults = std::map<std::string, std::map<std::string, std::string>>;

template <class T>
struct DefaultsOf {
  std::map<std::string, std::string>& of_keys;
  const T without;

  template <class Any>
  void operator()(const Any&) const {}
  template <class Value>
  void operator()(const schema::Key<T, Value>& key) const {
    if constexpr (requires(const Value& value) { toml_text(value); }) {
      const Value& value = without.*key.member;
      if constexpr (!requires { value.has_value(); }) {
        if (!schema::is_unset(value, key.about)) of_keys[key.name] = toml_text(value);
      }
    }
  }
  template <class Part>
  void operator()(const schema::Group<T, Part>& group) const {
    visit_group(group, DefaultsOf<Part>{of_keys, without.*group.member});
  }
};

template <class... Types>
Defaults defaults_of() {
  Defaults all;
  (describe(schema::Of<Types>{}, DefaultsOf<Types>{all[schema::kind(schema::Of<Types>{}).name], without_keys(Types{})}),
   ...);
  return all;
}

bool is_default(const std::string& kind, const std::string& key, const GivenValue& value) {
  static const Defaults all =
      defaults_of<Scene, TimeSettings, ElementSettings, ContactSettings, ContactPair, TiedContact, SkipSettings,
                  GuardSettings, DampingSettings, OutputSettings, Material, JohnsonCookSettings, DruckerPragerSettings,
                  CrushableFoamSettings, MooneyRivlinSettings, OgdenSettings, OrthotropicSettings, FluidSettings,
                  EquationOfStateSettings, ErosionSettings, Body, RoundNosedRodMesh, CylinderMesh, SphereMesh,
                  RigidBody, AttachedNodes, RigidMotion, Joint, PlaneConstraint, FixedConstraint, EquationTerm, Plane,
                  Line, RigidWall, PrescribedVelocity, NodalLoad, Pressure, Gravity, PointMass, InitialVelocity,
                  InitialStress, Probe>();
  const auto of_kind = all.find(kind);
  if (of_kind == all.end()) return false;
  const auto found = of_kind->second.find(key);
  return found != of_kind->second.end() && found->second == plain_text(value);
}

/// What of a scene a key is silent in.
struct Silent {
  std::string scene, kind, key, value;
};

/// That of silent_by_nature.hpp.
std::string special_kind(const std::string& kind, const std::string& text) {
  if (kind == "material" && text.find("model = \"elastic\"") != std::string::npos) return "elastic material";
  return kind == "contact" && text.find("method = \"none\"") != std::string::npos ? "contact that is off" : kind;
}

std::vector<Silent> silent_keys(const Runner& runner, const std::string& name, const std::string& text) {
  static const auto values = every_value();
  GivenTable given = parse_toml(text, name);
  for (const char* table : {"element", "contact", "skip", "guard", "damping", "output"}) {
    if (!given.contains(table)) given.set(table, GivenValue(GivenTable{}));
  }
  const Outcome before = runner.outcome(given);
  EXPECT_NE(before.hash, 1U) << name << ": " << before.told;
  std::vector<Silent> silent;
  // By numbers, since each change is made in a copy.
  std::vector<std::string> kinds;
  for_each_table(given, "scene", [&](const std::string& kind, const GivenTable&) { kinds.push_back(kind); });
  for (std::size_t t = 0; t < kinds.size(); ++t) {
    if (!values.contains(kinds[t])) continue;
    for (const auto& [key, others] : values.at(kinds[t])) {
      for (const GivenValue& value : others) {
        GivenTable changed = given;
        bool same = false;
        std::size_t number = 0;
        for_each_table(changed, "scene", [&, key = key](const std::string&, GivenTable& table) {
          if (number++ != t) return;
          const GivenValue* old = table.find(key);
          same = old != nullptr ? same_value(*old, value) : is_default(kinds[t], key, value);
          if (!same) table.set(key, value);
        });
        if (same) continue;
        const Outcome after = runner.outcome(changed);
        if (after.hash == 1U || !after.same_results(before)) continue;
        if (after.told != before.told && after.told.find(key) != std::string::npos) continue;
        silent.push_back({name, special_kind(kinds[t], text), key, toml_of(value)});
      }
    }
  }
  return silent;
}

TEST(KeyEffects, AreSeenOrTold) {
  const Runner runner;
  std::set<const test::SilentByNature*> used;
  for (const auto& [name, text] : test::key_effects_scenes()) {
    for (const Silent& one : silent_keys(runner, name, text)) {
      const auto* const known = test::silent_by_nature(one.kind, one.key);
      if (known == nullptr) ADD_FAILURE() << one.scene << " | " << one.kind << " | " << one.key << " | " << one.value;
      used.insert(known);
    }
  }
  for (const test::SilentByNature& one : test::all_silent_by_nature) {
    EXPECT_TRUE(used.contains(&one)) << one.kind << '.' << one.key << " is seen or told by now";
  }
}

}  // namespace
}  // namespace pinball::key_effects_test

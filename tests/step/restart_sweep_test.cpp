#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <set>

#include <solver/output/history.hpp>
#include <solver/scene/toml/table.hpp>
#include <solver/simulation.hpp>
#include <solver/summary.hpp>
#include <tests/support/changing_scene.hpp>
#include <tests/support/every_input.hpp>
#include <tests/support/folder_case.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/scene_text.hpp>

/// Saving and going on changes nothing, whatever the scene has and whenever it is done.
namespace pinball::restart_sweep_test {
namespace {

using test::load;
using test::saved;

/// All that a run tells at the time, but for seconds, threads and memory.
std::string told_by(const Simulation& simulation) {
  RunSummary summary = simulation.summary();
  summary.threads = 0;
  summary.phases.clear();
  summary.skipped_seconds = {};
  summary.wall_seconds = 0;
  summary.bytes_per_element = 0;
  return summary_json(summary);
}

/// The same at its end.
std::string outcome(Simulation& simulation) {
  simulation.run();
  return told_by(simulation);
}

/// A row of the history.
std::vector<double> row_of(const Simulation& simulation) { return history_numbers(simulation.history_row()); }

/// What a run is before a step.
struct Stop {
  std::int64_t step;
  StateBytes bytes;
  std::string told;
  FieldSnapshot fields;
};

void expect_same_fields(const FieldSnapshot& one, const FieldSnapshot& other) {
  EXPECT_EQ(one.time, other.time);
  EXPECT_EQ(one.position, other.position);
  EXPECT_EQ(one.velocity, other.velocity);
  EXPECT_EQ(one.contact_force, other.contact_force);
  EXPECT_EQ(one.stress, other.stress);
  EXPECT_EQ(one.plastic_strain, other.plastic_strain);
  EXPECT_EQ(one.pinball_radius, other.pinball_radius);
  EXPECT_EQ(one.alive, other.alive);
}

/// A simulation that goes on from a state which another one has read, saved and not gone on from.
Simulation gone_on(const Scene& scene, const StateBytes& bytes, int threads) {
  Simulation between(scene, {1}), rest(scene, {threads});
  EXPECT_EQ(load(between, bytes), 0U);
  EXPECT_EQ(load(rest, saved(between)), 0U);
  return rest;
}

/// Saves before some of the steps and goes on from each in a simulation of its own: it tells what the run has told
/// there, and then the same row by row up to the step after the next of these, one of them to the end.
void expect_same_after_restarts(const Scene& scene, const std::set<std::int64_t>& saves) {
  Simulation whole(scene, {1});
  std::vector<Stop> states;
  std::vector<std::vector<double>> rows;
  while (!whole.at_end()) {
    const auto step = static_cast<std::int64_t>(rows.size());
    if (saves.contains(step)) states.push_back({step, saved(whole), told_by(whole), whole.snapshot()});
    whole.step();
    rows.push_back(row_of(whole));
  }
  const std::string expected = outcome(whole);
  ASSERT_FALSE(states.empty());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto from = static_cast<std::size_t>(states[i].step);
    Simulation rest = gone_on(scene, states[i].bytes, 1 + static_cast<int>(i % 3));
    if (from > 0) {
      EXPECT_EQ(row_of(rest), rows[from - 1]) << "as read after step " << from;
    }
    EXPECT_EQ(told_by(rest), states[i].told) << "as read after step " << from;
    expect_same_fields(rest.snapshot(), states[i].fields);
    const auto to = i + 1 < states.size() ? static_cast<std::size_t>(states[i + 1].step) + 2 : rows.size();
    for (std::size_t step = from; step < std::min(to, rows.size()); ++step) {
      rest.step();
      ASSERT_EQ(row_of(rest), rows[step]) << "in step " << step << " from step " << from;
    }
    if (to >= rows.size()) {
      EXPECT_EQ(outcome(rest), expected) << "from step " << from;
    }
  }
}

/// Numbers of steps, at random.
std::set<std::int64_t> some_steps(std::size_t count, std::int64_t end, unsigned seed) {
  std::mt19937 random(seed);
  std::set<std::int64_t> steps{0};
  while (steps.size() < std::min(count, static_cast<std::size_t>(end))) steps.insert(random() % end);
  return steps;
}

std::int64_t steps_of(const Scene& scene) {
  Simulation simulation(scene, {1});
  std::int64_t steps = 0;
  for (; !simulation.at_end(); ++steps) simulation.step();
  return steps;
}

class RestartSweep : public test::FolderTest {
 protected:
  Scene changing(const std::vector<std::pair<std::string, std::string>>& changes = {}) const {
    std::string text = test::changing_scene;
    for (const auto& [what, instead] : changes) text = test::replaced(text, what, instead);
    return read(text);
  }
  Scene read(const std::string& text) const {
    const std::string path = (folder_ / "scene.toml").string();
    std::ofstream(path) << text;
    return read_scene(path);
  }
};

/// Names of tables and keys that say when something acts, or how it varies.
std::set<std::string> keys_of_times() {
  std::set<std::string> keys;
  for (const TableKeys& table : scene_keys()) {
    if (table.kind == "constraint") continue;  // of both kinds, which have tables of their own
    for (const auto& key : table.keys) {
      if (key == "start" || key == "end" || key == "times")
        keys.insert(std::string(table.kind) + "." + std::string(key));
    }
  }
  keys.erase("time.end");
  return keys;
}

/// The same of a scene as text.
std::set<std::string> keys_of_times(const std::string& text) {
  std::set<std::string> keys;
  std::istringstream lines(text);
  std::string table;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("[")) {
      table = line.substr(line.find_first_not_of('['), line.find(']') - line.find_first_not_of('['));
      std::ranges::replace(table, '.', '_');
    }
    if (line == "type = \"fixed\"") table = "fixed";
    for (const char* key : {"start", "end", "times"}) {
      if (line.starts_with(std::string(key) + " =") && table != "time") keys.insert(table + "." + key);
    }
  }
  return keys;
}

/// Rigid bodies, which are not beside subcycling and rigid walls.
const std::string rigid_scene = R"(units = "kg-m-s"
title = "A rigid body that is moved for a while"
[time]
end = 6e-4
[[material]]
name = "steel"
model = "elastic"
density = 7850
young_modulus = 2.1e11
poisson_ratio = 0.3
[[body]]
name = "plate"
material = "steel"
mesh = { type = "block", size = [0.4, 0.4, 0.1], elements = [4, 4, 1] }
[[body]]
name = "punch"
material = "steel"
position = [0.1, 0.1, 0.1001]
mesh = { type = "block", size = [0.2, 0.2, 0.1], elements = [2, 2, 1] }
[contact]
method = "pinball"
[[rigid_body]]
name = "punch"
bodies = ["punch"]
[[rigid_motion]]
rigid_body = "punch"
direction = [0, 0, 1]
speed = -20
times = [0, 2e-4, 4e-4]
factors = [1, 2, 0.5]
start = 9e-5
end = 3e-4
)";

TEST_F(RestartSweep, TheSceneHasEveryKeyOfTimes) {
  std::set<std::string> all = keys_of_times(test::changing_scene);
  all.merge(keys_of_times(rigid_scene));
  EXPECT_EQ(all, keys_of_times());
}

TEST_F(RestartSweep, ARigidBodyThatIsMovedForAWhile) {
  const Scene scene = read(rigid_scene);
  expect_same_after_restarts(scene, some_steps(8, steps_of(scene), 5));
}

TEST_F(RestartSweep, AnyStepOfAllThatBeginsAndEnds) {
  const Scene scene = changing();
  expect_same_after_restarts(scene, some_steps(24, steps_of(scene), 1));
}

TEST_F(RestartSweep, TheSameInFloat) {
  Scene scene = changing();
  scene.precision = Precision::float32;
  expect_same_after_restarts(scene, some_steps(8, steps_of(scene), 2));
}

TEST_F(RestartSweep, TheSameInMixedPrecision) {
  Scene scene = changing();
  scene.precision = Precision::mixed;
  expect_same_after_restarts(scene, some_steps(8, steps_of(scene), 3));
}

TEST_F(RestartSweep, TheSameWithSubcycling) {
  Scene scene = changing({{"[[contact.tied]]\nname = \"glue\"\nfirst = \"rider\"\nsecond = \"upper\"\ntolerance = "
                           "0.005\nstart = 6e-5\nend = 4e-4\n",
                           ""},
                          {"size = [0.3, 0.3, 0.3], elements = [3, 3, 3]",
                           "size = [[0.1, 0.1, 0.1], 0.3, 0.3], elements = [[1, 8, 1], 3, 3]"},
                          {"end = 6e-4", "end = 6e-4\nsubcycling = true"}});
  expect_same_after_restarts(scene, some_steps(8, steps_of(scene), 4));
}

TEST_F(RestartSweep, TheSameBySpringsAndSlidelines) {
  for (const ContactMethod method : {ContactMethod::pinball, ContactMethod::slideline}) {
    Scene scene = changing();
    scene.contact.method = method;
    scene.contact.enforcement = Enforcement::penalty;
    scene.contact.gap = ContactGap::pinball;
    for (ContactPair& pair : scene.contact_pairs) pair.friction = pair.static_friction = 0;
    expect_same_after_restarts(scene, some_steps(6, steps_of(scene), 5));
  }
}

class RestartOf : public testing::TestWithParam<std::string> {};

/// As many steps as take a moment: of small ones all.
TEST_P(RestartOf, EverySceneAndDeck) {
  Scene scene = test::read_input(GetParam());
  const std::int64_t elements = Simulation(scene, {1}).elements();
  constexpr std::int64_t most_element_steps = 200'000;
  const std::int64_t most = std::max<std::int64_t>(8, most_element_steps / elements);
  if (scene.time.steps < 0 || scene.time.steps > most) scene.time.steps = most;
  expect_same_after_restarts(scene, some_steps(4, steps_of(scene), 6));
}

INSTANTIATE_TEST_SUITE_P(All, RestartOf, testing::ValuesIn(test::every_input()), test::name_of_input);

}  // namespace
}  // namespace pinball::restart_sweep_test

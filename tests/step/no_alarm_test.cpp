#include <gmock/gmock.h>

#include <filesystem>
#include <set>

#include <solver/base/error.hpp>
#include <solver/formats/deck_reader.hpp>
#include <solver/step/solver.hpp>

/// Scenes and decks that are sound raise no alarm at the start: those that come along, and public ones.
namespace pinball::no_alarm_test {
namespace {

using testing::IsEmpty;
namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder, const std::set<std::string>& endings) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (endings.contains(entry.path().extension().string())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void expect_no_alarm(const Scene& scene, const std::string& name) {
  const Solver<double> solver(scene);
  EXPECT_THAT(solver.look().unlikely, IsEmpty()) << name;
  EXPECT_EQ(solver.look().cause, "") << name;
  EXPECT_EQ(solver.many_steps(), "") << name;
}

TEST(NoAlarm, OfScenesThatComeAlong) {
  const auto scenes = files_in(PINBALL_SOURCE_DIR "/data/scenes", {".toml"});
  ASSERT_GE(scenes.size(), 20U);
  for (const fs::path& path : scenes) expect_no_alarm(read_scene(path.string()), path.stem().string());
}

/// As far as they can be run: what is refused has its own tests.
std::size_t check_decks(const fs::path& folder, const std::string& but = "") {
  std::size_t checked = 0;
  for (const fs::path& path : files_in(folder, {".k", ".key", ".dyn", ".inp"})) {
    if (path.filename() == but) continue;
    Scene scene;
    try {
      scene = read_scene(translate_any_deck(path.string(), {}).source(path.string()));
    } catch (const InputError&) {
      continue;
    }
    expect_no_alarm(scene, path.filename().string());
    ++checked;
  }
  return checked;
}

TEST(NoAlarm, OfDecksThatComeAlong) {
  EXPECT_GE(check_decks(PINBALL_SOURCE_DIR "/data/decks"), 15U);
  EXPECT_GE(check_decks(PINBALL_SOURCE_DIR "/data/decks/abaqus"), 8U);
}

/// Cards are turned off so, and others are left out of contact.
TEST(NoAlarm, OfCardsWithALateBirth) {
  const std::string path = PINBALL_SOURCE_DIR "/data/decks/abaqus/exclusions.inp";
  Scene scene = read_scene(translate_any_deck(path, {}).source(path));
  ASSERT_FALSE(scene.contact_pairs.empty());
  scene.contact_pairs.back().start = 2 * scene.time.end;
  expect_no_alarm(scene, "exclusions.inp with a late pair");
}

TEST(NoAlarm, OfPublicDecks) {
  const fs::path folder = PINBALL_SOURCE_DIR "/../shared/decks";
  if (!fs::is_directory(folder)) GTEST_SKIP() << "no public decks here";
  EXPECT_GE(check_decks(folder, "projectile.k"), 2U);
  // Without the frame that adds its contact, its rod goes through the plate.
  const std::string path = folder / "projectile.k";
  Scene scene = read_scene(translate_any_deck(path, {}).source(path));
  scene.of_deck = true;
  EXPECT_THAT(
      Solver<double>(scene).look().unlikely,
      testing::ElementsAre(testing::HasSubstr("bodies Projectile and Plate meet from the start on, and no card")));
}

/// What hangs at the ground is told from what flies by it: all of its motion counts.
TEST(NoAlarm, OfWhatHangsAtTheGround) {
  const std::string text = R"(time.end = 2
units = "g-mm-ms"
contact.method = "none"
material = [{ name = "steel", model = "elastic", density = 7.85e-3, young_modulus = 2e5, poisson_ratio = 0.3 }]
rigid_body = [{ bodies = ["bob"], velocity = [0, 1005, 0], angular_velocity = [0, 0, 1] }]
joint = [{ kind = "revolute", bodies = ["ground", "bob"], point = [0, 5, 5], axis = [0, 0, 1] }]
[[body]]
name = "bob"
material = "steel"
position = [1000, 0, 0]
mesh = { type = "block", size = [10, 10, 10], elements = [1, 1, 1] }
)";
  Solver<double> solver(read_scene(SceneSource{"bob.toml", text, {}}));
  while (!solver.at_end()) solver.step();
  solver.finish();
  EXPECT_LT(std::abs(solver.balance_error_in_motion()), 1e-3);
}

}  // namespace
}  // namespace pinball::no_alarm_test

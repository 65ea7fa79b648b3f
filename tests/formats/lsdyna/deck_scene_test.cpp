#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include <solver/model/model.hpp>
#include <solver/scene/given/toml_file.hpp>
#include <solver/scene/toml/listing.hpp>

#include "deck_case.hpp"
#include "own_deck.hpp"

namespace pinball::deck_scene_test {
namespace {

using test::cube, test::elastic, test::ends, test::error_of;
using testing::HasSubstr;

using DeckAsScene = test::DeckTest;

/// All values of a scene, a line each.
std::string lines_of(const Scene& scene) {
  std::string lines;
  for (const SceneEntry& entry : list_scene(scene)) lines += entry.table + '.' + entry.key + " = " + entry.value + '\n';
  return lines;
}

TEST(OwnDecksAsScenes, AsTextTheyAreTheSameScene) {
  for (const std::string& name : test::all_own_decks()) {
    const std::string path = test::own_deck(name);
    const TranslatedDeck deck = translate_deck(
        path,
        {.chosen_case = name == "cases.k" ? std::optional(1) : std::nullopt, .lenient = false, .name_in_scene = ""});
    const std::string text = write_toml(deck.given->table);
    EXPECT_EQ(lines_of(read_scene(SceneSource{path, text, {}, {}})), lines_of(read_scene(deck.source(path)))) << name;
  }
}

TEST_F(DeckAsScene, ItsKeysAreChangedAsThoseOfAFile) {
  const TranslatedDeck deck = translate(cube + elastic + ends);
  const auto changed = [&](const std::string& key_value) {
    return read_scene(deck.source(path_, {.set = {key_value}, .refine = 1, .precision = {}, .vary = {}}));
  };
  EXPECT_EQ(changed("material.mat_1.density=2").materials[0].density, 2.0);
  EXPECT_EQ(changed("material.mat_1.density=2.5").materials[0].density, 2.5);
  EXPECT_EQ(read_scene(deck.source(path_)).materials[0].density, 7.85e-9);
  EXPECT_EQ(error_of([&] { changed("material.mat_1.density=-1"); }),
            "--set material.mat_1.density=-1: expected a number > 0, got -1");
  EXPECT_THAT(error_of([&] { changed("material.mat_2.density=1"); }), HasSubstr("nearest is \"mat_1\""));
}

TEST_F(DeckAsScene, TheFirstModelReadsNoFile) {
  const Scene whole = scene(cube + elastic + ends);
  const std::string same = folder_.string() + "//deck.k";
  const Scene by_another_path = read_scene(translate_deck(same).source(same));
  std::filesystem::rename(path_, path_ + ".away");
  EXPECT_EQ(build_model<double>(by_another_path).element_count(), 1);
  const Model<double> model = build_model<double>(whole);
  EXPECT_EQ(model.element_count(), 1);
  EXPECT_THAT(error_of([&] { build_model<double>(whole); }), HasSubstr("no such file"));
  std::filesystem::rename(path_ + ".away", path_);
  EXPECT_EQ(build_model<double>(whole).element_count(), 1);
}

}  // namespace
}  // namespace pinball::deck_scene_test

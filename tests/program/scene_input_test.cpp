#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include <solver/program/scene_input.hpp>
#include <tests/formats/lsdyna/deck_case.hpp>
#include <tests/support/error_of.hpp>

namespace pinball::test::scene_input_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// What is said of a text in a file of that name.
std::string error_for(const std::string& name, const std::string& text) {
  const auto folder = std::filesystem::temp_directory_path() / ("pinball_scene_input_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  SceneOptions options;
  options.scene = (folder / name).string();
  options.quiet = true;
  std::ofstream(options.scene) << text;
  const std::string message = error_of([&] { scene_input(options); });
  std::filesystem::remove_all(folder);
  return message;
}

const std::string keywords = "$ comment\n*KEYWORD\n*NODE\n", abaqus = "*Part, name=a\n*Node\n",
                  scene = "time.end = 1\n";

TEST(SceneInput, WhatIsNotWhatItsNameSaysIsToldSo) {
  EXPECT_THAT(error_for("a.toml", keywords), HasSubstr("this is a deck of keywords: name it .k"));
  EXPECT_THAT(error_for("a.toml", abaqus), HasSubstr(".inp if it is one of Abaqus"));
  EXPECT_THAT(error_for("a.inp", keywords), HasSubstr("this is an LS-DYNA keyword file: name it .k"));
  EXPECT_THAT(error_for("a.inp", scene), HasSubstr("this is a scene: name it .toml"));
  EXPECT_THAT(error_for("a.k", abaqus), HasSubstr("this is Abaqus input: name it .inp"));
  EXPECT_THAT(error_for("a.k", "# a comment\n[time]\nend = 1\n"), HasSubstr("this is a scene: name it .toml"));
  EXPECT_THAT(error_for("a.k", "\ntitle = \"a\"\n"), HasSubstr("this is a scene: name it .toml"));
  EXPECT_THAT(error_for("a.k", "** comment\n*NODE\n"), HasSubstr("this is Abaqus input: name it .inp"));
  EXPECT_THAT(error_for("a.k", scene), HasSubstr("this is a scene: name it .toml"));
}

TEST(SceneInput, WhatNothingReadsIsToldWhatIsRead) {
  const std::string zipped = std::string("\x1f\x8b\x08\0\0=\n", 7);
  for (const auto& [name, text] : {std::pair<std::string, std::string>{"a.bdf", "$ NASTRAN\nSOL 700\n"},
                                   {"a.unv", "    -1\n  2411\n"},
                                   {"a.k.gz", zipped}}) {
    EXPECT_THAT(error_for(name, text), HasSubstr("expected a scene (.toml), an LS-DYNA keyword file (.k, .key, .dyn)"));
  }
  EXPECT_THAT(error_for("a.msh", "$MeshFormat\n4.1 0 8\n"), HasSubstr("mesh = {type = \"file\", file = \"a.msh\"}"));
  EXPECT_THAT(error_for("scene.txt", scene), Not(HasSubstr("expected a scene (.toml)"))) << "by another name";
}

TEST(SceneInput, RadiossInputByAnotherNameIsNamed) {
  const std::string starter = "#RADIOSS STARTER\n/BEGIN\n";
  EXPECT_THAT(error_for("a.toml", starter), HasSubstr("this is Radioss input: name it .rad"));
  EXPECT_THAT(error_for("a.k", starter), HasSubstr("this is Radioss input: name it .rad"));
  EXPECT_THAT(error_for("a.rad", keywords), HasSubstr("expected Radioss input"));
}

class DeckInput : public FolderTest {};

/// Also where nothing is wrong: warnings name what they are about in the same way.
TEST_F(DeckInput, PartsOfItsSceneAreNamedByCards) {
  SceneOptions options;
  options.scene = (folder_ / "deck.k").string();
  options.quiet = true;
  std::ofstream(options.scene) << "*KEYWORD\n" << cube << elastic << ends << set_of_top << "*BOUNDARY_SPC_SET\n3,0,1\n";
  const Scene read = scene_input(options).read();
  EXPECT_EQ(read.fixed_constraints.at(0).nodes.where, options.scene + ":26: *BOUNDARY_SPC_SET: constraint.0");
  EXPECT_TRUE(read.of_deck) << "no card says what touches";
  EXPECT_EQ(read.contact.method, ContactMethod::none);
  std::ofstream(options.scene, std::ios::app) << "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n\n\n";
  const Scene touching = scene_input(options).read();
  EXPECT_FALSE(touching.of_deck);
  EXPECT_EQ(touching.contact.method, ContactMethod::pinball);
}

/// For the command that repeats a run.
TEST_F(DeckInput, KnowsHowTheDeckWasNamed) {
  SceneOptions options;
  options.scene = (folder_ / "deck.k").string();
  options.quiet = true;
  std::ofstream(options.scene) << "*KEYWORD\n" << cube << elastic << ends;
  const auto given_by = [&options] { return scene_input(options).source.given; };
  EXPECT_EQ(given_by()->file, "deck.k");
  EXPECT_THAT(given_by()->options, testing::IsEmpty());
  options.lenient = true;
  EXPECT_THAT(given_by()->options, testing::ElementsAre("--lenient"));
  std::ofstream(options.scene) << "*KEYWORD\n" << cube << elastic << ends << "*CASE\n2\n";
  options.chosen_case = 2;
  EXPECT_THAT(given_by()->options, testing::ElementsAre("--case", "2", "--lenient"));
}

}  // namespace
}  // namespace pinball::test::scene_input_test

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <solver/base/error.hpp>
#include <solver/formats/abaqus/mesh/abaqus_mesh.hpp>
#include <solver/formats/abaqus/scan/abaqus_assembly.hpp>
#include <solver/formats/abaqus/scan/abaqus_deck.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/folder_case.hpp>

namespace pinball::test::abaqus_deck_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

AbaqusDeck parse(const std::string& text) { return parse_abaqus_deck(text, "a.inp"); }

std::string error_of(const std::string& text) {
  try {
    parse(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<std::string> data_of(const AbaqusBlock& block) {
  std::vector<std::string> lines;
  DataLines data(block);
  while (const auto card = data.next()) lines.emplace_back(card->text);
  return lines;
}

TEST(AbaqusDeck, KeywordsHaveNeitherCaseNorBlanks) {
  const AbaqusDeck deck =
      parse("** a comment\n*Solid  Section , elset=Set-1, Material = Steel\n*solidsection,ELSET=b\n");
  ASSERT_EQ(deck.blocks.size(), 2u);
  EXPECT_EQ(deck.blocks[0].name, "SOLIDSECTION");
  EXPECT_EQ(deck.blocks[0].star_name(), "*SOLID SECTION");
  EXPECT_EQ(deck.blocks[0].value("ELSET"), "Set-1");
  EXPECT_EQ(deck.blocks[0].value("MATERIAL"), "Steel");
  EXPECT_FALSE(deck.blocks[0].has("CONTROLS"));
  EXPECT_EQ(deck.blocks[1].name, "SOLIDSECTION");
  EXPECT_EQ(deck.blocks[1].place.line, 3);
}

TEST(AbaqusDeck, KeywordLinesGoOnAfterAComma) {
  const AbaqusDeck deck = parse("*ELEMENT, TYPE=C3D8R,\n** in between\n ELSET=all\n1, 2\n");
  EXPECT_EQ(deck.blocks.at(0).value("ELSET"), "all");
  EXPECT_THAT(data_of(deck.blocks[0]), ElementsAre("1, 2"));
}

/// As CalculiX has it, whose own decks have such lines.
TEST(AbaqusDeck, ACommaBehindWhichNoParameterFollowsEndsItsKeyword) {
  const AbaqusDeck deck = parse("*MATERIAL, NAME=M,\n** in between\n*DENSITY,\n1000.,\n*SURFACE, NAME=s,\n_a_S2, S2\n");
  ASSERT_EQ(deck.blocks.size(), 3u);
  EXPECT_EQ(deck.blocks[0].value("NAME"), "M");
  EXPECT_EQ(deck.blocks[0].parameters.size(), 1u);
  EXPECT_EQ(deck.blocks[1].parameters.size(), 0u);
  EXPECT_EQ(deck.blocks[1].place.line, 3);
  EXPECT_THAT(data_of(deck.blocks[1]), ElementsAre("1000.,"));
  EXPECT_THAT(data_of(deck.blocks[2]), ElementsAre("_a_S2, S2"));
  EXPECT_THAT(deck.notes, ElementsAre(HasSubstr("*MATERIAL (a.inp:1): its line ends in a comma"), HasSubstr("*DENSITY"),
                                      HasSubstr("*SURFACE (a.inp:5)")));
  EXPECT_THAT(parse("*NODE,\n\n -1., 0.\n").notes, ElementsAre(HasSubstr("*NODE")));
  EXPECT_THAT(error_of("*NODE,\n"), HasSubstr("a.inp:1: expected the rest of a keyword line that ends in a comma"));
}

TEST(AbaqusDeck, QuotedNamesKeepBlanksAndCommas) {
  const AbaqusDeck deck = parse("*NSET, NSET=\"My, Set\"\n1\n");
  EXPECT_EQ(label_text(*deck.blocks[0].value("NSET")), "My, Set");
  EXPECT_EQ(split_label("\"Part.1\".Set-2")->second, "Set-2");
  EXPECT_FALSE(split_label("Set-2"));
}

TEST(AbaqusDeck, LabelsHaveACaseInQuotesAlone) {
  EXPECT_EQ(label_key("Set-1"), "SET-1");
  EXPECT_EQ(label_key("set-1"), label_key("\"SET-1\""));
  EXPECT_EQ(label_key("\"Set-1\""), "Set-1");
  EXPECT_EQ(label_key(" \"Part 1\".Set "), "Part 1.SET");
}

TEST(AbaqusDeck, NamesThatMeanOtherThingsAreTold) {
  struct Named {
    std::string name;
  };
  std::vector<Named> items{{"Low"}, {"Steel"}, {"Low"}, {"Steel"}};
  tell_apart(items, {"LOW", "Steel", "LOW", "STEEL"}, &Named::name);
  EXPECT_EQ(items[0].name, "Low");
  EXPECT_EQ(items[1].name, "Steel");
  EXPECT_EQ(items[2].name, "Low") << "the same thing";
  EXPECT_EQ(items[3].name, "STEEL");
}

TEST(AbaqusDeck, DataLinesAreThoseThatAreNoCommentsAndNotEmpty) {
  const AbaqusDeck deck = parse("*NODE\r\n1, 0., 0.,\r\n** no\r\n\r\n   2, 1.\r\n*NSET,NSET=A\r\n1,\r\n");
  EXPECT_THAT(data_of(deck.blocks.at(0)), ElementsAre("1, 0., 0.,", "2, 1."));
  EXPECT_THAT(data_of(deck.blocks.at(1)), ElementsAre("1,"));
  DataLines lines(deck.blocks[0]);
  lines.next();
  EXPECT_EQ(lines.next()->place.line, 5);
}

TEST(AbaqusDeck, EntriesEndWithTheLine) {
  EXPECT_THAT(entries_of(" 1, 2 ,,3,"), ElementsAre("1", "2", "", "3"));
  EXPECT_THAT(entries_of(""), ElementsAre());
}

TEST(AbaqusDeck, KnowsWhereAKeywordStands) {
  const AbaqusDeck deck = parse(
      "*PART, NAME=p\n*NODE\n*END PART\n*ASSEMBLY, NAME=a\n*INSTANCE, NAME=i, PART=p\n*END INSTANCE\n*NSET, NSET=s\n"
      "*END ASSEMBLY\n*MATERIAL, NAME=m\n*STEP\n*BOUNDARY\n*END STEP\n*STEP\n*CLOAD\n*END STEP\n");
  const auto block = [&](const char* name) {
    for (const AbaqusBlock& one : deck.blocks) {
      if (one.name == name) return one;
    }
    return AbaqusBlock{};
  };
  EXPECT_EQ(block("NODE").part, "P");
  EXPECT_TRUE(block("NSET").assembly);
  EXPECT_FALSE(block("MATERIAL").assembly);
  EXPECT_EQ(block("MATERIAL").step, 0);
  EXPECT_EQ(block("BOUNDARY").step, 1);
  EXPECT_EQ(block("CLOAD").step, 2);
}

TEST(AbaqusDeck, WhatIsNotClosedIsToldWithItsPlace) {
  EXPECT_EQ(error_of("*HEADING\n*PART, NAME=p\n*NODE\n"),
            "a.inp:2: *PART: expected *END PART before the end of the deck");
  EXPECT_EQ(error_of("*PART, NAME=p\n*END PART\n*INSTANCE, NAME=i, PART=p\n*NSET, NSET=s\n"),
            "a.inp:3: *INSTANCE: expected *END INSTANCE before the end of the deck");
  EXPECT_THAT(error_of("*END PART\n"), HasSubstr("a.inp:1: *END PART: nothing is open that it closes"));
  EXPECT_THAT(error_of("*STEP\n*STEP\n"), HasSubstr("a.inp:2: *STEP: the step before it is not closed"));
  EXPECT_EQ(error_of("*STEP\n*END STEP\n*STEP\n*CLOAD\n"),
            "a.inp:3: *STEP: expected *END STEP before the end of the deck");
  EXPECT_EQ(error_of("*STEP\n*END STEP\n*END STEP\n"), "a.inp:3: *END STEP: nothing is open that it closes");
  EXPECT_EQ(error_of("*HEADING\n*ASSEMBLY, NAME=a\n*NSET, NSET=s\n"),
            "a.inp:2: *ASSEMBLY: expected *END ASSEMBLY before the end of the deck");
  EXPECT_EQ(error_of("*ASSEMBLY, NAME=a\n*ASSEMBLY, NAME=b\n"),
            "a.inp:2: *ASSEMBLY: the one before it is not closed by *END ASSEMBLY");
  EXPECT_EQ(error_of("*END ASSEMBLY\n"), "a.inp:1: *END ASSEMBLY: nothing is open that it closes");
  const std::string part = "*PART, NAME=p\n", instance = "*INSTANCE, NAME=i, PART=p\n";
  for (const std::string& first : {part, instance}) {
    for (const std::string& second : {part, instance}) {
      const std::string name = second == part ? "*PART" : "*INSTANCE";
      EXPECT_EQ(error_of(first + second + "*END PART\n*END INSTANCE\n"),
                "a.inp:2: " + name + ": a *PART or an *INSTANCE before it is not closed");
    }
  }
}

TEST(AbaqusDeck, InstancesThatAreWrittenAlikeButForQuotesHaveNamesOfTheirOwn) {
  const AbaqusDeck deck = parse(
      "*PART, NAME=p\n*END PART\n*ASSEMBLY, NAME=a\n*INSTANCE, NAME=low, PART=p\n*END INSTANCE\n*INSTANCE, "
      "NAME=\"low\", PART=p\n"
      "*END INSTANCE\n*INSTANCE, NAME=Top, PART=p\n*END INSTANCE\n*END ASSEMBLY\n");
  std::vector<std::string> names;
  for (const AbaqusComponent& component : abaqus_components(deck)) names.push_back(component.name);
  EXPECT_THAT(names, ElementsAre("LOW", "low", "Top", "")) << "the last is what belongs to none";
}

TEST(AbaqusDeck, WhatIsNoAbaqusInputIsToldSo) {
  EXPECT_THAT(error_of("$ comment\n*KEYWORD\n"), HasSubstr("a.inp:1: expected Abaqus input, this is an LS-DYNA"));
  EXPECT_THAT(error_of("*KEYWORD\n*NODE\n"), HasSubstr("LS-DYNA file: name it .k"));
  EXPECT_THAT(error_of("*NODE\n*ELEMENT_SOLID\n"), HasSubstr("a.inp:2: *ELEMENT_SOLID: expected Abaqus input"));
  EXPECT_THAT(error_of("time.end = 1\n"), HasSubstr("a.inp:1: expected a keyword such as *HEADING"));
  EXPECT_THAT(error_of(""), HasSubstr("there is no keyword in it"));
}

class IncludingAbaqusDeck : public FolderTest {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
};

TEST_F(IncludingAbaqusDeck, FilesThatIncludeEachOtherTwiceAreStopped) {
  for (int i = 0; i < 40; ++i)
    write(fmt::format("{}.inp", i), fmt::format("*INCLUDE, INPUT={0}.inp\n*INCLUDE, INPUT={0}.inp\n", i + 1));
  write("40.inp", "*NODE\n");
  EXPECT_THAT(test::error_of([&] { read_abaqus_deck(path("0.inp")); }), HasSubstr("includes more than 10000 files"));
}

TEST_F(IncludingAbaqusDeck, FoldersPipesAndDevicesAreNoFiles) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  for (const char* name : {"pipe", "/dev/zero", "/dev/null"}) {
    write("main.inp", fmt::format("*HEADING\n*NODE, INPUT={}\n", name));
    EXPECT_THAT(test::error_of([&] { read_abaqus_deck(path("main.inp")); }),
                AllOf(HasSubstr("main.inp:2: INPUT="), HasSubstr("expected a file, got a pipe or a device")))
        << name;
  }
  write("main.inp", "*HEADING\n*INCLUDE, INPUT=.\n");
  EXPECT_THAT(test::error_of([&] { read_abaqus_deck(path("main.inp")); }), HasSubstr("expected a file, got a folder"));
}

/// Also where data lines of a keyword go on in another file.
TEST_F(IncludingAbaqusDeck, ElementsAreOfTheFilesThatHaveThem) {
  write("main.inp",
        "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n*ELEMENT, TYPE=C3D8\n"
        "1, 1,2,3,4,5,6,7,8\n*INCLUDE, INPUT=more.inp\n3, 1,2,3,4,5,6,7,8\n");
  write("more.inp", "** a comment\n2, 1,2,3,4,5,6,7,8\n");
  const MeshFile file = abaqus_mesh(read_abaqus_deck(path("main.inp"))).file;
  ASSERT_EQ(file.element_ids.size(), 3U);
  EXPECT_EQ(place_of_element(file, 0), path("main.inp") + ":11");
  EXPECT_EQ(place_of_element(file, 1), path("more.inp") + ":2");
  EXPECT_EQ(place_of_element(file, 2), path("main.inp") + ":13");
}

TEST(AbaqusDeck, IncludesKeywordsAndDataLines) {
  const auto folder = std::filesystem::temp_directory_path() / ("pinball_abaqus_include_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder / "sub");
  std::ofstream(folder / "main.inp")
      << "*NODE\n1,0.\n*INCLUDE, INPUT=sub/more.inp\n4,0.\n*ELEMENT, TYPE=C3D8, INPUT=e.txt\n";
  std::ofstream(folder / "sub" / "more.inp") << "2,0.\n*NSET, NSET=A\n1\n";
  std::ofstream(folder / "e.txt") << "1, 2\n";
  const std::string path = (folder / "main.inp").string();
  const AbaqusDeck deck = read_abaqus_deck(path);
  EXPECT_EQ(deck.files.size(), 3u);
  ASSERT_EQ(deck.blocks.size(), 3u);
  EXPECT_THAT(data_of(deck.blocks[0]), ElementsAre("1,0.", "2,0."));
  EXPECT_THAT(data_of(deck.blocks[1]), ElementsAre("1", "4,0.")) << "they go on with the keyword of the file";
  EXPECT_THAT(data_of(deck.blocks[2]), ElementsAre("1, 2"));
  std::ofstream(folder / "main.inp") << "*HEADING\n*INCLUDE, INPUT=none.inp\n";
  EXPECT_THROW(read_abaqus_deck(path), InputError);
  std::ofstream(folder / "main.inp") << "*HEADING\n*INCLUDE, INPUT=main.inp\n";
  EXPECT_THROW(read_abaqus_deck(path), InputError);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace pinball::test::abaqus_deck_test

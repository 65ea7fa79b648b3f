#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include <solver/formats/lsdyna/cards/keyword_rules.hpp>
#include <solver/formats/lsdyna/cards/keyword_scene.hpp>
#include <solver/formats/lsdyna/scan/fields.hpp>
#include <solver/formats/mesh_reader.hpp>
#include <solver/scene/given/toml_file.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/folder_case.hpp>

#include "card_decks.hpp"
#include "deck_outcome.hpp"

/// Each field of each card that is read is set to something else than its default, in a small deck of its own
/// (card_decks.hpp): that has to change the scene or the mesh, to be told by the name of the field, or to be an error.
/// What the table of cards calls told or refused has to be so, by its name. So no field is lost without a word.
namespace pinball::test::every_field_test {
namespace {

namespace fs = std::filesystem;

/// All that becomes of a deck.
struct Outcome {
  std::string made;            ///< scene and mesh
  std::set<std::string> told;  ///< sentences
  std::string error;

  /// Whether a sentence that is in one of the two alone, or that says so of the keyword, has this word.
  bool names(const Outcome& before, const std::string& keyword, const std::string& field) const {
    const std::regex word("(^|[^A-Z0-9_])" + field + "($|[^A-Z0-9_])");
    const auto has = [&](const std::string& line) { return std::regex_search(line, word); };
    for (const std::string& line : told) {
      if ((!before.told.contains(line) || line.starts_with("not used: *" + keyword)) && has(line)) return true;
    }
    for (const std::string& line : before.told) {
      if (!told.contains(line) && has(line)) return true;
    }
    return has(error);
  }
};

class EveryField : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    std::ofstream(folder_ / "more.k") << "*KEYWORD\n*NODE\n"
                                      << cube_lines(1) << "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n*END\n";
    std::ofstream(folder_ / "part.k") << "*KEYWORD\n*NODE\n"
                                      << cube_lines(1)
                                      << "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n*PART\nincluded\n1,1,1\n"
                                         "*SECTION_SOLID\n1,2\n*MAT_ELASTIC\n1,7.85E-9,210000.,0.3\n"
                                         "*SET_NODE_LIST\n1\n5,6\n*DEFINE_VECTOR\n1,0.,0.,0.,1.,2.,3.\n"
                                         "*DEFINE_CURVE\n1\n0.,1.\n1.,3.\n*END\n";
  }

  static std::string mesh_text(const fs::path& path) {
    FileMesh settings;
    settings.file = path.string();
    settings.format = MeshFormat::keyword;
    const MeshFile file = read_mesh_file(settings, {});
    return text_of(file);
  }

  /// width: what says how wide columns are, behind the name.
  Outcome outcome(const CardDeck& deck, const std::vector<std::string>& lines, const char* width = "") const {
    const std::string own = fmt::format("*{}{}\n{}\n", deck.keyword, width, fmt::join(lines, "\n"));
    std::string text = "*KEYWORD\n" + deck.others + own;
    for (const auto& [name, body] : common_keywords()) {
      const bool is_other = name != deck.keyword && ("\n" + deck.others).find("\n*" + name + "\n") == std::string::npos;
      if (is_other) text += "*" + name + "\n" + body;
    }
    const fs::path path = folder_ / "deck.k";
    fs::remove(path);  // a file that is written over is put on the disk at once
    std::ofstream(path) << text << "*END\n";
    Outcome result;
    try {
      const TranslatedDeck made = translate_deck(path.string());
      result.made = write_toml(made.given->table) + mesh_text(path);
      for (const auto* sentences : {&made.understood, &made.ignored})
        result.told.insert(sentences->begin(), sentences->end());
    } catch (const InputError& error) {
      result.error = error.what();
    }
    return result;
  }

  /// Other values than that of the deck and the default. Of a list of members none that it has.
  static std::vector<std::string> others(const std::vector<std::string>& fields, std::size_t at,
                                         const CardField& field) {
    std::vector<std::string> values;
    std::vector<const char*> some{"1", "2", "3", "7"};
    if (field.type == FieldType::number) some = {"0.37", "2.0"};
    if (field.type == FieldType::text) some = {"X"};
    const bool is_member = field.name.starts_with("ID") || field.name.starts_with("E") || field.name.starts_with("B");
    for (const char* value : some) {
      const std::optional<double> number = deck_number(value), given = deck_number(fields[at]);
      const bool is_same = number && (given ? *given == *number : *number == field.otherwise);
      const bool is_there = is_member && std::ranges::find(fields, value) != fields.end();
      if (!is_same && !is_there) values.emplace_back(value);
    }
    return values;
  }

  /// A line of commas in the columns of its layout.
  static std::string in_columns(const std::string& line, const CardLayout& layout, bool wide, bool twenty) {
    std::string text;
    const std::vector<std::string> fields = cut(line, 0);
    for (std::size_t i = 0; i < fields.size(); ++i)
      text += fmt::format("{:>{}}", fields[i], i < layout.size() ? layout[i].columns_of(wide, twenty) : 10);
    return text;
  }

  void expect_same_in_columns(const CardDeck& deck, const KeywordCards& cards) {
    const Outcome expected = outcome(deck, deck.lines);
    for (const char* width : {"", "%", "+"}) {
      std::vector<std::string> lines = deck.lines;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        const CardLayout* layout = cards.lines[i < cards.lines.size() ? i : i % cards.lines.size()];
        const bool is_last = cards.keyword.starts_with("DEFINE_") && i >= cards.lines.size();
        if (is_last) layout = cards.lines.back();
        if (layout != nullptr) lines[i] = in_columns(lines[i], *layout, *width == '%', *width == '+');
      }
      const Outcome columns = outcome(deck, lines, width);
      EXPECT_EQ(columns.error, expected.error) << deck.keyword << width;
      EXPECT_EQ(columns.made, expected.made) << deck.keyword << width;
    }
  }

  void set_each(const CardDeck& deck, const KeywordCards& cards) {
    const Outcome before = outcome(deck, deck.lines);
    ASSERT_EQ(before.error, "") << deck.keyword << ' ' << deck.form;
    ASSERT_GE(deck.lines.size(), cards.lines.size()) << deck.keyword;
    for (std::size_t line = 0; line < cards.lines.size(); ++line) {
      if (cards.lines[line] == nullptr) continue;
      const CardLayout& layout = *cards.lines[line];
      const std::vector<std::string> fields = cut(deck.lines[line], layout.size());
      for (std::size_t i = 0; i < layout.size(); ++i) {
        if (layout[i].name == deck.same) continue;
        if (layout[i].name.empty()) {
          set_unknown(deck, before, line, fields, i);
          continue;
        }
        ++fields_;
        for (const std::string& value : others(fields, i, layout[i]))
          try_one(deck, before, line, fields, i, layout[i], value);
      }
      for (std::size_t i = layout.size(); i < 8; ++i) set_unknown(deck, before, line, fields, i);
    }
  }

  /// A field that the manual does not have: told by its number, but of nodes and solids, which are many.
  void set_unknown(const CardDeck& deck, const Outcome& before, std::size_t line, std::vector<std::string> fields,
                   std::size_t at) {
    if (deck.keyword == "NODE" || deck.keyword == "ELEMENT_SOLID") return;
    const std::string name = fmt::format("field {}", at + 1);
    fields.resize(std::max(fields.size(), at + 1));
    try_one(deck, before, line, fields, at, layout::number(name).reported(), "3");
  }

  void try_one(const CardDeck& deck, const Outcome& before, std::size_t line, std::vector<std::string> fields,
               std::size_t at, const CardField& field, const std::string& value) {
    fields[at] = value;
    std::vector<std::string> lines = deck.lines;
    lines[line] = fmt::format("{}", fmt::join(fields, ","));
    const Outcome after = outcome(deck, lines);
    const std::string name(field.name);
    const bool named = after.names(before, deck.keyword, name);
    ++tried_;
    const std::string where = fmt::format("*{} {}, line {}, {} = {}", deck.keyword, deck.form, line + 1, name, value);
    if (field.use == FieldUse::reported) {
      EXPECT_TRUE(named && after.error.empty()) << where << " is not told: " << after.error;
    } else if (field.use == FieldUse::rejected) {
      EXPECT_TRUE(named && !after.error.empty()) << where << " is not refused by name: " << after.error;
    } else {
      EXPECT_TRUE(named || !after.error.empty() || after.made != before.made) << where << " is silent";
    }
  }

  int fields_ = 0, tried_ = 0;
};

std::vector<CardDeck> all_decks() {
  std::vector<CardDeck> decks;
  for (const auto& some : {decks_of_mesh(), decks_of_definitions(), decks_of_boundaries(), decks_of_controls()})
    decks.insert(decks.end(), some.begin(), some.end());
  return decks;
}

TEST_F(EveryField, OfEachCardCountsOrIsToldByItsName) {
  const std::vector<CardDeck> decks = all_decks();
  for (const KeywordCards& cards : keyword_cards()) {
    const auto same = [&](const CardDeck& deck) { return deck.keyword == cards.keyword && deck.form == cards.form; };
    EXPECT_TRUE(std::ranges::any_of(decks, same)) << "no deck has *" << cards.keyword << ' ' << cards.form;
    for (const CardDeck& deck : decks) {
      if (same(deck)) set_each(deck, cards);
    }
  }
  EXPECT_GT(fields_, 3'800);
  EXPECT_GT(tried_, 11'200);
}

TEST_F(EveryField, IsTheSameInColumnsOfAllWidths) {
  for (const CardDeck& deck : all_decks()) {
    const auto cards = std::ranges::find_if(
        keyword_cards(), [&](const KeywordCards& one) { return one.keyword == deck.keyword && one.form == deck.form; });
    ASSERT_NE(cards, keyword_cards().end()) << deck.keyword << ' ' << deck.form;
    expect_same_in_columns(deck, *cards);
  }
}

TEST(KeywordCards, AreThoseOfEachKeywordThatIsDone) {
  for (const KeywordRule& rule : keyword_rules()) {
    const bool is_read = rule.treatment == Treatment::done || rule.treatment == Treatment::mesh;
    if (!is_read || rule.name == std::string("TITLE")) continue;
    const auto is_of = [&](const KeywordCards& cards) { return rule_of(cards.keyword) == &rule; };
    EXPECT_TRUE(std::ranges::any_of(keyword_cards(), is_of)) << rule.name;
  }
}

}  // namespace
}  // namespace pinball::test::every_field_test

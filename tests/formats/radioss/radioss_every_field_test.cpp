#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include <solver/formats/deck/number_text.hpp>
#include <solver/formats/mesh_reader.hpp>
#include <solver/formats/radioss/layouts/radioss_cards.hpp>
#include <solver/scene/given/toml_file.hpp>
#include <tests/formats/lsdyna/deck_outcome.hpp>

#include "radioss_card_decks.hpp"
#include "radioss_case.hpp"

/// Each field of each keyword that is read is set to something else than its default, in a small deck of its own
/// (radioss_card_decks.hpp): that has to change the scene or the mesh, to be told by the name of the field, or to be an
/// error. What the table calls told or refused has to be so, by its name. So no field is lost without a word.
namespace pinball::test::radioss_every_field_test {
namespace {

/// All that becomes of a deck.
struct Outcome {
  std::string made;            ///< scene and mesh
  std::set<std::string> told;  ///< sentences
  std::string error;

  /// Whether a sentence that is in one of the two alone has this word.
  bool names(const Outcome& before, const std::string& field) const {
    const std::regex word("(^|[^A-Za-z0-9_])" + field + "($|[^A-Za-z0-9_])");
    const auto has = [&](const std::string& line) { return std::regex_search(line, word); };
    for (const std::string& line : told) {
      if (!before.told.contains(line) && has(line)) return true;
    }
    for (const std::string& line : before.told) {
      if (!told.contains(line) && has(line)) return true;
    }
    return has(error);
  }
};

class RadiossEveryField : public RadiossTest {
 protected:
  std::string mesh_text() const {
    const MeshFile file = read_mesh_file({.format = MeshFormat::radioss, .file = path_, .part = {}}, {});
    return text_of(file);
  }

  /// Fields in the columns of their layout; of the engine with blanks between.
  static std::string line_of(const std::vector<std::string>& fields, const CardLayout& layout, bool engine) {
    std::string text;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const int width = i < layout.size() ? layout[i].width : 10;
      text += engine ? fields[i] + " " : fmt::format("{:>{}}", fields[i], width);
    }
    return text + "\n";
  }

  /// What a keyword defines: "/MAT/1" of "/MAT/ELAST/1" and of "/MAT/ELAST/1/4", "/PART/1".
  static std::string defined(const std::string& header) {
    static const std::regex material("/MAT/[A-Z0-9_]+/([0-9]+)(/[0-9]+)?");
    return std::regex_replace(header, material, "/MAT/$1");
  }
  static std::set<std::string> defined_by(const RadiossCardDeck& deck) {
    std::set<std::string> all{defined(deck.header)};
    std::stringstream lines(deck.others);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with('/')) all.insert(defined(line));
    }
    return all;
  }

  /// The deck with these lines, each of fields between commas, in its keyword.
  Outcome outcome(const RadiossCardDeck& deck, const RadiossCards& cards, const std::vector<std::string>& lines) {
    std::string block = deck.header + "\n" + (cards.titled ? "title\n" : "");
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const CardLayout& layout = *cards.lines[std::min(i, cards.lines.size() - 1)];
      block += line_of(cut(lines[i], 0), layout, deck.engine);
    }
    std::string text;
    for (const std::string& common : common_radioss_blocks()) {
      if (!defined_by(deck).contains(defined(common.substr(0, common.find('\n'))))) text += common;
    }
    engine_ = (deck.engine && deck.header.starts_with("/RUN") ? "" : radioss_run) + (deck.engine ? block : "");
    text += deck.others + (deck.engine ? "" : block);
    Outcome result;
    try {
      const TranslatedDeck made = RadiossTest::translate(text, {});
      result.made = write_toml(made.given->table) + mesh_text();
      for (const auto* sentences : {&made.understood, &made.ignored})
        result.told.insert(sentences->begin(), sentences->end());
    } catch (const InputError& error) {
      result.error = error.what();
    }
    return result;
  }

  /// Other values than that of the deck and the default.
  static std::vector<std::string> others(const std::vector<std::string>& fields, std::size_t at,
                                         const CardField& field) {
    std::vector<std::string> values;
    std::vector<const char*> some{"1", "2", "7"};
    if (field.type == FieldType::number) some = {"0.37", "2.0"};
    if (field.type == FieldType::text) some = {"W"};
    for (const char* value : some) {
      const std::optional<double> number = deck_number(value), given = deck_number(fields[at]);
      const bool is_same = number && (given ? *given == *number : *number == field.otherwise);
      const bool is_there = field.name.starts_with("item_ID") && std::ranges::count(fields, value) > 0;
      if (!is_same && !is_there) values.emplace_back(value);
    }
    return values;
  }

  void set_each(const RadiossCardDeck& deck, const RadiossCards& cards) {
    const Outcome before = outcome(deck, cards, deck.lines);
    ASSERT_EQ(before.error, "") << deck.header;
    ASSERT_GE(deck.lines.size(), cards.lines.size()) << deck.header;
    for (std::size_t line = 0; line < cards.lines.size(); ++line) {
      const CardLayout& layout = *cards.lines[line];
      const std::vector<std::string> fields = cut(deck.lines[line], deck.engine ? 0 : layout.size());
      for (std::size_t i = 0; i < std::min(layout.size(), deck.engine ? fields.size() : layout.size()); ++i) {
        const CardField& field = layout[i];
        const bool silent = std::ranges::count(deck.same, field.name) > 0;
        if (field.name.empty() || silent) continue;
        for (const std::string& value : others(fields, i, field)) {
          std::vector<std::string> changed = fields, lines = deck.lines;
          changed[i] = value;
          lines[line] = fmt::format("{}", fmt::join(changed, ","));
          const Outcome after = outcome(deck, cards, lines);
          ++tried_;
          const bool named = after.names(before, std::string(field.name));
          const std::string where = fmt::format("{}, line {}, {} = {}", deck.header, line + 1, field.name, value);
          if (field.use == FieldUse::reported) {
            EXPECT_TRUE(named && after.error.empty()) << where << " is not told: " << after.error;
          } else if (field.use == FieldUse::rejected) {
            EXPECT_TRUE(named && !after.error.empty()) << where << " is not refused by name: " << after.error;
          } else {
            EXPECT_TRUE(named || !after.error.empty() || after.made != before.made) << where << " is silent";
          }
        }
      }
    }
  }

  int tried_ = 0;
};

TEST_F(RadiossEveryField, OfEachKeywordCountsOrIsToldByItsName) {
  const std::vector<RadiossCardDeck> decks = radioss_card_decks();
  for (const RadiossCards& cards : radioss_cards()) {
    const auto is_of = [&](const RadiossCardDeck& deck) { return deck.keyword == cards.keyword; };
    EXPECT_TRUE(std::ranges::any_of(decks, is_of)) << "no deck has " << cards.keyword;
    for (const RadiossCardDeck& deck : decks) {
      if (is_of(deck)) set_each(deck, cards);
    }
  }
  EXPECT_GT(tried_, 1'000);
}

}  // namespace
}  // namespace pinball::test::radioss_every_field_test

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include <solver/formats/abaqus/cards/abaqus_scene.hpp>
#include <solver/formats/lsdyna/scan/fields.hpp>
#include <solver/formats/mesh_reader.hpp>
#include <solver/scene/given/toml_file.hpp>
#include <tests/formats/lsdyna/own_deck.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/folder_case.hpp>

/// Each blank field of each data line of the Abaqus input that comes along is filled in: that has to change the scene,
/// to be refused, or to be told. So no field is lost without a word.
namespace pinball::test::abaqus_every_field_test {
namespace {

namespace fs = std::filesystem;

class EveryFieldOfAbaqus : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    fs::copy(own_deck(""), folder_, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }

  static std::vector<std::string> lines_of(const fs::path& file) {
    std::ifstream stream(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }
  /// Nodes and sets of the mesh that the deck is.
  static std::string mesh_text(const fs::path& path) {
    FileMesh settings;
    settings.file = path.string();
    settings.format = MeshFormat::abaqus;
    const MeshFile file = read_mesh_file(settings, {});
    std::string text;
    for (const Point& x : file.mesh.nodes) text += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
    for (const auto* sets : {&file.node_sets, &file.element_sets}) {
      for (const MeshSet& set : *sets)
        text += fmt::format("{}: {} {}\n", set.id, fmt::join(set.members, " "), set.problem);
    }
    for (const FaceSet& set : file.face_sets) text += fmt::format("{}: {} {}\n", set.id, set.faces.size(), set.problem);
    return text;
  }
  /// All that is said of a deck with this line in the place of another one.
  template <class Translate>
  std::string said(const fs::path& file, std::vector<std::string> lines, std::size_t at, const std::string& line,
                   const Translate& translate) const {
    lines[at] = line;
    std::ofstream(file) << fmt::format("{}\n", fmt::join(lines, "\n"));
    try {
      const TranslatedDeck deck = translate(file.string());
      return fmt::format("{}\n{}\n{}\n{}", write_toml(deck.given->table), fmt::join(deck.understood, "\n"),
                         fmt::join(deck.ignored, "\n"), mesh_text(file));
    } catch (const InputError& error) {
      return error.what();
    }
  }

  /// Fills each blank field of each card in turn. cut: a line as its fields, none where it is no card of numbers.
  template <class Cut, class Translate>
  void fill_all(const fs::path& file, const Cut& cut, const Translate& translate) {
    const std::vector<std::string> lines = lines_of(file);
    const std::string before = said(file, lines, 0, lines[0], translate);
    std::string keyword;
    for (std::size_t at = 0; at < lines.size(); ++at) {
      if (lines[at].starts_with('*')) keyword = lines[at];
      const std::string told_whole = fmt::format("{}: a data line", upper_case(keyword.substr(0, keyword.find(','))));
      if (before.find(told_whole) != std::string::npos) continue;
      const std::vector<std::string> fields = cut(keyword, lines[at]);
      for (std::size_t i = 0; i < fields.size(); ++i) {
        if (!fields[i].empty() && deck_number(fields[i]) != 0.0) continue;
        bool is_told = false;
        for (const char* value : {"1", "3", "0.37"}) {
          std::vector<std::string> filled = fields;
          filled[i] = value;
          is_told = is_told || said(file, lines, at, fmt::format("{}", fmt::join(filled, ", ")), translate) != before;
        }
        EXPECT_TRUE(is_told) << file.filename() << ':' << at + 1 << ": " << keyword << ", field " << i + 1;
        ++filled_;
      }
    }
  }

  static std::vector<std::string> cut_at_commas(const std::string& line, std::size_t least) {
    std::vector<std::string> fields;
    std::stringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) fields.emplace_back(trimmed(field));
    if (fields.size() < least) fields.resize(least);
    return fields;
  }

  int filled_ = 0;
};

TEST_F(EveryFieldOfAbaqus, OfEachDataLineOfAbaqusInputCountsOrIsTold) {
  const auto cut = [](const std::string& keyword, const std::string& line) -> std::vector<std::string> {
    static const std::set<std::string> no_cards{"*NODE", "*ELEMENT", "*HEADING"};
    std::string name = upper_case(keyword.substr(0, keyword.find(',')));
    if (line.empty() || line[0] == '*' || no_cards.contains(name)) return {};
    return cut_at_commas(line, 8);
  };
  for (const auto& entry : fs::directory_iterator(folder_ / "abaqus")) {
    if (entry.path().extension() != ".inp") continue;
    fill_all(entry.path(), cut, [](const std::string& path) { return translate_abaqus(path); });
  }
  EXPECT_GT(filled_, 100);
}

}  // namespace
}  // namespace pinball::test::abaqus_every_field_test

#include "deck_reader.hpp"

#include <optional>
#include <string_view>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/formats/abaqus/cards/abaqus_scene.hpp>
#include <solver/formats/deck/number_text.hpp>
#include <solver/formats/lsdyna/cards/keyword_scene.hpp>
#include <solver/formats/radioss/cards/radioss_scene.hpp>
#include <solver/formats/radioss/scan/radioss_deck.hpp>
#include <solver/mesh/file/input_file.hpp>
#include <solver/mesh/file/text_lines.hpp>
#include <solver/mesh/mesh_format.hpp>

namespace pinball {

namespace {

/// A scene by another name: it begins with a table, a comment or a key. Radioss input begins with a comment, too.
void require_no_scene(std::string_view text, const std::string& path) {
  if (text.starts_with("#RADIOSS"))
    throw InputError(path + ": expected a deck of keywords with stars, this is Radioss input: name it .rad");
  std::string_view line;
  while (next_line(text, line) && line.find_first_not_of(" \t\r") == std::string_view::npos) {
  }
  const bool is_key = line.find(" = ") != std::string_view::npos && !line.starts_with('*') && !line.starts_with('$');
  if (line.starts_with('[') || line.starts_with('#') || is_key)
    throw InputError(path + ": expected a deck of keywords, this is a scene: name it .toml");
}

/// Abaqus input by another name: comments of two stars, or parameters behind a keyword.
void require_no_abaqus_input(std::string_view text, const std::string& path) {
  std::string_view line;
  for (int lines = 0; lines < 100 && next_line(text, line);) {
    if (line.empty() || line.front() == '$' || line.front() == '\r') continue;
    if (line.starts_with("**") || (line.front() == '*' && !line.starts_with("*KEYWORD") &&
                                   line.find(',') < line.find('=') && line.find('=') < line.size()))
      throw InputError(path + ": expected an LS-DYNA keyword file, this is Abaqus input: name it .inp");
    ++lines;
  }
}

}  // namespace

bool is_any_deck(const std::string& path) {
  const std::optional<MeshFormat> format = format_by_ending(path);
  return format && is_of_decks(*format);
}

bool is_mesh_alone(const std::string& path) {
  const std::string text = bytes_of_file(path);
  std::string_view rest = text, line;
  if (format_by_ending(path) == MeshFormat::radioss)
    return radioss_engine_of(path).empty() && text.find("\n/RUN/") == std::string::npos;
  while (next_line(rest, line)) {
    if (!line.starts_with('*')) continue;
    const std::string keyword = upper_case(line.substr(0, 40));
    for (const std::string_view more : {"*CONTROL_TERMINATION", "*INCLUDE", "*STEP"}) {
      if (keyword.starts_with(more)) return false;
    }
  }
  return true;
}

TranslatedDeck translate_any_deck(const std::string& path, const DeckOptions& options) {
  std::string text = bytes_of_file(path);
  if (format_by_ending(path) == MeshFormat::radioss) return translate_radioss_text(std::move(text), path, options);
  require_no_scene(text, path);
  if (format_by_ending(path) == MeshFormat::abaqus) return translate_abaqus_text(std::move(text), path, options);
  require_no_abaqus_input(text, path);
  return translate_deck_text(std::move(text), path, options);
}

}  // namespace pinball

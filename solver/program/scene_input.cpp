#include "scene_input.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include <solver/base/error.hpp>
#include <solver/formats/deck_reader.hpp>
#include <solver/mesh/file/text_lines.hpp>
#include <solver/mesh/mesh_format.hpp>

namespace pinball {

namespace {

/// A scene whose text begins as a deck does, and the other way round.
void require_scene(std::string_view text, const std::string& path) {
  if (text.starts_with("#RADIOSS")) throw InputError(path + ": expected a scene, this is Radioss input: name it .rad");
  std::string_view line;
  while (next_line(text, line)) {
    if (line.empty() || line.front() == '$' || line.front() == '\r') continue;
    if (line.front() != '*') return;
    throw InputError(path +
                     ": expected a scene, this is a deck of keywords: name it .k, .key or .dyn if it is one of "
                     "LS-DYNA, .inp if it is one of Abaqus");
  }
}

/// Whether the first line that says something could be one of TOML: a table, or a key with a value.
bool may_be_toml(std::string_view text) {
  std::string_view line;
  while (next_line(text, line)) {
    if (line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    if (std::any_of(line.begin(), line.end(), [](char c) { return c >= 0 && c < '\t'; })) return false;  // no text
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos || line[begin] == '#') continue;
    return line[begin] == '[' || line.find('=') != std::string_view::npos;
  }
  return true;  // empty, which the reader says
}

/// A mesh by its ending is none.
void require_no_mesh(const std::string& path) {
  if (!format_by_ending(path)) return;
  throw InputError(
      fmt::format("{}: expected a scene or a deck, this is a mesh by its ending: a body of a scene names it, "
                  "mesh = {{type = \"file\", file = \"{}\"}}, and pinball info lists what it holds",
                  path, std::filesystem::path(path).filename().string()));
}

/// What other programs read.
void require_toml(std::string_view text, const std::string& path) {
  if (std::filesystem::path(path).extension() == ".toml" || may_be_toml(text)) return;
  throw InputError(
      path +
      ": expected a scene (.toml), an LS-DYNA keyword file (.k, .key, .dyn), Abaqus input (.inp) or Radioss input "
      "(.rad); meshes of "
      "a scene's bodies end in " +
      known_endings() + ". This file is none of these: another program may convert it, gmsh or meshio");
}

}  // namespace

void print_deck(const TranslatedDeck& deck, const std::string& path) {
  fmt::print("{}, as this program understands it:\n", path);
  for (const std::string& line : deck.understood) fmt::print("  {}\n", line);
  if (!deck.ignored.empty()) fmt::print("  ignored, since it cannot change the answer:\n");
  for (const std::string& line : deck.ignored) fmt::print("    {}\n", line);
}

std::string path_of_scene(const std::string& name) {
  if (!is_any_deck(name) || std::filesystem::exists(name)) return find_scene(name);
  try {
    return find_scene(name);
  } catch (const InputError&) {
    return name;  // no such file, which is what the reader says
  }
}

namespace {

DeckNotes notes_of(const TranslatedDeck& deck) {
  DeckNotes notes;
  notes.lines = deck.understood;
  for (const std::string& line : deck.ignored) notes.lines.push_back("ignored: " + line);
  return notes;
}

std::vector<std::string> options_of_deck(const SceneOptions& options) {
  std::vector<std::string> words;
  if (options.chosen_case) words.insert(words.end(), {"--case", fmt::format("{}", *options.chosen_case)});
  if (options.lenient) words.push_back("--lenient");
  return words;
}

}  // namespace

SceneInput scene_input(const SceneOptions& options) {
  const std::string path = path_of_scene(options.scene);
  if (!is_any_deck(path)) {
    if (options.chosen_case || options.lenient) {
      throw InputError(options.scene + ": --case and --lenient are for decks (.k, .key, .dyn, .inp, .rad)");
    }
    require_no_mesh(path);
    SceneSource source = read_scene_source(path, options.overrides);
    require_scene(source.text, path);
    require_toml(source.text, path);
    return {std::move(source), {}};
  }
  const TranslatedDeck deck = translate_any_deck(path, {options.chosen_case, options.lenient, ""});
  deck.given->file = std::filesystem::path(path).filename().string();
  deck.given->options = options_of_deck(options);
  if (!options.quiet) print_deck(deck, path);
  std::fflush(stdout);  // before the progress, in a log that both go to
  return {deck.source(path + " as a scene", options.overrides), notes_of(deck)};
}

}  // namespace pinball

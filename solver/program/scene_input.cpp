#include "scene_input.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <solver/base/error.hpp>
#include <solver/deck/abaqus/translated_abaqus.hpp>
#include <solver/deck/translated_deck.hpp>
#include <solver/keyword/input_file.hpp>
#include <solver/mesh/mesh_format.hpp>

namespace pinball {

namespace {

/// A scene whose text begins as a deck does, and the other way round.
void require_scene(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || line.front() == '$' || line.front() == '\r') continue;
    if (line.front() != '*') return;
    throw InputError(path +
                     ": expected a scene, this is a deck of keywords: name it .k, .key or .dyn if it is one of "
                     "LS-DYNA, .inp if it is one of Abaqus");
  }
}

/// Whether the first line that says something could be one of TOML: a table, or a key with a value. A scene that comes
/// through a pipe has no ending, and cannot be looked at before it is read.
bool may_be_toml(const std::string& path) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(path, problem)) return true;
  std::ifstream file(path, std::ios::binary);
  std::string line;
  while (std::getline(file, line)) {
    if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
    if (std::any_of(line.begin(), line.end(), [](char c) { return c >= 0 && c < '\t'; })) return false;  // no text
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos || line[begin] == '#') continue;
    return line[begin] == '[' || line.find('=') != std::string::npos;
  }
  return true;  // empty, which the reader says
}

/// Neither a scene by its ending nor by what it holds: meshes, and what other programs read.
void require_known_format(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".toml") return;
  if (format_by_ending(path)) {
    throw InputError(
        fmt::format("{}: expected a scene or a deck, this is a mesh by its ending: a body of a scene names it, "
                    "mesh = {{type = \"file\", file = \"{}\"}}",
                    path, std::filesystem::path(path).filename().string()));
  }
  if (!may_be_toml(path)) {
    throw InputError(
        path +
        ": expected a scene (.toml), an LS-DYNA keyword file (.k, .key, .dyn) or Abaqus input (.inp); meshes of "
        "a scene's bodies end in " +
        known_endings() + ". This file is none of these: another program may convert it, gmsh or meshio");
  }
}

/// A scene by another name: it begins with a table, a comment or a key.
void require_no_scene(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line) && line.find_first_not_of(" \t\r") == std::string::npos) {
  }
  const bool is_key = line.find(" = ") != std::string::npos && !line.starts_with('*') && !line.starts_with('$');
  if (line.starts_with('[') || line.starts_with('#') || is_key)
    throw InputError(path + ": expected a deck of keywords, this is a scene: name it .toml");
}

/// Abaqus input by another name: comments of two stars, or parameters behind a keyword.
void require_no_abaqus_input(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  for (int lines = 0; lines < 100 && std::getline(file, line);) {
    if (line.empty() || line.front() == '$' || line.front() == '\r') continue;
    if (line.starts_with("**") || (line.front() == '*' && !line.starts_with("*KEYWORD") &&
                                   line.find(',') < line.find('=') && line.find('=') < line.size()))
      throw InputError(path + ": expected an LS-DYNA keyword file, this is Abaqus input: name it .inp");
    ++lines;
  }
}

}  // namespace

bool is_any_deck(const std::string& path) { return is_deck(path) || is_abaqus_deck(path); }

TranslatedDeck translate_any_deck(const std::string& path, const DeckOptions& options) {
  require_file(path);
  require_no_scene(path);
  if (is_abaqus_deck(path)) return translate_abaqus(path, options);
  require_no_abaqus_input(path);
  return translate_deck(path, options);
}

void print_deck(const TranslatedDeck& deck, const std::string& path) {
  fmt::print("{}, as this program understands it:\n", path);
  for (const std::string& line : deck.understood) fmt::print("  {}\n", line);
  if (!deck.ignored.empty()) fmt::print("  ignored, since it cannot change the answer:\n");
  for (const std::string& line : deck.ignored) fmt::print("    {}\n", line);
}

namespace {

/// The file that the command line names, or the scene or deck of that name which comes with the program.
std::string path_of(const std::string& name) {
  if (!is_any_deck(name) || std::filesystem::exists(name)) return find_scene(name);
  try {
    return find_scene(name);
  } catch (const InputError&) {
    return name;  // no such file, which is what the reader says
  }
}

}  // namespace

Scene SceneInput::read() const {
  Scene scene = read_scene(source);
  scene.of_deck = deck && !deck->contact_said;
  if (deck) deck->name_parts(scene, source.path);
  return scene;
}

DeckNotes SceneInput::notes() const {
  DeckNotes notes;
  if (!deck) return notes;
  notes.lines = deck->understood;
  for (const std::string& line : deck->ignored) notes.lines.push_back("ignored: " + line);
  for (const TextOrigin& origin : deck->origins) notes.cards.push_back({origin.line, origin.place, origin.keyword});
  return notes;
}

SceneInput scene_input(const SceneOptions& options) {
  const std::string path = path_of(options.scene);
  if (!is_any_deck(path)) {
    if (options.chosen_case || options.lenient) {
      throw InputError(options.scene + ": --case and --lenient are for decks (.k, .key, .dyn, .inp)");
    }
    require_file(path);
    require_scene(path);
    require_known_format(path);
    return {read_scene_source(path, options.overrides), {}};
  }
  TranslatedDeck deck = translate_any_deck(path, {options.chosen_case, options.lenient, ""});
  if (!options.quiet) print_deck(deck, path);
  std::fflush(stdout);  // before the progress, in a log that both go to
  SceneSource source{path + " as a scene", deck.scene, options.overrides};
  return {std::move(source), std::move(deck)};
}

}  // namespace pinball

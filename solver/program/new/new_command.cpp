#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string_view>

#include <solver/base/error.hpp>
#include <solver/program/commands.hpp>
#include <solver/scene_rules.hpp>

#include "first_scene.hpp"

namespace pinball {

namespace {

std::string scene_text(const std::string& name) {
  constexpr std::string_view place = "NAME";
  std::string text = first_scene;
  for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + name.size())) {
    text.replace(at, place.size(), name);
  }
  return text;
}

/// "impact" of "impact" and of "impact.toml".
std::string name_of(const std::string& given) {
  const std::filesystem::path path(given);
  const std::string name = path.extension() == ".toml" ? path.stem().string() : given;
  if (path.has_parent_path() || name_problem(name)) {
    throw InputError(fmt::format("new: expected a name of letters, digits, \"_\" and \"-\", got \"{}\"", given));
  }
  return name;
}

}  // namespace

int new_command(const NewOptions& options) {
  const std::string name = name_of(options.name);
  const std::string path = (std::filesystem::path(options.out) / (name + ".toml")).string();
  std::error_code problem;
  if (!options.force && std::filesystem::exists(std::filesystem::symlink_status(path, problem))) {
    throw InputError(fmt::format("{}: is there already: expected another name, or --force", path));
  }
  std::ofstream file(path, std::ios::binary);
  file << scene_text(name);
  file.close();
  if (!file)
    throw InputError(fmt::format("{}: cannot be written: expected a folder that is there and may be written", path));
  fmt::print(
      "{0}: a first scene, with comments. Next:\n"
      "  pinball info {0}    what is in it, what will run, how long that takes\n"
      "  pinball run {0}     runs it; results go to out/{1}\n",
      path, name);
  return 0;
}

}  // namespace pinball

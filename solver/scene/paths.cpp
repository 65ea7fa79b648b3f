#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>
#include <solver/scene.hpp>

#include "data_folders.hpp"

namespace pinball {

namespace {

namespace fs = std::filesystem;

/// What was installed with a library, program or Python module in `folder`: data beside it, or share/pinball/data below
/// the prefix, some folders up from lib/x86_64-linux-gnu or lib/python3/dist-packages/pinball.
void add_installed(std::vector<std::string>& folders, fs::path folder) {
  folders.push_back(folder / "data");
  for (int up = 1; up <= 4 && folder.has_relative_path(); ++up) {
    folder = folder.parent_path();
    folders.push_back(folder / "share" / "pinball" / "data");
  }
}

/// Of what this function is part of: the program, or the library or Python module that a host has loaded.
fs::path own_folder() {
  Dl_info own{};
  if (dladdr(reinterpret_cast<const void*>(&own_folder), &own) == 0 || own.dli_fname == nullptr) return {};
  std::error_code problem;
  const fs::path file = fs::canonical(own.dli_fname, problem);
  return problem ? fs::path{} : file.parent_path();
}

/// Throws nothing: a folder that cannot be read holds no scenes.
std::set<std::string> scenes_in(const std::vector<std::string>& folders) {
  std::set<std::string> names;
  for (const fs::path folder : folders) {
    std::error_code problem;
    for (fs::directory_iterator entry(folder / "scenes", problem), end; !problem && entry != end;
         entry.increment(problem)) {
      if (entry->path().extension() == ".toml") names.insert(entry->path().stem().string());
    }
  }
  return names;
}

bool is_file(const fs::path& path) {
  std::error_code problem;
  return fs::exists(path, problem) && !fs::is_directory(path, problem);
}

}  // namespace

std::vector<std::string> data_folders() {
  std::vector<std::string> folders;
  if (const char* data = std::getenv("PINBALL_DATA"); data && *data) folders.push_back(data);
  if (const fs::path own = own_folder(); !own.empty()) add_installed(folders, own);
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  if (!none) folders.push_back((program.parent_path() / ".." / "share" / "pinball" / "data").lexically_normal());
  folders.push_back(PINBALL_SOURCE_DATA);
  return folders;
}

std::string find_scene(const std::string& name_or_path) {
  if (name_or_path.empty()) throw InputError("expected a scene, got an empty name");
  if (is_file(name_or_path)) return name_or_path;
  const auto folders = data_folders();
  for (const fs::path folder : folders) {
    const fs::path scenes = folder / "scenes", decks = folder / "decks";
    for (const auto& candidate : {scenes / name_or_path, scenes / (name_or_path + ".toml"), decks / name_or_path,
                                  decks / (name_or_path + ".k")}) {
      if (is_file(candidate)) return candidate.string();
    }
  }
  std::error_code none;
  if (fs::is_directory(name_or_path, none)) throw InputError(name_or_path + ": expected a file, this is a folder");
  const auto names = scenes_in(folders);
  if (names.empty()) {
    throw InputError(
        fmt::format("{}: no such scene, and none are found beside the program; "
                    "PINBALL_DATA may name the folder that holds \"scenes\"",
                    name_or_path));
  }
  const std::vector<std::string> known(names.begin(), names.end());
  std::string list;
  for (const auto& name : known) list += (list.empty() ? "" : ", ") + name;
  throw InputError(fmt::format("{}: no such scene, nearest is {}; known scenes: {}", name_or_path,
                               nearest(fs::path(name_or_path).stem().string(), known), list));
}

}  // namespace pinball

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <solver/base/error.hpp>

#include "commands.hpp"

namespace pinball {

namespace {

namespace fs = std::filesystem;

/// Where the viewer lies: installed with this program, or in the source tree.
fs::path find_viewer() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path installed = (program.parent_path() / ".." / "share" / "pinball" / "view").lexically_normal();
  for (const fs::path& folder : {installed, fs::path(PINBALL_SOURCE_VIEWER)}) {
    if (fs::exists(folder / "__main__.py", none)) return folder;
  }
  throw InputError(fmt::format("view: the files that draw are not installed; expected them in {}", installed.string()));
}

std::string python() {
  const char* wanted = std::getenv("PINBALL_PYTHON");
  return wanted && *wanted ? wanted : "/usr/bin/python3";  // where the packages of the system are found
}

}  // namespace

int view_command(const std::vector<std::string>& arguments) {
  // -B: nothing is written beside what is installed.
  std::vector<std::string> words{python(), "-B", find_viewer().string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::fflush(nullptr);
  execvp(pointers[0], pointers.data());  // returns only if it fails
  throw InputError(
      fmt::format("view: {} does not start ({}); pictures need the Debian packages python3, python3-vtk9, "
                  "python3-matplotlib and xvfb; PINBALL_PYTHON may name another Python",
                  words[0], std::strerror(errno)));
}

}  // namespace pinball

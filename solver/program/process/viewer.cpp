#include "viewer.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <solver/base/error.hpp>

extern char** environ;

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

std::string read_to_end(int descriptor) {
  std::string text;
  std::array<char, 4096> piece{};
  for (ssize_t n = 0; (n = ::read(descriptor, piece.data(), piece.size())) != 0;) {
    if (n > 0) text.append(piece.data(), n);
    if (n < 0 && errno != EINTR) break;
  }
  return text;
}

/// The last line of what a program said, without its own name.
std::string last_line(std::string text) {
  text.erase(text.find_last_not_of('\n') + 1);
  text.erase(0, text.rfind('\n') + 1);
  const std::string name = "pinball: error: ";
  return text.starts_with(name) ? text.substr(name.size()) : text;
}

}  // namespace

std::vector<std::string> viewer_command(const std::vector<std::string>& arguments) {
  // -B: nothing is written beside what is installed.
  std::vector<std::string> words{python(), "-B", find_viewer().string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

std::string draw_with_viewer(const std::vector<std::string>& arguments) {
  std::vector<std::string> words;
  try {
    words = viewer_command(arguments);
  } catch (const InputError& error) {
    return error.what();
  }
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return fmt::format("no pipe to the viewer: {}", std::strerror(errno));
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], 2);
  for (const int end : ends) ::posix_spawn_file_actions_addclose(&actions, end);
  pid_t process = 0;
  const int problem = ::posix_spawnp(&process, pointers[0], &actions, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  const std::string said = problem == 0 ? read_to_end(ends[0]) : "";
  ::close(ends[0]);
  if (problem != 0) return fmt::format("{} does not start ({})", words[0], std::strerror(problem));
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return said.empty() ? "the viewer ended without a word" : last_line(said);
}

}  // namespace pinball

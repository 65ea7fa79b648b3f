#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <solver/base/error.hpp>

#include "commands.hpp"
#include "process/viewer.hpp"

namespace pinball {

int view_command(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = viewer_command(arguments);
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

#pragma once

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

/// The program itself, from outside.
namespace pinball::test {

struct Finished {
  int status = -1;
  std::string text;  ///< stdout and stderr
};

/// pinball with these arguments of a shell; before: words that stand before it, such as `env NAME=VALUE`.
inline Finished run(const std::string& arguments, const std::string& before = {}) {
  Finished result;
  const std::string command = fmt::format("{} {} {} 2>&1", before, PINBALL_PROGRAM, arguments);
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 4096> piece{};
  for (std::size_t n = 0; (n = std::fread(piece.data(), 1, piece.size(), pipe)) > 0;)
    result.text.append(piece.data(), n);
  const int status = ::pclose(pipe);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

/// The status of bad input, and what is told of it.
inline void expect_bad_input(const std::string& arguments, const std::string& message) {
  const Finished f = run(arguments);
  EXPECT_EQ(f.status, 2) << arguments << '\n' << f.text;
  EXPECT_THAT(f.text, testing::HasSubstr(message)) << arguments;
}

inline std::string content(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace pinball::test

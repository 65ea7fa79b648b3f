#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <random>
#include <sstream>
#include <string>

#include <tests/support/error_of.hpp>

/// Files that are cut short or have other bytes in some places.
namespace pinball::test {

inline std::string bytes_of(const std::string& name) {
  std::ifstream file(PINBALL_SOURCE_DIR "/tests/data/" + name, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  EXPECT_FALSE(bytes.str().empty()) << name;
  return bytes.str();
}

using ReadBytes = std::function<void(const std::string&)>;

/// Reads the first n bytes of a file for each n, in steps; all that lack more than `spare` bytes must be an error.
inline void expect_errors_where_cut(const std::string& bytes, std::size_t step, std::size_t spare,
                                    const ReadBytes& read) {
  for (std::size_t length = 0; length + spare < bytes.size(); length += step)
    EXPECT_NE(error_of([&] { read(bytes.substr(0, length)); }), "no error") << length << " of " << bytes.size();
  EXPECT_EQ(error_of([&] { read(bytes); }), "no error");
}

/// Reads a file with some bytes changed, again and again: each is read, or an error. Returns how many are errors.
inline int errors_where_changed(const std::string& bytes, int trials, const ReadBytes& read) {
  std::mt19937 random(7);
  int errors = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::string damaged = bytes;
    for (unsigned k = random() % 3 + 1; k > 0; --k) {
      char& place = damaged[random() % damaged.size()];
      // Single bits, and bytes that make large and negative numbers.
      place = trial % 2 == 0 ? static_cast<char>(place ^ (1 << random() % 8))
                             : static_cast<char>(random() % 4 == 0 ? 0xff : random());
    }
    errors += error_of([&] { read(damaged); }) != "no error";
  }
  return errors;
}

}  // namespace pinball::test

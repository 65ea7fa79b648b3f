#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>
#include <string>

#include <solver/base/error.hpp>
#include <solver/program/others/other_history.hpp>
#include <tests/support/output_case.hpp>

/// Histories of other programs, written to a folder of their own and read.
namespace pinball::test {

class OtherHistories : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  OtherHistory read(const std::string& text) const { return read_other_history(write("history", text)); }
  std::string problem(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  static const OtherCurve& curve(const OtherHistory& history, const std::string& name) {
    for (const OtherCurve& c : history.curves) {
      if (c.name == name) return c;
    }
    throw std::runtime_error("no curve " + name);
  }

  test::TemporaryFolder folder_{testing::UnitTest::GetInstance()->current_test_info()->name()};
};

}  // namespace pinball::test

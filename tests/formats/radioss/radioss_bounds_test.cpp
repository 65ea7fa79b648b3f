#include <fmt/format.h>
#include <gmock/gmock.h>

#include "radioss_case.hpp"

/// Numbers below zero where none can be: told with the field and its line, and not taken for none.
namespace pinball::test::radioss_bounds_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class RadiossBounds : public RadiossTest {
 protected:
  /// The name of a field, and the end of the message.
  void expect_refused(const std::string& deck, const std::string& field, const std::string& expected) {
    EXPECT_THAT(error(deck), AllOf(HasSubstr("cube_0000.rad:"), HasSubstr(": " + field + ": expected " + expected)));
  }
  static std::string with(const std::string& material, const std::string& property) {
    return radioss_begin + material + property + radioss_cube;
  }
};

TEST_F(RadiossBounds, CoefficientsOfElementsAreNotBelowZero) {
  const auto property = [](std::initializer_list<double> viscosity) {
    return with(radioss_steel, "/PROP/SOLID/1\nsolids\n" + ten({"1"}) + twenty(viscosity) + "\n");
  };
  EXPECT_EQ(error(property({1, 0.1, 0.1})), no_error);
  expect_refused(property({-1}), "qa", "at least 0, got -1");
  expect_refused(property({1, -1}), "qb", "at least 0, got -1");
  expect_refused(property({1, 0.1, -1}), "h", "at least 0, got -1");
}

TEST_F(RadiossBounds, LimitsOfStressAndMeltingAreNotBelowZero) {
  const auto johnson = [](double limit, double hardening, double melting) {
    return with("/MAT/PLAS_JOHNS/1\nsteel\n" + twenty({7.85e-9, 0}) + twenty({210000, 0.3}) +
                    twenty({400, 100, 1, 0, limit}) + fmt::format("{:>100}\n", hardening) + twenty({1, melting}),
                radioss_property);
  };
  EXPECT_EQ(error(johnson(500, 0, 0)), no_error);
  expect_refused(johnson(-3, 0, 0), "SIG_max0", "at least 0, got -3");
  expect_refused(johnson(0, -3, 0), "Chard", "0 to 1, got -3");
  expect_refused(johnson(0, 2, 0), "Chard", "0 to 1, got 2");
  expect_refused(johnson(0, 0, -3), "T_melt", "at least 0, got -3");
}

TEST_F(RadiossBounds, WhatEndsBeforeTheRunIsRefused) {
  const std::string motion = "/GRNOD/NODE/5\ntop\n" + ten({"5", "6", "7", "8"}) + "/FUNCT/5\nf\n" + twenty({0, 1}) +
                             twenty({1, 1}) + "/IMPVEL/1\nv\n" + ten({"5", "Z", "0", "0", "5"});
  expect_refused(cube_with(motion + twenty({1, 1, 0, -3})), "Tstop", "at least 0, got -3");
}

/// Else the first of its lines would be taken for the title, and be lost.
TEST_F(RadiossBounds, NumbersInThePlaceOfATitleAreNotLost) {
  const std::string top = "/GRNOD/NODE/5\ntop\n" + ten({"5", "6", "7", "8"});
  const auto told = [&](const std::string& more, const std::string& block, const std::string& line) {
    EXPECT_THAT(error(cube_with(more)), HasSubstr(block + ": expected a line of its title, got numbers: \"" + line));
  };
  const std::string held = "   111 000         0         5\n";
  told(top + "/BCS/1\n" + held, "/BCS/1", "111 000 ");
  told("/GRNOD/NODE/5\n" + ten({"5", "6", "7", "8"}) + "/BCS/1\nb\n" + held, "/GRNOD/NODE/5", "5         6 ");
  told("/FUNCT/5\n" + twenty({0, 1}) + twenty({1, 2}) + top + "/CLOAD/1\nl\n" + ten({"5", "X", "0", "0", "5"}),
       "/FUNCT/5", "0 ");
  for (const char* title : {"2022 11", "  5", " 5 mm", ""}) {
    EXPECT_EQ(error(cube_with("/GRNOD/NODE/5\n" + std::string(title) + "\n" + ten({"5", "6", "7", "8"}) +
                              "/BCS/1\nb\n" + held)),
              no_error)
        << title;
  }
}

}  // namespace
}  // namespace pinball::test::radioss_bounds_test

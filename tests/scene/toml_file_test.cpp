#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <solver/scene/given/toml_file.hpp>
#include <solver/scene/schema/scene.hpp>

namespace pinball::toml_file_test {
namespace {

// The registry knows a key of each kind of table: of its own, of a group within it, and none that it leaves out.
static_assert(schema::has_key<Material>("density") && schema::has_key<Material>("young_modulus"));
static_assert(schema::has_key<PrescribedVelocity>("times") && schema::has_key<PrescribedVelocity>("set"));
static_assert(!schema::has_key<RigidWall>("plane") && schema::has_key<RigidWall>("without"));
static_assert(!schema::has_key<Material>("densty"));
static_assert(schema::has_group<RigidWall, TimeSpan>() && !schema::has_group<NodalLoad, TimeSpan>());

const std::string text = R"(# what it is
title = "a \\ \"quoted\" one"
units = ""

[time]  # *CONTROL_TERMINATION deck.k:3
end = 1e-06
steps = 12

[[material]]
name = "steel"
curve = { rate = 0.1, strain = [0.0, 1.0], deep = { a = true } }

[[material]]
name = "other"

[contact]
method = "none"

[[contact.pair]]
first = ["a", { faces = "3" }]
)";

GivenTable given() {
  GivenTable table = parse_toml(text, "a.toml");
  table.comment = "what it is";
  table.find("time")->as<GivenTable>()->comment = "*CONTROL_TERMINATION deck.k:3";
  return table;
}

TEST(TomlFile, WhatIsWrittenIsWhatWasRead) { EXPECT_EQ(write_toml(given()), text); }

TEST(TomlFile, NumbersKeepTheirBits) {
  GivenTable table;
  const std::vector<double> values{0.1,     1.0 / 3.0,
                                   1e300,   5e-324,
                                   -0.0,    2.0,
                                   1e22,    123456789012345680.0,
                                   6.25e-7, std::numeric_limits<double>::max()};
  GivenArray array;
  for (const double value : values) array.emplace_back(value);
  table.set("values", GivenValue(array));
  const GivenTable read = parse_toml(write_toml(table), "a.toml");
  const auto& found = *read.find("values")->as<GivenArray>();
  ASSERT_EQ(found.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASSERT_NE(found[i].as<double>(), nullptr) << values[i];
    EXPECT_EQ(std::signbit(*found[i].as<double>()), std::signbit(values[i]));
    EXPECT_EQ(*found[i].as<double>(), values[i]);
  }
}

TEST(TomlFile, PlacesAreThoseOfTheFileAlsoInACopy) {
  const GivenTable first = given(), copy = first;
  for (const GivenTable* table : {&first, &copy}) {
    EXPECT_EQ(table->find("time")->as<GivenTable>()->find("end")->place.text(""), "a.toml:6:7");
    EXPECT_EQ(table->find("material")->as<GivenArray>()->at(1).place.text(""), "a.toml:13:1");
  }
  EXPECT_EQ(GivenPlace().text("elsewhere"), "elsewhere");
  EXPECT_EQ(GivenPlace("--set a=1").text("elsewhere"), "--set a=1");
}

TEST(TomlFile, IntegersThatNoDoubleHasAreNoNumbers) {
  const std::int64_t largest = std::int64_t{1} << 53;
  EXPECT_EQ(GivenValue(largest).number(), 9007199254740992.0);
  EXPECT_FALSE(GivenValue(largest + 1).number());
  EXPECT_FALSE(GivenValue(std::string("1")).number());
}

}  // namespace
}  // namespace pinball::toml_file_test

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>

#include <solver/base/error.hpp>
#include <solver/program/others/beside_report.hpp>
#include <solver/program/others/curve_difference.hpp>
#include <solver/program/others/other_history.hpp>
#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>

namespace pinball::other_history_test {
namespace {

using Json = nlohmann::json;
using test::Finished;
using test::run;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A block as LS-DYNA's glstat has it.
std::string glstat_block(double time, double kinetic, double internal) {
  return fmt::format(
      " dt of cycle       1 is controlled by solid          1 of part         1\n\n"
      " time...........................   {:.5E}\n time step......................   1.00000E-07\n"
      " kinetic energy.................   {:.5E}\n internal energy................   {:.5E}\n"
      " stonewall energy...............   0.00000E+00\n total energy...................   {:.5E}\n"
      " global x velocity..............   2.00000E+00\n number of nodes................        27\n\n",
      time, kinetic, internal, kinetic + internal);
}

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

TEST_F(OtherHistories, GlstatIsReadBlockByBlock) {
  const OtherHistory h = read(" Taylor bar       ls-dyna\n\n" + glstat_block(0, 10, 0) + glstat_block(1e-5, 7, 3));
  EXPECT_EQ(h.kind, "glstat of LS-DYNA");
  EXPECT_THAT(h.times, ElementsAre(0, 1e-5));
  EXPECT_THAT(curve(h, "kinetic energy").values, ElementsAre(10, 7));
  EXPECT_THAT(curve(h, "internal energy").values, ElementsAre(0, 3));
  EXPECT_THAT(curve(h, "internal energy").meaning.columns, ElementsAre("internal", "bulk_viscosity", "folding"));
  EXPECT_THAT(curve(h, "total energy").meaning.columns, ElementsAre("total", "external"));
  EXPECT_TRUE(curve(h, "global x velocity").meaning.per_mass);
  EXPECT_THAT(curve(h, "stonewall energy").meaning.columns, ElementsAre());
}

TEST_F(OtherHistories, ARunThatWasTakenUpAgainCountsFromThere) {
  const OtherHistory h =
      read(glstat_block(0, 10, 0) + glstat_block(1, 9, 1) + glstat_block(2, 8, 2) + glstat_block(1, 9.5, 0.5));
  EXPECT_THAT(h.times, ElementsAre(0, 1));
  EXPECT_THAT(curve(h, "kinetic energy").values, ElementsAre(10, 9.5));
}

TEST_F(OtherHistories, ANumberThatDidNotFitIsNone) {
  const OtherHistory h = read("time,kinetic\n0,1\n1,********\n2,1.5D+00\n");
  EXPECT_TRUE(std::isnan(curve(h, "kinetic").values[1]));
  EXPECT_EQ(curve(h, "kinetic").values[2], 1.5);
}

TEST_F(OtherHistories, NodoutIsReadByItsNodesAlsoWhereNumbersTouch) {
  const auto block = [](const char* time, const char* rows) {
    return fmt::format(
        " n o d a l   p r i n t   o u t   f o r   t i m e  s t e p       1              ( at time {} )\n\n"
        " nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel      x-accl      y-accl"
        "      z-accl      x-coor      y-coor      z-coor\n{}\n"
        " n o d a l   p r i n t   o u t   f o r   t i m e  s t e p       1              ( at time {} )\n\n"
        " nodal point  x-rot      y-rot       z-rot       x-rot vel   y-rot vel   z-rot vel\n"
        "        17  9.0000E+00  9.0000E+00  9.0000E+00  9.0000E+00  9.0000E+00  9.0000E+00\n",
        time, rows, time);
  };
  const OtherHistory h = read(block("0.0000000E+00",
                                    "        17  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00 -5.0000E+00"
                                    "  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00") +
                              block("1.0000000E-03",
                                    "        17 1.00000E-03-2.00000E-03-5.00000E-03-1.00000E+00-2.00000E+00-5.00000E+00"
                                    " 0.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00 0.00000E+00"));
  EXPECT_EQ(h.kind, "nodout of LS-DYNA");
  EXPECT_THAT(h.times, ElementsAre(0, 1e-3));
  EXPECT_THAT(curve(h, "node_17_displacement_y").values, ElementsAre(0, -2e-3));
  EXPECT_THAT(curve(h, "node_17_velocity_z").values, ElementsAre(-5, -5));
  EXPECT_EQ(h.curves.size(), 6);
}

TEST_F(OtherHistories, TablesOfOpenRadiossAndAbaqusMeanTheSameEnergies) {
  const OtherHistory csv =
      read("\"time\",\"INTERNAL ENERGY\",\"KINETIC ENERGY\",\"X-MOMENTUM\",\"1 IE\",\n0,0,5,1,0,\n1,2,3,1,2,\n");
  EXPECT_EQ(csv.kind, "table");
  EXPECT_THAT(curve(csv, "KINETIC ENERGY").meaning.columns, ElementsAre("kinetic", "kinetic_below_zero"));
  EXPECT_THAT(curve(csv, "X-MOMENTUM").meaning.columns, ElementsAre("momentum_x"));
  EXPECT_THAT(curve(csv, "INTERNAL ENERGY").values, ElementsAre(0, 2));
  const OtherHistory report =
      read("\n      X              ALLKE           ALLIE\n\n  0.   5.   0.\n  1.E-3   3.E+00  2.\n");
  EXPECT_THAT(report.times, ElementsAre(0, 1e-3));
  EXPECT_THAT(curve(report, "ALLIE").meaning.columns, ElementsAre("internal", "hourglass", "folding"));
  EXPECT_THAT(curve(read("time [ms];rod_velocity_x\n0;1\n1;2\n"), "rod_velocity_x").meaning.columns,
              ElementsAre("rod_velocity_x"));
}

TEST_F(OtherHistories, WhatIsNoHistoryIsNamedWithItsLine) {
  EXPECT_THAT(problem("# nothing\n"), HasSubstr("history: expected a history, got an empty file"));
  EXPECT_THAT(problem("a,b\n1,2\n"), HasSubstr("history:1: expected the names of columns, one of them time"));
  EXPECT_THAT(problem("time,a\n0,1\n1,2,3\n4,5\n"), HasSubstr("history:3: expected 2 numbers"));
  EXPECT_THAT(problem("time,a\nx,1\n1,2\n"), HasSubstr("history:2: expected 2 numbers"));
  EXPECT_THAT(problem("time,a\n0,1\n"), HasSubstr("expected two times at least, got 1"));
  EXPECT_THAT(problem(" time.....  soon\n"), HasSubstr("history:1: expected a time, got soon"));
  EXPECT_THAT(problem(std::string("\0\0T01", 5)), HasSubstr("or a T01 file of Radioss, got another binary file"));
  EXPECT_THROW(read_other_history(folder_ / "none"), InputError);
}

TEST_F(OtherHistories, AFileThatIsStillWrittenEndsWithItsLastWholeLine) {
  EXPECT_THAT(read("time,a,b\n0,1,2\n1,2,3\n2,3").times, ElementsAre(0, 1));
}

/// A T01 file: records of big-endian words, which begin and end with their length in bytes.
class T01 {
 public:
  template <class... Words>
  T01& record(const Words&... words) {
    const std::string own = (word(words) + ...);
    bytes += word(static_cast<std::int32_t>(own.size())) + own + word(static_cast<std::int32_t>(own.size()));
    return *this;
  }

  std::string bytes;

 private:
  static std::string word(std::uint32_t value) {
    std::string text;
    for (unsigned shift = 32; shift > 0; shift -= 8) text += static_cast<char>(value >> (shift - 8) & 0xFFU);
    return text;
  }
  static std::string word(std::int32_t value) { return word(static_cast<std::uint32_t>(value)); }
  static std::string word(float value) { return word(std::bit_cast<std::uint32_t>(value)); }
  static std::string word(const std::string& text) { return text; }
};

/// Of two parts, a subset, and two nodes of a group, behind a group of something else.
T01 t01_head(std::int32_t code, std::size_t title) {
  const std::string name(title, ' '), line(80, ' ');
  T01 file;
  file.record(code, line).record(line);
  if (code > 3050) file.record(2).record(100).record(1.0F, 1.0F, 1.0F);
  file.record(2, 1, 1, 1, 2, 4).record(1, 2, 8, 3);                               // counts; global quantities
  file.record(1, name, 0, 1, 1, 0).record(2, name, 0, 1, 1, 2).record(1, 2);      // parts
  file.record(1, name).record(1, name).record(0, 0, 0, 2, 0, name).record(1, 2);  // material, property, subset
  file.record(4, 6, 0, 1, 1, name).record(30, name).record(65);                   // a spring
  return file.record(2, 0, 0, 2, 3, name).record(5, name).record(6, name).record(1, 6, 9);
}
void add_state(T01& file, float t) {
  file.record(t).record(3 * t, 2 * t, t, 5.0F).record(7.0F, 8.0F).record(9.0F);
  file.record(t, 2 * t, 3 * t, 10 * t, 20 * t, 30 * t);
}

TEST_F(OtherHistories, AT01HasEnergiesAndNodes) {
  for (const auto& [code, title] : {std::pair<std::int32_t, std::size_t>{3040, 40}, {3041, 80}, {4021, 100}}) {
    T01 file = t01_head(code, title);
    for (const float t : {0.0F, 0.5F, 1.0F}) add_state(file, t);
    const OtherHistory read_back = read(file.bytes);
    EXPECT_EQ(read_back.kind, "T01 of Radioss");
    EXPECT_THAT(read_back.times, ElementsAre(0, 0.5, 1)) << code;
    EXPECT_THAT(curve(read_back, "INTERNAL ENERGY").values, ElementsAre(0, 1.5, 3));
    EXPECT_THAT(curve(read_back, "KINETIC ENERGY").values, ElementsAre(0, 1.5, 3));  // with that of rotations
    EXPECT_THAT(curve(read_back, "X-MOMENTUM").values, ElementsAre(5, 5, 5));
    EXPECT_THAT(curve(read_back, "node_5_displacement_x").values, ElementsAre(0, 0.5, 1));
    EXPECT_THAT(curve(read_back, "node_6_velocity_z").values, ElementsAre(0, 10, 20));
    EXPECT_EQ(read_back.curves.size(), 7U);  // no accelerations
    const std::string whole = file.bytes;
    for (std::size_t cut = 1; cut < 40; ++cut)
      EXPECT_THAT(read(whole.substr(0, whole.size() - cut)).times, ElementsAre(0, 0.5)) << cut;
  }
}

TEST_F(OtherHistories, AT01ThatIsWrongIsNamedWithItsByte) {
  T01 file = t01_head(4021, 100);
  EXPECT_THAT(problem(file.bytes), HasSubstr("expected two times at least, got 0"));
  EXPECT_THAT(problem(file.bytes.substr(0, 300)), HasSubstr("byte 280: expected a part"));
  std::string many = file.bytes;
  many[file.bytes.find(std::string("\0\0\0\x18", 4)) + 4] = '\x7F';  // a count of parts
  EXPECT_THAT(problem(many), HasSubstr("expected a count"));
  add_state(file, 0.0F);
  file.record(1.0F).record(1.0F);
  EXPECT_THAT(problem(file.bytes), HasSubstr("expected a longer record of a state"));
}

/// A binout: lengths of eight bytes, commands and types of one; of either order of bytes.
class Binout {
 public:
  explicit Binout(bool big) : big_(big) {
    bytes = std::string("\x8\x8\x8\x1\x1", 5) + static_cast<char>(big ? 0 : 1) + std::string(2, '\0');
    record(7, std::string(8, '\0'));
  }
  Binout& folder(const std::string& path) { return record(2, path); }
  Binout& put(const std::string& name, const std::vector<float>& values) {
    std::string data;
    for (const float value : values) data += word(std::bit_cast<std::uint32_t>(value), 4);
    return record(3, std::string(1, '\x9') + static_cast<char>(name.size()) + name + data);
  }
  Binout& put(const std::string& name, double value) {
    return record(3, std::string(1, '\xA') + static_cast<char>(name.size()) + name +
                         word(std::bit_cast<std::uint64_t>(value), 8));
  }
  Binout& numbers(const std::string& name, const std::vector<std::uint32_t>& values) {
    std::string data;
    for (const std::uint32_t value : values) data += word(value, 4);
    return record(3, std::string(1, '\x3') + static_cast<char>(name.size()) + name + data);
  }

  std::string bytes;

 private:
  Binout& record(char command, const std::string& data) {
    bytes += word(9 + data.size(), 8) + command + data;
    return *this;
  }
  std::string word(std::uint64_t value, std::size_t size) const {
    std::string text;
    for (std::size_t i = 0; i < size; ++i) text += static_cast<char>(value >> 8 * (big_ ? size - 1 - i : i) & 0xFFU);
    return text;
  }

  bool big_;
};

TEST_F(OtherHistories, ABinoutHasGlstatAndNodout) {
  for (const bool big : {false, true}) {
    Binout file(big);
    file.folder("/").folder("/nodout/metadata").numbers("ids", {5, 6});
    for (int i = 1; i <= 3; ++i) {
      const float t = 0.5F * static_cast<float>(i);
      file.folder(fmt::format("/glstat/d{:06}", i)).put("time", t).put("kinetic_energy", {2 * t}).numbers("cycle", {7});
      file.put("energy_ratio", {1});
      if (i == 2) continue;  // written at other times
      file.folder(fmt::format("../../nodout/d{:06}", i)).put("time", {t}).put("x_displacement", {t, 10 * t});
      file.put("z_velocity", {3 * t, 4 * t}).put("rx_displacement", {1, 1});
    }
    file.folder("/");  // the end of the last state
    const OtherHistory all = read(file.bytes);
    EXPECT_EQ(all.kind, "binout of LS-DYNA");
    EXPECT_THAT(all.times, ElementsAre(0.5, 1, 1.5));
    EXPECT_THAT(curve(all, "kinetic_energy").values, ElementsAre(1, 2, 3));
    EXPECT_THAT(curve(all, "kinetic_energy").meaning.columns, ElementsAre("kinetic", "kinetic_below_zero"));
    EXPECT_TRUE(curve(all, "energy_ratio").meaning.columns.empty());
    EXPECT_THAT(curve(all, "node_6_displacement_x").values, ElementsAre(5, testing::IsNan(), 15));
    EXPECT_THAT(curve(all, "node_5_velocity_z").values, ElementsAre(1.5, testing::IsNan(), 4.5));
    EXPECT_EQ(read(file.bytes.substr(0, file.bytes.size() - 12)).times.size(), 3U);  // its last record is not whole
    EXPECT_THAT(problem(file.bytes + std::string(9, '\0')), HasSubstr("expected the length of a record, got 0"));
  }
}

/// Here 2 t at the times 0, 1, 2; there t, at other times.
Curves two_t() { return {{"time", "kinetic", "kinetic_below_zero"}, {{0, 0, 0}, {1, 2, 0}, {2, 4, 0}}, 3}; }

TEST(CurveDifferences, OfLinesAreThoseOfTheClosedForm) {
  const OtherHistory other{"", "", {0, 0.5, 1.5, 2}, {{"KE", {{"kinetic"}}, {0, 0.5, 1.5, 2}}}};
  const std::vector<CurveDifference> all = curve_differences(two_t(), other, 1);
  ASSERT_EQ(all.size(), 1);
  EXPECT_DOUBLE_EQ(all[0].here, 4);
  EXPECT_DOUBLE_EQ(all[0].there, 2);
  EXPECT_DOUBLE_EQ(*all[0].at_end, 1);
  EXPECT_DOUBLE_EQ(*all[0].largest, 1);
  EXPECT_DOUBLE_EQ(all[0].largest_time, 2);
  EXPECT_DOUBLE_EQ(*all[0].root_mean_square, std::sqrt(4.0 / 3) / 2);  // of t from 0 to 2, over the largest there
}

TEST(CurveDifferences, AreOfTimesThatBothHave) {
  const OtherHistory other{"", "", {-1, 1, 3}, {{"KE", {{"kinetic"}}, {100, 2, 100}}}};
  const std::vector<CurveDifference> all = curve_differences(two_t(), other, 1);
  ASSERT_EQ(all.size(), 1);
  EXPECT_DOUBLE_EQ(all[0].end_time, 1);
  EXPECT_DOUBLE_EQ(all[0].scale, 2);
  EXPECT_DOUBLE_EQ(*all[0].largest, 0);
  const OtherHistory later{"", "", {5, 6}, {{"KE", {{"kinetic"}}, {1, 1}}}};
  EXPECT_TRUE(curve_differences(two_t(), later, 1).empty());
}

TEST(CurveDifferences, OfWhatIsZeroThereAreNone) {
  const OtherHistory other{"", "", {0, 2}, {{"KE", {{"kinetic"}}, {0, 0}}}};
  const std::vector<CurveDifference> all = curve_differences(two_t(), other, 1);
  ASSERT_EQ(all.size(), 1);
  EXPECT_FALSE(all[0].at_end || all[0].largest || all[0].root_mean_square);
}

TEST(CurveDifferences, AVelocityIsAMomentumOverTheMass) {
  EXPECT_THAT(values_of({{"time", "momentum_x"}, {{0, 6}, {1, 12}}, 2}, {{"momentum_x"}, true}, 3), ElementsAre(2, 4));
  EXPECT_THAT(values_of({{"time", "momentum_x"}, {{0, 6}}, 1}, {{"momentum_y"}, true}, 3), ElementsAre());
}

/// What the page draws: of each file what this run has, too, with all its rows and all of the run.
TEST(CurvesBeside, HaveAllRowsOfBoth) {
  VariantRuns variant;
  variant.repeats.emplace_back();
  variant.curves = {{"time", "kinetic"}, {{0, 5}, {1, 6}, {2, 8}}, 3};
  const OtherHistory other{
      "a/b.csv", "table", {0, 0.5, 2}, {{"KE", {{"kinetic"}}, {5, 5.5, 8}}, {"rest", {{"nothing"}}, {1, 2, 3}}}};
  const Json all = Json::parse(beside_curves_json({variant, variant}, {other, other}));
  ASSERT_EQ(all.size(), 2);
  for (const Json& beside : all) {
    EXPECT_EQ(beside["file"], "b.csv");
    EXPECT_EQ(beside["there"]["columns"], (Json{"time", "KE"}));
    EXPECT_EQ(beside["there"]["data"], (Json{{0, 0.5, 2}, {5, 5.5, 8}}));
    ASSERT_EQ(beside["here"].size(), 2);
    for (const Json& here : beside["here"]) EXPECT_EQ(here["data"], (Json{{5, 6, 8}}));
  }
}

TEST_F(OtherHistories, ARunBesideItsOwnHistoryHasNoDifference) {
  const std::string scene = "two_blocks --quiet --threads 1 --set time.end=5e-5 ";
  ASSERT_EQ(run("run " + scene + "--out " + (folder_ / "out")).status, 0);
  const std::string json_file = folder_ / "table.json";
  const Finished f = run("compare " + scene + "--with " + (folder_ / "out/history.csv") + " --json " + json_file);
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(f.text, HasSubstr("root mean square"));
  EXPECT_THAT(f.text, Not(HasSubstr("first / this: above 1")));
  const Json beside = Json::parse(test::content(json_file))["beside"][0];
  EXPECT_EQ(beside["kind"], "table");
  EXPECT_GT(beside["quantities"].size(), 20);
  for (const Json& quantity : beside["quantities"]) {
    const Json& of_run = quantity["variants"][0];
    EXPECT_EQ(of_run["here"], of_run["there"]) << quantity;
    EXPECT_TRUE(of_run["largest_difference"].is_null() || of_run["largest_difference"] < 1e-12) << quantity;
  }
  EXPECT_TRUE(beside["not_compared"].empty());
}

TEST_F(OtherHistories, EachVariantIsComparedAndWhatIsNotIsTold) {
  const std::string file = write("glstat", glstat_block(0, 100, 0) + glstat_block(5e-5, 50, 50));
  const std::string json_file = folder_ / "table.json", page = folder_ / "page.html";
  const Finished f = run("compare two_blocks --quiet --threads 1 --set time.end=5e-5 --vary time.cfl=0.8,0.4 --with " +
                         file + " --json " + json_file + " --page " + page);
  EXPECT_EQ(f.status, 0) << f.text;
  EXPECT_THAT(f.text, HasSubstr("time.cfl=0.4"));
  EXPECT_THAT(f.text, HasSubstr("not compared: stonewall energy, number of nodes"));
  const Json quantities = Json::parse(test::content(json_file))["beside"][0]["quantities"];
  EXPECT_EQ(quantities[0]["name"], "time step");
  EXPECT_EQ(quantities[0]["variants"].size(), 2);
  EXPECT_THAT(test::content(page), HasSubstr("\"file\":\"glstat\""));
  test::expect_bad_input("compare two_blocks --with " + (folder_ / "none"), "cannot be read");
}

}  // namespace
}  // namespace pinball::other_history_test

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include <tests/support/program.hpp>

#include "other_history_case.hpp"

namespace pinball::test::d3plot_test {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

using D3plots = OtherHistories;
using Vectors = std::vector<std::array<double, 3>>;

/// A file of the family as LS-DYNA writes it: in words of four or eight bytes, of either order.
class D3plotFile {
 public:
  explicit D3plotFile(std::size_t size = 4, bool big = false) : size_(size), big_(big) {}

  D3plotFile& whole(std::int64_t value) { return bits(static_cast<std::uint64_t>(value)); }
  D3plotFile& number(double value) {
    return bits(size_ == 8 ? std::bit_cast<std::uint64_t>(value)
                           : std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  }
  D3plotFile& numbers(std::size_t count, double value) {
    for (std::size_t i = 0; i < count; ++i) number(value);
    return *this;
  }
  D3plotFile& vectors(const Vectors& all) {
    for (const auto& one : all) {
      for (const double x : one) number(x);
    }
    return *this;
  }
  D3plotFile& text(std::size_t bytes_of_it) {
    bytes.append(bytes_of_it, ' ');
    return *this;
  }
  D3plotFile& end() { return number(-999999); }
  D3plotFile& fill(std::size_t words) {
    bytes.append(words * size_, '\0');
    return *this;
  }

  std::string bytes;

 private:
  D3plotFile& bits(std::uint64_t value) {
    for (std::size_t i = 0; i < size_; ++i) bytes += static_cast<char>(value >> 8 * (big_ ? size_ - 1 - i : i) & 0xFFU);
    return *this;
  }

  std::size_t size_;
  bool big_;
};

/// What the head of a file says that is not zero, by the number of the word.
using HeadWords = std::map<int, std::int64_t>;

/// Two nodes, a solid of seven numbers, a shell of a rigid part, which has none; temperatures, added mass, velocities,
/// accelerations, deleted elements.
HeadWords usual_head() {
  return {{11, 1}, {15, 5}, {16, 2}, {17, 6}, {18, 8},  {19, 11}, {20, 1},      {21, 1},
          {22, 1}, {23, 1}, {27, 7}, {31, 1}, {33, 24}, {39, 31}, {36, -10003}, {50, 1}};
}
const Vectors first_places{{1, 2, 3}, {4, 5, 6}};

D3plotFile mesh_file(const HeadWords& head, std::size_t size = 4, bool big = false) {
  D3plotFile file(size, big);
  for (int word = 0; word < 64; ++word) file.whole(head.contains(word) ? head.at(word) : 0);
  if (head.at(15) == 5) file.whole(1).whole(2).whole(1).whole(20);
  file.vectors(first_places);
  for (int i = 0; i < 9; ++i) file.whole(1);  // the solid
  for (int i = 0; i < 5; ++i) file.whole(1);  // the shell
  file.whole(-16);                            // parts have numbers, too
  for (const int counted : {0, 0, 0, 0, 2, 1, 0, 1, 0, 0, 0, 0, 2, 0, 2}) file.whole(counted);
  file.whole(5).whole(900);                    // the nodes
  for (int i = 0; i < 13; ++i) file.whole(i);  // elements and parts
  file.whole(1).whole(2);                      // elements that were divided
  file.end().whole(90000).text(72).end().whole(90001).whole(2);
  for (int part = 1; part <= 2; ++part) file.whole(part).text(72);
  return file.end();
}

/// Nodes have come (t, 2 t, 3 t) and 10 times as far.
void add_state(D3plotFile& file, double t) {
  file.number(t).number(3 * t).number(4 * t).number(7 * t).number(1).number(2).number(3).numbers(2, 0);
  file.vectors({{1 + t, 2 + 2 * t, 3 + 3 * t}, {4 + 10 * t, 5 + 20 * t, 6 + 30 * t}});
  file.numbers(2, 293).numbers(2, 0.5);
  file.vectors({{1, 2, 3}, {10, 20, 30}}).numbers(6, -7);
  file.numbers(7, 100).numbers(2, 1);
}

TEST_F(D3plots, StatesOfAFamilyAreEnergiesAndNodes) {
  for (const std::size_t size : {4, 8}) {
    for (const bool big : {false, true}) {
      D3plotFile first = mesh_file(usual_head(), size, big), second(size, big), tenth(size, big);
      for (const double t : {0.0, 0.25}) add_state(first, t);
      first.fill(500);
      for (const double t : {0.5, 0.75}) add_state(second, t);
      second.end().fill(100);
      add_state(tenth, 0.625);  // taken up again
      add_state(tenth, 1);
      write("d3plot10", tenth.bytes + std::string(60, '\1'));  // a state that is not whole
      write("d3plot02", second.bytes);
      write("d3plot.log", "other");
      const OtherHistory all = read_other_history(write("d3plot", first.bytes));
      EXPECT_EQ(all.kind, "d3plot of LS-DYNA");
      EXPECT_THAT(all.times, ElementsAre(0, 0.25, 0.5, 0.625, 1)) << size << big;
      EXPECT_THAT(curve(all, "kinetic energy").values, ElementsAre(0, 0.75, 1.5, 1.875, 3));
      EXPECT_THAT(curve(all, "kinetic energy").meaning.columns, ElementsAre("kinetic", "kinetic_below_zero"));
      EXPECT_THAT(curve(all, "internal energy").values, ElementsAre(0, 1, 2, 2.5, 4));
      EXPECT_TRUE(curve(all, "kinetic and internal energy").meaning.columns.empty());
      EXPECT_THAT(curve(all, "global z velocity").values, Each(3));
      EXPECT_THAT(curve(all, "node_5_displacement_x").values, ElementsAre(0, 0.25, 0.5, 0.625, 1));
      EXPECT_THAT(curve(all, "node_900_displacement_z").values, ElementsAre(0, 7.5, 15, 18.75, 30));
      EXPECT_THAT(curve(all, "node_900_velocity_y").values, Each(20));
      EXPECT_EQ(all.curves.size(), 6U + 12U);
    }
  }
}

/// The nodes are numbered by their order where the file has no numbers; a thermal run has other numbers of the whole.
TEST_F(D3plots, NodesWithoutNumbersAreCounted) {
  HeadWords head{{11, 1}, {15, 4}, {16, 2}, {17, 6}, {18, 1}, {21, 1}};
  D3plotFile file;
  for (int word = 0; word < 64; ++word) file.whole(head.contains(word) ? head.at(word) : 0);
  file.vectors(first_places).end().number(0).number(9).vectors({{0, 0, 0}, {0, 0, 0}});
  file.number(1).number(9).vectors({{1, 2, 3}, {4, 5, 6}}).end();
  const OtherHistory all = read(file.bytes);
  EXPECT_THAT(all.times, ElementsAre(0, 1));
  EXPECT_EQ(all.curves.size(), 6U);
  EXPECT_THAT(curve(all, "node_2_velocity_y").values, ElementsAre(0, 5));
}

TEST_F(D3plots, WhatIsNotReadIsNamed) {
  const auto problem_with = [&](int word, std::int64_t value) {
    HeadWords head = usual_head();
    head[word] = value;
    D3plotFile file = mesh_file(head);
    add_state(file, 0);
    return problem(file.bytes);
  };
  EXPECT_THAT(problem_with(37, 3), HasSubstr("history: a d3plot with particles (SPH) is not read"));
  EXPECT_THAT(problem_with(54, 1), HasSubstr("airbag particles"));
  EXPECT_THAT(problem_with(23, -1), HasSubstr("solids of ten nodes"));
  EXPECT_THAT(problem_with(55, 1), HasSubstr("elements of higher order"));
  EXPECT_THAT(problem_with(11, 1001), HasSubstr("numbers of 64 bits"));
  EXPECT_THAT(problem_with(15, 8), HasSubstr("motions of rigid bodies"));
  EXPECT_THAT(problem_with(16, 20), HasSubstr("expected the numbers of 20 nodes"));
  EXPECT_THAT(problem_with(23, 100'000), HasSubstr("byte 92: expected a count, got 100000"));
  EXPECT_THAT(problem_with(23, 200), HasSubstr("got the end of the file"));
  EXPECT_THAT(problem(mesh_file(usual_head()).bytes), HasSubstr("expected one state at least, got 0"));
}

TEST_F(D3plots, DamagedFilesAreReadOrRejected) {
  std::mt19937 random(11);
  const auto any = [&](std::size_t below) { return std::uniform_int_distribution<std::size_t>(0, below - 1)(random); };
  int rejected = 0;
  for (int i = 0; i < 1'000; ++i) {
    D3plotFile file = mesh_file(usual_head(), i % 2 == 0 ? 4 : 8);
    for (const double t : {0.0, 0.5, 1.0}) add_state(file, t);
    for (std::size_t k = any(3) + 1; k > 0; --k) file.bytes[any(file.bytes.size())] = static_cast<char>(any(256));
    if (any(4) == 0) file.bytes.resize(any(file.bytes.size()));
    try {
      read(file.bytes);
    } catch (const InputError&) {
      ++rejected;
    }
  }
  EXPECT_GT(rejected, 150);
}

/// A cube that flies on: all of its nodes are where they should be.
TEST_F(D3plots, TheLastStateStandsBesideThatOfARun) {
  std::string deck = "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*NODE\n";
  Vectors places;
  for (int n = 0; n < 8; ++n) {
    places.push_back({double(n & 1), double(n >> 1 & 1), double(n >> 2)});
    deck += fmt::format("{},{},{},{}\n", n + 11, places.back()[0], places.back()[1], places.back()[2]);
  }
  deck +=
      "*ELEMENT_SOLID\n1,1,11,12,14,13,15,16,18,17\n*PART\ncube\n1,1,1\n*SECTION_SOLID\n1,1\n"
      "*MAT_ELASTIC\n1,1.0,100.0,0.3\n*INITIAL_VELOCITY_GENERATION\n1,2,0.0,0.5,-0.25,1.0\n*END\n";
  const std::string deck_file = write("cube.k", deck);
  D3plotFile file;
  HeadWords head{{11, 1}, {15, 4}, {16, 8}, {17, 6}, {18, 6}, {20, 1}, {21, 1}, {39, 18}};
  for (int word = 0; word < 64; ++word) file.whole(head.contains(word) ? head.at(word) : 0);
  file.vectors(places).whole(10);
  for (const int counted : {0, 0, 0, 0, 8, 0, 0, 0, 0}) file.whole(counted);
  for (int n = 11; n <= 18; ++n) file.whole(n);
  file.end();
  for (const double t : {0.0, 1.0}) {
    Vectors now = places;
    for (auto& x : now) x = {x[0] + 0.5 * t, x[1] - 0.25 * t, x[2] + t};
    now[7][2] += 0.01 * t;  // but this one
    file.number(t).numbers(6, 0).vectors(now).vectors(Vectors(8, {0.5, -0.25, 1.0}));
  }
  const std::string json_file = folder_ / "beside.json";
  const Finished f = run("compare " + deck_file + " --quiet --threads 1 --with " + write("d3plot", file.bytes) +
                         " --json " + json_file);
  ASSERT_EQ(f.status, 0) << f.text;
  const auto json = nlohmann::json::parse(std::ifstream(json_file));
  const auto& state = json["beside"][0]["last_state"][0];
  EXPECT_EQ(state["displacement"]["nodes"], 8);
  EXPECT_EQ(state["displacement"]["largest_node"], 18);
  EXPECT_THAT(state["displacement"]["largest_difference"].get<double>(), DoubleNear(0.01 / std::sqrt(1.3326), 1e-4));
  EXPECT_LT(state["velocity"]["largest_difference"].get<double>(), 1e-6);
}

}  // namespace
}  // namespace pinball::test::d3plot_test

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <solver/elements/subcycling.hpp>
#include <tests/support/saved_state.hpp>

#include "thin_section.hpp"

/// The levels of tiles from cycle to cycle, against what the mesh and the stable steps of the tiles ask for.
namespace pinball::cycle_levels_test {
namespace {

using namespace test;

class Bar {
 public:
  explicit Bar(int along = 60, int across = 2)
      : model(build_model<double>(bar_with_thin_section(1, across, along))),
        results(static_cast<std::size_t>(model.tile_count())) {
    for (std::size_t t = 0; t < results.size(); ++t) set_step(t, std::ldexp(1.0, model.tile_levels[t].own));
  }
  void set_step(std::size_t tile, double step) { results[tile].time_step = step; }
  void set_steps_of_level(int level, double step) {
    for (std::size_t t = 0; t < results.size(); ++t) {
      if (highest(t) == level) set_step(t, step);
    }
  }
  int highest(std::size_t tile) const { return model.tile_levels[tile].highest; }
  std::set<std::int32_t> nodes_of(std::size_t tile) const {
    std::set<std::int32_t> nodes;
    for_each_element(tile, [&](std::int32_t e) {
      for (const std::int32_t n : model.mesh.hexahedra[static_cast<std::size_t>(e)]) nodes.insert(n);
    });
    return nodes;
  }
  double elements_of_level(int level) const {
    double count = 0;
    for (std::size_t t = 0; t < results.size(); ++t) {
      if (highest(t) == level) for_each_element(t, [&](std::int32_t) { ++count; });
    }
    return count;
  }
  /// Tiles with a node of the tile, itself among them.
  std::set<std::size_t> around(std::size_t tile) const {
    const std::set<std::int32_t> nodes = nodes_of(tile);
    std::set<std::size_t> tiles;
    for (std::size_t t = 0; t < results.size(); ++t) {
      const std::set<std::int32_t> others = nodes_of(t);
      if (std::ranges::any_of(others, [&](std::int32_t n) { return nodes.contains(n); })) tiles.insert(t);
    }
    return tiles;
  }
  int top() const {
    int level = 0;
    for (std::size_t t = 0; t < results.size(); ++t) level = std::max(level, highest(t));
    return level;
  }
  /// The first tile of the highest level that has none of another level within two tiles.
  std::size_t one_by_itself() const {
    for (std::size_t t = 0; t < results.size(); ++t) {
      bool alike = highest(t) == top();
      for (const std::size_t beside : around(t)) {
        for (const std::size_t next : around(beside)) alike = alike && highest(next) == top();
      }
      if (alike) return t;
    }
    ADD_FAILURE() << "the bar is to be longer";
    return 0;
  }
  void cycle(Subcycling<double>& subcycling) const {
    subcycling.plan(results, 0);
    subcycling.begin_cycle(model);
  }
  std::vector<int> levels(const Subcycling<double>& subcycling) const {
    std::vector<int> levels;
    for (std::int32_t t = 0; t < model.tile_count(); ++t) {
      levels.push_back(std::ilogb(subcycling.step(t, false, {1.0}).length));
    }
    return levels;
  }
  std::vector<int> levels_of_mesh() const {
    std::vector<int> levels;
    for (const TileLevels& tile : model.tile_levels) levels.push_back(tile.highest);
    return levels;
  }

  Model<double> model;
  std::vector<TileResult<double>> results;

 private:
  template <class Visit>
  void for_each_element(std::size_t tile, const Visit& visit) const {
    const std::int64_t width = model.elements.width;
    for (std::int64_t slot = width * model.tile_packs[tile]; slot < width * model.tile_packs[tile + 1]; ++slot) {
      const std::int32_t e = model.element_of_slot[static_cast<std::size_t>(slot)];
      if (e >= 0) visit(e);
    }
  }
};

constexpr int cycles_to_choice = 64;  ///< more than there are between two choices among all levels

/// A span of nodes is due as often as the lowest level around any of its nodes.
void expect_levels_of_spans(const Bar& bar, bool every_node) {
  const Subcycling<double> subcycling(bar.model, every_node);
  std::vector<int> of_node(static_cast<std::size_t>(bar.model.nodes.count), every_node ? 0 : bar.top());
  for (std::size_t t = 0; t < bar.results.size(); ++t) {
    for (const std::int32_t n : bar.nodes_of(t)) {
      int& level = of_node[static_cast<std::size_t>(bar.model.node_of_scene_node[static_cast<std::size_t>(n)])];
      level = std::min(level, bar.highest(t));
    }
  }
  for (std::int32_t span = 0; span < span_count(bar.model.nodes.count); ++span) {
    const auto first = of_node.begin() + span * nodes_per_span;
    const auto end = of_node.begin() + std::min(bar.model.nodes.count, (span + 1) * nodes_per_span);
    const int level = *std::min_element(first, end);
    for (std::int32_t step = 0; step < subcycling.cycle_steps(); ++step) {
      EXPECT_EQ(subcycling.due_nodes(step).contain(span), level <= subcycling.due(step)) << span << ", " << step;
    }
    EXPECT_EQ(subcycling.due_nodes(0).steps(span), 1 << level) << span;
  }
}

TEST(CycleLevels, OfSpansAreTheLowestAroundTheirNodes) {
  for (const bool every_node : {false, true}) expect_levels_of_spans(Bar(12, 9), every_node);
  // Where levels change, and where the last span ends, at any place of a span.
  for (int along = 8; along < 60; ++along) expect_levels_of_spans(Bar(along), false);
}

/// Of two choices the one with less work per time, where it is less by a tenth; a smallest step costs a tenth of an
/// element step per element besides its own, where all nodes make it.
TEST(CycleLevels, AreChosenByTheirWork) {
  for (const bool every_node : {false, true}) {
    Bar bar(12);
    const double few = bar.elements_of_level(0), many = bar.elements_of_level(2);
    const double cost = every_node ? 0.1 * (few + many) : 0;
    double low = 2.1, high = 3.9;  // stable step of the many, over that of the few
    for (int halving = 0; halving < 40; ++halving) {
      const double ratio = 0.5 * (low + high);
      bar.set_steps_of_level(2, ratio);
      Subcycling<double> subcycling(bar.model, every_node);
      for (int cycle = 0; cycle < cycles_to_choice; ++cycle) bar.cycle(subcycling);
      (subcycling.levels() == 2 ? low : high) = ratio;
    }
    // (cost + few + many / 2) / 1 = 0.9 (cost + few + many / 4) / (ratio / 4)
    const double expected = 4 * 0.9 * (cost + few + many / 4) / (cost + few + many / 2);
    EXPECT_NEAR(low, expected, 1e-9);
  }
}

/// One that may make less than three quarters of the step of its own elements lowers those beside it.
TEST(CycleLevels, BesideASqueezedTileAreNoHigherThanItIsStable) {
  for (const double share : {0.76, 0.74, 0.51, 0.3}) {
    Bar bar;
    const double squeezed_to = share * std::ldexp(1.0, bar.top());
    const std::size_t tile = bar.one_by_itself();
    Subcycling<double> subcycling(bar.model, false);
    for (int cycle = 0; cycle < cycles_to_choice; ++cycle) bar.cycle(subcycling);
    std::vector<int> expected = bar.levels_of_mesh();
    EXPECT_EQ(bar.levels(subcycling), expected);
    const int stable = std::ilogb(squeezed_to);
    bar.set_step(tile, squeezed_to);
    bar.cycle(subcycling);
    expected[tile] = stable;
    if (share < 0.75) {
      for (const std::size_t beside : bar.around(tile)) expected[beside] = stable;
    }
    EXPECT_EQ(bar.levels(subcycling), expected) << share;
  }
}

/// Tiles go down at once, and up again now and then.
TEST(CycleLevels, AreChosenAgainAtOnceWhereStepsHaveBecomeSmaller) {
  Bar bar;
  const auto expect_levels_up_to = [&](const Subcycling<double>& subcycling, int level) {
    std::vector<int> expected = bar.levels_of_mesh();
    for (int& of_tile : expected) of_tile = std::min(of_tile, level);
    EXPECT_EQ(bar.levels(subcycling), expected);
  };
  Subcycling<double> subcycling(bar.model, false);
  for (int cycle = 0; cycle < cycles_to_choice; ++cycle) bar.cycle(subcycling);
  const int top = bar.top();
  bar.set_steps_of_level(top, std::ldexp(0.51, top));
  bar.cycle(subcycling);
  expect_levels_up_to(subcycling, top - 1);
  bar.set_steps_of_level(top, std::ldexp(1.0, top));
  bar.cycle(subcycling);
  expect_levels_up_to(subcycling, top - 1);
  for (int cycle = 0; cycle < cycles_to_choice; ++cycle) bar.cycle(subcycling);
  expect_levels_up_to(subcycling, top);
}

/// Within two tiles of an eroded element all make the smallest step, whatever they were; nothing beyond does, although
/// what has been uncovered may be squeezed. The same goes on from a saved state.
TEST(CycleLevels, WithinTwoTilesOfAnErodedElementAreTheLowest) {
  for (const bool squeezed : {false, true}) {
    Bar bar;
    const std::size_t tile = bar.one_by_itself();
    std::vector<int> expected = bar.levels_of_mesh();
    std::set<std::size_t> near;
    for (const std::size_t beside : bar.around(tile)) near.merge(bar.around(beside));
    for (const std::size_t t : near) expected[t] = 0;
    EXPECT_NE(*std::ranges::max_element(expected), 0);
    Subcycling<double> subcycling(bar.model, false), rest(bar.model, false);
    const std::vector<std::int64_t> before = subcycling.elements_of_levels();
    bar.results[tile].eroded_count = 3;
    subcycling.count_elements(bar.results, 0);
    bar.results[tile].eroded_count = 0;
    EXPECT_EQ(subcycling.elements_of_levels().back(), before.back() - 3);
    for (const std::size_t t : near) {
      if (squeezed) bar.set_step(t, 1.5);
    }
    StateBytes bytes;
    StateArchive::save(bytes, [&](StateArchive& archive) { subcycling.persist(archive, bar.model); });
    StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
    rest.persist(archive, bar.model);
    EXPECT_EQ(archive.left(), 0U);
    for (Subcycling<double>* one : {&subcycling, &rest}) {
      bar.cycle(*one);
      EXPECT_EQ(bar.levels(*one), expected);
    }
  }
}

}  // namespace
}  // namespace pinball::cycle_levels_test

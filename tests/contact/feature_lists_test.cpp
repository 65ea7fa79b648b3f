#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <random>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <solver/contact/faces/feature_lists.hpp>
#include <tests/support/cube_text.hpp>
#include <tests/support/output_case.hpp>
#include <tests/support/support.hpp>

#include "eroding_block.hpp"

/// Lists that follow erosion, against lists that are built anew after it.
namespace pinball::feature_lists_test {
namespace {

using namespace test;
using Lists = FeatureLists<double>;
using Pairs = std::set<Lists::Pair>;

/// Surface elements of two blocks on each other may erode; a tenth of an element apart, they are about to touch.
Scene eroding_blocks() {
  Scene scene = scene_of({block("a", {5, 5, 3}, 0.1, {0, 0, 0}), block("b", {4, 4, 3}, 0.11, {0.03, 0.04, 0.31})}, 1);
  scene.materials = {plastic_material("steel", 1e9, 1.0)};
  return scene;
}

/// Listed pairs that matter.
template <class Matters>
Pairs those_of(const SortedPairs& list, const Matters& matters) {
  Pairs pairs;
  for (std::int64_t piece = 0; piece < list.pieces.count; ++piece) {
    for (std::int64_t at = list.pieces.begin[piece]; at < list.pieces.end[piece]; ++at) {
      if (matters(list.first[at], list.second[at])) pairs.insert({list.first[at], list.second[at]});
    }
  }
  return pairs;
}
Pairs all_of(const SortedPairs& list) {
  return those_of(list, [](std::int32_t, std::int32_t) { return true; });
}

class ErodingBlocks {
 public:
  /// speed: of nodes in all directions, in elements over the time for which lists are built; size: that to which the
  /// blocks are squeezed, so that what lies near each other in them may touch; waits: so do faces behind the surface.
  ErodingBlocks(double speed, double size, bool waits = true) : model_(build_model<double>(eroding_blocks())) {
    Random random(17);
    auto &x = model_.nodes.position, &v = model_.nodes.velocity;
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = size * (x[i] + 0.01 * uniform(random, -1, 1));
      v[i] = 0.1 * speed / (horizon_steps * dt) * uniform(random, -1, 1);
    }
    for (std::size_t e = 0; waits && e < model_.slot_of_element.size(); ++e) strain_nearly_to_erosion(model_, {e});
    surface_.collect(source());
    edges_.collect(surface_);
    for (std::size_t e = 0; e < model_.slot_of_element.size(); ++e) {
      if (surface_.topology().exposed(model_.slot_of_element[e]) != 0) erodible_.push_back(e);
    }
    std::shuffle(erodible_.begin(), erodible_.end(), random);
  }

  void build(Lists& lists) const {
    const std::vector<float> depth(static_cast<std::size_t>(model_.nodes.count), 0);
    lists.count_step(dt);
    lists.build(source(), surface_, edges_, spheres_, settings_, depth, dt, 0, true);
  }
  void persist(Lists& lists, StateArchive& archive) const {
    lists.persist(archive, surface_, edges_, spheres_, settings_, model_.nodes.count);
  }
  bool follow(Lists& lists) const { return lists.follow_erosion(surface_, edges_, spheres_); }
  /// For the coming step alone, which is hardly one.
  void build_for_now(Lists& lists) const {
    const std::vector<float> depth(static_cast<std::size_t>(model_.nodes.count), 0);
    lists.build(source(), surface_, edges_, spheres_, settings_, depth, 1e-9 * dt, 0, false);
  }
  /// A step, in which some nodes are thrown off their ways, some of them by so much that segments turn.
  void move(Random& random) {
    auto &x = model_.nodes.position, &v = model_.nodes.velocity;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += dt * v[i];
    for (int thrown = 0; thrown < 4; ++thrown) {
      const auto slave = static_cast<std::size_t>(uniform(random, 0, std::nextafter(surface_.slaves().size(), 0)));
      const auto node = static_cast<std::size_t>(surface_.slaves()[slave].node);
      for (std::size_t k = 0; k < 3; ++k) {
        x[4 * node + k] += (thrown == 0 ? 0.1 : 0.01) * uniform(random, -1, 1);
        v[4 * node + k] = -2 * v[4 * node + k];
      }
    }
  }
  bool hold(Lists& lists) const { return lists.holds(source()); }
  bool follow_strays(Lists& lists) const {
    const std::vector<float> depth(static_cast<std::size_t>(model_.nodes.count), 0);
    return lists.follow_strays(source(), surface_, edges_, spheres_, depth);
  }
  static constexpr double dt = 1e-5;

  /// Takes some of the elements that were on the surface at first, all in one step.
  void erode_next(std::size_t count) {
    std::vector<std::int64_t> eroded;
    for (; count > 0; --count) {
      ASSERT_FALSE(erodible_.empty());
      eroded = erode(model_, erodible_.back());
      erodible_.pop_back();
    }
    ASSERT_TRUE(surface_.remove_eroded(eroded));
    ASSERT_TRUE(surface_.complete()) << "all that comes to the surface waited";
  }

  /// Listed pairs of active features that the mesh does not keep apart.
  Pairs nodes_that_matter(const Lists& lists) const {
    return those_of(lists.nodes(), [this](std::int32_t slave, std::int32_t segment) {
      const auto i = static_cast<std::size_t>(slave);
      return surface_.active(i) && surface_.active_segment(segment) &&
             !surface_.beside(surface_.around(i), std::span(&segment, 1));
    });
  }
  Pairs edges_that_matter(const Lists& lists) const {
    const auto active = [this](std::int32_t edge) {
      const auto segments = edges_.segments_of(edge);
      return std::any_of(segments.begin(), segments.end(),
                         [this](std::int32_t s) { return surface_.active_segment(s); });
    };
    return those_of(lists.edges(), [&](std::int32_t e, std::int32_t f) {
      return active(e) && active(f) && !surface_.beside(edges_.segments_of(e), edges_.segments_of(f));
    });
  }
  /// Listed pairs of edges of which one is known to stay flat, each of which has one that is; flat: flat_at_end or
  /// flat_along; cosine: between the faces of those that are sharp.
  int flat_pairs(const Lists& lists, std::uint8_t flat, double cosine) const {
    int count = 0;
    const ListPieces& pieces = lists.edges().pieces;
    for (std::int64_t piece = 0; piece < pieces.count; ++piece) {
      for (std::int64_t at = pieces.begin[piece]; at < pieces.end[piece]; ++at) {
        if (lists.edges().template flat_bits<1>(at, flat) == 0) continue;
        ++count;
        EXPECT_TRUE(is_flat(lists.edges().first[at], cosine) || is_flat(lists.edges().second[at], cosine));
      }
    }
    return count;
  }
  /// Whether some of the pairs are of one body.
  bool of_one_body(const Pairs& nodes) const {
    return std::any_of(nodes.begin(), nodes.end(), [this](const Lists::Pair& pair) {
      return surface_.slaves()[pair[0]].body == surface_.segments()[pair[1]].body;
    });
  }

 private:
  ModelSurface<double> source() const { return ModelSurface<double>(model_); }
  bool is_flat(std::int32_t edge, double cosine) const {
    std::vector<Vec3<double>> normals;
    for (const std::int32_t s : edges_.segments_of(edge)) {
      if (!surface_.active_segment(s)) continue;
      const auto x = [&](int k) { return vector_of(source().x(surface_.segments()[s].node[k])); };
      const Vec3<double> area = cross(x(2) - x(0), x(3) - x(1));
      normals.push_back((1 / std::sqrt(dot(area, area))) * area);
    }
    return normals.size() > 1 && dot(normals[0], normals[1]) >= cosine;
  }

  Model<double> model_;
  SegmentSurface<double> surface_{source(), surface_topology(model_)};
  EdgeTable<double> edges_;
  SphereSurface<double> spheres_{source(), surface_.topology()};
  ContactSettings settings_;
  std::vector<std::size_t> erodible_;
};

/// What else than the lists decides what they have.
struct Setting {
  double speed, size;
};
constexpr Setting settings[] = {{0.3, 1}, {3, 1}, {0.3, 0.3}, {1, 0.5}};

class FollowedLists : public testing::TestWithParam<Setting> {};
INSTANTIATE_TEST_SUITE_P(All, FollowedLists, testing::ValuesIn(settings));

TEST_P(FollowedLists, HaveWhatNewOnesHave) {
  ErodingBlocks blocks(GetParam().speed, GetParam().size);
  Lists followed, left;
  blocks.build(followed);
  blocks.build(left);
  int longer = 0, nodes_missed = 0, edges_missed = 0;
  for (const std::size_t count : {1, 1, 1, 3, 5, 1, 10, 20, 30}) {
    blocks.erode_next(count);
    const std::int64_t before = followed.entries();
    const bool grown = blocks.follow(followed);
    longer += grown;
    EXPECT_EQ(followed.entries() > before, grown);
    Lists anew;
    blocks.build(anew);
    const Pairs nodes = blocks.nodes_that_matter(anew), edges = blocks.edges_that_matter(anew);
    EXPECT_FALSE(nodes.empty());
    EXPECT_FALSE(edges.empty());
    EXPECT_EQ(blocks.nodes_that_matter(followed), nodes);
    EXPECT_EQ(blocks.edges_that_matter(followed), edges);
    nodes_missed += blocks.nodes_that_matter(left) != nodes;
    edges_missed += blocks.edges_that_matter(left) != edges;
    EXPECT_TRUE(GetParam().size == 1 || blocks.of_one_body(nodes));
  }
  EXPECT_GT(longer, 3);
  EXPECT_GT(nodes_missed, 3) << "lists that do not follow miss some";
  EXPECT_GT(edges_missed, 3);
}

TEST_P(FollowedLists, ThatWereReadAgainFollowAsTheOthersDo) {
  ErodingBlocks blocks(GetParam().speed, GetParam().size);
  Lists kept, read;
  blocks.build(kept);
  blocks.erode_next(5);
  blocks.follow(kept);
  StateBytes bytes;
  StateArchive::save(bytes, [&](StateArchive& archive) { blocks.persist(kept, archive); });
  StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
  blocks.persist(read, archive);
  for (const std::size_t count : {1, 5, 20}) {
    blocks.erode_next(count);
    EXPECT_EQ(blocks.follow(kept), blocks.follow(read));
    EXPECT_EQ(all_of(kept.nodes()), all_of(read.nodes()));
    EXPECT_EQ(all_of(kept.edges()), all_of(read.edges()));
  }
}

/// All that is near at a time is in lists that have followed until then. erodes: some elements, halfway.
void expect_to_follow(ErodingBlocks& blocks, bool erodes) {
  Random random(29);
  Lists followed, left;
  for (Lists* lists : {&followed, &left}) {
    blocks.build(*lists);
    lists->count_step(ErodingBlocks::dt);
  }
  int times = 0, longer = 0, missed = 0;
  for (int step = 0; step < 15; ++step) {
    blocks.move(random);
    if (erodes && step == 7) {
      blocks.erode_next(3);
      blocks.follow(followed);
      blocks.follow(left);
    }
    if (!blocks.hold(followed)) {
      const std::int64_t before = followed.entries();
      ASSERT_TRUE(blocks.follow_strays(followed)) << step;
      EXPECT_EQ(followed.entries(),
                before + followed.more_nodes().pieces.entries + followed.more_edges().pieces.entries);
      longer += followed.entries() > before;
      ++times;
    }
    EXPECT_TRUE(blocks.hold(followed));
    Lists now;
    blocks.build_for_now(now);
    const Pairs nodes = blocks.nodes_that_matter(now), edges = blocks.edges_that_matter(now);
    const auto has = [](const Pairs& all, const Pairs& some) {
      return std::includes(all.begin(), all.end(), some.begin(), some.end());
    };
    EXPECT_TRUE(has(blocks.nodes_that_matter(followed), nodes)) << step;
    EXPECT_TRUE(has(blocks.edges_that_matter(followed), edges)) << step;
    missed += !has(blocks.nodes_that_matter(left), nodes) || !has(blocks.edges_that_matter(left), edges);
    followed.count_step(ErodingBlocks::dt);
    left.count_step(ErodingBlocks::dt);
  }
  EXPECT_GT(times, 5);
  EXPECT_GT(longer, 3);
  EXPECT_GT(missed, 0) << "lists that do not follow miss some";
}

TEST_P(FollowedLists, HaveAllThatNodesMeetThatStray) {
  ErodingBlocks blocks(GetParam().speed, GetParam().size);
  expect_to_follow(blocks, true);
}

/// Where nothing waits behind the surface, and little moves, nodes look one way.
TEST_P(FollowedLists, HaveAllThatSegmentsMeetThatTurn) {
  ErodingBlocks blocks(0.01 * GetParam().speed, GetParam().size, false);
  expect_to_follow(blocks, false);
}

/// Nodes that are thrown by an element make edges sharp that were flat.
TEST(FeatureLists, KnowWhichEdgesStayFlat) {
  using Edges = ListedEdges<double>;
  ErodingBlocks blocks(0.003, 1);
  Random random(37);
  Lists lists;
  blocks.build(lists);
  lists.count_step(ErodingBlocks::dt);
  EXPECT_GT(blocks.flat_pairs(lists, Edges::flat_at_end, sharp_at_end), 0);
  EXPECT_GT(blocks.flat_pairs(lists, Edges::flat_along, sharp_along), 0);
  for (int step = 0; step < 15; ++step) {
    blocks.move(random);
    if (!blocks.hold(lists)) {
      ASSERT_TRUE(blocks.follow_strays(lists));
    }
    blocks.flat_pairs(lists, Edges::flat_at_end, sharp_at_end);
    blocks.flat_pairs(lists, Edges::flat_along, sharp_along);
    lists.count_step(ErodingBlocks::dt);
  }
}

TEST(FeatureLists, KnowThatErosionMakesEdgesSharp) {
  using Edges = ListedEdges<double>;
  ErodingBlocks blocks(0.003, 1);
  Lists lists;
  blocks.build(lists);
  ASSERT_GT(blocks.flat_pairs(lists, Edges::flat_at_end, sharp_at_end), 0);
  for (int times = 0; times < 8; ++times) {
    blocks.erode_next(8);
    blocks.follow(lists);
    blocks.flat_pairs(lists, Edges::flat_at_end, sharp_at_end);
  }
}

TEST(FeatureLists, ThatManyNodesHaveLeftAreToBeMadeAnew) {
  ErodingBlocks blocks(3, 1);
  Random random(31);
  Lists lists;
  blocks.build(lists);
  lists.count_step(ErodingBlocks::dt);
  for (int step = 0; step < 15; ++step) blocks.move(random);
  EXPECT_FALSE(blocks.hold(lists));
  EXPECT_FALSE(blocks.follow_strays(lists));
}

TEST(FeatureLists, ThatHoldNoLongerDoNotFollowErosion) {
  ErodingBlocks blocks(3, 1);
  Lists lists;
  blocks.build(lists);
  lists.invalidate();
  const std::int64_t before = lists.entries();
  blocks.erode_next(30);
  EXPECT_FALSE(blocks.follow(lists));
  EXPECT_EQ(lists.entries(), before);
}

/// Two cubes with a flat element between them, which is of the second body: no node is listed with a face of an element
/// that it belongs to itself, whichever body that is of.
TEST(FeatureLists, OfBodiesThatHaveNodesInCommonHaveNoNodeWithItsOwnElement) {
  const TemporaryFolder folder("joined");
  std::ofstream(folder / "cubes.k") << "*KEYWORD\n*NODE\n" + cube_lines(1) + square_lines(9, 1.2) +
                                           square_lines(13, 2.2) +
                                           "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n2,2,5,6,7,8,9,10,11,12\n"
                                           "3,2,9,10,11,12,13,14,15,16\n*END\n";
  Scene scene = scene_of({block("a", {1, 1, 1}, 1, {0, 0, 0}), block("b", {1, 1, 1}, 1, {0, 0, 0})}, 1);
  for (std::size_t b = 0; b < 2; ++b) {
    scene.bodies[b].mesh = FileMesh{MeshFormat::keyword, folder / "cubes.k", std::to_string(b + 1), 1.0};
  }
  Model<double> model = build_model<double>(scene);
  ASSERT_EQ(model.mesh.nodes.size(), 16U);
  constexpr double dt = 1e-5;
  Random random(3);
  auto& v = model.nodes.velocity;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = 0.5 / (horizon_steps * dt) * uniform(random, -1, 1);
  const ModelSurface<double> source(model);
  const SegmentSurface<double> surface(source, surface_topology(model));
  EdgeTable<double> edges;
  edges.collect(surface);
  Lists lists;
  lists.count_step(dt);
  lists.build(source, surface, edges, SphereSurface<double>(source, surface.topology()), scene.contact,
              std::vector<float>(16, 0), dt, 0, true);
  const Pairs nodes = all_of(lists.nodes());
  EXPECT_FALSE(nodes.empty());
  for (const auto& [slave, segment] : nodes) {
    const std::array<std::int32_t, 8>& corners = surface.segments()[segment].corners;
    EXPECT_EQ(std::ranges::count(corners, surface.slaves()[slave].node), 0) << slave << ", " << segment;
  }
}

}  // namespace
}  // namespace pinball::feature_lists_test

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <solver/contact/faces/edge_rows.hpp>
#include <solver/model/model_surface.hpp>
#include <tests/support/solver_case.hpp>

/// Rows of two edges that cross each other, against what can be worked out by hand.
namespace pinball::edge_rows_test {
namespace {

using namespace test;

/// How two edges cross.
struct Crossing {
  double s = 0.5, t = 0.5;  ///< where, of the lengths of both
  double angle = 1.2;       ///< between them [rad]
  double gap = 0;           ///< of the upper above the lower one
  double turned = 0;        ///< of the upper cube about its edge: half a turn, and it lies below that, as the lower one
};

/// Two cubes of size 1, each on an edge: the uppermost of the one, along x, crosses the lowest of the other.
class CrossedCubes {
 public:
  explicit CrossedCubes(const Crossing& crossing)
      : model_(build_model<double>(
            scene_of({block("a", {1, 1, 1}, 1, {0, 0, 0}), block("b", {1, 1, 1}, 1, {9, 0, 0})}, 1))),
        depth_(static_cast<std::size_t>(model_.nodes.count), 0) {
    const double c = std::cos(crossing.angle), s = std::sin(crossing.angle), root = std::sqrt(0.5);
    const double turn_c = std::cos(crossing.turned), turn_s = std::sin(crossing.turned);
    const double along = crossing.t - 0.5;
    for (int corner = 0; corner < 8; ++corner) {
      const double u = (corner & 1) - 0.5, v = corner >> 1 & 1, w = corner >> 2;
      put(corner, {u, root * (v - w), root * (v + w - 2)});
      const double aside = root * (v - w), up = root * (v + w);
      const double p = turn_c * aside - turn_s * up, z = turn_s * aside + turn_c * up;
      put(8 + corner, {crossing.s - 0.5 - along * c + u * c - p * s, -along * s + u * s + p * c, crossing.gap + z});
    }
  }
  /// Of a corner of the scene, b's from 8 on.
  std::int32_t node(int corner) const { return model_.node_of_scene_node[static_cast<std::size_t>(corner)]; }
  void set_velocity(int corner, double along_z) { model_.nodes.velocity[place(corner) + 2] = along_z; }
  void set_depth(int corner, float depth) { depth_[static_cast<std::size_t>(node(corner))] = depth; }

  /// The rows of the two edges in a step of length 1.
  std::vector<FeatureRow> rows(double approach = 0) const {
    const ModelSurface<double> source(model_);
    SegmentSurface<double> surface(source, surface_topology(model_));
    EdgeTable<double> edges;
    edges.collect(surface);
    const auto number_of = [&](int one, int other) {
      const auto [low, high] = std::minmax({node(one), node(other)});
      std::int32_t number = 0;
      while (edges.edges()[static_cast<std::size_t>(number)].node[0] != low ||
             edges.edges()[static_cast<std::size_t>(number)].node[1] != high) {
        ++number;
      }
      return number;
    };
    const std::int32_t lower = number_of(6, 7), upper = number_of(8, 9);
    EdgeRows<double>::EdgePairs pairs;
    pairs.found()[0].add(std::min(lower, upper), std::max(lower, upper));
    pairs.sort(static_cast<std::int64_t>(edges.edges().size()), native_width<double>);
    for (auto& ends : pairs.node) ends.renew(pairs.first.size());
    pairs.size.renew(pairs.first.size());
    for (std::size_t i = 0; i < pairs.first.size(); ++i) {
      for (std::size_t end = 0; end < 2; ++end) {
        pairs.node[end][i] = edges.edges()[static_cast<std::size_t>(pairs.first[i])].node[end];
        pairs.node[2 + end][i] = edges.edges()[static_cast<std::size_t>(pairs.second[i])].node[end];
      }
      pairs.size[i] = 2 * size();
    }
    const bool some_deep = std::ranges::any_of(depth_, [](float depth) { return depth > 0; });
    EdgeRows<double> found_rows;
    found_rows.find(source, surface, edges, pairs, {1.0, approach, depth_.data(), some_deep});
    std::vector<FeatureRow> all;
    std::as_const(found_rows.rows()).for_each([&](const FeatureRow& row) { all.push_back(row); });
    return all;
  }
  /// Of a segment: the radius of the ball of a cube of size 1.
  static double size() { return std::cbrt(3 / (4 * M_PI)); }

 private:
  std::size_t place(int corner) const { return 4 * static_cast<std::size_t>(node(corner)); }
  void put(int corner, const Point& x) {
    for (std::size_t k = 0; k < 3; ++k) model_.nodes.position[place(corner) + k] = x[k];
  }
  Model<double> model_;
  std::vector<float> depth_;
};

std::size_t rows_of(const Crossing& crossing) { return CrossedCubes(crossing).rows().size(); }

/// The one row has the ends of both with the shares that the crossing has of them, and the direction of both.
TEST(EdgeRows, AreThoseOfTheEndsOfEdgesThatCross) {
  for (const double angle : {0.03, 0.4, 1.5708, 2.3, -1.1}) {
    for (const auto& [s, t] : {std::pair{0.5, 0.5}, {0.1, 0.7}, {0.93, 0.12}}) {
      for (const double gap : {0.01, -0.05}) {
        const CrossedCubes cubes({s, t, angle, gap});
        const std::vector<FeatureRow> rows = cubes.rows();
        ASSERT_EQ(rows.size(), 1U) << angle << ", " << s << ", " << t << ", " << gap;
        const FeatureRow& row = rows[0];
        ASSERT_EQ(row.nodes, 4);
        // From body 2, whose weights are positive, to body 1.
        const double side = row.node[0] == cubes.node(6) || row.node[0] == cubes.node(7) ? -1 : 1;
        const std::pair<std::int32_t, double> expected[] = {{cubes.node(6), side * (1 - s)},
                                                            {cubes.node(7), side * s},
                                                            {cubes.node(8), -side * (1 - t)},
                                                            {cubes.node(9), -side * t}};
        for (int k = 0; k < 4; ++k) {
          double weight = 0;
          for (const auto& [node, share] : expected) weight += node == row.node[k] ? share : 0;
          EXPECT_NEAR(row.weight[k], weight, 1e-9);
        }
        EXPECT_NEAR(row.direction.x, 0, 1e-12);
        EXPECT_NEAR(row.direction.y, 0, 1e-12);
        EXPECT_NEAR(row.direction.z, side, 1e-12);
        EXPECT_NEAR(row.depth, -gap, 1e-12);
        EXPECT_NEAR(row.reach, CrossedCubes::size(), 1e-12);
        EXPECT_NEAR(row.size, 2 * CrossedCubes::size(), 1e-12);
      }
    }
  }
}

/// Round-off apart: nodes see to what is beyond.
TEST(EdgeRows, AreNoneBeyondAnEnd) {
  for (const double beyond : {-0.004, 1.004}) {
    EXPECT_EQ(rows_of({beyond, 0.5}), 0U) << beyond;
    EXPECT_EQ(rows_of({0.5, beyond}), 0U) << beyond;
  }
  for (const double end : {-0.0005, 1.0005}) {
    EXPECT_EQ(rows_of({end, 0.5}), 1U) << end;
    EXPECT_EQ(rows_of({0.5, end}), 1U) << end;
  }
}

/// These are knives: they meet however small the angle is.
TEST(EdgeRows, AreThereUntilEdgesAreParallel) {
  for (const double angle : {0.0205, 0.0195, 1e-3, 1e-5}) EXPECT_EQ(rows_of({0.5, 0.5, angle}), 1U) << angle;
  EXPECT_EQ(rows_of({0.5, 0.5, 0}), 0U);
}

TEST(EdgeRows, AreNoneOfWhatIsNearerToAnotherFaceAtTheEndOfAnEdge) {
  EXPECT_EQ(rows_of({0.5, 0.02, 1.5, -0.05}), 0U);
  EXPECT_EQ(rows_of({0.5, 0.1, 1.5, -0.05}), 1U);
}

TEST(EdgeRows, AreNoneOfEdgesThatDoNotLookAtEachOther) { EXPECT_EQ(rows_of({0.4, 0.6, 1.2, 0, M_PI}), 0U); }

/// A tenth of a segment deep, less what was as deep in the step before or has come in within it.
TEST(EdgeRows, AreNoneOfWhatDidNotComeInThere) {
  const auto deep = [](double depth, int corner, float before, double closing) {
    CrossedCubes cubes({0.5, 0.5, 1.2, -depth});
    if (corner >= 0) cubes.set_depth(corner, before);
    for (const int upper : {8, 9}) cubes.set_velocity(upper, -closing);
    return cubes.rows(closing).size();
  };
  const double least = 0.1 * CrossedCubes::size();
  EXPECT_EQ(deep(least - 1e-3, -1, 0, 0), 1U);
  EXPECT_EQ(deep(least + 1e-3, -1, 0, 0), 0U);
  EXPECT_EQ(deep(least + 0.2 - 1e-3, -1, 0, 0.2), 1U);
  EXPECT_EQ(deep(least + 0.2 + 1e-3, -1, 0, 0.2), 0U);
  for (const int corner : {6, 7, 8, 9}) {
    EXPECT_EQ(deep(least + 0.3 - 1e-3, corner, 0.3F, 0), 1U) << corner;
    EXPECT_EQ(deep(least + 0.3 + 1e-3, corner, 0.3F, 0), 0U) << corner;
  }
  EXPECT_EQ(deep(least + 0.2, 0, 0.3F, 0), 0U) << "of another edge";
}

/// A gap is open by a fiftieth of a segment, or closes within two steps as the one before.
TEST(EdgeRows, AreThoseOfGapsThatMayClose) {
  const auto open = [](double gap, double closing) {
    CrossedCubes cubes({0.5, 0.25, 1.2, gap});
    for (const int upper : {8, 9}) cubes.set_velocity(upper, -closing);
    return cubes.rows(2 * closing).size();
  };
  const double nearly = 0.02 * CrossedCubes::size();
  EXPECT_EQ(open(nearly - 1e-3, 0), 1U);
  EXPECT_EQ(open(nearly + 1e-3, 0), 0U);
  EXPECT_EQ(open(nearly + 0.2 - 1e-3, 0.1), 1U);
  EXPECT_EQ(open(nearly + 0.2 + 1e-3, 0.1), 0U);
  EXPECT_EQ(open(nearly - 1e-3, -0.1), 1U) << "what parts is no further away";
}

}  // namespace
}  // namespace pinball::edge_rows_test

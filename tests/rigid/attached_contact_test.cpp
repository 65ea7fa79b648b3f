#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include <solver/model/interfaces/contact_sides.hpp>

#include "rigid_case.hpp"

/// What may touch what where nodes are attached to a rigid body.
namespace pinball::attached_contact_test {
namespace {

using namespace test;

/// Two cubes side by side on a rigid bar, to which their feet are attached.
class AttachedContact : public testing::Test {
 protected:
  static Model<double> make_model() {
    Scene scene = scene_of({block("bar", {2, 1, 1}, 1, {0, 0, 0}), block("left", {1, 1, 1}, 1, {0, 0, 1}),
                            block("right", {1, 1, 1}, 1, {1, 0, 1})},
                           1);
    scene.rigid_bodies = {rigid("bar")};
    scene.attached_nodes = {attached_at("bar", "left", 1), attached_at("bar", "right", 1)};
    return build_model<double>(scene);
  }

  /// The node of an element at a place, in the numbers of the store.
  std::int32_t node(std::size_t element, const Point& place) const {
    for (const std::int32_t n : model_.mesh.hexahedra[element]) {
      const Point& p = model_.mesh.nodes[n];
      if (std::hypot(p[0] - place[0], p[1] - place[1], p[2] - place[2]) < 1e-9) return model_.node_of_scene_node[n];
    }
    throw std::logic_error("no such node");
  }
  std::array<std::int32_t, 4> side(std::size_t element, double x) const {
    return {node(element, {x, 0, 1}), node(element, {x, 1, 1}), node(element, {x, 1, 2}), node(element, {x, 0, 2})};
  }
  std::array<std::int32_t, 4> level(std::size_t element, double x, double z) const {
    return {node(element, {x, 0, z}), node(element, {x + 1, 0, z}), node(element, {x + 1, 1, z}),
            node(element, {x, 1, z})};
  }
  bool may(std::int32_t node, std::size_t element, const std::array<std::int32_t, 4>& face) const {
    return pairs_->node_and_face(node, model_.slot_of_element[element], 0, face).may;
  }
  bool edges_may(const std::array<std::int32_t, 2>& a, const std::array<std::int32_t, 2>& b) const {
    return pairs_->edges(a[0], a[1], b[0], b[1]).may;
  }

  const std::size_t bar_ = 0, left_ = 2, right_ = 3;  // elements; the bar has two
  const Model<double> model_ = make_model();
  const std::unique_ptr<ContactPairs> pairs_ = make_contact_pairs(model_);
};

TEST_F(AttachedContact, OfNodesAndFaces) {
  EXPECT_FALSE(may(node(left_, {0, 0, 1}), bar_, level(bar_, 0, 1))) << "what is attached, and the bar";
  EXPECT_FALSE(may(node(bar_, {0, 0, 1}), left_, side(left_, 0)));
  EXPECT_TRUE(may(node(left_, {0, 0, 2}), bar_, level(bar_, 0, 1))) << "what is not attached";
  EXPECT_TRUE(may(node(bar_, {0, 0, 1}), left_, level(left_, 0, 2)));
  EXPECT_FALSE(may(node(left_, {1, 0, 1}), right_, level(right_, 1, 1))) << "all of one body";
  EXPECT_TRUE(may(node(left_, {1, 0, 1}), right_, side(right_, 1)));
  EXPECT_TRUE(may(node(left_, {1, 0, 2}), right_, side(right_, 1)));
}

TEST_F(AttachedContact, OfEdges) {
  const std::array edge{node(bar_, {0, 0, 1}), node(bar_, {1, 0, 1})};
  EXPECT_FALSE(edges_may(edge, {node(left_, {0, 0, 1}), node(left_, {0, 0, 2})}));
  EXPECT_FALSE(edges_may({node(left_, {0, 0, 1}), node(left_, {0, 0, 2})}, edge));
  EXPECT_TRUE(edges_may(edge, {node(left_, {0, 0, 2}), node(left_, {1, 0, 2})}));
  const std::array foot{node(left_, {1, 0, 1}), node(left_, {1, 1, 1})};
  EXPECT_FALSE(edges_may(foot, {node(right_, {1, 0, 1}), node(right_, {2, 0, 1})}));
  EXPECT_TRUE(edges_may(foot, {node(right_, {1, 0, 1}), node(right_, {1, 0, 2})}));
}

TEST_F(AttachedContact, OfBalls) {
  const auto may = [this](std::size_t a, std::size_t b) {
    const auto corners = [this](std::size_t e) {
      std::array<std::int32_t, 8> nodes = model_.mesh.hexahedra[e];
      for (std::int32_t& n : nodes) n = model_.node_of_scene_node[n];
      return nodes;
    };
    return pairs_->elements(model_.slot_of_element[a], corners(a), model_.slot_of_element[b], corners(b)).may;
  };
  EXPECT_FALSE(may(bar_, left_));
  EXPECT_FALSE(may(right_, bar_));
  EXPECT_TRUE(may(left_, right_));
}

}  // namespace
}  // namespace pinball::attached_contact_test

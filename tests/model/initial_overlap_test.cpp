#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

#include <solver/model/initial_overlap.hpp>
#include <tests/support/solver_case.hpp>

namespace pinball::initial_overlap_test {
namespace {

using namespace test;

InitialOverlap overlap(const Point& corner, const std::array<int, 3>& elements = {2, 2, 2}, double h = 1) {
  return find_initial_overlap(
      build_mesh(scene_of({block("a", {2, 2, 2}, 1, {0, 0, 0}), block("b", elements, h, corner)}, 1)));
}

TEST(InitialOverlap, BodiesApartOrTouchingHaveNone) {
  EXPECT_EQ(overlap({0, 0, 2.5}).points, 0);
  EXPECT_EQ(overlap({0, 0, 2}).points, 0);
  EXPECT_EQ(overlap({0.3, 0.4, 1.95}).points, 0);  // a twentieth of an element: the facets of curved surfaces
}

TEST(InitialOverlap, IsNamed) {
  const InitialOverlap found = overlap({0.3, 0.4, 1.5});
  EXPECT_EQ(found.first, "a");
  EXPECT_EQ(found.second, "b");
  EXPECT_GT(found.points, 0);
}

TEST(InitialOverlap, OfTheSamePlaceAndOfABodyInsideAnother) {
  EXPECT_GE(overlap({0, 0, 0}).points, 2 * 8);  // at least the centres of all elements
  EXPECT_GT(overlap({0, 0, 0.5}).points, 0);    // where nodes and centres lie on faces
  EXPECT_GT(overlap({0.4, 0.4, 0.4}, {1, 1, 1}, 0.2).points, 0);
  EXPECT_GT(overlap({-4, -4, -4}, {1, 1, 1}, 10).points, 0);
}

/// One element each: no node, and none of the points of an element, lies in the other.
Scene bar_through_plate(const std::array<int, 3>& of_plate, const Point& corner_of_bar) {
  Body plate = block("plate", {1, 1, 1}, 1, {-5, -5, -0.25}), bar = block("bar", {1, 1, 1}, 1, corner_of_bar);
  plate.mesh = BlockMesh{{10, 10, 0.5}, of_plate};
  bar.mesh = BlockMesh{{1, 1, 10}, {1, 1, 1}};
  return scene_of({plate, bar}, 1);
}

TEST(InitialOverlap, OfABarThroughAPlateWithoutANodeInside) {
  const auto points = [](const std::array<int, 3>& of_plate, const Point& corner) {
    const Scene scene = bar_through_plate(of_plate, corner);
    const ModelMesh mesh = build_mesh(scene);
    const std::vector<InitialOverlap> all = find_initial_overlaps(scene, mesh);
    const std::int64_t found = find_initial_overlap(mesh).points;
    EXPECT_EQ(all.empty() ? 0 : all[0].points, found);
    return found;
  };
  EXPECT_EQ(points({1, 1, 1}, {0.5, 1.5, -5}), 4) << "its four long edges";
  EXPECT_EQ(points({1, 1, 2}, {0.5, 1.5, -5}), 4) << "their middles lie on faces of elements";
  EXPECT_GT(points({2, 2, 1}, {-0.3, 1.5, -5}), 0);
  EXPECT_GT(points({1, 1, 1}, {4.5, 1.5, -5}), 0) << "over the rim";
  EXPECT_EQ(points({1, 1, 1}, {5, 1.5, -5}), 0) << "along the rim";
  EXPECT_EQ(points({1, 1, 1}, {4.998, 1.5, -5}), 0) << "along the rim, but for facets";
  EXPECT_EQ(points({1, 1, 1}, {0.5, 1.5, 0.25}), 0) << "on the plate";
  EXPECT_EQ(points({1, 1, 1}, {4, 1.5, 0.25}), 0) << "on the plate, flush with its rim";
  EXPECT_EQ(points({1, 1, 1}, {4, 1.5, 0.24}), 0) << "the same, but for facets";
}

TEST(InitialOverlap, ScenesOfTheRepositoryHaveNone) {
  for (const char* name : {"rod_plate", "rod_oblique", "two_blocks", "two_bars", "sphere_sphere", "taylor_plate",
                           "newtons_cradle", "contact_patch", "sliding_block", "sphere_floor"}) {
    const Scene scene = read_scene(find_scene(name));
    const ModelMesh mesh = build_mesh(scene);
    EXPECT_EQ(find_initial_overlap(mesh).points, 0) << name;
    EXPECT_TRUE(find_initial_overlaps(scene, mesh).empty()) << name;
  }
}

Scene two_blocks(const Point& corner) {
  return scene_of({block("a", {2, 2, 2}, 1, {0, 0, 0}), block("b", {2, 2, 2}, 1, corner)}, 1);
}

std::vector<InitialOverlap> overlaps(const Scene& scene) { return find_initial_overlaps(scene, build_mesh(scene)); }

/// A pin that is too thick for its hole, and nothing moves: contact that a scene leaves open is on, and the bodies are
/// told of.
TEST(InitialOverlaps, OfBodiesAtRestTurnContactOn) {
  const auto model_of = [](const Point& corner) {
    Scene scene = two_blocks(corner);
    scene.contact.method = ContactMethod::not_set;
    scene.contact.enforcement = Enforcement::lagrange;
    return build_model<double>(scene);
  };
  const auto resting = model_of({0.3, 0.4, 1.6});
  EXPECT_EQ(resting.scene.contact.method, ContactMethod::pinball);
  EXPECT_EQ(resting.look.contact_because,
            "contact is on (contact.method is left out): bodies a and b overlap at the start");
  EXPECT_EQ(model_of({0, 0, 2}).scene.contact.method, ContactMethod::none) << "they touch";
}

TEST(InitialOverlaps, NameTheDeepestNodeAndItsDepth) {
  EXPECT_TRUE(overlaps(two_blocks({0, 0, 2.5})).empty());
  EXPECT_TRUE(overlaps(two_blocks({0, 0, 2})).empty());
  for (const double depth : {0.05, 0.29, 0.7}) {
    const auto found = overlaps(two_blocks({0.3, 0.4, 2 - depth}));
    ASSERT_EQ(found.size(), 1U) << depth;
    EXPECT_EQ(found[0].first, "a");
    EXPECT_EQ(found[0].second, "b");
    EXPECT_NEAR(overlaps(two_blocks({0, 0, 2 - depth}))[0].depth, depth, 1e-12) << "where sides lie in one plane";
    EXPECT_EQ(found[0].nodes, 4 + 4) << "the corners of b and of a that lie in the other";
    EXPECT_NEAR(found[0].depth, depth, 1e-12);
    EXPECT_NEAR(found[0].share, depth, 1e-12);
    ASSERT_GE(found[0].node, 0);
  }
}

/// The sides of triangles have nodes of the other body in their middle.
TEST(InitialOverlaps, AreNoneWhereTetrahedraTouchAFinerMesh) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 1, {0, 0, 0}), block("b", {4, 4, 4}, 0.5, {0, 0, 2})}, 1);
  for (const bool finer : {false, true}) {
    scene.bodies[0].elements = ElementShape::tetrahedra;
    scene.bodies[1].elements = finer ? ElementShape::tetrahedra : ElementShape::hexahedra;
    EXPECT_TRUE(overlaps(scene).empty()) << finer;
  }
}

TEST(InitialOverlaps, HaveOnePairOfBodiesAfterTheOther) {
  Scene scene = two_blocks({0, 0, 1.9});
  scene.bodies.push_back(block("c", {2, 2, 2}, 1, {0, 0, 3.7}));
  const auto found = overlaps(scene);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].second, "b");
  EXPECT_EQ(found[1].first, "b");
  EXPECT_EQ(found[1].second, "c");
  EXPECT_NEAR(found[0].depth, 0.1, 1e-12);
  EXPECT_NEAR(found[1].depth, 0.2, 1e-12);
  ContactPair pair;
  pair.first.bodies = {"b"};
  pair.second.bodies = {"c"};
  scene.contact_pairs = {pair};
  EXPECT_EQ(overlaps(scene).size(), 1U) << "what may not touch may overlap";
}

TEST(InitialOverlaps, SeeBarsThatCrossWithoutANodeInside) {
  Scene scene = two_blocks({0, 0, 0});
  scene.bodies[0].mesh = BlockMesh{{4, 1, 1}, {1, 1, 1}};
  scene.bodies[1].mesh = BlockMesh{{1, 4, 1}, {1, 1, 1}};
  scene.bodies[1].position = {1.5, -1.5, 0.3};
  const auto found = overlaps(scene);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].nodes, 0);
  EXPECT_GT(found[0].points, 0);
}

/// A pin of radius `pin` in a half hole of radius 10: 24 elements around the pin, 17 around the half hole.
std::vector<InitialOverlap> pin_in_hole(double pin) {
  Body body;
  body.name = "pin";
  body.material = "steel";
  body.mesh = CylinderMesh{pin, 10, Section::full, 0, 6, 3, 1, 4};
  const Scene scene = scene_of({body, block("hole", {17, 4, 4}, 1, {100, 0, 0})}, 1);
  ModelMesh mesh = build_mesh(scene);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (mesh.body_names[static_cast<std::size_t>(mesh.body_of_node[n])] != "hole") continue;
    const Point x = mesh.nodes[n];
    const double angle = M_PI * (1 - (x[0] - 100) / 17), radius = 10 + 2 * x[1];
    mesh.nodes[n] = {radius * std::cos(angle), radius * std::sin(angle), 2.5 * x[2]};
  }
  return find_initial_overlaps(scene, mesh);
}

TEST(InitialOverlaps, TellAPinThatIsTooLargeFromTheFacetsOfItsHole) {
  EXPECT_TRUE(pin_in_hole(10).empty()) << "facets stand into the hole by " << 10 * (1 - std::cos(M_PI / 34));
  EXPECT_TRUE(pin_in_hole(9.9).empty());
  const auto found = pin_in_hole(10.5);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_GT(found[0].nodes, 30);
  EXPECT_GE(found[0].depth, 0.5 - 1e-9);
  EXPECT_LT(found[0].depth, 0.6);
}

/// Whether bodies do not overlap once they are adjusted; and how far nodes have gone at most.
double way_of_adjustment(Scene scene, bool& apart) {
  scene.contact.overlap = ContactOverlap::adjust;
  const ModelMesh before = build_mesh(scene);
  ModelMesh mesh = before;
  adjust_initial_overlaps(scene, {}, mesh);
  apart = find_initial_overlaps(scene, mesh).empty();
  double way = 0;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) way = std::max(way, norm(minus(mesh.nodes[n], before.nodes[n])));
  return way;
}

/// A face has no tangents where corners are one node, and no foot is found there.
TEST(InitialOverlaps, OfWedgesThatTouchAtTheirAxisThereAreNone) {
  Scene scene = read_scene(find_scene("perforated_plate"));
  scene.bodies[0].position = {0, 0, 0};
  EXPECT_TRUE(overlaps(scene).empty());
  scene.bodies[0].position = {0, 0, -0.1};
  ASSERT_EQ(overlaps(scene).size(), 1U);
  EXPECT_NEAR(overlaps(scene)[0].depth, 0.1, 1e-9);
}

TEST(InitialOverlaps, AreAdjusted) {
  bool apart = false;
  EXPECT_EQ(way_of_adjustment(two_blocks({0, 0, 2}), apart), 0);
  EXPECT_NEAR(way_of_adjustment(two_blocks({0, 0, 1.71}), apart), 0.145, 1e-9) << "each of the two by half";
  EXPECT_TRUE(apart);
  EXPECT_LE(way_of_adjustment(two_blocks({0.3, 0.4, 1.71}), apart), 0.29 + 1e-9) << "meshes do not fit";
  EXPECT_TRUE(apart);
  const Scene small = scene_of({block("a", {2, 2, 2}, 1, {0, 0, 0}), block("b", {2, 2, 2}, 0.3, {0.2, 0.2, 1.9})}, 1);
  EXPECT_LE(way_of_adjustment(small, apart), 0.1 + 1e-9) << "nodes of one side alone";
  EXPECT_TRUE(apart);
}

/// Of a mesh that is turned, faces of wedges and tetrahedra that are collapsed to lines have areas of rounding.
/// up: of unit length, what was z.
ModelMesh turned_blocks(ElementShape shape, const Point& up) {
  Scene scene = two_blocks({0.53, 0.47, 1.8});
  for (Body& body : scene.bodies) body.elements = shape;
  ModelMesh mesh = build_mesh(scene);
  Point right{1, 0, 0};
  make_orthogonal(right, {up});
  const Point back = cross(up, right);
  for (Point& x : mesh.nodes) {
    Point turned{};
    for (std::size_t k = 0; k < 3; ++k) turned[k] = x[0] * right[k] + x[1] * back[k] + x[2] * up[k];
    x = turned;
  }
  return mesh;
}

TEST(InitialOverlaps, OfTetrahedraAreThoseOfHexahedraHoweverTheMeshLies) {
  Scene scene = two_blocks({0, 0, 0});
  scene.contact.overlap = ContactOverlap::adjust;
  for (const Point& up : {Point{0, 0, 1}, Point{0.48, 0.6, 0.64}, Point{0.8, 0, 0.6}, Point{-0.36, 0.48, 0.8}}) {
    const auto overlap_of = [&](ElementShape shape) {
      const std::vector<InitialOverlap> found = find_initial_overlaps(scene, turned_blocks(shape, up));
      return found.empty() ? InitialOverlap{} : found[0];
    };
    const InitialOverlap cut = overlap_of(ElementShape::tetrahedra), whole = overlap_of(ElementShape::hexahedra);
    EXPECT_EQ(whole.nodes, 8);
    EXPECT_EQ(cut.nodes, whole.nodes);
    EXPECT_NEAR(cut.depth, 0.2, 1e-12);
    const ModelMesh before = turned_blocks(ElementShape::tetrahedra, up);
    ModelMesh mesh = before;
    adjust_initial_overlaps(scene, {}, mesh);
    EXPECT_TRUE(find_initial_overlaps(scene, mesh).empty());
    const std::size_t moved =
        mesh.nodes.size() - std::inner_product(mesh.nodes.begin(), mesh.nodes.end(), before.nodes.begin(),
                                               std::size_t{0}, std::plus<>{}, std::equal_to<>{});
    EXPECT_EQ(moved, 8U);
  }
}

/// They never touch each other, also at the end, and keep their volumes.
TEST(InitialOverlaps, OfBodiesOfOneRigidBodyAreNone) {
  Scene scene = two_blocks({0, 0, 1.5});
  EXPECT_FALSE(overlaps(scene).empty());
  scene.rigid_bodies.emplace_back().bodies = {"a"};
  scene.rigid_bodies.emplace_back().bodies = {"b"};
  bool apart = false;
  EXPECT_FALSE(overlaps(scene).empty()) << "of two";
  EXPECT_GT(find_overlap_at(1, scene, build_mesh(scene), 0.2).points, 0);
  EXPECT_GT(way_of_adjustment(scene, apart), 0.1);
  scene.rigid_bodies.pop_back();
  scene.rigid_bodies[0].bodies = {"a", "b"};
  EXPECT_TRUE(overlaps(scene).empty());
  EXPECT_EQ(find_overlap_at(1, scene, build_mesh(scene), 0.2).points, 0);
  EXPECT_EQ(way_of_adjustment(scene, apart), 0);
}

TEST(InitialOverlaps, AreAdjustedWithinPlanesOfSymmetryAndWhereNodesAreFree) {
  Scene scene = two_blocks({0, 0, 1.8});
  scene.constraints = {{{0, 0, 0}, {1, 0, 0}, ""}};
  FixedConstraint fixed;
  fixed.nodes.plane = Plane{{0, 0, 1.8}, {0, 0, 1}};
  fixed.directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene.fixed_constraints = {fixed};
  scene.contact.overlap = ContactOverlap::adjust;
  ModelMesh mesh = build_mesh(scene);
  const ModelMesh before = mesh;
  adjust_initial_overlaps(scene, {}, mesh);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (before.nodes[n][0] == 0) {
      EXPECT_EQ(mesh.nodes[n][0], 0);
    }
    if (before.nodes[n][2] == 1.8) {
      EXPECT_EQ(mesh.nodes[n], before.nodes[n]);
    }
  }
  EXPECT_TRUE(find_initial_overlaps(scene, mesh).empty()) << "those that are not held go all the way";
}

TEST(InitialOverlaps, ThatLeaveAnElementNoVolumeAreRefused) {
  Scene scene = two_blocks({0, 0, 5});
  scene.bodies[1] = block("b", {1, 1, 1}, 0.2, {0.9, 0.9, 0.9});
  scene.contact.overlap = ContactOverlap::adjust;
  EXPECT_THAT(error_of<InputError>([&] { build_model<double>(scene); }),
              testing::AllOf(testing::HasSubstr("contact.overlap"), testing::HasSubstr("of body")));
}

}  // namespace
}  // namespace pinball::initial_overlap_test

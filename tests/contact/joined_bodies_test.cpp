#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>
#include <vector>

#include <solver/contact/slideline/slideline_search.hpp>
#include <solver/contact/surface/joined_bodies.hpp>
#include <solver/model/model_surface.hpp>
#include <tests/support/folder_case.hpp>
#include <tests/support/solver_case.hpp>

/// Bodies that are parts of one mesh and have nodes in common.
namespace pinball::joined_bodies_test {
namespace {

using namespace test;

/// An element of a lattice, by its place along x and z, and the part that it belongs to.
struct Cell {
  int x, z, part;
};

class JoinedBodiesContact : public FolderTest {
 protected:
  /// One body for each part; unit: edges along x and y of 1, and along z of this.
  Scene scene_of_cells(const std::vector<Cell>& cells, const std::vector<Point>& velocity, double height) const {
    const std::string path = (folder_ / "cells.k").string();
    std::ofstream file(path);
    const auto node = [](int x, int y, int z) { return 1 + 20 * z + 10 * y + x; };
    file << "*KEYWORD\n*NODE\n";
    for (int z = 0; z < 8; ++z) {
      for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 8; ++x) file << fmt::format("{},{},{},{:g}\n", node(x, y, z), x, y, z * height);
      }
    }
    file << "*ELEMENT_SOLID\n";
    int number = 0;
    for (const Cell& cell : cells) {
      file << fmt::format("{},{}", ++number, cell.part);
      for (const int up : {0, 1}) {
        for (const auto& [i, j] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          file << fmt::format(",{}", node(cell.x + i, j, cell.z + up));
        }
      }
      file << '\n';
    }
    file << "*END\n";
    std::vector<Body> bodies;
    for (std::size_t part = 1; part <= velocity.size(); ++part) {
      Body body;
      body.name = fmt::format("part_{}", part);
      body.material = "steel";
      body.mesh = FileMesh{MeshFormat::keyword, path, std::to_string(part), 1.0};
      body.velocity = velocity[part - 1];
      bodies.push_back(body);
    }
    return scene_of(bodies, 2e-3);
  }

  /// Every kind of contact and search, with its name.
  template <class Work>
  static void for_each_contact(const Work& work) {
    struct Kind {
      ContactMethod method;
      ContactGap gap;
    };
    for (const auto& [method, gap] : {Kind{ContactMethod::pinball, ContactGap::pinball},
                                      {ContactMethod::pinball, ContactGap::face},
                                      {ContactMethod::slideline, ContactGap::not_set}}) {
      for (const Enforcement enforcement : {Enforcement::penalty, Enforcement::projection, Enforcement::lagrange}) {
        if (gap == ContactGap::face && enforcement == Enforcement::penalty) continue;
        for (const ContactSearch search : {ContactSearch::tree, ContactSearch::hash}) {
          for (const bool self : {true, false}) {
            SCOPED_TRACE(fmt::format("method {}, gap {}, {}, search {}, self {}", static_cast<int>(method),
                                     static_cast<int>(gap), enforcement_name(enforcement), static_cast<int>(search),
                                     self));
            ContactSettings contact;
            contact.method = method;
            contact.gap = gap;
            contact.enforcement = enforcement;
            contact.search = search;
            contact.self = self;
            work(contact);
          }
        }
      }
    }
  }

  /// The most pairs of a step.
  static std::int64_t most_pairs(const Scene& scene) {
    Solver<double> solver(scene);
    std::int64_t most = 0;
    run_to_end(solver, [&] { most = std::max(most, solver.counts().pairs()); });
    return most;
  }
};

TEST_F(JoinedBodiesContact, IsNotWhereTheyArePressedTogether) {
  Scene scene = scene_of_cells({{0, 0, 1}, {0, 1, 2}}, {{0, 0, 60}, {0, 0, -60}}, 1);
  for_each_contact([&](const ContactSettings& contact) {
    scene.contact = contact;
    EXPECT_EQ(most_pairs(scene), 0);
  });
}

/// Balls of flat elements reach over the next layer, and over a body of one layer.
TEST_F(JoinedBodiesContact, IsNotWhereBallsOverlappedFromTheStart) {
  Scene scene = scene_of_cells({{0, 0, 1}, {0, 1, 1}, {0, 2, 2}, {0, 3, 3}, {0, 4, 3}},
                               {{0, 0, 30}, {0, 0, 0}, {0, 0, -30}}, 0.2);
  for_each_contact([&](const ContactSettings& contact) {
    scene.contact = contact;
    EXPECT_EQ(most_pairs(scene), 0);
  });
}

/// Arms on a common base that come together, as two bodies or as one with the base.
TEST_F(JoinedBodiesContact, IsWhereTheyWereApartAndMeet) {
  const std::vector<Point> velocity{{600, 0, 0}, {-600, 0, 0}, {0, 0, 0}};
  std::vector<Cell> cells;
  for (int x = 0; x < 5; ++x) cells.push_back({x, 0, 3});
  for (int z = 1; z < 6; ++z) {
    cells.push_back({0, z, 1});
    cells.push_back({4, z, 2});
  }
  Scene scene = scene_of_cells(cells, velocity, 1);
  scene.time.end = 4e-3;
  for_each_contact([&](const ContactSettings& contact) {
    scene.contact = contact;
    EXPECT_GT(most_pairs(scene), 0);
  });
}

/// An arm that may fold onto the base that it stands on: near the joint nodes meet no segments, as in one body.
TEST_F(JoinedBodiesContact, IsThatOfOneBodyForNodesOfASlideline) {
  const auto may_touch = [&](int part_of_arm) {
    std::vector<Cell> cells;
    for (int x = 0; x < 6; ++x) cells.push_back({x, 0, 1});
    for (int z = 1; z < 6; ++z) cells.push_back({0, z, part_of_arm});
    const Scene scene = scene_of_cells(cells, std::vector<Point>(static_cast<std::size_t>(part_of_arm)), 1);
    const Model<double> model = build_model<double>(scene);
    const SegmentSurface<double> surface(ModelSurface<double>(model), surface_topology(model));
    const SlidelineSearch<double> search(ModelSurface<double>(model), surface, true);
    std::int64_t pairs = 0;
    for (const auto& slave : surface.slaves()) {
      for (const auto& segment : surface.segments()) pairs += search.may_touch(slave, segment) ? 1 : 0;
    }
    return pairs;
  };
  EXPECT_GT(may_touch(1), 0);
  EXPECT_EQ(may_touch(2), may_touch(1));
}

TEST_F(JoinedBodiesContact, KnowsThemOverOthers) {
  const std::vector<Cell> cells{{4, 0, 4}, {0, 0, 3}, {1, 0, 1}, {6, 0, 2}, {2, 0, 5}, {5, 1, 4}};
  const Model<double> model = build_model<double>(scene_of_cells(cells, std::vector<Point>(5), 1));
  const Surface surface(surface_topology(model));
  const JoinedBodies joined(ModelSurface<double>(model), surface);
  for (const std::int32_t body : {0, 2, 4}) EXPECT_EQ(joined.first(body), 0) << body;
  for (const std::int32_t body : {1, 3}) EXPECT_EQ(joined.first(body), 1) << "they meet in an edge";
  EXPECT_TRUE(joined.are_one(4, 2));
  EXPECT_FALSE(joined.are_one(1, 2));
  EXPECT_EQ(JoinedBodies().first(7), 7);
}

}  // namespace
}  // namespace pinball::joined_bodies_test

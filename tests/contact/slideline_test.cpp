#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <solver/contact/segments/segment_surface.hpp>
#include <solver/contact/slideline/slideline_search.hpp>
#include <solver/model/model_surface.hpp>

#include "impact_case.hpp"

/// Contact of slave nodes with master segments, through the solver and piece by piece.
namespace pinball::slideline_test {
namespace {

using namespace test;

class Slideline : public testing::TestWithParam<Enforcement> {
 protected:
  Scene slideline(Scene scene) const {
    scene.contact.method = ContactMethod::slideline;
    scene.contact.enforcement = GetParam();
    return scene;
  }
  bool penalty() const { return GetParam() == Enforcement::penalty; }
};

INSTANTIATE_TEST_SUITE_P(All, Slideline,
                         testing::Values(Enforcement::penalty, Enforcement::projection, Enforcement::lagrange),
                         [](const auto& test) { return std::string(enforcement_name(test.param)); });

TEST_P(Slideline, HeadOnImpactKeepsMomentumAndClosesItsBalance) {
  const Scene scene = slideline(head_on_impact(0.01));
  Solver<double> solver(scene);
  EXPECT_STREQ(solver.contact()->name(), "slideline");
  double worst = 0;
  run_to_end(solver, [&] {
    worst = std::max(worst, std::abs(solver.balance_error()));
    for (const double p : solver.momentum()) ASSERT_NEAR(p, 0, 1e-12 * 7850 * 0.027 * 10);
  });
  if (penalty()) {
    // The first and the last force of a spring work over whole steps, of which it touches for a part.
    Scene fine = scene;
    fine.time.cfl = 0.1;
    Solver<double> fine_solver(fine);
    double fine_worst = 0;
    run_to_end(fine_solver, [&] { fine_worst = std::max(fine_worst, std::abs(fine_solver.balance_error())); });
    EXPECT_LT(fine_worst, 1e-2);  // the damping begins at once: first order
    EXPECT_LT(fine_worst, 0.2 * worst);
  } else {
    EXPECT_LT(worst, 2e-3);
  }
  EXPECT_LT(velocity_of_body(solver, 0)[2], -7);
  EXPECT_GT(velocity_of_body(solver, 0)[2], -10);
  EXPECT_NEAR(velocity_of_body(solver, 0)[2], -velocity_of_body(solver, 1)[2], 1e-9);
}

TEST_P(Slideline, ObliqueImpactsKeepMomentumAndEnergy) {
  const auto with = [this](const Scene& scene) { return slideline(scene); };
  expect_oblique_impacts_conserve(with, 0.01, [](const Solver<double>& solver, double energy) {
    EXPECT_GT(std::abs(solver.energies().contact_damped), 1e-6 * energy) << "they are to touch";
    EXPECT_EQ(solver.counts().pairs(), 0) << "they separate";
  });
}

TEST_P(Slideline, ImpactsAreTheSameFarFromTheOrigin) {
  const auto rebound = [this](const Point& place) {
    Scene scene = slideline(head_on_impact(0.01));
    for (Body& body : scene.bodies) {
      for (std::size_t k = 0; k < 3; ++k) body.position[k] += place[k];
    }
    Solver<double> solver(scene);
    run_to_end(solver);
    return velocity_of_body(solver, 1)[2];
  };
  const double here = rebound({0, 0, 0});
  EXPECT_NEAR(rebound({123.4567, 98.76, 45.67}), here, 1e-3 * here);
}

TEST_P(Slideline, BodiesThatTouchAtRestStayAtRest) {
  Scene scene =
      slideline(scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0}), block("b", {2, 2, 2}, 0.15, {0, 0, 0.3})}, 1e-3));
  Solver<double> solver(scene);
  run_to_end(solver);
  EXPECT_EQ(kinetic_energy(solver), 0);
}

TEST_P(Slideline, APlateOneElementThickIsHitFromBothSides) {
  const auto plate_velocity = [&](double sign) {
    Solver<double> solver(slideline(impact_on_plate(sign, 0.01)));
    run_to_end(solver);
    EXPECT_LT(std::abs(solver.balance_error()), 0.03);
    EXPECT_GT(sign * (velocity_of_body(solver, 1)[2] - velocity_of_body(solver, 0)[2]), 0) << "they separate";
    return velocity_of_body(solver, 0)[2];
  };
  const double from_above = plate_velocity(1), from_below = plate_velocity(-1);
  EXPECT_LT(from_above, -1);
  // Nodes on the common edge of two segments belong to one of them, which round-off decides.
  EXPECT_NEAR(from_below, -from_above, 0.01 * from_below);
}

TEST_P(Slideline, ABodyStopsAtTheSurfaceThatErosionHasExposed) {
  const double h = impact_h;
  Solver<double> solver(slideline(impact_on_eroding_target(0.5)));
  solver.step();
  EXPECT_EQ(solver.contact()->surface_elements(), 64 - 8 + 8);
  erode_upper_layer(solver);
  const Point before = solver.momentum();
  solver.step();
  EXPECT_EQ(solver.counts().eroded_elements(), 16);
  EXPECT_EQ(solver.contact()->surface_elements(), 48 - 4 + 8);
  double lowest = 1;
  run_to_end(solver, [&] {
    for (std::size_t n = 125; n < 125 + 9; ++n) lowest = std::min(lowest, position_of(solver, n)[2]);
  });
  EXPECT_GT(lowest, 2.8 * h) << "stopped by the layer below";
  EXPECT_LT(lowest, 3.2 * h) << "not by the nodes of what has eroded";
  EXPECT_GT(velocity_of_body(solver, 1)[2], velocity_of_body(solver, 0)[2]);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(solver.momentum()[k], before[k], 1e-9 * std::abs(before[2]));
}

TEST_P(Slideline, ListsLastOverErosionsAndMissNothing) {
  const double h = 0.1;
  Scene scene = slideline(scene_of(
      {block("plate", {8, 8, 3}, h, {0, 0, 0}), block("rod", {2, 2, 8}, h, {0.27, 0.31, 3.1 * h}, {300, 0, -2000})},
      4e-4));
  scene.materials = {plastic_material("steel", 1e9, 0.6)};
  const auto outcome = [&](bool keep_lists, std::int64_t& searches, std::int64_t& erosions) {
    scene.skip.contact_search = keep_lists;
    Solver<double> solver(scene);
    std::int64_t eroded = 0;
    run_to_end(solver, [&] {
      erosions += solver.counts().eroded_elements() != eroded;
      eroded = solver.counts().eroded_elements();
    });
    searches = solver.contact()->searches();
    return state_hash(solver.model());
  };
  std::int64_t searches = 0, erosions = 0, searches_each_step = 0, erosions_each_step = 0;
  const std::uint64_t kept = outcome(true, searches, erosions);
  EXPECT_EQ(outcome(false, searches_each_step, erosions_each_step), kept);
  EXPECT_GT(erosions, 20) << "steps in which elements erode";
  EXPECT_EQ(erosions, erosions_each_step);
  EXPECT_LT(searches, erosions);
}

/// A block is pressed on a held one of another mesh and slides over it for three of its elements. Returns how much its
/// height varies, over the size of an element.
double bumps(Scene scene) {
  const double h = 0.1;
  scene.bodies = {block("floor", {16, 6, 1}, h, {-0.3, -0.3, -h}),
                  block("slider", {3, 3, 2}, 0.8 * h, {-0.12, -0.12, 0}, {100, 0, 0})};
  FixedConstraint floor;
  floor.nodes.body = "floor";
  floor.directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene.fixed_constraints = {floor};
  NodalLoad load;
  load.nodes.body = "slider";
  load.force = {0, 0, -2e5};
  scene.loads = {load};
  scene.damping.mass = 500;
  scene.time.end = 5e-3;
  Solver<double> solver(scene);
  double low = 1, high = -1;
  run_to_end(solver, [&] {
    if (solver.time() < 2e-3) return;  // it has come to rest in height
    double sum = 0;
    int count = 0;
    const ModelMesh& mesh = solver.mesh();
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if (mesh.body_of_node[n] == 1) sum += position_of(solver, n)[2], ++count;
    }
    low = std::min(low, sum / count);
    high = std::max(high, sum / count);
  });
  return (high - low) / h;
}

TEST_P(Slideline, SlidesSmoothlyOverAFlatSurface) {
  // What balls cannot do: the report says that their surface is bumpy.
  const double slideline_bumps = bumps(slideline(scene_of({}, 1)));
  EXPECT_LT(slideline_bumps, 2e-3);
  if (penalty()) {
    EXPECT_GT(bumps(scene_of({}, 1)), 10 * slideline_bumps);
  }
}

TEST_P(Slideline, ANodeThatSlidesOverAnEdgeIsFree) {
  // A block moves along the top of another until it hangs over its edge: nothing may hold it back.
  const double h = 0.1;
  Scene scene = slideline(
      scene_of({block("a", {3, 3, 3}, h, {0, 0, 0}), block("b", {2, 2, 2}, h, {0.05, 0.05, 0.3}, {150, 0, -2})}, 3e-3));
  Solver<double> solver(scene);
  const double before = velocity_of_body(solver, 1)[0];
  run_to_end(solver);
  EXPECT_GT(position_of(solver, 64)[0], 0.4) << "it is to have left";
  EXPECT_NEAR(velocity_of_body(solver, 1)[0], before, 0.01 * before);
}

/// Two blocks of elements of size 1/8, the lower with its top at z = 0 and wider, the upper so deep in it. Returns the
/// pairs of their first step.
std::int64_t pairs_at_depth(const Scene& contact, double depth, double speed) {
  const double h = 0.125;
  Scene scene = contact;
  scene.bodies = {block("a", {6, 6, 3}, h, {-3 * h, -3 * h, -3 * h}),
                  block("b", {2, 2, 2}, h, {-0.9 * h, -0.9 * h, -depth}, {0, 0, -speed})};
  Solver<double> solver(scene);
  solver.step();
  return solver.counts().pairs();
}
const double radius_of_eighths = 0.125 * std::cbrt(3 / (4 * M_PI));

/// As deep as the radius of a segment is the most that a node has come in through it at once.
TEST_P(Slideline, WhatIsDeepFromTheStartTouchesNothing) {
  const Scene scene = slideline(scene_of({}, 1e-4));
  EXPECT_GT(pairs_at_depth(scene, 0.95 * radius_of_eighths, 10), 0);
  EXPECT_EQ(pairs_at_depth(scene, 1.05 * radius_of_eighths, 10), 0);
}

/// Of springs: what rests on another body does not touch it.
TEST(SlidelineSprings, LeaveGapsOfRoundOffAlone) {
  Scene scene = scene_of({}, 1e-4);
  scene.contact.method = ContactMethod::slideline;
  const double round_off = 4096 * std::numeric_limits<double>::epsilon() * radius_of_eighths;
  EXPECT_EQ(pairs_at_depth(scene, 0.98 * round_off, 0), 0);
  EXPECT_GT(pairs_at_depth(scene, 1.02 * round_off, 0), 0);
}

/// A node whose foot is on the edge of two segments goes from one to the other by round-off, also while it leaves.
TEST(SlidelineSprings, GiveBackWhatTheyHoldWhereAFootChangesItsSegment) {
  const double h = impact_h;
  const auto dissipated = [&](double shift, double& worst) {
    Scene scene = scene_of(
        {block("a", {4, 4, 3}, h, {0, 0, 0}), block("b", {2, 2, 2}, h, {h + shift, h + shift, 3.005 * h}, {0, 0, -10})},
        8e-4);
    scene.contact.method = ContactMethod::slideline;
    scene.contact.enforcement = Enforcement::penalty;
    Solver<double> solver(scene);
    run_to_end(solver, [&] { worst = std::max(worst, std::abs(solver.balance_error())); });
    EXPECT_EQ(solver.counts().pairs(), 0) << "they have parted";
    return solver.energies().contact_damped;
  };
  double worst_within = 0, worst_on_edges = 0;
  const double within = dissipated(0.3 * h, worst_within), on_edges = dissipated(0, worst_on_edges);
  EXPECT_NEAR(on_edges, within, 0.1 * within);
  EXPECT_LT(worst_on_edges, 1.5 * worst_within);
}

TEST(SlidelineSearch, ListsEveryNodeThatComesNearASegment) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double dt = 1e-4;
  // Squeezed, nodes come near segments of their own body too.
  for (const auto& [speed, size] : {std::pair{0.0, 1.0}, {5.0, 1.0}, {50.0, 1.0}, {5.0, 0.4}}) {
    Scene scene = scene_of(
        {block("a", {4, 3, 2}, 0.1, {0, 0, 0}, {0, 0, speed}),
         block("b", {3, 3, 3}, 0.07, {0.05, 0.1, 0.21}, {speed, 0, -speed}), block("c", {1, 1, 1}, 0.3, {-0.31, 0, 0})},
        1);
    Model<double> model = build_model<double>(scene);
    Array<double>&x = model.nodes.position, &v = model.nodes.velocity;
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = size * (x[i] + 0.02 * uniform(generator));
      v[i] += 0.3 * speed * uniform(generator);  // so that segments grow
    }
    SegmentSurface<double> surface(ModelSurface<double>(model), surface_topology(model));
    SlidelineSearch<double> search(ModelSurface<double>(model), surface, true);
    search.count_step(dt);
    search.build(ModelSurface<double>(model), surface, 0.5);
    std::int64_t near = 0, near_own = 0;
    for (int step = 1; step < horizon_steps; ++step) {  // the last may be over by round-off
      search.count_step(dt);
      // Straight on, but for less than what every node may stray.
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += dt * v[i] + (step == 5 ? 0.0005 * uniform(generator) : 0);
      surface.update(ModelSurface<double>(model));
      ASSERT_TRUE(search.holds(ModelSurface<double>(model)));
      for (std::size_t i = 0; i < surface.slaves().size(); ++i) {
        const auto& slave = surface.slaves()[i];
        const double* p = x.data() + 4 * static_cast<std::int64_t>(slave.node);
        const std::int32_t* first = search.candidates(i);
        for (std::size_t s = 0; s < surface.segments().size(); ++s) {
          if (!search.may_touch(slave, surface.segments()[s])) continue;
          const double* sphere = surface.sphere().data() + 4 * s;
          if (std::hypot(p[0] - sphere[0], p[1] - sphere[1], p[2] - sphere[2]) >= sphere[3]) continue;
          ++near;
          near_own += surface.segments()[s].body == slave.body;
          EXPECT_EQ(std::count(first, first + search.count(i), static_cast<std::int32_t>(s)), 1);
        }
      }
    }
    EXPECT_GT(near, 1000);
    EXPECT_EQ(near_own > 100, size < 1);
    x[4] += 0.1;
    EXPECT_FALSE(search.holds(ModelSurface<double>(model)));
  }
}

}  // namespace
}  // namespace pinball::slideline_test

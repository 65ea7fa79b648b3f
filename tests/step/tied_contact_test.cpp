#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <solver/model/selection/node_selection.hpp>
#include <solver/results/warnings.hpp>
#include <tests/support/run_hash.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/tied_case.hpp>

/// Nodes that are tied to faces.
namespace pinball::tied_contact_test {
namespace {

using namespace test;
using testing::HasSubstr;

Point momentum_of_all(const Solver<double>& solver) { return solver.momentum(); }

/// Numbers of the scene: nodes of the lower block first.
double largest_distance_from_faces(const Solver<double>& solver) {
  double largest = 0;
  for (std::size_t n = 0; n < solver.mesh().nodes.size(); ++n) {
    const TiedNode* const tied = solver.tied().nodes().tie_of(solver.model().node_of_scene_node[n]);
    if (tied == nullptr) continue;
    for (int c = 0; c < 3; ++c) {
      double foot = 0;
      for (std::size_t k = 0; k < 4; ++k)
        foot += tied->weight[k] * solver.model().nodes.position_of(tied->corner[k])[c];
      largest = std::max(largest, std::abs(foot - solver.model().nodes.position_of(tied->node)[c]));
    }
  }
  return largest;
}

TEST(TiedContact, TellsWhatItHasTied) {
  Scene scene = glued(4, 3, 1e-4);
  Solver<double> solver(scene);
  EXPECT_EQ(solver.model().tie_counts.at(0).nodes, 25);
  EXPECT_EQ(solver.model().tie_counts[0].near, 0);
  scene = glued(4, 3, 1e-4, 0.02);  // tolerance: 0.05 sqrt(2) 0.2 = 0.01414
  EXPECT_EQ(Solver<double>(scene).model().tie_counts.at(0).nodes, 0);
  EXPECT_EQ(Solver<double>(scene).model().tie_counts[0].near, 25);
  scene.tied_contacts[0].tolerance = 0.021;
  const Solver<double> wider(scene);
  EXPECT_EQ(wider.model().tie_counts.at(0).nodes, 25);
  EXPECT_DOUBLE_EQ(wider.model().mesh.nodes[64][2], 0.6) << "nodes are put on their faces";
  PrescribedVelocity moved;
  moved.nodes.line = Line{{0, 0, 0.6}, {1, 0, 0}};
  moved.nodes.body = "high";
  scene = glued(4, 3, 1e-4);
  scene.prescribed_velocities = {moved};
  EXPECT_EQ(Solver<double>(scene).model().tie_counts.at(0).held, 5);
}

TEST(TiedContact, IsWarnedOfWhereTheSecondSideHasTheFinerMesh) {
  const auto warnings = [](int first, int second) {
    RunSummary summary;
    summary.tied = Solver<double>(glued(first, second, 1e-4)).model().tie_counts;
    return start_warnings(summary);
  };
  for (const int coarse : {1, 3, 4}) EXPECT_THAT(warnings(4, coarse), testing::IsEmpty()) << coarse;
  EXPECT_THAT(
      warnings(2, 4),
      testing::ElementsAre(HasSubstr(
          "9 nodes are tied, and 16 nodes of its second side lie on its first side with nothing that follows")));
}

TEST(TiedContact, MovesAsOneBody) {
  for (const int fine : {3, 4, 7}) {
    Scene scene = glued(fine, 3, 4e-3);
    for (Body& body : scene.bodies) body.velocity = {3, -7, 20};
    Solver<double> solver(scene);
    const Point before = momentum_of_all(solver);
    run(solver);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(momentum_of_all(solver)[k], before[k], 1e-11 * before[2]);
      EXPECT_NEAR(velocity_of(solver, 0)[k], Point({3, -7, 20})[k], 1e-9);
    }
    EXPECT_LT(std::abs(stress_of(solver, 0)[2]), 1e-3) << "Pa, of 2e11";
    EXPECT_LT(largest_distance_from_faces(solver), 1e-13);
  }
}

/// Two blocks with meshes that do not fit, turning about their common centre of mass for a quarter of a turn. They go
/// on as fast as they are given, with masses as ties lump them, 0.2 % more inert: the first step tells what is to be
/// kept.
TEST(TiedContact, KeepsEnergyAndBothMomentaOfWhatTurns) {
  Scene scene = glued(5, 3, 5e-3);
  const double w = 300;
  scene.bodies[0].angular_velocity = scene.bodies[1].angular_velocity = {w, 0, 0};
  scene.bodies[0].velocity = {0, 0.3 * w, 0};  // of the centroid, about the middle
  scene.bodies[1].velocity = {0, -0.3 * w, 0};
  Solver<double> solver(scene);
  solver.step();
  const Point before = angular_momentum(solver);
  double worst = 0;
  while (!solver.at_end()) {
    solver.step();
    worst = std::max(worst, std::abs(solver.balance_error()));
  }
  solver.finish();
  EXPECT_LT(worst, 1e-4);
  EXPECT_LT(largest_distance_from_faces(solver), 1e-13);
  const Point after = angular_momentum(solver);
  EXPECT_NEAR(after[0] / before[0], 1, 1e-4);
  EXPECT_NEAR(momentum_of_all(solver)[1] / before[0], 0, 1e-10);
}

/// A wave that passes the joint of two equal meshes is that in one mesh: masses and forces are those of common nodes.
TEST(TiedContact, PassesAWaveAsCommonNodesDo) {
  const auto bar = [](bool one) {
    Scene scene =
        one ? scene_of({block("bar", {2, 2, 16}, 0.1, {0, 0, 0})}, 3e-4, false)
            : scene_of({block("left", {2, 2, 8}, 0.1, {0, 0, 0}), block("right", {2, 2, 8}, 0.1, {0, 0, 0.8})}, 3e-4,
                       false);
    if (!one) scene.tied_contacts = {tie("right", "left")};
    PrescribedVelocity push;
    push.nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
    push.velocity = {0, 0, 5};
    scene.prescribed_velocities = {push};
    return scene;
  };
  Solver<double> joined(bar(true)), tied(bar(false));
  EXPECT_EQ(tied.model().tie_counts[0].nodes, 9);
  run(joined);
  run(tied);
  EXPECT_EQ(joined.steps(), tied.steps());
  double largest = 0;
  for (std::size_t e = 0; e < 64; ++e) {
    const auto a = stress_of(joined, e), b = stress_of(tied, e);
    for (std::size_t c = 0; c < 6; ++c) {
      largest = std::max(largest, std::abs(a[c]));
      EXPECT_NEAR(a[c], b[c], 1e-8 * 2e8) << e;
    }
  }
  EXPECT_GT(largest, 1e8);
}

/// A load on tied nodes, a pressure on faces of which they are corners and a host's forces do the work that the corners
/// which move them take up: from rest, in the first steps, too.
TEST(TiedContact, CountsTheWorkOfWhatActsOnTiedNodes) {
  Scene scene = glued(5, 3, 1e-3);
  scene.guard.energy_error = 1e9;
  NodeSelection joint;
  joint.plane = Plane{{0, 0, 0.6}, {0, 0, 1}};
  joint.body = "high";
  NodalLoad load;
  load.nodes = joint;
  load.force = {1e6, 2e6, -3e6};
  Pressure pressure;
  pressure.name = "side";
  pressure.faces.plane = Plane{{0.6, 0, 0}, {1, 0, 0}};
  pressure.faces.body = "high";
  pressure.pressure = 1e7;
  for (const int kind : {0, 1, 2}) {
    if (kind == 0) scene.loads = {load};
    if (kind == 1) scene.pressures = {pressure};
    Solver<double> solver(scene);
    if (kind == 2) {
      Array<double>& forces = solver.host_forces();
      for (const std::int32_t n : select_nodes(solver.mesh(), joint)) {
        record(forces.data(), solver.model().node_of_scene_node[n])[1] = 1e5;
      }
    }
    double worst = 0;
    while (!solver.at_end()) {
      solver.step();
      worst = std::max(worst, std::abs(solver.balance_error()));
    }
    solver.finish();
    EXPECT_GT(solver.energies().external, 0) << kind;
    EXPECT_LT(worst, 1e-6) << kind;
    scene.loads.clear();
    scene.pressures.clear();
  }
}

/// Gravity of one of two blocks has its weight, whoever has the masses of its nodes, and does the work of that.
TEST(TiedContact, HasTheWeightOfItsOwnBody) {
  for (const std::string body : {"low", "high"}) {
    Scene scene = glued(5, 3, 1e-3);
    scene.gravities = {{.acceleration = {300, 0, -200}, .bodies = {body}, .name = "weight"}};
    Solver<double> solver(scene);
    double worst = 0;
    while (!solver.at_end()) {
      solver.step();
      worst = std::max(worst, std::abs(solver.balance_error()));
    }
    solver.finish();
    const double weight = 7850 * 0.6 * 0.6 * 0.6 * 300;
    EXPECT_NEAR(momentum_of_all(solver)[0], weight * 1e-3, 1e-9 * weight) << body;
    EXPECT_NEAR(solver.boundary().forces(solver.model()).at(0).force[0], weight, 1e-9 * weight) << body;
    EXPECT_LT(worst, 1e-6) << body;
  }
}

/// A uniform stress in two blocks, whose meshes are nested: what the nodes of the finer give to the corners of the
/// coarser is the force of the same stress there. Each tied node that has other neighbours across the joint than common
/// nodes would have is in balance, too.
TEST(TiedContact, HoldsAUniformStress) {
  Scene scene = glued(6, 3, 1e-2);
  scene.damping.mass = 4000;
  FixedConstraint held;
  held.nodes.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  held.directions = {{0, 0, 1}};
  scene.fixed_constraints = {held};
  scene.constraints = {{{0, 0, 0}, {1, 0, 0}, ""}, {{0, 0, 0}, {0, 1, 0}, ""}};
  NodalLoad load;
  load.nodes.plane = Plane{{0, 0, 1.2}, {0, 0, 1}};
  load.force = {0, 0, -0.36e8};
  scene.loads = {load};
  Solver<double> solver(scene);
  run(solver);
  for (std::size_t e = 0; e < solver.mesh().hexahedra.size(); ++e) {
    EXPECT_NEAR(stress_of(solver, e)[2], -1e8, 2e5) << e;
    EXPECT_NEAR(stress_of(solver, e)[0], 0, 2e5) << e;
  }
}

/// Blocks that fly towards each other are joined by the tie at its start, as by a plastic impact, and let go at its
/// end.
TEST(TiedContact, IsBornAndDies) {
  Scene scene = glued(4, 3, 6e-4);
  scene.bodies[1].velocity = {0, 4, 0};
  scene.tied_contacts[0].start = 1e-4;
  scene.tied_contacts[0].end = 4e-4;
  Solver<double> solver(scene);
  const Point before = momentum_of_all(solver);
  double worst = 0;
  while (!solver.at_end()) {
    solver.step();
    const bool tied = solver.force_time() >= 1e-4 && solver.force_time() < 4e-4;
    EXPECT_EQ(solver.tied().nodes().active(), tied ? 25 : 0) << solver.force_time();
    worst = std::max(worst, std::abs(solver.balance_error()));
  }
  solver.finish();
  EXPECT_NEAR(momentum_of_all(solver)[1], before[1], 1e-11 * before[1]);
  EXPECT_GT(body_results(solver)[0].velocity[1], 0.5) << "the lower block was taken along";
  EXPECT_LT(worst, 0.01) << "what the joining costs is counted";
  EXPECT_GT(solver.energies().contact_damped, 0);
}

/// Where its foot was when the tie began is where a node stays from then on, and nothing jumps.
TEST(TiedContact, ThatIsBornLaterKeepsWhatLiesBetween) {
  Scene scene = glued(4, 3, 6e-4, 2e-3);
  scene.bodies[1].velocity = {0, 4, 0};
  scene.tied_contacts[0].tolerance = 0.1;
  scene.tied_contacts[0].start = 1e-4;
  Solver<double> solver(scene);
  const auto from_foot = [&](const TiedNode& tied) {
    Point way{};
    for (std::size_t c = 0; c < 3; ++c) {
      way[c] = solver.model().nodes.position_of(tied.node)[c];
      for (std::size_t k = 0; k < 4; ++k)
        way[c] -= tied.weight[k] * solver.model().nodes.position_of(tied.corner[k])[c];
    }
    return way;
  };
  const auto tied = [&]() -> const TiedNode* {
    for (const std::int32_t n : solver.model().node_of_scene_node) {
      if (const TiedNode* const found = solver.tied().nodes().tie_of(n)) return found;
    }
    return nullptr;
  };
  while (tied() == nullptr) solver.step();
  const TiedNode& node = *tied();
  const double born = solver.force_time();
  const Point between = from_foot(node);
  EXPECT_NEAR(between[1], 4 * born, 1e-3 * 4 * born) << "what the upper block had gone until then";
  run(solver);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(from_foot(node)[c], between[c], 1e-14);
}

TEST(TiedContact, EndsWithTheElementOfItsFace) {
  Scene scene = glued(4, 3, 2e-4);
  scene.materials = {plastic_material("steel", 5e8, 1)};
  for (Body& body : scene.bodies) body.velocity = {0, 0, 1};
  Solver<double> solver(scene);
  for (int i = 0; i < 3; ++i) solver.step();
  EXPECT_EQ(solver.tied().nodes().active(), 25);
  strain_to_failure(solver, {18});  // a corner of the upper layer of the lower block
  const Point before = momentum_of_all(solver);
  run(solver);
  EXPECT_LT(solver.tied().nodes().active(), 25);
  EXPECT_GT(solver.tied().nodes().active(), 15);
  EXPECT_NEAR(momentum_of_all(solver)[2], before[2], 1e-11 * before[2]);
}

std::string name_of(const std::tuple<Enforcement, ContactGap, ContactMethod>& kind) {
  return std::string(std::get<2>(kind) == ContactMethod::slideline ? "slideline_" : "pinball_") +
         enforcement_name(std::get<0>(kind)) + (std::get<1>(kind) == ContactGap::face ? "_face" : "_ball");
}

/// While they are tied the two do not touch each other; a third block touches what is tied.
class TiedInContact : public testing::TestWithParam<std::tuple<Enforcement, ContactGap, ContactMethod>> {
 protected:
  static Scene scene() {
    Scene made = glued(4, 3, 4e-4);
    made.contact.method = std::get<2>(GetParam());
    made.contact.enforcement = std::get<0>(GetParam());
    made.contact.gap = std::get<1>(GetParam());
    made.bodies.push_back(block("third", {3, 3, 6}, 0.1, {0.601, 0.15, 0.25}, {-10, 0, 0}));
    ContactPair own, other;
    own.name = "own";
    own.first.bodies = {"low"};
    own.second.bodies = {"high"};
    other.name = "other";
    other.first.bodies = {"low", "high"};
    other.second.bodies = {"third"};
    made.contact_pairs = {own, other};
    return made;
  }
};
INSTANTIATE_TEST_SUITE_P(All, TiedInContact,
                         testing::Values(std::tuple{Enforcement::lagrange, ContactGap::face, ContactMethod::pinball},
                                         std::tuple{Enforcement::penalty, ContactGap::pinball, ContactMethod::pinball},
                                         std::tuple{Enforcement::lagrange, ContactGap::pinball, ContactMethod::pinball},
                                         std::tuple{Enforcement::penalty, ContactGap::pinball,
                                                    ContactMethod::slideline},
                                         std::tuple{Enforcement::lagrange, ContactGap::face, ContactMethod::slideline}),
                         [](const auto& test) { return name_of(test.param); });

TEST_P(TiedInContact, OnlyOthersTouch) {
  Solver<double> solver(scene());
  const Point before = momentum_of_all(solver);
  run(solver);
  EXPECT_EQ(solver.contact_pairs()[0].force_max, 0);
  EXPECT_LT(solver.contact_pairs()[1].impulse[0], 0);
  EXPECT_NEAR(momentum_of_all(solver)[0], before[0], 1e-11 * std::abs(before[0]));
  EXPECT_LT(largest_distance_from_faces(solver), 1e-13);
  EXPECT_LT(std::abs(solver.balance_error()), 0.03);
}

TEST_P(TiedInContact, HasTheSameBitsWithAnyThreadsAndFromASavedState) {
  Scene made = scene();
  made.tied_contacts[0].end = 3e-4;
  const std::uint64_t one = hash_of<double>(made, 1);
  EXPECT_EQ(hash_of<double>(made, 3), one);
  Solver<double> whole(made);
  for (const double part : {0.3, 0.9}) {
    while (whole.time() < part * made.time.end) whole.step();
    const StateBytes state = test::saved(whole);
    Solver<double> rest(made);
    EXPECT_EQ(fingerprint(rest.model()), fingerprint(whole.model()));
    EXPECT_EQ(test::load(rest, state), 0U);
    run(rest);
    EXPECT_EQ(state_hash(rest.model()), one) << part;
  }
}

/// The stable step is that of the elements: a run at cfl 1 neither gains energy nor ends.
TEST(TiedContact, LeavesTheStableStepAlone) {
  Scene scene = glued(6, 2, 3e-3);
  scene.bodies[1].velocity_noise = 2;
  scene.time.cfl = 1.0;
  Solver<double> solver(scene);
  double worst = 0;
  while (!solver.at_end()) {
    solver.step();
    worst = std::max(worst, solver.balance_error());
  }
  solver.finish();
  EXPECT_LT(worst, 0.05);
}

TEST(TiedContact, SaysWhatItCannot) {
  Scene scene = glued(4, 3, 1e-4);
  scene.time.subcycling = true;
  EXPECT_THAT(input_error_of(scene), HasSubstr("expected time.subcycling = false"));
  scene = glued(4, 3, 1e-4, 0.5);
  scene.tied_contacts[0].tolerance = 0.51;  // the elements of the upper block, 0.15 high, are drawn out; that may be
  EXPECT_THAT(input_error_of(scene), testing::Not(HasSubstr("faces")));
  // In the lower one by more than an element: both its layers of nodes go to one plane.
  scene.bodies[1] = block("high", {1, 1, 2}, 0.15, {0.225, 0.225, 0.4});
  scene.tied_contacts[0].tolerance = 0.21;
  EXPECT_THAT(input_error_of(scene), HasSubstr("when its nodes are put on the faces"));
}

}  // namespace
}  // namespace pinball::tied_contact_test

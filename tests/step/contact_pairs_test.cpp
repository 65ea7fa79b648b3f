#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include <solver/base/state_archive.hpp>
#include <solver/summary.hpp>
#include <tests/support/run_hash.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/solver_case.hpp>

/// Contact pairs of a scene: what they let touch, when, and what they say of force and impulse.
namespace pinball::contact_pairs_test {
namespace {

using namespace test;

ContactPair pair_of(const std::string& name, const std::vector<std::string>& first,
                    const std::vector<std::string>& second = {}) {
  ContactPair pair;
  pair.name = name;
  pair.first.bodies = first;
  pair.second.bodies = second;
  return pair;
}

struct Kind {
  const char* name;
  ContactMethod method;
  Enforcement enforcement;
  ContactGap gap;
};

const std::vector<Kind> kinds{
    {"balls_penalty", ContactMethod::pinball, Enforcement::penalty, ContactGap::pinball},
    {"balls_lagrange", ContactMethod::pinball, Enforcement::lagrange, ContactGap::pinball},
    {"balls_projection", ContactMethod::pinball, Enforcement::projection, ContactGap::pinball},
    {"faces_lagrange", ContactMethod::pinball, Enforcement::lagrange, ContactGap::face},
    {"faces_projection", ContactMethod::pinball, Enforcement::projection, ContactGap::face},
    {"slideline_penalty", ContactMethod::slideline, Enforcement::penalty, ContactGap::pinball},
    {"slideline_lagrange", ContactMethod::slideline, Enforcement::lagrange, ContactGap::face}};

Scene with(Scene scene, const Kind& kind) {
  scene.contact.method = kind.method;
  scene.contact.enforcement = kind.enforcement;
  scene.contact.gap = kind.gap;
  return scene;
}

/// A block that flies down onto another, with meshes that do not fit.
Scene two_blocks(double end = 2e-4) {
  return scene_of({block("low", {4, 4, 3}, 0.1, {0, 0, 0}, {0, 0, 5}),
                   block("high", {3, 3, 3}, 0.09, {0.07, 0.05, 0.301}, {4, 0, -15})},
                  end);
}

Point momentum_of(const Solver<double>& solver, std::size_t body) {
  const BodyResult result = body_results(solver)[body];
  Point momentum = result.velocity;
  for (double& p : momentum) p *= result.mass_remaining;
  return momentum;
}

class ContactPairs : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(All, ContactPairs, testing::ValuesIn(kinds),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(ContactPairs, OfAllThatTouchesMakeTheBitsOfNoPairs) {
  Scene scene = with(two_blocks(), GetParam());
  const std::uint64_t without = hash_of<double>(scene);
  scene.contact_pairs = {pair_of("both", {"high"}, {"low"})};
  EXPECT_EQ(hash_of<double>(scene), without);
  EXPECT_EQ(hash_of<double>(scene, 3), without);
  scene.contact_pairs = {pair_of("all", {"high", "low"})};
  EXPECT_EQ(hash_of<double>(scene), without);
}

TEST_P(ContactPairs, ImpulseIsTheChangeOfMomentum) {
  Scene scene = with(two_blocks(), GetParam());
  scene.contact_pairs = {pair_of("both", {"high"}, {"low"})};
  Solver<double> solver(scene);
  const Point before = momentum_of(solver, 1), of_low = momentum_of(solver, 0);
  run(solver);
  const PairResult pair = solver.contact_pairs().at(0);
  const Point after = momentum_of(solver, 1), low = momentum_of(solver, 0);
  const double size = std::abs(before[2]);
  EXPECT_GT(pair.impulse[2], 0.3 * size);
  EXPECT_GT(pair.force_max, 0);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(pair.impulse[k], after[k] - before[k], 1e-12 * size) << k;
    EXPECT_NEAR(pair.impulse[k], of_low[k] - low[k], 1e-12 * size) << k;
  }
}

/// A block between two others; the third pair is never in contact.
TEST_P(ContactPairs, OfThreeBodiesSumUp) {
  Scene scene = with(scene_of({block("left", {3, 3, 3}, 0.1, {-0.3005, 0.02, 0}, {20, 0, 0}),
                               block("middle", {3, 3, 3}, 0.1, {0, 0, 0}),
                               block("right", {3, 3, 3}, 0.1, {0.3005, -0.03, 0.01}, {-8, 1, 0})},
                              1.5e-4),
                     GetParam());
  scene.contact_pairs = {pair_of("ml", {"middle"}, {"left"}), pair_of("mr", {"middle"}, {"right"}),
                         pair_of("lr", {"left"}, {"right"})};
  Solver<double> solver(scene);
  std::array<Point, 3> before{};
  for (std::size_t b = 0; b < 3; ++b) before[b] = momentum_of(solver, b);
  run(solver);
  const auto& pairs = solver.contact_pairs();
  const double size = before[0][0];
  EXPECT_GT(pairs[0].impulse[0], 0.1 * size);
  EXPECT_LT(pairs[1].impulse[0], -0.03 * size);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto change = [&](std::size_t b) { return momentum_of(solver, b)[k] - before[b][k]; };
    EXPECT_NEAR(change(1), pairs[0].impulse[k] + pairs[1].impulse[k], 1e-12 * size);
    EXPECT_NEAR(change(0), -pairs[0].impulse[k], 1e-12 * size);
    EXPECT_NEAR(change(2), -pairs[1].impulse[k], 1e-12 * size);
    EXPECT_EQ(pairs[2].impulse[k], 0);
  }
}

TEST_P(ContactPairs, LetNothingElseTouch) {
  Scene scene = with(two_blocks(), GetParam());
  scene.bodies.push_back(block("ghost", {2, 2, 2}, 0.1, {0.1, 0.1, -0.201}, {0, 0, 30}));
  scene.contact_pairs = {pair_of("both", {"high"}, {"low"})};
  Solver<double> solver(scene);
  const Point before = momentum_of(solver, 2);
  run(solver);
  EXPECT_NEAR(momentum_of(solver, 2)[2], before[2], 1e-12 * before[2]);
  EXPECT_GT(solver.contact_pairs()[0].impulse[2], 0);
}

TEST_P(ContactPairs, AreBornAndDie) {
  Scene scene = with(two_blocks(3e-4), GetParam());
  scene.contact_pairs = {pair_of("both", {"high"}, {"low"})};
  scene.contact_pairs[0].end = 1.1e-4;  // while they press on each other
  Solver<double> solver(scene);
  double last = 0;
  while (!solver.at_end()) {
    const Energies before = solver.energies();
    solver.step();
    if (before.contact_stored > 0 && solver.energies().contact_stored == 0 && last == 0 &&
        solver.force_time() >= 1.1e-4) {  // what the springs held is counted when they end
      EXPECT_NEAR(solver.energies().contact_damped - before.contact_damped, before.contact_stored,
                  0.2 * before.contact_stored);
    }
    const PairResult& pair = solver.contact_pairs()[0];
    if (solver.force_time() >= 1.1e-4) {
      EXPECT_EQ(pair.force, Point{}) << solver.force_time();
      if (last == 0) last = pair.impulse[2];
      EXPECT_EQ(pair.impulse[2], last);
    }
  }
  EXPECT_GT(last, 0);
  scene.contact_pairs[0].end = never;
  scene.contact_pairs[0].start = 1;  // later than the run: they go through each other
  Solver<double> without(scene);
  const Point before = momentum_of(without, 1);
  run(without);
  EXPECT_NEAR(momentum_of(without, 1)[2], before[2], 1e-12 * std::abs(before[2]));
  EXPECT_EQ(without.contact_pairs()[0].force_max, 0);
}

/// The step at which a pair is born is that of its time: the forces of the step before are those without it.
TEST_P(ContactPairs, AreBornAtTheirStep) {
  Scene scene = with(two_blocks(2e-4), GetParam());
  scene.contact_pairs = {pair_of("both", {"high"}, {"low"})};
  scene.contact_pairs[0].start = 1.0e-4;
  Solver<double> solver(scene);
  bool acts = false;
  while (!solver.at_end() && !acts) {
    solver.step();
    acts = solver.contact_pairs()[0].force_max > 0;
    EXPECT_TRUE(!acts || solver.force_time() >= 1.0e-4);
  }
}

TEST_P(ContactPairs, OfWhichTheLastOneCounts) {
  Scene scene = with(two_blocks(), GetParam());
  scene.contact_pairs = {pair_of("one", {"high"}, {"low"}), pair_of("two", {"low"}, {"high"})};
  Solver<double> solver(scene);
  run(solver);
  EXPECT_EQ(solver.contact_pairs()[0].force_max, 0);
  EXPECT_LT(solver.contact_pairs()[1].impulse[2], 0) << "the force on low";
}

/// Saved while a pair lives and after it has died.
TEST_P(ContactPairs, GoOnFromASavedState) {
  Scene scene = with(two_blocks(2.4e-4), GetParam());
  scene.contact_pairs = {pair_of("one", {"high"}, {"low"}), pair_of("two", {"low"}, {"high"})};
  scene.contact_pairs[1].start = 0.5e-4;
  scene.contact_pairs[1].end = 1.2e-4;
  Solver<double> whole(scene);
  std::vector<StateBytes> states(3);
  for (std::size_t i = 0; i < states.size(); ++i) {
    while (whole.time() < (static_cast<double>(i) + 0.4) * 6e-5) whole.step();
    StateArchive::save(states[i], [&](StateArchive& archive) { whole.persist(archive); });
  }
  run(whole);
  for (const StateBytes& state : states) {
    DefaultExecutionSpace::set_concurrency(3);
    Solver<double> rest(scene);
    test::load(rest, state);
    run(rest);
    EXPECT_EQ(state_hash(rest.model()), state_hash(whole.model()));
    for (std::size_t p = 0; p < 2; ++p) {
      EXPECT_EQ(rest.contact_pairs()[p].impulse, whole.contact_pairs()[p].impulse);
      EXPECT_EQ(rest.contact_pairs()[p].force_max, whole.contact_pairs()[p].force_max);
    }
  }
  DefaultExecutionSpace::set_concurrency(1);
}

/// A body that may touch itself, as a pair without a second side, and one that may not, as it is in no such pair.
TEST(ContactPairsOfOneBody, AreThoseOfAFirstSideAlone) {
  Scene scene = with(two_blocks(), kinds[3]);
  scene.contact_pairs = {pair_of("all", {"low", "high"})};
  Solver<double> solver(scene);
  run(solver);
  EXPECT_GT(solver.contact_pairs()[0].force_max + 1, 0);
  EXPECT_EQ(solver.contact_pairs()[0].impulse, Point{}) << "both are on the first side";
  EXPECT_GT(solver.counts().pairs_max(), 0);
}

/// Two pairs of one scene have friction of their own.
TEST(ContactPairsWithFriction, HaveTheirOwn) {
  Scene scene = with(two_blocks(), kinds[3]);
  scene.contact_pairs = {pair_of("both", {"high"}, {"low"})};
  scene.bodies[1].velocity = {40, 0, -15};
  const auto tangential = [](Scene given, double friction) {
    given.contact_pairs[0].friction = given.contact_pairs[0].static_friction = friction;
    Solver<double> solver(given);
    run(solver);
    const Point p = solver.contact_pairs()[0].impulse;
    return p[0] / p[2];
  };
  EXPECT_NEAR(tangential(scene, 0.2), -0.2, 0.004) << "it slides all the time";
  EXPECT_NEAR(tangential(scene, 0.05), -0.05, 0.001);
  EXPECT_NEAR(tangential(scene, 0), 0, 1e-3) << "faces turn a little";
}

/// Rows slide at 4 m/s less what friction has stopped: the ratio is that of the velocity.
TEST(ContactPairsWithFriction, DecaysWithTheSpeed) {
  Scene scene = with(two_blocks(1.2e-4), kinds[3]);
  scene.bodies[1].velocity = {40, 0, -15};
  scene.contact_pairs = {pair_of("both", {"high"}, {"low"})};
  ContactPair& pair = scene.contact_pairs[0];
  pair.static_friction = 0.4;
  pair.friction = 0.1;
  pair.friction_decay = 0.05;
  Solver<double> solver(scene);
  int compared = 0;
  while (!solver.at_end()) {
    const double speed = velocity_of(solver, 0)[0];
    solver.step();
    const Point force = solver.contact_pairs()[0].force;
    if (!(force[2] > 0.5 * solver.contact_pairs()[0].force_max)) continue;
    ++compared;
    const double slides = body_results(solver)[1].velocity[0] - speed;
    EXPECT_NEAR(-force[0] / force[2], 0.1 + 0.3 * std::exp(-0.05 * slides), 0.02);
  }
  EXPECT_GT(compared, 3);
}

}  // namespace
}  // namespace pinball::contact_pairs_test

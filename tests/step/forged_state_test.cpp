#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <random>
#include <span>
#include <string>

#include <solver/base/state_archive.hpp>
#include <tests/support/saved_state.hpp>
#include <tests/support/solver_case.hpp>

/// A state whose checksum is right and whose numbers are not: it is refused, or the run goes on from it, fails or not;
/// never is memory read or written that is not its own, which the address sanitizer sees (preset debug), and never more
/// of it asked for than the state itself has. PINBALL_FORGE_ALL=1 changes every word of the states.
namespace pinball::forged_state_test {
namespace {

using namespace test;

/// What a word is replaced by.
enum class Forgery { zero, ones, random, next, next_high };

void forge(std::byte* word, Forgery how, std::mt19937_64& random) {
  std::uint64_t value = 0;
  std::memcpy(&value, word, sizeof value);
  switch (how) {
    case Forgery::zero:
      value = 0;
      break;
    case Forgery::ones:
      value = ~std::uint64_t(0);
      break;
    case Forgery::random:
      value = random();
      break;
    case Forgery::next:
      value += 1 + random() % 100;
      break;  // indices just beyond their bounds
    case Forgery::next_high:
      value += (1 + random() % 100) << 32U;
      break;
  }
  std::memcpy(word, &value, sizeof value);
}

/// Whether the state was taken. A run from it may end with what it says of itself.
template <class S>
bool goes_on(const Scene& scene, const StateBytes& state) {
  Solver<S> solver(scene);
  try {
    StateBytes again;
    test::load_any(solver, state, again);
  } catch (const InputError&) {
    return false;
  }
  try {
    for (int step = 0; step < 3 && !solver.at_end(); ++step) solver.step();
    solver.finish();
    RunSummary summary;
    fill_summary(solver, summary);
    snapshot(solver);
  } catch (const RunError&) {
  }
  return true;
}

template <class S>
void expect_no_harm(const Scene& scene, int steps, std::vector<std::size_t> to_erode = {}) {
  DefaultExecutionSpace::set_concurrency(1);
  StateBytes state;
  {
    Solver<S> solver(scene);
    for (int step = 0; step < steps; ++step) {
      if (step == steps / 2 && !to_erode.empty()) strain_to_failure(solver, to_erode);
      solver.step();
    }
    StateArchive::save(state, [&](StateArchive& archive) { solver.persist(archive); });
  }
  ASSERT_TRUE(goes_on<S>(scene, state));
  std::mt19937_64 random(11);
  const std::size_t stride = std::getenv("PINBALL_FORGE_ALL") != nullptr ? 1 : 29;
  int refused = 0, taken = 0;
  StateBytes forged(state.size());
  for (const Forgery how : {Forgery::zero, Forgery::ones, Forgery::random, Forgery::next, Forgery::next_high}) {
    for (std::size_t word = random() % stride; 8 * word + 8 <= state.size(); word += stride) {
      std::memcpy(forged.data(), state.data(), state.size());
      forge(forged.data() + 8 * word, how, random);
      SCOPED_TRACE("word " + std::to_string(word) + ", forgery " + std::to_string(static_cast<int>(how)));
      ASSERT_NO_THROW((goes_on<S>(scene, forged) ? taken : refused)++);
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_GT(taken, 0);
}

/// Counts of which sums and products would overflow. Of what is the number of steps none can be taken.
TEST(ForgedState, StepsThatNoRunMakesAreRefused) {
  constexpr std::int64_t steps = 37;
  const Scene scene = scene_of({block("a", {1, 1, 2}, 0.1, {0, 0, 0}, {0, 0, 1})}, 1e-2);
  StateBytes state;
  Solver<double> solver(scene);
  for (std::int64_t step = 0; step < steps; ++step) solver.step();
  StateArchive::save(state, [&](StateArchive& archive) { solver.persist(archive); });
  ASSERT_EQ(solver.clock().steps(), steps);
  int places = 0;
  for (std::size_t place = 0; place + 8 <= state.size(); ++place) {  // flags take a byte
    std::int64_t value = 0;
    std::memcpy(&value, state.data() + place, sizeof value);
    if (value != steps) continue;
    ++places;
    StateBytes forged(state.size());
    std::memcpy(forged.data(), state.data(), state.size());
    value = std::int64_t(1) << 60;  // of two elements
    std::memcpy(forged.data() + place, &value, sizeof value);
    EXPECT_FALSE(goes_on<double>(scene, forged)) << place;
  }
  EXPECT_GT(places, 0);
}

/// Blocks in impact, of a material that erodes.
Scene impact(ContactMethod method, Enforcement enforcement, ContactGap gap) {
  Scene scene = scene_of(
      {block("a", {3, 3, 3}, 0.1, {0, 0, 0}, {0, 0, 100}), block("b", {2, 3, 3}, 0.1, {0.03, 0.02, 0.302})}, 1e-4);
  scene.materials = {plastic_material("steel", 3e8, 0.5)};
  scene.contact.method = method;
  scene.contact.enforcement = enforcement;
  scene.contact.gap = gap;
  if (enforcement != Enforcement::penalty && gap == ContactGap::face) {
    scene.contact.friction = 0.1;
    scene.contact.static_friction = 0.1;
  }
  scene.element.bulk_viscosity = true;
  return scene;
}

const std::vector<std::size_t> some{13, 22};

TEST(ForgedState, PenaltyOfPinballs) {
  expect_no_harm<double>(impact(ContactMethod::pinball, Enforcement::penalty, ContactGap::pinball), 8, some);
}
TEST(ForgedState, PenaltyOfPresentPinballsInFloat) {
  Scene scene = impact(ContactMethod::pinball, Enforcement::penalty, ContactGap::pinball);
  scene.contact.radius = ContactRadius::current;
  expect_no_harm<float>(scene, 8);
}
TEST(ForgedState, ImpulsesOfPinballs) {
  expect_no_harm<double>(impact(ContactMethod::pinball, Enforcement::lagrange, ContactGap::pinball), 8, some);
}
TEST(ForgedState, ImpulsesBetweenFaces) {
  expect_no_harm<double>(impact(ContactMethod::pinball, Enforcement::lagrange, ContactGap::face), 8, some);
}
TEST(ForgedState, PenaltyOfTheSlideline) {
  expect_no_harm<double>(impact(ContactMethod::slideline, Enforcement::penalty, ContactGap::pinball), 8, some);
}
TEST(ForgedState, ImpulsesOfTheSlideline) {
  expect_no_harm<float>(impact(ContactMethod::slideline, Enforcement::projection, ContactGap::pinball), 8, some);
}
TEST(ForgedState, Boundary) {
  Scene scene = pressed_blocks(4e-4);
  scene.bodies[0].mesh = BlockMesh{{0.6, 0.5, 0.7}, {3, 2, 3}};
  expect_no_harm<double>(scene, 5);
}
TEST(ForgedState, SubcyclingAndRest) {
  Scene scene = scene_of(
      {block("a", {3, 3, 3}, 0.1, {0, 0, 0}, {0, 0, 100}), block("b", {6, 6, 3}, 0.02, {0.1, 0.1, 0.3002})}, 1e-4);
  scene.time.subcycling = true;
  expect_no_harm<double>(scene, 3);
  scene.time.subcycling = false;
  scene.skip.resting = true;
  expect_no_harm<double>(scene, 3);
}

}  // namespace
}  // namespace pinball::forged_state_test

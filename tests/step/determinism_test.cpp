#include <gtest/gtest.h>

#include <cmath>

#include <kernels/exec.hpp>
#include <tests/support/solver_case.hpp>

/// The same bits for any number of threads and from run to run.
namespace pinball::determinism_test {
namespace {

using namespace test;

void set_threads([[maybe_unused]] int threads) {
#if defined(_OPENMP)
  omp_set_num_threads(threads);
#endif
}

template <class S>
struct Outcome {
  std::uint64_t hash = 0;
  std::int64_t steps = 0, eroded = 0;
  Energies energy;
  std::int64_t searches = 0, skipped = 0;
};

template <class S>
Outcome<S> outcome(const Scene& scene, int threads) {
  set_threads(threads);
  Solver<S> solver(scene);
  run(solver);
  set_threads(1);
  return {state_hash(solver.model()),        solver.steps(),
          solver.counts().eroded_elements(), solver.energies(),
          solver.contact()->searches(),      solver.contact()->searches_skipped()};
}

template <class S>
void expect_same_bits(const Scene& scene) {
  const Outcome<S> one = outcome<S>(scene, 1);
  for (const int threads : {1, 2, 3, 8}) {
    const Outcome<S> other = outcome<S>(scene, threads);
    EXPECT_EQ(other.hash, one.hash) << threads << " threads";
    EXPECT_EQ(other.steps, one.steps);
    EXPECT_EQ(other.eroded, one.eroded);
    EXPECT_EQ(other.energy.total(), one.energy.total());  // sums too
    EXPECT_EQ(other.energy.internal, one.energy.internal);
    EXPECT_EQ(other.energy.external, one.energy.external);
    EXPECT_EQ(other.energy.contact_stored, one.energy.contact_stored);
    EXPECT_EQ(other.energy.contact_damped, one.energy.contact_damped);
  }
}

Scene rod_plate() {
  Scene scene = read_scene(find_scene("rod_plate"));
  scene.time.end = 16e-6;  // late enough for the first elements to erode
  return scene;
}

TEST(Determinism, BoundaryConditionsInDouble) { expect_same_bits<double>(pressed_blocks(6e-4)); }
TEST(Determinism, BoundaryConditionsWithImpulses) {
  Scene scene = pressed_blocks(6e-4);
  scene.contact.enforcement = Enforcement::lagrange;
  expect_same_bits<double>(scene);
}
TEST(Determinism, BoundaryConditionsInFloat) { expect_same_bits<float>(pressed_blocks(6e-4)); }
TEST(Determinism, TwoBlocksInDouble) { expect_same_bits<double>(read_scene(find_scene("two_blocks"))); }
TEST(Determinism, TwoBlocksInFloat) { expect_same_bits<float>(read_scene(find_scene("two_blocks"))); }

TEST(Determinism, RodPlateInDouble) {
  expect_same_bits<double>(rod_plate());
  EXPECT_GT(outcome<double>(rod_plate(), 1).eroded, 0) << "the test is to cover erosion";
}
TEST(Determinism, RodPlateInFloat) { expect_same_bits<float>(rod_plate()); }

TEST(Determinism, RodPlateByImpulses) {
  Scene scene = rod_plate();
  scene.contact.gap = ContactGap::face;
  for (const Enforcement enforcement : {Enforcement::projection, Enforcement::lagrange}) {
    scene.contact.enforcement = enforcement;
    expect_same_bits<double>(scene);
    expect_same_bits<float>(scene);
  }
}

TEST(Determinism, ThousandsOfRowsOfImpulses) {
  Scene scene = wide_blocks(1e-5);  // a few steps, each of hundreds of iterations
  {
    Solver<double> solver(scene);
    run(solver);
    EXPECT_GT(solver.counts().pairs_max(), 1000) << "enough for more than one thread";
  }
  expect_same_bits<double>(scene);
  expect_same_bits<float>(scene);
  scene.contact.friction = scene.contact.static_friction = 0;
  expect_same_bits<double>(scene);
  scene.contact.enforcement = Enforcement::projection;
  expect_same_bits<double>(scene);
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::pinball;
  scene.contact.friction = scene.contact.static_friction = 0.1;
  expect_same_bits<double>(scene);
}

TEST(Determinism, RodPlateBySlideline) {
  Scene scene = rod_plate();
  scene.contact.method = ContactMethod::slideline;
  for (const Enforcement enforcement : {Enforcement::penalty, Enforcement::projection, Enforcement::lagrange}) {
    scene.contact.enforcement = enforcement;
    expect_same_bits<double>(scene);
  }
  expect_same_bits<float>(scene);
}

// A search at every step lists other pairs than one that is to last for many steps, but the same ones touch, and their
// forces are summed in the same order. Energies are summed over pieces of the list, which may differ.
template <class S>
void expect_same_run(Scene scene) {
  const Outcome<S> kept = outcome<S>(scene, 1);
  scene.skip.contact_search = false;
  const Outcome<S> searched = outcome<S>(scene, 1);
  EXPECT_GT(kept.skipped, 0);
  EXPECT_EQ(searched.skipped, 0);
  EXPECT_EQ(searched.searches, kept.searches + kept.skipped);
  EXPECT_EQ(searched.hash, kept.hash);
  EXPECT_EQ(searched.steps, kept.steps);
  EXPECT_EQ(searched.eroded, kept.eroded);
  const double scale = std::abs(kept.energy.total()) * 1e-12;
  EXPECT_NEAR(searched.energy.kinetic, kept.energy.kinetic, scale);
  EXPECT_NEAR(searched.energy.internal, kept.energy.internal, scale);
  EXPECT_NEAR(searched.energy.hourglass, kept.energy.hourglass, scale);
  EXPECT_NEAR(searched.energy.contact_stored, kept.energy.contact_stored, scale);
  EXPECT_NEAR(searched.energy.contact_damped, kept.energy.contact_damped, scale);
  EXPECT_NEAR(searched.energy.eroded, kept.energy.eroded, scale);
}

TEST(SkippedSearches, ChangeNothingInTwoBlocks) { expect_same_run<double>(read_scene(find_scene("two_blocks"))); }
TEST(SkippedSearches, ChangeNothingInRodPlate) { expect_same_run<double>(rod_plate()); }
TEST(SkippedSearches, ChangeNothingByImpulses) {
  Scene scene = rod_plate();
  scene.contact.gap = ContactGap::face;
  scene.contact.enforcement = Enforcement::lagrange;
  expect_same_run<double>(scene);
}
TEST(SkippedSearches, ChangeNothingWithCurrentRadii) {
  Scene scene = rod_plate();
  scene.contact.radius = ContactRadius::current;
  expect_same_run<double>(scene);
}
TEST(SkippedSearches, ChangeNothingBySlideline) {
  Scene scene = rod_plate();
  scene.contact.method = ContactMethod::slideline;
  expect_same_run<double>(scene);
}

}  // namespace
}  // namespace pinball::determinism_test

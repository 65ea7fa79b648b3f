#include <thread>

#include "embedding_case.hpp"

/// Embedded contact and the solver's give the same bits, whatever the layout, the threads, and what else runs.
namespace pinball::embedded_bits_test {
namespace {

using namespace test;

struct Kind {
  const char* name;
  ContactMethod method;
  Enforcement enforcement;
  ContactGap gap;
};

const Kind pinball_penalty{"PinballPenalty", ContactMethod::pinball, Enforcement::penalty, ContactGap::pinball};
const Kind pinball_lagrange{"PinballLagrange", ContactMethod::pinball, Enforcement::lagrange, ContactGap::face};
const Kind slideline_penalty{"SlidelinePenalty", ContactMethod::slideline, Enforcement::penalty, ContactGap::face};

class EmbeddedBits : public testing::TestWithParam<Kind> {
 protected:
  Scene scene() const { return breaking_plate(GetParam().method, GetParam().enforcement, GetParam().gap); }
};

INSTANTIATE_TEST_SUITE_P(
    All, EmbeddedBits,
    testing::Values(pinball_penalty, pinball_lagrange, slideline_penalty,
                    Kind{"PinballProjection", ContactMethod::pinball, Enforcement::projection, ContactGap::pinball},
                    Kind{"SlidelineLagrange", ContactMethod::slideline, Enforcement::lagrange, ContactGap::face}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_P(EmbeddedBits, AreThoseOfTheSolver) {
  const Scene whole = scene();
  Solver<double> solver(whole);
  EmbeddingHost<double> host(whole);
  std::int64_t touching_steps = 0;
  while (!solver.at_end()) {
    solver.step();
    host.step(solver.dt());
    const auto& result = host.result();
    ASSERT_EQ(host.state(), EmbeddingHost<double>::state_of(solver.model())) << "step " << solver.steps();
    ASSERT_EQ(result.pairs, solver.counts().pairs());
    ASSERT_EQ(result.stored, solver.energies().contact_stored);
    ASSERT_EQ(result.dissipated, solver.energies().contact_damped);
    ASSERT_EQ(result.surface_elements, solver.contact()->surface_elements());
    ASSERT_EQ(result.frequency2 > 0, result.pairs > 0 && whole.contact.enforcement == Enforcement::penalty);
    touching_steps += result.pairs > 0;
  }
  EXPECT_GT(touching_steps, 10);
  EXPECT_GT(host.eroded_elements(), 10);
  EXPECT_EQ(host.result().searches, solver.contact()->searches());
  EXPECT_EQ(host.result().searches_skipped, solver.contact()->searches_skipped());
  EXPECT_GT(host.result().searches, 3);
}

/// The state after some steps of one length, in which elements erode.
template <class S, class Index = std::int32_t>
std::vector<S> outcome(const Scene& scene, Layout layout, std::int32_t first_index = 0, std::int32_t threads = 1) {
  EmbeddingHost<S, Index> host(scene, layout, first_index, threads);
  std::int64_t pairs = 0;
  for (int i = 0; i < 60; ++i) {
    host.step(2e-6);
    pairs += host.result().pairs;
  }
  EXPECT_GT(pairs, 0);
  EXPECT_GT(host.eroded_elements(), 0);
  return host.state();
}

TEST_P(EmbeddedBits, DoNotDependOnTheLayout) {
  const std::vector<double> records = outcome<double>(scene(), Layout::records);
  EXPECT_EQ(outcome<double>(scene(), Layout::interleaved), records);
  EXPECT_EQ(outcome<double>(scene(), Layout::separate), records);
  EXPECT_EQ((outcome<double, std::int64_t>(scene(), Layout::interleaved)), records);
  EXPECT_EQ(outcome<double>(scene(), Layout::separate, 1), records);
}

TEST_P(EmbeddedBits, OfFloatsDoNotDependOnTheLayout) {
  const std::vector<float> records = outcome<float>(scene(), Layout::records);
  EXPECT_EQ(outcome<float>(scene(), Layout::interleaved), records);
  EXPECT_EQ((outcome<float, std::int64_t>(scene(), Layout::separate, 1)), records);
}

TEST_P(EmbeddedBits, DoNotDependOnTheThreads) {
  const std::vector<double> one = outcome<double>(scene(), Layout::interleaved, 0, 1);
  for (const std::int32_t threads : {2, 3, 8}) {
    EXPECT_EQ(outcome<double>(scene(), Layout::interleaved, 0, threads), one) << threads << " threads";
  }
  EXPECT_EQ(DefaultExecutionSpace::concurrency(), 1) << "that of the caller is left alone";
}

TEST(EmbeddedInstances, InTwoThreadsGiveTheSameBitsAsOneAfterTheOther) {
  const auto scene_of_kind = [](const Kind& kind) { return breaking_plate(kind.method, kind.enforcement, kind.gap); };
  const Scene first = scene_of_kind(pinball_penalty), second = scene_of_kind(pinball_lagrange);
  const auto run = [](const Scene& scene) { return outcome<double>(scene, Layout::interleaved, 0, 2); };
  const std::vector<double> of_first = run(first), of_second = run(second);
  std::vector<double> beside_first, beside_second, same_as_first;
  std::thread a([&] { beside_first = run(first); });
  std::thread b([&] { beside_second = run(second); });
  std::thread c([&] { same_as_first = run(first); });
  a.join();
  b.join();
  c.join();
  EXPECT_EQ(beside_first, of_first);
  EXPECT_EQ(beside_second, of_second);
  EXPECT_EQ(same_as_first, of_first);
  EXPECT_NE(of_first, of_second);
}

/// The first step has none before it to tell how much closes in one, and a host may make a longer one at any time.
TEST(EmbeddedSteps, SeeWhatClosesInOneThatIsLongerThanTheLast) {
  const double h = 0.1, speed = 1000;
  for (const int before : {0, 2}) {
    Scene scene = scene_of(
        {block("a", {3, 3, 3}, h, {0, 0, 0}), block("b", {2, 2, 2}, h, {0.4 * h, 0.3 * h, 3.05 * h}, {0, 0, -speed})},
        1);
    scene.contact = ContactSettings();
    scene.contact.method = ContactMethod::pinball;
    scene.contact.gap = ContactGap::face;
    EmbeddingHost<double> host(scene);
    const double longer = 0.1 * h / speed;
    double deepest = 0;
    for (int i = 0; i < before + 4; ++i) {
      host.step(i < before ? 1e-3 * longer : longer);
      deepest = std::max(deepest, host.result().penetration_ratio);
    }
    EXPECT_LT(deepest, 1e-3) << "steps before: " << before;
    EXPECT_GT(host.result().pairs, 0);
  }
}

TEST(EmbeddedErosion, OpensTheSurfaceBehindDeadElements) {
  // A block rests against a target, whose upper layer the host takes away.
  const double h = 0.1;
  Scene scene = scene_of({block("target", {4, 4, 4}, h, {0, 0, 0}),
                          block("block", {2, 2, 2}, h, {0.1, 0.1, (4 + touching_gap) * h}, {0, 0, -50})},
                         1);
  EmbeddingHost<double> host(scene);
  for (int i = 0; i < 10; ++i) host.step(1e-6);
  EXPECT_EQ(host.result().surface_elements, 64 - 8 + 8);
  EXPECT_GT(host.result().pairs, 0);
  const double stored = host.result().stored;
  EXPECT_GT(stored, 0);
  EXPECT_EQ(host.result().eroded, 0);
  for (std::size_t e = 48; e < 64; ++e) host.erode(e);
  host.step(1e-6);
  EXPECT_EQ(host.result().surface_elements, 48 - 4 + 8);
  EXPECT_EQ(host.result().pairs, 0);
  EXPECT_EQ(host.result().stored, 0);
  EXPECT_NEAR(host.result().eroded, stored, 1e-12 * stored);
  // The layer below is there: what comes down on it is stopped.
  int steps = 0;
  while (host.result().pairs == 0 && steps < 3000) {
    host.step(2e-6);
    ++steps;
  }
  EXPECT_GT(host.result().pairs, 0);
  EXPECT_NEAR(steps * 2e-6, h / 50, 0.1 * h / 50) << "it has gone on for the height of a layer";
}

}  // namespace
}  // namespace pinball::embedded_bits_test

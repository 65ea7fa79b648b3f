#include <solver/simulation.hpp>

#include "trial.hpp"

/// Settings that may not change results, and those that have to be refused.
namespace pinball::settings_trial_test {
namespace {

using namespace test;

class SettingsTrial : public TrialTest {};
INSTANTIATE_TEST_SUITE_P(All, SettingsTrial, testing::ValuesIn(variants), variant_name);

Scene two_blocks(const Variant& variant) { return with_contact(read_scene(find_scene("two_blocks")), variant); }

/// Velocity of the upper block after the impact [m/s].
double velocity_after(const Scene& scene) {
  Solver<double> solver(scene);
  run_to_end(solver);
  return motion_of_body(solver, 1).velocity()[2];
}

TEST_P(SettingsTrial, LargerBallsChangeNothing) {
  if (GetParam().method == ContactMethod::pinball && GetParam().gap == ContactGap::pinball) {
    GTEST_SKIP() << "balls that touch are the contact itself";
  }
  also_holds({"slideline_penalty", "slideline_projection", "slideline_lagrange"});
  Scene scene = two_blocks(GetParam());
  const double reference = velocity_after(scene);
  for (const double factor : {0.5, 2.0, 3.0, 5.0}) {
    scene.contact.radius_factor = factor;
    const std::string trial = fmt::format("two_blocks, radius_factor {}, velocity", factor);
    compare(trial, run_of(trial, [&] { return velocity_after(scene); }), reference, 1e-6 * std::abs(reference));
  }
  scene.contact.radius_factor = 1;
  for (const double skin : {0.0, 0.1, 3.0}) {
    scene.contact.skin = skin;
    const std::string trial = fmt::format("two_blocks, skin {}, velocity", skin);
    compare(trial, run_of(trial, [&] { return velocity_after(scene); }), reference, 1e-6 * std::abs(reference));
  }
}

TEST_P(SettingsTrial, NumbersWithoutMeaningAreRefused) {
  const auto refused = [&](double ContactSettings::*number, double value) {
    Scene scene = two_blocks(GetParam());
    scene.contact.*number = value;
    try {
      const Simulation simulation(scene);
    } catch (const InputError&) {
      return 1.0;
    }
    return 0.0;
  };
  at_least("radius_factor 1e50 is refused", refused(&ContactSettings::radius_factor, 1e50), 1);
  at_least("skin 1e100 is refused", refused(&ContactSettings::skin, 1e100), 1);
}

}  // namespace
}  // namespace pinball::settings_trial_test

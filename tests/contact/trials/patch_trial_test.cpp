#include <array>

#include "trial.hpp"

/// Contact patch test (data/scenes/contact_patch.toml): blocks whose flat meshes do not fit are pressed together; the
/// stress is the same everywhere.
namespace pinball::patch_trial_test {
namespace {

using namespace test;

class PatchTrial : public TrialTest {};
INSTANTIATE_TEST_SUITE_P(All, PatchTrial, testing::ValuesIn(variants), variant_name);

struct Meshes {
  const char* name;
  std::array<int, 3> lower, upper;  ///< elements of blocks of 1 x 1 x 0.5
  double bound;
};
constexpr Meshes meshes[] = {{"cubes", {4, 4, 2}, {5, 5, 3}, 0.01},      {"flat 4:1", {4, 4, 8}, {5, 5, 10}, 0.01},
                             {"flat 8:1", {4, 4, 16}, {5, 5, 20}, 0.01}, {"tall 1:2", {4, 4, 1}, {5, 5, 1}, 0.01},
                             {"sizes 3.5", {2, 2, 1}, {7, 7, 3}, 0.05},  {"sizes 4", {2, 2, 1}, {8, 8, 4}, 0.05}};

/// How far the ball of an element of the block reaches out of its upper or lower face; below 0 if it does not.
double reach_of_ball(const std::array<int, 3>& elements) {
  const double volume = 0.5 / elements[0] / elements[1] / elements[2];
  return std::cbrt(3 * volume / (4 * M_PI)) - 0.25 / elements[2];
}

double worst_stress(const Meshes& m, const Variant& variant) {
  const auto half_block = [](const std::string& name, const std::array<int, 3>& elements, double z) {
    Body body;
    body.name = name;
    body.material = "steel";
    body.mesh = BlockMesh{{1, 1, 0.5}, elements};
    body.position = {0, 0, z};
    return body;
  };
  const double balls = std::max(0.0, reach_of_ball(m.lower)) + std::max(0.0, reach_of_ball(m.upper));
  const double gap = 0.01 + (variant.gap == ContactGap::pinball ? balls : 0);
  Scene scene = trial_scene({half_block("lower", m.lower, 0), half_block("upper", m.upper, 0.5 + gap)}, 20);
  scene.contact.self = false;
  scene.materials[0].density = 1;
  scene.materials[0].bulk_modulus = 1 / (3 * (1 - 2 * 0.3));
  scene.materials[0].shear_modulus = 1 / (2 * (1 + 0.3));
  scene.damping.mass = 3;
  scene.constraints = {{{0, 0, 0}, {1, 0, 0}, ""}, {{0, 0, 0}, {0, 1, 0}, ""}};
  scene.fixed_constraints = {held_at("lower", 0)};
  scene.fixed_constraints[0].directions = {{0, 0, 1}};
  NodalLoad load;
  load.nodes.body = "upper";
  load.nodes.plane = Plane{{0, 0, 1 + gap}, {0, 0, 1}};
  load.force = {0, 0, -0.01};
  scene.loads = {load};
  Solver<double> solver(with_contact(scene, variant));
  run_to_end(solver);
  double mean = 0, worst = 0;
  const auto count = static_cast<std::size_t>(solver.element_count());
  for (std::size_t e = 0; e < count; ++e) mean += stress_of(solver, e)[2] / static_cast<double>(count);
  if (std::abs(mean / -0.01 - 1) > 0.5) return 1e3;  // not pressed together
  for (std::size_t e = 0; e < count; ++e) worst = std::max(worst, std::abs(stress_of(solver, e)[2] / mean - 1));
  return worst;
}

TEST_P(PatchTrial, PressureIsTheSameEverywhere) {
  for (const Meshes& m : meshes) {
    const std::string trial = fmt::format("patch test, {}, worst stress", m.name);
    at_most(trial, run_of(trial, [&] { return worst_stress(m, GetParam()); }), m.bound);
  }
}

}  // namespace
}  // namespace pinball::patch_trial_test

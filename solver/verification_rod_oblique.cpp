#include <algorithm>
#include <cmath>
#include <pinball/solver/verification.hpp>

/// The report's problem 4, an oblique rod: what is left of it.
namespace pinball {

namespace {

struct Outcome {
  double balance_error = 0;   ///< largest
  double momentum_drift = 0;  ///< along the plane of symmetry, relative
  double mass_left = 0;       ///< of the rod, relative
};

Outcome run_rod(const Scene& scene) {
  Solver<double> solver(scene);
  const Point before = solver.momentum();
  Outcome result;
  run_to_end(solver, [&] { result.balance_error = std::max(result.balance_error, std::abs(solver.balance_error())); });
  const Point after = solver.momentum();
  const double scale = std::hypot(before[0], before[2]);
  result.momentum_drift = std::max(std::abs(after[0] - before[0]), std::abs(after[2] - before[2])) / scale;
  const BodyResult rod = solver.history_row().bodies[0];
  result.mass_left = rod.mass_remaining / rod.mass_initial;
  return result;
}

}  // namespace

std::vector<VerificationRow> verify_rod_oblique(const Scene& scene) {
  const Outcome penalty = run_rod(scene);
  Scene old = scene;
  old.contact.method = ContactMethod::slideline;
  old.contact.enforcement = Enforcement::projection;
  const Outcome slideline = run_rod(old);
  SceneOverrides finer;
  finer.set = {"contact.enforcement=lagrange"};
  finer.refine = 2;
  const Outcome lagrange = run_rod(read_scene(scene.path, finer));
  return {
      compare_with_zero("penalty: drift of momentum", penalty.momentum_drift, 1e-10, "conservation"),
      compare_with_zero("penalty: largest error of the energy balance", penalty.balance_error, 1e-2, "conservation"),
      compare_with_zero("slideline, projection: drift of momentum", slideline.momentum_drift, 1e-10, "conservation"),
      compare_with_zero("slideline, projection: largest error of the energy balance", slideline.balance_error, 1e-3,
                        "conservation"),
      compare_with_zero("lagrange, --refine 2: drift of momentum", lagrange.momentum_drift, 1e-10, "conservation"),
      compare_with_zero("lagrange, --refine 2: largest error of the energy balance", lagrange.balance_error, 1e-3,
                        "conservation"),
      // Ten points. The shot is little above the ballistic limit, and mass is lost by erosion alone: README, the
      // oblique rod.
      compare("lagrange, --refine 2: mass of the rod left / initial", lagrange.mass_left, 0.42, 0.10 / 0.42,
              "report, problem 4"),
  };
}

}  // namespace pinball

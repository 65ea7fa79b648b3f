#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cases.hpp"
#include "solver_run.hpp"

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
  const BodyResult rod = history_row(solver).bodies[number_of_body(scene, "rod")];
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
  // The shot is little above the ballistic limit, and round-off decides which elements erode: of twelve runs that
  // differ in the length of the step alone, eleven rods dig in and leave 46 to 51 % of the mass, one is thrown off with
  // 67 %. So the median stands for them.
  Outcome lagrange;
  std::vector<double> mass_left;
  for (const char* fraction : {"0.90", "0.89", "0.88", "0.87", "0.86"}) {
    SceneOverrides finer;
    finer.set = {"contact.enforcement=lagrange", std::string("time.cfl=") + fraction};
    finer.refine = 2;
    const Outcome one = run_rod(read_scene(scene.path, finer));
    lagrange.balance_error = std::max(lagrange.balance_error, one.balance_error);
    lagrange.momentum_drift = std::max(lagrange.momentum_drift, one.momentum_drift);
    mass_left.push_back(one.mass_left);
  }
  std::nth_element(mass_left.begin(), mass_left.begin() + 2, mass_left.end());
  lagrange.mass_left = mass_left[2];
  return {
      compare_with_zero("penalty: drift of momentum", penalty.momentum_drift, 1e-10, "conservation"),
      compare_with_zero("penalty: largest error of the energy balance", penalty.balance_error, 1e-2, "conservation"),
      compare_with_zero("slideline, projection: drift of momentum", slideline.momentum_drift, 1e-10, "conservation"),
      compare_with_zero("slideline, projection: largest error of the energy balance", slideline.balance_error, 1e-3,
                        "conservation"),
      compare_with_zero("lagrange, --refine 2: drift of momentum", lagrange.momentum_drift, 1e-10, "conservation"),
      compare_with_zero("lagrange, --refine 2: largest error of the energy balance", lagrange.balance_error, 1e-3,
                        "conservation"),
      // Ten points: docs/accuracy.md.
      compare("lagrange, --refine 2: mass of the rod left / initial, median of five", lagrange.mass_left, 0.42,
              0.10 / 0.42, "report, problem 4"),
  };
}

}  // namespace pinball

#include <fmt/core.h>

#include "cases.hpp"
#include "solver_run.hpp"

/// Verification of failure: a projectile shears a plug out of a plate and flies on, or is stopped, against tests.
namespace pinball {

namespace {

struct Shot {
  double velocity = 0;       ///< of the projectile at the end, the way it came [length/time]
  double balance_error = 0;  ///< largest
};

Shot shoot(const Scene& scene, double velocity) {
  Scene one = scene;
  one.bodies[0].velocity = {0, 0, -velocity};
  Solver<double> solver(one);
  run_to_end(solver);
  RunSummary summary;
  fill_summary(solver, summary);
  return {-summary.bodies[0].velocity[2], summary.balance_error_max};
}

/// Between a projectile that is stopped, or has a twentieth of its velocity left, and one that is not.
double ballistic_limit(const Scene& scene, double low, double high, double width) {
  while (high - low > width) {
    const double middle = (low + high) / 2;
    (shoot(scene, middle).velocity > 0.05 * middle ? high : low) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

std::vector<VerificationRow> verify_perforated_plate(const Scene& scene) {
  const std::string tests = "tests: Boervik and others 2002";
  const struct {
    double before, after;  ///< the plate, in the tests [m/s]
  } shots[] = {{303.5, 199.7}, {244.2, 132.6}};
  std::vector<VerificationRow> rows;
  // The mesh decides (docs/accuracy.md): elements of half the size leave 5 and 15 % too much of these velocities, and a
  // limit that is 2 % too low; those of twice the size one that is 30 % too high.
  for (const auto& [before, after] : shots) {
    const Shot shot = shoot(scene, before);
    rows.push_back(compare(fmt::format("velocity after the plate [m/s], {:g} before it", before), shot.velocity, after,
                           0.05, tests));
    rows.push_back(compare_with_zero(fmt::format("largest error of the energy balance, {:g} m/s", before),
                                     shot.balance_error, 1e-3, "conservation"));
  }
  rows.push_back(compare("ballistic limit [m/s], within 2", ballistic_limit(scene, 160, 224, 4), 184.5, 0.12, tests));
  return rows;
}

}  // namespace pinball

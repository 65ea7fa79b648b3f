#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <solver/scene.hpp>
#include <solver/step/solver.hpp>

/// Verification: scenes whose answer is known exactly, or from an independent source, run through the library and
/// compared with it. Tolerances are justified where they are set.
namespace pinball {

/// One comparison. `error` is relative to the reference where that is not zero, else absolute; `pass` is error <=
/// tolerance, false for a value that is not finite.
struct VerificationRow {
  std::string scene;
  std::string quantity;  ///< with its unit
  double value = 0.0;
  double reference = 0.0;
  std::string source;  ///< where the reference comes from
  double error = 0.0;
  double tolerance = 0.0;
  bool pass = false;
};

/// Compares with a reference other than 0, relatively.
VerificationRow compare(const std::string& quantity, double value, double reference, double tolerance,
                        const std::string& source);

/// Compares something that is exactly 0: a drift, a residual, already divided by its scale.
VerificationRow compare_with_zero(const std::string& quantity, double value, double tolerance,
                                  const std::string& source);

/// A scene of data/scenes and what is checked in it.
struct VerificationCase {
  std::string scene;
  std::vector<VerificationRow> (*run)(const Scene& scene);
};

const std::vector<VerificationCase>& verification_cases();

/// Runs one case; a run that fails becomes a row that does not pass.
std::vector<VerificationRow> verify_scene(const VerificationCase& verification);

/// To the end of the scene, with everything brought to one time; calls `after_step` after each step.
void run_to_end(
    Solver<double>& solver, const std::function<void()>& after_step = [] {});

/// Moves nodes along a path that is known beforehand: after each step their positions are those of the path, their
/// velocities those that lead from one position to the next. The solver then computes strains, stresses and the forces
/// on the remaining nodes. The work that this takes is in no energy: the scene's guard.energy_error must be wide.
class PrescribedMotion {
 public:
  /// Place at a time of the node that began at `start`.
  using Path = std::function<Point(const Point& start, double time)>;

  /// nodes: of the scene; empty: all.
  PrescribedMotion(Solver<double>& solver, Path path, std::vector<std::int32_t> nodes = {});

  /// One step of the solver, then the prescribed nodes are put in their places.
  void step();

 private:
  Solver<double>& solver_;
  Path path_;
  std::vector<std::int32_t> nodes_;
};

/// Stress of an element of the scene: xx yy zz xy yz zx.
std::array<double, 6> stress_of(const Solver<double>& solver, std::size_t element);

/// Position and velocity of a node of the scene, as the store has them.
Point position_of(const Solver<double>& solver, std::size_t node);
Point velocity_of(const Solver<double>& solver, std::size_t node);

// The cases, one function per scene.
std::vector<VerificationRow> verify_block(const Scene& scene);
std::vector<VerificationRow> verify_cantilever(const Scene& scene);
std::vector<VerificationRow> verify_patch_test(const Scene& scene);
std::vector<VerificationRow> verify_plate_impact(const Scene& scene);
std::vector<VerificationRow> verify_refined_layer(const Scene& scene);
std::vector<VerificationRow> verify_rod_oblique(const Scene& scene);
std::vector<VerificationRow> verify_rod_plate(const Scene& scene);
std::vector<VerificationRow> verify_sphere_sphere(const Scene& scene);
std::vector<VerificationRow> verify_sphere_wall(const Scene& scene);
std::vector<VerificationRow> verify_sphere_wall_full(const Scene& scene);
std::vector<VerificationRow> verify_spinning_block(const Scene& scene);
std::vector<VerificationRow> verify_taylor_bar(const Scene& scene);
std::vector<VerificationRow> verify_taylor_plate(const Scene& scene);
std::vector<VerificationRow> verify_two_bars(const Scene& scene);
std::vector<VerificationRow> verify_two_blocks(const Scene& scene);
std::vector<VerificationRow> verify_uniaxial_strain(const Scene& scene);

}  // namespace pinball

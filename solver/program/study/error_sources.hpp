#pragma once

#include <string>
#include <vector>

#include <solver/scene.hpp>

namespace pinball {

/// What may move a number beside the mesh.
enum class ErrorSource { step, precision, hourglass, chance };

/// Runs of one scene that say what a source does.
struct SourceVariation {
  ErrorSource source;
  std::string name;           ///< "time step", "hourglass stiffness", "chance"
  std::string what;           ///< "time.cfl = 0.45"
  std::string folder;         ///< of its run; of chance before the number of the run
  std::vector<Scene> scenes;  ///< one; of chance as many as the ensemble has
};

/// The scene with half the step (and half of time.smallest_step, so that masses stay), in the other precision, with
/// each other hourglass control, and `ensemble` times with initial velocities that differ by parts of 1e-9 (of single
/// precision: 1e-5), the k-th by k such parts: noise on all nodes, of the largest speed that the scene gives, or of a
/// thousandth of the speed of waves where all is at rest; what is given to some nodes is multiplied.
std::vector<SourceVariation> vary_sources(const Scene& scene, const std::vector<ErrorSource>& sources, int ensemble);

}  // namespace pinball

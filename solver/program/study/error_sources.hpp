#pragma once

#include <string>
#include <vector>

#include <solver/scene.hpp>

namespace pinball {

/// What may move a number beside the mesh.
enum class ErrorSource { step, precision, hourglass, contact, chance, body };

/// Runs of one scene that say what a source does.
struct SourceVariation {
  ErrorSource source;
  std::string name;           ///< "time step", "hourglass stiffness", "chance"
  std::string what;           ///< "time.cfl = 0.45"
  std::string folder;         ///< of its run; of chance before the number of the run
  std::vector<Scene> scenes;  ///< one; of chance as many as the ensemble has
};

/// The scene with half the step (and half of time.smallest_step, so that masses stay), in each other precision, with
/// each other hourglass control, with the contact of the defaults and a slideline where it has another and its friction
/// allows them, and `ensemble` times with initial velocities that differ by parts of 1e-9 (of single precision: 1e-5),
/// the k-th by k such parts: noise on all nodes, of the largest speed that the scene gives, or of a thousandth of the
/// speed of waves where all is at rest; what is given to some nodes is multiplied.
std::vector<SourceVariation> vary_sources(const Scene& scene, const std::vector<ErrorSource>& sources, int ensemble);

/// A body that has more elements alone, so many times in each direction.
struct RefinedBody {
  std::string body;
  int times = 2;
};

/// "plate 2 times finer", of its source.
std::string name_of(const RefinedBody& body);

/// "plate=2". Throws InputError that names --refine where it is no name with a number of 2 and more.
RefinedBody parse_refined_body(const std::string& text);

/// The scene with each of the bodies refined and the others as they are. Throws InputError for a body that the scene
/// has not, that shares the nodes of a file with others, or whose mesh takes no such factor.
std::vector<SourceVariation> vary_bodies(const Scene& scene, const std::vector<RefinedBody>& bodies);

}  // namespace pinball

#pragma once

#include <string>

#include <solver/model/model.hpp>

/// What the meshes and materials of a scene show of its numbers before the first step.
namespace pinball {

/// The element that would set the step of a run.
struct SmallestStep {
  double step = std::numeric_limits<double>::infinity();  ///< that it is stable with [time]
  std::int64_t element = 0;
  /// By what an element of which one side stops raises its stable rate 2/dt over the closing speed, at most: by its
  /// bulk viscosity, and because it is stiffer as it is compressed [1/length].
  double rate_of_closing = 0;
};

/// Throws InputError for a time.end that no number of stable steps reaches, and for a damping.mass of which one stable
/// step makes nonsense: beyond 2/dt it turns every motion round and enlarges it.
///
/// longest_impact_step: StepClock::longest_impact_step [time]
///
/// Returns the smallest stable step of all elements that deform, infinite where none does.
SmallestStep check_against_steps(const Scene& scene, const ModelMesh& mesh, double longest_impact_step);

/// A sentence on a run of a million steps or more; else empty.
std::string find_many_steps(const Scene& scene, const ModelMesh& mesh, const SmallestStep& smallest);

/// A sentence on the material of which erosion.smallest_step takes most elements in the first step already, since their
/// stable steps are below it; empty where there is none.
std::string find_eroded_at_start(const Scene& scene, const ModelMesh& mesh);

/// A sentence on the hourglass_coefficient that is furthest beyond what the steps allow, of [element] or of a body;
/// empty where none is.
///
/// The viscous form damps the hourglass modes of an element at the rate d = 64 k c A/V (theory.md, 4.4; 64 k c/h for a
/// cube), which lagged is stable up to d dt = 2:
///
///     k <= V / (32 c A dt) ,      0.047 for a cube at nu = 0.3 and time.cfl = 0.9 .
///
/// LS-DYNA and others name QH = 4 k. The other two forms have frequencies of at most that of the material at a
/// coefficient of 1, and are sure to be stable up to 1/cfl^2.
std::string find_unstable_hourglass(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball

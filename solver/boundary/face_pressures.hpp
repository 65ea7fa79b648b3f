#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/model/model.hpp>
#include <solver/results.hpp>

#include "cycle_mean.hpp"
#include "space/boundary_kernels.hpp"

namespace pinball {

/// Pressure on faces of elements ([[pressure]]), against the outward normals of where they are now.
/// (kernels/boundary/face_pressure.hpp).
template <class S>
class FacePressures {
 public:
  /// Throws InputError for a pressure without faces.
  FacePressures(const Model<S>& model, const BoundaryKernels<S>& kernels);

  bool any() const { return !loads_.empty(); }

  /// Adds the forces of the present places to those of the nodes, but for faces of eroded elements; time: of the
  /// forces; begins_cycle: the step is the first of its cycle.
  void apply(const NodeArrays<S>& nodes, double time, const StepLengths& step, bool begins_cycle);
  /// Work of the forces that apply() has added; to be called when all forces are known.
  ExternalWork work(const NodeArrays<S>& nodes, const StepLengths& step);

  void persist(StateArchive& archive);
  /// Forces are means over the steps of the cycle, up to the last one made.
  std::vector<PressureResult> results() const;
  std::size_t bytes() const;

 private:
  struct Load {
    Pressure given;
    std::unique_ptr<PressureKernels<S>> faces;
    bool acts = false;                 ///< at the time of the forces
    std::array<CycleMean, 3> cycle{};  ///< of the force
    double done = 0;                   ///< work of all steps before the last
    ExternalWork last;
    std::optional<Point> force_read;  ///< with a state, up to its next step [force]
  };
  static Point force_of_step(const Load& load);
  static Point mean_force(const Load& load);
  std::vector<Load> loads_;
};

}  // namespace pinball

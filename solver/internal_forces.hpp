#pragma once

#include <cstdint>
#include <pinball/solver/model.hpp>
#include <pinball/solver/tile_kernels.hpp>
#include <vector>

namespace pinball {

/// Work of the whole mesh in one step.
template <class S>
struct InternalForceResult {
  double internal = 0, hourglass = 0, viscous = 0, eroded = 0;
  S time_step = 0;
  std::int64_t time_step_slot = -1;
  std::int64_t eroded_count = 0;
  std::int64_t inverted_count = 0;
};

/// Element stresses and internal forces (report figure 4, steps 3a-c in one sweep): tiles of one colour side by side,
/// the colours one after the other, so that the forces are added without atomics and always in one order.
template <class S>
class InternalForces {
 public:
  explicit InternalForces(const Model<S>& model);

  /// Adds the internal forces to the nodes and updates the element state; dt: the step just made [time].
  InternalForceResult<S> compute(Model<S>& model, S dt);

  /// Results of the last step per tile: where elements were eroded or inverted.
  const std::vector<TileResult<S>>& tiles() const { return results_; }

 private:
  std::vector<TileKernel<S>> kernel_of_part_;
  std::vector<TileResult<S>> results_;
};

}  // namespace pinball

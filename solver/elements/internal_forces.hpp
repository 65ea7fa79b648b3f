#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <solver/base/colouring.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/model/model.hpp>

#include "resting_tiles.hpp"
#include "subcycling.hpp"
#include "tile_kernels.hpp"

namespace pinball {

/// Work of the whole mesh in one step.
template <class S>
struct InternalForceResult {
  double internal = 0, hourglass = 0, viscous = 0, eroded = 0;
  S time_step = 0;
  std::int64_t time_step_slot = -1;
  std::int64_t eroded_count = 0;
  std::int64_t inverted_count = 0;
  std::int64_t resting_elements = 0;    ///< not worked, because their tiles rest
  std::int64_t subcycled_elements = 0;  ///< not worked, because their step is not over; without eroded ones
};

/// Element stresses and internal forces (report figure 4, steps 3a-c in one sweep): tiles of one colour side by side,
/// the colours one after the other, so that the forces are added without atomics and always in one order. Tiles that
/// rest are left out (skip.resting); left in they give the same bits.
template <class S>
class InternalForces {
 public:
  explicit InternalForces(const Model<S>& model);

  /// Adds the internal forces to the nodes and updates the element state; dt: the step just made [time].
  InternalForceResult<S> compute(Model<S>& model, S dt);
  /// The same for the tiles whose steps end in a step of the cycle. Tiles at rest are worked like others.
  InternalForceResult<S> compute(Model<S>& model, S dt, Subcycling<S>& subcycling, std::int32_t step_of_cycle);

  /// To be told when velocities or element states were changed by others than the step: the next compute() works all
  /// tiles and looks anew which of them rest.
  void forget_resting() { resting_.reset(); }

  /// model: with its own state read before.
  void persist(StateArchive& archive, const Model<S>& model);

  /// Results of the last step per tile: where elements were eroded or inverted.
  const std::vector<TileResult<S>>& tiles() const { return results_; }
  std::size_t bytes() const;

 private:
  void choose_worked(const Model<S>& model);
  void work(Model<S>& model, std::int32_t tile, const ElementStep<S>& step);
  InternalForceResult<S> sum() const;

  std::vector<TileKernel<S>> kernel_of_part_;
  std::vector<TileResult<S>> results_;
  std::optional<RestingTiles<S>> resting_;  ///< known once all tiles have been worked
  Colouring worked_;                        ///< the tiles to work
};

/// Slots of tiles in which elements have eroded in the last step: those that are padding or no longer have a mass,
/// ascending. tiles: as of InternalForces::tiles().
template <class S>
std::vector<std::int64_t> eroded_slots(const Model<S>& model, const std::vector<TileResult<S>>& tiles);

}  // namespace pinball

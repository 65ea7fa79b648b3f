#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/model/model.hpp>
#include <solver/parallel/subdomain.hpp>

#include "nodal_volumes.hpp"
#include "schedule.hpp"
#include "tile_kernels.hpp"

namespace pinball {

/// What the elements did in a step [energy].
struct ElementWork {
  double internal = 0, hourglass = 0, viscous = 0;
  double hourglass_plastic = 0;  ///< of `internal`: what yield took of hourglass modes
  double folding = 0;            ///< that corners near turning over store now
  double eroded = 0;             ///< internal energy that eroded elements take with them
};

/// Work of the whole mesh in one step, and what it found.
template <class S>
struct InternalForceResult : ElementWork {
  S time_step = 0;  ///< smallest stable step [time]
  std::int64_t time_step_slot = -1;
  std::int64_t eroded_count = 0;
  std::int64_t inverted_count = 0;
  std::int64_t inside_out_count = 0;    ///< elements with a corner that has turned over, also of tiles not updated
  std::int64_t resting_elements = 0;    ///< not updated, because their tiles rest
  std::int64_t subcycled_elements = 0;  ///< not updated, because their step is not over; without eroded ones
};

/// Element stresses and internal forces (report figure 4, steps 3a-c in one sweep): tiles of one colour side by side,
/// the colours one after the other, so that the forces are added without atomics and always in one order.
template <class S>
class InternalForces {
 public:
  /// domain: of several ranks, which share the results of their tiles; null: one process works all.
  explicit InternalForces(const Model<S>& model, Subdomain<S>* domain = nullptr);

  /// Adds the internal forces of the tiles that are due to the nodes and updates their element states; dt: the step
  /// just made [time]. What is not due does no work and keeps its stable step.
  InternalForceResult<S> compute(Model<S>& model, Schedule<S>& schedule, const Due& due,
                                 const ElementStep<S>& smallest);

  void persist(StateArchive& archive, const Model<S>& model);

  /// Results of the last step per tile: where elements were eroded or inverted.
  const std::vector<TileResult<S>>& tiles() const { return results_; }
  /// The stable step that a tile keeps while it rests, where it is not this class that works it.
  void keep_time_step(std::int32_t tile, S time_step, std::int64_t slot) {
    results_[tile].time_step = time_step;
    results_[tile].time_step_slot = slot;
  }
  /// The same of the tiles of all ranks.
  void share_time_steps(Subdomain<S>& domain);
  std::size_t bytes() const { return results_.capacity() * sizeof(TileResult<S>) + volumes_.bytes(); }

 private:
  void work(Model<S>& model, std::int32_t tile, const ElementStep<S>& step);
  template <class E>
  void work_in(Model<S>& model, std::int32_t tile, const ElementStep<S>& step, TileKernel<E, S> kernel);
  InternalForceResult<S> sum() const;
  std::int64_t share_results(Schedule<S>& schedule, const Due& due, bool skips_resting);
  void share_eroded(Model<S>& model);

  Subdomain<S>* domain_;
  std::vector<TileKernel<S, S>> kernel_of_part_;
  std::vector<TileKernel<float, S>> mixed_kernel_of_part_;  ///< in its place, where elements have fewer digits
  std::vector<TileResult<S>> results_;
  NodalVolumes<S> volumes_;
};

/// Slots of tiles in which elements have eroded in the last step: those that are padding or no longer have a mass,
/// ascending. tiles: as of InternalForces::tiles().
template <class S>
std::vector<std::int64_t> eroded_slots(const Model<S>& model, const std::vector<TileResult<S>>& tiles);

}  // namespace pinball

#include "internal_forces.hpp"

#include <limits>

#include <kernels/exec.hpp>
#include <solver/base/built_features.hpp>

namespace pinball {

template <class S>
InternalForces<S>::InternalForces(const Model<S>& model) : results_(static_cast<std::size_t>(model.tile_count())) {
  for (const Part& part : model.parts) kernel_of_part_.push_back(choose_tile_kernel<S>(part.features));
}

namespace {

/// body(tile) for the tiles of one colour side by side, the colours one after the other.
template <class Body>
void for_each_tile(const Colouring& tiles, const Body& body) {
  parallel_for_coloured("internal forces", DefaultExecutionSpace{}, tiles.colour_offsets.data(),
                        static_cast<std::int32_t>(tiles.colour_offsets.size()) - 1, tiles.items.data(), body);
}

}  // namespace

template <class S>
void InternalForces<S>::work(Model<S>& model, std::int32_t tile, const ElementStep<S>& step) {
  const auto t = static_cast<std::size_t>(tile);
  const auto part = static_cast<std::size_t>(model.tile_part[t]);
  kernel_of_part_[part](model.elements.view(), model.nodes.view(), model.constants[part], step, model.tile_packs[t],
                        model.tile_packs[t + 1], results_[t]);
}

template <class S>
InternalForceResult<S> InternalForces<S>::compute(Model<S>& model, S dt) {
  if (!built::resting || !resting_) {
    worked_ = model.tile_colours;
  } else if (resting_->wake(model.nodes)) {
    choose_worked(model);
  }
  for_each_tile(worked_, [&](std::int32_t tile) {
    TileResult<S>& result = results_[static_cast<std::size_t>(tile)];
    const TileResult<S> before = result;
    work(model, tile, {dt});
    // Worked all the same, a tile at rest keeps its stable step, as it does when it is skipped.
    if (!built::resting || !resting_ || !resting_->rests(tile)) return;
    result.time_step = before.time_step;
    result.time_step_slot = before.time_step_slot;
  });
  InternalForceResult<S> result = sum();
  if (built::resting && resting_ && model.scene.skip.resting) result.resting_elements = resting_->elements();
  if (built::resting && !resting_) {
    resting_.emplace(model);
    choose_worked(model);
  }
  return result;
}

template <class S>
InternalForceResult<S> InternalForces<S>::compute(Model<S>& model, S dt, Subcycling<S>& subcycling,
                                                  std::int32_t step_of_cycle) {
  for (TileResult<S>& result : results_) {  // what is not worked has done nothing, and keeps its stable step
    const TileResult<S> before = result;
    result = {};
    result.time_step = before.time_step;
    result.time_step_slot = before.time_step_slot;
  }
  for (int level = subcycling.due(step_of_cycle); level >= 0; --level) {
    subcycling.use_mean_velocities(model.nodes, level);
    for_each_tile(subcycling.tiles()[static_cast<std::size_t>(level)],
                  [&](std::int32_t tile) { work(model, tile, subcycling.step(tile, step_of_cycle == 0, dt)); });
    subcycling.use_present_velocities(model.nodes, level);
  }
  InternalForceResult<S> result = sum();
  result.subcycled_elements = subcycling.count_elements(results_, step_of_cycle);
  return result;
}

template <class S>
InternalForceResult<S> InternalForces<S>::sum() const {
  InternalForceResult<S> sum;
  sum.time_step = std::numeric_limits<S>::infinity();
  for (const TileResult<S>& r : results_) {
    sum.internal += r.internal;
    sum.hourglass += r.hourglass;
    sum.viscous += r.viscous;
    sum.eroded += r.eroded;
    sum.eroded_count += r.eroded_count;
    sum.inverted_count += r.inverted_count;
    if (r.time_step < sum.time_step) {
      sum.time_step = r.time_step;
      sum.time_step_slot = r.time_step_slot;
    }
  }
  return sum;
}

template <class S>
std::vector<std::int64_t> eroded_slots(const Model<S>& model, const std::vector<TileResult<S>>& tiles) {
  constexpr int W = ElementStore<S>::width;
  std::vector<std::int64_t> slots;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    if (tiles[t].eroded_count == 0) continue;
    for (std::int64_t slot = model.tile_packs[t] * W; slot < model.tile_packs[t + 1] * W; ++slot) {
      if (!(model.elements.mass[static_cast<std::size_t>(slot)] > S(0))) slots.push_back(slot);
    }
  }
  return slots;
}

/// The tiles of model.tile_colours without those that are to be skipped, colours in the same order.
template <class S>
void InternalForces<S>::choose_worked(const Model<S>& model) {
  worked_ = chosen_of(model.tile_colours,
                      [&](std::int32_t tile) { return !model.scene.skip.resting || !resting_->rests(tile); });
}

template <class S>
void InternalForces<S>::persist(StateArchive& archive, const Model<S>& model) {
  archive.of_fixed_size(results_);
  std::vector<std::uint8_t> rests;
  if (resting_) rests = resting_->flags();
  archive(rests);  // empty: not known
  if (!archive.reads()) return;
  resting_.reset();
  if (rests.empty()) return;
  if (rests.size() != results_.size()) StateArchive::throw_foreign();
  resting_.emplace(model, rests);
  choose_worked(model);
}

template <class S>
std::size_t InternalForces<S>::bytes() const {
  return results_.capacity() * sizeof(TileResult<S>) + (resting_ ? resting_->bytes() : 0) +
         (worked_.items.capacity() + worked_.colour_offsets.capacity()) * sizeof(std::int32_t);
}

template class InternalForces<double>;
template class InternalForces<float>;
template std::vector<std::int64_t> eroded_slots(const Model<double>&, const std::vector<TileResult<double>>&);
template std::vector<std::int64_t> eroded_slots(const Model<float>&, const std::vector<TileResult<float>>&);

}  // namespace pinball

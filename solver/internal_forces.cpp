#include <limits>
#include <pinball/built_features.hpp>
#include <pinball/kernels/exec.hpp>
#include <pinball/solver/internal_forces.hpp>

namespace pinball {

template <class S>
InternalForces<S>::InternalForces(const Model<S>& model) : results_(static_cast<std::size_t>(model.tile_count())) {
  for (const Part& part : model.parts) kernel_of_part_.push_back(choose_tile_kernel<S>(part.features));
}

template <class S>
InternalForceResult<S> InternalForces<S>::compute(Model<S>& model, S dt) {
  if (!built::resting || !resting_) {
    worked_ = model.tile_colours;
  } else if (resting_->wake(model.nodes)) {
    choose_worked(model);
  }
  const ElementView<S> elements = model.elements.view();
  const NodeView<S> nodes = model.nodes.view();
  parallel_for_coloured("internal forces", DefaultExecutionSpace{}, worked_.colour_offsets.data(),
                        static_cast<std::int32_t>(worked_.colour_offsets.size()) - 1, worked_.items.data(),
                        [&](std::int32_t tile) {
                          const auto t = static_cast<std::size_t>(tile);
                          const auto part = static_cast<std::size_t>(model.tile_part[t]);
                          TileResult<S>& result = results_[t];
                          const TileResult<S> before = result;
                          kernel_of_part_[part](elements, nodes, model.constants[part], dt, model.tile_packs[t],
                                                model.tile_packs[t + 1], result);
                          // Worked all the same, a tile at rest keeps its stable step, as it does when it is skipped.
                          if (!built::resting || !resting_ || !resting_->rests(tile)) return;
                          result.time_step = before.time_step;
                          result.time_step_slot = before.time_step_slot;
                        });
  InternalForceResult<S> sum;
  sum.time_step = std::numeric_limits<S>::infinity();
  if (resting_ && model.scene.skip.resting) sum.skipped_elements = resting_->elements();
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
  if (built::resting && !resting_) {
    resting_.emplace(model);
    choose_worked(model);
  }
  return sum;
}

/// The tiles of model.tile_colours without those that are to be skipped, colours in the same order.
template <class S>
void InternalForces<S>::choose_worked(const Model<S>& model) {
  const Colouring& colours = model.tile_colours;
  worked_.colour_offsets = {0};
  worked_.items.clear();
  for (std::size_t c = 0; c + 1 < colours.colour_offsets.size(); ++c) {
    for (std::int32_t i = colours.colour_offsets[c]; i < colours.colour_offsets[c + 1]; ++i) {
      const std::int32_t tile = colours.items[static_cast<std::size_t>(i)];
      if (!model.scene.skip.resting || !resting_->rests(tile)) worked_.items.push_back(tile);
    }
    const auto end = static_cast<std::int32_t>(worked_.items.size());
    if (end > worked_.colour_offsets.back()) worked_.colour_offsets.push_back(end);
  }
}

template <class S>
std::size_t InternalForces<S>::bytes() const {
  return results_.capacity() * sizeof(TileResult<S>) + (resting_ ? resting_->bytes() : 0) +
         (worked_.items.capacity() + worked_.colour_offsets.capacity()) * sizeof(std::int32_t);
}

template class InternalForces<double>;
template class InternalForces<float>;

}  // namespace pinball

#include <limits>
#include <pinball/kernels/exec.hpp>
#include <pinball/solver/internal_forces.hpp>

namespace pinball {

template <class S>
InternalForces<S>::InternalForces(const Model<S>& model) : results_(static_cast<std::size_t>(model.tile_count())) {
  for (const Part& part : model.parts) kernel_of_part_.push_back(choose_tile_kernel<S>(part.features));
}

template <class S>
InternalForceResult<S> InternalForces<S>::compute(Model<S>& model, S dt) {
  const ElementView<S> elements = model.elements.view();
  const NodeView<S> nodes = model.nodes.view();
  const Colouring& colours = model.tile_colours;
  parallel_for_coloured("internal forces", DefaultExecutionSpace{}, colours.colour_offsets.data(),
                        static_cast<std::int32_t>(colours.colour_offsets.size()) - 1, colours.items.data(),
                        [&](std::int32_t tile) {
                          const auto t = static_cast<std::size_t>(tile);
                          const auto part = static_cast<std::size_t>(model.tile_part[t]);
                          kernel_of_part_[part](elements, nodes, model.constants[part], dt, model.tile_packs[t],
                                                model.tile_packs[t + 1], results_[t]);
                        });

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

template class InternalForces<double>;
template class InternalForces<float>;

}  // namespace pinball

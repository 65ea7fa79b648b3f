#include <pinball/solver/internal_forces.hpp>

#include <limits>

#include <pinball/kernels/element_update.hpp>
#include <pinball/kernels/exec.hpp>

namespace pinball {

namespace {

template <class S, ElementFeatures features>
void update_tile(const ElementView<S>& elements, const NodeView<S>& nodes, const ElementConstants<S>& constants, S dt,
                 std::int64_t first_pack, std::int64_t last_pack, TileResult<S>& result) {
  using T = Pack<S, native_width<S>>;
  ElementSums<T> sums;
  sums.time_step = T(std::numeric_limits<S>::infinity());
  for (std::int64_t pack = first_pack; pack < last_pack; ++pack) {
    update_element_pack<T, features>(elements, nodes, constants, dt, pack, static_cast<int>(pack - first_pack), sums);
  }
  result.internal = static_cast<double>(lane_sum(sums.internal));
  result.hourglass = static_cast<double>(lane_sum(sums.hourglass));
  result.viscous = static_cast<double>(lane_sum(sums.viscous));
  result.eroded = static_cast<double>(lane_sum(sums.eroded));
  result.eroded_count = sums.eroded_count;
  result.inverted_count = sums.inverted_count;
  result.time_step = std::numeric_limits<S>::infinity();
  result.time_step_slot = -1;
  for (int i = 0; i < width_of<T>; ++i) {
    if (lane(sums.time_step, i) < result.time_step) {
      result.time_step = lane(sums.time_step, i);
      const auto pack = first_pack + static_cast<std::int64_t>(lane(sums.time_step_pack, i));
      result.time_step_slot = pack * width_of<T> + i;
    }
  }
}

// One kernel per combination of features; the choice is made once, at the start.
template <class S>
using Kernel = void (*)(const ElementView<S>&, const NodeView<S>&, const ElementConstants<S>&, S, std::int64_t,
                        std::int64_t, TileResult<S>&);

template <class S, bool plastic, bool erosion, bool viscosity>
Kernel<S> choose_hourglass(HourglassKind kind) {
  switch (kind) {
    case HourglassKind::stiffness:
      return update_tile<S, ElementFeatures{plastic, erosion, viscosity, HourglassKind::stiffness}>;
    case HourglassKind::viscous:
      return update_tile<S, ElementFeatures{plastic, erosion, viscosity, HourglassKind::viscous}>;
    case HourglassKind::none:
      break;
  }
  return update_tile<S, ElementFeatures{plastic, erosion, viscosity, HourglassKind::none}>;
}

template <class S, bool plastic, bool erosion>
Kernel<S> choose_viscosity(const ElementFeatures& f) {
  return f.bulk_viscosity ? choose_hourglass<S, plastic, erosion, true>(f.hourglass)
                          : choose_hourglass<S, plastic, erosion, false>(f.hourglass);
}

template <class S>
Kernel<S> choose_kernel(const ElementFeatures& f) {
  if (f.plastic && f.erosion) return choose_viscosity<S, true, true>(f);
  if (f.plastic) return choose_viscosity<S, true, false>(f);
  return choose_viscosity<S, false, false>(f);
}

}  // namespace

template <class S>
InternalForces<S>::InternalForces(const Model<S>& model) : results_(static_cast<std::size_t>(model.tile_count())) {
  for (const Part& part : model.parts) kernel_of_part_.push_back(choose_kernel<S>(part.features));
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

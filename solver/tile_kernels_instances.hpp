#pragma once

#include <pinball/kernels/element_update.hpp>
#include <pinball/solver/tile_kernels.hpp>

/// The kernels behind choose_tile_kernel. Included by one source file per precision, because compiling them takes long.
namespace pinball {

/// Asks for the nodes of a pack that is two packs ahead: where they lie nothing but the corner numbers says, so that
/// the processor cannot foresee it. Of a row of elements every second one will do: two node records share a cache line.
template <class S>
void prefetch_nodes(const NodeView<S>& nodes, const std::int32_t* corner) {
  for (int i = 0; i < 8 * native_width<S>; i += 2) {
    const std::int64_t record = 4 * static_cast<std::int64_t>(corner[i]);
    __builtin_prefetch(nodes.position + record);
    __builtin_prefetch(nodes.velocity + record);
    __builtin_prefetch(nodes.force + record);
  }
}

template <class S, ElementFeatures features>
void update_tile(const ElementView<S>& elements, const NodeView<S>& nodes, const ElementConstants<S>& constants,
                 const ElementStep<S>& step, std::int64_t first_pack, std::int64_t last_pack, TileResult<S>& result) {
  using T = Pack<S, native_width<S>>;
  ElementSums<T> sums;
  for (std::int64_t pack = first_pack; pack < last_pack; ++pack) {
    const std::int64_t ahead = pack + 2;
    if (ahead < last_pack) prefetch_nodes(nodes, elements.corner + ahead * 8 * width_of<T>);
    update_element_pack<T, features>(elements, nodes, constants, step, pack, static_cast<int>(pack - first_pack), sums);
  }
  result.internal = static_cast<double>(lane_sum(sums.internal));
  result.hourglass = static_cast<double>(lane_sum(sums.hourglass));
  result.viscous = static_cast<double>(lane_sum(sums.viscous));
  result.eroded = static_cast<double>(lane_sum(sums.eroded));
  result.eroded_count = sums.eroded_count;
  result.inverted_count = sums.inverted_count;
  S rate = 0;
  result.time_step_slot = -1;
  for (int i = 0; i < width_of<T>; ++i) {
    if (lane(sums.stable_rate, i) > rate) {
      rate = lane(sums.stable_rate, i);
      const auto pack = first_pack + static_cast<std::int64_t>(lane(sums.stable_rate_pack, i));
      result.time_step_slot = pack * width_of<T> + i;
    }
  }
  result.time_step = S(2) / rate;  // infinite for a tile without living elements
}

template <class S, bool plastic, bool erosion, bool viscosity>
TileKernel<S> choose_hourglass(HourglassKind kind) {
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
TileKernel<S> choose_viscosity(const ElementFeatures& f) {
  return f.bulk_viscosity ? choose_hourglass<S, plastic, erosion, true>(f.hourglass)
                          : choose_hourglass<S, plastic, erosion, false>(f.hourglass);
}

template <class S>
TileKernel<S> choose_tile_kernel(const ElementFeatures& f) {
  if (f.plastic && f.erosion) return choose_viscosity<S, true, true>(f);
  if (f.plastic) return choose_viscosity<S, true, false>(f);
  return choose_viscosity<S, false, false>(f);
}

}  // namespace pinball

#include "host_pinballs.hpp"

#include <kernels/exec.hpp>
#include <solver/base/lists_in_order.hpp>
#include <solver/contact/search/surface_motion.hpp>

namespace pinball {

template <class S>
void HostPinballs<S>::update_geometry(const SurfaceNodes<S>& nodes, bool radii) {
  using T = Pack<S, native_width<S>>;
  const RangePolicy<> packs{0, of_.packs()};
  if (radii) {
    parallel_for("pinballs", packs, UpdatePinballs<T, true>{of_.geometry, nodes.position, nodes.velocity});
  } else {
    parallel_for("pinballs", packs, UpdatePinballs<T, false>{of_.geometry, nodes.position, nodes.velocity});
  }
}

template <class S>
bool HostPinballs<S>::any_strays(const SurfaceNodes<S>& nodes, S elapsed) {
  return pinball::any_strays(of_.expected, nodes.position, elapsed);
}

template <class S>
bool HostPinballs<S>::any_grows(const SurfaceNodes<S>& nodes, S most) {
  const BallsGrow<S> grows{of_.corner, of_.radius, nodes.position, most, of_.geometry.radius_factor};
  return first_where("radii", of_.balls, grows) < of_.balls;
}

template <class S>
PairSums<S> HostPinballs<S>::find_forces(const PenaltyConstants<S>& constants, S dt) {
  return pair_forces_.compute(pinballs_of(of_.geometry), constants, {of_.pairs, of_.pieces}, dt, of_.force);
}

template <class S>
void HostPinballs<S>::add_forces(const SurfaceNodes<S>& nodes) {
  constexpr int W = native_width<S>;
  parallel_for_coloured("contact scatter", DefaultExecutionSpace{}, of_.colour_offsets.data(),
                        std::ssize(of_.colour_offsets) - 1, of_.tiles.data(), [&](std::int32_t tile) {
                          for (std::int32_t p = of_.tile_first[tile]; p < of_.tile_first[tile + 1]; ++p) {
                            const S* f = record(of_.force, p);
                            if (!(f[3] > S(0))) continue;
                            const std::int32_t* const corner = of_.geometry.corner + p / W * 8 * W + p % W;
                            for (int i = 0; i < 8; ++i) add_to_node(record(nodes.force, corner[i * W]), f);
                          }
                        });
}

template <class S>
S HostPinballs<S>::largest_row(const SurfaceNodes<S>& nodes) {
  LargestOf<S> largest;
  parallel_reduce(
      "contact frequency", RangePolicy<>{0, std::ssize(of_.nodes)}, largest,
      [&](std::int64_t begin, std::int64_t end, LargestOf<S>& partial) {
        for (std::int64_t n = begin; n < end; ++n) {
          partial.join({contact_row<S>(nodes.force, nodes.inverse_mass, of_.nodes[n])});
        }
      },
      [](LargestOf<S>& whole, const LargestOf<S>& partial) { whole.join(partial); });
  return largest.number;
}

template class HostPinballs<double>;
template class HostPinballs<float>;

}  // namespace pinball

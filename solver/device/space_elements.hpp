#pragma once

#include <vector>

#include <kernels/tetrahedron_update.hpp>
#include <solver/elements/element_features.hpp>

#include "device_mesh.hpp"
#include "device_resting.hpp"
#include "element_totals.hpp"
#include "fetched_elements.hpp"
#include "some_pieces.hpp"

/// The element kernel on an execution space: a thread works one lane of a device, or one pack of the host.
namespace pinball {

/// Which elements are at rest, or another rank's. Neither set the step: they keep theirs, or that rank does.
struct RestingElements {
  const std::int32_t* tile;   ///< per pack of the widest kind
  const std::uint8_t* rests;  ///< per tile (TileWork); null: all are awake
  bool updated;               ///< at rest, but worked all the same

  /// TileWork of the tile.
  template <class S>
  PINBALL_FUNCTION std::uint8_t at(std::int64_t place) const {
    return rests == nullptr ? TileWork::awake : rests[tile[place / widest_pack<S>]];
  }
};

/// A part of the elements, in the memory of the space.
template <class S>
struct ElementLaunch {
  ElementView<S> elements;
  NodeView<S> nodes;
  ElementConstants<S> constants;
  ElementStep<S> step;
  S* corner_force;
  RestingElements resting;
  S* rates;            ///< per place: 2/dt of its stable step dt; null: not asked for [1/time]
  std::uint8_t* left;  ///< per pack: whether a kernel without rare cases has left it; of packs at rest no matter
  bool only_left;      ///< only those are worked
  std::int64_t first, last;
};

template <class S, ElementFeatures features>
struct UpdatesElements {
  using T = Pack<S, native_width<S>>;
  ElementLaunch<S> launch;

  PINBALL_FUNCTION void operator()(std::int64_t pack, ElementTotals<S>& totals) const {
    if (!takes(pack)) return;
    ElementSums<T> sums;
    const bool done = update(launch.elements, pack, sums, KeptAtCorners<S>{launch.corner_force}, NothingAhead{});
    if (note(pack, done, totals)) count(pack, sums, totals);
  }

#if defined(PINBALL_DEVICE_COMPILER)
  /// The elements first, first + sum_lanes, ... before end, with what the next needs on its way.
  __device__ void sum_lane(std::int64_t first, std::int64_t end, ElementTotals<S>& totals) const {
    using Fetched = FetchedElements<S, features>;
    Fetched fetched(launch.elements, *shared_values<typename Fetched::Memory, 1>());
    const auto wanted = [&](std::int64_t element) { return element < end && takes(element); };
    bool takes_this = wanted(first);
    fetched.fetch_first(first, takes_this);
    fetched.fetch_state(first, takes_this);
    for (std::int64_t element = first; element < end; element += sum_lanes) {
      fetched.next_round();
      wait_for_all_groups_but_one();
      const std::int64_t next = element + sum_lanes;
      const bool takes_next = wanted(next);
      fetched.fetch_first(next, takes_next);
      if (takes_this) update_fetched(fetched, element, totals);
      wait_for_all_groups_but_one();
      fetched.fetch_state(next, takes_next);
      takes_this = takes_next;
    }
  }

 private:
  __device__ void update_fetched(const FetchedElements<S, features>& fetched, std::int64_t element,
                                 ElementTotals<S>& totals) const {
    const ElementView<S> view = fetched.view(element);
    const std::int64_t lane = threadIdx.x;
    ElementSums<T> sums;
    const KeptAtCorners<S> forces{launch.corner_force + (element - lane) * 24};
    const bool done = update(view, lane, sums, forces, WaitsForState{});
    wait_for_all_groups_but_one();  // a pack that is not there, or is left, asks for nothing
    if (!note(element, done, totals)) return;
    fetched.write(element, sums.eroded_count > 0);
    count(element, sums, totals);
  }
#endif

 private:
  /// Returns whether it is done, as update_element_pack does. ahead: of that.
  template <class Ahead>
  PINBALL_FUNCTION bool update(const ElementView<S>& view, std::int64_t pack, ElementSums<T>& sums,
                               const KeptAtCorners<S>& forces, const Ahead& ahead) const {
    if constexpr (features.tetrahedra) {
      ahead(2);  // what an element keeps is loaded now
      update_tetrahedron_pack<T, features, device_row>(view, launch.nodes, launch.constants, launch.step, pack, 0, sums,
                                                       forces);
      return true;
    } else {
      return update_element_pack<T, features, device_row>(view, launch.nodes, launch.constants, launch.step, pack, 0,
                                                          sums, forces, ahead);
    }
  }
  /// Whether the kernel has to look at a pack.
  PINBALL_FUNCTION bool takes(std::int64_t pack) const {
    if (launch.only_left) return launch.left[pack] != 0;
    const std::uint8_t work = tile_work(pack);
    return work == TileWork::rests ? launch.resting.updated : work != TileWork::none;
  }
  PINBALL_FUNCTION std::uint8_t tile_work(std::int64_t pack) const {
    return launch.resting.template at<S>(pack * width_of<T>);
  }

  /// Which packs are left for another kernel. Returns `done`.
  PINBALL_FUNCTION bool note(std::int64_t pack, bool done, ElementTotals<S>& totals) const {
    if (!done) {
      launch.left[pack] = 1;
      ++totals.left_count;
    } else if (launch.only_left) {
      launch.left[pack] = 0;
    }
    return done;
  }
  PINBALL_FUNCTION void count(std::int64_t pack, ElementSums<T>& sums, ElementTotals<S>& totals) const {
    const std::int64_t first = pack * width_of<T>;
    if (launch.rates != nullptr) store(sums.stable_rate, launch.rates + first);
    if (tile_work(pack) != TileWork::awake) sums.stable_rate = T(0);
    totals.add(sums, first);
  }
};

/// some: of a rank, which works these pieces of the sum alone and keeps what each adds up to; null: all are worked.
template <class S>
using ElementKernel = ElementTotals<S> (*)(ElementLaunch<S>, SomePieces<S>*);

/// of_piece: of each of some.
template <class S, class Space, ElementFeatures features>
ElementTotals<S> sweep_elements(const ElementLaunch<S>& launch, const SomePieces<S>* some, ElementTotals<S>* of_piece) {
  using Work = UpdatesElements<S, features>;
  constexpr int W = width_of<typename Work::T>;
  const RangePolicy<Space> packs{launch.first / W, launch.last / W};
  ElementTotals<S> totals;
  if (some == nullptr) {
    parallel_reduce("elements", packs, Work{launch}, totals);
    return totals;
  }
  for (const PieceRange pieces : some->worked) {
    reduce_pieces("elements", packs, pieces, Work{launch}, of_piece);
    for (std::int64_t p = pieces.first; p < pieces.last; ++p) totals.join(of_piece[p]);
  }
  return totals;
}

/// Rare cases have a sweep of their own, over the packs that the first has left, in the steps in which it has left any.
template <class S, class Space, ElementFeatures features>
ElementTotals<S> update_elements(ElementLaunch<S> launch, SomePieces<S>* some) {
  ElementTotals<S>* const usual_pieces = some == nullptr ? nullptr : some->usual.data();
  if constexpr (features.yield == YieldLaw::linear) {
    if (!(features.plastic && launch.constants.never_yields)) {
      constexpr ElementFeatures usual{features.plastic,   features.erosion, features.bulk_viscosity,
                                      features.hourglass, features.yield,   false};
      ElementTotals<S> totals = sweep_elements<S, Space, usual>(launch, some, usual_pieces);
      if (totals.left_count == 0) return totals;
      launch.only_left = true;
      totals.join(sweep_elements<S, Space, features>(launch, some, some == nullptr ? nullptr : some->of_left.data()));
      return totals;
    }
  }
  return sweep_elements<S, Space, features>(launch, some, usual_pieces);
}

/// Each is compiled for itself, by the sources that define these; the choice is made once.
template <class S, class Space>
ElementKernel<S> choose_linear_kernel(const ElementFeatures& features);
template <class S, class Space>
ElementKernel<S> choose_general_kernel(const ElementFeatures& features);
template <class S, class Space>
ElementKernel<S> tetrahedron_kernel();

template <class S, class Space>
struct UpdatesElementsIn {
  template <ElementFeatures features>
  ElementKernel<S> of() const {
    return update_elements<S, Space, features>;
  }
};

}  // namespace pinball

#pragma once

#include <kernels/element_data.hpp>
#include <kernels/exec.hpp>
#include <kernels/exec/fetch.hpp>

#include "device_mesh.hpp"

#if defined(PINBALL_DEVICE_COMPILER)

/// Elements of a block of threads whose numbers come into the block's memory while those before them are worked.
///
/// The kernel of an element takes so many registers that eight warps are all that a processor of the device has, too
/// few to hide what it waits for memory: without this it waits for more than half of its time, for one array after
/// another. A thread fetches for itself alone, so that threads need not wait for each other.
namespace pinball {

template <class S, ElementFeatures features>
class FetchedElements {
  static constexpr int block = sum_lanes;
  static constexpr bool keeps_modes = stores_hourglass_modes(features.hourglass);

 public:
  /// Numbers of a block's elements, in rows as in ElementView. What is needed first is there twice: for the elements at
  /// work and for the next.
  struct Memory {
    std::int32_t corner[2][8 * block];
    S mass[2][block];
    S stress[6 * block];
    S plastic_strain[features.plastic ? block : 1];
    S hourglass_state[keeps_modes ? 12 * block : 1];
    S viscous_stress[features.bulk_viscosity ? block : 1];
    S internal_energy[features.erosion ? block : 1];
  };

  __device__ FetchedElements(const ElementView<S>& elements, Memory& memory)
      : elements_(elements), memory_(memory), lane_(static_cast<int>(threadIdx.x)) {}

  /// Begins with what is needed first of an element, for the next round.
  __device__ void fetch_first(std::int64_t element, bool wanted) {
    if (wanted) {
      fetch_numbers<8>(memory_.corner[1 - turn_], elements_.corner, element);
      fetch_numbers<1>(memory_.mass[1 - turn_], elements_.mass, element);
    }
    end_of_group();
  }
  /// Begins with the rest, for the next round. Before, the present round has ended.
  __device__ void fetch_state(std::int64_t element, bool wanted) {
    if (wanted) {
      for_each_array([&]<int N>(S* here, const S* array) { fetch_numbers<N>(here, array, element); });
    }
    end_of_group();
  }
  __device__ void next_round() { turn_ = 1 - turn_; }

  /// The block's elements of this round; element: of this thread, whose number among them is that of its lane.
  __device__ ElementView<S> view(std::int64_t element) const {
    const std::int64_t begin = element - lane_;  // of a row, as all parts are
    ElementView<S> view = elements_;
    view.corner = memory_.corner[turn_];
    view.mass = memory_.mass[turn_];
    view.stress = memory_.stress;
    view.plastic_strain = memory_.plastic_strain;
    if (has_modes()) view.hourglass_state = memory_.hourglass_state;
    if (elements_.viscous_stress != nullptr) view.viscous_stress = memory_.viscous_stress;
    if (elements_.internal_energy != nullptr) view.internal_energy = memory_.internal_energy;
    if (elements_.material_state != nullptr) view.material_state += begin * elements_.material_numbers;
    if (elements_.mass_share != nullptr) view.mass_share += begin;
    if (elements_.folding_onset != nullptr) view.folding_onset += begin;
    if (elements_.volume_ratio != nullptr) view.volume_ratio += begin * 2;
    return view;
  }

  /// Writes back what the step has changed of the thread's element.
  __device__ void write(std::int64_t element, bool eroded) const {
    for_each_array([&]<int N>(const S* here, S* array) {
      PINBALL_UNROLL
      for (int c = 0; c < N; ++c) array[place<N>(element, c)] = here[place<N>(lane_, c)];
    });
    if (eroded) elements_.mass[element] = memory_.mass[turn_][lane_];
  }

 private:
  /// Without control the kernel of the viscous form has no numbers of modes.
  __device__ bool has_modes() const {
    return keeps_hourglass_state(features.hourglass) || elements_.hourglass_state != nullptr;
  }
  template <int N>
  __device__ static std::int64_t place(std::int64_t element, int component) {
    return place_in_rows<device_row>(element, N) + component * device_row;
  }
  template <int N, class Number>
  __device__ void fetch_numbers(Number* here, const Number* array, std::int64_t element) const {
    PINBALL_UNROLL
    for (int c = 0; c < N; ++c) fetch(here + place<N>(lane_, c), array + place<N>(element, c));
  }
  /// Calls visit<N>(memory, array) for arrays of N numbers an element that a step may change, but for the mass.
  template <class Visit>
  __device__ void for_each_array(const Visit& visit) const {
    visit.template operator()<6>(memory_.stress, elements_.stress);
    if constexpr (features.plastic) visit.template operator()<1>(memory_.plastic_strain, elements_.plastic_strain);
    if constexpr (keeps_modes) {
      if (has_modes()) visit.template operator()<12>(memory_.hourglass_state, elements_.hourglass_state);
    }
    if constexpr (features.bulk_viscosity) {
      if (elements_.viscous_stress != nullptr) {
        visit.template operator()<1>(memory_.viscous_stress, elements_.viscous_stress);
      }
    }
    if constexpr (features.erosion) {
      if (elements_.internal_energy != nullptr) {
        visit.template operator()<1>(memory_.internal_energy, elements_.internal_energy);
      }
    }
  }

  const ElementView<S>& elements_;
  Memory& memory_;
  int lane_, turn_ = 1;
};

/// What update_element_pack calls: what follows ahead(2) loads the state.
struct WaitsForState {
  __device__ void operator()(int part) const {
    if (part == 2) wait_for_all_groups_but_one();
  }
};

}  // namespace pinball

#endif

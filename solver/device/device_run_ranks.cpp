#include <vector>

#include "device_run.hpp"

/// Where what one of several ranks has on its device meets what the others have.
namespace pinball {

template <class S>
void DeviceRun<S>::share_with_ranks() {
  step_->set_pieces(ranks_->pieces());
  domain_->bring_own_by([this] { bring_own(); });
  domain_->keep_with_state([this] {
    if (!knows_resting_) return;
    rests_on_ranks_ = step_->read_resting();
    domain_->share_tiles(rests_on_ranks_.data());
  });
}

/// Of several ranks: of what this one works, and what has eroded anywhere.
template <class S>
void DeviceRun<S>::bring_own() {
  if (!device_is_newer_) return;
  common_->give(NodeNumbers::none);
  DeviceState<S> state;  // as large as the state itself: not kept between
  step_->read(state);
  layout_.to_model(state, model_);
  if (domain_ != nullptr) domain_->take_out_eroded(model_);
  common_->equal_motion();
  device_is_newer_ = false;
}

template <class S>
void DeviceRun<S>::bring_nodes() {
  common_->give(NodeNumbers::force);
  NodeStore<S>& nodes = model_.nodes;
  step_->read_nodes(nodes.position.data(), nodes.velocity.data(), nodes.force.data());
  domain_->bring_nodes(model_);
  step_->write_nodes(nodes.position.data(), nodes.velocity.data(), nodes.force.data());
  nodes.force.reset(nodes.force.size());
  common_->equal_motion();
}

template <class S>
void DeviceRun<S>::add_common(std::span<const std::int32_t> nodes) {
  common_->add(nodes);
  if (domain_ == nullptr) return;
  domain_->add_common(nodes);
  common_->set_own(domain_->own_common());
}

/// All numbers of the new ones are shown, for those of the others are, too; of several ranks they are those of the rank
/// that has moved the node.
template <class S>
void DeviceRun<S>::take_in(std::span<const std::int32_t> nodes) {
  common_->give(NodeNumbers::none);
  if (!common_->add(nodes)) return;
  common_->show_anew();
  if (domain_ == nullptr) return;
  domain_->take_in(model_, nodes);
  common_->set_own(domain_->own_common());
  common_->take(NodeNumbers::all);
}

/// What the corners of elements do to common nodes goes from the rank that holds all of these corners to all.
template <class S>
void DeviceRun<S>::share_common_forces() {
  if (domain_ == nullptr || !domain_->has_common()) return;
  common_->show_own_forces();
  domain_->share_forces(model_.nodes);
  common_->take(NodeNumbers::force);
}

template <class S>
std::vector<std::int64_t> DeviceRun<S>::eroded_slots() {
  if (eroded_count_ == 0 || !eroded_.empty()) return eroded_;
  any_eroded_ = true;
  Array<S>& mass = model_.elements.mass.template in<S>();
  for (const std::int64_t place : step_->take_eroded()) {
    const std::int64_t slot = layout_.slot_of_place(place);
    mass[slot] = 0;
    if (domain_ == nullptr || domain_->rank_of_slot(slot) == domain_->rank()) eroded_.push_back(slot);
  }
  if (domain_ != nullptr) eroded_ = domain_->join_eroded(model_, eroded_);
  return eroded_;
}

template <class S>
void DeviceRun<S>::show_strains(const Surface& surface) {
  if (!any_eroded_) return;
  std::vector<std::int64_t> slots, places;
  for (std::int32_t tile = 0; tile < model_.tile_count(); ++tile) {
    if (!model_.parts[model_.tile_part[tile]].features.erosion) continue;
    if (domain_ != nullptr && !domain_->works(tile)) continue;
    for (const std::int64_t slot : model_.slots_of(tile)) {
      if (surface.exposed(slot) == 0) continue;
      slots.push_back(slot);
      places.push_back(layout_.place_of_slot(slot));
    }
  }
  bring_strains(slots, places);
  if (domain_ != nullptr) domain_->share_strains(model_, surface);
}

template void DeviceRun<double>::share_with_ranks();
template void DeviceRun<float>::share_with_ranks();
template void DeviceRun<double>::bring_own();
template void DeviceRun<float>::bring_own();
template void DeviceRun<double>::bring_nodes();
template void DeviceRun<float>::bring_nodes();
template void DeviceRun<double>::add_common(std::span<const std::int32_t>);
template void DeviceRun<float>::add_common(std::span<const std::int32_t>);
template void DeviceRun<double>::take_in(std::span<const std::int32_t>);
template void DeviceRun<float>::take_in(std::span<const std::int32_t>);
template void DeviceRun<double>::share_common_forces();
template void DeviceRun<float>::share_common_forces();
template std::vector<std::int64_t> DeviceRun<double>::eroded_slots();
template std::vector<std::int64_t> DeviceRun<float>::eroded_slots();
template void DeviceRun<double>::show_strains(const Surface&);
template void DeviceRun<float>::show_strains(const Surface&);

}  // namespace pinball

#include "device_run.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <solver/base/built_features.hpp>
#include <solver/base/error.hpp>
#include <solver/boundary/space/make_boundary_kernels.hpp>
#include <solver/elements/volume_groups.hpp>
#include <solver/scene_rules.hpp>

#include "body_elements.hpp"
#include "device_pinballs.hpp"
#include "devices.hpp"
#include "resting_list.hpp"

namespace pinball {

std::string missing_on_device(const Scene& scene) {
  std::vector<std::string> missing;
  const auto add = [&missing](bool is_there, const char* what) {
    if (is_there) missing.emplace_back(what);
  };
  add(scene.time.subcycling, "subcycling");
  add(scene.precision == Precision::mixed, "precision = \"mixed\"");
  return fmt::format("{}", fmt::join(missing, ", "));
}

namespace {

/// The device of a scene. Throws MissingOnDevice, and InputError where there is no such device.
Device device_for(const Scene& scene) {
  const std::string missing = missing_on_device(scene);
  if (!missing.empty()) {
    throw MissingOnDevice(fmt::format("{}no device can do this scene yet: it has {}; expected --device none",
                                      message_head(scene), missing),
                          missing);
  }
  require_device(scene.device);
  return scene.device;
}

template <class S>
std::unique_ptr<DeviceStep<S>> make_step([[maybe_unused]] Device device, [[maybe_unused]] const DeviceMesh<S>& mesh) {
#if defined(PINBALL_WITH_MOCK)
  if (device == Device::mock) return make_mock_step(mesh);
#endif
#if defined(PINBALL_WITH_CUDA) || defined(PINBALL_WITH_HIP)
  return make_gpu_step(mesh);
#else
  return {};  // refused before
#endif
}

}  // namespace

template <class S>
DeviceRun<S>::DeviceRun(Model<S>& model, InternalForces<S>& forces, Schedule<S>& schedule, Subdomain<S>* domain)
    : model_(model),
      forces_(forces),
      schedule_(schedule),
      domain_(domain),
      device_(device_for(model.scene)),
      layout_(model) {
  DeviceMesh<S> mesh = layout_.mesh(model);
  if (domain != nullptr) {
    domain->set_device(choose_device(device_, domain->rank_on_machine()));
    ranks_.emplace(model, layout_, device_, *domain);
    ranks_->mark(mesh);
  } else {
    mesh.volumes.lists = layout_.lists_of_places(std::move(VolumeGroups<S>(model).lists));
    mesh.volumes.own = mesh.volumes.lists.elements();
  }
  step_ = make_step(device_, mesh);
  common_ = std::make_unique<CommonMirror<S>>(*step_, model.nodes);
  if (domain != nullptr) share_with_ranks();
}

template <class S>
void DeviceRun<S>::bring_back() {
  if (domain_ == nullptr) return bring_own();
  domain_->bring_back(model_);
}

template <class S>
void DeviceRun<S>::bring_back_resting() {
  if (!knows_resting_) return;
  schedule_.set_resting(model_, domain_ == nullptr ? step_->read_resting() : rests_on_ranks_);
}

template <class S>
void DeviceRun<S>::take_velocities() {
  std::vector<S> position(model_.nodes.position.size()), velocity(position), force(position);
  step_->read_nodes(position.data(), velocity.data(), force.data());
  step_->write_nodes(position.data(), model_.nodes.velocity.data(), force.data());
  common_->equal_motion();
}

template <class S>
const S* DeviceRun<S>::forces(std::vector<S>& memory) {
  common_->give(NodeNumbers::none);
  std::vector<S> position(model_.nodes.position.size()), velocity(position);
  memory.resize(position.size());
  step_->read_nodes(position.data(), velocity.data(), memory.data());
  return memory.data();
}

/// What output sums up where the state lies is summed up by rank 0, which has the others' part of it for that.
template <class S>
void DeviceRun<S>::show_whole_state() {
  send_state();
  if (domain_ == nullptr || has_whole_state_) return;
  bring_back();
  step_->write(layout_.state(model_));
  has_whole_state_ = true;
}

/// Sends what the host has changed.
template <class S>
void DeviceRun<S>::send_state() {
  if (!host_is_newer_) return;
  host_is_newer_ = false;
  has_whole_state_ = true;
  asks_what_rests_ = true;
  step_->write(layout_.state(model_));
  take_masses();
  common_->equal_motion();
  any_eroded_ = std::ranges::any_of(model_.slot_of_element, [this](auto slot) { return !model_.elements.alive(slot); });
}

/// The same. Returns whether tiles that rest were found anew.
template <class S>
bool DeviceRun<S>::take_changes() {
  send_state();
  if (!asks_what_rests_) return false;
  asks_what_rests_ = false;
  step_->set_resting({});
  knows_resting_ = false;
  if (schedule_.resting() != nullptr) {  // of a checkpoint
    tell_resting();
    return false;
  }
  if (built::resting) schedule_.find_resting(model_);
  return built::resting;
}

template <class S>
void DeviceRun<S>::tell_resting() {
  const DeviceResting<S> list = resting_list(model_, *schedule_.resting(), forces_.tiles());
  step_->set_resting(list);
  resting_ = list.tile;
  knows_resting_ = rests_anywhere_ = true;
}

/// The tiles that were found at rest are updated once more, for the stable steps that they keep from then on.
template <class S>
ElementTotals<S> DeviceRun<S>::update_anew(const ElementStep<S>& step) {
  Array<S> rates;
  const ElementTotals<S> totals = step_->update_elements(step, rates);
  keep_time_steps(model_, layout_, *schedule_.resting(), rates, forces_);
  if (domain_ != nullptr) forces_.share_time_steps(*domain_);
  tell_resting();
  return totals;
}

/// Which tiles rest is found before they are updated, which changes nothing of it.
template <class S>
InternalForceResult<S> DeviceRun<S>::update_elements(const Due& /*due*/, const ElementStep<S>& step, bool more_forces) {
  typename DeviceRanks<S>::Resting resting;
  const bool found = take_changes();
  common_->give(NodeNumbers::force);
  device_is_newer_ = true;
  has_whole_state_ = false;
  if (ranks_) ranks_->connect(*step_);
  if (!found) resting = wake();
  if (ranks_) ranks_->exchange_volumes(*step_);
  ElementTotals<S> totals = found ? update_anew(step) : step_->update_elements(step);
  if (ranks_) ranks_->exchange_forces(*step_);
  if (more_forces) step_->sum_corner_forces();
  share_common_forces();
  if (ranks_) totals = ranks_->share(step_->pieces_of_parts(), totals);
  eroded_.clear();
  InternalForceResult<S> result;
  result.internal = totals.internal;
  result.hourglass = totals.hourglass;
  result.viscous = totals.viscous;
  result.eroded = totals.eroded;
  result.hourglass_plastic = totals.hourglass_plastic;
  result.folding = totals.folding;
  result.time_step = S(2) / totals.stable_rate;  // infinite without living elements
  result.time_step_slot = totals.place < 0 ? -1 : layout_.slot_of_place(totals.place);
  if (resting.tile >= 0 && resting.time_step < result.time_step) {
    result.time_step = resting.time_step;
    result.time_step_slot = forces_.tiles()[resting.tile].time_step_slot;
  }
  if (model_.scene.skip.resting) result.resting_elements = resting.elements;
  result.eroded_count = eroded_count_ = totals.eroded_count;
  result.inverted_count = totals.inverted_count;
  result.inside_out_count = totals.inside_out_count;
  return result;
}

/// Returns what rests in this step.
template <class S>
typename DeviceRanks<S>::Resting DeviceRun<S>::wake() {
  const RestingTotals<S> own = step_->wake();
  const std::int32_t tile = own.index < 0 ? -1 : resting_[own.index];
  typename DeviceRanks<S>::Resting resting{own.time_step, tile, own.elements};
  if (!ranks_ || !rests_anywhere_) return resting;
  resting = ranks_->share(resting);
  rests_anywhere_ = resting.tile >= 0;
  return resting;
}

template <class S>
std::unique_ptr<BoundaryKernels<S>> DeviceRun<S>::boundary_kernels() const {
#if defined(PINBALL_WITH_MOCK)
  if (device_ == Device::mock) return make_mock_boundary_kernels<S>(layout_.places_of_slots(), domain_);
#endif
#if defined(PINBALL_WITH_CUDA) || defined(PINBALL_WITH_HIP)
  return make_gpu_boundary_kernels<S>(layout_.places_of_slots(), domain_);
#else
  return {};
#endif
}

template <class S>
std::unique_ptr<PinballKernels<S>> DeviceRun<S>::pinball_kernels() const {
#if defined(PINBALL_WITH_MOCK)
  if (device_ == Device::mock) return make_mock_pinball_kernels<S>();
#endif
#if defined(PINBALL_WITH_CUDA) || defined(PINBALL_WITH_HIP)
  return make_gpu_pinball_kernels<S>();
#else
  return {};
#endif
}

template <class S>
NodeArrays<S> DeviceRun<S>::nodes(NodeNumbers changes) {
  common_->give(changes);
  return step_->nodes();
}

template <class S>
MotionEnergy DeviceRun<S>::integrate(const Due& /*due*/, const StepLengths& step) {
  device_is_newer_ = true;
  common_->give(NodeNumbers::all);
  return ranks_ ? ranks_->integrate(*step_, step) : step_->integrate(step);
}

template <class S>
void DeviceRun<S>::take_masses() {
  step_->write_masses(model_.nodes.inverse_mass.data(), model_.node_mass.data());
}

template <class S>
void DeviceRun<S>::bring_strains(std::span<const std::int64_t> slots, const std::vector<std::int64_t>& places) {
  if (places.empty() || model_.elements.plastic_strain.empty()) return;
  const std::vector<S> strains = step_->read_numbers(StateNumbers::plastic_strain, places);
  Array<S>& of_model = model_.elements.plastic_strain.template in<S>();
  for (std::size_t i = 0; i < slots.size(); ++i) of_model[slots[i]] = strains[i];
}

template <class S>
NodeArrays<S> DeviceRun<S>::nodes_for_output() {
  show_whole_state();
  return nodes(NodeNumbers::none);
}

template <class S>
std::vector<BodySum> DeviceRun<S>::body_sums() {
  show_whole_state();
  common_->give(NodeNumbers::none);
  if (!knows_bodies_) {
    step_->set_bodies(body_elements(model_, [this](std::int64_t slot) { return layout_.place_of_slot(slot); }));
  }
  knows_bodies_ = true;
  return step_->body_sums();
}

template <class S>
std::vector<ElementWork> DeviceRun<S>::work_of_bodies() {
  std::vector<ElementWork> work(model_.scene.bodies.size());
  const std::vector<ElementTotals<S>>& totals = ranks_ ? ranks_->totals_of_parts() : step_->totals_of_parts();
  for (std::size_t part = 0; part < totals.size(); ++part) {
    const std::int32_t of = layout_.body_of_part(part);
    if (of < 0) continue;
    ElementWork& body = work[of];
    body.internal += totals[part].internal;
    body.eroded += totals[part].eroded;
    body.hourglass += totals[part].hourglass;
    body.viscous += totals[part].viscous;
  }
  return work;
}

template <class S>
void DeviceRun<S>::show_watched(std::span<const std::int32_t> nodes, std::span<const std::int64_t> slots) {
  if (domain_ != nullptr) {
    bring_back();
    return;
  }
  if (!device_is_newer_) return;
  common_->give(NodeNumbers::none);
  std::vector<std::int64_t> numbers, places, components;
  for (const std::int32_t node : nodes) {
    for (std::int64_t k = 0; k < 3; ++k) numbers.push_back(4 * static_cast<std::int64_t>(node) + k);
  }
  for (const std::int64_t slot : slots) {
    places.push_back(layout_.place_of_slot(slot));
    for (int c = 0; c < 6; ++c) components.push_back(place_in_packs<device_row>(places.back(), c, 6));
  }
  const auto bring = [this](StateNumbers of, const std::vector<std::int64_t>& at, const auto& put) {
    if (at.empty()) return;
    const std::vector<S> found = step_->read_numbers(of, at);
    for (std::size_t i = 0; i < at.size(); ++i) put(i, found[i]);
  };
  bring(StateNumbers::position, numbers, [&](std::size_t i, S x) { model_.nodes.position[numbers[i]] = x; });
  bring(StateNumbers::velocity, numbers, [&](std::size_t i, S v) { model_.nodes.velocity[numbers[i]] = v; });
  Array<S>& stress = model_.elements.stress.template in<S>();
  bring(StateNumbers::stress, components,
        [&](std::size_t i, S value) { stress[model_.elements.at(slots[i / 6], static_cast<int>(i % 6), 6)] = value; });
  bring_strains(slots, places);
}

template <class S>
std::size_t DeviceRun<S>::bytes() const {
  return step_->bytes() + common_->bytes();
}

template class DeviceRun<double>;
template class DeviceRun<float>;

}  // namespace pinball

#include "device_run.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <vector>

#include <solver/base/built_features.hpp>
#include <solver/base/error.hpp>
#include <solver/boundary/space/make_boundary_kernels.hpp>
#include <solver/scene_rules.hpp>

#include "devices.hpp"
#include "resting_list.hpp"

namespace pinball {

std::string missing_on_device(const Scene& scene) {
  std::vector<std::string> missing;
  const auto add = [&missing](bool is_there, const char* what) {
    if (is_there) missing.emplace_back(what);
  };
  const ContactMethod method = scene.contact.method;  // not set: of a scene whose bodies are not known yet
  add(method == ContactMethod::pinball || method == ContactMethod::slideline, "contact");
  add(!scene.tied_contacts.empty(), "tied contact");
  add(!scene.rigid_bodies.empty(), "rigid bodies");
  add(scene.time.subcycling, "subcycling");
  add(scene.precision == Precision::mixed, "precision = \"mixed\"");
  add(scene.output.body_energies, "output.body_energies");
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
DeviceRun<S>::DeviceRun(Model<S>& model, InternalForces<S>& forces, Schedule<S>& schedule)
    : model_(model), forces_(forces), schedule_(schedule), device_(device_for(model.scene)), layout_(model) {
  step_ = make_step(device_, layout_.mesh(model));
  state_ = layout_.state(model);
}

template <class S>
void DeviceRun<S>::bring_back() {
  if (!device_is_newer_) return;
  step_->read(state_);
  layout_.to_model(state_, model_);
  device_is_newer_ = false;
}

template <class S>
void DeviceRun<S>::bring_back_resting() {
  if (knows_resting_) schedule_.set_resting(model_, step_->read_resting());
}

/// Sends what the host has changed. Returns whether tiles that rest were found anew.
template <class S>
bool DeviceRun<S>::take_changes() {
  if (!host_is_newer_) return false;
  host_is_newer_ = false;
  state_ = layout_.state(model_);
  step_->write(state_);
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
  knows_resting_ = true;
}

/// Which tiles rest is found before they are updated, which changes nothing of it. They are updated once more, for the
/// stable steps that they keep from then on.
template <class S>
InternalForceResult<S> DeviceRun<S>::update_elements(const Due& /*due*/, const ElementStep<S>& step, bool more_forces) {
  RestingTotals<S> resting;
  ElementTotals<S> totals;
  const bool found = take_changes();
  device_is_newer_ = true;
  if (found) {
    Array<S> rates;
    totals = step_->update_elements(step, rates);
    keep_time_steps(model_, layout_, *schedule_.resting(), rates, forces_);
    tell_resting();
  } else {
    resting = step_->wake();
    totals = step_->update_elements(step);
  }
  if (more_forces) step_->sum_corner_forces();
  InternalForceResult<S> result;
  result.internal = totals.internal;
  result.hourglass = totals.hourglass;
  result.viscous = totals.viscous;
  result.eroded = totals.eroded;
  result.hourglass_plastic = totals.hourglass_plastic;
  result.folding = totals.folding;
  result.time_step = S(2) / totals.stable_rate;  // infinite without living elements
  result.time_step_slot = totals.place < 0 ? -1 : layout_.slot_of_place(totals.place);
  if (resting.index >= 0 && resting.time_step < result.time_step) {
    result.time_step = resting.time_step;
    const std::int32_t tile = resting_[resting.index];
    result.time_step_slot = forces_.tiles()[tile].time_step_slot;
  }
  if (model_.scene.skip.resting) result.resting_elements = resting.elements;
  result.eroded_count = totals.eroded_count;
  result.inverted_count = totals.inverted_count;
  result.inside_out_count = totals.inside_out_count;
  return result;
}

template <class S>
std::unique_ptr<BoundaryKernels<S>> DeviceRun<S>::boundary_kernels() const {
#if defined(PINBALL_WITH_MOCK)
  if (device_ == Device::mock) return make_mock_boundary_kernels<S>(layout_.places_of_slots());
#endif
#if defined(PINBALL_WITH_CUDA) || defined(PINBALL_WITH_HIP)
  return make_gpu_boundary_kernels<S>(layout_.places_of_slots());
#else
  return {};
#endif
}

template <class S>
NodeArrays<S> DeviceRun<S>::nodes(NodeNumbers /*changes*/) {
  return step_->nodes();
}

template <class S>
MotionEnergy DeviceRun<S>::integrate(const Due& /*due*/, const StepLengths& step) {
  device_is_newer_ = true;
  return step_->integrate(step);
}

template <class S>
std::size_t DeviceRun<S>::bytes() const {
  return step_->bytes() + state_.bytes();
}

template class DeviceRun<double>;
template class DeviceRun<float>;

}  // namespace pinball

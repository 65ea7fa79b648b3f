#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <solver/base/error.hpp>
#include <solver/boundary/space/boundary_kernels.hpp>
#include <solver/elements/internal_forces.hpp>

#include "device_layout.hpp"
#include "device_step.hpp"

namespace pinball {

/// What of a scene no device can do yet, as the end of a sentence ("contact, subcycling"); empty: all of it can be
/// done.
std::string missing_on_device(const Scene& scene);

/// A scene with something that no device can do yet.
struct MissingOnDevice : InputError {
  MissingOnDevice(const std::string& what, std::string what_is_missing)
      : InputError(what), missing(std::move(what_is_missing)) {}
  std::string missing;  ///< as of missing_on_device
};

/// A model whose state lies on a device. The host's stores are a mirror of it: who reads them asks for bring_back
/// first, who changes them says so. This is the one place that knows which of both is newer.
template <class S>
class DeviceRun {
 public:
  /// Throws MissingOnDevice, and InputError where there is no such device.
  explicit DeviceRun(const Model<S>& model);

  /// Copies the state into the stores, if the device has changed it since.
  void bring_back(Model<S>& model);
  /// Of the tiles that rest.
  void bring_back(const Model<S>& model, Schedule<S>& schedule);
  /// The stores have been changed: the next step begins with them.
  void host_has_changed() { host_is_newer_ = true; }

  /// The loops of boundary conditions, on nodes().
  std::unique_ptr<BoundaryKernels<S>> boundary_kernels() const;
  NodeArrays<S> nodes() { return step_->nodes(); }

  /// As InternalForces::compute, for schedules without subcycling; `forces` keeps the stable steps of tiles at rest.
  /// with_sums: the forces of nodes have those of their corners, for who adds more before nodes are integrated.
  InternalForceResult<S> update_elements(const Model<S>& model, Schedule<S>& schedule, InternalForces<S>& forces,
                                         const ElementStep<S>& step, bool with_sums);
  MotionEnergy integrate(const StepLengths& step);

  std::size_t bytes() const;  ///< of both, less the stores of the model

 private:
  bool take_changes(const Model<S>& model, Schedule<S>& schedule, const InternalForces<S>& forces);
  void tell_resting(const Model<S>& model, const Schedule<S>& schedule, const InternalForces<S>& forces);

  Device device_;
  DeviceLayout<S> layout_;
  std::unique_ptr<DeviceStep<S>> step_;
  DeviceState<S> state_;  ///< what crosses over, in the device's layout
  bool host_is_newer_ = true, device_is_newer_ = false;
  bool knows_resting_ = false;         ///< the device, which tiles rest
  std::vector<std::int32_t> resting_;  ///< those that it knows of
};

}  // namespace pinball

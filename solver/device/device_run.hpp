#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <solver/base/error.hpp>

#include "common_mirror.hpp"
#include "device_layout.hpp"
#include "device_ranks.hpp"
#include "device_step.hpp"
#include "step_space.hpp"

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

/// A model whose state lies on a device. The host's stores are a mirror of it: who reads them asks for bring_back()
/// first, who changes them says so. This is the one place that knows which of both is newer.
template <class S>
class DeviceRun final : public StepSpace<S> {
 public:
  /// All have to stay where they are; `forces` keeps the stable steps of tiles at rest. domain: of several ranks, each
  /// with a device; null: this process is alone. Throws MissingOnDevice, and InputError where there is no such device.
  DeviceRun(Model<S>& model, InternalForces<S>& forces, Schedule<S>& schedule, Subdomain<S>* domain = nullptr);

  std::unique_ptr<BoundaryKernels<S>> boundary_kernels() const override;
  std::unique_ptr<PinballKernels<S>> pinball_kernels() const override;
  NodeArrays<S> nodes(NodeNumbers changes) override;
  InternalForceResult<S> update_elements(const Due& due, const ElementStep<S>& step, bool more_forces) override;
  MotionEnergy integrate(const Due& due, const StepLengths& step) override;

  void add_common(std::span<const std::int32_t> nodes) override;
  void take_in(std::span<const std::int32_t> nodes) override;
  void show(NodeNumbers numbers) override { common_->show(numbers); }
  void take(NodeNumbers changed) override { common_->take(changed); }
  void list(std::span<const std::int32_t> nodes) override { common_->list(nodes); }
  void show_listed(NodeNumbers numbers) override { common_->show_listed(numbers); }
  void take_listed(NodeNumbers changed) override { common_->take_listed(changed); }
  Sharers* sharers() override { return domain_ != nullptr ? &domain_->sharers() : nullptr; }
  void take_masses() override;
  std::vector<std::int64_t> eroded_slots() override;
  void show_strains(const Surface& surface) override;

  NodeArrays<S> nodes_for_output() override;
  std::vector<BodySum> body_sums() override;
  std::vector<ElementWork> work_of_bodies() override;
  void show_watched(std::span<const std::int32_t> nodes, std::span<const std::int64_t> slots) override;

  void bring_nodes() override;
  void take_velocities() override;
  const S* forces(std::vector<S>& memory) override;
  void bring_back() override;
  void bring_back_resting() override;
  void host_has_changed() override {
    host_is_newer_ = true;
    knows_resting_ = false;  // what rested may have been changed
  }
  std::size_t bytes() const override;

 private:
  void share_with_ranks();
  void share_common_forces();
  ElementTotals<S> update_anew(const ElementStep<S>& step);
  typename DeviceRanks<S>::Resting wake();
  bool take_changes();
  void send_state();
  void bring_own();
  void show_whole_state();
  void tell_resting();
  void bring_strains(std::span<const std::int64_t> slots, const std::vector<std::int64_t>& places);

  Model<S>& model_;
  InternalForces<S>& forces_;
  Schedule<S>& schedule_;
  Subdomain<S>* domain_;
  Device device_;
  DeviceLayout<S> layout_;
  std::optional<DeviceRanks<S>> ranks_;  ///< only with domain_
  std::unique_ptr<DeviceStep<S>> step_;
  std::unique_ptr<CommonMirror<S>> common_;
  bool host_is_newer_ = true, device_is_newer_ = false;
  bool asks_what_rests_ = true;        ///< others may rest than the device knows of
  bool knows_resting_ = false;         ///< the device, which tiles rest
  std::vector<std::int32_t> resting_;  ///< those that it knows of
  std::int64_t eroded_count_ = 0;      ///< in the last update
  std::vector<std::int64_t> eroded_;   ///< their slots, when somebody has asked
  bool any_eroded_ = false;            ///< in any step
  bool knows_bodies_ = false;
  // Of several ranks:
  bool has_whole_state_ = false;              ///< the device, also what is another's
  bool rests_anywhere_ = false;               ///< any tile, on any rank
  std::vector<std::uint8_t> rests_on_ranks_;  ///< per tile, when the state was last brought back
};

}  // namespace pinball

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <solver/device/step_space.hpp>
#include <solver/parallel/subdomain.hpp>

namespace pinball {

/// The space of the host's threads. Of several ranks: what this one shares with the others.
template <class S>
class HostStep final : public StepSpace<S> {
 public:
  /// All have to stay where they are. domain: of several ranks; null: this process is alone.
  HostStep(Model<S>& model, InternalForces<S>& forces, Schedule<S>& schedule, Subdomain<S>* domain)
      : model_(model), forces_(forces), schedule_(schedule), domain_(domain) {}

  std::unique_ptr<BoundaryKernels<S>> boundary_kernels() const override;
  std::unique_ptr<PinballKernels<S>> pinball_kernels() const override { return nullptr; }
  NodeArrays<S> nodes(NodeNumbers /*changes*/) override;
  InternalForceResult<S> update_elements(const Due& due, const ElementStep<S>& step, bool /*more_forces*/) override {
    return forces_.compute(model_, schedule_, due, step);
  }
  MotionEnergy integrate(const Due& due, const StepLengths& step) override;

  void add_common(std::span<const std::int32_t> nodes) override {
    if (domain_ != nullptr) domain_->add_common(nodes);
  }
  void take_in(std::span<const std::int32_t> nodes) override {
    if (domain_ != nullptr) domain_->take_in(model_, nodes);
  }
  void show(NodeNumbers /*numbers*/) override {}
  void take(NodeNumbers /*changed*/) override {}
  void list(std::span<const std::int32_t> /*nodes*/) override {}
  void show_listed(NodeNumbers /*numbers*/) override {}
  void take_listed(NodeNumbers /*changed*/) override {}
  Sharers* sharers() override { return domain_ != nullptr ? &domain_->sharers() : nullptr; }
  void take_masses() override {}
  std::vector<std::int64_t> eroded_slots() override { return pinball::eroded_slots(model_, forces_.tiles()); }
  void show_strains(const Surface& surface) override {
    if (domain_ != nullptr) domain_->share_strains(model_, surface);
  }

  void bring_nodes() override { domain_->bring_nodes(model_); }
  void take_velocities() override {}
  const S* forces(std::vector<S>& /*memory*/) override { return model_.nodes.force.data(); }

  NodeArrays<S> nodes_for_output() override {
    bring_back();
    return nodes(NodeNumbers::none);
  }
  std::vector<BodySum> body_sums() override;
  std::vector<ElementWork> work_of_bodies() override;
  void show_watched(std::span<const std::int32_t> /*nodes*/, std::span<const std::int64_t> /*slots*/) override {
    bring_back();
  }

  void bring_back() override {
    if (domain_ != nullptr) domain_->bring_back(model_);
  }
  void bring_back_resting() override {}
  void host_has_changed() override {}
  std::size_t bytes() const override {
    return (bodies_ ? bodies_->bytes() : 0) + (single_bodies_ ? single_bodies_->bytes() : 0);
  }

 private:
  template <class E>
  using Bodies = SpaceBodySums<S, E, native_width<E>, DefaultExecutionSpace>;
  template <class E>
  std::vector<BodySum> sums_of(std::optional<Bodies<E>>& bodies);

  Model<S>& model_;
  InternalForces<S>& forces_;
  Schedule<S>& schedule_;
  Subdomain<S>* domain_;
  std::optional<Bodies<S>> bodies_;             ///< from the first body_sums() on
  std::optional<Bodies<float>> single_bodies_;  ///< in its place, where elements have fewer digits
};

}  // namespace pinball

#pragma once

#include <utility>

#include <kernels/boundary/node_forces.hpp>

#include "boundary_kernels.hpp"
#include "loops.hpp"

namespace pinball {

/// Forces on all nodes.
template <class S, class Space, class Forces>
class SpaceNodeForces : public NodeForceKernels<S> {
 public:
  SpaceNodeForces(const char* name, std::int64_t count, const Forces& forces, SharedList shared = nullptr)
      : name_(name), count_(count), shared_(std::move(shared)), forces_(forces) {}

  void add(const NodeArrays<S>& nodes, const std::array<double, 3>& vector) override {
    if constexpr (requires { forces_.follow(vector.data()); }) forces_.follow(vector.data());
    for_each<Space>(name_, count_, AddForces<S, Forces>{nodes, forces_}, shared_);
  }
  void add_work(const NodeArrays<S>& nodes, const StepLengths& step, ExternalWork& sum) const override {
    add_sum<Space>(name_, count_, WorkOfForces<S, Forces>{nodes, forces_, step}, sum, shared_);
  }
  std::size_t bytes() const override { return 0; }

 private:
  const char* name_;
  std::int64_t count_;
  SharedList shared_;

 protected:
  Forces forces_;
};

/// Forces on nodes of a list, each with its share.
template <class S, class Space, class Forces, class Share>
class SpaceSharedForces final : public SpaceNodeForces<S, Space, Forces> {
 public:
  SpaceSharedForces(const char* name, const std::vector<std::int32_t>& nodes, const std::vector<Share>& share,
                    SharedList shared)
      : SpaceNodeForces<S, Space, Forces>(name, nodes.size(), Forces{}, std::move(shared)),
        nodes_(list_in<Space>(nodes)),
        share_(list_in<Space>(share)) {
    this->forces_.nodes = nodes_.data();
    this->forces_.share = share_.data();
  }
  std::size_t bytes() const override { return nodes_.bytes() + share_.bytes(); }

 private:
  Array<std::int32_t, typename Space::memory_space> nodes_;
  Array<Share, typename Space::memory_space> share_;
};

/// Forces that the host gives in every step: where they lie, or in a copy.
template <class S, class Space>
class SpaceGivenForces final : public SpaceNodeForces<S, Space, GivenForce<S>> {
 public:
  SpaceGivenForces(std::int64_t count, const S* forces)
      : SpaceNodeForces<S, Space, GivenForce<S>>("host forces", count, {forces}), given_(forces) {
    if constexpr (!on_host<Space>) {
      copy_.renew(4 * static_cast<std::size_t>(count));
      this->forces_.given = copy_.data();
    }
  }
  void add(const NodeArrays<S>& nodes, const std::array<double, 3>& vector) override {
    if constexpr (!on_host<Space>) deep_copy(copy_, given_, copy_.size());
    SpaceNodeForces<S, Space, GivenForce<S>>::add(nodes, vector);
  }
  std::size_t bytes() const override { return copy_.bytes(); }

 private:
  const S* given_;
  Array<S, typename Space::memory_space> copy_;
};

}  // namespace pinball

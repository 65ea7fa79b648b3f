#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "boundary_kernels.hpp"
#include "loops.hpp"

namespace pinball {

/// Some nodes with numbers of each, or all nodes without a list.
struct NodeList {
  const std::int32_t* node = nullptr;
  const double* of_node = nullptr;

  PINBALL_FUNCTION std::int64_t at(std::int64_t i) const { return node == nullptr ? i : node[i]; }
};

/// Twice the kinetic energy; of_node: the share of its mass.
template <class S>
struct KineticOfNodes {
  NodeArrays<S> nodes;
  NodeList list;
  S energy_step;

  PINBALL_FUNCTION void operator()(std::int64_t i, double& twice) const {
    const std::int64_t n = list.at(i);
    const double share = list.of_node == nullptr ? 1 : list.of_node[i];
    const S factor = energy_step * nodes.inverse_mass[n];
    S v2 = 0;
    for (int k = 0; k < 3; ++k) {
      const S v = nodes.velocity[4 * n + k];
      v2 += v * (v + factor * nodes.force[4 * n + k]);
    }
    twice += share * nodes.mass[n] * static_cast<double>(v2);
  }
};

/// of_node: the mass that counts.
template <class S>
struct MomentumOfNodes {
  NodeArrays<S> nodes;
  NodeList list;

  PINBALL_FUNCTION void operator()(std::int64_t i, VectorSum& sum) const {
    const std::int64_t n = list.at(i);
    const double mass = list.of_node == nullptr ? nodes.mass[n] : list.of_node[i];
    const S* const v = nodes.velocity + 4 * n;
    sum.join({mass * static_cast<double>(v[0]), mass * static_cast<double>(v[1]), mass * static_cast<double>(v[2])});
  }
};

template <class S, class Space>
class SpaceNodeMotion final : public NodeMotionKernels<S> {
 public:
  explicit SpaceNodeMotion(std::int32_t node_count) : count_(node_count), listed_(false) {}
  SpaceNodeMotion(const std::vector<std::int32_t>& nodes, const std::vector<double>& share,
                  const std::vector<double>& mass, SharedList shared)
      : count_(std::ssize(nodes)),
        listed_(true),
        shared_(std::move(shared)),
        node_(list_in<Space>(nodes)),
        share_(list_in<Space>(share)),
        mass_(list_in<Space>(mass)) {}

  double kinetic(const NodeArrays<S>& nodes, double energy_step) const override {
    double twice = 0;
    add_sum<Space>("kinetic energy", count_,
                   KineticOfNodes<S>{nodes, list_of(share_.data()), static_cast<S>(energy_step)}, twice, shared_);
    return 0.5 * twice;
  }
  VectorSum momentum(const NodeArrays<S>& nodes) const override {
    VectorSum sum;
    add_sum<Space>("momentum", count_, MomentumOfNodes<S>{nodes, list_of(mass_.data())}, sum);
    return sum;
  }
  std::size_t bytes() const override { return node_.bytes() + share_.bytes() + mass_.bytes(); }

 private:
  NodeList list_of(const double* of_node) const { return listed_ ? NodeList{node_.data(), of_node} : NodeList(); }

  std::int64_t count_;
  bool listed_;
  SharedList shared_;
  Array<std::int32_t, typename Space::memory_space> node_;
  Array<double, typename Space::memory_space> share_, mass_;
};

}  // namespace pinball

#pragma once

#include <utility>

#include "boundary_kernels.hpp"
#include "loops.hpp"

namespace pinball {

template <class S, class Space>
class SpaceWall final : public WallKernels<S> {
 public:
  SpaceWall(bool rubs, SharedNodes* sharing) : rubs_(rubs), sharing_(sharing) {}

  void set(const std::vector<std::int32_t>& nodes, const std::vector<WallHold<S>>& hold) override {
    nodes_ = list_in<Space>(nodes);
    shared_ = shared_list(sharing_, nodes.size(), [nodes](std::int64_t i) { return nodes[i]; });
    hold_ = list_in<Space>(hold);
    reaction_.reset(nodes.size());
    drag_.reset(rubs_ ? 3 * nodes.size() : 0);
  }
  void clear_reactions() override { reaction_.reset(reaction_.size()); }

  WallPush push(const NodeArrays<S>& nodes, const WallPlane<S>& wall, const WallStep<S>& step) override {
    WallPush sum;
    add_sum<Space>("push on a rigid wall", count(), PushWall<S>{nodes, wall, of(), step}, sum, shared_);
    return sum;
  }
  WallStop stop(const NodeArrays<S>& nodes, const WallPlane<S>& wall, const WallStep<S>& step) override {
    WallStop sum;
    add_sum<Space>("rigid wall", count(), StopAtWall<S>{nodes, wall, of(), step}, sum, shared_);
    return sum;
  }
  void push_held(const NodeArrays<S>& nodes, const WallPlane<S>& wall) override {
    for_each<Space>("held nodes of a rigid wall", hold_.size(), PushHeldNodes<S>{nodes, wall, of()});
  }
  void add_work(const NodeArrays<S>& nodes, const WallPlane<S>& wall, const StepLengths& step,
                ExternalWork& sum) override {
    add_sum<Space>("work of a rigid wall", count(), WorkOfWall<S>{nodes, wall, of(), step}, sum, shared_);
  }
  std::size_t bytes() const override { return nodes_.bytes() + hold_.bytes() + reaction_.bytes() + drag_.bytes(); }

 private:
  using Memory = typename Space::memory_space;
  std::int64_t count() const { return nodes_.size(); }
  WallNodes<S> of() {
    const auto held = static_cast<std::int64_t>(hold_.size());
    return {nodes_.data(), count() - held, hold_.data(), reaction_.data(), rubs_ ? drag_.data() : nullptr};
  }

  bool rubs_;
  SharedNodes* sharing_;
  SharedList shared_;
  Array<std::int32_t, Memory> nodes_;
  Array<WallHold<S>, Memory> hold_;  ///< of the last nodes
  Array<S, Memory> reaction_;        ///< per node [force]
  Array<S, Memory> drag_;            ///< 3 per node, only where it rubs [force]
};

template <class S, class Space>
class SpaceReflection final : public ReflectionKernels<S> {
 public:
  SpaceReflection(const std::vector<std::int32_t>& nodes, const std::array<double, 3>& point,
                  const std::array<double, 3>& inward, SharedList shared)
      : nodes_(list_in<Space>(nodes)), point_(point), inward_(inward), shared_(std::move(shared)) {}

  void keep_forces(const NodeArrays<S>& nodes) override {
    const auto [a, b, c] = inward_;
    across_.renew(nodes_.size());
    for_each<Space>("forces across symmetry walls", nodes_.size(),
                    KeepForcesAcross<S>{nodes_.data(), {S(a), S(b), S(c)}, nodes.force, across_.data()}, shared_);
  }
  Reflection reflect(const NodeArrays<S>& nodes, S position_step, const DueSpans& due) const override {
    const auto [x, y, z] = point_;
    const auto [a, b, c] = inward_;
    const std::int8_t* const levels = due.level_of_span == nullptr ? nullptr : due.level_of_span->data();
    const ReflectNodes<S> turn{
        nodes_.data(), {S(x), S(y), S(z)}, {S(a), S(b), S(c)}, position_step, nodes.position, nodes.velocity,
        levels,        nodes_per_span,
    };
    Reflection sum;
    add_sum<Space>("work of symmetry walls", nodes_.size(), SumReflection<S>{turn, nodes.mass, across_.data()}, sum,
                   shared_);
    for_each<Space>("symmetry walls", nodes_.size(), turn);
    return sum;
  }
  std::size_t bytes() const override { return nodes_.bytes() + across_.bytes(); }

 private:
  Array<std::int32_t, typename Space::memory_space> nodes_;
  Array<S, typename Space::memory_space> across_;  ///< per node, of keep_forces() [force]
  std::array<double, 3> point_, inward_;
  SharedList shared_;
};

}  // namespace pinball

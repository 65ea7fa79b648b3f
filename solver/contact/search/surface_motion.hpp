#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <kernels/exec/array.hpp>
#include <kernels/simd.hpp>
#include <kernels/straying.hpp>
#include <kernels/tensor.hpp>
#include <solver/base/lists_in_order.hpp>
#include <solver/base/state_archive.hpp>

namespace pinball {

/// Time since lists were built. The step that is being made is not known yet: it is taken to be as long as the one
/// before, and what that is wrong by counts as straying.
template <class S>
class ListClock {
 public:
  /// horizon: time for which lists are built [time].
  void restart(S horizon) {
    horizon_ = horizon;
    known_ = 0;
    steps_ = 0;
  }
  /// Notes the length of the step just made.
  void count_step(S dt) {
    if (steps_ > 0) known_ += dt;
    last_step_ = dt;
    ++steps_;
  }
  void persist(StateArchive& archive) { archive(horizon_, known_, last_step_, steps_); }
  S elapsed() const { return known_ + last_step_; }
  S last_step() const { return last_step_; }
  bool over() const { return elapsed() > horizon_; }

 private:
  S horizon_ = 0, known_ = 0, last_step_ = 0;
  std::int64_t steps_ = 0;
};

/// Steps for which lists are built. Fast pairs are listed along the way that they make in this time.
inline constexpr int horizon_steps = 20;

/// Where the nodes of the surface are expected to go, and how far they may stray from it before what was built on that
/// expectation has to be built anew.
///
/// A node is expected to keep the velocity v that it had at the start: x(t) = x + v t. The centre of an element is the
/// mean of its corners, so that it strays no further from its own straight way than the furthest of them. Every node
/// has its own allowance, which follows what it strayed before: a few violent ones make neither the others' lists
/// longer nor theirs short-lived, and bodies or fragments in free flight do not stray at all.
template <class S>
class SurfaceMotion {
 public:
  /// Watches these nodes and no others. node_count: of the store; node_of(i), for i below `count`: a node, perhaps that
  /// of another i, too; size_of(i), of the first i of a node: what its allowance is measured by, the radius of a
  /// pinball or element that it belongs to [length].
  template <class NodeOf, class SizeOf>
  void watch(std::int32_t node_count, std::int64_t count, const NodeOf& node_of, const SizeOf& size_of);
  /// Adapts the allowances to what the nodes have strayed since start(), for a time to come.
  /// position: of the node store; elapsed: since start(); horizon: the time to come [time].
  void adapt(const S* position, S elapsed, S horizon);
  /// Starts from the present positions and velocities, node records, of the nodes watched. skin: scale of the
  /// allowances over the sizes of the nodes [-]; 0: none may stray.
  void start(const S* position, const S* velocity, S skin);

  /// The nodes watched, some perhaps several times.
  std::span<const std::int32_t> nodes() const { return node_; }
  /// All of them, as loops see them.
  ExpectedNodes<S> expected() const;
  /// Whether no node has strayed further than allowed after this time; false if a position is not a number.
  bool holds(const S* position, S elapsed) const;
  /// Those of the nodes watched that have: places in nodes(), without padding, ascending.
  void find_strayed(const S* position, S elapsed, std::vector<std::int32_t>& places) const;
  /// Starts nodes again, from where they are now and as they move now, with the same beginning of time as the others,
  /// and allows them more. places: as found; skin: of start(); elapsed, horizon: since then, and from now on [time].
  void restart(std::span<const std::int32_t> places, const S* position, const S* velocity, S skin, S elapsed,
               S horizon);
  /// Where a node is taken to have been at the start, and how it is taken to move. place: in nodes().
  Vec3<S> start_position(std::size_t place) const { return started(place, 0); }
  Vec3<S> start_velocity(std::size_t place) const { return started(place, 3); }
  /// How far the centre of an element or a face may stray, given its corners [length].
  template <class Corners>
  S allowance(const Corners& corners) const {
    float largest = 0;
    for (const std::int32_t node : corners) largest = std::max(largest, allowance_[node]);
    return largest;
  }
  /// Node records of what start() was given of the nodes watched; nothing of others.
  void put_start(Array<S>& position, Array<S>& velocity) const;
  /// node_count: of the store; watched: whether there are nodes that are watched.
  void persist(StateArchive& archive, std::int32_t node_count, bool watched);
  std::size_t bytes() const;

 private:
  std::int64_t packs() const;  ///< of nodes
  Vec3<S> started(std::size_t place, std::size_t component) const {
    constexpr std::size_t W = native_width<S>;
    const S* const of = start_.data() + place / W * 6 * W + component * W + place % W;
    return {of[0], of[W], of[2 * W]};
  }
  void put_started(std::size_t place, const S* position, const S* velocity, S elapsed);
  void put_allowance(std::size_t place, S allowance, S skin);

  std::size_t count_ = 0;           ///< nodes, padded to whole packs
  std::vector<std::int32_t> node_;  ///< number in the store, from the lowest up
  std::vector<S> size_;             ///< what the allowance of the node is measured by [length]
  Array<S> start_;                  ///< in packs, 6 components: position and velocity
  Array<S> allowed2_;               ///< square of the allowance [length^2]
  std::vector<float> allowance_;    ///< per node of the store [length]
};

/// Whether any of these nodes has strayed further than allowed after this time, by the threads of the host.
template <class S>
bool any_strays(const ExpectedNodes<S>& nodes, const S* position, S elapsed);

template <class S>
template <class NodeOf, class SizeOf>
void SurfaceMotion<S>::watch(std::int32_t node_count, std::int64_t count, const NodeOf& node_of,
                             const SizeOf& size_of) {
  constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();
  std::vector<std::int32_t> first(node_count, none);
  allowance_.resize(node_count, 0);
  parallel_for("nodes watched", RangePolicy<>{0, count},
               [&](std::int64_t i) { keep_lowest(first[node_of(i)], static_cast<std::int32_t>(i)); });
  list_where("list of nodes watched", node_count, node_, [&](std::int64_t node) { return first[node] != none; });
  size_.resize(node_.size());
  parallel_for("sizes of nodes", RangePolicy<>{0, std::ssize(node_)},
               [&](std::int64_t i) { size_[i] = size_of(first[node_[i]]); });
}

}  // namespace pinball

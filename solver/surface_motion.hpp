#pragma once

#include <array>
#include <cstdint>
#include <pinball/solver/aligned_array.hpp>
#include <pinball/solver/stores.hpp>
#include <pinball/solver/surface_pinballs.hpp>
#include <vector>

namespace pinball {

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
  /// Takes the nodes of these pinballs, each once. node_count: of the store.
  void collect(const SurfacePinballs<S>& pinballs, std::int32_t node_count);
  /// Adapts the allowances to what the nodes have strayed in the time elapsed, for a time to come of `horizon`.
  void adapt(const S* position, S elapsed, S horizon);
  /// Starts from the present positions and velocities. skin: scale of the allowances over the radius of the pinballs,
  /// 0: no node may stray.
  void start(const NodeStore<S>& nodes, S skin);

  /// Whether no node has strayed further than allowed after this time; false if a position is not a number.
  bool holds(const S* position, S elapsed) const;
  /// How far the centre of an element may stray [length].
  S allowance(const std::array<std::int32_t, 8>& corners) const;
  std::size_t bytes() const;

 private:
  std::size_t count_ = 0;            ///< nodes, padded to whole packs
  std::vector<std::int32_t> node_;   ///< number in the store
  std::vector<std::uint8_t> taken_;  ///< per node of the store: in node_
  std::vector<S> size_;              ///< radius of the largest pinball of the node [length]
  AlignedArray<S> start_;            ///< in packs, 6 components: position and velocity
  AlignedArray<S> allowed2_;         ///< square of the allowance [length^2]
  std::vector<float> allowance_;     ///< per node of the store [length]
};

}  // namespace pinball

#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/model/model.hpp>
#include <solver/model/node_spans.hpp>
#include <solver/model/step_levels.hpp>
#include <solver/parallel/subdomain.hpp>

#include "tile_kernels.hpp"

namespace pinball {

/// Elements with a small stable step make it, the others a multiple of it (time.subcycling).
///
/// A cycle is as many of the smallest steps as the largest one holds. A tile of level l is updated at every 2^l-th
/// step, for the time since it was updated before, and gives its nodes the impulse of its forces over 2^l steps at
/// once: as the force of one step, with the weight 2^l. Between such impulses nodes move uniformly. Every impulse sums
/// to zero over the nodes of an element and has no moment, so that momentum and angular momentum are conserved to
/// round-off, and for elastic bodies the map from step to step is symplectic (asynchronous variational integrators:
/// Lew, Marsden, Ortiz, West, Arch. Rational Mech. Anal. 167, 85-146, 2003): the energy strays by the square of the
/// step, but does not drift.
///
/// Where tiles of several levels meet, a node is kicked more often than the tiles of the higher level are updated.
/// These see its mean velocity since they were updated before, which is the way that it has made.
///
/// Levels come from the mesh (step_levels.hpp) and are chosen again at the beginning of a cycle, from the stable steps
/// that the tiles then have; a tile never goes above the level that it has from the mesh. Where elements erode, what
/// they uncover makes the smallest step from then on.
template <class S>
class Subcycling {
 public:
  /// every_node: all nodes make the smallest step, because something else than elements acts on all of them. domain: of
  /// several ranks, which choose the same levels; null: one process works all tiles. Has to stay where it is.
  Subcycling(const Model<S>& model, bool every_node, Subdomain<S>* domain = nullptr);

  std::int32_t cycle_steps() const { return 1 << top_; }
  int levels() const { return top_ + 1; }
  /// The highest level that is updated in a step of the cycle; step 0 updates all.
  int due(std::int32_t step) const { return step == 0 ? top_ : std::countr_zero(static_cast<std::uint32_t>(step)); }
  bool is_due(std::int32_t tile, std::int32_t step) const { return level_[tile] <= due(step); }

  /// Chooses the levels of the coming cycle, before the tiles are updated in the step that begins it.
  /// contact_frequency2: bound on the square of the contact frequency [1/time^2].
  void plan(const std::vector<TileResult<S>>& tiles, double contact_frequency2);
  /// Takes what was planned, after the tiles were updated.
  void begin_cycle(const Model<S>& model);

  /// Of each level, by colour; of several ranks those that this one works.
  const std::vector<Colouring>& tiles() const { return tiles_; }
  /// The step that a tile makes when it is updated; dt: the smallest step, of the time since it was updated before.
  ElementStep<S> step(std::int32_t tile, bool begins_cycle, const ElementStep<S>& smallest) const;
  /// Puts mean velocities in the places of those of nodes that move otherwise within the steps of a level; and back.
  void use_mean_velocities(NodeStore<S>& nodes, int level);
  void use_present_velocities(NodeStore<S>& nodes, int level);

  /// Nodes to integrate in a step of the cycle: those of level l at every 2^l-th step, for 2^l steps.
  DueSpans due_nodes(std::int32_t step) const { return {&level_of_span_, due(step)}; }
  /// To be called after each integration.
  void count_step(NodeStore<S>& nodes);

  /// The smallest step that is stable with the levels of the present cycle, and the slot that limits it.
  struct StableStep {
    double step = 0;
    std::int64_t slot = -1;
  };
  StableStep stable_step(const std::vector<TileResult<S>>& tiles, double contact_frequency2) const;

  /// To be called with what every step has done; returns the elements, without eroded ones, of the tiles that were not
  /// updated in it.
  std::int64_t count_elements(const std::vector<TileResult<S>>& tiles, std::int32_t step);
  /// Elements per level, in the present cycle.
  std::vector<std::int64_t> elements_of_levels() const;
  void persist(StateArchive& archive, const Model<S>& model);
  std::size_t bytes() const;

 private:
  /// Nodes that are kicked within the steps of a level.
  struct MixedNodes {
    std::vector<std::int32_t> node;
    /// Records of the velocity in the first step since the level was updated, of the sum of what the steps after it
    /// differ by (so that uniform motion stays exact), and of the present velocity, while the mean one has its place.
    std::vector<S> first, differences, present;
    int steps = 0;  ///< since the level was updated
  };

  /// The tiles of each level, and what follows from them for the nodes.
  void sort_by_level(const Model<S>& model);
  void share_mixed_nodes();
  template <class Body>
  static void for_each_mixed_node(const MixedNodes& mixed, NodeStore<S>& nodes, const Body& body);
  std::vector<StepGroup> groups(const std::vector<TileResult<S>>& tiles, double contact_frequency2) const;
  void find_neighbours(const Model<S>& model);
  void lower_around(std::int32_t tile);
  void lower_beside_squeezed(const std::vector<StepGroup>& groups, std::vector<int>& levels) const;

  bool every_node_;
  Subdomain<S>* domain_;
  int top_ = 0;
  std::vector<int> level_, next_level_;  ///< per tile
  std::vector<int> highest_, own_;       ///< per tile, from the mesh
  double planned_step_ = 0;              ///< the smallest stable step at the last choice of levels
  int cycles_ = 0;                       ///< since then
  std::vector<std::int64_t> elements_;   ///< per tile, without eroded ones
  std::vector<Colouring> tiles_;         ///< per level
  std::vector<std::int8_t> level_of_span_;
  std::vector<MixedNodes> mixed_;                                  ///< per level; none for level 0
  std::vector<std::vector<std::int32_t>> neighbours_;              ///< per tile: tiles with a node in common
  std::vector<std::int32_t> tile_of_node_, tile_of_node_offsets_;  ///< the tiles of each node
};

}  // namespace pinball

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <solver/base/colouring.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/model/model.hpp>
#include <solver/model/node_spans.hpp>

#include "resting_tiles.hpp"
#include "subcycling.hpp"
#include "tile_kernels.hpp"

namespace pinball {

/// Which step is made.
struct Due {
  std::int32_t step_of_cycle = 0;  ///< 0: all elements are updated, and then all energies are of one time
  bool first = false;              ///< of the run
  bool last = false;               ///< the step without a length that brings everything to one time

  bool all() const { return step_of_cycle == 0; }
};

/// What bounds the coming step.
struct StepBound {
  double stable = 0;             ///< largest stable step, the smallest one where steps differ [time]
  std::int64_t slot = -1;        ///< of the element that sets it
  bool by_contact = false;       ///< contact has the higher frequency
  std::int32_t cycle_steps = 1;  ///< steps until all elements have been updated
  double longest = std::numeric_limits<double>::infinity();  ///< beyond which no step goes, whatever is stable [time]
};

/// Elements and nodes that are due in a step: with subcycling those whose own step ends in it, else all, but for tiles
/// at rest. All elements at once are a cycle of one step, on one level.
template <class S>
class Schedule {
 public:
  /// domain: of several ranks, of which this schedule has the tiles; null: one process has all.
  explicit Schedule(const Model<S>& model, Subdomain<S>* domain = nullptr);

  std::int32_t cycle_steps() const { return subcycling_ ? subcycling_->cycle_steps() : 1; }
  /// Before the elements of a step are updated. results: of each tile, when it was last updated.
  void begin_step(const Model<S>& model, const Due& due, const std::vector<TileResult<S>>& results);

  /// The highest level whose tiles are due; they are updated from the highest to level 0.
  int highest_level(const Due& due) const { return subcycling_ ? subcycling_->due(due.step_of_cycle) : 0; }
  /// The tiles of a level, by colour; of several ranks those that this one works.
  const Colouring& tiles(int level) const { return subcycling_ ? subcycling_->tiles()[level] : awake_; }
  /// Whether the step of a tile ends in the one that is made, whoever works it, and whether it rests or not.
  bool is_due(std::int32_t tile, const Due& due) const {
    return !subcycling_ || subcycling_->is_due(tile, due.step_of_cycle);
  }
  /// The step that a tile makes; smallest: the smallest one just made.
  ElementStep<S> step_of(std::int32_t tile, const Due& due, const ElementStep<S>& smallest) const {
    return subcycling_ ? subcycling_->step(tile, due.all(), smallest) : smallest;
  }
  /// Whether a tile is updated although it rests (skip.resting = false): then it keeps its stable step.
  bool rests(std::int32_t tile) const { return resting_ && resting_->rests(tile); }
  /// Nodes between two levels have a mean velocity over the step of the higher one: it takes the place of the present
  /// velocity while the tiles of that level are updated.
  void show_mean_velocities(NodeStore<S>& nodes, int level) {
    if (subcycling_) subcycling_->use_mean_velocities(nodes, level);
  }
  void show_present_velocities(NodeStore<S>& nodes, int level) {
    if (subcycling_) subcycling_->use_present_velocities(nodes, level);
  }

  /// After the elements of a step were updated. Returns how many were not because they rest.
  std::int64_t end_work(const Model<S>& model);
  /// When all know what they have done: how many elements, without eroded ones, were not updated because their step
  /// is not over.
  std::int64_t count_elements(const Due& due, const std::vector<TileResult<S>>& results) {
    return subcycling_ ? subcycling_->count_elements(results, due.step_of_cycle) : 0;
  }

  /// The bound of elements and contact together; where all elements were updated, of the cycle that begins.
  /// element_step, slot: smallest stable step of the elements and who sets it; contact_frequency2: bound on the square
  /// of the contact frequency [1/time^2].
  StepBound bound(const Model<S>& model, const Due& due, const std::vector<TileResult<S>>& results, double element_step,
                  std::int64_t slot, double contact_frequency2);

  DueSpans due_spans(const Due& due) const {
    return subcycling_ ? subcycling_->due_nodes(due.step_of_cycle) : DueSpans{};
  }
  /// After a step in which all elements were updated: how many of the smallest steps the position of a node is ahead of
  /// the stresses.
  int steps_ahead(std::int32_t node) const {
    return subcycling_ ? subcycling_->due_nodes(0).steps(node / nodes_per_span) : 1;
  }
  /// When the nodes of a step have the velocities that they keep.
  void end_step(NodeStore<S>& nodes) {
    if (subcycling_) subcycling_->count_step(nodes);
  }

  /// To be called when velocities or element states were changed by others than the step: the next one works all tiles
  /// and looks anew which of them rest.
  void forget_resting() { resting_.reset(); }
  /// Null: not known, or nobody asks for it.
  const RestingTiles<S>* resting() const { return resting_ ? &*resting_ : nullptr; }
  /// Finds the tiles that rest, in a model without subcycling.
  void find_resting(const Model<S>& model);
  /// Of several ranks: whether a tile that another rank works rests.
  void set_other_resting(std::int32_t tile, bool rests) {
    if (resting_) resting_->set_other(tile, rests);
  }
  /// rests: per tile, as of RestingTiles::flags().
  void set_resting(const Model<S>& model, const std::vector<std::uint8_t>& rests);
  const Subcycling<S>* subcycling() const { return subcycling_ ? &*subcycling_ : nullptr; }

  /// model: with its own state read before.
  void persist(StateArchive& archive, const Model<S>& model);
  std::size_t bytes() const;

 private:
  void choose_awake(const Model<S>& model);
  Colouring deformable(const Model<S>& model) const;
  bool works(std::int32_t tile) const { return domain_ == nullptr || domain_->works(tile); }

  Subdomain<S>* domain_;
  std::optional<Subcycling<S>> subcycling_;  ///< only where the scene asks for it
  std::optional<RestingTiles<S>> resting_;   ///< without subcycling; known once all tiles have been updated
  Colouring awake_;                          ///< the tiles to work, without subcycling
  double contact_frequency2_ = 0;            ///< largest since the cycle began [1/time^2]
};

}  // namespace pinball

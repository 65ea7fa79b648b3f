#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <kernels/boundary/external_work.hpp>
#include <kernels/exec.hpp>
#include <kernels/tensor.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/contact/contact_settings.hpp>
#include <solver/contact/surface/contact_pairs.hpp>
#include <solver/contact/surface/held_directions.hpp>
#include <solver/contact/surface/node_bound.hpp>
#include <solver/contact/surface/surface_source.hpp>
#include <solver/contact/tied/tied_nodes.hpp>

#include "contact_rows.hpp"
#include "impulse_iterations.hpp"
#include "pair_names.hpp"
#include "row_system.hpp"

namespace pinball {

/// Result of one solution of the contact impulses.
struct ImpulseResult {
  double dissipated = 0;         ///< energy taken out since the solution before, see ImpulseSolver [energy]
  double penetration_ratio = 0;  ///< largest penetration, as it is, over the size of its pair [-]
  std::int32_t deepest = -1;     ///< first node of that pair; negative: nothing is deep
  std::int64_t pairs = 0;        ///< pairs that push
  int iterations = 0;            ///< iterations of the island of rows that took the most, by lagrange
  bool at_bound = false;         ///< they ended at the bound of their number
  bool unsolved = false;         ///< and what was left was not small
  double residual = 0;           ///< what they left, of the island with the most over its scale [length/time]
  double scale = 0;              ///< of that island: the largest rate that its impulses are to change [length/time]
};

/// Contact by impulses instead of springs: after accelerations are known and before positions move, impulses take out
/// the velocities v* with which gaps would close within the step (kernels/contact_impulse.hpp). They do not change the
/// stable step.
///
///   lagrange     the coupled system of the step, by iterations until it is solved (ImpulseIterations);
///   projection   one step towards it.
///
/// Release (Hughes, Taylor, Sackman, Curnier and Kanoknukulchai, Comp. Meths. Appl. Mech. Engrg. 8, 249-276, 1976): the
/// first impulse of a contact acts on nodes of half an element, so that it is half of what a step of a steady contact
/// gives. When a pair separates, its nodes get the other half; without it they ring for ever. It may not return more
/// energy than the pair has taken out.
///
/// Energy: what the impulses take out is the work of their forces, counted as all work is (external_work.hpp).
///
/// Friction (kernels/contact_friction.hpp): part of the coupled system, or, with projection, one step after that of the
/// impulses. Its work is counted with that of the impulses.
///
/// Rows are solved in double, and every sum has an order of its own, so that results do not depend on the number of
/// threads.
template <class S>
class ImpulseSolver {
 public:
  /// pairs: null, or kept by whoever keeps this.
  ImpulseSolver(const ContactSettings& settings, std::int32_t node_count, HeldDirections held,
                const ContactPairs* pairs = nullptr);

  /// Nodes that come to be held have lost their velocities along these since the rows were found.
  void take_held_directions(HeldDirections held) {
    held_ = std::move(held);
    has_stopped_nodes_ = true;
  }
  /// Begins the rows of the coming step (kernels/contact_row.hpp); those of the step before are gone.
  void begin_rows();
  /// Begins with the rows of some lists, one list after the other: what add_row() and add_node() make of each. Row has
  /// their arguments: first, second, direction, depth, size and pair; node and weight of its `nodes`, and
  /// give_to(*this), which adds it by these.
  template <class Row>
  void begin_rows(std::span<const std::span<const Row>> lists);
  /// Adds the row of two things that may touch within the coming step; its nodes follow. Each pair has one row.
  /// first, second: names that the pair keeps from step to step; direction: from body 2 to body 1; depth: penetration
  /// at the present positions, or negative gap [length]; size: what the depth is compared with, R1 + R2 [length].
  /// pair: by which they touch.
  void add_row(std::int64_t first, std::int64_t second, const Vec3<double>& direction, double depth, double size,
               PairOf pair = {});
  /// Adds a node of the store to the last row. weight: negative for the nodes of body 1, positive for those of body 2;
  /// each side sums to 1. Collapsed elements and spheres have a node at several corners: its weights add up. What has
  /// no weight is left out.
  /// A tied node is where its corners are: they take its place.
  void add_node(std::int32_t node, double weight) {
    const TiedNode* const tie = ties_ != nullptr ? ties_->tie_of(node) : nullptr;
    if (tie == nullptr) {
      add_free_node(node, weight);
      return;
    }
    for (std::size_t k = 0; k < 4; ++k) add_free_node(tie->corner[k], tie->weight[k] * weight);
  }
  /// ties: null, or kept by whoever keeps this.
  void set_ties(const TiedNodes<S>* ties) { ties_ = ties; }
  /// sides: null, or kept by whoever keeps this.
  void set_rigid_sides(const RigidSides* sides) { rigid_.sides = sides; }
  /// Whether a pair of these names pushed, or was deep, in the step before.
  bool has_touched(std::int64_t first, std::int64_t second) const {
    return place_in_memory(first, second) != PairNames::none;
  }
  /// All rows are there. dt: the step just made.
  void finish_rows(const SurfaceSource<S>& source, double dt);
  /// Largest change of velocity that stopping a gap will give one of its sides, of the gaps that close within two steps
  /// like the one just made; after finish_rows. By mean masses of the nodes on both sides [length/time].
  double expected_change(const SurfaceSource<S>& source, double dt) const;

  /// Solves for the impulses of the coming step and adds the forces that give them to the nodes.
  /// Loads, constraints and prescribed velocities must already be in the node forces and velocities; what the forces of
  /// the contact have in held directions is for them to take up again. bounds: of these nodes. They are rows of the
  /// system, too, but give no forces: that is for those to do who stop the nodes, when contact has given its own.
  ImpulseResult solve(const SurfaceSource<S>& source, const StepLengths& step, std::span<const NodeBound> bounds = {});
  /// Whether there were bounds.
  bool was_bounded() const { return !bounded_.empty(); }
  /// Then, when all forces on the nodes are known: counts the work of the impulses with the velocities that nodes have
  /// with these, which may differ from those of solve() by what it does not know of bounds. step: of solve().
  void follow_bounds(const SurfaceSource<S>& source, const StepLengths& step);

  /// Nodes of the rows, each once.
  const std::vector<std::int32_t>& nodes() const { return node_; }

  /// Adds the contact forces of the last solution, per node of the store [force].
  void add_node_forces(std::span<Point> node_force) const;
  /// Adds to the force on the first side of each pair that of the last solution [force].
  void add_pair_forces(std::vector<Point>& sums) const;

  void persist(StateArchive& archive, const SurfaceSource<S>& source);
  std::size_t bytes() const;

 private:
  /// What outlives a step, by the names of the pair.
  struct PairMemory {
    std::int64_t first, second;
    double depth;        ///< as far as approach has closed it, see limit_depth [length]
    double force;        ///< of the last step [force]
    double lost;         ///< energy that the pair has taken out, but for friction [energy]
    double friction[3];  ///< of the last step [force]
    bool slides;         ///< in the last step
  };
  /// What a row of rows_ is besides.
  struct Pair {
    double depth;              ///< penetration, or negative gap; see limit_depth [length]
    double seen;               ///< the same as it is, without the limit [length]
    double size;               ///< [length]
    double rate_before;        ///< G v in the middle of the step before [length/time]
    double rate_free;          ///< G v* [length/time]
    double force;              ///< of this step [force]
    double sliding_before[3];  ///< of the middle of the step before, across the direction [length/time]
    ExternalWork lost;         ///< in this step [energy]
    double taken;              ///< the same without friction [energy]
    PairMemory memory;
  };

  std::size_t place_in_memory(std::int64_t first, std::int64_t second) const {
    return names_.find(first, second, [&](std::size_t at) { return is_memory_of(at, first, second); });
  }
  bool is_memory_of(std::size_t at, std::int64_t first, std::int64_t second) const {
    return memory_[at].first == first && memory_[at].second == second;
  }
  /// The memory of a pair, which is looked for at `next` first: rows mostly come in the order of the step before.
  void recall(PairMemory& memory, std::size_t& next) const {
    std::size_t at = next;
    if (at >= memory_.size() || !is_memory_of(at, memory.first, memory.second)) {
      at = place_in_memory(memory.first, memory.second);
      if (at == PairNames::none) return;
    }
    memory = memory_[at];
    next = at + 1;
  }
  /// Entries of a row: its nodes of the store, each once, but for those without weight. Returns how many.
  template <class Row>
  static int entries_of(const Row& row, std::int32_t* node, double* weight);
  template <class Row>
  std::size_t put_rows(std::span<const Row> list, std::size_t number);
  template <class Row>
  void put_entries(std::span<const Row> list, std::size_t number, std::size_t first);
  void number_nodes();

  double rigid_inverse_mass(std::size_t i, const Vec3<double>& direction) const;
  bool has_free_node(const RowView& row) const;
  double mobile_share(const SurfaceSource<S>& source, const RowView& row) const;

  /// Where a node stands last in a row.
  struct LastEntry {
    std::size_t row;
    int entry;
  };
  static constexpr std::int32_t no_place = std::numeric_limits<std::int32_t>::max();

  void add_bounds(std::span<const NodeBound> bounds, double dt);
  void drop_bounds();
  bool is_bound(std::size_t i) const { return i >= contacts_; }
  void find_ways(const SurfaceSource<S>& source, RowTensor RigidSide::*way);
  Vec3<double> way_of(const RowView& row) const;
  void move_on_ways(double sign);
  void limit_depth(const SurfaceSource<S>& source, std::size_t i, double dt);
  void load_nodes(const SurfaceSource<S>& source, double velocity_step);
  void renew_rates_before(const SurfaceSource<S>& source);
  void set_rates(double velocity_step, double dt);
  void set_rate(std::size_t i, double velocity_step, double dt);
  void choose_active();
  bool has_friction() const { return has_friction_; }
  double friction_of(std::size_t i) const;
  void begin_friction(double velocity_step);
  void build_system(double velocity_step);
  double rate_scale(std::size_t i) const;
  void solve_coupled(ImpulseResult& result);
  void find_deepest(ImpulseResult& result) const;
  void set_budget();
  /// Energy that a pair may give back in this step.
  double budget_of(const Pair& pair) const { return budget_share_ * std::max(0.0, pair.memory.lost); }
  bool opens(std::int64_t k) const;
  bool find_opening();
  double shared_inverse_mass(std::int64_t k) const;
  void share_releases();
  void move_by_releases();
  double released_by(std::int64_t k, double velocity_step) const;
  void release(double velocity_step);
  void rub_by_releases();
  std::optional<std::pair<std::int32_t, std::int32_t>> rigid_pair(const SurfaceSource<S>& source,
                                                                  const RowView& row) const;
  void find_most_friction(const SurfaceSource<S>& source);
  Vec3<double> finish_row(std::int64_t k, const StepLengths& step);
  ExternalWork keep_friction(std::int64_t k, const Vec3<double>& after, const StepLengths& step);
  void give_forces(const SurfaceSource<S>& source, const StepLengths& step);
  void sum_up(ImpulseResult& result);
  void remember();
  void name_memory();
  void check(const StateArchive& archive, std::int32_t node_count) const;
  /// Rows from which on a second thread gains more than it has to wait for.
  static constexpr std::size_t rows_worth_a_thread = 512;
  /// Calls body(i) for i below count, of rows or their nodes, in any order.
  template <class Body>
  void for_all(const char* name, std::size_t count, const Body& body) const {
    const std::int64_t end = count;
    if (rows_.size() < rows_worth_a_thread) {
      parallel_for(name, RangePolicy<Serial>{0, end}, body);
    } else {
      parallel_for(name, RangePolicy<>{0, end}, body);
    }
  }

  void add_free_node(std::int32_t node, double weight);

  const TiedNodes<S>* ties_ = nullptr;
  RigidPlaces rigid_;
  // Where there are rigid bodies, per entry of node_, as records:
  Array<double> arm_;  ///< [length]
  Array<double> way_;  ///< what velocities on the way of a step are more than those that nodes have [length/time]
  std::vector<double> rigid_release_share_;  ///< as release_share_, per rigid body
  bool lagrange_ = false;
  PairRule friction_;                   ///< of rows without a pair
  const ContactPairs* contact_pairs_;   ///< or null
  bool has_friction_ = false;           ///< of contact itself
  bool rubs_ = false;                   ///< or of a bound of this step
  bool has_stopped_nodes_ = false;      ///< constraints have begun since the rows were found
  std::vector<PairOf> pair_of_row_;     ///< one per row, only where there are pairs
  ContactRows rows_;                    ///< of places in node_
  std::vector<FrictionRow> frictions_;  ///< one per row, only where there is friction
  std::vector<Pair> pairs_;             ///< one per row
  std::vector<double> most_friction_;   ///< one per active row with friction, see there [mass length/time]
  std::vector<double> slid_;            ///< how fast in the step just made, one per row with friction [length/time]
  std::size_t contacts_ = 0;            ///< rows before those of bounds
  std::vector<double> bound_friction_;  ///< mu, one per row of a bound [-]
  std::vector<std::int32_t> bounded_;   ///< places of the nodes that have a bound, ascending
  std::vector<std::int32_t> active_;    ///< rows that take part
  RowSystem system_;                    ///< of the active rows
  ImpulseIterations iterations_;
  std::vector<ImpulseNode> nodes_;        ///< per entry of node_
  std::vector<std::uint8_t> opens_;       ///< per row of system_
  std::vector<double> release_share_;     ///< per entry of nodes_: sum of |w| F over the rows that open [force]
  Array<double> row_vector_;              ///< records, of the rows of system_: what they release, then their forces
  Array<double> velocity_;                ///< records of four numbers, per entry of node_
  std::vector<std::int32_t> node_;        ///< of the store, per entry of nodes_
  std::vector<LastEntry> last_entry_;     ///< per entry of node_
  std::vector<PairMemory> memory_;        ///< of the last step, in the order of its rows
  PairNames names_;                       ///< where the memory of a pair is
  std::size_t next_memory_ = 0;           ///< where that of the next row is looked for first
  std::vector<std::int32_t> node_place_;  ///< per node of the store: place in nodes_ or no_place
  HeldDirections held_;
  double taken_ = 0;         ///< energy that all pairs have taken out, but for friction [energy]
  double budget_share_ = 0;  ///< part of what a pair has taken out that it may give back [-]
  double pending_ = 0;       ///< energy dissipated by the last impulses in the step after them
};

template <class S>
inline void ImpulseSolver<S>::add_free_node(std::int32_t node, double weight) {
  if (weight == 0) return;
  const std::size_t number = rows_.size() - 1;
  ImpulseRow& row = rows_.rows[number];
  std::int32_t& place = node_place_[node];
  if (place == no_place) {
    place = node_.size();
    node_.push_back(node);
    last_entry_.push_back({number, -1});
  }
  LastEntry& last = last_entry_[place];
  if (last.row == number && last.entry >= 0) {
    rows_.weight[row.first + last.entry] += weight;
    return;
  }
  last = {number, row.nodes};
  rows_.node.push_back(place);
  rows_.weight.push_back(weight);
  ++row.nodes;
}

}  // namespace pinball

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <kernels/contact_friction.hpp>
#include <kernels/exec/array.hpp>
#include <solver/base/records.hpp>

#include "contact_rows.hpp"
#include "rigid_rows.hpp"

namespace pinball {

/// Consecutive rows, and nodes, that no other rows and nodes of a system are coupled with.
struct Island {
  std::int32_t first_row, end_row;
  std::int32_t first_node, end_node;
  std::int32_t end_free = 0;                    ///< of the nodes that move by themselves; then those of rigid bodies
  std::int32_t first_group = 0, end_group = 0;  ///< of rigid bodies
  bool rubs = false;                            ///< whether some of its rows may

  std::int32_t rows() const { return end_row - first_row; }
};

/// Consecutive nodes of a system that are of one rigid body.
struct RigidGroup {
  std::int32_t body, first_node, end_node;
};

/// The rows of a contact system that take part, numbered anew island by island, else in the order in which they were
/// added; and for each node its rows. All of it follows from the rows alone.
class RowSystem {
 public:
  /// What a row is in a solution, along a direction of length one. (That of balls as they are added is longer.)
  struct Row {
    Vec3<double> direction;  ///< a
    double length;           ///< of the direction with which it was added [-]
    double rate;             ///< r [length/time]
    double inverse_mass;     ///< G M^-1 G^T, of the row by itself [1/mass]
    double bound;            ///< at least the row sum of G M^-1 G^T, in whatever direction [1/mass]
    double sum_along;        ///< the same along the direction [1/mass]
    double sum_across;       ///< and across it [1/mass]
    double coefficient;      ///< mu [-]
    double scale;            ///< rate that impulses are to change [length/time]
  };

  /// active: numbers of the rows that take part, ascending; nodes: per place of a node; frictions: per row, or empty;
  /// rigid: of the places. rows, nodes and rigid have to outlive the use of this. Scales are for the caller to set.
  void build(const ContactRows& rows, const std::vector<std::int32_t>& active, const std::vector<ImpulseNode>& nodes,
             const std::vector<FrictionRow>& frictions, const RigidPlaces& rigid = {});

  std::int32_t size() const { return order_.size(); }
  /// The number of row k among all rows.
  std::int32_t original(std::int64_t k) const { return order_[k]; }
  const Row& row(std::int64_t k) const { return constants_[k]; }
  Row& row(std::int64_t k) { return constants_[k]; }
  RowView entries(std::int64_t k) const {
    const std::size_t first = first_entry_[k];
    const int nodes = first_entry_[k + 1] - first_entry_[k];
    return {&row(k).direction.x, nodes, node_of_.data() + first, weight_of_.data() + first};
  }
  /// p of an impulse p a + q of row k, a being the direction with which it was added.
  double impulse_as_added(std::int64_t k, const Vec3<double>& b) const {
    return dot(row(k).direction, b) / row(k).length;
  }
  /// Whether there is friction.
  bool rubs() const { return rubs_; }
  std::span<const Island> islands() const { return islands_; }
  /// Nodes of rigid bodies, body by body, in the order of the islands: all that rows have of a body is in one.
  std::span<const RigidGroup> groups() const { return groups_; }
  const RigidPlaces& rigid() const { return rigid_; }
  /// Places of the nodes, island by island.
  std::span<const std::int32_t> nodes() const { return node_order_; }
  std::size_t places() const { return nodes_->size(); }
  const ImpulseNode& node(std::int32_t place) const { return (*nodes_)[place]; }

  /// sum_I w_I v_I of a row. velocities: records of four numbers, per place of a node.
  Vec3<double> approach(std::int64_t k, const double* velocities) const {
    const RowView row = entries(k);
    return weighted_sum(row.nodes, row.node, row.weight, velocities);
  }
  /// sum_i w_iI b_i of a node. impulses: records of four numbers, per row.
  Vec3<double> impulse_at(std::int32_t place, const double* impulses) const {
    const std::int32_t first = rows_of_node_[place];
    return weighted_sum(rows_of_node_[place + 1] - first, row_.data() + first, weight_.data() + first, impulses);
  }
  /// Takes the impulses of its rows from the velocity of a node: records of four numbers both.
  void move(std::int32_t place, const double* impulses, double* velocities) const {
    const Vec3<double> change = moved_by(node(place), impulse_at(place, impulses));
    double* const v = record(velocities, place);
    v[0] -= change.x;
    v[1] -= change.y;
    v[2] -= change.z;
  }
  /// Calls body(k, w) for the rows of a node, in their order.
  template <class Body>
  void for_rows_of(std::int32_t place, const Body& body) const {
    const std::int32_t first = rows_of_node_[place];
    const std::int32_t end = rows_of_node_[place + 1];
    for (std::int32_t e = first; e < end; ++e) {
      body(row_[e], weight_[e]);
    }
  }
  std::size_t bytes() const;

 private:
  void find_islands(const std::vector<std::int32_t>& active);
  void sort(const std::vector<std::int32_t>& active);
  void copy_entries();
  void list_rows_of_nodes();
  void set_constants(const std::vector<FrictionRow>& frictions);
  void join_rigid_bodies();
  void sort_rigid_nodes();
  void add_rigid_constants();
  std::int32_t root(std::int32_t place);

  const ContactRows* rows_ = nullptr;
  const std::vector<ImpulseNode>* nodes_ = nullptr;
  RigidPlaces rigid_;
  bool rubs_ = false;
  std::vector<std::int32_t> order_;        ///< number among all rows, per row
  std::vector<std::int32_t> first_entry_;  ///< of each row; rows + 1
  Array<std::int32_t> node_of_;            ///< per entry
  Array<double> weight_of_;                ///< per entry
  std::vector<std::int32_t> node_order_;   ///< place, per node
  std::vector<Island> islands_;
  std::vector<RigidGroup> groups_;
  Array<Row> constants_;                    ///< per row
  std::vector<std::int32_t> rows_of_node_;  ///< where the rows of a place begin in row_ and weight_; places + 1
  Array<std::int32_t> row_;
  Array<double> weight_;
  std::vector<double> weights_;  ///< of all rows at a place, without their signs
  // Only while this is built; kept for their memory.
  std::vector<std::int32_t> parent_;  ///< of a place in the tree of its island
  std::vector<std::int32_t> island_, next_;
  std::vector<std::int32_t> rigid_places_;  ///< places of rigid bodies, body by body
  std::vector<double> along_, most_;        ///< per rigid body: sums over its rows of roots of what they have of it
};

}  // namespace pinball

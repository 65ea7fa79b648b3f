#pragma once

#include <algorithm>
#include <utility>

#include "boundary_kernels.hpp"
#include "loops.hpp"

namespace pinball {

/// First of each node's entries of a list in the order of nodes, and the length of the list.
template <class Entry>
std::vector<std::int32_t> first_of_nodes(const std::vector<Entry>& list) {
  std::vector<std::int32_t> first;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i == 0 || list[i].node != list[i - 1].node) first.push_back(i);
  }
  if (!list.empty()) first.push_back(list.size());
  return first;
}

template <class S, class Space>
class SpaceHeldNodes final : public HeldNodeKernels<S> {
 public:
  explicit SpaceHeldNodes(SharedNodes* sharing) : sharing_(sharing) {}

  void set(const std::vector<NodeConstraint<S>>& constraints, const std::vector<NodePrescription<S>>& prescribed,
           bool keeps) override {
    constraints_ = list_in<Space>(constraints);
    const std::vector<std::int32_t> first_held = first_of_nodes(constraints);
    first_held_ = list_in<Space>(first_held);
    find_spans(constraints, first_held);
    prescribed_ = list_in<Space>(prescribed);
    first_moved_ = list_in<Space>(first_of_nodes(prescribed));
    reaction_.reset(prescribed.size());
    held_.reset(keeps ? constraints.size() : 0);
    if (sharing_ == nullptr) return;
    shared_ = shared_list(sharing_, prescribed.size(), [prescribed](std::int64_t i) { return prescribed[i].node; });
    owner_moved_ = owners(prescribed);
    owner_held_ = keeps ? owners(constraints) : std::vector<std::int32_t>();
    // What the rank has that moves the node, for the forces of tables.
    if (!std::exchange(is_kept_, true)) sharing_->keep_with_state([this] { share_forces(); });
  }
  void clear_forces() override {
    reaction_.reset(reaction_.size());
    held_.reset(held_.size());
  }

  void constrain(const NodeArrays<S>& nodes, double velocity_step, const DueSpans& due) override {
    const DueNodes due_nodes{due.level_of_span == nullptr ? nullptr : due.level_of_span->data(), nodes_per_span,
                             due.level};
    const ConstrainNodes<S> constrain{nodes,     constraints_.data(), first_held_.data(),
                                      due_nodes, velocity_step,       held_.empty() ? nullptr : held_.data()};
    if constexpr (on_host<Space>) {
      if (due.level_of_span != nullptr) {
        constrain_spans(constrain, due);
        return;
      }
    }
    for_each<Space>("constraints", count(first_held_), constrain);
  }
  void prescribe(const NodeArrays<S>& nodes, const std::vector<double>& factors, double velocity_step) override {
    factor_.renew(factors.size());
    deep_copy(factor_, factors.data(), factors.size());
    for_each<Space>("prescribed velocities", count(first_moved_),
                    MoveNodes<S>{nodes, prescribed_.data(), first_moved_.data(), factor_.data(),
                                 static_cast<S>(velocity_step), reaction_.data()});
  }
  void add_work(const NodeArrays<S>& nodes, const StepLengths& step, ExternalWork& sum) const override {
    const MovingForce<S> forces{prescribed_.data(), reaction_.data()};
    add_sum<Space>("work of prescribed velocities", prescribed_.size(),
                   WorkOfForces<S, MovingForce<S>>{nodes, forces, step}, sum, shared_);
  }
  double energy_along(const NodeArrays<S>& nodes, const StepLengths& step) const override {
    double sum = 0;
    add_sum<Space>("energy of constrained motion", constraints_.size(),
                   EnergyAlong<S>{nodes, constraints_.data(), step.before}, sum);
    return sum;
  }
  void share_forces() override {
    if (!owner_moved_.empty()) share_array(*sharing_, owner_moved_, reaction_);
    if (!owner_held_.empty()) share_array(*sharing_, owner_held_, held_);
  }
  VectorSum force_of_constraint(std::int32_t table) const override {
    VectorSum sum;
    const ForceOfTable<double, NodeConstraint<S>> of_table{constraints_.data(), table, held_.data()};
    add_sum<Space>("force of a constraint", held_.size(), of_table, sum);
    return sum;
  }
  VectorSum force_of_prescribed(std::int32_t table) const override {
    VectorSum sum;
    const ForceOfTable<S, NodePrescription<S>> of_table{prescribed_.data(), table, reaction_.data()};
    add_sum<Space>("force of a prescribed velocity", reaction_.size(), of_table, sum);
    return sum;
  }
  std::size_t bytes() const override {
    return constraints_.bytes() + first_held_.bytes() + prescribed_.bytes() + first_moved_.bytes() + factor_.bytes() +
           reaction_.bytes() + held_.bytes();
  }

 private:
  void find_spans(const std::vector<NodeConstraint<S>>& constraints, const std::vector<std::int32_t>& first) {
    first_of_span_.assign(1, 0);
    for (std::int32_t i = 0; i + 1 < std::ssize(first); ++i) {
      const std::size_t span = constraints[first[i]].node / nodes_per_span;
      first_of_span_.resize(std::max(first_of_span_.size(), span + 1), i);
    }
    first_of_span_.push_back(first.empty() ? 0 : static_cast<std::int32_t>(first.size()) - 1);
  }
  /// The same where not all nodes are due: a span at a time.
  void constrain_spans(const ConstrainNodes<S>& of, const DueSpans& due) const {
    ConstrainNodes<S> constrain = of;
    constrain.due = {};
    parallel_for("constraints", RangePolicy<Space>{0, std::ssize(first_of_span_) - 1}, [&](std::int64_t span) {
      if (!due.contain(span)) return;
      for (std::int32_t i = first_of_span_[span]; i < first_of_span_[span + 1]; ++i) constrain(i);
    });
  }
  template <class Entry>
  std::vector<std::int32_t> owners(const std::vector<Entry>& list) const {
    std::vector<std::int32_t> owner;
    for (const Entry& entry : list) owner.push_back(sharing_->rank_of_node(entry.node));
    return owner;
  }
  using Memory = typename Space::memory_space;
  static std::int64_t count(const Array<std::int32_t, Memory>& first) {
    return first.empty() ? 0 : static_cast<std::int64_t>(first.size()) - 1;
  }

  SharedNodes* sharing_;
  SharedList shared_;                                   ///< of prescribed_
  std::vector<std::int32_t> owner_moved_, owner_held_;  ///< ranks of prescribed_, and of constraints_ if held_ is kept
  bool is_kept_ = false;                                ///< share_forces, with the state
  Array<NodeConstraint<S>, Memory> constraints_;
  Array<std::int32_t, Memory> first_held_;   ///< per held node and one more: its constraints
  std::vector<std::int32_t> first_of_span_;  ///< per span up to the last with a held node, and one more: in first_held_
  Array<NodePrescription<S>, Memory> prescribed_;
  Array<std::int32_t, Memory> first_moved_;  ///< per moved node and one more: its prescriptions
  Array<double, Memory> factor_;             ///< per table
  Array<S, Memory> reaction_;                ///< per prescription [force]
  Array<double, Memory> held_;               ///< along its normal, per constraint; empty: it is not kept [force]
};

}  // namespace pinball

#include <solver/base/error.hpp>

#include "solver.hpp"

namespace pinball {

template <class S>
void Solver<S>::follow_rank_0(const Answer& answer) {
  for (;;) {
    switch (domain_->next_order()) {
      case RankOrder::step:
      case RankOrder::finish:
        try {
          advance(domain_->last_order() == RankOrder::finish);
        } catch (const RunError&) {  // rank 0 has come to the same, and says so
        }
        break;
      case RankOrder::state:
        domain_->send_state(model_);
        break;
      case RankOrder::answer:
        domain_->ask(0, answer);
        break;
      case RankOrder::end:
        return;
    }
  }
}

template <class S>
std::vector<std::int32_t> Solver<S>::rank_of_elements() const {
  std::vector<std::int32_t> ranks;
  if (!domain_) return ranks;
  for (const std::int64_t slot : model_.slot_of_element) ranks.push_back(domain_->rank_of_slot(slot));
  return ranks;
}

/// What contact, ties, equations and rigid bodies read and move, each on all ranks, or beside a device.
template <class S>
void Solver<S>::choose_common_nodes() {
  if (contact() != nullptr) space_->add_common(contact()->nodes());
  std::vector<std::int32_t> nodes;
  for (const auto& [node, mass] : tied_.nodes().masses_without()) nodes.push_back(node);
  for (const RigidNodes& rigid : model_.rigid) nodes.insert(nodes.end(), rigid.nodes.begin(), rigid.nodes.end());
  nodes.insert(nodes.end(), equations_.nodes().begin(), equations_.nodes().end());
  space_->add_common(nodes);
}

/// Where some begin or end, ranks add up other sums, for which they need nodes that they had not.
template <class S>
void Solver<S>::follow_constraints() {
  if (domain_ && boundary_.changes(clock_.time())) space_->bring_nodes();
  if (!boundary_.follow(model_, space_->nodes(NodeNumbers::none), clock_.time(), clock_.lengths())) return;
  contact_.take_held_directions(model_);
  equations_.take_held_directions(model_);
  if (domain_) domain_->connect_sums(model_);
}

/// Of several ranks all fail in the same way where guards find something, after all messages of a step.
template <class S>
void Solver<S>::advance(bool last) {
  if (!domain_) {
    make_cycle(last);
    return;
  }
  domain_->begin_cycle();
  try {
    make_cycle(last);
  } catch (const RunError&) {
    domain_->end_cycle();
    throw;
  }
  domain_->end_cycle();
}

template void Solver<double>::follow_rank_0(const Answer&);
template void Solver<float>::follow_rank_0(const Answer&);
template std::vector<std::int32_t> Solver<double>::rank_of_elements() const;
template std::vector<std::int32_t> Solver<float>::rank_of_elements() const;
template void Solver<double>::choose_common_nodes();
template void Solver<float>::choose_common_nodes();
template void Solver<double>::follow_constraints();
template void Solver<float>::follow_constraints();
template void Solver<double>::advance(bool);
template void Solver<float>::advance(bool);

}  // namespace pinball

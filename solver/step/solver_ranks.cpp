#include <solver/base/error.hpp>

#include "solver.hpp"

namespace pinball {

template <class S>
void Solver<S>::follow_rank_0() {
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
      case RankOrder::end:
        return;
    }
  }
}

/// Of several ranks all fail in the same way where guards find something, after all messages of a step.
template <class S>
void Solver<S>::advance(bool last) {
  if (!domain_) {
    make_cycle(last);
    return;
  }
  domain_->begin_step();
  try {
    make_cycle(last);
  } catch (const RunError&) {
    domain_->end_step();
    throw;
  }
  domain_->end_step();
}

template void Solver<double>::follow_rank_0();
template void Solver<float>::follow_rank_0();
template void Solver<double>::advance(bool);
template void Solver<float>::advance(bool);

}  // namespace pinball

#pragma once

#include <algorithm>
#include <cstdint>

#include <solver/base/state_archive.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// Elements with a corner that has turned over (kernels/folding.hpp): how many there are, and which was the first.
class InsideOutWatch {
 public:
  std::int64_t now() const { return now_; }
  std::int64_t most() const { return most_; }  ///< at once
  double first_time() const { return first_time_; }
  std::int64_t first_slot() const { return first_slot_; }  ///< negative: it was never set

  /// time: of the forces. Returns whether there have been none before: then the first is asked for.
  bool look(std::int64_t count, double time) {
    const bool first = count > 0 && most_ == 0;
    if (first) first_time_ = time;
    now_ = count;
    most_ = std::max(most_, count);
    return first;
  }
  void set_first(std::int64_t slot) { first_slot_ = slot; }

  void persist(StateArchive& archive) { archive(now_, most_, first_time_, first_slot_); }

 private:
  std::int64_t now_ = 0, most_ = 0;
  double first_time_ = 0;
  std::int64_t first_slot_ = -1;
};

/// Whether a body's element.inside_out is to stop the run.
bool may_stop_inside_out(const Scene& scene);

struct FoldedElement {
  std::int64_t slot = -1;
  double share = 1;  ///< of its least corner: eight times the Jacobian over the volume [-]
};

/// The living element whose least corner is smallest; dt: the step from the forces to the positions. Its slot is
/// negative where there is none. of_bodies_that_stop: among those whose element.inside_out is to stop the run.
template <class S>
FoldedElement most_folded(const Model<S>& model, double dt, bool of_bodies_that_stop);

}  // namespace pinball

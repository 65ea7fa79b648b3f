#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include <solver/base/state_archive.hpp>
#include <solver/contact/algorithm/contact_algorithm.hpp>
#include <solver/elements/internal_forces.hpp>
#include <solver/results/skipped_work.hpp>

namespace pinball {

/// What the steps of a run have computed, left out and found.
class RunCounts {
 public:
  const WorkCounts& work() const { return work_; }
  std::int64_t eroded_elements() const { return eroded_elements_; }
  std::int64_t pairs() const { return pairs_; }          ///< in contact at the time of the forces
  std::int64_t pairs_max() const { return pairs_max_; }  ///< most of them at once
  double penetration_ratio_max() const { return deepest_.ratio; }
  double deepest_time() const { return deepest_.time; }        ///< of the largest penetration
  std::int64_t deepest_node() const { return deepest_.node; }  ///< of the store, at it; negative: there was none

  /// surface: elements of the contact surface, negative without contact; all: elements of the scene; time: of the
  /// forces.
  template <class S>
  void count(const Due& due, const InternalForceResult<S>& element, const ContactWork& contact, std::int64_t surface,
             std::int64_t all, double time) {
    if (!due.last) {
      work_.eroded_element_steps += eroded_elements_;
      work_.resting_element_steps += element.resting_elements;
      work_.subcycled_element_steps += element.subcycled_elements;
      if (surface >= 0) {
        work_.surface_element_steps += surface;
        work_.inner_element_steps += all - eroded_elements_ - surface;
      }
    }
    work_.iterations += contact.iterations;
    eroded_elements_ += element.eroded_count;
    if (contact.penetration_ratio > deepest_.ratio) deepest_ = {contact.penetration_ratio, time, contact.deepest};
    pairs_ = contact.pairs;
    pairs_max_ = std::max(pairs_max_, pairs_);
  }
  void count_search(double seconds) { work_.search_seconds += seconds; }

  void persist(StateArchive& archive) {
    archive(work_, eroded_elements_, pairs_, pairs_max_, deepest_);
    const std::array counts{work_.resting_element_steps,
                            work_.subcycled_element_steps,
                            work_.eroded_element_steps,
                            work_.surface_element_steps,
                            work_.inner_element_steps,
                            work_.searches,
                            work_.searches_skipped,
                            work_.iterations.solutions,
                            work_.iterations.iterations,
                            work_.iterations.largest,
                            work_.iterations.at_bound,
                            work_.iterations.unsolved,
                            eroded_elements_,
                            pairs_,
                            pairs_max_};
    archive.require_all(counts, -most, most);
    archive.require(work_.iterations.residual >= 0 && work_.iterations.relative >= 0);
  }

  /// Beyond what any run counts, and sums of a few of them do not overflow.
  static constexpr std::int64_t most = std::int64_t(1) << 60;

 private:
  WorkCounts work_;
  std::int64_t eroded_elements_ = 0, pairs_ = 0, pairs_max_ = 0;
  struct Deepest {
    double ratio = 0, time = 0;
    std::int64_t node = -1;  // no padding in what is saved
  } deepest_;
};

}  // namespace pinball

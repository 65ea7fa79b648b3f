#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <kernels/boundary/external_work.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/results.hpp>
#include <solver/scene.hpp>

namespace pinball {

/// Forces and impulses of the contact pairs of a scene.
class PairLedger {
 public:
  explicit PairLedger(const std::vector<ContactPair>& pairs) : sums_(pairs.size()) {
    for (const ContactPair& pair : pairs) results_.push_back({pair.name});
  }
  bool any() const { return !results_.empty(); }
  /// Books a step. add_forces(sums) adds to the force on the first side of each pair [force].
  template <class AddForces>
  void book(const AddForces& add_forces, const StepLengths& step) {
    sums_.assign(results_.size(), Point{});
    add_forces(sums_);
    for (std::size_t p = 0; p < results_.size(); ++p) {
      PairResult& result = results_[p];
      result.force = sums_[p];
      result.force_max = std::max(result.force_max, std::hypot(sums_[p][0], sums_[p][1], sums_[p][2]));
      for (std::size_t k = 0; k < 3; ++k) result.impulse[k] += step.velocity() * sums_[p][k];
    }
  }
  const std::vector<PairResult>& results() const { return results_; }
  void persist(StateArchive& archive) {
    for (PairResult& result : results_) archive(result.force, result.force_max, result.impulse);
  }

 private:
  std::vector<PairResult> results_;
  std::vector<Point> sums_;
};

}  // namespace pinball

#pragma once

#include <cstdint>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/model/initial_overlap.hpp>

namespace pinball {

/// Bodies that share space when contact between them begins, and nodes behind rigid walls when these begin, where that
/// is later than the start.
class BegunOverlaps {
 public:
  /// Whether a pair of the scene begins in the step to a time, from the time before.
  static bool begins(const Scene& scene, double before, double time);
  /// Then; mesh: as it is at that time.
  void look(const Scene& scene, const ModelMesh& mesh, double before, double time);

  /// Of rigid walls that begin then: what lies behind them.
  void take_passed_walls(const std::vector<InitialOverlap>& passed) {
    passed_walls_.insert(passed_walls_.end(), passed.begin(), passed.end());
  }

  const std::vector<InitialOverlap>& found() const { return found_; }
  const std::vector<InitialOverlap>& passed_walls() const { return passed_walls_; }
  void persist(StateArchive& archive, std::int64_t nodes);

 private:
  std::vector<InitialOverlap> found_, passed_walls_;
};

}  // namespace pinball

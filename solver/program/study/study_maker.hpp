#pragma once

#include <optional>
#include <string>

#include <solver/scene.hpp>

#include "convergence_study.hpp"

namespace pinball {

/// Makes the runs of a study one by one, as long as its time lasts, and keeps what they say.
class StudyMaker {
 public:
  StudyMaker(const Scene& scene, const StudySettings& settings);
  StudyMaker(const StudyMaker&) = delete;
  StudyMaker& operator=(const StudyMaker&) = delete;

  /// Into its place from coarse to fine. Throws InputError where a quantity is unknown.
  void run_mesh(const MeshFactor& factor);
  /// On the mesh of the scene itself where that is among them and its run came to its end, else on the coarsest.
  /// Contact is one where anything has touched.
  void run_sources();
  /// With one of the sources on another mesh.
  void run_trial(std::size_t source, const MeshFactor& factor);
  /// Anew what the runs say; where none came to its end: nothing.
  void draw();

  const ConvergenceStudy& study() const { return study_; }
  const Scene& scene() const { return scene_; }
  double seconds_left() const { return budget_.left(); }

  /// Of a run on a mesh, with one of the sources if one is named, from those that were made; none: there are none [s].
  std::optional<double> expected_seconds(const MeshFactor& factor, std::optional<std::size_t> source = {}) const;

 private:
  StudyRun run(const Scene& scene, const std::string& name, const std::string& what, const StudyFolder& folder,
               std::optional<double> expected);
  void run_source(const SourceVariation& variation);
  StudyRun run_variation(const SourceVariation& variation, std::size_t number, const StudyFolder& folder,
                         std::optional<double> expected);
  /// How many runs of the ensemble go side by side, each on one thread: that takes less time than one after the other
  /// on all threads (docs/performance.md). 1: they go one after the other.
  int runs_side_by_side(const SourceVariation& ensemble) const;
  /// Of a mesh: how many have their fields written, for the page.
  int states_to_show(const Scene& refined, const MeshFactor& factor) const;
  /// How many times the work of the same mesh a source takes, as long as no run has shown it.
  double work_of_source(const StudySource& source) const;

  const Scene& scene_;
  const StudySettings& settings_;
  StudyBudget budget_;
  StudyFolder folder_;
  ConvergenceStudy study_;
  bool has_sources_mesh_ = false;  ///< it has been chosen, also where no source is asked for
};

}  // namespace pinball

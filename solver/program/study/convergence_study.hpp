#pragma once

#include <optional>
#include <string>
#include <vector>

#include <solver/scene.hpp>

#include "grid_convergence.hpp"
#include "mesh_factor.hpp"
#include "study_runs.hpp"

namespace pinball {

struct StudyMesh {
  MeshFactor factor;
  std::string counts;  ///< of elements: "bar: core 8, ring 4, layers 80"
  StudyRun run;
};

struct StudyQuantity {
  std::string name;  ///< as run_results.hpp has it
  std::string unit;
  std::vector<std::optional<double>> values;   ///< of each mesh; none: its run failed
  double scale = 0;                            ///< the largest of the runs
  std::optional<GridConvergence> convergence;  ///< none: fewer than three meshes have a value
};

/// What a scene says on meshes of several sizes.
struct ConvergenceStudy {
  std::string scene, title;
  std::vector<StudyMesh> meshes;  ///< from coarse to fine
  std::vector<StudyQuantity> quantities;

  /// The mesh of the scene itself, if it is among them.
  std::optional<std::size_t> own_mesh() const;
  bool stopped() const;  ///< a signal ended it
  bool failed() const;   ///< a run has
};

struct StudySettings {
  std::vector<MeshFactor> factors;  ///< from coarse to fine
  std::vector<std::string> of;      ///< quantities; empty: default_quantities()
  StudyFolder folder;
};

/// Runs the scene on each mesh, from coarse to fine, and draws what they say. Throws InputError where the scene cannot
/// be refined or a quantity is unknown, which the coarsest run shows.
ConvergenceStudy study_convergence(const Scene& scene, const StudySettings& settings);

}  // namespace pinball

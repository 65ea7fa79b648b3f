#pragma once

#include <optional>
#include <string>
#include <vector>

#include <solver/scene.hpp>

#include "costs/study_limits.hpp"
#include "error_sources.hpp"
#include "grid_convergence.hpp"
#include "mesh_factor.hpp"
#include "study_runs.hpp"

namespace pinball {

struct StudyMesh {
  MeshFactor factor;
  std::string counts;  ///< of elements: "bar: core 8, ring 4, layers 80"
  StudyRun run;
};

/// What something else than the mesh does, on one mesh.
struct StudySource {
  ErrorSource source;
  std::string name, what;      ///< as in SourceVariation
  std::vector<StudyRun> runs;  ///< one; of chance an ensemble
};

/// One of the sources on another mesh: whether it reaches an error for less.
struct StudyTrial {
  std::size_t source = 0;  ///< of the sources of the study
  MeshFactor factor;
  std::string counts;  ///< as of StudyMesh
  StudyRun run;
};

/// Of the scale of a quantity: percent of a value below are of no use.
inline constexpr double small_value = 1e-3;

struct StudyQuantity {
  std::string name;  ///< as run_results.hpp has it
  std::string unit;
  std::vector<std::optional<double>> values;   ///< of each mesh; none: its run failed
  double scale = 0;                            ///< the largest of the runs
  std::optional<GridConvergence> convergence;  ///< none: fewer than three meshes have a value
  /// What each source moves it by: value less that of the same mesh, of chance the standard deviation of the ensemble
  /// and that value; none: its run failed.
  std::vector<std::optional<double>> moved{};
  std::optional<double> mean_of_chance{};
  /// Of a curve over time, whose value is its distance from this: what elements of no size would give, or where nothing
  /// converges the finest one.
  std::optional<TimeCurve> limit{};

  /// None: the run has none.
  std::optional<double> value_in(const RunResults& results) const;
};

/// What a scene says on meshes of several sizes.
struct ConvergenceStudy {
  std::string scene, title;
  std::vector<StudyMesh> meshes;  ///< from coarse to fine
  std::vector<StudyQuantity> quantities;
  std::vector<StudySource> sources;  ///< beside the mesh
  std::size_t sources_mesh = 0;      ///< on which they were looked at: the scene's own, else the coarsest
  std::vector<StudyTrial> trials{};
  StudyLimits limits{};
  std::string units{};  ///< of the scene
  std::vector<std::string> bodies{};

  /// The mesh of the scene itself, if it is among them.
  std::optional<std::size_t> own_mesh() const;
  std::vector<const StudyRun*> runs() const;  ///< all of them
  bool stopped() const;                       ///< a signal ended it
  bool failed() const;                        ///< a run on one of the meshes has
};

struct StudySettings {
  std::vector<MeshFactor> factors;  ///< from coarse to fine
  std::vector<std::string> of;      ///< quantities; empty: default_quantities()
  StudyFolder folder;
  std::vector<ErrorSource> sources{};  ///< beside the mesh
  int ensemble = 4;                    ///< runs for chance
  std::vector<RefinedBody> bodies{};   ///< each refined apart
  StudyLimits limits{};
};

/// Runs the scene on each mesh, from coarse to fine, and draws what they say; with a limit also on meshes, and with
/// settings, that reach the error for less, or that the time is enough for. A run that is expected to take longer than
/// is left of the time is left out. Throws InputError where the scene cannot be refined or a quantity is unknown, which
/// the coarsest run shows.
ConvergenceStudy study_convergence(const Scene& scene, const StudySettings& settings);

}  // namespace pinball

#include "convergence_study.hpp"

#include <algorithm>

#include "costs/settings_search.hpp"
#include "quantities.hpp"
#include "study_maker.hpp"

namespace pinball {

std::optional<double> StudyQuantity::value_in(const RunResults& results) const {
  if (!is_curve(name)) return results.value(name);
  const auto curve = results.curve(name);
  return curve && limit ? std::optional(distance(*curve, *limit)) : std::nullopt;
}

std::optional<std::size_t> ConvergenceStudy::own_mesh() const {
  const auto own =
      std::find_if(meshes.begin(), meshes.end(), [](const StudyMesh& mesh) { return mesh.factor == MeshFactor{}; });
  return own == meshes.end() ? std::nullopt : std::optional(static_cast<std::size_t>(own - meshes.begin()));
}

std::vector<const StudyRun*> ConvergenceStudy::runs() const {
  std::vector<const StudyRun*> all;
  for (const StudyMesh& mesh : meshes) all.push_back(&mesh.run);
  for (const StudySource& source : sources) {
    for (const StudyRun& run : source.runs) all.push_back(&run);
  }
  for (const StudyTrial& trial : trials) all.push_back(&trial.run);
  return all;
}

bool ConvergenceStudy::stopped() const {
  const auto all = runs();
  return std::any_of(all.begin(), all.end(), [](const StudyRun* run) { return run->stopped; });
}

bool ConvergenceStudy::failed() const {
  return std::any_of(meshes.begin(), meshes.end(), [](const StudyMesh& mesh) { return !mesh.run.failure.empty(); });
}

ConvergenceStudy study_convergence(const Scene& scene, const StudySettings& settings) {
  require_refinable(scene);
  // What cannot be is reported before a run.
  for (const MeshFactor& factor : settings.factors) refined_by(scene, factor);
  vary_bodies(scene, settings.bodies);
  if (!settings.of.empty() && !settings.factors.empty()) {
    const Scene first = refined_by(scene, settings.factors.front());
    require_quantities(settings.of, study_results_to_come(first, settings.folder));
  }
  StudyMaker maker(scene, settings);
  for (const MeshFactor& factor : settings.factors) {
    maker.run_mesh(factor);
    if (maker.study().stopped()) return maker.study();
  }
  maker.run_sources();
  if (maker.study().stopped()) return maker.study();
  maker.draw();
  search_settings(maker);
  return maker.study();
}

}  // namespace pinball

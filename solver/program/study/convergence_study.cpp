#include "convergence_study.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <solver/program/stop_signals.hpp>

#include "quantities.hpp"

namespace pinball {

namespace {

constexpr double round_off_of_double = 1e-10, round_off_of_float = 1e-4;  ///< of a run, of the scale of a quantity

std::string folder_of(const MeshFactor& factor) {
  std::string name = "mesh_" + factor.text();
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

StudyQuantity quantity_of(const std::string& name, const Scene& scene, const std::vector<StudyMesh>& meshes) {
  StudyQuantity quantity{name, unit_of_quantity(name, parse_units(scene.units)), {}, 0, {}};
  std::vector<MeshValue> values;
  for (const StudyMesh& mesh : meshes) {
    const auto& results = mesh.run.results;
    quantity.values.push_back(results ? results->value(name) : std::nullopt);
    if (!quantity.values.back()) continue;
    values.push_back({1 / mesh.factor.value(), *quantity.values.back()});
    quantity.scale = std::max(quantity.scale, results->scale(name));
  }
  const double round_off = scene.precision == Precision::float32 ? round_off_of_float : round_off_of_double;
  if (values.size() >= 3) quantity.convergence = grid_convergence(values, quantity.scale, round_off);
  return quantity;
}

}  // namespace

std::optional<std::size_t> ConvergenceStudy::own_mesh() const {
  const auto own =
      std::find_if(meshes.begin(), meshes.end(), [](const StudyMesh& mesh) { return mesh.factor == MeshFactor{}; });
  return own == meshes.end() ? std::nullopt : std::optional(static_cast<std::size_t>(own - meshes.begin()));
}

bool ConvergenceStudy::stopped() const { return !meshes.empty() && meshes.back().run.stopped; }

bool ConvergenceStudy::failed() const {
  return std::any_of(meshes.begin(), meshes.end(), [](const StudyMesh& mesh) { return !mesh.run.failure.empty(); });
}

ConvergenceStudy study_convergence(const Scene& scene, const StudySettings& settings) {
  require_refinable(scene);
  std::vector<Scene> scenes;
  for (const MeshFactor& factor : settings.factors) scenes.push_back(refined_by(scene, factor));
  ConvergenceStudy study{scene.name, scene.title, {}, {}};
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const MeshFactor& factor = settings.factors[i];
    const std::string counts = element_counts(scenes[i]);
    const std::string what =
        fmt::format("mesh {} of {}, elements {} times: {}", i + 1, scenes.size(), factor.text(), counts);
    study.meshes.push_back({factor, counts, make_study_run(scenes[i], folder_of(factor), what, settings.folder)});
    const StudyRun& run = study.meshes.back().run;
    if (run.results) require_quantities(settings.of, *run.results);
    if (run.stopped) return study;
  }
  const auto fine = std::find_if(study.meshes.rbegin(), study.meshes.rend(),
                                 [](const StudyMesh& mesh) { return mesh.run.results.has_value(); });
  if (fine == study.meshes.rend()) return study;
  const auto names = settings.of.empty() ? default_quantities(scene, *fine->run.results) : settings.of;
  for (const std::string& name : names) study.quantities.push_back(quantity_of(name, scene, study.meshes));
  return study;
}

}  // namespace pinball

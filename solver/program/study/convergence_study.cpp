#include "convergence_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <solver/base/error.hpp>

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

/// What an ensemble says together with the run that it is beside.
void add_chance(const std::vector<double>& values, StudyQuantity& quantity) {
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  const double count = static_cast<double>(values.size()), mean = sum / count;
  for (const double value : values) squares += (value - mean) * (value - mean);
  quantity.moved.push_back(std::sqrt(squares / (count - 1)));
  quantity.mean_of_chance = mean;
}

void add_sources(const ConvergenceStudy& study, StudyQuantity& quantity) {
  const std::optional<double> base = quantity.values[study.sources_mesh];
  for (const StudySource& source : study.sources) {
    std::vector<double> values;
    for (const StudyRun& run : source.runs) {
      const auto value = run.results ? run.results->value(quantity.name) : std::nullopt;
      if (value) values.push_back(*value);
    }
    if (!base || values.empty()) {
      quantity.moved.emplace_back();
    } else if (source.source != ErrorSource::chance) {
      quantity.moved.push_back(values.front() - *base);
    } else {
      values.push_back(*base);
      add_chance(values, quantity);
    }
  }
}

/// On the mesh of the scene itself where that is among them and its run came to its end.
void run_sources(const Scene& scene, const StudySettings& settings, ConvergenceStudy& study) {
  const auto own = study.own_mesh();
  const auto there = [](const StudyMesh& mesh) { return mesh.run.results.has_value(); };
  const auto first = std::find_if(study.meshes.begin(), study.meshes.end(), there);
  if (first == study.meshes.end()) return;
  study.sources_mesh = own && there(study.meshes[*own]) ? *own : static_cast<std::size_t>(first - study.meshes.begin());
  const MeshFactor factor = study.meshes[study.sources_mesh].factor;
  for (const SourceVariation& variation :
       vary_sources(refined_by(scene, factor), settings.sources, settings.ensemble)) {
    study.sources.push_back({variation.source, variation.name, variation.what, {}});
    for (std::size_t k = 0; k < variation.scenes.size(); ++k) {
      const std::string number = variation.source == ErrorSource::chance ? fmt::format("{}", k + 1) : "";
      const std::string what = fmt::format("mesh {}, {}{}: {}", factor.text(), variation.name, number, variation.what);
      StudyRun& run = study.sources.back().runs.emplace_back();
      try {
        run = make_study_run(variation.scenes[k], folder_of(factor) + '_' + variation.folder + number, what,
                             settings.folder);
      } catch (const InputError& error) {  // not with this scene
        run.failure = error.what();
      }
      if (run.stopped) return;
    }
  }
}

}  // namespace

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
  std::vector<Scene> scenes;
  for (const MeshFactor& factor : settings.factors) scenes.push_back(refined_by(scene, factor));
  ConvergenceStudy study{scene.name, scene.title, {}, {}, {}};
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
  run_sources(scene, settings, study);
  if (study.stopped()) return study;
  const auto names = settings.of.empty() ? default_quantities(scene, *fine->run.results) : settings.of;
  for (const std::string& name : names) {
    study.quantities.push_back(quantity_of(name, scene, study.meshes));
    add_sources(study, study.quantities.back());
  }
  return study;
}

}  // namespace pinball

#include "study_quantities.hpp"

#include <algorithm>
#include <cmath>

namespace pinball {

namespace {

constexpr double round_off_of_double = 1e-10, round_off_of_float = 1e-4;  ///< of a run, of the scale of a quantity

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

}  // namespace

void draw_quantities(const Scene& scene, const std::vector<std::string>& names, ConvergenceStudy& study) {
  study.quantities.clear();
  for (const std::string& name : names) {
    study.quantities.push_back(quantity_of(name, scene, study.meshes));
    add_sources(study, study.quantities.back());
  }
}

}  // namespace pinball

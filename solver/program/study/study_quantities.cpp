#include "study_quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pinball {

namespace {

constexpr double round_off_of_double = 1e-10, round_off_of_float = 1e-4;  ///< of a run, of the scale of a quantity

double round_off_of(const Scene& scene) {
  return has_single_elements(scene.precision) ? round_off_of_float : round_off_of_double;
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
  if (values.size() >= 3) quantity.convergence = grid_convergence(values, quantity.scale, round_off_of(scene));
  return quantity;
}

/// The curves of the runs on three finest meshes, from fine to coarse, with the sizes of these; fewer where there are.
struct FinestCurves {
  std::array<double, 3> sizes{};
  std::vector<TimeCurve> curves;
};

FinestCurves finest_curves(const std::string& name, const std::vector<StudyMesh>& meshes) {
  FinestCurves finest;
  for (auto mesh = meshes.rbegin(); mesh != meshes.rend() && finest.curves.size() < 3; ++mesh) {
    const auto curve = mesh->run.results ? mesh->run.results->curve(name) : std::nullopt;
    if (!curve) continue;
    finest.sizes[finest.curves.size()] = 1 / mesh->factor.value();
    finest.curves.push_back(*curve);
  }
  return finest;
}

/// What finer meshes would give: the difference of the two finest, gone on with. All meshes have their distance from
/// it.
StudyQuantity curve_quantity_of(const std::string& name, const Scene& scene, const std::vector<StudyMesh>& meshes) {
  StudyQuantity quantity{name, unit_of_quantity(name, parse_units(scene.units)), {}, 0, {}};
  const auto [sizes, curves] = finest_curves(name, meshes);
  for (const StudyMesh& mesh : meshes) {
    if (mesh.run.results) quantity.scale = std::max(quantity.scale, mesh.run.results->scale(name));
  }
  if (!curves.empty()) quantity.limit = curves.front();
  if (curves.size() == 3) {
    const double e21 = distance(curves[0], curves[1]), e32 = distance(curves[1], curves[2]);
    const GridConvergence c = distance_convergence(sizes, e21, e32, quantity.scale, round_off_of(scene));
    if (c.verdict == Convergence::monotone) {
      quantity.limit = beyond(curves[0], curves[1], 1 / std::expm1(c.order * std::log(sizes[1] / sizes[0])));
    }
    quantity.convergence = c;
  }
  for (const StudyMesh& mesh : meshes) {
    quantity.values.push_back(mesh.run.results ? quantity.value_in(*mesh.run.results) : std::nullopt);
  }
  return quantity;
}

/// Distances of each source from the run that it is beside; of chance the deviation from the mean.
void add_curve_sources(const ConvergenceStudy& study, StudyQuantity& quantity) {
  const auto& plain = study.meshes[study.sources_mesh].run.results;
  const auto base = plain ? plain->curve(quantity.name) : std::nullopt;
  for (const StudySource& source : study.sources) {
    std::vector<TimeCurve> curves;
    for (const StudyRun& run : source.runs) {
      const auto curve = run.results ? run.results->curve(quantity.name) : std::nullopt;
      if (curve) curves.push_back(*curve);
    }
    quantity.moved.emplace_back();
    if (!base || curves.empty()) continue;
    if (source.source != ErrorSource::chance) {
      quantity.moved.back() = distance(curves.front(), *base);
      continue;
    }
    curves.push_back(*base);
    const TimeCurve mean = mean_of(curves);
    double squares = 0;
    for (const TimeCurve& curve : curves) squares += std::pow(distance(curve, mean), 2);
    quantity.moved.back() = std::sqrt(squares / (curves.size() - 1));
    quantity.mean_of_chance = quantity.value_in(*plain);
  }
}

/// What an ensemble says together with the run that it is beside.
void add_chance(const std::vector<double>& values, StudyQuantity& quantity) {
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  const double count = values.size(), mean = sum / count;
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
    const bool curve = is_curve(name);
    study.quantities.push_back(curve ? curve_quantity_of(name, scene, study.meshes)
                                     : quantity_of(name, scene, study.meshes));
    (curve ? add_curve_sources : add_sources)(study, study.quantities.back());
  }
}

}  // namespace pinball

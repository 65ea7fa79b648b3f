#include "probes.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include <solver/model/selection/named_nodes.hpp>

namespace pinball {

namespace {

/// Columns that a quantity takes, without the name of the probe.
std::vector<std::string> columns_of(const std::string& quantity) {
  if (quantity == "stress") return {"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_zx"};
  if (quantity == "effective_stress" || quantity == "plastic_strain") return {quantity};
  return {quantity + "_x", quantity + "_y", quantity + "_z"};
}

double square_of_distance(const Point& a, const Point& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

/// sqrt(3/2 s:s) of xx yy zz xy yz zx.
double effective_stress(const double* s) {
  const double direct = (s[0] - s[1]) * (s[0] - s[1]) + (s[1] - s[2]) * (s[1] - s[2]) + (s[2] - s[0]) * (s[2] - s[0]);
  return std::sqrt(0.5 * direct + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

Point place_of(const ModelMesh& mesh, const Probe& probe, std::size_t i) {
  return probe.kind == ProbeKind::node ? mesh.nodes[i] : element_centre(mesh, i);
}

/// Of the nodes or elements of its body the one nearest to its point, the first of several.
std::size_t nearest_place(const ModelMesh& mesh, const Probe& probe) {
  std::size_t best = 0;
  double nearest = std::numeric_limits<double>::infinity();
  const bool node = probe.kind == ProbeKind::node;
  const auto& body_of = node ? mesh.body_of_node : mesh.body;
  const auto has = [&](std::int32_t body, std::size_t i) {
    if (body_of[i] == body) return true;
    return node && std::ranges::binary_search(mesh.shared[body], static_cast<std::int32_t>(i));
  };
  const std::int32_t own = std::ranges::find(mesh.body_names, probe.body) - mesh.body_names.begin();
  for (std::size_t i = 0; i < body_of.size(); ++i) {
    if (!probe.body.empty() && !has(own, i)) continue;
    const double distance = square_of_distance(place_of(mesh, probe, i), probe.point);
    if (!(distance < nearest)) continue;
    nearest = distance;
    best = i;
  }
  return best;
}

}  // namespace

template <class S>
Probes<S>::Probes(const Model<S>& model) {
  const ModelMesh& mesh = model.mesh;
  for (const Probe& probe : model.scene.probes) {
    const bool node = probe.kind == ProbeKind::node;
    const std::size_t i = probe.number ? place_of_number(mesh, probe) : nearest_place(mesh, probe);
    const std::string& first = mesh.body_names[node ? mesh.body_of_node[i] : mesh.body[i]];
    watched_.push_back({probe, i, probe.body.empty() ? first : probe.body, place_of(mesh, probe, i)});
  }
}

template <class S>
std::vector<std::string> Probes<S>::columns() const {
  std::vector<std::string> columns;
  for (const Watched& w : watched_) {
    for (const std::string& quantity : w.probe.quantities) {
      for (const std::string& column : columns_of(quantity)) {
        columns.push_back(fmt::format("{}_{}", w.probe.name, column));
      }
    }
  }
  return columns;
}

template <class S>
std::vector<std::int32_t> Probes<S>::nodes(const Model<S>& model) const {
  std::vector<std::int32_t> nodes;
  for (const Watched& w : watched_) {
    if (w.probe.kind == ProbeKind::node) nodes.push_back(model.node_of_scene_node[w.number]);
  }
  return nodes;
}

template <class S>
std::vector<std::int64_t> Probes<S>::slots(const Model<S>& model) const {
  std::vector<std::int64_t> slots;
  for (const Watched& w : watched_) {
    if (w.probe.kind == ProbeKind::element) slots.push_back(model.slot_of_element[w.number]);
  }
  return slots;
}

template <class S>
void Probes<S>::add_values(const Model<S>& model, const Watched& w, const WayAhead& way_ahead,
                           std::vector<double>& values) const {
  double stress[6] = {}, plastic_strain = 0;
  std::int32_t node = 0;
  if (w.probe.kind == ProbeKind::element) {
    const std::int64_t slot = model.slot_of_element[w.number];
    for (int c = 0; c < 6; ++c) stress[c] = model.elements.stress_of(slot, c);
    const auto& strains = model.elements.plastic_strain;
    if (!strains.empty()) plastic_strain = strains[slot];
  } else {
    node = model.node_of_scene_node[w.number];
  }
  for (const std::string& quantity : w.probe.quantities) {
    if (quantity == "stress") {
      values.insert(values.end(), stress, stress + 6);
    } else if (quantity == "effective_stress") {
      values.push_back(effective_stress(stress));
    } else if (quantity == "plastic_strain") {
      values.push_back(plastic_strain);
    } else {
      const S *x = model.nodes.position_of(node), *v = model.nodes.velocity_of(node);
      const Point ahead = way_ahead(node);
      for (std::size_t k = 0; k < 3; ++k) {
        const double velocity = v[k];
        const double position = x[k] - ahead[k];
        values.push_back(quantity == "velocity" ? velocity : quantity == "position" ? position : position - w.start[k]);
      }
    }
  }
}

template <class S>
std::vector<double> Probes<S>::values(const Model<S>& model, const WayAhead& way_ahead) const {
  std::vector<double> values;
  for (const Watched& w : watched_) add_values(model, w, way_ahead, values);
  return values;
}

template <class S>
std::vector<ProbeResult> Probes<S>::results(const Model<S>& model, const WayAhead& way_ahead) const {
  std::vector<ProbeResult> results;
  for (const Watched& w : watched_) {
    ProbeResult result{w.probe.name, w.body, static_cast<std::int64_t>(w.number), w.probe.kind == ProbeKind::element,
                       w.start,      {}};
    std::vector<double> values;
    add_values(model, w, way_ahead, values);
    for (const std::string& quantity : w.probe.quantities) {
      for (const std::string& column : columns_of(quantity)) {
        result.values.push_back({column, values[result.values.size()]});
      }
    }
    results.push_back(std::move(result));
  }
  return results;
}

template class Probes<double>;
template class Probes<float>;

}  // namespace pinball

#include "near_nodes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "node_selection.hpp"

namespace pinball {

namespace {

constexpr double far_from_all = 0.1;  ///< of a point from the box of all nodes, over the size of that [-]

/// The nearest node is taken, however far it is.
void add_far_point(const Point& point, const ModelMesh& mesh, const std::string& where,
                   std::vector<std::string>& found) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double low = INFINITY, high = -INFINITY;
    for (const Point& node : mesh.nodes) {
      low = std::min(low, node[k]);
      high = std::max(high, node[k]);
    }
    square += std::pow(std::max({0.0, low - point[k], point[k] - high}), 2);
  }
  const double size = mesh_size(mesh);
  if (!(std::sqrt(square) > far_from_all * size)) return;
  found.push_back(
      fmt::format("{}: the point ({:.6g}, {:.6g}, {:.6g}) lies {:.4g} away from all bodies, which extend over {:.4g}",
                  where, point[0], point[1], point[2], std::sqrt(square), size));
}

}  // namespace

std::vector<std::string> find_near_nodes(const Scene& scene, const ModelMesh& mesh) {
  std::vector<std::string> found;
  const auto look = [&](const NodeSelection& selection) {
    if (selection.nearest) add_far_point(*selection.nearest, mesh, selection.where, found);
    if (!selection.plane && !selection.line && !selection.box) return;
    const SelectedNodes selected = selected_nodes(mesh, selection);
    if (selected.near == 0) {
      if (selected.nodes.empty())
        found.push_back(fmt::format("{}: there is no node {}", selection.where, describe(selection)));
      return;
    }
    found.push_back(
        fmt::format("{}: {} node{} within a tenth of an element of those {} {} not taken, {} are: give a tolerance if "
                    "they are meant",
                    selection.where, selected.near, selected.near == 1 ? "" : "s", describe(selection),
                    selected.near == 1 ? "is" : "are", selected.nodes.size()));
  };
  for_each_selection_of_nodes(scene, look);
  for (const Pressure& pressure : scene.pressures) look(pressure.faces);
  return found;
}

}  // namespace pinball

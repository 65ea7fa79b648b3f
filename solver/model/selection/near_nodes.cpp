#include "near_nodes.hpp"

#include <fmt/core.h>

#include "node_selection.hpp"

namespace pinball {

std::vector<std::string> find_near_nodes(const Scene& scene, const ModelMesh& mesh) {
  std::vector<std::string> found;
  const auto look = [&](const NodeSelection& selection) {
    if (!selection.plane && !selection.line && !selection.box) return;
    const SelectedNodes selected = selected_nodes(mesh, selection);
    if (selected.near == 0) return;
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

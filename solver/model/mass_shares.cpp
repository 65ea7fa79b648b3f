#include "mass_shares.hpp"

#include <algorithm>

#include "elements/element_parts.hpp"

namespace pinball {

namespace {

std::size_t node_at(const std::vector<std::int32_t>& node_of_scene_node, std::int32_t corner) {
  return node_of_scene_node[corner];
}

}  // namespace

template <class S>
std::vector<MassShares> mass_shares(const Model<S>& model, const std::vector<std::int32_t>& group_of_body,
                                    std::size_t groups) {
  std::vector<double> of_all(model.node_mass.size(), 0.0), theirs(of_all);
  std::vector<std::vector<std::size_t>> members(groups);
  for (std::size_t e = 0; e < model.mesh.hexahedra.size(); ++e) {
    const std::int32_t group = group_of_body[model.mesh.body[e]];
    if (group >= 0) members[group].push_back(e);
    const CornerShares share = corner_shares(model.scene, model.mesh, e);
    for (std::size_t i = 0; i < 8; ++i)
      of_all[node_at(model.node_of_scene_node, model.mesh.hexahedra[e][i])] += model.element_mass[e] * share[i];
  }
  std::vector<MassShares> all(groups);
  for (std::size_t g = 0; g < groups; ++g) {
    std::vector<std::int32_t>& nodes = all[g].nodes;
    for (const std::size_t e : members[g]) {
      const CornerShares share = corner_shares(model.scene, model.mesh, e);
      for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t node = node_at(model.node_of_scene_node, model.mesh.hexahedra[e][i]);
        if (!(theirs[node] > 0)) nodes.push_back(node);
        theirs[node] += model.element_mass[e] * share[i];
      }
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const std::int32_t n : nodes) {
      double& mass = theirs[n];
      all[g].share.push_back(mass / of_all[n]);
      mass = 0;
    }
  }
  return all;
}

template std::vector<MassShares> mass_shares(const Model<double>&, const std::vector<std::int32_t>&, std::size_t);
template std::vector<MassShares> mass_shares(const Model<float>&, const std::vector<std::int32_t>&, std::size_t);

}  // namespace pinball

#include "equation_rows.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include <solver/base/error.hpp>
#include <solver/model/selection/named_nodes.hpp>
#include <solver/model/selection/node_selection.hpp>

namespace pinball {

namespace {

/// Listed ones in the order of the list, others in that of the mesh.
std::vector<std::int32_t> nodes_in_order(const ModelMesh& mesh, const NodeSelection& selection) {
  NodeSelection without_list = selection;
  without_list.nodes.clear();
  if (selection.nodes.empty() || !without_list.all()) return select_nodes(mesh, selection);
  std::vector<std::int32_t> nodes;
  for (const std::int64_t number : selection.nodes) nodes.push_back(node_of_number(mesh, selection, number));
  return nodes;
}

struct TermNodes {
  const EquationTerm* term;
  std::vector<std::int32_t> nodes;  ///< of the scene
};

void require_free(bool is_free, const EquationTerm& term, const char* otherwise) {
  if (!is_free)
    throw InputError(fmt::format("{}: expected nodes that are free, one of them {}", term.nodes.where, otherwise));
}

/// Per node of the store: what moves it as a whole.
template <class S>
class LedNodes {
 public:
  explicit LedNodes(const Model<S>& model) : rigid_(model.nodes.count, false), tied_(model.nodes.count, false) {
    for (const RigidNodes& rigid : model.rigid) {
      for (const std::int32_t n : rigid.nodes) rigid_[n] = true;
    }
    for (const TiedNode& tied : model.tied_nodes) tied_[tied.node] = true;
  }

  void require_none(std::int32_t node, const EquationTerm& term) const {
    require_free(!rigid_[node], term, "is of a rigid body");
    require_free(!tied_[node], term, "is tied to a face: give the nodes of the face");
  }

 private:
  std::vector<bool> rigid_, tied_;
};

std::size_t equations_of(const std::vector<TermNodes>& terms) {
  std::size_t most = 1;
  const EquationTerm* longest = nullptr;
  for (const auto& [term, nodes] : terms) {
    if (nodes.size() == 1) continue;
    if (longest != nullptr && nodes.size() != most) {
      throw InputError(fmt::format("{}: expected {} nodes, as the term {} of the equation {} has, or 1, got {}",
                                   term->nodes.where, most, longest->nodes.where, term->name, nodes.size()));
    }
    most = nodes.size();
    longest = term;
  }
  return most;
}

}  // namespace

template <class S>
std::vector<EquationRow> equation_rows(const Model<S>& model) {
  if (model.scene.equation_terms.empty()) return {};
  std::vector<std::string> names;
  std::map<std::string, std::vector<TermNodes>> terms;
  for (const EquationTerm& term : model.scene.equation_terms) {
    std::vector<TermNodes>& same = terms[term.name];
    if (same.empty()) names.push_back(term.name);
    same.push_back({&term, nodes_in_order(model.mesh, term.nodes)});
  }
  const LedNodes<S> led(model);
  std::vector<EquationRow> rows;
  for (const std::string& name : names) {
    const std::vector<TermNodes>& of_name = terms[name];
    for (std::size_t i = 0, count = equations_of(of_name); i < count; ++i) {
      EquationRow row{of_name.front().term->nodes.where, {}};
      for (const auto& [term, nodes] : of_name) {
        const std::int32_t node = model.node_of_scene_node[nodes.size() == 1 ? nodes[0] : nodes[i]];
        led.require_none(node, *term);
        auto part = std::ranges::find(row.parts, node, &EquationPart::node);
        if (part == row.parts.end()) part = row.parts.insert(part, EquationPart{node, {}});
        for (std::size_t k = 0; k < 3; ++k) part->coefficient[k] += term->factor * term->direction[k];
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

template std::vector<EquationRow> equation_rows(const Model<double>&);
template std::vector<EquationRow> equation_rows(const Model<float>&);

}  // namespace pinball

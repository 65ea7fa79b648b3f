#include "shell_layers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <solver/base/point.hpp>

namespace pinball {

namespace {

constexpr double sharpest = -0.5;  ///< cosine of the angle between normals of shells that share nodes of a layer

using Edge = std::pair<std::int32_t, std::int32_t>;

/// Shells with one orientation, and which corners of them have one pair of nodes.
class ShellSurface {
 public:
  ShellSurface(const std::vector<RigidShell>& shells, const std::vector<Point>& places)
      : shells_(shells), places_(places), corner_(4 * shells.size()) {
    std::iota(corner_.begin(), corner_.end(), 0);
    for (std::size_t s = 0; s < shells.size(); ++s) {
      for (int k = 0; k < 4; ++k) {
        const Edge edge = edge_of(s, k);
        if (edge.first != edge.second) edges_[{shells[s].part, std::minmax(edge.first, edge.second)}].push_back({s, k});
      }
    }
    orient();
    for (const auto& [edge, sides] : edges_) join(sides);
  }

  bool is_turned(std::size_t shell) const { return turned_[shell]; }
  /// A number that corners have in common which have one pair of nodes.
  std::size_t corner(std::size_t shell, int k) const { return root(4 * shell + k); }
  /// Unit vector, to the side that is above.
  Point normal(std::size_t shell) const {
    const auto& n = shells_[shell].nodes;
    Point across = cross(minus(places_[n[2]], places_[n[0]]), minus(places_[n[3]], places_[n[1]]));
    make_orthogonal(across, {});
    if (turned_[shell]) across = {-across[0], -across[1], -across[2]};
    return across;
  }

 private:
  struct Side {
    std::size_t shell;
    int edge;
  };
  Edge edge_of(std::size_t shell, int k) const {
    const auto& n = shells_[shell].nodes;
    return {n[k], n[(k + 1) % 4]};
  }
  /// Neighbours run along their common edge in opposite directions.
  bool agree(const Side& a, const Side& b) const {
    const bool same = edge_of(a.shell, a.edge).first == edge_of(b.shell, b.edge).first;
    return same == (turned_[a.shell] != turned_[b.shell]);
  }
  void orient() {
    turned_.assign(shells_.size(), false);
    std::vector<bool> known(shells_.size(), false);
    for (std::size_t first = 0; first < shells_.size(); ++first) {
      if (known[first]) continue;
      std::vector<std::size_t> next{first};
      known[first] = true;
      while (!next.empty()) {
        const std::size_t s = next.back();
        next.pop_back();
        for (int k = 0; k < 4; ++k) {
          const Edge edge = edge_of(s, k);
          if (edge.first == edge.second) continue;
          const auto& sides = edges_.at({shells_[s].part, std::minmax(edge.first, edge.second)});
          if (sides.size() != 2) continue;
          const Side &own = sides[0].shell == s ? sides[0] : sides[1],
                     &other = sides[0].shell == s ? sides[1] : sides[0];
          if (known[other.shell]) continue;
          known[other.shell] = true;
          if (!agree(own, other)) turned_[other.shell] = true;
          next.push_back(other.shell);
        }
      }
    }
  }
  void join(const std::vector<Side>& sides) {
    if (sides.size() != 2 || !agree(sides[0], sides[1])) return;
    if (dot(normal(sides[0].shell), normal(sides[1].shell)) < sharpest) return;
    const Edge edge = edge_of(sides[0].shell, sides[0].edge);
    for (const std::int32_t node : {edge.first, edge.second}) {
      const std::size_t a = root(corner_with(sides[0].shell, node)), b = root(corner_with(sides[1].shell, node));
      corner_[std::max(a, b)] = std::min(a, b);
    }
  }
  std::size_t corner_with(std::size_t shell, std::int32_t node) const {
    const auto& n = shells_[shell].nodes;
    return 4 * shell + (std::ranges::find(n, node) - n.begin());
  }
  std::size_t root(std::size_t corner) const {
    while (corner_[corner] != corner) corner = corner_[corner];
    return corner;
  }

  const std::vector<RigidShell>& shells_;
  const std::vector<Point>& places_;
  std::vector<std::size_t> corner_;
  std::map<std::pair<std::int32_t, Edge>, std::vector<Side>> edges_;
  std::vector<bool> turned_;
};

/// What corners with one pair of nodes have together.
struct Corner {
  std::int32_t node = 0;
  std::vector<std::size_t> shells;
  std::int32_t below = 0, above = 0;
};

/// The nodes of shells by those below them.
std::map<std::int32_t, std::int32_t> middles_of_layers(const MeshFile& file) {
  std::map<std::int32_t, std::int32_t> middle;
  for (const LayerNodes& layer : file.layers) middle[layer.below] = layer.middle;
  return middle;
}

/// The layers by the keys of their shells. middle: of middles_of_layers().
std::map<std::array<std::int32_t, 4>, std::array<std::int32_t, 8>> layers_of_shells(
    const MeshFile& file, const std::map<std::int32_t, std::int32_t>& middle) {
  std::map<std::array<std::int32_t, 4>, std::array<std::int32_t, 8>> all;
  for (const auto& n : file.mesh.hexahedra) {
    std::array<std::int32_t, 4> of_shell{};
    bool is_layer = true;
    for (std::size_t k = 0; k < 4 && is_layer; ++k) {
      const auto found = middle.find(n[k]);
      is_layer = found != middle.end();
      if (is_layer) of_shell[k] = found->second;
    }
    if (is_layer) all[key_of_shell(of_shell)] = n;
  }
  return all;
}

}  // namespace

bool is_flat_layer(const std::array<std::int32_t, 8>& hexahedron) {
  return std::equal(hexahedron.begin(), hexahedron.begin() + 4, hexahedron.begin() + 4);
}

std::array<std::int32_t, 4> key_of_shell(std::array<std::int32_t, 4> corners) {
  std::ranges::sort(corners);
  std::fill(std::unique(corners.begin(), corners.end()), corners.end(), std::int32_t{-1});
  return corners;
}

bool go_round_alike(const std::array<std::int32_t, 4>& a, const std::array<std::int32_t, 4>& b) {
  const auto behind = [](const std::array<std::int32_t, 4>& face, std::int32_t node) {
    std::size_t k = std::ranges::find(face, node) - face.begin();
    while (face[k] == node) k = (k + 1) % 4;
    return face[k];
  };
  return behind(a, a[0]) == behind(b, a[0]);
}

void add_shell_layers(const std::vector<RigidShell>& shells, MeshFile& file) {
  if (shells.empty()) return;
  const std::vector<Point> places = file.mesh.nodes;
  const ShellSurface surface(shells, places);
  std::map<std::size_t, Corner> corners;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    for (int k = 0; k < 4; ++k) {
      if (k == 3 && shells[s].nodes[3] == shells[s].nodes[2]) continue;
      Corner& corner = corners[surface.corner(s, k)];
      corner.node = shells[s].nodes[k];
      corner.shells.push_back(s);
    }
  }
  std::int64_t number = *std::ranges::max_element(file.node_ids);
  for (auto& [key, corner] : corners) {
    Point mean{};
    double thickness = 0, shift = 0;
    for (const std::size_t s : corner.shells) {
      const Point normal = surface.normal(s);
      const double share = static_cast<double>(corner.shells.size());
      for (std::size_t k = 0; k < 3; ++k) mean[k] += normal[k];
      thickness += shells[s].thickness / share;
      shift += (surface.is_turned(s) ? -shells[s].shift : shells[s].shift) / share;
    }
    make_orthogonal(mean, {});
    double steepest = 1;
    for (const std::size_t s : corner.shells) steepest = std::min(steepest, dot(mean, surface.normal(s)));
    const double half = 0.5 * thickness / std::max(steepest, 0.5);
    for (const double side : {-half, half}) {
      (side < 0 ? corner.below : corner.above) = static_cast<std::int32_t>(file.mesh.nodes.size());
      Point place = places[corner.node];
      for (std::size_t k = 0; k < 3; ++k) place[k] += (side + 2 * half * shift) * mean[k];
      file.mesh.nodes.push_back(place);
      file.node_ids.push_back(++number);
    }
    file.layers.push_back({corner.node, corner.below, corner.above, shells[corner.shells.front()].part});
  }
  const std::set<std::int64_t> taken(file.element_ids.begin(), file.element_ids.end());
  std::int64_t element = 0;
  for (const std::int64_t id : file.element_ids) element = std::max(element, id);
  for (const RigidShell& shell : shells) element = std::max(element, shell.id);
  for (std::size_t s = 0; s < shells.size(); ++s) {
    std::array<std::int32_t, 8> hexahedron{};
    for (int k = 0; k < 4; ++k) {
      int from = surface.is_turned(s) ? 3 - k : k;
      if (from == 3 && shells[s].nodes[3] == shells[s].nodes[2]) from = 2;
      const Corner& corner = corners.at(surface.corner(s, from));
      hexahedron[k] = corner.below;
      hexahedron[k + 4] = corner.above;
    }
    ++file.parts[shells[s].part].shells;
    if (shells[s].element >= 0) {
      file.mesh.hexahedra[shells[s].element] = hexahedron;
      continue;
    }
    if (file.lines_of.empty() || file.lines_of.back().file != shells[s].file)
      file.lines_of.push_back({static_cast<std::int32_t>(file.mesh.hexahedra.size()), shells[s].file});
    file.mesh.hexahedra.push_back(hexahedron);
    file.element_ids.push_back(taken.contains(shells[s].id) ? ++element : shells[s].id);
    file.part.push_back(shells[s].part);
    file.line.push_back(shells[s].line);
  }
}

void put_layers_into_sets(MeshFile& file, LayerFaces faces, const std::vector<std::int32_t>& kept) {
  if (file.layers.empty()) return;
  std::multimap<std::int32_t, const LayerNodes*> of_node;
  for (const LayerNodes& layer : file.layers) of_node.emplace(layer.middle, &layer);
  std::vector<bool> used(file.mesh.nodes.size(), false);  // by solids, with which shells share nodes
  std::vector<std::int32_t> of_solids;
  for (std::size_t e = 0; e < file.mesh.hexahedra.size(); ++e) add_nodes_of_element(file, e, of_solids);
  for (const std::int32_t node : of_solids) used[node] = true;
  for (MeshSet& set : file.node_sets) {
    std::vector<std::int32_t> more;
    for (const std::int32_t node : set.members) {
      const auto [first, end] = of_node.equal_range(node);
      for (auto at = first; at != end; ++at) more.insert(more.end(), {at->second->below, at->second->above});
    }
    std::erase_if(set.members, [&](std::int32_t node) {
      return !used[node] && of_node.contains(node) && !std::ranges::binary_search(kept, node);
    });
    set.members.insert(set.members.end(), more.begin(), more.end());
    std::ranges::sort(set.members);
    set.members.erase(std::unique(set.members.begin(), set.members.end()), set.members.end());
  }
  const std::map<std::int32_t, std::int32_t> middle = middles_of_layers(file);
  const auto layers = layers_of_shells(file, middle);
  for (FaceSet& set : file.face_sets) {
    std::vector<std::array<std::int32_t, 4>> others;
    for (const std::array<std::int32_t, 4>& face : set.faces) {
      std::array<std::int32_t, 4> of_shell = face;
      if (of_shell[3] < 0) of_shell[3] = of_shell[2];
      const auto found = layers.find(key_of_shell(of_shell));
      if (found == layers.end()) {
        others.push_back(face);
      } else {
        const auto& n = found->second;
        std::array<std::int32_t, 4> from_above{};
        for (std::size_t k = 0; k < 4; ++k) from_above[k] = middle.at(n[k]);
        const bool is_above = go_round_alike(of_shell, from_above);
        if (faces == LayerFaces::both || !is_above) others.push_back({n[0], n[3], n[2], n[1]});
        if (faces == LayerFaces::both || is_above) others.push_back({n[4], n[5], n[6], n[7]});
      }
    }
    set.faces = std::move(others);
  }
}

}  // namespace pinball

#include "split_hexahedra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include <solver/base/error.hpp>

namespace pinball {

namespace {

using Parents = std::array<std::int32_t, 8>;  ///< ascending; -1 behind those of an edge or face

/// Of the corners of a hexahedron on a lattice of 3 x 3 x 3 points, in the order of mesh.hpp.
constexpr std::array<std::array<int, 3>, 8> corner_places{
    {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}}};

/// Finds or makes the node in the middle of some.
class MiddleNodes {
 public:
  explicit MiddleNodes(std::vector<Point>& nodes) : nodes_(nodes) {}

  std::int32_t of(std::vector<std::int32_t> nodes) {
    std::sort(nodes.begin(), nodes.end());
    if (nodes.size() == 1) return nodes.front();
    const Parents parents = parents_of(nodes);
    const auto [found, is_new] = made_.try_emplace(parents, static_cast<std::int32_t>(nodes_.size()));
    if (!is_new) return found->second;
    Point middle{};
    for (const std::int32_t node : nodes) {
      for (std::size_t k = 0; k < 3; ++k) middle[k] += nodes_[node][k] / nodes.size();
    }
    nodes_.push_back(middle);
    parents_.push_back(parents);
    return found->second;
  }
  /// Whether some have a node in their middle.
  bool has(std::vector<std::int32_t> nodes) const {
    std::sort(nodes.begin(), nodes.end());
    return made_.count(parents_of(nodes)) > 0;
  }
  /// Of each new node, in their order.
  const std::vector<Parents>& parents() const { return parents_; }

 private:
  static Parents parents_of(const std::vector<std::int32_t>& sorted) {
    Parents parents;
    parents.fill(-1);
    std::copy(sorted.begin(), sorted.end(), parents.begin());
    return parents;
  }

  std::vector<Point>& nodes_;
  std::map<Parents, std::int32_t> made_;
  std::vector<Parents> parents_;
};

void require_splittable(const MeshFile& file) {
  const std::size_t elements = file.mesh.hexahedra.size();
  if (elements > std::numeric_limits<std::int32_t>::max() / 64) {
    throw InputError(fmt::format("{}: {} elements are too many to be split in eight", file.path, elements));
  }
  for (std::size_t e = 0; e < elements; ++e) {
    std::array<std::int32_t, 8> corners = file.mesh.hexahedra[e];
    std::sort(corners.begin(), corners.end());
    if (std::adjacent_find(corners.begin(), corners.end()) == corners.end()) continue;
    throw InputError(fmt::format("{}: {} is collapsed: expected hexahedra of eight nodes, others are not refined",
                                 place_of_element(file, e), element_name(file, e)));
  }
}

/// The eight, at the corner 0 first, in the order of the corners.
void add_eight(const std::array<std::int32_t, 8>& corners, MiddleNodes& middles,
               std::vector<std::array<std::int32_t, 8>>& hexahedra) {
  std::array<std::int32_t, 27> lattice;  // several of the eight have its points in common
  lattice.fill(-1);
  const auto node_at = [&](int x, int y, int z) {
    std::int32_t& node = lattice[9 * x + 3 * y + z];
    if (node >= 0) return node;
    std::vector<std::int32_t> around;
    for (std::size_t c = 0; c < 8; ++c) {
      const auto& place = corner_places[c];
      const auto is_near = [](int at, int corner) { return at == 1 || at == corner; };
      if (is_near(x, place[0]) && is_near(y, place[1]) && is_near(z, place[2])) around.push_back(corners[c]);
    }
    return node = middles.of(std::move(around));
  };
  for (const auto& child : corner_places) {
    std::array<std::int32_t, 8>& hexahedron = hexahedra.emplace_back();
    for (std::size_t c = 0; c < 8; ++c) {
      const auto& place = corner_places[c];
      hexahedron[c] = node_at((child[0] + place[0]) / 2, (child[1] + place[1]) / 2, (child[2] + place[2]) / 2);
    }
  }
}

template <class Value>
void repeat_eight_times(std::vector<Value>& of_elements) {
  std::vector<Value> repeated;
  repeated.reserve(8 * of_elements.size());
  for (const Value& value : of_elements) repeated.insert(repeated.end(), 8, value);
  of_elements = std::move(repeated);
}

void add_new_members(MeshSet& set, const std::vector<Parents>& parents, std::size_t old_nodes) {
  std::vector<bool> is_in(old_nodes, false);
  for (const std::int32_t node : set.members) is_in[node] = true;
  for (std::size_t n = 0; n < parents.size(); ++n) {
    const auto all_in = [&](std::int32_t node) { return node < 0 || is_in[node]; };
    if (std::all_of(parents[n].begin(), parents[n].end(), all_in)) {
      set.members.push_back(old_nodes + n);
    }
  }
}

void split_members(MeshSet& set) {
  std::vector<std::int32_t> members;
  for (const std::int32_t element : set.members) {
    for (std::int32_t child = 0; child < 8; ++child) members.push_back(8 * element + child);
  }
  set.members = std::move(members);
}

/// The corners of a face along its edges: what names a face may have them across it, as readers take them.
std::array<std::int32_t, 4> along_its_edges(const std::array<std::int32_t, 4>& face, const MiddleNodes& middles) {
  const std::array<std::array<std::int32_t, 4>, 3> ways{
      {face, {face[0], face[2], face[1], face[3]}, {face[0], face[1], face[3], face[2]}}};
  for (const std::array<std::int32_t, 4>& way : ways) {
    bool all = true;
    for (std::size_t c = 0; c < 4; ++c) all = all && middles.has({way[c], way[(c + 1) % 4]});
    if (all) return way;
  }
  return face;
}

/// A face that is none of a hexahedron of the mesh stays as it is.
void split_faces(FaceSet& set, MiddleNodes& middles) {
  std::vector<std::array<std::int32_t, 4>> faces;
  for (const std::array<std::int32_t, 4>& named : set.faces) {
    if (!middles.has({named.begin(), named.end()})) {
      faces.push_back(named);
      continue;
    }
    const std::array<std::int32_t, 4> face = along_its_edges(named, middles);
    const std::int32_t centre = middles.of({face.begin(), face.end()});
    for (std::size_t c = 0; c < 4; ++c) {
      const std::int32_t next = middles.of({face[c], face[(c + 1) % 4]}),
                         before = middles.of({face[(c + 3) % 4], face[c]});
      faces.push_back({face[c], next, centre, before});
    }
  }
  set.faces = std::move(faces);
}

void number_new_nodes(std::vector<std::int64_t>& ids, std::size_t count) {
  if (ids.empty()) return;
  std::int64_t last = *std::max_element(ids.begin(), ids.end());
  while (ids.size() < count) ids.push_back(++last);
}

}  // namespace

void split_hexahedra(MeshFile& file) {
  require_splittable(file);
  const std::size_t old_nodes = file.mesh.nodes.size();
  MiddleNodes middles(file.mesh.nodes);
  std::vector<std::array<std::int32_t, 8>> hexahedra;
  hexahedra.reserve(8 * file.mesh.hexahedra.size());
  for (const auto& corners : file.mesh.hexahedra) add_eight(corners, middles, hexahedra);
  file.mesh.hexahedra = std::move(hexahedra);
  repeat_eight_times(file.element_ids);
  repeat_eight_times(file.part);
  repeat_eight_times(file.line);
  for (MeshLines& lines : file.lines_of) lines.first *= 8;
  for (FaceSet& set : file.face_sets) split_faces(set, middles);
  for (MeshSet& set : file.node_sets) add_new_members(set, middles.parents(), old_nodes);
  for (MeshSet& set : file.element_sets) split_members(set);
  number_new_nodes(file.node_ids, file.mesh.nodes.size());
  if (file.held.empty()) return;
  for (const Parents& parents : middles.parents()) {
    std::uint8_t bits = 7;
    for (const std::int32_t node : parents) bits &= node < 0 ? 7 : file.held[node];
    file.held.push_back(bits);
  }
}

}  // namespace pinball

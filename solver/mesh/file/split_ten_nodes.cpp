#include "split_ten_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <kernels/tetrahedron.hpp>
#include <solver/base/counted.hpp>
#include <solver/base/error.hpp>

namespace pinball {

namespace {

/// Corners that the edges join, as EdgeNodes has them.
constexpr std::array<std::array<int, 2>, 6> edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
/// Opposite edges, and the four others in their order around the line between these: seen from the second,
/// counterclockwise.
struct Axis {
  int from, to;
  std::array<int, 4> around;
};
constexpr std::array<Axis, 3> axes{{{0, 5, {3, 4, 1, 2}}, {1, 3, {4, 5, 2, 0}}, {2, 4, {5, 3, 0, 1}}}};

/// Of ways through the middle that are as long but for rounding the first is taken: over their length.
constexpr double as_long = 1e-6;

using Corners4 = std::array<std::int32_t, 4>;

Corners4 corners_of(const MeshFile& file, const EdgeNodes& of) {
  Corners4 corners;
  for (int i = 0; i < 4; ++i) corners[i] = file.mesh.hexahedra[of.element][tetrahedron_corner(i)];
  return corners;
}

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

void require_middles(const MeshFile& file, const EdgeNodes& of) {
  const Corners4 corners = corners_of(file, of);
  for (std::size_t i = 0; i < edges.size(); ++i)
    require_middle(file, of.element, of.nodes[i], corners[edges[i][0]], corners[edges[i][1]],
                   "four corners, then the nodes of the edges");
}

void add_eight(const MeshFile& file, const EdgeNodes& of, std::vector<Corners8>& elements) {
  const Corners4 corner = corners_of(file, of);
  const auto& m = of.nodes;
  const auto length = [&](const Axis& axis) {
    return distance(file.mesh.nodes[m[axis.from]], file.mesh.nodes[m[axis.to]]);
  };
  const double longest = (1 + as_long) * length(*std::ranges::min_element(axes, {}, length));
  const Axis& axis = *std::ranges::find_if(axes, [&](const Axis& one) { return length(one) <= longest; });
  for (std::size_t i = 0; i < 4; ++i)
    elements.push_back(tetrahedron(m[axis.from], m[axis.to], m[axis.around[i]], m[axis.around[(i + 1) % 4]]));
  elements.push_back(tetrahedron(corner[0], m[0], m[2], m[3]));
  elements.push_back(tetrahedron(m[0], corner[1], m[1], m[4]));
  elements.push_back(tetrahedron(m[2], m[1], corner[2], m[5]));
  elements.push_back(tetrahedron(m[3], m[4], m[5], corner[3]));
}

/// Of eight elements from `first` on a node of that at a corner.
std::int32_t node_of_corner(const MeshFile& file, std::int32_t first, int corner, int at) {
  return file.mesh.hexahedra[first + 4 + corner][tetrahedron_corner(at)];
}

/// Whether the eight from `first` on are those of a hexahedron, which have eight corners.
bool is_of_hexahedron(const MeshFile& file, std::int32_t first) {
  const Corners8& corners = file.mesh.hexahedra[first];
  return corners[2] != corners[3];
}

/// Element i of the eight at each corner j has the node between corners i and j.
void add_hexahedron(const MeshFile& file, std::int32_t first, EdgeMiddles& middles) {
  for (int i = 0; i < 8; ++i) {
    for (int j = i + 1; j < 8; ++j)
      middles.add(file.mesh.hexahedra[first + i][i], file.mesh.hexahedra[first + j][j],
                  file.mesh.hexahedra[first + i][j]);
  }
}

void split_faces(FaceSet& set, const EdgeMiddles& middles) {
  std::vector<Corners4> faces;
  for (const Corners4& face : set.faces) {
    const std::vector<Corners4> pieces = middles.pieces_of(face);
    faces.insert(faces.end(), pieces.begin(), pieces.end());
  }
  set.faces = std::move(faces);
}

/// first: as split_ten_nodes returns it.
template <class Value>
void repeat(std::vector<Value>& of_elements, const std::vector<std::int32_t>& first) {
  if (of_elements.empty()) return;
  std::vector<Value> repeated;
  repeated.reserve(first.back());
  for (std::size_t e = 0; e < of_elements.size(); ++e)
    repeated.insert(repeated.end(), first[e + 1] - first[e], of_elements[e]);
  of_elements = std::move(repeated);
}

void split_members(MeshSet& set, const std::vector<std::int32_t>& first) {
  std::vector<std::int32_t> members;
  for (const std::int32_t element : set.members) {
    for (std::int32_t e = first[element]; e < first[element + 1]; ++e) members.push_back(e);
  }
  set.members = std::move(members);
}

}  // namespace

/// Of tetrahedra the corner elements come behind the four inside, and have the nodes of the edges in the places of the
/// other ends. Of hexahedra there are these alone.
EdgeMiddles::EdgeMiddles(const MeshFile& file) {
  for (const EdgeNodes& of : file.edge_nodes) add(corners_of(file, of), of.nodes);
  for (const TwentyNodes& of : file.twenty_nodes) {
    const Corners8& corners = file.mesh.hexahedra[of.element];
    for (std::size_t i = 0; i < hexahedron_edges.size(); ++i)
      add(corners[hexahedron_edges[i][0]], corners[hexahedron_edges[i][1]], of.nodes[i]);
  }
  for (const std::int32_t first : file.eights) {
    if (is_of_hexahedron(file, first)) {
      add_hexahedron(file, first, *this);
      continue;
    }
    std::array<std::int32_t, 6> nodes{};
    for (std::size_t i = 0; i < edges.size(); ++i) nodes[i] = node_of_corner(file, first, edges[i][0], edges[i][1]);
    Corners4 corners{};
    for (int i = 0; i < 4; ++i) corners[i] = node_of_corner(file, first, i, i);
    add(corners, nodes);
  }
}

Corners8 unsplit(const MeshFile& file, std::int32_t first) {
  if (is_of_hexahedron(file, first)) {
    Corners8 corners{};
    for (int i = 0; i < 8; ++i) corners[i] = file.mesh.hexahedra[first + i][i];
    return corners;
  }
  const auto corner = [&](int i) { return node_of_corner(file, first, i, i); };
  return tetrahedron(corner(0), corner(1), corner(2), corner(3));
}

void EdgeMiddles::add(const std::array<std::int32_t, 4>& corners, const std::array<std::int32_t, 6>& nodes) {
  for (std::size_t i = 0; i < edges.size(); ++i) add(corners[edges[i][0]], corners[edges[i][1]], nodes[i]);
}

void EdgeMiddles::add(std::int32_t a, std::int32_t b, std::int32_t middle) {
  middle_.try_emplace(std::minmax(a, b), middle);
}

std::int32_t EdgeMiddles::of(std::int32_t a, std::int32_t b) const {
  const auto found = middle_.find(std::minmax(a, b));
  return found == middle_.end() ? -1 : found->second;
}

std::vector<std::array<std::int32_t, 4>> EdgeMiddles::pieces_of(const std::array<std::int32_t, 4>& face) const {
  std::vector<std::int32_t> c;  // different ones, in their order
  for (const std::int32_t node : face) {
    if (std::ranges::find(c, node) == c.end()) c.push_back(node);
  }
  if (c.size() == 4 && of(c[0], c[2]) != of(c[1], c[3])) {  // named across its edges: diagonals have one middle
    if (of(c[0], c[1]) == of(c[2], c[3])) std::swap(c[1], c[2]);
    if (of(c[0], c[3]) == of(c[1], c[2])) std::swap(c[2], c[3]);
  }
  std::array<std::int32_t, 4> m{-1, -1, -1, -1};
  for (std::size_t i = 0; i < c.size() && c.size() >= 3; ++i) m[i] = of(c[i], c[(i + 1) % c.size()]);
  const std::int32_t centre = c.size() == 4 ? of(c[0], c[2]) : 0;
  if (c.size() < 3 || centre < 0 || *std::min_element(m.begin(), m.begin() + c.size()) < 0) return {face};
  if (c.size() == 4)
    return {
        {c[0], m[0], centre, m[3]}, {m[0], c[1], m[1], centre}, {centre, m[1], c[2], m[2]}, {m[3], centre, m[2], c[3]}};
  return {{c[0], m[0], m[2], m[2]}, {m[0], c[1], m[1], m[1]}, {m[2], m[1], c[2], c[2]}, {m[0], m[1], m[2], m[2]}};
}

std::vector<std::int32_t> EdgeMiddles::nodes_of(const std::vector<std::array<std::int32_t, 4>>& faces) const {
  std::vector<std::int32_t> nodes = nodes_of_faces(faces);
  if (middle_.empty()) return nodes;
  for (const std::array<std::int32_t, 4>& face : faces) {
    for (std::size_t i = 0; i < 4; ++i) nodes.push_back(of(face[i], face[(i + 1) % 4]));
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::erase(nodes, -1);
  return nodes;
}

void require_middle(const MeshFile& file, std::int32_t element, std::int32_t node, std::int32_t a, std::int32_t b,
                    const char* expected) {
  constexpr double farthest = 0.35;  // from the middle, over the length of the edge; 0.21 where it bends by 90 degrees
  const Point &x = file.mesh.nodes[a], &y = file.mesh.nodes[b];
  const Point middle{0.5 * (x[0] + y[0]), 0.5 * (x[1] + y[1]), 0.5 * (x[2] + y[2])};
  if (distance(file.mesh.nodes[node], middle) <= farthest * distance(x, y)) return;
  throw InputError(fmt::format("{}: {}: node {} is not near the middle of its edge, from node {} to {}: expected {}",
                               place_of_element(file, element), element_name(file, element),
                               number_of(file.node_ids, node), number_of(file.node_ids, a), number_of(file.node_ids, b),
                               expected));
}

void put_pieces(MeshFile& file, std::vector<Corners8> pieces, const std::vector<std::int32_t>& first,
                const EdgeMiddles& middles) {
  file.mesh.hexahedra = std::move(pieces);
  repeat(file.element_ids, first);
  repeat(file.part, first);
  repeat(file.line, first);
  for (MeshLines& lines : file.lines_of) lines.first = first[lines.first];
  for (FaceSet& set : file.face_sets) split_faces(set, middles);
  for (MeshSet& set : file.element_sets) split_members(set, first);
}

std::vector<std::int32_t> split_ten_nodes(MeshFile& file) {
  if (file.edge_nodes.empty()) return {};
  const std::size_t count = file.mesh.hexahedra.size(), split = file.edge_nodes.size();
  if (count + 7 * split > std::numeric_limits<std::int32_t>::max() / 8)
    throw InputError(fmt::format("{}: {} are too many to be split in eight", file.path,
                                 counted(split, "tetrahedron of ten nodes", "tetrahedra of ten nodes")));
  EdgeMiddles middles;
  std::vector<Corners8> elements;
  std::vector<std::int32_t> first;
  elements.reserve(count + 7 * split);
  first.reserve(count + 1);
  auto next = file.edge_nodes.begin();
  for (std::size_t e = 0; e < count; ++e) {
    first.push_back(static_cast<std::int32_t>(elements.size()));
    if (next == file.edge_nodes.end() || next->element != static_cast<std::int32_t>(e)) {
      elements.push_back(file.mesh.hexahedra[e]);
      continue;
    }
    require_middles(file, *next);
    middles.add(corners_of(file, *next), next->nodes);
    file.eights.push_back(first.back());
    add_eight(file, *next, elements);
    if (!file.part.empty() && file.part[e] >= 0) ++file.parts[file.part[e]].ten_nodes;
    ++next;
  }
  first.push_back(static_cast<std::int32_t>(elements.size()));
  put_pieces(file, std::move(elements), first, middles);
  for (TwentyNodes& one : file.twenty_nodes) one.element = first[one.element];
  file.notes.push_back(fmt::format("{}: {}, each as eight of four nodes", file.path,
                                   counted(split, "tetrahedron of ten nodes", "tetrahedra of ten nodes")));
  file.edge_nodes.clear();
  return first;
}

}  // namespace pinball

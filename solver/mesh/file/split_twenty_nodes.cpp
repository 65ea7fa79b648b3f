#include "split_twenty_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <span>

#include <solver/base/counted.hpp>
#include <solver/base/error.hpp>
#include <solver/mesh/element_types.hpp>

#include "split_ten_nodes.hpp"

namespace pinball {

namespace {

/// Corners of the faces, and the edges between them.
struct FaceOfTwenty {
  std::array<int, 4> corners, edges;
};
constexpr std::array<FaceOfTwenty, 6> hexahedron_faces{{{{0, 1, 2, 3}, {0, 1, 2, 3}},
                                                        {{4, 5, 6, 7}, {4, 5, 6, 7}},
                                                        {{0, 1, 5, 4}, {0, 9, 4, 8}},
                                                        {{1, 2, 6, 5}, {1, 10, 5, 9}},
                                                        {{2, 3, 7, 6}, {2, 11, 6, 10}},
                                                        {{3, 0, 4, 7}, {3, 8, 7, 11}}}};

using FaceCorners = std::array<std::int32_t, 4>;

/// All nodes of an element, between each pair of its corners the one that lies there: on the diagonal the corners.
using Between = std::array<std::array<std::int32_t, 8>, 8>;

/// Nodes that an element gets.
struct Centres {
  std::array<std::int32_t, 6> faces{};
  std::int32_t element = 0;
};

class Splitting {
 public:
  explicit Splitting(MeshFile& file) : file_(file) {}

  Between add(const TwentyNodes& of) {
    const Corners8& corners = file_.mesh.hexahedra[of.element];
    if (different_nodes(corners) < 8)
      throw InputError(fmt::format("{}: {}: two of the eight corners of a hexahedron of twenty nodes are the same",
                                   place_of_element(file_, of.element), element_name(file_, of.element)));
    for (std::size_t i = 0; i < hexahedron_edges.size(); ++i)
      require_middle(file_, of.element, of.nodes[i], corners[hexahedron_edges[i][0]], corners[hexahedron_edges[i][1]],
                     "eight corners, then the nodes of the edges");
    Between between{};
    Centres& centres = centres_.emplace_back();
    centres.element = add_node(corners, of.nodes, 0.25);
    for (int i = 0; i < 8; ++i) {
      between[i].fill(centres.element);
      between[i][i] = corners[i];
    }
    const auto put = [&](int i, int j, std::int32_t node) { between[i][j] = between[j][i] = node; };
    for (std::size_t f = 0; f < hexahedron_faces.size(); ++f) {
      const auto& c = hexahedron_faces[f].corners;
      const std::int32_t centre = centres.faces[f] = centre_of_face(corners, of.nodes, hexahedron_faces[f]);
      put(c[0], c[2], centre);
      put(c[1], c[3], centre);
    }
    for (std::size_t i = 0; i < hexahedron_edges.size(); ++i)
      put(hexahedron_edges[i][0], hexahedron_edges[i][1], of.nodes[i]);
    return between;
  }

  void number_nodes() {
    if (file_.node_ids.empty()) return;
    std::int64_t last = *std::ranges::max_element(file_.node_ids);
    while (file_.node_ids.size() < file_.mesh.nodes.size()) file_.node_ids.push_back(++last);
    if (!file_.held.empty()) file_.held.resize(file_.mesh.nodes.size(), 0);
  }

  /// Centres of faces, and of elements, all of whose other nodes a set has.
  void add_to(MeshSet& set, const std::vector<TwentyNodes>& twenty) const {
    std::vector<bool> has(file_.mesh.nodes.size(), false);
    for (const std::int32_t node : set.members) has[node] = true;
    const auto add_one = [&](std::int32_t node) {
      if (!has[node]) set.members.push_back(node);
      has[node] = true;
    };
    for (std::size_t k = 0; k < twenty.size(); ++k) {
      const Corners8& corners = file_.mesh.hexahedra[twenty[k].element];
      bool all = true;
      for (std::size_t f = 0; f < hexahedron_faces.size(); ++f) {
        const auto is_in = [&](std::span<const std::int32_t> nodes, const std::array<int, 4>& places) {
          return std::ranges::all_of(places, [&](int place) { return has[nodes[place]]; });
        };
        const bool whole =
            is_in(corners, hexahedron_faces[f].corners) && is_in(twenty[k].nodes, hexahedron_faces[f].edges);
        if (whole) add_one(centres_[k].faces[f]);
        all = all && whole;
      }
      if (all) add_one(centres_[k].element);
    }
  }

 private:
  /// Where the shape functions of the element have its middle, or that of a face: -1/4 of corners and a factor of the
  /// nodes of edges.
  std::int32_t add_node(std::span<const std::int32_t> corners, std::span<const std::int32_t> middles, double factor) {
    Point x{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (const std::int32_t node : corners) x[k] -= 0.25 * file_.mesh.nodes[node][k];
      for (const std::int32_t node : middles) x[k] += factor * file_.mesh.nodes[node][k];
    }
    file_.mesh.nodes.push_back(x);
    return static_cast<std::int32_t>(file_.mesh.nodes.size() - 1);
  }

  /// One for both elements that have the face.
  std::int32_t centre_of_face(const Corners8& corners, const std::array<std::int32_t, 12>& nodes,
                              const FaceOfTwenty& face) {
    FaceCorners of_face{}, of_edges{};
    for (std::size_t i = 0; i < 4; ++i) {
      of_face[i] = corners[face.corners[i]];
      of_edges[i] = nodes[face.edges[i]];
    }
    FaceCorners key = of_face;
    std::ranges::sort(key);
    const auto found = of_faces_.find(key);
    if (found != of_faces_.end()) return found->second;
    return of_faces_[key] = add_node(of_face, of_edges, 0.5);
  }

  MeshFile& file_;
  std::vector<Centres> centres_;
  std::map<FaceCorners, std::int32_t> of_faces_;  ///< by their corners, ascending
};

}  // namespace

std::vector<std::int32_t> split_twenty_nodes(MeshFile& file) {
  if (file.twenty_nodes.empty()) return {};
  const std::vector<TwentyNodes> twenty = std::move(file.twenty_nodes);
  file.twenty_nodes.clear();
  const std::size_t count = file.mesh.hexahedra.size(), split = twenty.size();
  const std::string of_twenty = counted(split, "hexahedron of twenty nodes", "hexahedra of twenty nodes");
  if (std::max(count, file.mesh.nodes.size()) + 7 * split > std::numeric_limits<std::int32_t>::max() / 8)
    throw InputError(fmt::format("{}: {} are too many to be split in eight", file.path, of_twenty));
  Splitting splitting(file);
  EdgeMiddles middles;
  std::vector<Corners8> elements;
  std::vector<std::int32_t> first, eights;
  auto next = twenty.begin();
  for (std::size_t e = 0; e < count; ++e) {
    first.push_back(static_cast<std::int32_t>(elements.size()));
    if (next == twenty.end() || next->element != static_cast<std::int32_t>(e)) {
      elements.push_back(file.mesh.hexahedra[e]);
      continue;
    }
    const Between between = splitting.add(*next++);
    for (int i = 0; i < 8; ++i) {
      for (int j = i + 1; j < 8; ++j) middles.add(between[i][i], between[j][j], between[i][j]);
      elements.push_back(between[i]);
    }
    eights.push_back(first.back());
  }
  first.push_back(static_cast<std::int32_t>(elements.size()));
  splitting.number_nodes();
  for (MeshSet& set : file.node_sets) splitting.add_to(set, twenty);
  for (const std::int32_t before : file.eights) eights.push_back(first[before]);
  std::ranges::sort(eights);
  file.eights = std::move(eights);
  put_pieces(file, std::move(elements), first, middles);
  file.notes.push_back(
      fmt::format("{}: {}, each as eight of eight nodes, with nodes in the middle of its faces and of "
                  "itself, which are in sets of nodes that have all other nodes of these",
                  file.path, of_twenty));
  return first;
}

}  // namespace pinball

#include "ties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include <kernels/face_projection.hpp>
#include <solver/base/error.hpp>
#include <solver/base/face_corners.hpp>
#include <solver/base/faces.hpp>
#include <solver/contact/search/box_pairs.hpp>
#include <solver/model/element_checks.hpp>
#include <solver/model/exposed_faces.hpp>
#include <solver/model/given_directions.hpp>
#include <solver/model/place_names.hpp>
#include <solver/model/selection/node_selection.hpp>

#include "contact_sides.hpp"

namespace pinball {

namespace {

/// Tolerance without one, over the shorter diagonal of a face: that of LS-DYNA for faces of solids.
constexpr double default_tolerance = 0.05;
/// Up to so many times the tolerance a node that is not tied is reported [-].
constexpr double near = 5;
/// Weights that are nothing but round-off [-].
constexpr double nothing = 1e-10;

Vec3<double> place(const ModelMesh& mesh, std::int32_t node) {
  const Point& p = mesh.nodes[node];
  return {p[0], p[1], p[2]};
}

struct Face {
  std::int32_t element;
  std::array<std::int32_t, 4> node;
  double tolerance;
};

/// Where a node would be tied.
struct Foot {
  std::int32_t face = -1;
  double distance = 0;
  std::array<double, 4> weight{};
};

/// The search for the ties of a scene, one tied contact after the other.
class TieSearch {
 public:
  TieSearch(const Scene& scene, ModelMesh& mesh)
      : scene_(scene), mesh_(mesh), tied_(mesh.nodes.size(), 0), is_corner_(mesh.nodes.size(), 0) {
    exposed_ = find_exposed_faces(mesh, {}, face_neighbours(mesh.hexahedra));
    find_held();
  }

  std::vector<TiedNode> find(std::vector<TiedResult>& counts) {
    for (std::size_t t = 0; t < scene_.tied_contacts.size(); ++t) {
      counts.push_back(tie(scene_.tied_contacts[t], static_cast<std::int16_t>(t)));
    }
    put_on_faces();
    return std::move(ties_);
  }

 private:
  /// Nodes that are moved as prescribed, or held in all directions, by whatever constraints together.
  void find_held() {
    held_.assign(mesh_.nodes.size(), 0);
    directions_ = given_directions(scene_, mesh_);
    std::ranges::stable_sort(directions_, {}, &GivenDirection::node);
    for (const GivenDirection& given : directions_) {
      if (!given.held) held_[given.node] = 1;
    }
    NodeDirections of_node(scene_);
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      if (i == 0 || directions_[i].node != directions_[i - 1].node) of_node.clear();
      if (directions_[i].held) of_node.add(directions_[i]);
      if (of_node.all().size() == 3) held_[directions_[i].node] = 1;
    }
  }
  std::span<const GivenDirection> directions_of(std::int32_t node) const {
    return {std::ranges::lower_bound(directions_, node, {}, &GivenDirection::node),
            std::ranges::upper_bound(directions_, node, {}, &GivenDirection::node)};
  }
  /// Whether a node is held in a direction in which a corner that it follows may move.
  bool is_held_beside(std::int32_t node, const Face& face, const std::array<double, 4>& weight) const {
    const std::span<const GivenDirection> own = directions_of(node);
    for (std::size_t k = 0; k < 4 && !own.empty(); ++k) {
      if (!(weight[k] > nothing)) continue;
      NodeDirections of_corner(scene_);
      for (const GivenDirection& given : directions_of(face.node[k])) {
        if (given.held) of_corner.add(given);
      }
      if (std::ranges::any_of(own, [&](const GivenDirection& held) { return of_corner.add(held); })) return true;
    }
    return false;
  }

  /// Calls visit(element, nodes) for the faces of a side.
  template <class Visit>
  void for_each_face(const SideMembers& members, const Visit& visit) const {
    std::vector<std::uint8_t> in_set(mesh_.hexahedra.size(), 0);
    for (const std::int32_t e : members.elements) in_set[e] = 1;
    std::vector<std::array<std::int32_t, 4>> keys;
    for (const auto& face : members.faces) keys.push_back(face_key(face));
    std::sort(keys.begin(), keys.end());
    for (std::size_t e = 0; e < mesh_.hexahedra.size(); ++e) {
      const bool whole = members.body[mesh_.body[e]] != 0 || in_set[e] != 0;
      if (!whole && keys.empty()) continue;
      for (unsigned f = 0; f < 6; ++f) {
        if ((exposed_[e] >> f & 1U) == 0) continue;
        const auto nodes = face_of(mesh_.hexahedra[e], f);
        if (whole || std::binary_search(keys.begin(), keys.end(), face_key(nodes))) visit(e, nodes);
      }
    }
  }

  std::vector<std::int32_t> nodes_of(const SideMembers& members) const {
    std::vector<std::int32_t> nodes = members.nodes;
    for_each_face(members, [&](std::int32_t, const std::array<std::int32_t, 4>& face) {
      nodes.insert(nodes.end(), face.begin(), face.end());
    });
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  std::vector<Face> faces_of(const SideMembers& members, double tolerance) const {
    std::vector<Face> faces;
    for_each_face(members, [&](std::int32_t element, const std::array<std::int32_t, 4>& node) {
      const auto diagonal = [&](std::size_t a, std::size_t b) {
        const Vec3<double> d = place(mesh_, node[b]) - place(mesh_, node[a]);
        return std::sqrt(dot(d, d));
      };
      const double size = std::min(diagonal(0, 2), diagonal(1, 3));
      faces.push_back({element, node, tolerance < 0 ? default_tolerance * size : tolerance});
    });
    return faces;
  }

  TiedResult tie(const TiedContact& tied, std::int16_t number) {
    TiedResult count;
    count.name = tied.name;
    const SideMembers first = find_members(mesh_, tied.first, tied.where + ".first");
    const SideMembers second = find_members(mesh_, tied.second, tied.where + ".second");
    const std::vector<std::int32_t> nodes = nodes_of(first);
    const std::vector<Face> faces = faces_of(second, tied.tolerance);
    const std::vector<std::vector<std::int32_t>> around = faces_near(nodes, faces);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const std::int32_t node = nodes[i];
      const Foot foot = nearest_foot(node, faces, around[i]);
      if (foot.face < 0) continue;
      const Face& face = faces[foot.face];
      if (!(foot.distance <= face.tolerance)) {
        ++count.near;
      } else if (held_[node] != 0) {
        ++count.held;
      } else if (tied_[node] != 0 || is_corner_[node] != 0) {
        ++count.taken;
      } else {
        ++count.nodes;
        if (is_held_beside(node, face, foot.weight)) ++count.free;
        tied_[node] = 1;
        for (const std::int32_t corner : face.node) is_corner_[corner] = 1;
        ties_.push_back({node, face.node, foot.weight, face.element, number});
      }
    }
    count.open = open_nodes(first, second, tied.tolerance);
    return count;
  }

  /// Nodes of the second side that lie on faces of the first and that no node follows: where that has the coarser mesh
  /// nothing keeps them there.
  std::int64_t open_nodes(const SideMembers& first, const SideMembers& second, double tolerance) const {
    std::vector<std::uint8_t> followed(mesh_.nodes.size(), 0);
    for (const TiedNode& tied : ties_) {
      for (std::size_t k = 0; k < 4; ++k) followed[tied.corner[k]] |= tied.weight[k] > 0 ? 1 : 0;
    }
    std::vector<std::int32_t> nodes = nodes_of(second);
    std::erase_if(nodes, [&](std::int32_t n) { return followed[n] != 0 || tied_[n] != 0 || held_[n] != 0; });
    const std::vector<Face> faces = faces_of(first, tolerance);
    if (faces.empty() || nodes.empty()) return 0;
    const std::vector<std::vector<std::int32_t>> around = faces_near(nodes, faces);
    std::int64_t open = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      open += std::ranges::any_of(around[i], [&](std::int32_t f) {
        const Face& face = faces[f];
        const bool its_own = std::ranges::find(face.node, nodes[i]) != face.node.end();
        return !its_own && foot_on(face, nodes[i]).distance <= face.tolerance;
      });
    }
    return open;
  }

  /// Of a node on one face; far away where there is none.
  Foot foot_on(const Face& face, std::int32_t node) const {
    Vec3<double> x[4];
    for (std::size_t k = 0; k < 4; ++k) x[k] = place(mesh_, face.node[k]);
    const FaceProjection<double> at = project_onto_face(x, place(mesh_, node), 0.0, 0.0);
    Vec3<double> to = place(mesh_, node);  // what a foot lies outside of a face is known up to its size alone
    for (std::size_t k = 0; k < 4; ++k) to = to - at.weight[k] * x[k];
    Foot foot;
    foot.distance = at.outside < INFINITY ? std::sqrt(dot(to, to)) : INFINITY;
    std::copy(std::begin(at.weight), std::end(at.weight), foot.weight.begin());
    return foot;
  }

  /// Per node the faces that it lies near, in their order.
  std::vector<std::vector<std::int32_t>> faces_near(const std::vector<std::int32_t>& nodes,
                                                    const std::vector<Face>& faces) const {
    const std::int32_t first_node = faces.size();
    MovingBoxes<double> boxes(first_node + static_cast<std::int32_t>(nodes.size()));
    const auto box_of = [&](const std::int32_t* node, int count, double reach) {
      MovingBox<double> box = empty_box<double>();
      for (int k = 0; k < 3; ++k) {
        double low = INFINITY, high = -INFINITY;
        for (int i = 0; i < count; ++i) {
          const double x = mesh_.nodes[node[i]][k];
          low = std::min(low, x);
          high = std::max(high, x);
        }
        box.bound[k] = box.bound[6 + k] = low - reach;
        box.bound[3 + k] = box.bound[9 + k] = high + reach;
      }
      return box;
    };
    for (std::int32_t f = 0; f < first_node; ++f) {
      boxes.set(f, box_of(faces[f].node.data(), 4, near * faces[f].tolerance));
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      boxes.set(first_node + static_cast<std::int32_t>(i), box_of(&nodes[i], 1, 0));
    }
    BoxPairs<double> pairs;
    pairs.find(boxes, ContactSearch::tree,
               [first_node](std::int32_t a, std::int32_t b) { return a < first_node && b >= first_node; });
    std::vector<std::vector<std::int32_t>> around(nodes.size());
    for (std::int64_t piece = 0; piece < fixed_pieces; ++piece) {
      const auto firsts = pairs.firsts(piece), seconds = pairs.seconds(piece);
      for (std::size_t p = 0; p < firsts.size(); ++p) around[seconds[p] - first_node].push_back(firsts[p]);
    }
    return around;
  }

  /// The nearest face that may take a node, as far as that is near; none: -1.
  Foot nearest_foot(std::int32_t node, const std::vector<Face>& faces, const std::vector<std::int32_t>& around) const {
    Foot best;
    for (const std::int32_t number : around) {
      const Face& face = faces[number];
      const auto is_its_own = [&](std::int32_t corner) { return corner == node || tied_[corner] != 0; };
      if (std::any_of(face.node.begin(), face.node.end(), is_its_own)) continue;
      const Foot foot = foot_on(face, node);
      if (!(foot.distance <= near * face.tolerance)) continue;
      const double same = 1e-9 * face.tolerance;
      if (best.face >= 0 && !(foot.distance < best.distance - same)) continue;
      best = foot;
      best.face = number;
    }
    drop_round_off(best.weight);
    return best;
  }

  static void drop_round_off(std::array<double, 4>& weight) {
    double sum = 0;
    for (double& w : weight) sum += w = w < nothing ? 0.0 : w;
    auto largest = std::max_element(weight.begin(), weight.end());
    if (sum > 0) *largest += 1 - sum;
  }

  void put_on_faces() {
    std::vector<std::uint8_t> moved(mesh_.nodes.size(), 0);
    for (const TiedNode& tied : ties_) {
      if (scene_.tied_contacts[tied.tie].start > 0) continue;
      moved[tied.node] = 1;
      for (std::size_t c = 0; c < 3; ++c) {
        double x = 0;
        for (std::size_t k = 0; k < 4; ++k) x += tied.weight[k] * mesh_.nodes[tied.corner[k]][c];
        mesh_.nodes[tied.node][c] = x;
      }
    }
    for (std::int64_t e = 0; e < mesh_.element_count(); ++e) {
      const auto& nodes = mesh_.hexahedra[e];
      if (std::none_of(nodes.begin(), nodes.end(), [&](std::int32_t n) { return moved[n] != 0; })) continue;
      const std::string problem = volume_problem(mesh_.corners(e), scene_.precision);
      if (problem.empty()) continue;
      throw InputError(
          fmt::format("{}{} {} when its nodes are put on the faces that they are tied "
                      "to: try a smaller contact.tied tolerance",
                      message_head(scene_), element_name(mesh_, e), problem));
    }
  }

  const Scene& scene_;
  ModelMesh& mesh_;
  std::vector<std::uint8_t> exposed_, held_;
  std::vector<GivenDirection> directions_;      ///< by nodes
  std::vector<std::uint8_t> tied_, is_corner_;  ///< per node
  std::vector<TiedNode> ties_;
};

}  // namespace

std::vector<TiedNode> find_ties(const Scene& scene, ModelMesh& mesh, std::vector<TiedResult>& counts) {
  if (scene.tied_contacts.empty()) return {};
  return TieSearch(scene, mesh).find(counts);
}

}  // namespace pinball

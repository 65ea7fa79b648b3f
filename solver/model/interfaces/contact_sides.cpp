#include "contact_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <unordered_map>

#include <solver/base/error.hpp>
#include <solver/base/face_corners.hpp>
#include <solver/base/text_distance.hpp>
#include <solver/model/rigid/rigid_nodes.hpp>
#include <solver/model/selection/named_nodes.hpp>

namespace pinball {

namespace {

/// The set of this name or number. Throws InputError where there is none, and for what is wrong with it.
template <class Set>
const Set& set_of(const std::vector<Set>& sets, const MeshSetName& name, const char* kind, const FileNodes& file,
                  const std::string& where) {
  const Set* found = find_set(sets, name.set);
  if (found == nullptr) {
    const std::vector<std::string> known = set_names(sets);
    throw InputError(fmt::format("{}: {} has no set of {} \"{}\"{}", where, file.path, kind, name.set,
                                 known.empty() ? "" : fmt::format(", nearest is \"{}\"", nearest(name.set, known))));
  }
  if (!found->problem.empty()) throw InputError(fmt::format("{}: {}", where, found->problem));
  return *found;
}

template <class Members>
void require_some(const Members& members, const MeshSetName& name, const char* kind, const std::string& where) {
  if (!members.empty()) return;
  throw InputError(
      fmt::format("{}: expected a set with {} of the scene's bodies, \"{}\" has none", where, kind, name.set));
}

}  // namespace

SideMembers find_members(const ModelMesh& mesh, const ContactSide& side, const std::string& where) {
  SideMembers members;
  members.body.assign(mesh.body_names.size(), 0);
  for (const std::string& body : side.bodies) {
    const auto found = std::ranges::find(mesh.body_names, body);
    if (found == mesh.body_names.end()) throw InputError(fmt::format("{}: no body named \"{}\"", where, body));
    members.body[found - mesh.body_names.begin()] = 1;
  }
  const auto add = [&](const std::vector<MeshSetName>& names, const char* kind, auto sets, auto of, auto& all) {
    for (const MeshSetName& name : names) {
      const FileNodes& file = file_of(mesh, name.file, where);
      const auto& own = set_of(file.*sets, name, kind, file, where).*of;
      require_some(own, name, kind, where);
      all.insert(all.end(), own.begin(), own.end());
    }
  };
  add(side.elements, "elements", &FileNodes::element_sets, &MeshSet::members, members.elements);
  add(side.faces, "faces", &FileNodes::face_sets, &FaceSet::faces, members.faces);
  add(side.nodes, "nodes", &FileNodes::sets, &MeshSet::members, members.nodes);
  return members;
}

namespace {

std::vector<bool> nodes_of_side(const ModelMesh& mesh, const ContactSide& side, const std::string& where) {
  const SideMembers members = find_members(mesh, side, where);
  std::vector<bool> of_side(mesh.nodes.size(), false);
  const auto add = [&of_side](const auto& nodes) {
    for (const std::int32_t node : nodes) of_side[node] = true;
  };
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    if (members.body[mesh.body[e]] != 0) add(mesh.hexahedra[e]);
  }
  for (const std::int32_t e : members.elements) add(mesh.hexahedra[e]);
  for (const auto& face : members.faces) add(face);
  add(members.nodes);
  return of_side;
}

}  // namespace

MetSides::MetSides(const Scene& scene, const ModelMesh& mesh) {
  const auto add = [&](const auto& contact) {
    nodes_.push_back({nodes_of_side(mesh, contact.first, contact.where + ".first"),
                      nodes_of_side(mesh, contact.second, contact.where + ".second")});
  };
  for (const TiedContact& tied : scene.tied_contacts) add(tied);
  for (const ContactPair& pair : scene.contact_pairs) {
    if (!pair.second.empty()) add(pair);
  }
}

bool MetSides::have(std::int32_t a, std::int32_t b) const {
  return std::ranges::any_of(
      nodes_, [a, b](const auto& sides) { return (sides[0][a] && sides[1][b]) || (sides[0][b] && sides[1][a]); });
}

namespace {

/// Puts together which group each thing of a model belongs to.
template <class S>
class SidesOfModel {
 public:
  explicit SidesOfModel(const Model<S>& model)
      : model_(model), element_(model.mesh.hexahedra.size(), SidePatterns::none), faces_of_(0, FaceHash{}) {}

  SurfaceSides build() {
    const Scene& scene = model_.scene;
    for (const ContactPair& pair : scene.contact_pairs) {
      sides_.rules.push_back(
          {pair.friction, pair.static_friction, pair.friction_decay, pair.start, pair.end, pair.second.empty()});
    }
    sides_.ties = scene.tied_contacts.size();
    const std::vector<std::int32_t> rigid = bodies_with_attached_nodes();
    sides_.rigid = rigid.size();
    std::int32_t side = 0;
    for (const ContactPair& pair : scene.contact_pairs) {
      take(find_members(model_.mesh, pair.first, pair.where + ".first"), side++);
      if (!pair.second.empty()) take(find_members(model_.mesh, pair.second, pair.where + ".second"), side);
      ++side;
    }
    for (const TiedContact& tied : scene.tied_contacts) {
      take(find_members(model_.mesh, tied.second, tied.where + ".second"), side++);
    }
    for (const std::int32_t body : rigid) {
      const RigidBody& of = scene.rigid_bodies[body];
      take(find_members(model_.mesh, {.bodies = of.bodies}, of.where), side++);
    }
    spread();
    find_attached(rigid);
    return std::move(sides_);
  }

 private:
  struct FaceHash {
    std::size_t operator()(const std::array<std::int32_t, 4>& key) const {
      std::size_t hash = 0;
      for (const std::int32_t n : key) hash = hash * 0x9E3779B97F4A7C15ULL + n;
      return hash ^ hash >> 29;
    }
  };

  /// Numbers of the rigid bodies that nodes are attached to, ascending.
  std::vector<std::int32_t> bodies_with_attached_nodes() const {
    std::set<std::int32_t> bodies;
    for (const AttachedNodes& attached : model_.scene.attached_nodes) {
      bodies.insert(rigid_body_of_name(model_.scene, attached.rigid_body));
    }
    return {bodies.begin(), bodies.end()};
  }

  /// Of the nodes that move with these bodies those that no element of a rigid body has.
  void find_attached(const std::vector<std::int32_t>& rigid) {
    if (rigid.empty()) return;
    sides_.attached_to.assign(sides_.node.size(), -1);
    for (std::size_t number = 0; number < rigid.size(); ++number) {
      for (const std::int32_t n : model_.rigid[rigid[number]].nodes) {
        sides_.attached_to[n] = static_cast<std::int16_t>(number);
      }
    }
    for (std::size_t e = 0; e < model_.mesh.hexahedra.size(); ++e) {
      if (model_.rigid_of_body[model_.mesh.body[e]] < 0) continue;
      for (const std::int32_t node : model_.mesh.hexahedra[e]) sides_.attached_to[model_.node_of_scene_node[node]] = -1;
    }
  }

  void take(const SideMembers& members, std::int32_t side) {
    SidePatterns& patterns = sides_.patterns;
    const bool some_body = std::ranges::find(members.body, 1) != members.body.end();
    for (std::size_t e = 0; some_body && e < element_.size(); ++e) {
      if (members.body[model_.mesh.body[e]] != 0) element_[e] = patterns.with(element_[e], side);
    }
    for (const std::int32_t e : members.elements) element_[e] = patterns.with(element_[e], side);
    for (const auto& face : members.faces) {
      std::int32_t& group = faces_of_.try_emplace(face_key(face), SidePatterns::none).first->second;
      group = patterns.with(group, side);
    }
    if (!members.nodes.empty() && node_.empty()) node_.assign(model_.mesh.nodes.size(), SidePatterns::none);
    for (const std::int32_t n : members.nodes) node_[n] = patterns.with(node_[n], side + sides_.sides());
  }

  /// From elements of the scene to slots, faces and nodes of the store.
  void spread() {
    SidePatterns& patterns = sides_.patterns;
    sides_.element.assign(model_.elements.slots, SidePatterns::none);
    if (!faces_of_.empty()) sides_.face.assign(sides_.element.size(), {});
    sides_.node.assign(model_.mesh.nodes.size(), SidePatterns::none);
    for (std::size_t n = 0; n < node_.size(); ++n) sides_.node[model_.node_of_scene_node[n]] = node_[n];
    const auto add_to = [&](std::int32_t node, std::int32_t group) {
      std::int32_t& own = sides_.node[model_.node_of_scene_node[node]];
      own = patterns.joined(own, group);
    };
    for (std::size_t e = 0; e < element_.size(); ++e) {
      const std::int64_t slot = model_.slot_of_element[e];
      const auto& corners = model_.mesh.hexahedra[e];
      for (const std::int32_t node : corners) add_to(node, element_[e]);
      std::int32_t whole = element_[e];  // the ball of an element with a face belongs to the side of the face
      for (unsigned f = 0; f < 6 && !faces_of_.empty(); ++f) {
        const std::array<std::int32_t, 4> nodes = face_of(corners, f);
        std::int32_t group = element_[e];
        if (const auto found = faces_of_.find(face_key(nodes)); found != faces_of_.end()) {
          group = patterns.joined(group, found->second);
          for (const std::int32_t node : nodes) add_to(node, found->second);
        }
        sides_.face[slot][f] = group;
        whole = patterns.joined(whole, group);
      }
      sides_.element[slot] = whole;
    }
  }

  const Model<S>& model_;
  SurfaceSides sides_;
  std::vector<std::int32_t> element_;  ///< group per element of the scene
  std::vector<std::int32_t> node_;     ///< group of sets of nodes, per node of the scene; empty: there are none
  std::unordered_map<std::array<std::int32_t, 4>, std::int32_t, FaceHash> faces_of_;  ///< group by nodes
};

}  // namespace

template <class S>
std::unique_ptr<ContactPairs> make_contact_pairs(const Model<S>& model) {
  const Scene& scene = model.scene;
  if (scene.contact_pairs.empty() && scene.tied_contacts.empty() && scene.attached_nodes.empty()) return nullptr;
  try {
    return std::make_unique<ContactPairs>(SidesOfModel<S>(model).build());
  } catch (const std::length_error&) {
    throw InputError(message_head(model.scene) +
                     "contact.pair: expected fewer ways in which sides of pairs, ties and rigid bodies with attached "
                     "nodes share bodies and sets (4,096)");
  }
}

template std::unique_ptr<ContactPairs> make_contact_pairs(const Model<double>&);
template std::unique_ptr<ContactPairs> make_contact_pairs(const Model<float>&);

}  // namespace pinball

#include "overlapping_bodies.hpp"

#include <algorithm>
#include <utility>

#include <solver/base/faces.hpp>
#include <solver/model/exposed_faces.hpp>
#include <solver/model/nodes_of_bodies.hpp>

namespace pinball {

namespace {

/// A node on a face of an element, inside or on the surface, may be off it by rounding: over the size of the element.
constexpr double off_by_rounding = -1e-9;
/// Part of what facets stand out that is forgiven: nodes need not lie on the curved surface as exactly as those of the
/// facets.
constexpr double forgiven = 1.5;

}  // namespace

bool may_touch(const std::vector<ContactPair>& pairs, const std::string& a, const std::string& b) {
  const auto holds = [](const ContactSide& side, const std::string& body) {
    return !side.elements.empty() || !side.faces.empty() || !side.nodes.empty() ||
           std::ranges::find(side.bodies, body) != side.bodies.end();
  };
  return pairs.empty() || std::any_of(pairs.begin(), pairs.end(), [&](const ContactPair& pair) {
           const ContactSide& second = pair.second.empty() ? pair.first : pair.second;
           return (holds(pair.first, a) && holds(second, b)) || (holds(pair.first, b) && holds(second, a));
         });
}

OverlappingBodies::OverlappingBodies(const ModelMesh& mesh, const std::vector<ContactPair>& pairs,
                                     std::vector<std::int32_t> rigid)
    : mesh_(mesh), pairs_(pairs), rigid_(std::move(rigid)), bodies_(mesh.body_names.size()) {
  for_nodes_of_bodies(mesh, [&](std::int32_t b, std::int32_t n) {
    bodies_[b].box.take(mesh.nodes[n]);
    bodies_[b].nodes.push_back(n);
  });
  for (BodyParts& body : bodies_) std::ranges::sort(body.nodes);
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) bodies_[mesh.body[e]].elements.push_back(e);
}

bool OverlappingBodies::may_touch(std::size_t a, std::size_t b) const {
  const bool one = !rigid_.empty() && rigid_[a] >= 0 && rigid_[a] == rigid_[b];
  return !one && pinball::may_touch(pairs_, mesh_.body_names[a], mesh_.body_names[b]);
}

void OverlappingBodies::for_each(const std::function<bool(std::size_t, std::size_t, const Bounds&)>& visit) const {
  for (std::size_t a = 0; a < bodies_.size(); ++a) {
    for (std::size_t b = a + 1; b < bodies_.size(); ++b) {
      const Bounds box = common(bodies_[a].box, bodies_[b].box);
      if (box.empty() || !may_touch(a, b)) continue;
      if (!visit(a, b, box)) return;
    }
  }
}

const BodySurface& NodeDepths::surface(std::size_t body) {
  if (exposed_.empty()) {
    exposed_ = find_exposed_faces(mesh_, scene_.constraints, face_neighbours(mesh_.hexahedra));
  }
  const auto found = surfaces_.find(body);
  if (found != surfaces_.end()) return found->second;
  return surfaces_.emplace(body, BodySurface(mesh_, bodies_.parts(body).elements, exposed_)).first->second;
}

void NodeDepths::of_one_in_other(std::size_t of, std::size_t in, const Bounds& box, double least,
                                 const std::function<void(std::size_t, const BodyDepth&)>& visit) {
  const BodyInside other(mesh_, bodies_.parts(in).elements, box);
  const std::vector<std::size_t>& common = bodies_.parts(in).nodes;
  for (const std::size_t n : bodies_.parts(of).nodes) {
    if (std::ranges::binary_search(common, n)) continue;  // it is where both hang together
    const Point& x = mesh_.nodes[n];
    if (!box.holds(x) || !other.holds(x, off_by_rounding)) continue;
    const BodyDepth depth = surface(in).depth_of(x, surface(of).normals_at(n));
    if (depth.depth > least * depth.size + forgiven * depth.facets) visit(n, depth);
  }
}

void NodeDepths::for_each(std::size_t a, std::size_t b, const Bounds& box, double least,
                          const std::function<void(std::size_t, const BodyDepth&)>& visit) {
  of_one_in_other(a, b, box, least, visit);
  of_one_in_other(b, a, box, least, visit);
}

}  // namespace pinball

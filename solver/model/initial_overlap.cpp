#include "initial_overlap.hpp"

#include <solver/model/interfaces/body_depth.hpp>
#include <solver/model/interfaces/overlapping_bodies.hpp>
#include <solver/model/interfaces/piercing_edges.hpp>
#include <solver/model/rigid/rigid_nodes.hpp>

namespace pinball {

namespace {

/// Depth at which a point of an element tells an overlap, over the size of the element, and at which a node does, over
/// that of a face.
constexpr double deep_point = 0.1, deep_node = 0.01;

/// Points of one body inside elements of another, within the box that both share.
std::int64_t points_inside(const ModelMesh& mesh, const BodyParts& of, const BodyInside& in, const Bounds& box,
                           double depth) {
  std::int64_t count = 0;
  const auto look = [&](const Point& x) { count += box.holds(x) && in.holds(x, depth); };
  for (const std::size_t n : of.nodes) look(mesh.nodes[n]);
  for (const std::size_t e : of.elements) {
    const Point centre = element_centre(mesh, e);
    look(centre);
    // Nodes and centres of regular meshes may all lie on faces of the other body's elements.
    for (const Point& corner : mesh.corners(e)) {
      const Point to = minus(corner, centre);
      look({centre[0] + 0.55 * to[0], centre[1] + 0.55 * to[1], centre[2] + 0.55 * to[2]});
    }
  }
  return count;
}

/// Of both; without any, edges of one that go through the other.
std::int64_t points_inside(const ModelMesh& mesh, const BodyParts& a, const BodyParts& b, const Bounds& box,
                           double depth) {
  const std::int64_t points = points_inside(mesh, a, BodyInside(mesh, b.elements, box), box, depth) +
                              points_inside(mesh, b, BodyInside(mesh, a.elements, box), box, depth);
  return points > 0 ? points : edges_through(mesh, a, b, box, depth);
}

}  // namespace

InitialOverlap find_initial_overlap(const ModelMesh& mesh, const std::vector<ContactPair>& pairs, double depth,
                                    const std::vector<std::int32_t>& rigid) {
  const OverlappingBodies bodies(mesh, pairs, rigid);
  InitialOverlap found;
  bodies.for_each([&](std::size_t a, std::size_t b, const Bounds& box) {
    const std::int64_t points = points_inside(mesh, bodies.parts(a), bodies.parts(b), box, depth);
    if (points > 0) found = {mesh.body_names[a], mesh.body_names[b], points};
    return points == 0;
  });
  return found;
}

InitialOverlap find_overlap_at(double time, const Scene& scene, const ModelMesh& mesh, double depth) {
  std::vector<ContactPair> pairs = scene.contact_pairs;
  std::erase_if(pairs, [time](const ContactPair& pair) { return pair.end < time; });
  if (pairs.empty() && !scene.contact_pairs.empty()) return {};
  return find_initial_overlap(mesh, pairs, depth, rigid_body_of_bodies(scene));
}

namespace {

std::vector<InitialOverlap> all_overlaps(const Scene& scene, const ModelMesh& mesh,
                                         const std::vector<ContactPair>& pairs, double time) {
  const OverlappingBodies bodies(mesh, pairs, rigid_body_of_bodies(scene));
  NodeDepths depths(scene, mesh, bodies);
  std::vector<InitialOverlap> found;
  bodies.for_each([&](std::size_t a, std::size_t b, const Bounds& box) {
    InitialOverlap pair{mesh.body_names[a], mesh.body_names[b],
                        points_inside(mesh, bodies.parts(a), bodies.parts(b), box, deep_point)};
    depths.for_each(a, b, box, deep_node, [&](std::size_t node, const BodyDepth& depth) {
      ++pair.nodes;
      if (!(depth.depth > pair.depth)) return;
      pair.node = node;
      pair.depth = depth.depth;
      pair.share = depth.depth / depth.size;
    });
    pair.time = time;
    if (pair.points > 0 || pair.nodes > 0) found.push_back(pair);
    return true;
  });
  return found;
}

}  // namespace

std::vector<InitialOverlap> find_initial_overlaps(const Scene& scene, const ModelMesh& mesh) {
  return all_overlaps(scene, mesh, scene.contact_pairs, 0);
}

std::vector<InitialOverlap> find_begun_overlaps(const Scene& scene, const ModelMesh& mesh, double before, double time) {
  std::vector<ContactPair> pairs = scene.contact_pairs;
  std::erase_if(
      pairs, [&](const ContactPair& pair) { return !(before < pair.start && pair.start <= time) || pair.end <= time; });
  return pairs.empty() ? std::vector<InitialOverlap>() : all_overlaps(scene, mesh, pairs, time);
}

}  // namespace pinball

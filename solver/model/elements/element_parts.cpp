#include "element_parts.hpp"

#include <solver/mesh/tetrahedra.hpp>
#include <solver/model/rigid/rigid_nodes.hpp>

namespace pinball {

namespace {

/// Which shapes the deformable elements of each body have: hexahedra, tetrahedra. Rigid ones count as hexahedra.
std::vector<std::array<bool, 2>> shapes_of_bodies(const Scene& scene, const ModelMesh& mesh,
                                                  const std::vector<std::int32_t>& rigid_body) {
  std::vector<std::array<bool, 2>> shapes(scene.bodies.size(), {false, false});
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    const std::int32_t body = mesh.body[e];
    shapes[body][rigid_body[body] < 0 && is_tetrahedron(mesh.hexahedra[e]) ? 1 : 0] = true;
  }
  return shapes;
}

}  // namespace

std::size_t ElementParts::part_of(const ModelMesh& mesh, std::size_t element) const {
  const std::array<std::size_t, 2>& of = of_body[mesh.body[element]];
  return of[is_tetrahedron(mesh.hexahedra[element]) ? 1 : 0];
}

ElementParts element_parts(const Scene& scene, const ModelMesh& mesh) {
  const std::vector<std::size_t> material_of_body = material_of_bodies(scene);
  const std::vector<std::int32_t> rigid_body = rigid_body_of_bodies(scene);
  const std::vector<std::array<bool, 2>> shapes = shapes_of_bodies(scene, mesh, rigid_body);
  ElementParts all;
  all.of_body.resize(scene.bodies.size());
  for (std::size_t material = 0; material < scene.materials.size(); ++material) {
    const std::size_t first = all.parts.size();
    const auto number_of = [&](const ElementPart& wanted) {
      const auto is_it = [&](const ElementPart& p) {
        return p.settings == wanted.settings && p.rigid == wanted.rigid && p.tetrahedra == wanted.tetrahedra;
      };
      std::size_t part = first;
      while (part < all.parts.size() && !is_it(all.parts[part])) ++part;
      if (part == all.parts.size()) all.parts.push_back(wanted);
      return part;
    };
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      if (material_of_body[b] != material) continue;
      const ElementSettings& settings = scene.bodies[b].element ? *scene.bodies[b].element : scene.element;
      const bool rigid = rigid_body[b] >= 0;
      for (const bool tetrahedra : {false, true}) {
        if (shapes[b][tetrahedra ? 1 : 0])
          all.of_body[b][tetrahedra ? 1 : 0] = number_of({material, settings, rigid, tetrahedra});
      }
      if (rigid) all.of_body[b][1] = all.of_body[b][0];
    }
    if (all.parts.size() == first) all.parts.push_back({material, scene.element});
  }
  return all;
}

}  // namespace pinball

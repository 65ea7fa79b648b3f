#include "element_parts.hpp"

#include <variant>

#include <kernels/exec.hpp>
#include <solver/model/rigid/rigid_nodes.hpp>

namespace pinball {

namespace {

bool is_generated(const Body& body) {
  return !std::holds_alternative<FileMesh>(body.mesh) && !std::holds_alternative<ArrayMesh>(body.mesh);
}

std::size_t place_of(WorkedShape shape) { return static_cast<std::size_t>(shape); }

/// Per element. Rigid ones count as hexahedra.
std::vector<WorkedShape> shapes_of_elements(const Scene& scene, const ModelMesh& mesh,
                                            const std::vector<std::int32_t>& rigid_body) {
  std::vector<WorkedShape> shapes(mesh.hexahedra.size(), WorkedShape::hexahedron);
  parallel_for("shapes of elements", RangePolicy<>{0, mesh.element_count()}, [&](std::int64_t e) {
    if (rigid_body[mesh.body[e]] < 0) shapes[e] = worked_shape(scene, mesh, e);
  });
  return shapes;
}

}  // namespace

WorkedShape worked_shape(const Scene& scene, const ModelMesh& mesh, std::size_t element) {
  const WorkedShape shape = worked_as(mesh.hexahedra[element]);
  const bool keeps = shape == WorkedShape::wedge && is_generated(scene.bodies[mesh.body[element]]);
  return keeps ? WorkedShape::hexahedron : shape;
}

CornerShares corner_shares(const Scene& scene, const ModelMesh& mesh, std::size_t element) {
  return corner_shares(worked_shape(scene, mesh, element), mesh.hexahedra[element]);
}

std::size_t ElementParts::part_of(const ModelMesh& mesh, std::size_t element) const {
  return of_body[mesh.body[element]][place_of(shape[element])];
}

ElementParts element_parts(const Scene& scene, const ModelMesh& mesh) {
  const std::vector<std::size_t> material_of_body = material_of_bodies(scene);
  const std::vector<std::int32_t> rigid_body = rigid_body_of_bodies(scene);
  ElementParts all;
  all.shape = shapes_of_elements(scene, mesh, rigid_body);
  std::vector<std::array<bool, 3>> has(scene.bodies.size(), {false, false, false});
  for (std::size_t e = 0; e < all.shape.size(); ++e) has[mesh.body[e]][place_of(all.shape[e])] = true;
  all.of_body.resize(scene.bodies.size());
  for (std::size_t material = 0; material < scene.materials.size(); ++material) {
    const std::size_t first = all.parts.size();
    const auto number_of = [&](const ElementPart& wanted) {
      const auto is_it = [&](const ElementPart& p) {
        return p.settings == wanted.settings && p.rigid == wanted.rigid && p.shape == wanted.shape;
      };
      std::size_t part = first;
      while (part < all.parts.size() && !is_it(all.parts[part])) ++part;
      if (part == all.parts.size()) all.parts.push_back(wanted);
      return part;
    };
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      if (material_of_body[b] != material) continue;
      const ElementSettings& settings = scene.bodies[b].element ? *scene.bodies[b].element : scene.element;
      for (const auto shape : {WorkedShape::hexahedron, WorkedShape::wedge, WorkedShape::tetrahedron}) {
        if (has[b][place_of(shape)])
          all.of_body[b][place_of(shape)] = number_of({material, settings, rigid_body[b] >= 0, shape});
      }
    }
    if (all.parts.size() == first) all.parts.push_back({material, scene.element});
  }
  return all;
}

}  // namespace pinball

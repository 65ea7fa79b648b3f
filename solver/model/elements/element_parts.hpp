#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <solver/mesh/shapes/wedges.hpp>
#include <solver/model/model.hpp>
#include <solver/scene.hpp>

namespace pinball {

/// Of an element as if it deformed. Those at the axis of generated sections are wedges, too, but are worked as
/// hexahedra: with one element around the angle there are as many nodes to move as elsewhere, and nothing locks; which
/// of their nodes has two corners is given by the axis.
WorkedShape worked_shape(const Scene& scene, const ModelMesh& mesh, std::size_t element);

/// Of its mass, also where it is rigid.
CornerShares corner_shares(const Scene& scene, const ModelMesh& mesh, std::size_t element);

/// Elements that one kernel with one set of constants works: of a material, with the settings of [element] or those
/// that a body has in their place; rigid or not; of one shape.
struct ElementPart {
  std::size_t material = 0;
  ElementSettings settings;
  bool rigid = false;                           ///< of rigid bodies: no kernel works them, no step has to be stable
  WorkedShape shape = WorkedShape::hexahedron;  ///< of rigid ones always that
};

struct ElementParts {
  std::vector<ElementPart> parts;  ///< by material, those of one in the order of their bodies; at least one of each
  std::vector<std::array<std::size_t, 3>> of_body;  ///< of the elements of each shape of each body
  std::vector<WorkedShape> shape;                   ///< per element

  /// Number of the part that an element belongs to.
  std::size_t part_of(const ModelMesh& mesh, std::size_t element) const;
};

/// Of a completed scene. Bodies of one material with the same settings share a part. Throws InputError where a body has
/// a material that is not there.
ElementParts element_parts(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <solver/model/model.hpp>
#include <solver/scene.hpp>

namespace pinball {

/// Elements that one kernel with one set of constants works: of a material, with the settings of [element] or those
/// that a body has in their place; rigid or not; of one shape.
struct ElementPart {
  std::size_t material = 0;
  ElementSettings settings;
  bool rigid = false;       ///< of rigid bodies: no kernel works them, no step has to be stable for them
  bool tetrahedra = false;  ///< deformable ones; all else are hexahedra
};

struct ElementParts {
  std::vector<ElementPart> parts;  ///< by material, those of one in the order of their bodies; at least one of each
  std::vector<std::array<std::size_t, 2>> of_body;  ///< of the hexahedra and the tetrahedra of each body

  /// Number of the part that an element belongs to.
  std::size_t part_of(const ModelMesh& mesh, std::size_t element) const;
};

/// Of a completed scene. Bodies of one material with the same settings share a part. Throws InputError where a body has
/// a material that is not there.
ElementParts element_parts(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball

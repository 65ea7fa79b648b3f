#pragma once

#include <cstddef>
#include <vector>

#include <solver/scene.hpp>

namespace pinball {

/// Elements that one kernel with one set of constants works: of a material, with the settings of [element] or those
/// that a body has in their place; rigid or not.
struct ElementPart {
  std::size_t material = 0;
  ElementSettings settings;
  bool rigid = false;  ///< of rigid bodies: no kernel works them, no step has to be stable for them
};

struct ElementParts {
  std::vector<ElementPart> parts;    ///< by material, those of one in the order of their bodies; at least one of each
  std::vector<std::size_t> of_body;  ///< number of the part that the elements of each body belong to
};

/// Of a completed scene. Bodies of one material with the same settings share a part. Throws InputError where a body has
/// a material that is not there.
ElementParts element_parts(const Scene& scene);

}  // namespace pinball

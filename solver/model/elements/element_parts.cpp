#include "element_parts.hpp"

#include <solver/model/model.hpp>
#include <solver/model/rigid/rigid_nodes.hpp>

namespace pinball {

ElementParts element_parts(const Scene& scene) {
  const std::vector<std::size_t> material_of_body = material_of_bodies(scene);
  const std::vector<std::int32_t> rigid_body = rigid_body_of_bodies(scene);
  ElementParts all;
  all.of_body.resize(scene.bodies.size());
  for (std::size_t material = 0; material < scene.materials.size(); ++material) {
    const std::size_t first = all.parts.size();
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      if (material_of_body[b] != material) continue;
      const ElementSettings& settings = scene.bodies[b].element ? *scene.bodies[b].element : scene.element;
      const bool rigid = rigid_body[b] >= 0;
      const auto is_other = [&](const ElementPart& p) { return p.settings != settings || p.rigid != rigid; };
      std::size_t part = first;
      while (part < all.parts.size() && is_other(all.parts[part])) ++part;
      if (part == all.parts.size()) all.parts.push_back({material, settings, rigid});
      all.of_body[b] = part;
    }
    if (all.parts.size() == first) all.parts.push_back({material, scene.element});
  }
  return all;
}

}  // namespace pinball

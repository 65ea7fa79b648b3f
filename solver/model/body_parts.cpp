#include "body_parts.hpp"

#include <algorithm>
#include <array>

#include "elements/element_parts.hpp"

namespace pinball {

template <class S>
std::vector<std::vector<BodyPart>> parts_of_bodies(const Model<S>& model, const std::vector<std::int32_t>& nodes) {
  std::vector<std::vector<BodyPart>> parts(nodes.size());
  if (nodes.empty()) return parts;
  std::vector<std::int32_t> place(model.mesh.nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) place[nodes[i]] = i;
  for (std::size_t e = 0; e < model.mesh.hexahedra.size(); ++e) {
    const std::array<std::int32_t, 8>& corners = model.mesh.hexahedra[e];
    if (std::ranges::none_of(corners, [&](std::int32_t n) { return place[n] >= 0; })) continue;
    const CornerShares share = corner_shares(model.scene, model.mesh, e);
    for (std::size_t i = 0; i < 8; ++i) {
      if (place[corners[i]] < 0) continue;
      std::vector<BodyPart>& bodies = parts[place[corners[i]]];
      auto own = std::ranges::find(bodies, model.mesh.body[e], &BodyPart::body);
      if (own == bodies.end()) own = bodies.insert(own, {model.mesh.body[e], 0.0});
      own->share += model.element_mass[e] * share[i];
    }
  }
  for (std::vector<BodyPart>& bodies : parts) {
    double mass = 0;
    for (const BodyPart& part : bodies) mass += part.share;
    for (BodyPart& part : bodies) part.share /= mass;
  }
  return parts;
}

template std::vector<std::vector<BodyPart>> parts_of_bodies(const Model<double>&, const std::vector<std::int32_t>&);
template std::vector<std::vector<BodyPart>> parts_of_bodies(const Model<float>&, const std::vector<std::int32_t>&);

}  // namespace pinball

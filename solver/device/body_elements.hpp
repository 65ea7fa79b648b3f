#pragma once

#include <utility>

#include <kernels/exec.hpp>
#include <solver/model/elements/element_parts.hpp>
#include <solver/model/model.hpp>

#include "body_sums.hpp"

namespace pinball {

/// place_of(slot): where the element of a slot lies in the arrays that are summed up.
template <class S, class PlaceOf>
BodyElements body_elements(const Model<S>& model, const PlaceOf& place_of) {
  const std::size_t bodies = model.mesh.body_names.size();
  std::vector<std::int32_t> next(bodies, 0);  // per body: of its elements in the lists
  for (const std::int32_t body : model.mesh.body) ++next[body];
  BodyElements elements;
  elements.bodies = bodies;
  std::int32_t all = 0;
  for (std::size_t body = 0; body < bodies; ++body) {
    const std::int32_t count = std::exchange(next[body], all);
    for (std::int32_t i = 0; i < count; i += BodyElements::most_of_piece) {
      elements.first.push_back(all + i);
      elements.body.push_back(static_cast<std::int32_t>(body));
    }
    all += count;
  }
  elements.first.push_back(all);
  std::vector<std::int32_t> element_of(all);
  for (const std::int32_t element : model.element_of_slot) {
    if (element >= 0) element_of[next[model.mesh.body[element]]++] = element;
  }
  elements.place.renew(all);
  elements.mass.renew(all);
  elements.nodes.renew(all);
  parallel_for("elements of bodies", RangePolicy<>{0, all}, [&](std::int64_t i) {
    const std::int32_t element = element_of[i];
    elements.place[i] = static_cast<std::int32_t>(place_of(model.slot_of_element[element]));
    elements.mass[i] = model.element_mass[element];
    elements.nodes[i] = worked_shape(model.scene, model.mesh, element) == WorkedShape::wedge ? 6 : 8;
  });
  return elements;
}

}  // namespace pinball

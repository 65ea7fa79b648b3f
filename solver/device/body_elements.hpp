#pragma once

#include <solver/model/elements/element_parts.hpp>
#include <solver/model/model.hpp>

#include "body_sums.hpp"

namespace pinball {

/// place_of(slot): where the element of a slot lies in the arrays that are summed up.
template <class S, class PlaceOf>
BodyElements body_elements(const Model<S>& model, const PlaceOf& place_of) {
  std::vector<std::vector<std::int64_t>> slots(model.mesh.body_names.size());
  for (std::int64_t slot = 0; slot < model.elements.slots; ++slot) {
    if (!model.is_padding(slot)) slots[model.mesh.body[model.element_of_slot[slot]]].push_back(slot);
  }
  BodyElements elements;
  elements.bodies = slots.size();
  for (std::size_t body = 0; body < slots.size(); ++body) {
    for (std::size_t i = 0; i < slots[body].size(); ++i) {
      if (i % BodyElements::most_of_piece == 0) {
        elements.first.push_back(static_cast<std::int32_t>(elements.place.size()));
        elements.body.push_back(static_cast<std::int32_t>(body));
      }
      elements.place.push_back(static_cast<std::int32_t>(place_of(slots[body][i])));
      const std::int32_t element = model.element_of_slot[slots[body][i]];
      elements.mass.push_back(model.element_mass[element]);
      const WorkedShape shape = worked_shape(model.scene, model.mesh, element);
      elements.nodes.push_back(shape == WorkedShape::wedge ? 6 : 8);
    }
  }
  elements.first.push_back(static_cast<std::int32_t>(elements.place.size()));
  return elements;
}

}  // namespace pinball

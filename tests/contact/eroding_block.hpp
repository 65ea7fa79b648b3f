#pragma once

#include <cstddef>
#include <initializer_list>
#include <vector>

#include <solver/contact/segments/segment_surface.hpp>
#include <solver/elements/internal_forces.hpp>
#include <solver/model/model_surface.hpp>
#include <tests/support/solver_case.hpp>

/// A block of 27 elements whose surface is followed piece by piece while they erode.
namespace pinball::test {

/// A block whose elements erode at a plastic strain of 1.
inline Model<double> eroding_block() {
  Scene scene = scene_of({block("a", {3, 3, 3}, 0.1, {0, 0, 0})}, 1);
  scene.materials = {plastic_material("steel", 1e9, 1.0)};
  return build_model<double>(scene);
}

/// In the middle of the upper face of the block, the one behind it, with which it shares a face, and one at a corner.
inline constexpr std::size_t upper_element = 22, centre_element = 13, corner_element = 26;

/// So that faces behind these elements wait, where they are on the surface.
inline void strain_nearly_to_erosion(Model<double>& model, std::initializer_list<std::size_t> elements) {
  for (const std::size_t e : elements) {
    model.elements.plastic_strain[static_cast<std::size_t>(model.slot_of_element[e])] = 0.8;
  }
}

/// Takes an element out of the model; returns the slots of all that have eroded.
inline std::vector<std::int64_t> erode(Model<double>& model, std::size_t element) {
  model.elements.mass[static_cast<std::size_t>(model.slot_of_element[element])] = 0;
  std::vector<TileResult<double>> tiles(static_cast<std::size_t>(model.tile_count()));
  for (TileResult<double>& tile : tiles) tile.eroded_count = 1;
  return eroded_slots(model, tiles);
}
inline bool erode(Model<double>& model, SegmentSurface<double>& surface, std::size_t element) {
  return surface.remove_eroded(erode(model, element));
}

}  // namespace pinball::test

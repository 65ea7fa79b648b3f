#include <algorithm>
#include <cmath>
#include <pinball/solver/surface_elements.hpp>

namespace pinball {

namespace {

template <class S>
std::size_t part_of(const Model<S>& model, std::int64_t slot) {
  const auto tile = std::upper_bound(model.tile_packs.begin(), model.tile_packs.end(), slot / ElementStore<S>::width);
  return static_cast<std::size_t>(model.tile_part[static_cast<std::size_t>(tile - model.tile_packs.begin() - 1)]);
}

}  // namespace

template <class S>
const Material& material_of(const Model<S>& model, std::int64_t slot) {
  return model.scene.materials[part_of(model, slot)];
}

template <class S>
double volume_radius(const Model<S>& model, std::int64_t slot) {
  const auto e = static_cast<std::size_t>(model.element_of_slot[static_cast<std::size_t>(slot)]);
  const double volume = model.element_mass[e] / material_of(model, slot).density;
  return std::cbrt(volume * 3.0 / (4.0 * M_PI));
}

template <class S>
bool may_soon_erode(const Model<S>& model, const Surface& surface, std::int64_t slot) {
  if (surface.exposed(slot) == 0) return false;
  const std::size_t part = part_of(model, slot);
  if (!model.parts[part].features.erosion) return false;
  const S limit = std::min(S(1), model.constants[part].material.erosion_strain);
  return model.elements.plastic_strain[static_cast<std::size_t>(slot)] > S(0.1) * limit;
}

template const Material& material_of(const Model<double>&, std::int64_t);
template const Material& material_of(const Model<float>&, std::int64_t);
template double volume_radius(const Model<double>&, std::int64_t);
template double volume_radius(const Model<float>&, std::int64_t);
template bool may_soon_erode(const Model<double>&, const Surface&, std::int64_t);
template bool may_soon_erode(const Model<float>&, const Surface&, std::int64_t);

}  // namespace pinball

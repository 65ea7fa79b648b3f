#include <algorithm>
#include <pinball/solver/surface_elements.hpp>
#include <pinball/solver/surface_pinballs.hpp>

namespace pinball {

template <class S>
void SurfacePinballs<S>::update(const Model<S>& model, const Surface& surface,
                                const std::vector<std::int32_t>& uncovered) {
  chosen.resize(static_cast<std::size_t>(surface.slots()), 0);
  std::vector<std::int32_t> added;
  const auto choose = [&](std::int32_t s) {
    std::uint8_t& mark = chosen[static_cast<std::size_t>(s)];
    if (mark == 0) added.push_back(s);
    mark = 1;
  };
  const auto choose_behind = [&](std::int32_t s) {
    if (!may_soon_erode(model, surface, s)) return;
    surface.for_each_face_behind(s, [&](std::int32_t behind, unsigned /*face*/) { choose(behind); });
  };
  for (const std::int32_t s : uncovered) {
    if (surface.exposed(s) != 0) choose(s);
  }
  const std::size_t exposed = added.size();
  for (std::size_t i = 0; i < exposed; ++i) choose_behind(added[i]);
  for (const std::int32_t s : slot) choose_behind(s);
  std::sort(added.begin(), added.end());

  SurfacePinballs<S> merged;
  merged.reserve(slot.size() + added.size());
  auto next = added.begin();
  for (std::size_t i = 0; i < slot.size(); ++i) {
    for (; next != added.end() && *next < slot[i]; ++next) merged.append(model, *next);
    if (surface.alive(slot[i])) {
      merged.append(*this, i);
    } else {
      chosen[static_cast<std::size_t>(slot[i])] = 0;
    }
  }
  for (; next != added.end(); ++next) merged.append(model, *next);
  merged.chosen.swap(chosen);
  *this = std::move(merged);
}

template <class S>
void SurfacePinballs<S>::reserve(std::size_t n) {
  for (auto* v : {&slot, &body}) v->reserve(n);
  corners.reserve(n);
  reference.reserve(n);
  for (auto* v : {&radius, &mass, &bulk_modulus}) v->reserve(n);
}

template <class S>
void SurfacePinballs<S>::append(const SurfacePinballs& others, std::size_t i) {
  ++count;
  slot.push_back(others.slot[i]);
  body.push_back(others.body[i]);
  corners.push_back(others.corners[i]);
  reference.push_back(others.reference[i]);
  radius.push_back(others.radius[i]);
  mass.push_back(others.mass[i]);
  bulk_modulus.push_back(others.bulk_modulus[i]);
}

template <class S>
void SurfacePinballs<S>::append(const Model<S>& model, std::int64_t s) {
  const auto e = static_cast<std::size_t>(model.element_of_slot[static_cast<std::size_t>(s)]);
  ++count;
  slot.push_back(static_cast<std::int32_t>(s));
  body.push_back(model.mesh.body[e]);
  std::array<std::int32_t, 8> nodes{};
  for (int i = 0; i < 8; ++i) {
    nodes[static_cast<std::size_t>(i)] = model.elements.corner[ElementStore<S>::at(s, i, 8)];
  }
  corners.push_back(nodes);
  radius.push_back(static_cast<S>(model.scene.contact.radius_factor * volume_radius(model, s)));
  mass.push_back(static_cast<S>(model.element_mass[e]));
  bulk_modulus.push_back(static_cast<S>(material_of(model, s).bulk_modulus));
  const Point c = element_centre(model.mesh, e);
  reference.push_back({static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]),
                       static_cast<float>(radius.back())});
}

template <class S>
std::size_t SurfacePinballs<S>::bytes() const {
  return slot.capacity() * (2 * sizeof(slot[0]) + sizeof(corners[0]) + sizeof(reference[0]) + 3 * sizeof(S)) +
         chosen.capacity();
}

template struct SurfacePinballs<double>;
template struct SurfacePinballs<float>;

}  // namespace pinball

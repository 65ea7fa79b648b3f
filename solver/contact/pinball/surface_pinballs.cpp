#include "surface_pinballs.hpp"

#include <algorithm>
#include <utility>

namespace pinball {

template <class S>
void SurfacePinballs<S>::update(const SurfaceSource<S>& source, double radius_factor, const Surface& surface,
                                const std::vector<std::int32_t>& uncovered, SurfacePinballs& before) {
  chosen.resize(surface.slots(), 0);
  std::vector<std::int32_t> added;
  const auto choose = [&](std::int32_t s) {
    std::uint8_t& mark = chosen[s];
    if (mark == 0) added.push_back(s);
    mark = 1;
  };
  const auto choose_behind = [&](std::int32_t s) {
    if (!(surface.exposed(s) != 0 && source.may_soon_erode(s))) return;
    surface.for_each_face_behind(s, [&](std::int32_t behind, unsigned /*face*/) { choose(behind); });
  };
  for (const std::int32_t s : uncovered) {
    if (surface.exposed(s) != 0) choose(s);
  }
  const std::size_t exposed = added.size();
  for (std::size_t i = 0; i < exposed; ++i) choose_behind(added[i]);
  for (const std::int32_t s : slot) choose_behind(s);
  std::sort(added.begin(), added.end());

  std::swap(*this, before);
  clear();
  chosen.swap(before.chosen);
  auto next = added.begin();
  const std::size_t count_before = before.slot.size();
  for (std::size_t i = 0; i < count_before;) {
    for (; next != added.end() && *next < before.slot[i]; ++next) append(source, radius_factor, *next);
    std::size_t end = i;  // of those that stay together
    while (end < count_before && surface.alive(before.slot[end]) &&
           !(next != added.end() && *next < before.slot[end])) {
      ++end;
    }
    append(before, i, end);
    if (end < count_before && !surface.alive(before.slot[end])) {
      chosen[before.slot[end]] = 0;
      ++end;
    }
    i = end;
  }
  for (; next != added.end(); ++next) append(source, radius_factor, *next);
}

template <class S>
void SurfacePinballs<S>::clear() {
  count = 0;
  slot.clear();
  body.clear();
  corners.clear();
  reference.clear();
  for (auto* v : {&radius, &mass, &bulk_modulus}) v->clear();
}

template <class S>
void SurfacePinballs<S>::append(const SurfacePinballs& others, std::size_t begin, std::size_t end) {
  const auto add = [begin, end](auto& to, const auto& from) {
    to.insert(to.end(), from.begin() + begin, from.begin() + end);
  };
  count += end - begin;
  add(slot, others.slot);
  add(body, others.body);
  add(corners, others.corners);
  add(reference, others.reference);
  add(radius, others.radius);
  add(mass, others.mass);
  add(bulk_modulus, others.bulk_modulus);
}

template <class S>
void SurfacePinballs<S>::append(const SurfaceSource<S>& source, double radius_factor, std::int64_t s) {
  const ContactElement element = source.element(s);
  ++count;
  slot.push_back(s);
  body.push_back(element.body);
  corners.push_back(element.corners);
  radius.push_back(static_cast<S>((element.sphere ? 1.0 : radius_factor) * element.radius));
  mass.push_back(static_cast<S>(element.mass));
  bulk_modulus.push_back(static_cast<S>(element.bulk_modulus));
  const Point c = element.centre();
  reference.push_back({static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]),
                       static_cast<float>(radius.back())});
}

template <class S>
void SurfacePinballs<S>::persist(StateArchive& archive, const SurfaceSource<S>& source, double radius_factor) {
  std::vector<std::int32_t> slots = slot;
  archive(slots);
  if (!archive.reads()) return;
  clear();
  chosen.assign(source.slots, 0);
  for (const std::int32_t s : slots) {
    archive.require(source.is_element(s) && (slot.empty() || slot.back() < s));
    chosen[s] = 1;
    append(source, radius_factor, s);
  }
}

template <class S>
std::size_t SurfacePinballs<S>::bytes() const {
  return slot.capacity() * (2 * sizeof(slot[0]) + sizeof(corners[0]) + sizeof(reference[0]) + 3 * sizeof(S)) +
         chosen.capacity();
}

template struct SurfacePinballs<double>;
template struct SurfacePinballs<float>;

}  // namespace pinball

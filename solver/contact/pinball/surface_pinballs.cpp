#include "surface_pinballs.hpp"

#include <algorithm>
#include <utility>

#include <solver/base/lists_in_order.hpp>

namespace pinball {

template <class S>
void SurfacePinballs<S>::update(const SurfaceSource<S>& source, double radius_factor, const Surface& surface,
                                const std::vector<std::int32_t>& uncovered, SurfacePinballs& before) {
  chosen.resize(surface.slots(), 0);
  const auto choose_behind = [&](std::int32_t s) {
    if (surface.exposed(s) == 0 || !source.may_soon_erode(s)) return;
    surface.for_each_face_behind(s, [&](std::int32_t behind, unsigned /*face*/) { set_mark(chosen[behind]); });
  };
  parallel_for("uncovered pinballs", RangePolicy<>{0, std::ssize(uncovered)}, [&](std::int64_t i) {
    if (surface.exposed(uncovered[i]) == 0) return;
    set_mark(chosen[uncovered[i]]);
    choose_behind(uncovered[i]);
  });
  parallel_for("pinballs behind", RangePolicy<>{0, count}, [&](std::int64_t p) {
    if (!surface.alive(slot[p])) chosen[slot[p]] = 0;
    choose_behind(slot[p]);
  });

  std::swap(*this, before);
  chosen.swap(before.chosen);
  list_where("pinballs", std::ssize(chosen), slot, [this](std::int64_t s) { return chosen[s] != 0; });
  make_room();
  parallel_for("numbers of pinballs", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    const std::int64_t begin = count * piece / fixed_pieces, end = count * (piece + 1) / fixed_pieces;
    if (begin == end) return;
    auto same = std::lower_bound(before.slot.begin(), before.slot.end(), slot[begin]);
    for (std::int64_t p = begin; p < end; ++p) {
      while (same != before.slot.end() && *same < slot[p]) ++same;
      if (same != before.slot.end() && *same == slot[p]) {
        put(p, before, same - before.slot.begin());
      } else {
        put(p, source.element(slot[p]), radius_factor);
      }
    }
  });
}

/// For all of `slot`.
template <class S>
void SurfacePinballs<S>::make_room() {
  count = static_cast<std::int32_t>(slot.size());
  body.resize(count);
  corners.resize(count);
  reference.resize(count);
  for (auto* v : {&radius, &mass, &bulk_modulus}) v->resize(count);
}

template <class S>
void SurfacePinballs<S>::put(std::size_t p, const SurfacePinballs& others, std::size_t q) {
  body[p] = others.body[q];
  corners[p] = others.corners[q];
  reference[p] = others.reference[q];
  radius[p] = others.radius[q];
  mass[p] = others.mass[q];
  bulk_modulus[p] = others.bulk_modulus[q];
}

template <class S>
void SurfacePinballs<S>::put(std::size_t p, const ContactElement& element, double radius_factor) {
  body[p] = element.body;
  corners[p] = element.corners;
  radius[p] = static_cast<S>((element.sphere ? 1.0 : radius_factor) * element.radius);
  mass[p] = static_cast<S>(element.mass);
  bulk_modulus[p] = static_cast<S>(element.bulk_modulus);
  const Point c = element.centre();
  reference[p] = {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]),
                  static_cast<float>(radius[p])};
}

template <class S>
void SurfacePinballs<S>::persist(StateArchive& archive, const SurfaceSource<S>& source, double radius_factor) {
  archive(slot);
  if (!archive.reads()) return;
  make_room();
  chosen.assign(source.slots, 0);
  for (std::size_t p = 0; p < slot.size(); ++p) {
    archive.require(source.is_element(slot[p]) && (p == 0 || slot[p - 1] < slot[p]));
    chosen[slot[p]] = 1;
    put(p, source.element(slot[p]), radius_factor);
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

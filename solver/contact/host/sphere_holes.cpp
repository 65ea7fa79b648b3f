#include "sphere_holes.hpp"

#include <algorithm>
#include <cmath>

#include <kernels/hexahedron.hpp>

#include "host_error.hpp"

namespace pinball {

namespace {

/// The widest hole at a node of an exposed face, in which a sphere of this radius is not stopped [length].
double widest_hole(const ContactElement& element, unsigned exposed, double radius_factor) {
  const Point centre = element.centre();
  double widest = 0;
  for (unsigned f = 0; f < 6; ++f) {
    if ((exposed >> f & 1U) == 0) continue;
    const auto corner = [&](int i) -> const Point& { return element.reference[face_nodes[f][i]]; };
    const Point normal = cross(minus(corner(2), corner(0)), minus(corner(3), corner(1)));
    const double size = norm(normal);
    if (!(size > 0)) continue;
    for (int i = 0; i < 4; ++i) {
      const Point to = minus(corner(i), centre);
      const double along = dot(to, normal) / size;
      widest = std::max(widest, std::sqrt(std::max(0.0, dot(to, to) - along * along)) - radius_factor * element.radius);
    }
  }
  return widest;
}

}  // namespace

template <class S>
std::string sphere_holes(const ContactSettings& settings, const SurfaceSource<S>& source, const Surface& surface) {
  if (settings.method != ContactMethod::pinball || settings.gap == ContactGap::face) return "";
  double smallest = INFINITY, widest = 0;
  std::int64_t spheres = 0;
  for (const bool count : {false, true}) {
    for (std::int64_t slot = 0; slot < surface.slots(); ++slot) {
      if (!surface.alive(slot) || surface.exposed(slot) == 0) continue;
      const ContactElement element = source.element(slot);
      if (count) {
        spheres += element.sphere && element.radius <= widest ? 1 : 0;
      } else if (element.sphere) {
        smallest = std::min(smallest, element.radius);
      } else {
        widest = std::max(widest, widest_hole(element, surface.exposed(slot), settings.radius_factor));
      }
    }
  }
  if (spheres == 0) return "";
  return message_of("mesh->sphere_radius: ", spheres, " spheres, the smallest of radius ", smallest,
                    ", may fall between the balls of elements, at nodes of faces where holes are up to ", widest,
                    ": try options->gap = PINBALL_CONTACT_GAP_FACE, or a larger options->radius_factor");
}

template std::string sphere_holes(const ContactSettings&, const SurfaceSource<double>&, const Surface&);
template std::string sphere_holes(const ContactSettings&, const SurfaceSource<float>&, const Surface&);

}  // namespace pinball

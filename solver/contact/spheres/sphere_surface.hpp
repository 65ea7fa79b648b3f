#pragma once

#include <cstdint>
#include <vector>

#include <solver/contact/surface/surface.hpp>
#include <solver/contact/surface/surface_source.hpp>

namespace pinball {

/// The rigid spheres of a surface.
template <class S>
class SphereSurface {
 public:
  struct Sphere {
    std::int32_t node, slot, body;
    S radius;  ///< [length]
  };

  SphereSurface(const SurfaceSource<S>& source, const Surface& topology) {
    for (std::int64_t slot = 0; slot < topology.slots(); ++slot) {
      if (!topology.alive(slot)) continue;
      const ContactElement element = source.element(slot);
      if (!element.sphere) continue;
      spheres_.push_back(
          {element.corners[0], static_cast<std::int32_t>(slot), element.body, static_cast<S>(element.radius)});
    }
  }
  const std::vector<Sphere>& spheres() const { return spheres_; }
  std::int32_t count() const { return spheres_.size(); }
  std::size_t bytes() const { return spheres_.capacity() * sizeof(Sphere); }

 private:
  std::vector<Sphere> spheres_;
};

}  // namespace pinball

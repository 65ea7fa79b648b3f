#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/contact/surface/surface.hpp>
#include <solver/contact/surface/surface_source.hpp>

namespace pinball {

/// The pinballs of all elements that contact may concern, in the order of their slots: what does not change from step
/// to step. Elements of the surface, and those behind elements that may soon erode: with these, lists last over
/// erosions.
template <class S>
struct SurfacePinballs {
  std::int32_t count = 0;
  std::vector<std::int32_t> slot;                    ///< of the element
  std::vector<std::int32_t> body;                    ///< of the element
  std::vector<std::array<std::int32_t, 8>> corners;  ///< node numbers
  std::vector<std::array<float, 4>> reference;       ///< centre and radius in the undeformed mesh [length]
  std::vector<S> radius;                             ///< of the undeformed element [length]
  std::vector<S> mass;                               ///< of the element [mass]
  std::vector<S> bulk_modulus;                       ///< [stress]
  std::vector<std::uint8_t> chosen;                  ///< per slot of the element store: is among these

  /// Drops eroded elements; takes in uncovered ones (slots) and those behind elements that may soon erode.
  /// radius_factor: on the radii of the elements, but not of spheres [-]; before: memory for what they are until then.
  void update(const SurfaceSource<S>& source, double radius_factor, const Surface& surface,
              const std::vector<std::int32_t>& uncovered, SurfacePinballs& before);
  /// Whether all corners are one node.
  bool is_sphere(std::size_t p) const {
    return std::all_of(corners[p].begin(), corners[p].end(), [&](std::int32_t n) { return n == corners[p][0]; });
  }
  void persist(StateArchive& archive, const SurfaceSource<S>& source, double radius_factor);
  std::size_t bytes() const;

 private:
  void make_room();
  /// Sets one to one of others, or to that of an element.
  void put(std::size_t p, const SurfacePinballs& others, std::size_t q);
  void put(std::size_t p, const ContactElement& element, double radius_factor);
};

}  // namespace pinball

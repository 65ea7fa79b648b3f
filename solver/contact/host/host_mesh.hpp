#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <solver/contact/contact.h>
#include <solver/contact/surface/surface_source.hpp>

#include "host_error.hpp"

namespace pinball {

/// Whether a number of a host can be computed with: finite, and its square, too.
template <class S>
bool is_sound(S number) {
  return std::isfinite(number * number);
}
template <class S>
bool is_sound(const std::array<S, 3>& vector) {
  return is_sound(vector[0]) && is_sound(vector[1]) && is_sound(vector[2]);
}

/// Throws HostError for a stride that leads out of what memory can have.
template <class S>
void require_stride(std::int64_t stride, std::int64_t nodes, const char* name) {
  const std::int64_t most = std::numeric_limits<std::ptrdiff_t>::max() / std::ptrdiff_t{sizeof(S)} / nodes;
  if (stride >= 1 && stride <= most) return;
  throw HostError(PINBALL_CONTACT_BAD_COUNT, name, "stride: expected 1 ... ", most, ", got ", stride);
}

/// One vector per node in the arrays of a host.
template <class S>
struct HostVectors {
  const S *x, *y, *z;
  std::int64_t stride;

  explicit HostVectors(const pinball_contact_input& in)
      : x(static_cast<const S*>(in.x)),
        y(static_cast<const S*>(in.y)),
        z(static_cast<const S*>(in.z)),
        stride(in.stride) {}
  std::array<S, 3> operator[](std::int64_t node) const {
    return {x[node * stride], y[node * stride], z[node * stride]};
  }
  /// Whether the components of a node lie beside each other; then the number behind those of any node but the last can
  /// be read.
  bool are_together() const { return stride >= 3 && y == x + 1 && z == x + 2; }
  /// Whether they lie as node records do (gather.hpp).
  bool are_records() const {
    return stride == 4 && are_together() && reinterpret_cast<std::uintptr_t>(x) % (4 * sizeof(S)) == 0;
  }
};

/// A pinball_contact_mesh with its arrays as what they are. Elements are numbered on by the spheres.
template <class S>
class HostMesh {
 public:
  /// Throws HostError for what is wrong in the mesh or in the positions of its nodes.
  HostMesh(const pinball_contact_options& options, const pinball_contact_mesh* mesh,
           const pinball_contact_input* position);

  std::int32_t nodes() const { return mesh_.node_count; }
  std::int32_t elements() const { return mesh_.element_count; }
  std::int32_t spheres() const { return mesh_.sphere_count; }
  std::int32_t all() const { return elements() + spheres(); }
  std::array<std::int32_t, 8> corners(std::int32_t element) const;
  std::int32_t body(std::int32_t element) const;
  double bulk_modulus(std::int32_t element) const;
  double sphere_radius(std::int32_t sphere) const { return number(mesh_.sphere_radius, sphere); }
  /// Mass of a node that is in use [mass].
  double mass(std::int32_t node) const { return number(mesh_.mass, node); }
  const void* element_masses() const { return mesh_.element_mass; }
  const void* element_volumes() const { return mesh_.element_volume; }
  double number(const void* numbers, std::int64_t i) const { return static_cast<const S*>(numbers)[i]; }
  const std::uint8_t* hidden_faces() const { return mesh_.hidden_faces; }
  std::vector<HeldDirection> held() const;
  /// First element of each tile, spheres with them, and at last their number.
  std::vector<std::int32_t> tiles() const;
  /// Forgets what is read at creation alone.
  void forget_arguments();

 private:
  std::int32_t node_at(const void* numbers, std::int64_t i) const;
  void check_nodes_of(const void* numbers, std::int64_t count, const char* name) const;
  void check_numbers(const void* numbers, std::int64_t count, const char* name) const;
  void check_bodies(const std::int32_t* bodies, std::int64_t count, const char* name) const;
  void check_counts() const;
  void check_elements() const;
  void check_spheres();
  void check_held() const;
  void check_held_of_nodes() const;
  void check_tiles() const;
  void check_nodes(const HostVectors<S>& position) const;

  pinball_contact_mesh mesh_;
  bool long_index_;
  std::int64_t first_index_;
  std::int32_t bodies_ = 0;  ///< those of elements are numbered below this
};

}  // namespace pinball

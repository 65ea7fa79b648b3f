#include "host_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <solver/base/tile_size.hpp>

#include "host_error.hpp"

namespace pinball {

namespace {

/// Bodies are compared as single-precision numbers (reference_balls.hpp).
constexpr std::int64_t most_bodies = 1 << 24;

void require_count(std::int64_t count, std::int64_t least, const char* name) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max() - 1;
  if (count < least || count > most) {
    throw HostError(PINBALL_CONTACT_BAD_COUNT, name, ": expected ", least, " ... ", most, ", got ", count);
  }
}

}  // namespace

template <class S>
HostMesh<S>::HostMesh(const pinball_contact_options& options, const pinball_contact_mesh* mesh,
                      const pinball_contact_input* position)
    : mesh_(), long_index_(options.index == PINBALL_CONTACT_INT64), first_index_(options.first_index) {
  require_version(mesh, "mesh");
  mesh_ = *mesh;
  check_counts();
  check_elements();
  check_spheres();
  if (mesh_.sphere_count > 0 && options.method == PINBALL_CONTACT_SLIDELINE) {
    throw HostError(PINBALL_CONTACT_BAD_OPTION, "options->method: the slideline has no spheres");
  }
  if (mesh_.sphere_count > 0 && options.radius == PINBALL_CONTACT_RADIUS_CURRENT) {
    throw HostError(PINBALL_CONTACT_BAD_OPTION, "options->radius: spheres keep their radii");
  }
  check_held();
  check_tiles();
  require_pointer(position, "position");
  check_nodes(HostVectors<S>(*position));
}

template <class S>
std::int32_t HostMesh<S>::node_at(const void* numbers, std::int64_t i) const {
  const std::int64_t number = long_index_ ? static_cast<const std::int64_t*>(numbers)[i]
                                          : std::int64_t{static_cast<const std::int32_t*>(numbers)[i]};
  return number - first_index_;
}

template <class S>
std::array<std::int32_t, 8> HostMesh<S>::corners(std::int32_t element) const {
  std::array<std::int32_t, 8> nodes{};
  if (element >= elements()) {
    nodes.fill(node_at(mesh_.sphere_node, element - elements()));
  } else {
    for (int i = 0; i < 8; ++i) nodes[i] = node_at(mesh_.corners, 8 * std::int64_t{element} + i);
  }
  return nodes;
}

template <class S>
std::int32_t HostMesh<S>::body(std::int32_t element) const {
  const std::int32_t sphere = element - elements();
  if (sphere >= 0) return mesh_.sphere_body != nullptr ? mesh_.sphere_body[sphere] : bodies_ + sphere;
  return mesh_.body != nullptr ? mesh_.body[element] : 0;
}

template <class S>
double HostMesh<S>::bulk_modulus(std::int32_t element) const {
  if (element >= elements()) return number(mesh_.sphere_bulk_modulus, element - elements());
  return number(mesh_.bulk_modulus, mesh_.part != nullptr ? mesh_.part[element] : element);
}

template <class S>
std::vector<HeldDirection> HostMesh<S>::held() const {
  std::vector<HeldDirection> held;
  for (std::int64_t i = 0; i < mesh_.held_count; ++i) {
    const auto component = [&](std::int64_t k) { return number(mesh_.held_direction, 3 * i + k); };
    held.push_back({node_at(mesh_.held_node, i), {component(0), component(1), component(2)}});
  }
  return held;
}

template <class S>
std::vector<std::int32_t> HostMesh<S>::tiles() const {
  std::vector<std::int32_t> first;
  const auto cut = [&first, this](std::int32_t begin, std::int32_t end) {
    const std::int64_t size = tile_size(all());
    for (std::int64_t e = begin; e < end; e += size) first.push_back(e);
  };
  if (mesh_.tile_offsets != nullptr) {
    for (std::int64_t t = 0; t < mesh_.tile_count; ++t) {
      first.push_back(mesh_.tile_offsets[t]);
    }
  } else {
    cut(0, elements());
  }
  cut(elements(), all());
  first.push_back(all());
  return first;
}

template <class S>
void HostMesh<S>::forget_arguments() {
  mesh_.mass = mesh_.held_node = mesh_.held_direction = nullptr;
  mesh_.hidden_faces = nullptr;
  mesh_.tile_offsets = nullptr;
}

template <class S>
void HostMesh<S>::check_nodes_of(const void* numbers, std::int64_t count, const char* name) const {
  if (count > 0) require_pointer(numbers, name);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t number = long_index_ ? static_cast<const std::int64_t*>(numbers)[i]
                                            : std::int64_t{static_cast<const std::int32_t*>(numbers)[i]};
    if (number < first_index_ || number - first_index_ >= mesh_.node_count) {
      throw HostError(PINBALL_CONTACT_BAD_INDEX, name, "[", i, "]: node ", number, " is not among ", first_index_,
                      " ... ", mesh_.node_count - 1 + first_index_);
    }
  }
}

template <class S>
void HostMesh<S>::check_numbers(const void* numbers, std::int64_t count, const char* name) const {
  if (count > 0) require_pointer(numbers, name);
  for (std::int64_t i = 0; i < count; ++i) {
    if (number(numbers, i) > 0 && std::isfinite(number(numbers, i))) continue;
    throw HostError(PINBALL_CONTACT_BAD_NUMBER, name, "[", i, "]: expected a number > 0, got ", number(numbers, i));
  }
}

template <class S>
void HostMesh<S>::check_bodies(const std::int32_t* bodies, std::int64_t count, const char* name) const {
  for (std::int64_t i = 0; bodies != nullptr && i < count; ++i) {
    if (bodies[i] >= 0 && bodies[i] < most_bodies) continue;
    throw HostError(PINBALL_CONTACT_BAD_INDEX, name, "[", i, "]: expected 0 ... ", most_bodies - 1, ", got ",
                    bodies[i]);
  }
}

template <class S>
void HostMesh<S>::check_counts() const {
  require_count(mesh_.node_count, 1, "mesh->node_count");
  require_count(mesh_.element_count, 0, "mesh->element_count");
  require_count(mesh_.sphere_count, 0, "mesh->sphere_count");
  require_count(mesh_.held_count, 0, "mesh->held_count");
  require_count(mesh_.element_count + mesh_.sphere_count, 1, "mesh->element_count + mesh->sphere_count");
}

template <class S>
void HostMesh<S>::check_elements() const {
  if (mesh_.element_count == 0) return;
  check_nodes_of(mesh_.corners, 8 * mesh_.element_count, "mesh->corners");
  check_bodies(mesh_.body, mesh_.element_count, "mesh->body");
  if (mesh_.part != nullptr) {
    require_count(mesh_.part_count, 1, "mesh->part_count");
    for (std::int64_t e = 0; e < mesh_.element_count; ++e) {
      if (mesh_.part[e] >= 0 && mesh_.part[e] < mesh_.part_count) continue;
      throw HostError(PINBALL_CONTACT_BAD_INDEX, "mesh->part[", e, "]: ", mesh_.part[e], " is not among 0 ... ",
                      mesh_.part_count - 1);
    }
  }
  check_numbers(mesh_.bulk_modulus, mesh_.part != nullptr ? mesh_.part_count : mesh_.element_count,
                "mesh->bulk_modulus");
  if (mesh_.element_mass != nullptr) check_numbers(mesh_.element_mass, mesh_.element_count, "mesh->element_mass");
  if (mesh_.element_volume != nullptr) check_numbers(mesh_.element_volume, mesh_.element_count, "mesh->element_volume");
}

template <class S>
void HostMesh<S>::check_spheres() {
  for (std::int32_t e = 0; e < elements(); ++e) bodies_ = std::max(bodies_, body(e) + 1);
  if (mesh_.sphere_body == nullptr && bodies_ + mesh_.sphere_count > most_bodies) {
    throw HostError(PINBALL_CONTACT_BAD_COUNT, "mesh->sphere_count: more than ", most_bodies, " bodies");
  }
  check_nodes_of(mesh_.sphere_node, mesh_.sphere_count, "mesh->sphere_node");
  check_numbers(mesh_.sphere_radius, mesh_.sphere_count, "mesh->sphere_radius");
  check_numbers(mesh_.sphere_bulk_modulus, mesh_.sphere_count, "mesh->sphere_bulk_modulus");
  check_bodies(mesh_.sphere_body, mesh_.sphere_count, "mesh->sphere_body");
}

template <class S>
void HostMesh<S>::check_held() const {
  check_nodes_of(mesh_.held_node, mesh_.held_count, "mesh->held_node");
  if (mesh_.held_count > 0) require_pointer(mesh_.held_direction, "mesh->held_direction");
  for (std::int64_t i = 0; i < mesh_.held_count; ++i) {
    double length2 = 0;
    for (std::int64_t k = 0; k < 3; ++k) {
      const double component = number(mesh_.held_direction, 3 * i + k);
      length2 += component * component;
    }
    if (std::abs(length2 - 1) < 1e-5) continue;
    throw HostError(PINBALL_CONTACT_BAD_NUMBER, "mesh->held_direction: entry ", i,
                    " is not of unit length: ", std::sqrt(length2));
  }
  check_held_of_nodes();
}

/// Two directions of a node that are not orthogonal would take away more than there is.
template <class S>
void HostMesh<S>::check_held_of_nodes() const {
  const std::vector<HeldDirection> held = this->held();
  std::vector<std::size_t> by_node(held.size());
  std::iota(by_node.begin(), by_node.end(), std::size_t(0));
  std::stable_sort(by_node.begin(), by_node.end(), [&](auto a, auto b) { return held[a].node < held[b].node; });
  for (std::size_t i = 0; i < by_node.size(); ++i) {
    for (std::size_t j = i; j-- > 0 && held[by_node[j]].node == held[by_node[i]].node;) {
      const Point &a = held[by_node[j]].normal, &b = held[by_node[i]].normal;
      if (std::abs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) < 1e-5) continue;
      throw HostError(PINBALL_CONTACT_BAD_NUMBER, "mesh->held_direction: entries ", by_node[j], " and ", by_node[i],
                      " are of one node and not orthogonal");
    }
  }
}

template <class S>
void HostMesh<S>::check_tiles() const {
  if (mesh_.tile_offsets == nullptr) return;
  require_count(mesh_.tile_count, 0, "mesh->tile_count");
  for (std::int64_t t = 0; t <= mesh_.tile_count; ++t) {
    const std::int64_t least = t == 0 ? 0 : mesh_.tile_offsets[t - 1];
    const std::int64_t most = t == 0 ? 0 : mesh_.element_count;
    const std::int64_t given = mesh_.tile_offsets[t];
    if (given >= (t == mesh_.tile_count ? mesh_.element_count : least) && given <= most) continue;
    throw HostError(PINBALL_CONTACT_BAD_INDEX, "mesh->tile_offsets[", t, "]: ", given,
                    " does not ascend from 0 to element_count");
  }
}

/// Masses and places of the nodes that are in use.
template <class S>
void HostMesh<S>::check_nodes(const HostVectors<S>& position) const {
  require_pointer(mesh_.mass, "mesh->mass");
  if (position.x == nullptr || position.y == nullptr || position.z == nullptr) require_pointer(nullptr, "position");
  require_stride<S>(position.stride, mesh_.node_count, "position->");
  for (std::int32_t e = 0; e < all(); ++e) {
    for (const std::int32_t node : corners(e)) {
      const S inverse = static_cast<S>(1.0 / mass(node));
      if (!(inverse > S(0)) || !std::isfinite(inverse) || !(mass(node) > 0)) {
        throw HostError(PINBALL_CONTACT_BAD_NUMBER, "mesh->mass[", node, "]: expected a number > 0, got ", mass(node));
      }
      const std::array<S, 3> x = position[node];
      if (is_sound(x)) continue;
      throw HostError(PINBALL_CONTACT_BAD_NUMBER, "position: node ", node, " is at ", x[0], ", ", x[1], ", ", x[2],
                      unsound);
    }
  }
}

template class HostMesh<double>;
template class HostMesh<float>;

}  // namespace pinball

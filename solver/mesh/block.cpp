#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include <solver/base/error.hpp>

#include "generators.hpp"

namespace pinball {

namespace {

void require_sections(const BlockMesh& settings, std::size_t axis) {
  if (settings.sections[axis].empty()) return;
  double length = 0.0;
  std::int64_t elements = 0;
  for (const BlockSection& section : settings.sections[axis]) {
    if (!std::isfinite(section.length) || section.length <= 0.0 || section.elements < 1) {
      throw InputError(fmt::format(
          "block mesh: sections[{}]: expected lengths > 0 and integers >= 1, got a length of {} and elements {}", axis,
          section.length, section.elements));
    }
    length += section.length;
    elements += section.elements;
  }
  constexpr double round_off = 1e-12;
  if (std::abs(length - settings.size[axis]) > round_off * length)
    throw InputError(fmt::format("block mesh: size[{}]: expected {}, the sum of its sections, got {}", axis, length,
                                 settings.size[axis]));
  if (elements != settings.elements[axis])
    throw InputError(fmt::format("block mesh: elements[{}]: expected {}, the sum of its sections, got {}", axis,
                                 elements, settings.elements[axis]));
}

/// Coordinates of the planes of nodes along one direction.
std::vector<double> node_planes(const BlockMesh& settings, std::size_t axis) {
  std::vector<BlockSection> sections = settings.sections[axis];
  if (sections.empty()) sections.push_back({settings.size[axis], settings.elements[axis]});
  std::vector<double> planes{0.0};
  double begin = 0.0;
  for (const BlockSection& section : sections) {
    for (int i = 1; i <= section.elements; ++i) {
      // The quotient first: it is exactly 1 at the far face.
      planes.push_back(begin + section.length * (static_cast<double>(i) / section.elements));
    }
    begin = planes.back();
  }
  return planes;
}

}  // namespace

Mesh generate_block(const BlockMesh& settings) {
  double node_count = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(settings.size[axis]) || settings.size[axis] <= 0.0)
      throw InputError(fmt::format("block mesh: size[{}]: expected a length > 0, got {}", axis, settings.size[axis]));
    if (settings.elements[axis] < 1)
      throw InputError(
          fmt::format("block mesh: elements[{}]: expected an integer >= 1, got {}", axis, settings.elements[axis]));
    require_sections(settings, axis);
    node_count *= settings.elements[axis] + 1.0;
  }
  if (node_count > std::numeric_limits<std::int32_t>::max())
    throw InputError("block mesh: elements: more than 2^31 - 1 nodes");

  const auto [nx, ny, nz] = settings.elements;
  Mesh mesh;
  mesh.nodes.reserve(static_cast<std::size_t>(node_count));
  mesh.hexahedra.reserve(static_cast<std::size_t>(nx) * ny * nz);
  const std::vector<double> xs = node_planes(settings, 0), ys = node_planes(settings, 1), zs = node_planes(settings, 2);
  for (const double z : zs)
    for (const double y : ys)
      for (const double x : xs) mesh.nodes.push_back({x, y, z});

  const std::int32_t row = nx + 1, slab = row * (ny + 1);
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const std::int32_t n = i + row * j + slab * k;
        mesh.hexahedra.push_back(
            {n, n + 1, n + 1 + row, n + row, n + slab, n + 1 + slab, n + 1 + row + slab, n + row + slab});
      }
  return mesh;
}

}  // namespace pinball

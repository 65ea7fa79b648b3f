#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <pinball/solver/error.hpp>
#include <pinball/solver/mesh_generators.hpp>

namespace pinball {

Mesh generate_block(const BlockMesh& settings) {
  double node_count = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(settings.size[axis]) || settings.size[axis] <= 0.0)
      throw InputError(fmt::format("block mesh: size[{}]: expected a length > 0, got {}", axis, settings.size[axis]));
    if (settings.elements[axis] < 1)
      throw InputError(
          fmt::format("block mesh: elements[{}]: expected an integer >= 1, got {}", axis, settings.elements[axis]));
    node_count *= settings.elements[axis] + 1.0;
  }
  if (node_count > std::numeric_limits<std::int32_t>::max())
    throw InputError("block mesh: elements: more than 2^31 - 1 nodes");

  const auto [nx, ny, nz] = settings.elements;
  Mesh mesh;
  mesh.nodes.reserve(static_cast<std::size_t>(node_count));
  mesh.hexahedra.reserve(static_cast<std::size_t>(nx) * ny * nz);
  // The quotient first: it is exactly 1 at the far face.
  const auto coordinate = [&](int axis, int i) {
    return settings.size[axis] * (static_cast<double>(i) / settings.elements[axis]);
  };
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) mesh.nodes.push_back({coordinate(0, i), coordinate(1, j), coordinate(2, k)});

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

#include "array_mesh.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include <solver/base/error.hpp>

namespace pinball {

namespace {

constexpr std::int64_t most_records = 500'000'000;  // numbered with 32 bits, four numbers each

void check_shape(const ConstArrayView& array, const char* name, std::int64_t components, bool integers) {
  const bool is_integer = array.type == NumberType::int32 || array.type == NumberType::int64;
  const auto fail = [name](const std::string& problem) { throw InputError(fmt::format("mesh.{}: {}", name, problem)); };
  if (array.data == nullptr) fail("expected an array, got a null pointer");
  if (is_integer != integers) {
    fail(integers ? "expected integers, got floating-point numbers" : "expected floating-point numbers, got integers");
  }
  if (array.components != components) {
    fail(fmt::format("expected records of {} numbers, got {}", components, array.components));
  }
  if (array.count < 1 || array.count > most_records) {
    fail(fmt::format("expected 1 to {} records, got {}", most_records, array.count));
  }
}

std::int64_t index_at(const ConstArrayView& array, std::int64_t record, std::int64_t component) {
  return array.type == NumberType::int32 ? *array.at<std::int32_t>(record, component)
                                         : *array.at<std::int64_t>(record, component);
}

}  // namespace

Mesh copy_mesh(const ArrayMesh& arrays) {
  check_shape(arrays.coordinates, "coordinates", 3, false);
  check_shape(arrays.hexahedra, "hexahedra", 8, true);
  const std::int64_t nodes = arrays.coordinates.count, elements = arrays.hexahedra.count;
  Mesh mesh;
  mesh.nodes.resize(nodes);
  for (std::int64_t n = 0; n < nodes; ++n) {
    for (std::int64_t k = 0; k < 3; ++k) {
      const double x = arrays.coordinates.number(n, k);
      if (!std::isfinite(x)) {
        throw InputError(fmt::format("mesh.coordinates[{}][{}]: expected a finite number, got {}", n, k, x));
      }
      mesh.nodes[n][k] = x;
    }
  }
  std::vector<bool> used(mesh.nodes.size(), false);
  mesh.hexahedra.resize(elements);
  for (std::int64_t e = 0; e < elements; ++e) {
    for (std::int64_t i = 0; i < 8; ++i) {
      const std::int64_t index = index_at(arrays.hexahedra, e, i);
      // Compared before the subtraction, which could overflow.
      if (index < arrays.first_index || index - arrays.first_index >= nodes) {
        throw InputError(fmt::format("mesh.hexahedra[{}][{}]: expected a node from {} to {}, got {}", e, i,
                                     arrays.first_index, arrays.first_index + nodes - 1, index));
      }
      const std::int64_t node = index - arrays.first_index;
      used[node] = true;
      mesh.hexahedra[e][i] = node;
    }
  }
  for (std::size_t n = 0; n < used.size(); ++n) {
    if (!used[n]) {
      throw InputError(
          fmt::format("mesh.coordinates[{}]: expected nodes of elements only, no element has this one", n));
    }
  }
  return mesh;
}

}  // namespace pinball

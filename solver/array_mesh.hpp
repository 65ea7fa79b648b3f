#pragma once

#include <cstdint>
#include <memory>

#include "array_view.hpp"
#include "mesh.hpp"

namespace pinball {

/// The mesh of a body in the memory of a host. It is read, and copied once, while the model is built: elements are
/// sorted then. Until that is done the arrays have to stay; afterwards nothing refers to them.
struct ArrayMesh {
  ConstArrayView coordinates{};  ///< records of three floats or doubles, one per node [length]
  /// Records of eight 32- or 64-bit integers, one per element: places in `coordinates`, in the order of corners that
  /// mesh.hpp shows.
  ConstArrayView hexahedra{};
  std::int64_t first_index = 0;         ///< what `hexahedra` calls the first node: 1 in Fortran
  std::shared_ptr<const void> owner{};  ///< keeps the arrays while they may be read; none: the host sees to that
};

/// The copy. Throws InputError that names the array and the place in it: a null pointer, a wrong type or number of
/// components, no records, a coordinate that is not finite, an index out of range, a node of no element.
Mesh copy_mesh(const ArrayMesh& arrays);

}  // namespace pinball

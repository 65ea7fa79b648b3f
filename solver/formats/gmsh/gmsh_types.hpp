#pragma once

#include <cstdint>
#include <string>

namespace pinball {

/// Types of elements, as Gmsh numbers them.
namespace gmsh {

inline constexpr std::int64_t line = 1, triangle = 2, quadrangle = 3, line_3 = 8, triangle_6 = 9, point = 15;

/// Nodes of an element; 0: not a type that is known.
int nodes_of(std::int64_t type);
/// 0: a point, 3: a volume, which also stands for what is not known.
int dimension_of(std::int64_t type);
/// "20-node hexahedra"
std::string name_of(std::int64_t type);

}  // namespace gmsh
}  // namespace pinball

#pragma once

#include <string>
#include <vector>

#include "abaqus_mesh.hpp"
#include "abaqus_sets.hpp"

/// Rigid elements, R3D4 and R3D3, and elements of one node, MASS and ROTARYI, of Abaqus input.
namespace pinball {

/// How many nodes a rigid element of a type has; 0: it is none.
int nodes_of_rigid_element(const std::string& type);
/// MASS, ROTARYI.
bool is_point_element(const std::string& type);

/// Sides of a rigid element as faces: SPOS, seen from where its nodes go round counterclockwise, and SNEG. hexahedron:
/// flat, the same corners below and above.
std::array<std::int32_t, 4> positive_side(const std::array<std::int32_t, 8>& hexahedron);
std::array<std::int32_t, 4> negative_side(const std::array<std::int32_t, 8>& hexahedron);

/// Makes a layer of each flat hexahedron, as thick as the data line of its *RIGID BODY says, half of it on each side.
/// Where that says nothing a layer does not change what is met: where surfaces have one side of the elements alone, it
/// lies behind it, a fourth of the mean edge thick; else it is a twentieth thick. references: nodes that stay in their
/// sets. Throws InputError for a thickness below 0.
void thicken_rigid_elements(AbaqusMesh& mesh, MeshFile& file, std::vector<std::int32_t> references);

}  // namespace pinball

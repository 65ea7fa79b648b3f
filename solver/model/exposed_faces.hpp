#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model.hpp"

namespace pinball {

/// Outward normal of a face of an element, of unit length; zero for a face without area.
Point face_normal(const ModelMesh& mesh, std::size_t element, std::size_t face);

/// Per element of a mesh its exposed faces: bit f is set where nothing is on the other side of face f (xi-, xi+, eta-,
/// eta+, zeta-, zeta+). A face in a plane of symmetry is not exposed: the mirror image of the body continues there. A
/// face whose corners the plane holds is in it only if it lies along it: of a layer in plane strain all are held.
/// neighbours: what face_neighbours gives for the mesh.
std::vector<std::uint8_t> find_exposed_faces(const ModelMesh& mesh, const std::vector<PlaneConstraint>& symmetry,
                                             const std::vector<std::array<std::int32_t, 6>>& neighbours);

/// The same bits of faces that have others on their other side than such of the same corners: quadrangles beside two
/// triangles that have their corners, and these. Nothing in a mesh without triangles or without quadrangles.
std::vector<std::uint8_t> find_split_faces(const ModelMesh& mesh,
                                           const std::vector<std::array<std::int32_t, 6>>& neighbours);

}  // namespace pinball

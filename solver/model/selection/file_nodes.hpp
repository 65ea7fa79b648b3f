#pragma once

#include <cstdint>
#include <vector>

#include <solver/model/model.hpp>

namespace pinball {

/// What a mesh file calls the nodes, faces and elements of the bodies that are from it. node, element: their places in
/// the model, per node and hexahedron of the file; -1: it is in no body.
FileNodes file_nodes(const MeshFile& file, const std::vector<std::int32_t>& node,
                     const std::vector<std::int32_t>& element);

}  // namespace pinball

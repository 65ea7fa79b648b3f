#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// A shell of a rigid part. Of three nodes the last one stands twice.
struct RigidShell {
  std::int64_t id = 0;
  std::int32_t part = 0;  ///< place in the parts of the file
  std::int32_t line = 0;
  std::string file;
  std::array<std::int32_t, 4> nodes{};  ///< of its middle surface, places in the mesh
  double thickness = 0;                 ///< [length]
};

/// Puts a layer of hexahedra behind the others for shells of rigid parts, as thick as they are, half of it on each side
/// of their nodes: it has their volume, and what meets it meets faces where those of the shells are. Shells of a part
/// that share an edge, two of them, share its nodes, which lie along the mean of their normals so that both keep their
/// thickness, but where they turn by more than 120 degrees; over other edges, and where a surface has one side only,
/// layers are not joined. The nodes of the shells have no element; file.layers says what has become of them.
void add_shell_layers(const std::vector<RigidShell>& shells, MeshFile& file);

/// Puts nodes of layers into the sets in the place of those of their shells, and both faces in that of a shell.
void put_layers_into_sets(MeshFile& file);

}  // namespace pinball

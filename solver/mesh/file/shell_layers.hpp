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
  double shift = 0;                     ///< of the layer along their normal, in thicknesses; 0: half on each side
  std::int32_t element = -1;            ///< place in the mesh, where it stands already; -1: behind all others
};

/// Whether a hexahedron stands for a shell whose layer is not there yet: the same corners below and above.
bool is_flat_layer(const std::array<std::int32_t, 8>& hexahedron);

/// Corners of a shell or of its face, of which one may stand twice, in an order that is the same wherever they begin,
/// and whichever stands twice.
std::array<std::int32_t, 4> key_of_shell(std::array<std::int32_t, 4> corners);
/// Whether two with one key go round their corners in one direction.
bool go_round_alike(const std::array<std::int32_t, 4>& a, const std::array<std::int32_t, 4>& b);

/// Puts a layer of hexahedra behind the others, or where they stand, for shells of rigid parts, as thick as they are,
/// half of it on each side of their nodes, or shifted: it has their volume, and what meets it meets faces where those
/// of the shells are. Shells of a part that share an edge, two of them, share its nodes, which lie along the mean of
/// their normals so that both keep their thickness, but where they turn by more than 120 degrees; over other edges, and
/// where a surface has one side only, layers are not joined. The nodes of the shells have no element; file.layers says
/// what has become of them.
void add_shell_layers(const std::vector<RigidShell>& shells, MeshFile& file);

/// Which faces of a layer stand in a set of faces for a shell.
enum class LayerFaces : std::uint8_t { both, facing };  ///< facing: to the side from which the corners go round

/// Puts nodes of layers into the sets in the place of those of their shells, and faces in that of a shell. kept: nodes
/// of shells that stay in their sets, ascending.
void put_layers_into_sets(MeshFile& file, LayerFaces faces = LayerFaces::both,
                          const std::vector<std::int32_t>& kept = {});

}  // namespace pinball

#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <solver/mesh/mesh_file.hpp>
#include <solver/mesh/tetrahedra.hpp>

namespace pinball {

/// Makes eight tetrahedra of four nodes of each that has ten, which fill it with faces between its nodes: first the
/// four inside, around the shortest line between the nodes of two opposite edges, then that at each corner. They have
/// its number, part and line, and are in its sets of elements; a face of it in a set of faces becomes four. Nodes and
/// their sets stay as they are: a set of the nodes of elements has to be one of all of these (add_nodes_of_element).
/// Elements of `twenty_nodes` are found by their new places. What is done is noted in `notes`.
///
/// Returns per element, and for one behind the last, its first place from now on; empty: no element has ten nodes.
/// Throws InputError for a node that is nearer to another place than the middle of its edge, and for meshes that 32
/// bits cannot number.
std::vector<std::int32_t> split_ten_nodes(MeshFile& file);

/// The element between its corners of which the eight that begin at `first` have been made: a tetrahedron of ten nodes,
/// or a hexahedron of twenty (split_twenty_nodes.hpp).
Corners8 unsplit(const MeshFile& file, std::int32_t first);

/// Corners that the edges of a hexahedron join, in the order of TwentyNodes.
inline constexpr std::array<std::array<int, 2>, 12> hexahedron_edges{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// Nodes in the middle of the edges of elements of ten and twenty nodes, and of the faces of the latter.
class EdgeMiddles {
 public:
  EdgeMiddles() = default;
  /// Of those that have been split, and those that are to be, which have none in the middle of faces yet.
  explicit EdgeMiddles(const MeshFile& file);
  /// nodes: as of EdgeNodes.
  void add(const std::array<std::int32_t, 4>& corners, const std::array<std::int32_t, 6>& nodes);
  /// The node between two others: of an edge, or of a face, in whose corners they are opposite.
  void add(std::int32_t a, std::int32_t b, std::int32_t middle);
  /// The four triangles or quadrilaterals of a face between corners, of a triangle whichever of its corners stands
  /// twice; the face itself where its edges have no nodes in their middles.
  std::vector<std::array<std::int32_t, 4>> pieces_of(const std::array<std::int32_t, 4>& face) const;
  /// Corners of faces, and the nodes on their edges, ascending, each once; of faces of no hexahedron those that there
  /// are.
  std::vector<std::int32_t> nodes_of(const std::vector<std::array<std::int32_t, 4>>& faces) const;

 private:
  std::int32_t of(std::int32_t a, std::int32_t b) const;  ///< -1: there is none

  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middle_;  ///< by the ends, the lower first
};

/// Pieces of elements in the place of these, with their numbers, parts and lines, in their sets and in those of faces.
/// first: as split_ten_nodes returns it.
void put_pieces(MeshFile& file, std::vector<Corners8> pieces, const std::vector<std::int32_t>& first,
                const EdgeMiddles& middles);

/// Throws InputError for a node that is not near the middle of the edge from a to b of an element, where formats number
/// nodes in another order. expected: that order.
void require_middle(const MeshFile& file, std::int32_t element, std::int32_t node, std::int32_t a, std::int32_t b,
                    const char* expected);

}  // namespace pinball

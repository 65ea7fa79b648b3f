#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <solver/mesh.hpp>

namespace pinball {

/// Nodes or elements of a set that no body has: nothing is done with them, which is reported to who uses the set.
struct LeftOut {
  std::size_t count = 0;
  std::int64_t first = 0;  ///< the smallest of their numbers in the file

  void add(std::int64_t number) {
    first = count == 0 ? number : std::min(first, number);
    ++count;
  }
};

/// Members of a set that a file gives a number, a name or both: nodes or elements as places in the mesh.
struct MeshSet {
  std::int64_t id = 0;  ///< 0: none
  std::string name;
  std::vector<std::int32_t> members;
  std::string problem{};  ///< what is wrong with it, for who uses it; empty: nothing
  LeftOut left_out{};
};

/// A set of faces, each of four corners; of a triangle the last one stands twice.
struct FaceSet {
  std::int64_t id = 0;
  std::string name;
  std::vector<std::array<std::int32_t, 4>> faces;  ///< corner -1: of a node that no hexahedron has
  std::string problem{};                           ///< as of a MeshSet
  std::size_t left_out = 0;                        ///< faces that no body has
};

struct MeshPart {
  std::int64_t id = 0;
  std::string name;
  std::size_t ten_nodes = 0;  ///< of its elements in the file: tetrahedra of ten nodes (split_ten_nodes)
  std::size_t shells = 0;     ///< of its elements: layers in the place of rigid shells
};

/// What stands for a node of rigid shells, which itself has no element: places in the mesh.
struct LayerNodes {
  std::int32_t middle = 0, below = 0, above = 0;
  std::int32_t part = 0;  ///< place in the parts
};

/// Of a tetrahedron of ten nodes, those on its edges AB, BC, CA, AD, BD, CD; its corners are those of `element`.
struct EdgeNodes {
  std::int32_t element = 0;  ///< place in the mesh
  std::array<std::int32_t, 6> nodes{};
};

/// Of a hexahedron of twenty nodes, those on its edges: four of its first face, the same of the opposite one, and four
/// between these, each from the corner of its number on. Its corners are those of `element`.
struct TwentyNodes {
  std::int32_t element = 0;  ///< place in the mesh
  std::array<std::int32_t, 12> nodes{};
};

/// From which hexahedron on the lines are those of an included file.
struct MeshLines {
  std::int32_t first = 0;
  std::string file;
};

/// A part or set of a file, for who wants to know what there is.
struct MeshGroup {
  enum class Kind { part, elements, nodes, faces } kind;
  std::int64_t id = 0;  ///< 0: none
  std::string name;
  std::size_t members = 0;  ///< elements, nodes or faces
};

/// All that a file says of a mesh: nodes and hexahedra, which of them belong to which part, and sets. Numbers (ids) are
/// those of the file; everything else refers to places, which count from 0 in the order of the file.
struct MeshFile {
  std::string path;
  Mesh mesh;
  std::vector<std::int64_t> node_ids;     ///< per node
  std::vector<std::int64_t> element_ids;  ///< per hexahedron
  std::vector<std::int32_t> part;         ///< per hexahedron, place in `parts`
  std::vector<std::int32_t> line;         ///< per hexahedron, in its file; empty: not known
  std::vector<MeshLines> lines_of;        ///< in the order of the hexahedra; empty: all are lines of the file itself
  std::vector<std::uint8_t> held;         ///< per node: bits of x, y, z that the file itself holds; empty: none
  std::size_t held_rotations = 0;         ///< nodes whose rotations the file holds, which those of solids do not have
  std::vector<EdgeNodes> edge_nodes;      ///< ascending by elements, until split_ten_nodes has made eight of each
  std::vector<TwentyNodes> twenty_nodes;  ///< the same, until split_twenty_nodes has
  std::vector<std::int32_t> eights;       ///< the first of each of these eight, ascending
  std::vector<LayerNodes> layers;         ///< of rigid shells
  std::vector<MeshPart> parts;
  std::vector<MeshGroup> other_parts;  ///< that were not asked for, where the reader leaves out what is not
  std::vector<MeshSet> node_sets, element_sets;
  std::vector<FaceSet> face_sets;
  std::vector<std::string> notes{};   ///< what was left out, in sentences
  std::vector<MeshSource> sources{};  ///< the file itself, and those that it includes
};

struct ElementType;  // solver/mesh/element_types.hpp

/// Puts one more element behind the others, with the nodes on its edges where they are read. nodes: places in the mesh,
/// as many as the type has; behind the corners those of EdgeNodes or TwentyNodes.
void append_element(MeshFile& file, const ElementType& type, std::span<const std::int32_t> nodes);

/// Puts all nodes of an element behind others: its corners, and those on its edges that the file gives it.
void add_nodes_of_element(const MeshFile& file, std::int32_t element, std::vector<std::int32_t>& nodes);

/// Elements of a part: that of this name or number, or else the set of elements of it; all for "". Throws InputError
/// where there is none, of which it names the nearest, or a name of several.
std::vector<std::int32_t> elements_of_part(const MeshFile& file, const std::string& part);

/// The file, or the included one, that a hexahedron stands in.
const std::string& path_of_element(const MeshFile& file, std::int32_t element);
/// "FILE:LINE" where it stands; the file alone where the line is not known.
std::string place_of_element(const MeshFile& file, std::int32_t element);

/// The set of this name, or else of this number; null: none. Throws InputError for a name of several.
const MeshSet* find_set(const std::vector<MeshSet>& sets, const std::string& name);
const FaceSet* find_set(const std::vector<FaceSet>& sets, const std::string& name);
/// All names and numbers, for messages.
std::vector<std::string> set_names(const std::vector<MeshSet>& sets);
std::vector<std::string> set_names(const std::vector<FaceSet>& sets);

/// Also those that were not asked for.
std::vector<MeshGroup> groups_of(const MeshFile& file);

/// The nodes of faces, ascending, each once; of faces of no hexahedron those that there are.
std::vector<std::int32_t> nodes_of_faces(const std::vector<std::array<std::int32_t, 4>>& faces);

/// Drops the nodes that no hexahedron has, also from the sets, which count them; of faces their corners become -1.
void keep_used_nodes(MeshFile& file);

/// The number of a node or an element of these; where a file has none (empty) its place.
std::int64_t number_of(const std::vector<std::int64_t>& ids, std::int32_t place);

/// What a message calls an element: by the file's own number and, where they are known, its line.
std::string element_name(const MeshFile& file, std::int32_t element);

}  // namespace pinball

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <solver/base/point.hpp>

/// The types of solid elements: all that is known of one, but for the kernels that work it (kernels/element_update.hpp,
/// tetrahedron_update.hpp). Each is stored as the eight corners of a hexahedron, some of which are the same node
/// (solver/mesh.hpp). Its faces are those of the hexahedron that have three different nodes or more, so that exposed
/// faces, contact and loads need to know of no shape.
namespace pinball {

struct SizeOfElement;  // solver/base/hexahedron_of_points.hpp

using Corners8 = std::array<std::int32_t, 8>;

/// The tetrahedron of four nodes: seen from d, a to c go counterclockwise, so that its volume is positive.
constexpr Corners8 tetrahedron(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
  return {a, a, b, b, c, d, d, c};
}

/// The wedge between the triangles a b c and d e f: seen from the second, both go counterclockwise.
constexpr Corners8 wedge(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d, std::int32_t e,
                         std::int32_t f) {
  return {a, b, c, c, d, e, f, f};
}

/// The pyramid of the base a b c d: seen from the top it goes counterclockwise.
constexpr Corners8 pyramid(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d, std::int32_t top) {
  return {a, b, c, d, top, top, top, top};
}

/// Whether corners have the form of tetrahedron().
bool is_tetrahedron(const Corners8& corners);

/// Corners at both ends of each.
inline constexpr std::array<std::array<int, 2>, 12> edges_of_hexahedron{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

enum class SolidShape : std::uint8_t { hexahedron, wedge, pyramid, tetrahedron };

/// What decides how an element is worked.
enum class WorkedShape : std::uint8_t {
  hexahedron,  ///< with a volume of its own
  wedge,       ///< a hexahedron with nodes that are all alike, and a volume averaged over them
  tetrahedron  ///< with a volume averaged over nodes
};

/// A shape. Faces have the numbers of face_nodes (kernels/hexahedron.hpp); -1: there is none.
struct KnownShape {
  SolidShape shape;
  const char* plural;
  Corners8 stored;                  ///< which of its corners stands at each of the eight
  WorkedShape worked;               ///< where it deforms, and is from a file or a host
  const char* note;                 ///< what a deck with it is told; empty: nothing
  std::array<int, 6> abaqus_faces;  ///< that Abaqus calls S1 to S6
  std::array<std::array<int, 4>, 6>
      exodus_sides;                ///< corners of the eight of its sides 1 to 6; -1 first: there is none
  int vtk_written = 12;            ///< cell of results
  std::span<const int> cell = {};  ///< which of the eight corners that has; empty: all
};

/// What a file calls an element: types of one shape may have more nodes than corners, or another order of them.
struct ElementType {
  SolidShape shape;
  int nodes;                                         ///< that a file gives, corners first
  int gmsh = 0, vtk = 0;                             ///< numbers of the type; 0: there is none
  std::string_view exodus = {};                      ///< beginning of the names of its blocks; empty: there is none
  std::string_view abaqus = {};                      ///< its names, blanks between, the usual one first
  std::string_view radioss = {};                     ///< keyword of its cards
  std::array<int, 8> order{0, 1, 2, 3, 4, 5, 6, 7};  ///< place in the file of each of its corners
  bool has_edge_nodes = false;  ///< the nodes behind the corners are read, too (solver/mesh/file/split_ten_nodes.hpp)
  /// Some programs see the first face of it from the other side in VTK's files: the corners are these then.
  std::span<const int> turned = {};
};

/// No type that is known has more.
inline constexpr std::size_t most_nodes_of_element = 27;

const KnownShape& known_shape(SolidShape shape);
std::span<const KnownShape> known_shapes();
std::span<const ElementType> element_types();

/// The type of a number, ElementType::gmsh or vtk; null: there is none.
const ElementType* element_type(int ElementType::*format, int number);
/// The type of a name, ElementType::abaqus or radioss; null: there is none.
const ElementType* element_type(std::string_view ElementType::*format, std::string_view name);

/// The eight corners of an element of a type, from its nodes in the order of the file.
Corners8 stored_corners(const ElementType& type, std::span<const std::int32_t> nodes);

/// How many of eight corners are different nodes.
std::size_t different_nodes(const Corners8& corners);
/// How an element that deforms is worked, by its shape, also where it is collapsed in another way than that is stored.
WorkedShape worked_as(const Corners8& corners);

/// The shape of eight corners that are stored in the way of one; hexahedron, where they are in none.
SolidShape shape_of(const Corners8& corners);

/// The eight corners of an element of which results have a cell with these nodes (KnownShape::cell).
Corners8 corners_of_cell(std::span<const std::int32_t> nodes);

/// "hexahedra, wedges, pyramids or tetrahedra"
std::string names_of_shapes();
/// The same with the numbers of their types: "hexahedra (12, 11), wedges (13), ..."
std::string names_of_types(int ElementType::*format);

/// What the bound on the stable step of an element is made of. corners: where they are [length].
SizeOfElement element_size(WorkedShape shape, const std::array<Point, 8>& corners);

}  // namespace pinball

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <solver/formats/abaqus/scan/abaqus_assembly.hpp>
#include <solver/formats/abaqus/scan/abaqus_deck.hpp>
#include <solver/mesh/element_types.hpp>
#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// Where the nodes and elements of a component are in the mesh, and what its numbers become there.
struct AbaqusRange {
  std::size_t first_node = 0, nodes = 0, first_element = 0, elements = 0;
  std::int64_t added = 0;  ///< to its numbers: those of several instances are told apart
};

/// Elements of one type that stand together, up to the first of the next.
struct AbaqusElements {
  std::size_t first = 0;
  std::string type;  ///< without case and blanks: "C3D8R"
  SolidShape shape = SolidShape::hexahedron;
};

/// A MASS or ROTARYI element.
struct AbaqusPointElement {
  std::size_t component = 0;
  bool turns = false;  ///< ROTARYI
  std::int64_t number = 0;
  std::string set;         ///< key of the label that *ELEMENT, ELSET= gives it; empty: none
  std::string node_label;  ///< as its line has it
  DeckPlace place;
  std::int32_t node = -1;  ///< place in the mesh
};

/// Labels of the sets of a mesh, one per set, as label_key has them.
struct AbaqusKeys {
  std::vector<std::string> node_sets, element_sets, face_sets;
};

/// The mesh of Abaqus input, and what is needed to find things in it by the deck's own labels.
struct AbaqusMesh {
  MeshFile file;
  std::size_t given_nodes = 0;  ///< behind these come those of layers, and that hexahedra of twenty nodes get
  std::vector<AbaqusComponent> components;
  std::vector<AbaqusSection> sections;  ///< and rigid bodies of rigid elements: as the first of `file.parts`
  std::vector<AbaqusRange> ranges;      ///< per component
  std::vector<AbaqusElements> types;
  std::vector<AbaqusPointElement> points;
  AbaqusKeys keys;
};

/// NODE, ELEMENT (C3D8 and its kin; C3D6, C3D5 and C3D4 as collapsed hexahedra, C3D10 and C3D20 as eight, R3D4 and R3D3
/// as layers), NSET, ELSET, SURFACE, in parts, instances and the assembly. Parts of the mesh are sections of instances;
/// elements of no section are a part named for the instance. Sets and surfaces of an instance are named INSTANCE.NAME,
/// and NAME where nothing else is named so; labels that are written alike but for quotes by their keys. With more than
/// one component numbers of the second begin behind a power of ten, and so on. Throws InputError "FILE:LINE: ...".
AbaqusMesh abaqus_mesh(const AbaqusDeck& deck);

/// What an element is given as, whichever of its nodes are the same. types: those of a mesh.
SolidShape given_shape(const std::vector<AbaqusElements>& types, std::int32_t element);

/// Face of a hexahedron, as face_nodes of kernels/hexahedron.hpp numbers them, that Abaqus calls S1 to S6 (of a wedge
/// S1 to S5); -1: none. It goes by the places of the nodes: of a hexahedron that has one of them several times some
/// faces are triangles, and some no faces at all (is_face). given: given_shape() of it.
int abaqus_face(const std::array<std::int32_t, 8>& hexahedron, SolidShape given, int number);

/// Its corners, counterclockwise from outside; of a triangle the last one stands twice.
std::array<std::int32_t, 4> corners_of_face(const std::array<std::int32_t, 8>& hexahedron, int face);
/// Whether these are three nodes or more.
bool is_face(const std::array<std::int32_t, 4>& corners);

}  // namespace pinball

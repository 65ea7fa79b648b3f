#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <solver/mesh.hpp>
#include <solver/mesh_settings.hpp>

namespace pinball {

/// Members of a set that a file gives a number, a name or both: nodes or elements as places in the mesh.
struct MeshSet {
  std::int64_t id = 0;  ///< 0: none
  std::string name;
  std::vector<std::int32_t> members;
  std::string problem{};  ///< what is wrong with it, for who uses it; empty: nothing
};

/// A set of faces, each of four corners; of a triangle the last one stands twice.
struct FaceSet {
  std::int64_t id = 0;
  std::string name;
  std::vector<std::array<std::int32_t, 4>> faces;
  std::string problem{};  ///< as of a MeshSet
};

struct MeshPart {
  std::int64_t id = 0;
  std::string name;
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
  std::vector<MeshPart> parts;
  std::vector<MeshSet> node_sets, element_sets;
  std::vector<FaceSet> face_sets;
};

/// Reads the file of a mesh, with its coordinates scaled. parts: which are needed ("": all).
MeshFile read_mesh_file(const FileMesh& settings, const std::vector<std::string>& parts);

/// Elements of a part: that of this name or number, or else the set of elements of it; all for "". Throws InputError
/// where there is none; it names the nearest.
std::vector<std::int32_t> elements_of_part(const MeshFile& file, const std::string& part);

/// The set of this name, or else of this number; null: none. Of several the last one counts, as in a deck.
const MeshSet* find_set(const std::vector<MeshSet>& sets, const std::string& name);
/// All names and numbers, for messages.
std::vector<std::string> set_names(const std::vector<MeshSet>& sets);

/// The file itself, and those that it includes.
std::vector<std::string> files_of(const FileMesh& settings);

}  // namespace pinball

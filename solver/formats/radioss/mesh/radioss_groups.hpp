#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <solver/formats/radioss/scan/radioss_fields.hpp>
#include <solver/mesh/file/shell_layers.hpp>
#include <solver/mesh/file/split_ten_nodes.hpp>
#include <solver/mesh/mesh_file.hpp>
#include <solver/mesh/number_index.hpp>

#include "radioss_parts.hpp"

namespace pinball {

/// Groups of nodes and of solids, and surfaces, of Radioss input: /GRNOD, /GRBRIC, /SURF, /LINE/SURF. What is wrong
/// with one is kept with it, for who uses it.
class RadiossGroups {
 public:
  /// All have to stay; file has its nodes and elements already. shells: whose nodes, and middle surfaces, are those of
  /// their parts, too.
  RadiossGroups(const RadiossDeck& deck, const RadiossParts& parts, MeshFile& file, const NumberIndex& nodes,
                const std::vector<RigidShell>& shells);
  /// Adds all of them to the file.
  void read();

 private:
  using Places = std::vector<std::int32_t>;
  using Face = std::array<std::int32_t, 4>;

  void name_groups();
  Places nodes_of(const RadiossBlock& block);
  Places nodes_of_surface(const RadiossBlock& block);
  Places bricks_of(const RadiossBlock& block);
  std::vector<Face> faces_of(const RadiossBlock& block);
  /// Of a group that another names. Throws InputError where it is not there or in itself.
  const RadiossBlock& find(const std::map<std::int64_t, const RadiossBlock*>& groups, const char* what, std::int64_t id,
                           const DeckPlace& place) const;

  Places numbered(const RadiossBlock& block, bool of_nodes) const;
  Places in_ranges(const RadiossBlock& block, bool of_nodes, bool steps);
  Places in_boxes(const RadiossBlock& block, bool of_nodes) const;
  std::vector<bool> parts_of(const RadiossBlock& block, std::string_view kind) const;
  Places bricks_of_parts(const RadiossBlock& block, std::string_view kind) const;
  /// Middle surfaces of the shells of parts.
  std::vector<Face> shells_of_parts(const RadiossBlock& block, std::string_view kind) const;
  Places nodes_of_bricks(const Places& bricks) const;
  std::vector<Face> shells_of_surface(const RadiossBlock& block) const;
  Face segment(const RadiossFields& fields) const;
  Places bricks_of_surface(const RadiossBlock& block);
  /// Faces of some solids that no other one of them has, and those of these on the surface of the mesh.
  struct Outside {
    std::vector<Face> all, of_mesh;
  };
  Outside outside_of(const Places& bricks);

  const RadiossDeck& deck_;
  const RadiossParts& parts_;
  MeshFile& file_;
  const EdgeMiddles middles_;
  const NumberIndex& nodes_;
  const std::vector<RigidShell>& shells_;
  NumberIndex bricks_;
  std::map<std::int64_t, const RadiossBlock*> node_groups_, brick_groups_, surfaces_, lines_, boxes_;
  std::vector<std::array<std::int32_t, 6>> neighbours_;
  std::size_t depth_ = 0;  ///< of groups in groups
};

}  // namespace pinball

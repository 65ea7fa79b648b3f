#pragma once

#include <map>
#include <optional>
#include <utility>

#include <solver/mesh/element_table.hpp>
#include <solver/mesh/element_types.hpp>
#include <solver/mesh/mesh_file.hpp>
#include <solver/mesh/number_index.hpp>

#include "gmsh_groups.hpp"

namespace pinball {

/// Makes the mesh of what the sections of a Gmsh file say: hexahedra of the physical volumes that are wanted, and a set
/// of nodes for each group of points, curves and surfaces, of surfaces a set of faces, too.
class GmshCollector {
 public:
  /// node_ids: their numbers, each once.
  GmshCollector(const std::string& path, std::vector<Point> nodes, std::vector<std::int64_t> node_ids,
                NumberIndex index);

  /// wanted: groups; none: all volumes. repeats: an element stands in the file again for each of its groups (2.2).
  void begin_elements(std::vector<std::int64_t> wanted, std::int64_t expected, bool repeats);
  bool wants(std::span<const std::int64_t> groups) const;
  /// Place of a node; -1: there is none of that number.
  std::int32_t node(std::int64_t id) const { return index_.find(id); }
  /// nodes: as of append_element; line: 0 where there are none.
  void add_volume(const ElementType& type, std::span<const std::int32_t> nodes, std::span<const std::int64_t> groups,
                  std::int64_t id, int line);
  /// A point, line, triangle or quadrangle, with or without nodes on its edges. problem: what is wrong with it, for who
  /// uses its groups.
  void add_boundary(int dimension, std::span<const std::int32_t> nodes, std::span<const std::int64_t> groups,
                    const std::string& problem);

  /// Counts an element of volumes that are not wanted.
  void leave_out(std::span<const std::int64_t> groups);

  MeshFile finish(const GmshGroups& groups, const std::vector<std::string>& names);

 private:
  struct Boundary {
    std::vector<std::int32_t> nodes;
    std::vector<std::array<std::int32_t, 4>> faces;
    std::string problem;
  };
  using Members = std::map<std::int64_t, std::vector<std::int32_t>>;

  void add_to_group(std::int64_t group, std::int32_t place);
  void require_elements(const std::vector<std::string>& names) const;
  void name_parts(const GmshGroups& groups);
  void name_sets(const GmshGroups& groups);
  void name_boundaries(const GmshGroups& groups);

  MeshFile file_;
  NumberIndex index_;
  std::vector<std::int64_t> wanted_;
  bool repeats_ = false, overlapping_ = false;
  std::optional<PlaceTable> known_;                              ///< format 2.2
  std::vector<std::int64_t> first_group_;                        ///< per hexahedron; 0: none
  Members members_;                                              ///< per physical volume
  std::map<std::int64_t, std::size_t> left_out_;                 ///< elements of physical volumes that are not wanted
  std::map<std::pair<int, std::int64_t>, Boundary> boundaries_;  ///< by dimension and group
};

}  // namespace pinball

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// Integers that a file of VTK gives its cells or points, one for each.
struct VtkArray {
  std::string name;
  bool of_cells = true;
  bool numbers = false;  ///< they are the cells' or points' own numbers
  std::vector<std::int64_t> values;
};

/// An unstructured grid as a file of VTK has it.
struct VtkGrid {
  std::vector<Point> points;
  std::vector<std::int32_t> connectivity;  ///< points of all cells
  std::vector<std::int64_t> ends;          ///< per cell: place in `connectivity` after its last point
  std::vector<std::uint8_t> types;         ///< per cell
  std::vector<VtkArray> arrays;
};

/// The array of the cells by which a file says what part a cell belongs to, if nobody names another: the first of these
/// that there is, in capitals or not.
extern const std::vector<std::string> vtk_part_arrays;

/// Hexahedra, voxels, wedges and pyramids of a grid. array: of the cells, whose integers number the parts; "": one of
/// vtk_part_arrays, or none. Other arrays of integers become sets: NAME where they are 0 or 1, else NAME:VALUE. Points,
/// lines, triangles and quadrangles become sets of nodes and faces, numbered as parts are. parts: those that are
/// needed; none: all. Throws InputError that names the cell for other volumes, points that are not there, a missing
/// array.
MeshFile mesh_of_grid(VtkGrid grid, const std::string& path, const std::string& array,
                      const std::vector<std::string>& parts);

}  // namespace pinball

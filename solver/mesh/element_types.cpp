#include "element_types.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include <kernels/tetrahedron.hpp>
#include <solver/base/hexahedron_of_points.hpp>

#include "shapes/wedges.hpp"
#include "words.hpp"

/// Numbers and names of the formats: "MSH file format" in the reference manual of Gmsh; vtkCellType.h; L. A. Schoof,
/// V. R. Yarberry, SAND92-2137, for Exodus; the manuals of Abaqus and Radioss.
namespace pinball {

namespace {

using Sides = std::array<std::array<int, 4>, 6>;
constexpr std::array<int, 4> none{-1, -1, -1, -1};

constexpr std::array tetrahedron_cell{tetrahedron_corner(0), tetrahedron_corner(1), tetrahedron_corner(2),
                                      tetrahedron_corner(3)};

constexpr std::array shapes{
    KnownShape{
        .shape = SolidShape::hexahedron,
        .plural = "hexahedra",
        .stored = {0, 1, 2, 3, 4, 5, 6, 7},
        .worked = WorkedShape::hexahedron,
        .note = "",
        .abaqus_faces = {4, 5, 2, 1, 3, 0},
        .exodus_sides = Sides{{{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}}}},
    KnownShape{.shape = SolidShape::wedge,
               .plural = "wedges",
               .stored = wedge(0, 1, 2, 3, 4, 5),
               .worked = WorkedShape::wedge,
               .note = "wedges as collapsed hexahedra, with volumes averaged over nodes",
               .abaqus_faces = {4, 5, 2, 1, 0, -1},
               .exodus_sides = Sides{{{0, 1, 5, 4}, {1, 2, 6, 5}, {0, 4, 6, 2}, {0, 2, 1, 1}, {4, 5, 6, 6}, none}}},
    KnownShape{.shape = SolidShape::pyramid,
               .plural = "pyramids",
               .stored = pyramid(0, 1, 2, 3, 4),
               .worked = WorkedShape::hexahedron,
               .note = "pyramids as collapsed hexahedra",
               .abaqus_faces = {4, 2, 1, 3, 0, -1},
               .exodus_sides = Sides{{{0, 1, 4, 4}, {1, 2, 4, 4}, {2, 3, 4, 4}, {0, 4, 3, 3}, {0, 3, 2, 1}, none}}},
    KnownShape{.shape = SolidShape::tetrahedron,
               .plural = "tetrahedra",
               .stored = tetrahedron(0, 1, 2, 3),
               .worked = WorkedShape::tetrahedron,
               .note = "tetrahedra with volumes averaged over nodes",
               .abaqus_faces = {0, 1, 3, 2, -1, -1},
               .exodus_sides = Sides{{{0, 2, 5, 5}, {2, 4, 5, 5}, {0, 5, 4, 4}, {0, 4, 2, 2}, none, none}},
               .vtk_written = 10,
               .cell = tetrahedron_cell},
};

static_assert(std::ranges::is_sorted(shapes, {}, &KnownShape::shape) &&
              static_cast<std::size_t>(shapes.back().shape) + 1 == shapes.size());

constexpr std::array turned_wedge{3, 4, 5, 0, 1, 2};
constexpr std::array turned_pyramid{3, 2, 1, 0, 4};

constexpr std::array types{
    ElementType{.shape = SolidShape::hexahedron,
                .nodes = 8,
                .gmsh = 5,
                .vtk = 12,
                .exodus = "HEX",
                .abaqus = "C3D8 C3D8R C3D8I C3D8H C3D8S C3D8RH C3D8IH C3D8T C3D8RT",
                .radioss = "BRICK"},
    ElementType{.shape = SolidShape::hexahedron, .nodes = 8, .vtk = 11, .order = {0, 1, 3, 2, 4, 5, 7, 6}},
    ElementType{.shape = SolidShape::hexahedron,
                .nodes = 20,
                .abaqus = "C3D20 C3D20R C3D20H C3D20RH",
                .radioss = "BRIC20",
                .has_edge_nodes = true},
    ElementType{.shape = SolidShape::wedge,
                .nodes = 6,
                .gmsh = 6,
                .vtk = 13,
                .exodus = "WEDGE",
                .abaqus = "C3D6 C3D6R C3D6T",
                .radioss = "PENTA6",
                .turned = turned_wedge},
    ElementType{.shape = SolidShape::pyramid,
                .nodes = 5,
                .gmsh = 7,
                .vtk = 14,
                .exodus = "PYRAMID",
                .abaqus = "C3D5 C3D5H",
                .turned = turned_pyramid},
    ElementType{.shape = SolidShape::tetrahedron,
                .nodes = 4,
                .gmsh = 4,
                .vtk = 10,
                .exodus = "TET",
                .abaqus = "C3D4 C3D4H C3D4T",
                .radioss = "TETRA4"},
    ElementType{.shape = SolidShape::tetrahedron,
                .nodes = 10,
                .gmsh = 11,
                .vtk = 24,
                .exodus = "TET",
                .abaqus = "C3D10 C3D10M C3D10H C3D10MH",
                .radioss = "TETRA10",
                .has_edge_nodes = true},
};

static_assert(std::ranges::max(types, {}, &ElementType::nodes).nodes <= static_cast<int>(most_nodes_of_element));

/// "a, b or c"
std::string alternatives_of(const std::vector<std::string>& all) {
  if (all.size() < 2) return fmt::format("{}", fmt::join(all, ""));
  return fmt::format("{} or {}", fmt::join(all.begin(), all.end() - 1, ", "), all.back());
}

}  // namespace

std::span<const KnownShape> known_shapes() { return shapes; }
std::span<const ElementType> element_types() { return types; }

const KnownShape& known_shape(SolidShape shape) { return shapes[static_cast<std::size_t>(shape)]; }

const ElementType* element_type(int ElementType::*format, int number) {
  const auto found = std::ranges::find(types, number, format);
  return number == 0 || found == types.end() ? nullptr : &*found;
}

const ElementType* element_type(std::string_view ElementType::*format, std::string_view name) {
  const auto is_of = [&](const ElementType& type) {
    bool found = false;
    for_words(type.*format, [&](std::string_view word) { found = found || word == name; });
    return found;
  };
  const auto type = std::ranges::find_if(types, is_of);
  return type == types.end() ? nullptr : &*type;
}

Corners8 stored_corners(const ElementType& type, std::span<const std::int32_t> nodes) {
  const Corners8& stored = known_shape(type.shape).stored;
  Corners8 corners;
  for (std::size_t i = 0; i < 8; ++i) corners[i] = nodes[type.order[stored[i]]];
  return corners;
}

bool is_tetrahedron(const Corners8& c) {
  const bool collapsed = c[0] == c[1] && c[2] == c[3] && c[4] == c[7] && c[5] == c[6];
  return collapsed && c[0] != c[2] && c[0] != c[4] && c[0] != c[5] && c[2] != c[4] && c[2] != c[5] && c[4] != c[5];
}

std::size_t different_nodes(const Corners8& corners) {
  Corners8 sorted = corners;
  std::ranges::sort(sorted);
  return std::unique(sorted.begin(), sorted.end()) - sorted.begin();
}

WorkedShape worked_as(const Corners8& corners) {
  bool is_collapsed = false;  // nearly none is, and each is asked several times
  for (const auto& [begin, end] : edges_of_hexahedron) is_collapsed = is_collapsed || corners[begin] == corners[end];
  if (!is_collapsed) return WorkedShape::hexahedron;
  if (is_tetrahedron(corners)) return WorkedShape::tetrahedron;
  return as_wedge(corners) ? WorkedShape::wedge : WorkedShape::hexahedron;
}

SolidShape shape_of(const Corners8& c) {
  if (is_tetrahedron(c)) return SolidShape::tetrahedron;
  if (c[4] == c[6]) return SolidShape::pyramid;
  return c[2] == c[3] && c[6] == c[7] ? SolidShape::wedge : SolidShape::hexahedron;
}

Corners8 corners_of_cell(std::span<const std::int32_t> nodes) {
  const auto has_cell = [&nodes](const KnownShape& shape) { return shape.cell.size() == nodes.size(); };
  const auto found = std::ranges::find_if(shapes, has_cell);
  const KnownShape& shape = found == shapes.end() ? known_shape(SolidShape::hexahedron) : *found;
  Corners8 corners;
  for (std::size_t i = 0; i < 8; ++i) corners[i] = nodes[shape.stored[i]];
  return corners;
}

std::string names_of_shapes() {
  std::vector<std::string> names;
  for (const KnownShape& shape : shapes) names.emplace_back(shape.plural);
  return alternatives_of(names);
}

std::string names_of_types(int ElementType::*format) {
  std::vector<std::string> names;
  for (const KnownShape& shape : shapes) {
    std::vector<int> numbers;
    for (const ElementType& type : types) {
      if (type.shape == shape.shape && type.*format != 0) numbers.push_back(type.*format);
    }
    if (!numbers.empty()) names.push_back(fmt::format("{} ({})", shape.plural, fmt::join(numbers, ", ")));
  }
  return alternatives_of(names);
}

SizeOfElement element_size(WorkedShape shape, const std::array<Point, 8>& corners) {
  SizeOfElement size = element_size(corners, shape == WorkedShape::tetrahedron);
  if (shape == WorkedShape::wedge) size.square = square_of_wedge(corners);
  return size;
}

}  // namespace pinball

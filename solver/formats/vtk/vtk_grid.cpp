#include "vtk_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <span>

#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>
#include <solver/mesh/element_types.hpp>
#include <solver/mesh/quality.hpp>

/// Types and the order of points: "VTK File Formats", and vtkCellType.h.
namespace pinball {

const std::vector<std::string> vtk_part_arrays{"part",        "part_id",   "partid",       "material", "material_id",
                                               "materialids", "attribute", "block_id",     "blockid",  "objectid",
                                               "region",      "body",      "gmsh:physical"};

namespace {

constexpr int vertex = 1, line_2 = 3, triangle = 5, pixel = 8, quadrangle = 9, line_3 = 21, triangle_6 = 22;
/// An array with more values than this numbers something else than sets.
constexpr std::size_t most_sets = 1000;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string name_of(int type) {
  static const std::map<int, std::string> names{
      {15, "pentagonal prisms"}, {16, "hexagonal prisms"},    {25, "quadratic hexahedra"},
      {26, "quadratic wedges"},  {27, "quadratic pyramids"},  {29, "triquadratic hexahedra"},
      {42, "polyhedra"},         {71, "Lagrange tetrahedra"}, {72, "Lagrange hexahedra"},
      {79, "Bezier hexahedra"},
  };
  const auto found = names.find(type);
  return found == names.end() ? "cells" : found->second;
}

bool is_of_lower_dimension(int type) {
  return type <= quadrangle || (type >= 21 && type <= 23) || type == 28 || (type >= 30 && type <= 36) || type == 68 ||
         type == 69 || type == 70;
}

/// Of a cell without a volume; 0: it is not known.
std::size_t points_of_boundary(int type) {
  return type == vertex                        ? 1
         : type == line_2                      ? 2
         : type == triangle || type == line_3  ? 3
         : type == pixel || type == quadrangle ? 4
         : type == triangle_6                  ? 6
                                               : 0;
}

class Builder {
 public:
  Builder(VtkGrid grid, const std::string& path, const std::vector<std::string>& parts)
      : grid_(std::move(grid)), wanted_(parts) {
    file_.path = path;
  }

  MeshFile build(const std::string& array) {
    const VtkArray* part = part_array(array);
    file_.mesh.nodes = std::move(grid_.points);
    cell_place_.assign(grid_.types.size(), -1);
    for (std::size_t cell = 0; cell < grid_.types.size(); ++cell) add_cell(cell, part ? part->values[cell] : 0, part);
    if (file_.mesh.hexahedra.empty()) fail(fmt::format("expected {}, got none", names_of_shapes()));
    number_elements();
    number_nodes();
    name_parts(part);
    add_boundaries();
    for (const VtkArray& other : grid_.arrays) {
      if (&other != part && !other.numbers) add_sets(other);
    }
    keep_used_nodes(file_);
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const { throw InputError(file_.path + ": " + problem); }

  const VtkArray* part_array(const std::string& wanted) const {
    std::vector<std::string> known;
    for (const VtkArray& array : grid_.arrays) {
      if (array.of_cells && array.name == wanted && !wanted.empty()) return &array;
      if (array.of_cells) known.push_back(array.name);
    }
    if (!wanted.empty()) {
      fail(fmt::format("no array of integers of the cells is named \"{}\": {}", wanted,
                       known.empty() ? "there are none" : fmt::format("nearest is \"{}\"", nearest(wanted, known))));
    }
    for (const std::string& name : vtk_part_arrays) {
      for (const VtkArray& array : grid_.arrays) {
        if (array.of_cells && !array.numbers && lower(array.name) == name) return &array;
      }
    }
    return nullptr;
  }

  bool is_wanted(std::int64_t part, bool has_parts) const {
    if (wanted_.empty() || !has_parts) return true;
    // A set of elements may be of any part.
    const bool all_numbers = std::ranges::all_of(
        wanted_, [](const std::string& name) { return name.find_first_not_of("0123456789-") == std::string::npos; });
    return !all_numbers || std::ranges::count(wanted_, std::to_string(part)) > 0;
  }

  void add_cell(std::size_t cell, std::int64_t part, bool has_parts) {
    const int type = grid_.types[cell];
    const std::int64_t begin = cell == 0 ? 0 : grid_.ends[cell - 1];
    const std::span<const std::int32_t> points(grid_.connectivity.data() + begin, grid_.ends[cell] - begin);
    for (const std::int32_t point : points) {
      if (point < 0 || point >= std::ssize(file_.mesh.nodes))
        fail(fmt::format("cell {}: expected points from 0 to {}, got {}", cell, file_.mesh.nodes.size() - 1, point));
    }
    const ElementType* const volume = element_type(&ElementType::vtk, type);
    if (volume == nullptr && !is_of_lower_dimension(type)) return reject(cell, type, is_wanted(part, has_parts));
    const std::size_t expected = volume != nullptr ? volume->nodes : points_of_boundary(type);
    if (expected > 0 && points.size() != expected)
      fail(
          fmt::format("cell {}: expected {} points of a cell of type {}, got {}", cell, expected, type, points.size()));
    if (volume != nullptr) {
      cell_place_[cell] = file_.mesh.hexahedra.size();
      std::array<std::int32_t, 8> turned{};
      append_element(file_, *volume, in_order(*volume, points, turned));
    } else if (expected > 0 && has_parts) {
      add_boundary(type, points, part);
    }
  }

  void reject(std::size_t cell, int type, bool wanted) const {
    if (!wanted) return;
    fail(fmt::format("cell {}: expected types of {}, got {} (type {})", cell, names_of_types(&ElementType::vtk),
                     name_of(type), type));
  }

  /// The format has the first triangle of a wedge seen from inside, many programs write it as other formats do: the
  /// points, or what is put into `turned`.
  std::span<const std::int32_t> in_order(const ElementType& type, std::span<const std::int32_t> points,
                                         std::array<std::int32_t, 8>& turned) const {
    if (type.turned.empty()) return points;
    const Corners8 there = stored_corners(type, points);
    std::array<Point, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) corners[i] = file_.mesh.nodes[there[i]];
    if (volume_by_quadrature(corners) >= 0) return points;
    for (std::size_t i = 0; i < type.turned.size(); ++i) turned[i] = points[type.turned[i]];
    return {turned.data(), type.turned.size()};
  }

  void add_boundary(int type, std::span<const std::int32_t> p, std::int64_t part) {
    std::vector<std::int32_t>& nodes = nodes_of_boundary_[part];
    nodes.insert(nodes.end(), p.begin(), p.end());
    if (type == triangle || type == triangle_6) faces_[part].push_back({p[0], p[1], p[2], p[2]});
    if (type == quadrangle) faces_[part].push_back({p[0], p[1], p[2], p[3]});
    if (type == pixel) faces_[part].push_back({p[0], p[1], p[3], p[2]});
  }

  /// As ParaView counts cells and points, or by the file's own numbers.
  void number_elements() {
    const VtkArray* own = numbers(true);
    for (std::size_t cell = 0; cell < cell_place_.size(); ++cell) {
      if (cell_place_[cell] >= 0) file_.element_ids.push_back(own ? own->values[cell] : cell);
    }
  }
  void number_nodes() {
    if (const VtkArray* own = numbers(false)) {
      file_.node_ids = own->values;
      return;
    }
    file_.node_ids.resize(file_.mesh.nodes.size());
    for (std::size_t n = 0; n < file_.node_ids.size(); ++n) file_.node_ids[n] = n;
  }
  const VtkArray* numbers(bool of_cells) const {
    for (const VtkArray& array : grid_.arrays) {
      if (array.numbers && array.of_cells == of_cells) return &array;
    }
    return nullptr;
  }

  static MeshPart named(std::int64_t value) { return {value, value == 0 ? "0" : ""}; }

  void name_parts(const VtkArray* part) {
    if (part == nullptr) return;
    std::map<std::int64_t, std::int32_t> place;
    file_.part.resize(file_.mesh.hexahedra.size());
    for (std::size_t cell = 0; cell < cell_place_.size(); ++cell) {
      if (cell_place_[cell] < 0) continue;
      const std::int64_t value = part->values[cell];
      const auto [found, is_new] = place.try_emplace(value, static_cast<std::int32_t>(file_.parts.size()));
      if (is_new) file_.parts.push_back(named(value));
      file_.part[cell_place_[cell]] = found->second;
    }
  }

  void add_boundaries() {
    for (auto& [id, nodes] : nodes_of_boundary_) {
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      file_.node_sets.push_back({id, named(id).name, std::move(nodes)});
    }
    for (auto& [id, faces] : faces_) file_.face_sets.push_back({id, named(id).name, std::move(faces)});
  }

  /// Sets of cells or points by their values but 0.
  void add_sets(const VtkArray& array) {
    std::set<std::int64_t> values;
    for (const std::int64_t value : array.values) {
      if (value != 0 && (values.empty() || *values.rbegin() != value)) values.insert(value);
      if (values.size() > most_sets) return;
    }
    std::map<std::int64_t, MeshSet> sets;
    for (const std::int64_t value : values) {
      const bool alone = values.size() == 1 && value == 1;
      sets[value] = {0, alone ? array.name : fmt::format("{}:{}", array.name, value), {}};
    }
    for (std::size_t i = 0; i < array.values.size(); ++i) {
      const std::int32_t place = array.of_cells ? cell_place_[i] : static_cast<std::int32_t>(i);
      if (array.values[i] != 0 && place >= 0) sets[array.values[i]].members.push_back(place);
    }
    std::vector<MeshSet>& all = array.of_cells ? file_.element_sets : file_.node_sets;
    for (auto& [value, set] : sets) all.push_back(std::move(set));
  }

  VtkGrid grid_;
  const std::vector<std::string>& wanted_;
  MeshFile file_;
  std::vector<std::int32_t> cell_place_;  ///< among the hexahedra; -1: none
  std::map<std::int64_t, std::vector<std::int32_t>> nodes_of_boundary_;
  std::map<std::int64_t, std::vector<std::array<std::int32_t, 4>>> faces_;
};

}  // namespace

MeshFile mesh_of_grid(VtkGrid grid, const std::string& path, const std::string& array,
                      const std::vector<std::string>& parts) {
  return Builder(std::move(grid), path, parts).build(array);
}

}  // namespace pinball

#include "field_arrays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>

#include <kernels/exec.hpp>
#include <solver/base/error.hpp>
#include <solver/base/hexahedron_of_points.hpp>
#include <solver/mesh/element_types.hpp>

namespace pinball {
namespace {

/// count x components numbers of type T, made in blocks so that no second copy of a field is held.
template <class T, class Value>
DataArray make_array(std::string_view type, std::string_view name, std::size_t count, std::size_t components,
                     Value value) {
  DataArray array;
  array.attributes = fmt::format(R"(type="{}" Name="{}")", type, name);
  if (components > 1) array.attributes += fmt::format(R"( NumberOfComponents="{}")", components);
  array.bytes = count * components * sizeof(T);
  array.write = [=](const ByteSink& sink) {
    constexpr std::size_t block = 65536;
    std::vector<T> buffer(std::min(block, count) * components);
    for (std::size_t begin = 0; begin < count; begin += block) {
      const std::size_t own = std::min(block, count - begin);
      parallel_for("numbers of a field", RangePolicy<>{0, static_cast<std::int64_t>(own)}, [&](std::int64_t i) {
        T* const to = buffer.data() + i * components;
        for (std::size_t c = 0; c < components; ++c) to[c] = static_cast<T>(value(begin + i, c));
      });
      sink(buffer.data(), own * components * sizeof(T));
    }
  };
  return array;
}

template <class Components>
DataArray vector_field(std::string_view name, const std::vector<Components>& field) {
  return make_array<float>("Float32", name, field.size(), std::tuple_size_v<Components>,
                           [&field](std::size_t i, std::size_t c) { return field[i][c]; });
}

DataArray scalar_field(std::string_view name, const std::vector<double>& field) {
  return make_array<float>("Float32", name, field.size(), 1, [&field](std::size_t i, std::size_t) { return field[i]; });
}

double von_mises(const std::array<double, 6>& s) {
  const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

/// Positive in compression.
double pressure(const std::array<double, 6>& s) { return -(s[0] + s[1] + s[2]) / 3; }

/// Mean stress, positive in tension, over the effective stress; 0 without stress [-].
double triaxiality(const std::array<double, 6>& s) {
  const double effective = von_mises(s);
  return effective > 0 ? -pressure(s) / effective : 0.0;
}

/// The least Jacobian of a corner over the mean volume: not above 0 where a corner has turned over, 1 in a
/// parallelepiped, 0 where the element has no volume [-].
double corner_share(const FieldSnapshot& s, std::size_t element) {
  std::array<Point, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) corners[i] = s.position[s.hexahedra[element][i]];
  const double volume = hexahedron_volume(corners);
  if (shape_of(s.hexahedra[element]) == SolidShape::tetrahedron) return volume == 0 ? 0.0 : std::copysign(1.0, volume);
  return volume == 0 ? 0.0 : std::copysign(1.0, volume) * least_corner_share(corners);
}

DataArray numbers_array(std::string_view name, const std::vector<std::int64_t>& numbers) {
  return make_array<std::int64_t>("Int64", name, numbers.size(), 1,
                                  [&numbers](std::size_t i, std::size_t) { return numbers[i]; });
}

/// Strings as VTK has them: each with a zero behind it.
DataArray names_array(std::string_view name, const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& one : names) (text += one) += '\0';
  DataArray array;
  array.attributes = fmt::format(R"(type="String" Name="{}" NumberOfTuples="{}")", name, names.size());
  array.bytes = text.size();
  array.write = [text](const ByteSink& sink) { sink(text.data(), text.size()); };
  return array;
}

/// Whether a field is asked for, by itself or by one that brings it; without any names all are.
struct Wanted {
  const std::vector<std::string>& fields;

  bool operator()(std::string_view name, std::string_view with = {}) const {
    return fields.empty() ||
           std::any_of(fields.begin(), fields.end(), [&](const auto& f) { return f == name || f == with; });
  }
};

void list_node_arrays(const FieldSnapshot& s, const FieldBase& base, const Wanted& wanted, std::vector<DataArray>& to) {
  if (wanted("velocity") && !s.velocity.empty()) to.push_back(vector_field("velocity", s.velocity));
  if (wanted("displacement", "velocity") && !base.initial.empty()) {
    to.push_back(make_array<float>("Float32", "displacement", s.position.size(), 3, [&](std::size_t i, std::size_t c) {
      return s.position[i][c] - base.initial[i][c];
    }));
  }
  if (wanted("contact_force") && !s.contact_force.empty()) {
    to.push_back(vector_field("contact_force", s.contact_force));
  }
  if (!base.node_number.empty()) to.push_back(numbers_array("node_number", base.node_number));
}

void list_stress_arrays(const FieldSnapshot& s, const Wanted& wanted, std::vector<DataArray>& to) {
  if (s.stress.empty()) return;
  const auto invariant = [&](std::string_view name, double (*value)(const std::array<double, 6>&)) {
    to.push_back(make_array<float>("Float32", name, s.stress.size(), 1,
                                   [&s, value](std::size_t i, std::size_t) { return value(s.stress[i]); }));
  };
  if (wanted("stress")) {
    to.push_back(vector_field("stress", s.stress));
    constexpr std::array<std::string_view, 6> components = {"xx", "yy", "zz", "xy", "yz", "zx"};
    for (std::size_t c = 0; c < components.size(); ++c) {
      to.back().attributes += fmt::format(R"( ComponentName{}="{}")", c, components[c]);
    }
    invariant("von_mises", von_mises);
  }
  if (wanted("pressure", "stress")) invariant("pressure", pressure);
  if (wanted("triaxiality")) invariant("triaxiality", triaxiality);
}

void list_element_arrays(const FieldSnapshot& s, const FieldBase& base, const Wanted& wanted,
                         std::vector<DataArray>& to) {
  const std::size_t elements = s.hexahedra.size();
  list_stress_arrays(s, wanted, to);
  if (wanted("plastic_strain") && !s.plastic_strain.empty()) {
    to.push_back(scalar_field("plastic_strain", s.plastic_strain));
  }
  if (wanted("temperature") && !s.temperature.empty()) to.push_back(scalar_field("temperature", s.temperature));
  if (wanted("damage") && !s.damage.empty()) to.push_back(scalar_field("damage", s.damage));
  if (wanted("pinball_radius") && !s.pinball_radius.empty()) {
    to.push_back(scalar_field("pinball_radius", s.pinball_radius));
  }
  if (wanted("corner_share")) {
    to.push_back(make_array<float>("Float32", "corner_share", elements, 1,
                                   [&s](std::size_t i, std::size_t) { return corner_share(s, i); }));
  }
  // Always: 5 bytes per element, and without `alive` an eroded element could not be hidden.
  to.push_back(make_array<std::uint8_t>("UInt8", "alive", elements, 1, [&s](std::size_t i, std::size_t) {
    return s.alive.empty() ? std::uint8_t{1} : s.alive[i];
  }));
  to.push_back(make_array<std::int32_t>("Int32", "body", elements, 1,
                                        [&s](std::size_t i, std::size_t) { return s.body.empty() ? 0 : s.body[i]; }));
  if (!base.element_number.empty()) to.push_back(numbers_array("element_number", base.element_number));
}

struct Cells {
  std::vector<std::int32_t> nodes;  ///< of all, one after the other
  std::vector<std::int64_t> ends;   ///< of each
};

bool has_own_cell(const Corners8& corners) { return !known_shape(shape_of(corners)).cell.empty(); }

Cells cells_of(const FieldSnapshot& s) {
  Cells cells;
  for (const auto& corners : s.hexahedra) {
    const KnownShape& shape = known_shape(shape_of(corners));
    for (const int corner : shape.cell) cells.nodes.push_back(corners[corner]);
    if (shape.cell.empty()) cells.nodes.insert(cells.nodes.end(), corners.begin(), corners.end());
    cells.ends.push_back(cells.nodes.size());
  }
  return cells;
}

/// Of hexahedra alone no second copy is held.
void list_cells(const FieldSnapshot& s, FieldArrays& a) {
  const std::size_t elements = s.hexahedra.size();
  if (std::ranges::none_of(s.hexahedra, has_own_cell)) {
    a.cells.push_back(make_array<std::int32_t>("Int32", "connectivity", 8 * elements, 1,
                                               [&s](std::size_t i, std::size_t) { return s.hexahedra[i / 8][i % 8]; }));
    a.cells.push_back(make_array<std::int64_t>("Int64", "offsets", elements, 1,
                                               [](std::size_t i, std::size_t) { return 8 * (i + 1); }));
    return;
  }
  const auto cells = std::make_shared<const Cells>(cells_of(s));
  a.cells.push_back(make_array<std::int32_t>("Int32", "connectivity", cells->nodes.size(), 1,
                                             [cells](std::size_t i, std::size_t) { return cells->nodes[i]; }));
  a.cells.push_back(make_array<std::int64_t>("Int64", "offsets", elements, 1,
                                             [cells](std::size_t i, std::size_t) { return cells->ends[i]; }));
}

void list_mesh_arrays(const FieldSnapshot& s, FieldArrays& a) {
  const std::size_t elements = s.hexahedra.size();
  a.points.push_back(make_array<double>("Float64", "Points", s.position.size(), 3,
                                        [&s](std::size_t i, std::size_t c) { return s.position[i][c]; }));
  list_cells(s, a);
  a.cells.push_back(make_array<std::uint8_t>("UInt8", "types", elements, 1, [&s](std::size_t i, std::size_t) {
    return known_shape(shape_of(s.hexahedra[i])).vtk_written;
  }));
}

void check_size(const std::string& path, std::string_view field, std::size_t size, std::size_t expected) {
  if (size != 0 && size != expected) {
    throw RunError(fmt::format("cannot write {}: {} has {} values, the mesh {}", path, field, size, expected));
  }
}

}  // namespace

FieldArrays list_arrays(const FieldSnapshot& s, const FieldBase& base, const std::vector<std::string>& fields,
                        const std::vector<std::string>& bodies) {
  FieldArrays a;
  a.field.push_back(
      make_array<double>("Float64", "TimeValue", 1, 1, [&s](std::size_t, std::size_t) { return s.time; }));
  a.field.back().attributes += R"( NumberOfTuples="1")";
  if (!bodies.empty()) a.field.push_back(names_array("body_names", bodies));
  list_node_arrays(s, base, {fields}, a.point);
  list_element_arrays(s, base, {fields}, a.cell);
  if (!base.node_place.empty()) {
    a.point.push_back(numbers_array(node_places, base.node_place));
    a.point_attributes = fmt::format(R"( GlobalIds="{}")", node_places);
  }
  if (!base.element_place.empty()) {
    a.cell.push_back(numbers_array(element_places, base.element_place));
    a.cell_attributes = fmt::format(R"( GlobalIds="{}")", element_places);
  }
  list_mesh_arrays(s, a);
  return a;
}

void check_sizes(const std::string& path, const FieldSnapshot& s, const FieldBase& base) {
  const std::size_t nodes = s.position.size(), elements = s.hexahedra.size();
  check_size(path, "velocity", s.velocity.size(), nodes);
  check_size(path, "contact_force", s.contact_force.size(), nodes);
  check_size(path, "stress", s.stress.size(), elements);
  check_size(path, "plastic_strain", s.plastic_strain.size(), elements);
  check_size(path, "temperature", s.temperature.size(), elements);
  check_size(path, "damage", s.damage.size(), elements);
  check_size(path, "pinball_radius", s.pinball_radius.size(), elements);
  check_size(path, "alive", s.alive.size(), elements);
  check_size(path, "body", s.body.size(), elements);
  check_size(path, "displacement", base.initial.size(), nodes);
  check_size(path, "node_number", base.node_number.size(), nodes);
  check_size(path, "element_number", base.element_number.size(), elements);
}

}  // namespace pinball

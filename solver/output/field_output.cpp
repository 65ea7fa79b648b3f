#include "field_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

#include <solver/base/error.hpp>
#include <solver/results/units.hpp>

#include "output_file.hpp"
#include "run_files.hpp"

namespace pinball {
namespace {

static_assert(std::endian::native == std::endian::little, "the appended data are written as they lie in memory");

constexpr std::array<std::string_view, 6> known_fields = {"velocity",       "contact_force",  "stress",
                                                          "plastic_strain", "pinball_radius", "alive"};

/// One <DataArray>: what the head of the file says of it, and how its bytes are made.
struct DataArray {
  std::string attributes;
  std::uint64_t bytes = 0;
  std::function<void(OutputFile&)> write;
};

/// count x components numbers of type T, made in blocks so that no second copy of a field is held.
template <class T, class Value>
DataArray make_array(std::string_view type, std::string_view name, std::size_t count, std::size_t components,
                     Value value) {
  DataArray array;
  array.attributes = fmt::format(R"(type="{}" Name="{}")", type, name);
  if (components > 1) array.attributes += fmt::format(R"( NumberOfComponents="{}")", components);
  array.bytes = count * components * sizeof(T);
  array.write = [=](OutputFile& file) {
    constexpr std::size_t block = 4096;
    std::vector<T> buffer(std::min(block, count) * components);
    for (std::size_t begin = 0; begin < count; begin += block) {
      const std::size_t end = std::min(begin + block, count);
      T* to = buffer.data();
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t c = 0; c < components; ++c) *to++ = static_cast<T>(value(i, c));
      }
      file.write(buffer.data(), (end - begin) * components * sizeof(T));
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

/// An array that is there but of another length than the mesh would make a file that no reader takes.
void check_size(const std::string& path, std::string_view field, std::size_t size, std::size_t expected) {
  if (size != 0 && size != expected) {
    throw RunError(fmt::format("cannot write {}: {} has {} values, the mesh {}", path, field, size, expected));
  }
}

void check_sizes(const std::string& path, const FieldSnapshot& s) {
  const std::size_t nodes = s.position.size(), elements = s.hexahedra.size();
  check_size(path, "velocity", s.velocity.size(), nodes);
  check_size(path, "contact_force", s.contact_force.size(), nodes);
  check_size(path, "stress", s.stress.size(), elements);
  check_size(path, "plastic_strain", s.plastic_strain.size(), elements);
  check_size(path, "pinball_radius", s.pinball_radius.size(), elements);
  check_size(path, "alive", s.alive.size(), elements);
  check_size(path, "body", s.body.size(), elements);
}

/// Strings as VTK has them: each with a zero behind it.
DataArray names_array(std::string_view name, const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& one : names) (text += one) += '\0';
  DataArray array;
  array.attributes = fmt::format(R"(type="String" Name="{}" NumberOfTuples="{}")", name, names.size());
  array.bytes = text.size();
  array.write = [text](OutputFile& file) { file.write(text); };
  return array;
}

struct Arrays {
  std::vector<DataArray> field, point, cell, points, cells;
};

Arrays list_arrays(const FieldSnapshot& s, const std::vector<std::string>& fields,
                   const std::vector<std::string>& bodies) {
  const auto wanted = [&fields](std::string_view name) {
    return fields.empty() || std::find(fields.begin(), fields.end(), name) != fields.end();
  };
  const std::size_t elements = s.hexahedra.size();
  Arrays a;
  a.field.push_back(
      make_array<double>("Float64", "TimeValue", 1, 1, [&s](std::size_t, std::size_t) { return s.time; }));
  a.field.back().attributes += R"( NumberOfTuples="1")";
  if (!bodies.empty()) a.field.push_back(names_array("body_names", bodies));

  if (wanted("velocity") && !s.velocity.empty()) a.point.push_back(vector_field("velocity", s.velocity));
  if (wanted("contact_force") && !s.contact_force.empty()) {
    a.point.push_back(vector_field("contact_force", s.contact_force));
  }
  if (wanted("stress") && !s.stress.empty()) {
    a.cell.push_back(vector_field("stress", s.stress));
    constexpr std::array<std::string_view, 6> components = {"xx", "yy", "zz", "xy", "yz", "zx"};
    for (std::size_t c = 0; c < components.size(); ++c) {
      a.cell.back().attributes += fmt::format(R"( ComponentName{}="{}")", c, components[c]);
    }
    a.cell.push_back(make_array<float>("Float32", "von_mises", elements, 1,
                                       [&s](std::size_t i, std::size_t) { return von_mises(s.stress[i]); }));
  }
  if (wanted("plastic_strain") && !s.plastic_strain.empty()) {
    a.cell.push_back(scalar_field("plastic_strain", s.plastic_strain));
  }
  if (wanted("pinball_radius") && !s.pinball_radius.empty()) {
    a.cell.push_back(scalar_field("pinball_radius", s.pinball_radius));
  }
  // Always: 5 bytes per element, and without `alive` an eroded element could not be hidden.
  a.cell.push_back(make_array<std::uint8_t>("UInt8", "alive", elements, 1, [&s](std::size_t i, std::size_t) {
    return s.alive.empty() ? std::uint8_t{1} : s.alive[i];
  }));
  a.cell.push_back(make_array<std::int32_t>(
      "Int32", "body", elements, 1, [&s](std::size_t i, std::size_t) { return s.body.empty() ? 0 : s.body[i]; }));

  a.points.push_back(make_array<double>("Float64", "Points", s.position.size(), 3,
                                        [&s](std::size_t i, std::size_t c) { return s.position[i][c]; }));
  a.cells.push_back(make_array<std::int32_t>("Int32", "connectivity", 8 * elements, 1,
                                             [&s](std::size_t i, std::size_t) { return s.hexahedra[i / 8][i % 8]; }));
  a.cells.push_back(make_array<std::int64_t>("Int64", "offsets", elements, 1,
                                             [](std::size_t i, std::size_t) { return 8 * (i + 1); }));
  constexpr int vtk_hexahedron = 12;
  a.cells.push_back(
      make_array<std::uint8_t>("UInt8", "types", elements, 1, [](std::size_t, std::size_t) { return vtk_hexahedron; }));
  return a;
}

/// Text that may stand in an XML comment.
std::string comment(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '-' && !safe.empty() && safe.back() == '-') safe += ' ';  // "--" would end it
    safe += c;
  }
  return fmt::format("<!-- {} -->\n", safe);
}

}  // namespace

void write_vtu(const std::string& path, const FieldSnapshot& snapshot, const std::vector<std::string>& fields,
               const std::string& units, const std::vector<std::string>& bodies) {
  check_sizes(path, snapshot);
  const Arrays arrays = list_arrays(snapshot, fields, bodies);

  // Offsets count from the byte after "_"; each block is its length (UInt64) and its bytes.
  std::string head = "<?xml version=\"1.0\"?>\n" + comment(units_line(units));
  std::vector<const DataArray*> blocks;
  std::uint64_t offset = 0;
  const auto section = [&](std::string_view name, const std::vector<DataArray>& list) {
    head += fmt::format("      <{}>\n", name);
    for (const DataArray& array : list) {
      head += fmt::format("        <DataArray {} format=\"appended\" offset=\"{}\"/>\n", array.attributes, offset);
      offset += sizeof(std::uint64_t) + array.bytes;
      blocks.push_back(&array);
    }
    head += fmt::format("      </{}>\n", name);
  };
  head +=
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "  <UnstructuredGrid>\n";
  section("FieldData", arrays.field);
  head += fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", snapshot.position.size(),
                      snapshot.hexahedra.size());
  section("PointData", arrays.point);
  section("CellData", arrays.cell);
  section("Points", arrays.points);
  section("Cells", arrays.cells);
  head += "    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_";

  OutputFile file(path);
  file.write(head);
  for (const DataArray* block : blocks) {
    file.write(&block->bytes, sizeof block->bytes);
    block->write(file);
  }
  file.write("\n  </AppendedData>\n</VTKFile>\n");
  file.commit();
}

FieldWriter::FieldWriter(std::string folder, std::string base_name, std::vector<std::string> fields, std::string units,
                         const Written& kept, std::vector<std::string> bodies)
    : folder_(std::move(folder)),
      base_name_(std::move(base_name)),
      fields_(std::move(fields)),
      units_(std::move(units)),
      bodies_(std::move(bodies)) {
  for (const std::string& field : fields_) {
    if (std::find(known_fields.begin(), known_fields.end(), field) == known_fields.end()) {
      throw InputError(fmt::format("output.fields: unknown field \"{}\", expected some of {}", field,
                                   fmt::join(known_fields, ", ")));
    }
  }
  make_folder(folder_);

  // What an earlier, longer run left would be opened together with ours.
  const std::string prefix = base_name_ + "_";
  std::vector<std::filesystem::path> stale = {in_folder(folder_, base_name_ + ".pvd")};
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.empty() ? "." : folder_, error)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() == ".vtu" && stem.size() > prefix.size() && stem.starts_with(prefix) &&
        std::all_of(stem.begin() + static_cast<std::ptrdiff_t>(prefix.size()), stem.end(),
                    [](char c) { return c >= '0' && c <= '9'; })) {
      stale.push_back(entry.path());
    }
  }
  for (const auto& file : kept) {
    const auto there =
        std::find_if(stale.begin(), stale.end(), [&file](const auto& path) { return path.filename() == file.second; });
    if (there == stale.end()) continue;
    stale.erase(there);
    written_.push_back(file);
  }
  next_number_ = kept.size();
  for (const auto& path : stale) std::filesystem::remove(path, error);
  if (!written_.empty()) write_list();
}

void FieldWriter::write(const FieldSnapshot& snapshot) {
  const std::string name = fmt::format("{}_{:04}.vtu", base_name_, next_number_++);
  write_vtu(in_folder(folder_, name), snapshot, fields_, units_, bodies_);
  written_.emplace_back(snapshot.time, name);
  write_list();
}

void FieldWriter::write_list() const {
  std::string text = "<?xml version=\"1.0\"?>\n" + comment(units_line(units_)) +
                     "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (const auto& [time, name] : written_) {
    text += fmt::format("    <DataSet timestep=\"{:.17g}\" group=\"\" part=\"0\" file=\"{}\"/>\n", time, name);
  }
  text += "  </Collection>\n</VTKFile>\n";
  OutputFile file(in_folder(folder_, base_name_ + ".pvd"));
  file.write(text);
  file.commit();
}

std::string write_last_good_state(const std::string& folder, const FieldSnapshot& snapshot, const std::string& units,
                                  const std::vector<std::string>& bodies) {
  make_folder(folder);
  std::string path = in_folder(folder, last_good_picture_name);
  write_vtu(path, snapshot, {}, units, bodies);
  return path;
}

}  // namespace pinball

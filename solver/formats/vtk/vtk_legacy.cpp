#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include <solver/base/error.hpp>
#include <solver/mesh/file/mesh_scanner.hpp>

#include "vtk_reader.hpp"
#include "vtk_values.hpp"

/// Format: "VTK File Formats", legacy; versions 1 to 5.1. Binary numbers have their highest byte first.
namespace pinball {
namespace {

constexpr std::int64_t most_points = std::numeric_limits<std::int32_t>::max() / 8;

/// "%20" is a space.
std::string decoded(std::string_view name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned code = 0;
    if (name[i] == '%' && i + 2 < name.size() &&
        std::from_chars(name.data() + i + 1, name.data() + i + 3, code, 16).ptr == name.data() + i + 3) {
      text += static_cast<char>(code);
      i += 2;
    } else {
      text += name[i];
    }
  }
  return text;
}

class LegacyReader {
 public:
  LegacyReader(std::string_view text, const std::string& name) : scan_(text, name) {}

  VtkGrid read() {
    read_head();
    while (!scan_.at_end()) read_section(std::string(scan_.word("a section such as POINTS")));
    if (!has_points_) scan_.fail("a section POINTS", "");
    if (grid_.ends.size() != grid_.types.size())
      scan_.fail(fmt::format("CELL_TYPES for {} cells", grid_.ends.size()), std::to_string(grid_.types.size()));
    if (grid_.types.empty()) scan_.fail("a section CELLS", "");
    return std::move(grid_);
  }

 private:
  enum class Data { none, cells, points };

  void read_head() {
    scan_.rest_of_line();
    scan_.rest_of_line();
    const std::string form(scan_.word("ASCII or BINARY"));
    if (form != "ASCII" && form != "BINARY") scan_.fail("ASCII or BINARY", form);
    if (form == "BINARY") scan_.set_binary();
    scan_.keyword("DATASET");
    const std::string kind(scan_.word("UNSTRUCTURED_GRID"));
    if (kind != "UNSTRUCTURED_GRID") scan_.fail("UNSTRUCTURED_GRID", kind);
  }

  void read_section(const std::string& name) {
    if (name == "POINTS") return read_points();
    if (name == "CELLS") return read_cells();
    if (name == "CELL_TYPES") return read_types();
    if (name == "CELL_DATA" || name == "POINT_DATA") return begin_data(name);
    if (name == "FIELD") return read_fields();
    if (name == "METADATA") return skip_metadata();
    if (name == "SCALARS") return read_scalars();
    if (name == "LOOKUP_TABLE") return skip_lookup_table();
    if (name == "COLOR_SCALARS") return skip_colours();
    if (name == "VECTORS" || name == "NORMALS") return read_array(3, false);
    if (name == "TENSORS") return read_array(9, false);
    if (name == "TENSORS6") return read_array(6, false);
    if (name == "GLOBAL_IDS") return read_array(1, true);
    if (name == "PEDIGREE_IDS") return read_array(1, false);
    if (name == "TEXTURE_COORDINATES") return read_texture();
    scan_.fail("a section such as POINTS, CELLS, CELL_TYPES, CELL_DATA or SCALARS", name);
  }

  VtkType type() {
    const std::string_view name = scan_.word("a type of numbers such as double");
    const auto type = vtk_type(name);
    if (!type) scan_.fail("a type of numbers such as int or double", name);
    return *type;
  }

  /// So many numbers, as T.
  template <class T>
  std::vector<T> values(std::int64_t count, VtkType type, const char* what) {
    std::vector<T> all;
    scan_.begin_data();
    scan_.require_room(count, size_of(type), 1, fmt::format("as many numbers ({})", what));
    if (scan_.binary()) {
      const std::size_t read = append_numbers(scan_.data_bytes(count * size_of(type), what), type,
                                              std::endian::native == std::endian::little, all);
      if (read != static_cast<std::size_t>(count)) scan_.fail(what, fmt::format("number {} out of range", read));
    } else {
      all.reserve(count);
      for (std::int64_t i = 0; i < count; ++i) {
        std::string_view word = scan_.word(what);
        const std::string_view whole = word;
        if (!append_word(word, all)) scan_.fail(what, whole);
      }
    }
    scan_.end_data();
    return all;
  }

  void skip(std::int64_t count, VtkType type) {
    scan_.begin_data();
    scan_.require_room(count, size_of(type), 1, "as many numbers");
    if (scan_.binary()) {
      scan_.data_bytes(count * size_of(type), "numbers");
    } else {
      for (std::int64_t i = 0; i < count; ++i) scan_.word("a number");
    }
    scan_.end_data();
  }

  std::int64_t small_count(const char* what, std::int64_t most) {
    const std::int64_t count = scan_.count(what);
    if (count > most) scan_.fail(fmt::format("{} that is at most {}", what, most), std::to_string(count));
    return count;
  }

  void read_points() {
    if (has_points_) scan_.fail("one section POINTS", "another one");
    has_points_ = true;
    const std::int64_t count = small_count("the number of points", most_points);
    const std::vector<double> x = values<double>(3 * count, type(), "a coordinate of a point");
    grid_.points.resize(count);
    for (std::int64_t i = 0; i < 3 * count; ++i) grid_.points[i / 3][i % 3] = x[i];
  }

  void read_cells() {
    if (!grid_.ends.empty()) scan_.fail("one section CELLS", "another one");
    const std::int64_t first = small_count("the number of cells", most_points),
                       second = small_count("the number of integers of the cells", std::int64_t{1} << 33);
    if (scan_.next_line_begins("OFFSETS")) return read_offsets(first, second);
    const std::vector<std::int32_t> all = values<std::int32_t>(second, VtkType::i32, "an integer of a cell");
    std::int64_t at = 0;
    for (std::int64_t cell = 0; cell < first; ++cell) {
      const std::int64_t points = at < second ? all[at++] : -1;
      if (points < 0 || points > second - at)
        scan_.fail(fmt::format("{} cells within {} integers", first, second), fmt::format("{}", cell));
      grid_.connectivity.insert(grid_.connectivity.end(), all.begin() + at, all.begin() + at + points);
      grid_.ends.push_back(grid_.connectivity.size());
      at += points;
    }
  }

  /// Since version 5.1: where each cell begins, and the points of all.
  void read_offsets(std::int64_t offsets, std::int64_t points) {
    scan_.keyword("OFFSETS");
    std::vector<std::int64_t> begins = values<std::int64_t>(offsets, type(), "the offset of a cell");
    scan_.keyword("CONNECTIVITY");
    grid_.connectivity = values<std::int32_t>(points, type(), "a point of a cell");
    if (begins.empty() || begins.front() != 0 || begins.back() != points || !std::ranges::is_sorted(begins))
      scan_.fail(fmt::format("offsets from 0 to {}, ascending", points), "others");
    grid_.ends.assign(begins.begin() + 1, begins.end());
  }

  void read_types() {
    if (!grid_.types.empty()) scan_.fail("one section CELL_TYPES", "another one");
    const std::int64_t count = small_count("the number of cells", most_points);
    const auto all = values<std::int32_t>(count, VtkType::i32, "the type of a cell");
    for (const std::int32_t type : all) {
      if (type < 0 || type > 255) scan_.fail("a type of cells from 0 to 255", std::to_string(type));
      grid_.types.push_back(type);
    }
  }

  void begin_data(const std::string& name) {
    data_ = name == "CELL_DATA" ? Data::cells : Data::points;
    tuples_ = scan_.count("the number of cells or points");
    const std::size_t expected = data_ == Data::cells ? grid_.ends.size() : grid_.points.size();
    if (tuples_ != static_cast<std::int64_t>(expected))
      scan_.fail(fmt::format("data of {} {}", expected, data_ == Data::cells ? "cells" : "points"),
                 std::to_string(tuples_));
  }

  void add(const std::string& name, std::int64_t components, std::int64_t tuples, VtkType type, bool numbers) {
    if (components > 0 && tuples > (std::int64_t{1} << 40) / components)
      scan_.fail("an array of numbers", std::to_string(tuples));
    if (data_ == Data::none || components != 1 || !is_integer(type) || tuples != tuples_)
      return skip(components * tuples, type);
    grid_.arrays.push_back({name, data_ == Data::cells, numbers, values<std::int64_t>(tuples, type, "an integer")});
  }

  void read_array(std::int64_t components, bool numbers) {
    const std::string name = decoded(scan_.word("the name of an array"));
    add(name, components, tuples_, type(), numbers);
  }

  void read_scalars() {
    const std::string name = decoded(scan_.word("the name of an array"));
    const VtkType numbers = type();
    const std::string_view more = scan_.rest_of_line();
    std::vector<std::int64_t> components;
    std::string_view rest = more;
    if (!append_word(rest, components)) components.assign(1, 1);
    if (components[0] < 1 || components[0] > 4) scan_.fail("1 to 4 components", more);
    scan_.keyword("LOOKUP_TABLE");
    scan_.word("the name of a lookup table");
    add(name, components[0], tuples_, numbers, false);
  }

  void read_texture() {
    const std::string name = decoded(scan_.word("the name of an array"));
    const std::int64_t components = small_count("the number of texture coordinates", 3);
    add(name, components, tuples_, type(), false);
  }

  void skip_lookup_table() {
    scan_.word("the name of a lookup table");
    const std::int64_t count = small_count("the size of a lookup table", std::int64_t{1} << 40);
    skip(4 * count, scan_.binary() ? VtkType::u8 : VtkType::f32);
  }

  void skip_colours() {
    scan_.word("the name of an array");
    const std::int64_t components = small_count("the number of components", 4);
    skip(components * tuples_, scan_.binary() ? VtkType::u8 : VtkType::f32);
  }

  void read_fields() {
    scan_.word("the name of the fields");
    const std::int64_t count = scan_.count("the number of fields");
    for (std::int64_t i = 0; i < count; ++i) {
      std::string name(scan_.word("the name of a field"));
      if (name == "METADATA") {
        skip_metadata();
        name = scan_.word("the name of a field");
      }
      const std::int64_t components = small_count("the number of components", std::int64_t{1} << 30),
                         tuples = scan_.count("the number of tuples");
      const std::string text = decoded(name);
      add(text, components, tuples, type(), text == "GlobalElementId" || text == "GlobalNodeId");
    }
  }

  /// Names and such of the array before: up to an empty line.
  void skip_metadata() {
    scan_.rest_of_line();
    while (!scan_.rest_of_line().empty()) {
    }
  }

  MeshScanner scan_;
  VtkGrid grid_;
  bool has_points_ = false;
  Data data_ = Data::none;
  std::int64_t tuples_ = 0;
};

}  // namespace

VtkGrid parse_vtk_legacy(const std::string& bytes, const std::string& name) { return LegacyReader(bytes, name).read(); }

}  // namespace pinball

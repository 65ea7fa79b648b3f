#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>

#include <solver/base/error.hpp>

#include "vtk_reader.hpp"
#include "vtk_values.hpp"
#include "vtu_data.hpp"

#ifdef PINBALL_PUGIXML
#include <pugixml.hpp>
#endif

/// Format: "VTK XML File Formats", UnstructuredGrid.
namespace pinball {

#ifdef PINBALL_PUGIXML

namespace {

constexpr std::int64_t most_points = std::numeric_limits<std::int32_t>::max() / 8;
constexpr std::string_view appended_tag = "<AppendedData";

class VtuReader {
 public:
  /// The text of the file up to its appended data is parsed in its place.
  VtuReader(std::string& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  VtkGrid read() {
    parse();
    const pugi::xml_node file = document_.child("VTKFile");
    if (!file) fail(document_, "expected <VTKFile>");
    read_head(file);
    const pugi::xml_node grid = file.child("UnstructuredGrid");
    if (!grid) fail(file, "expected <UnstructuredGrid>");
    if (!grid.child("Piece")) fail(grid, "expected <Piece>");
    for (const pugi::xml_node piece : grid.children("Piece")) read_piece(piece);
    for (const VtkArray& array : grid_.arrays) {
      const std::size_t expected = array.of_cells ? grid_.types.size() : grid_.points.size();
      if (array.values.size() != expected) fail(grid, fmt::format("expected array {} in every <Piece>", array.name));
    }
    return std::move(grid_);
  }

 private:
  void parse() {
    const std::size_t appended = bytes_.find(appended_tag), end = bytes_.find('>', appended);
    pugi::xml_parse_result result;
    if (appended == std::string::npos || end == std::string::npos) {
      result = document_.load_buffer_inplace(bytes_.data(), bytes_.size(), pugi::parse_escapes);
    } else {
      // What is appended is no XML where it is raw. What comes before it is short.
      head_ = bytes_.substr(0, end + 1) + "</AppendedData></VTKFile>";
      result = document_.load_buffer_inplace(head_.data(), head_.size(), pugi::parse_escapes);
      appended_ = std::string_view(bytes_).substr(end + 1);
      const std::size_t mark = appended_.find('_');
      if (mark == std::string_view::npos) throw InputError(name_ + ": expected \"_\" before the appended data");
      appended_.remove_prefix(mark + 1);
    }
    if (!result)
      throw InputError(
          fmt::format("{}:{}: not well-formed XML: {}", name_, line_at(result.offset), result.description()));
  }

  std::ptrdiff_t line_at(std::ptrdiff_t offset) const {
    const std::string& text = head_.empty() ? bytes_ : head_;
    const auto end = text.begin() + std::clamp<std::ptrdiff_t>(offset, 0, text.size());
    return 1 + std::count(text.begin(), end, '\n');
  }

  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& problem) const {
    const std::string_view array = node.attribute("Name").value();
    throw InputError(fmt::format("{}:{}: {}{}", name_, line_at(node.offset_debug()),
                                 array.empty() ? "" : fmt::format("array {}: ", array), problem));
  }

  void read_head(const pugi::xml_node& file) {
    const std::string_view type = file.attribute("type").value(), order = file.attribute("byte_order").value(),
                           compressor = file.attribute("compressor").value(),
                           header = file.attribute("header_type").value();
    if (type != "UnstructuredGrid") fail(file, fmt::format("expected type UnstructuredGrid, got \"{}\"", type));
    const bool little = std::endian::native == std::endian::little;
    if (!order.empty() && order != (little ? "LittleEndian" : "BigEndian"))
      fail(file, fmt::format("expected numbers in the byte order of this machine, got {}", order));
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
      fail(file, fmt::format("expected no compressor, or vtkZLibDataCompressor, got {}", compressor));
    encoding_.compressed = !compressor.empty();
    if (!header.empty() && header != "UInt32" && header != "UInt64")
      fail(file, fmt::format("expected header_type UInt32 or UInt64, got {}", header));
    encoding_.wide_header = header == "UInt64";
    const std::string_view encoding = file.child("AppendedData").attribute("encoding").value();
    if (!encoding.empty() && encoding != "raw" && encoding != "base64")
      fail(file, fmt::format("expected appended data as raw or base64, got {}", encoding));
    appended_base64_ = encoding != "raw";
  }

  std::int64_t count_of(const pugi::xml_node& piece, const char* attribute) const {
    std::vector<std::int64_t> count;
    std::string_view text = piece.attribute(attribute).value();
    if (!append_word(text, count) || count[0] < 0 || count[0] > most_points)
      fail(piece, fmt::format("expected {}, a number up to {}, got \"{}\"", attribute, most_points,
                              piece.attribute(attribute).value()));
    return count[0];
  }

  void read_piece(const pugi::xml_node& piece) {
    const std::int64_t points = count_of(piece, "NumberOfPoints"), cells = count_of(piece, "NumberOfCells");
    const std::int64_t first_point = grid_.points.size();
    if (first_point + points > most_points) fail(piece, "has more points than a mesh can hold");
    read_points(piece, points);
    read_cells(piece, cells, first_point);
    read_arrays(piece.child("CellData"), true, cells);
    read_arrays(piece.child("PointData"), false, points);
  }

  void read_points(const pugi::xml_node& piece, std::int64_t count) {
    const pugi::xml_node array = piece.child("Points").child("DataArray");
    if (!array) fail(piece, "expected <Points> with a <DataArray>");
    std::vector<double> x;
    read_values(array, 3 * count, x);
    const std::size_t first = grid_.points.size();
    grid_.points.resize(first + count);
    for (std::int64_t i = 0; i < 3 * count; ++i) grid_.points[first + i / 3][i % 3] = x[i];
  }

  void read_cells(const pugi::xml_node& piece, std::int64_t count, std::int64_t first_point) {
    const pugi::xml_node cells = piece.child("Cells");
    std::vector<std::int64_t> ends;
    read_values(array_of(cells, "offsets"), count, ends);
    const std::int64_t before = grid_.connectivity.size();
    if (!std::ranges::is_sorted(ends) ||
        (!ends.empty() && (ends.front() < 0 || ends.back() > most_points * 8 - before)))
      fail(array_of(cells, "offsets"), "expected numbers that ascend");
    read_values(array_of(cells, "connectivity"), ends.empty() ? 0 : ends.back(), grid_.connectivity);
    for (std::size_t i = before; first_point > 0 && i < grid_.connectivity.size(); ++i) {
      if (grid_.connectivity[i] < 0)
        fail(array_of(cells, "connectivity"), "expected points of the piece, got a negative number");
      grid_.connectivity[i] += first_point;
    }
    for (const std::int64_t end : ends) grid_.ends.push_back(before + end);
    read_types(array_of(cells, "types"), count);
  }

  void read_types(const pugi::xml_node& array, std::int64_t count) {
    std::vector<std::int32_t> types;
    read_values(array, count, types);
    for (const std::int32_t type : types) {
      if (type < 0 || type > 255) fail(array, fmt::format("expected types of cells from 0 to 255, got {}", type));
      grid_.types.push_back(type);
    }
  }

  pugi::xml_node array_of(const pugi::xml_node& parent, const char* name) const {
    for (const pugi::xml_node array : parent.children("DataArray")) {
      if (std::string_view(array.attribute("Name").value()) == name) return array;
    }
    fail(parent, fmt::format("expected a <DataArray> of the name {}", name));
  }

  /// Integers, one for each cell or point.
  void read_arrays(const pugi::xml_node& parent, bool of_cells, std::int64_t count) {
    const std::string_view own = parent.attribute("GlobalIds").value();
    for (const pugi::xml_node array : parent.children("DataArray")) {
      const auto type = vtk_type(array.attribute("type").value());
      const std::string_view components = array.attribute("NumberOfComponents").value();
      if (!type || !is_integer(*type) || !(components.empty() || components == "1")) continue;
      const std::string name = array.attribute("Name").value();
      const bool numbers = (!own.empty() && own == name) || name == (of_cells ? "GlobalElementId" : "GlobalNodeId");
      auto found = std::ranges::find_if(
          grid_.arrays, [&](const VtkArray& known) { return known.name == name && known.of_cells == of_cells; });
      if (found == grid_.arrays.end()) found = grid_.arrays.insert(found, {name, of_cells, numbers, {}});
      read_values(array, count, found->values);
    }
  }

  /// Adds so many numbers.
  template <class T>
  void read_values(const pugi::xml_node& array, std::int64_t count, std::vector<T>& to) const {
    const auto type = vtk_type(array.attribute("type").value());
    if (!type) fail(array, fmt::format("expected a type such as Float64, got \"{}\"", array.attribute("type").value()));
    const std::string_view format = array.attribute("format").value();
    if (format == "ascii" || format.empty()) return read_text(array, count, to);
    if (format != "binary" && format != "appended")
      fail(array, fmt::format("expected format ascii, binary or appended, got \"{}\"", format));
    std::string whole, problem;
    const std::size_t expected = count * size_of(*type);
    const std::string_view data =
        format == "binary" ? vtu_bytes(inline_text(array), true, encoding_, expected, whole, problem)
                           : vtu_bytes(appended_text(array), appended_base64_, encoding_, expected, whole, problem);
    if (!problem.empty()) fail(array, problem);
    const std::size_t read = append_numbers(data, *type, false, to);
    if (read != static_cast<std::size_t>(count)) fail(array, fmt::format("number {} is out of range", read));
  }

  template <class T>
  void read_text(const pugi::xml_node& array, std::int64_t count, std::vector<T>& to) const {
    std::string_view text = array.child_value();
    if (count > (std::ssize(text) + 1) / 2)
      fail(array, fmt::format("expected {} numbers, got no more than {}", count, (text.size() + 1) / 2));
    to.reserve(to.size() + count);
    for (std::int64_t i = 0; i < count; ++i) {
      if (!append_word(text, to))
        fail(array, fmt::format("expected {} numbers, number {} is none, or out of range", count, i));
    }
    if (text.find_first_not_of(" \t\r\n") != std::string_view::npos)
      fail(array, fmt::format("expected {} numbers, got more", count));
  }

  static std::string_view inline_text(const pugi::xml_node& array) {
    const std::string_view text = array.child_value();
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first == std::string_view::npos ? std::string_view() : text.substr(first);
  }

  std::string_view appended_text(const pugi::xml_node& array) const {
    std::vector<std::int64_t> offset;
    std::string_view text = array.attribute("offset").value();
    if (!append_word(text, offset) || offset[0] < 0 || offset[0] > std::ssize(appended_))
      fail(array, fmt::format("expected an offset within the {} bytes of appended data, got \"{}\"", appended_.size(),
                              array.attribute("offset").value()));
    return appended_.substr(offset[0]);
  }

  std::string& bytes_;
  const std::string& name_;
  std::string head_;
  std::string_view appended_;
  bool appended_base64_ = true;
  VtuEncoding encoding_;
  pugi::xml_document document_;
  VtkGrid grid_;
};

}  // namespace

VtkGrid parse_vtu(std::string& bytes, const std::string& name) { return VtuReader(bytes, name).read(); }

#else

VtkGrid parse_vtu(std::string&, const std::string& name) {
  throw InputError(name +
                   ": this program was built without pugixml, which .vtu meshes need: install libpugixml-dev "
                   "(apt-get install libpugixml-dev, or pugixml of another system) and build it again");
}

#endif

}  // namespace pinball

#include "field_frame.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <cstring>
#include <memory>
#include <type_traits>

#include <solver/base/error.hpp>
#include <solver/output/field_arrays.hpp>

namespace pinball {
namespace {

using InputFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void throw_unreadable(const std::string& what) { throw RunError("cannot read " + what); }

std::uint64_t whole_number(std::string_view text, std::uint64_t otherwise) {
  std::uint64_t number = otherwise;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

FieldFrame::Array described(std::string_view section, std::string_view attributes) {
  FieldFrame::Array array;
  array.section = section;
  array.name = xml_attribute(attributes, "Name");
  array.type = xml_attribute(attributes, "type");
  array.components = whole_number(xml_attribute(attributes, "NumberOfComponents"), 1);
  return array;
}

/// All up to the "_" behind which data begin.
std::string head_of(std::FILE* file, const std::string& path) {
  constexpr std::string_view end = "<AppendedData encoding=\"raw\">\n_";
  std::string head;
  while (head.size() < (1U << 20)) {
    const std::size_t before = head.size();
    head.resize(before + 8192);
    head.resize(before + std::fread(head.data() + before, 1, 8192, file));
    const auto found = head.find(end);
    if (found != std::string::npos) return head.substr(0, found + end.size());
    if (head.size() == before) break;
  }
  throw_unreadable(path + ": expected a file of field output");
}

void read_block(const std::string& path, std::uint64_t begin, std::uint64_t bytes, char* to) {
  const InputFile file(std::fopen(path.c_str(), "rb"), &std::fclose);
  std::uint64_t there = 0;
  const bool done = file && std::fseek(file.get(), static_cast<long>(begin), SEEK_SET) == 0 &&
                    std::fread(&there, sizeof there, 1, file.get()) == 1 && there == bytes &&
                    std::fread(to, 1, bytes, file.get()) == bytes;
  if (!done) throw_unreadable(path);
}

/// Length of the data at a place of the file.
std::uint64_t length_at(std::FILE* file, std::uint64_t begin, const std::string& path) {
  std::uint64_t length = 0;
  const bool done =
      std::fseek(file, static_cast<long>(begin), SEEK_SET) == 0 && std::fread(&length, sizeof length, 1, file) == 1;
  if (!done) throw_unreadable(path + ": it is cut short");
  return length;
}

template <class T>
constexpr std::string_view vtk_type() {
  if constexpr (std::is_same_v<T, float>) return "Float32";
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "UInt8";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  return "Int64";
}

}  // namespace

std::string_view xml_attribute(std::string_view text, std::string_view name) {
  const std::string begin = fmt::format(" {}=\"", name);
  const auto from = text.find(begin);
  if (from == std::string_view::npos) return {};
  const auto value = text.substr(from + begin.size());
  return value.substr(0, value.find('"'));
}

FieldFrame FieldFrame::of_file(const std::string& path) {
  return path.ends_with(".pvtu") ? of_pieces(path) : of_one_file(path);
}

FieldFrame FieldFrame::of_one_file(const std::string& path) {
  const InputFile file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw_unreadable(path);
  const std::string head = head_of(file.get(), path);
  FieldFrame frame;
  std::string section;
  for (std::size_t at = head.find('<'); at != std::string::npos; at = head.find('<', at + 1)) {
    const std::string_view tag = std::string_view(head).substr(at + 1, head.find('>', at) - at - 1);
    for (const char* name : {"FieldData", "PointData", "CellData", "Points", "Cells"}) {
      if (tag == name || tag.starts_with(std::string(name) + ' ')) section = name;
    }
    if (!tag.starts_with("DataArray ")) continue;
    const std::uint64_t begin = head.size() + whole_number(xml_attribute(tag, "offset"), 0);
    Array array = described(section, tag);
    array.bytes = length_at(file.get(), begin, path);
    array.read = [path, begin, bytes = array.bytes](char* to) { read_block(path, begin, bytes, to); };
    frame.arrays_.push_back(std::move(array));
  }
  return frame;
}

FieldFrame FieldFrame::of_snapshot(const FieldSnapshot& snapshot, const FieldBase& base) {
  FieldFrame frame;
  const FieldArrays arrays = list_arrays(snapshot, base, {}, {});
  const auto add = [&frame](const char* section, const std::vector<DataArray>& list) {
    for (const DataArray& one : list) {
      Array array = described(section, ' ' + one.attributes);
      array.bytes = one.bytes;
      array.read = [write = one.write](char* to) {
        write([&to](const void* data, std::size_t bytes) {
          std::memcpy(to, data, bytes);
          to += bytes;
        });
      };
      frame.arrays_.push_back(std::move(array));
    }
  };
  add("PointData", arrays.point);
  add("CellData", arrays.cell);
  add("Points", arrays.points);
  add("Cells", arrays.cells);
  return frame;
}

const FieldFrame::Array* FieldFrame::find(std::string_view name) const {
  for (const Array& array : arrays_) {
    if (array.name == name) return &array;
  }
  return nullptr;
}

template <class T>
std::vector<T> FieldFrame::read(std::string_view name) const {
  const Array* const array = find(name);
  if (array == nullptr || array->type != vtk_type<T>() || array->bytes % sizeof(T) != 0) {
    throw_unreadable(fmt::format("the field {} of an output time", name));
  }
  std::vector<T> numbers(array->bytes / sizeof(T));
  array->read(reinterpret_cast<char*>(numbers.data()));
  return numbers;
}

template std::vector<float> FieldFrame::read(std::string_view) const;
template std::vector<double> FieldFrame::read(std::string_view) const;
template std::vector<std::uint8_t> FieldFrame::read(std::string_view) const;
template std::vector<std::int32_t> FieldFrame::read(std::string_view) const;
template std::vector<std::int64_t> FieldFrame::read(std::string_view) const;

}  // namespace pinball

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <solver/field_base.hpp>
#include <solver/results.hpp>

namespace pinball {

/// What a tag says: NAME="..."; empty where it does not.
std::string_view xml_attribute(std::string_view tag, std::string_view name);

/// The arrays of one output time by the names and with the numbers that a .vtu file has (FieldWriter).
class FieldFrame {
 public:
  struct Array {
    std::string section;  ///< PointData, CellData, ...
    std::string name, type;
    std::size_t components = 1;
    std::uint64_t bytes = 0;
    std::function<void(char* to)> read;  ///< all its bytes
  };

  /// Of a file that FieldWriter has written, or of all pieces that one lists; numbers are read from it when they are
  /// asked for. Throws RunError that names the file.
  static FieldFrame of_file(const std::string& path);
  /// Refers to both.
  static FieldFrame of_snapshot(const FieldSnapshot& snapshot, const FieldBase& base);

  const std::vector<Array>& arrays() const { return arrays_; }
  bool has(std::string_view name) const { return find(name) != nullptr; }
  /// T: what the file has it as (float, double, std::uint8_t, std::int32_t, std::int64_t). Throws RunError where it is
  /// not there, or something else.
  template <class T>
  std::vector<T> read(std::string_view name) const;

 private:
  static FieldFrame of_one_file(const std::string& path);
  static FieldFrame of_pieces(const std::string& path);
  const Array* find(std::string_view name) const;

  std::vector<Array> arrays_;
};

}  // namespace pinball

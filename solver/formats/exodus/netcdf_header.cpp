#include "netcdf_header.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

#include <solver/base/error.hpp>

/// Format: "NetCDF Classic Format Specification" in the user's guide of netCDF; all numbers have their highest byte
/// first.
namespace pinball {
namespace {

constexpr std::uint32_t dimension_tag = 10, variable_tag = 11, attribute_tag = 12;

/// Bytes of a number of a type; 0: there is no such type.
std::uint64_t size_of(std::uint64_t type) {
  constexpr std::uint64_t sizes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
  return type < std::size(sizes) ? sizes[type] : 0;
}

class Header {
 public:
  explicit Header(const std::string& path)
      : path_(path), file_(path, std::ios::binary), left_(std::filesystem::file_size(path)), size_(left_) {}

  void check() {
    char magic[4]{};
    file_.read(magic, 4);
    if (!file_ || std::string_view(magic, 3) != "CDF") return;  // another format, which libnetcdf judges
    if (magic[3] != 1 && magic[3] != 2 && magic[3] != 5) fail("is a netCDF file of an unknown format");
    version_ = magic[3];
    left_ -= 4;
    records_ = count();
    if (version_ != 5 && records_ == 0xffffffff) records_ = 0;  // written as a stream
    read_dimensions();
    skip_attributes();
    read_variables();
    if (end() > size_)
      fail(fmt::format("is cut short: its variables end at byte {}, and it has {} bytes", end(), size_));
  }

 private:
  struct Variable {
    std::uint64_t begin, bytes;
    bool of_records;
  };

  [[noreturn]] void fail(const std::string& problem) const { throw InputError(path_ + ": " + problem); }

  std::uint64_t number(int bytes) {
    unsigned char text[8]{};
    if (left_ < static_cast<std::uint64_t>(bytes) || !file_.read(reinterpret_cast<char*>(text), bytes))
      fail("is cut short: the header of a netCDF file is not complete");
    left_ -= bytes;
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8 | text[i];
    return value;
  }
  std::uint64_t count() { return number(version_ == 5 ? 8 : 4); }

  void skip(std::uint64_t bytes) {
    if (bytes > left_) fail("is cut short: the header of a netCDF file is not complete");
    left_ -= bytes;
    file_.seekg(bytes, std::ios::cur);
  }
  static std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }
  void skip_name() {
    const std::uint64_t length = count();
    if (length > left_) fail("has a damaged header: a name is longer than the file");
    skip(padded(length));
  }

  /// Number of the things of a list.
  std::uint64_t list(std::uint32_t tag) {
    const std::uint64_t found = number(4), length = count();
    if (found != tag && (found != 0 || length != 0)) fail("has a damaged header: expected a list");
    if (length > left_) fail("has a damaged header: a list is longer than the file");
    return length;
  }

  void read_dimensions() {
    for (std::uint64_t left = list(dimension_tag); left > 0; --left) {
      skip_name();
      dimensions_.push_back(count());
    }
  }

  void skip_attributes() {
    for (std::uint64_t left = list(attribute_tag); left > 0; --left) {
      skip_name();
      const std::uint64_t bytes = size_of(number(4)), length = count();
      if (bytes == 0 || length > left_) fail("has a damaged header: an attribute is longer than the file");
      skip(padded(bytes * length));
    }
  }

  void read_variables() {
    for (std::uint64_t left = list(variable_tag); left > 0; --left) {
      skip_name();
      Variable variable{0, 1, false};
      const std::uint64_t rank = count();
      if (rank > left_) fail("has a damaged header: a variable has too many dimensions");
      for (std::uint64_t d = 0; d < rank; ++d) {
        const std::uint64_t dimension = count();
        if (dimension >= dimensions_.size()) fail("has a damaged header: a variable has a dimension that is not there");
        if (d == 0 && dimensions_[dimension] == 0) {
          variable.of_records = true;
        } else {
          multiply(variable.bytes, dimensions_[dimension]);
        }
      }
      skip_attributes();
      const std::uint64_t bytes = size_of(number(4));
      if (bytes == 0) fail("has a damaged header: a variable has an unknown type");
      multiply(variable.bytes, bytes);
      count();  // its size, which is wrong in files of more than 4 GB
      variable.begin = number(version_ == 1 ? 4 : 8);
      variables_.push_back(variable);
    }
  }

  void multiply(std::uint64_t& product, std::uint64_t factor) const {
    if (factor != 0 && product > size_ / factor) fail("is cut short, or damaged: a variable is longer than the file");
    product *= factor;
  }

  /// Byte after the last one of the data.
  std::uint64_t end() const {
    std::uint64_t record = 0, records = 0, last = 0;
    for (const Variable& v : variables_) {
      if (v.of_records) record += padded(v.bytes), ++records;
    }
    for (const Variable& v : variables_) {
      if (v.bytes == 0 || (v.of_records && records_ == 0)) continue;
      // A record of one variable alone is not padded.
      const std::uint64_t step = records == 1 ? v.bytes : record;
      if (v.begin > size_ || (v.of_records && step > 0 && records_ - 1 > size_ / step)) return ~std::uint64_t{0};
      last = std::max(last, v.begin + v.bytes + (v.of_records ? (records_ - 1) * step : 0));
    }
    return last;
  }

  std::string path_;
  std::ifstream file_;
  std::uint64_t left_, size_, records_ = 0;
  int version_ = 0;
  std::vector<std::uint64_t> dimensions_;
  std::vector<Variable> variables_;
};

}  // namespace

void check_netcdf_header(const std::string& path) { Header(path).check(); }

}  // namespace pinball

#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace pinball {

/// A netCDF file to be read, through libnetcdf: classic formats and, where that library has it, HDF5. Everything that
/// reads throws InputError "PATH: variable NAME: ...". Variables are no longer than what the file can hold. One thread
/// at a time has such files: neither library knows of threads.
class NetcdfFile {
 public:
  explicit NetcdfFile(const std::string& path);
  ~NetcdfFile();
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  const std::string& path() const { return path_; }
  /// Length of a dimension; 0: there is none of the name.
  std::int64_t dimension(const std::string& name) const;
  bool has(const std::string& variable) const;
  std::vector<std::int64_t> shape(const std::string& variable) const;

  std::vector<double> numbers(const std::string& variable) const;
  std::vector<std::int64_t> integers(const std::string& variable) const;
  /// Into an array that has room for the whole variable.
  void integers_into(const std::string& variable, std::int32_t* to) const;
  /// Rows of characters, up to the first zero of each.
  std::vector<std::string> texts(const std::string& variable) const;
  std::string attribute(const std::string& variable, const std::string& name) const;

  [[noreturn]] void fail(const std::string& variable, const std::string& problem) const;

 private:
  int number_of(const std::string& variable) const;
  std::int64_t length(const std::string& variable) const;
  void require(int status, const std::string& variable) const;

  std::unique_lock<std::recursive_mutex> turn_;
  std::string path_;
  int file_ = -1;
  std::int64_t most_ = 0;  ///< numbers that a variable may have
};

}  // namespace pinball

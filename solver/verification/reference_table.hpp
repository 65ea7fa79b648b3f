#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pinball {

/// A table of numbers with named columns, from a file of data/reference.
class ReferenceTable {
 public:
  /// Reads NAME of the folder "reference" beside that of a scene. Throws InputError that names the file, and the line
  /// of what is no number.
  ReferenceTable(const std::string& scene_path, const std::string& name);

  std::size_t rows() const { return rows_; }
  /// Throws InputError that names the file if it has no such column.
  const std::vector<double>& column(const std::string& name) const;

 private:
  std::string path_;
  std::size_t rows_ = 0;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace pinball

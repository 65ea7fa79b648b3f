#include "reference_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <solver/base/error.hpp>

namespace pinball {

ReferenceTable::ReferenceTable(const std::string& scene_path, const std::string& name)
    : path_((std::filesystem::path(scene_path).parent_path() / ".." / "reference" / name).lexically_normal().string()) {
  std::ifstream file(path_);
  std::string line, cell;
  if (!std::getline(file, line)) throw InputError(fmt::format("{}: no such file, or it is empty", path_));
  std::istringstream head(line);
  while (std::getline(head, cell, ',')) names_.push_back(cell);
  columns_.resize(names_.size());
  while (std::getline(file, line)) {
    ++rows_;
    std::istringstream cells(line);
    for (auto& column : columns_) {
      char* end = nullptr;
      if (std::getline(cells, cell, ',')) column.push_back(std::strtod(cell.c_str(), &end));
      if (end == nullptr || end == cell.c_str()) {
        throw InputError(fmt::format("{}:{}: expected {} numbers", path_, rows_ + 1, names_.size()));
      }
    }
  }
}

const std::vector<double>& ReferenceTable::column(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) throw InputError(fmt::format("{}: expected a column {}", path_, name));
  return columns_[found - names_.begin()];
}

}  // namespace pinball

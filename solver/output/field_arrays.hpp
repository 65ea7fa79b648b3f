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

/// Takes bytes, a piece after the other.
using ByteSink = std::function<void(const void* data, std::size_t bytes)>;

/// Names of the arrays that say of the nodes and elements of a piece where they are in the scene.
inline constexpr std::string_view node_places = "GlobalNodeId", element_places = "GlobalElementId";

/// One <DataArray>: what the head of the file says of it, and how its bytes are made.
struct DataArray {
  std::string attributes;
  std::uint64_t bytes = 0;
  std::function<void(const ByteSink&)> write;
};

/// Those of one .vtu file, by the part that they stand in. They read what they were listed from.
struct FieldArrays {
  std::vector<DataArray> field, point, cell, points, cells;
  std::string point_attributes{}, cell_attributes{};  ///< of the parts: which array has the places in the scene
};

/// Of a snapshot: fields as in OutputSettings::fields, empty for all; names of the bodies.
FieldArrays list_arrays(const FieldSnapshot& snapshot, const FieldBase& base, const std::vector<std::string>& fields,
                        const std::vector<std::string>& bodies);

/// Throws RunError for an array that is there but of another length than the mesh: no reader would take the file.
void check_sizes(const std::string& path, const FieldSnapshot& snapshot, const FieldBase& base);

}  // namespace pinball

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <solver/field_base.hpp>
#include <solver/results.hpp>

#include "field_arrays.hpp"

namespace pinball {

/// A part of a mesh with its fields, which one of several ranks writes.
struct FieldPiece {
  FieldSnapshot snapshot;
  std::vector<Point> initial;
  FieldBase base;  ///< `initial` is that of this piece; with the places in the scene
};

/// The elements of a rank, in the order of the scene, and their nodes. rank_of_element: of each of all.
FieldPiece cut_piece(const FieldSnapshot& all, const FieldBase& base, const std::vector<std::int32_t>& rank_of_element,
                     std::int32_t rank);

/// Of the file: BASE_0000_0.vtu.
std::string piece_name(const std::string& base, std::int64_t number, std::int32_t rank);

/// Writes the list of all pieces (a .pvtu file, for ParaView) and what they hold. arrays: of any of them; sources:
/// their files, as they are found from the folder of this one. Throws RunError that names the file.
void write_list_of_pieces(const std::string& path, const FieldArrays& arrays, const std::string& units,
                          const std::vector<std::string>& sources);

}  // namespace pinball

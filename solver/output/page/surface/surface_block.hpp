#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "run_surface.hpp"

namespace pinball {

/// Characters of text that surfaces may take in a page: a page of 6 MB has room for them.
inline constexpr std::size_t most_surface_characters = 4'500'000;
/// Codes of fields: 0 to highest_code, and of what has no value.
inline constexpr int highest_code = 4094;
inline constexpr unsigned no_value_code = 0xffff;

/// JSON of a surface for the viewer of a page: what it is (times, bodies by their names, fields with lowest value, step
/// and range of colours), and its numbers as base64. Positions are steps of 1/65000 of what the body takes of an axis
/// at most, values of fields steps of 1/4094 of their range: what is read differs by half a step at most. Where the
/// text would be longer than `most`, it has fewer times; the last where it has one. "null" where not even that fits.
std::string surface_json(const RunSurface& surface, const std::vector<std::string>& bodies,
                         std::size_t most = most_surface_characters);

/// The same; {"error": why} where it cannot be shown. Does not throw.
std::string surface_json_of_frames(const FrameSource& source, const std::vector<std::string>& bodies);

/// The same of the fields that a run has written to a folder, and where there are none, of its last state (null: not
/// known). "null": there is nothing to show.
std::string surface_json_of_run(const std::string& folder, const std::vector<std::string>& bodies,
                                const FieldSnapshot* last, const FieldBase* base);

}  // namespace pinball

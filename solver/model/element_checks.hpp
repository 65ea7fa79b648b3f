#pragma once

#include <array>
#include <string>

#include <solver/scene.hpp>

/// What makes an element useless before the first step, as the end of a sentence that begins with its name; empty where
/// nothing does.
namespace pinball {

/// Inverted or flat, or with volumes that the precision cannot hold. Of an element that lies so far from the origin
/// that its shape cannot be known this says nothing: rounding_problem does.
std::string volume_problem(const std::array<Point, 8>& corners, Precision precision);

/// Too far from the origin for its size (mesh_rounding.hpp).
std::string rounding_problem(const std::array<Point, 8>& corners, Precision precision);

}  // namespace pinball

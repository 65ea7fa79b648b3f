#pragma once

#include <string>

#include "other_history.hpp"

namespace pinball {

/// Whether these bytes begin as a T01 file of Radioss does.
bool is_t01(const std::string& bytes);

/// Histories of a T01 file, as engines of Radioss and OpenRadioss write it (TFILE of type 4): global quantities, and
/// displacements and velocities of the nodes of /TH/NODE. The kinetic energy has that of rotations in it, which the
/// file has apart. A state that is not whole, at the end, is left out. Throws InputError that names the file and the
/// byte.
void read_t01(const std::string& bytes, OtherHistory& history);

}  // namespace pinball

#pragma once

#include <string>

#include "other_history.hpp"

namespace pinball {

/// Whether these bytes begin as a binout of LS-DYNA does, whose form is called LSDA.
bool is_binout(const std::string& bytes);

/// Of a binout: quantities of glstat, displacements and velocities of nodout. Where they are written at other times
/// each has no number at those of the other. A record that is not whole, at the end, is left out. Throws InputError
/// that names the file and the byte.
void read_binout(const std::string& bytes, OtherHistory& history);

}  // namespace pinball

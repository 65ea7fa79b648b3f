#pragma once

#include <string>

#include "other_history.hpp"

namespace pinball {

/// Whether these bytes begin as a d3plot of LS-DYNA does.
bool is_d3plot(const std::string& bytes);

/// Of a d3plot and the files that go on with it beside it, d3plot01 and so on: energies and velocities of the whole,
/// displacements and velocities of all nodes by the numbers of the deck. Of states with more than most_kept numbers in
/// all every second is kept, or every third and so on, and the last; kind says so. A state that is not whole, at the
/// end, is left out. bytes: of the first file. Throws InputError that names the file and what is not read of it.
void read_d3plot(const std::string& bytes, OtherHistory& history);

/// Numbers of nodes that read_d3plot keeps, of all states together.
inline constexpr double most_kept = 4e7;

}  // namespace pinball

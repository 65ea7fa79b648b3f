#pragma once

#include <string>
#include <vector>

#include "other_history.hpp"

namespace pinball {

/// Whether these lines are the tables that CalculiX writes for *NODE PRINT and *EL PRINT, its .dat.
bool is_calculix_dat(const std::vector<std::string>& lines);

/// A table for each quantity, set and time, with a line for each node or integration point. Curves:
/// node_N_displacement_x and the like of velocities, SET_force_x of total forces, element_N_stress_xx and
/// element_N_plastic_strain as means over the integration points. Throws InputError for a line that is no row of its
/// table, and for a time that is none.
void read_calculix_dat(const std::vector<std::string>& lines, OtherHistory& history);

}  // namespace pinball

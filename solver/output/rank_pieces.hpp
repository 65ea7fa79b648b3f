#pragma once

#include <string>

#include <solver/simulation.hpp>

#include "field_output.hpp"

namespace pinball {

/// On rank 0 of several: all of them write their piece of the fields (answer_with_piece), and then it lists them.
/// Throws RunError with what the first has to say that could not write its own.
void write_pieces(Simulation& simulation, FieldWriter& fields);

/// What the others do when rank 0 asks for pieces. folder: of the run.
RankAnswer answer_with_piece(const std::string& folder);

}  // namespace pinball

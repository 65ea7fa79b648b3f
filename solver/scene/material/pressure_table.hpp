#pragma once

#include <optional>
#include <vector>

#include <solver/scene_rules.hpp>

namespace pinball {

/// Of a tabulated equation of state: A, B and K over the strain of its volume_measure, here ln(1 + mu), straight from
/// where it begins.
struct TablePiece {
  double strain;                     ///< ln(1 + mu) at its beginning [-]
  double cold, cold_rise;            ///< A there, dA/d ln(1 + mu) [stress]
  double thermal, thermal_rise;      ///< B there, dB/d ln(1 + mu) [-]
  double unloading, unloading_rise;  ///< K there, dK/d ln(1 + mu), of what crushes [stress]
};

/// By rising ln(1 + mu). eos: without a problem.
std::vector<TablePiece> pieces_of_table(const EquationOfStateSettings& eos);

std::optional<Problem> problem_of_table(const EquationOfStateSettings& eos);

/// Of two pieces that meet at rest the stiffer one's; 0: the table is none [stress].
double bulk_modulus_of_table(const EquationOfStateSettings& eos);

}  // namespace pinball

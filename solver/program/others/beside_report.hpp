#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include <solver/program/comparison.hpp>

#include "other_history.hpp"

/// What a comparison shows of histories of other programs.
namespace pinball {

/// For each history a table with a line per quantity that both have (and variant, where there are several): both values
/// at the last common time and how far they are apart; the nodes that both number at the end of the run; and the names
/// of what is not compared.
std::string beside_table(const std::vector<VariantRuns>& runs, const std::vector<OtherHistory>& others);

/// [{file, kind, times, first_time, last_time, quantities [{name, columns, variants [{time, here, there, difference,
/// largest_difference, largest_time, root_mean_square}]}], last_state [per variant {time, and of displacement and
/// velocity of nodes by number {nodes, longest, largest_difference, largest_node, root_mean_square}}], not_compared
/// [names]}]; differences are shares of the largest size there, null where that is zero.
nlohmann::ordered_json beside_json(const std::vector<VariantRuns>& runs, const std::vector<OtherHistory>& others);

/// What the page draws: [{file, there, here}], curves (curves_json) of the quantities that both have: of the other
/// program, and of each variant at the times of its rows.
std::string beside_curves_json(const std::vector<VariantRuns>& runs, const std::vector<OtherHistory>& others);

}  // namespace pinball

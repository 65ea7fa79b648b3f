#pragma once

#include <string>

#include "error_costs.hpp"

/// What a study shows of time against error.
namespace pinball {

/// The error that settings are named for: that of the limits, else 1 %.
double error_of_report(const ConvergenceStudy& study);

/// "mesh 3/2, float: 0.35 s, 1.2 MB, errs by 0.8 %".
std::string cost_text(const CostPoint& point, double error);

/// What settings reach an error in the quantity, or why none is known to, and what it could be at best: "for 1 % of
/// tail_position_z [mm] take mesh 3/2, float: 0.35 s, 1.2 MB, errs by 0.8 %; finer than 0.02 % is chance". Empty: it
/// has no band.
std::string cost_sentence(const ConvergenceStudy& study, const std::vector<CostPoint>& points, std::size_t quantity);

/// Of a search: what reaches the error in all quantities, or the best in the time; empty: there was none.
std::string search_sentence(const ConvergenceStudy& study);

/// A sentence for each quantity with a band, and where there are few of them a line for each run; empty: there is none.
std::string costs_text(const ConvergenceStudy& study);

}  // namespace pinball

#pragma once

#include <string>
#include <vector>

#include "comparison.hpp"
#include "others/other_history.hpp"

/// What a comparison shows. runs: at least one variant, each with the same number of repeats.
namespace pinball {

/// A line per quantity, a column per variant.
std::string comparison_table(const std::vector<VariantRuns>& runs);

/// The same and all times of each repeat: {scene, version, machine {cpu, threads, simd_width}, repeats,
/// variants [{settings, failure, seconds, contact_share, first_over_this, momentum_error, summary, repeats}]}.
/// `summary` is summary.json without times; numbers that are not known are null. With others it has `beside`, too
/// (others/beside_report.hpp).
std::string comparison_json(const std::vector<VariantRuns>& runs, const std::vector<OtherHistory>& others = {});

/// A page to be opened in a browser: the table, and the curves of the variants and of others over each other.
std::string comparison_page(const std::vector<VariantRuns>& runs, const std::vector<OtherHistory>& others = {});

}  // namespace pinball

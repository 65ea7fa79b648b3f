#pragma once

#include <string>

#include "base/export.h"
#include "results.hpp"

namespace pinball {

/// The text of summary.json, indented, with a line break at its end. A number that is NaN or infinite becomes null;
/// state_hash is a string of 16 hexadecimal digits; element_steps_per_second = elements * steps / wall_seconds.
PINBALL_API std::string summary_json(const RunSummary& summary);

/// Writes FOLDER/summary.json; it appears complete or not at all. converged: JSON for the key of that name, which is
/// not there where it is empty. Throws RunError that names the file.
void write_summary(const std::string& folder, const RunSummary& summary, const std::string& converged = {});

}  // namespace pinball

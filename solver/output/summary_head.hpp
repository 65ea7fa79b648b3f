#pragma once

#include <string>

#include <solver/results.hpp>

namespace pinball {

/// The text of summary.json while a run goes on, and of one that failed before its first step: the keys up to `nodes`,
/// which are null until the mesh is built. Numbers of the start are not there: nobody takes them for results.
std::string summary_head_json(const RunSummary& summary);

}  // namespace pinball

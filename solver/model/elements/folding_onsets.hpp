#pragma once

#include <vector>

#include <solver/model/model.hpp>

namespace pinball {

/// From which share of the mean on the corners of each element resist turning over (kernels/folding.hpp) [-]: half of
/// what its least corner has at the start, at most the usual onset; 0, where a corner is turned over then: nothing
/// resists. Empty: the usual onset for all.
std::vector<double> folding_onsets(const ModelMesh& mesh);

}  // namespace pinball

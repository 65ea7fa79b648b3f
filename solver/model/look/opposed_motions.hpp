#pragma once

#include <string>
#include <vector>

#include <solver/model/model.hpp>

namespace pinball {

/// Prescribed velocities that some of their nodes do not have, since a constraint or an earlier one gives these another
/// along the same direction: a sentence for each two of them.
std::vector<std::string> opposed_motions(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball

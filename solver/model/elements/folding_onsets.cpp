#include "folding_onsets.hpp"

#include <algorithm>

#include <kernels/folding.hpp>
#include <solver/base/hexahedron_of_points.hpp>

namespace pinball {

std::vector<double> folding_onsets(const ModelMesh& mesh) {
  // A copy: a variable template that a reference is bound to is visible outside a library, whatever GCC 12 is told.
  constexpr double usual = folding_onset<double>;
  std::vector<double> onsets;
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    const double share = least_corner_share(mesh.corners(e));
    if (share >= 2 * usual) continue;
    if (onsets.empty()) onsets.assign(mesh.hexahedra.size(), usual);
    onsets[e] = std::max(0.0, 0.5 * share);
  }
  return onsets;
}

}  // namespace pinball

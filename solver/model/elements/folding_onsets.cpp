#include "folding_onsets.hpp"

#include <algorithm>

#include <kernels/folding.hpp>
#include <solver/base/hexahedron_of_points.hpp>
#include <solver/base/lists_in_order.hpp>

namespace pinball {

std::vector<double> folding_onsets(const ModelMesh& mesh) {
  // A copy: a variable template that a reference is bound to is visible outside a library, whatever GCC 12 is told.
  constexpr double usual = folding_onset<double>;
  const auto share = [&](std::int64_t e) { return least_corner_share(mesh.corners(e)); };
  std::vector<std::int32_t> near_folding;
  list_where("corners", mesh.element_count(), near_folding, [&](std::int64_t e) { return !(share(e) >= 2 * usual); });
  std::vector<double> onsets(near_folding.empty() ? 0 : mesh.hexahedra.size(), usual);
  for (const std::int32_t e : near_folding) onsets[e] = std::max(0.0, 0.5 * share(e));
  return onsets;
}

}  // namespace pinball

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
  const std::int64_t count = mesh.element_count();
  if (first_where("corners", count, [&](std::int64_t e) { return !(share(e) >= 2 * usual); }) == count) return {};
  std::vector<double> onsets(count, usual);
  parallel_for("onsets of folding", RangePolicy<>{0, count}, [&](std::int64_t e) {
    if (const double own = share(e); !(own >= 2 * usual)) onsets[e] = std::max(0.0, 0.5 * own);
  });
  return onsets;
}

}  // namespace pinball

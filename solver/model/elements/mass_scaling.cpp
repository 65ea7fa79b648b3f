#include "mass_scaling.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include <solver/base/error.hpp>
#include <solver/model/place_names.hpp>

#include "element_start.hpp"

namespace pinball {

std::vector<double> mass_factors(const Scene& scene, const ModelMesh& mesh, const ElementParts& parts) {
  const TimeSettings& time = scene.time;
  if (!(time.smallest_step > 0)) return {};
  std::vector<double> factors(mesh.hexahedra.size(), 1.0);
  for (std::size_t e = 0; e < factors.size(); ++e) {
    const ElementPart& part = parts.parts[parts.part_of(mesh, e)];
    if (part.rigid) continue;
    const ElementStart start = element_start(mesh, e, scene.materials[part.material], part);
    const double factor = start.mass_factor(time.smallest_step / time.cfl);
    if (!(factor > 0) || !std::isfinite(factor)) {
      throw InputError(fmt::format("{}time.smallest_step: expected a step for which {} can have a mass, got {:.9g}",
                                   message_head(scene), element_name(mesh, e), time.smallest_step));
    }
    factors[e] = time.mass_scaling == MassScaling::all ? factor : std::max(1.0, factor);
  }
  if (std::ranges::all_of(factors, [](double factor) { return factor == 1; })) factors.clear();
  return factors;
}

}  // namespace pinball

#include "require_built.hpp"

#include <fmt/core.h>

#include <solver/base/built_features.hpp>
#include <solver/base/error.hpp>

namespace pinball {

template <class S>
void require_built(const Model<S>& model, bool with_boundary_conditions) {
  const auto require = [&](bool is_built, bool needed, const char* feature, const char* setting) {
    if (is_built || !needed) return;
    throw InputError(fmt::format("{}: expected {}: this program was built without {} (PINBALL_WITHOUT)",
                                 model.scene.path, setting, feature));
  };
  for (const Part& part : model.parts) {
    const ElementFeatures& f = part.features;
    require(built::erosion, f.erosion, "erosion", "no erosion_strain and no element.negative_volume=\"erode\"");
    require(built::plasticity, f.plastic, "plasticity", "elastic materials");
    require(built::bulk_viscosity, f.bulk_viscosity, "bulk viscosity", "element.bulk_viscosity=false");
    require(built::hourglass, f.hourglass != HourglassKind::none, "hourglass control", "element.hourglass=\"none\"");
  }
  require(built::contact, model.scene.contact.method != ContactMethod::none, "contact", "contact.method=\"none\"");
  require(built::boundary_conditions, with_boundary_conditions, "boundary conditions",
          "no constraints, prescribed velocities, loads, pressures, damping or rigid walls");
  require(built::resting, model.scene.skip.resting, "leaving out tiles at rest", "skip.resting=false");
}

template void require_built(const Model<double>&, bool);
template void require_built(const Model<float>&, bool);

}  // namespace pinball

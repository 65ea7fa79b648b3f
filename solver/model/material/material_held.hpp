#pragma once

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include <solver/base/error.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// Throws InputError for a material whose numbers are not finite, or next to nothing, in the precision of the run.
template <class S>
void require_held(const Scene& scene, const Material& material, const ElementConstants<S>& constants) {
  const auto require = [&](const char* key, double given, S held) {
    if (held >= std::numeric_limits<S>::min() && held <= std::numeric_limits<S>::max()) return;
    throw InputError(fmt::format("{}material.{}: {} = {:.6g} is beyond {} precision: expected other units{}",
                                 message_head(scene), material.name, key, given,
                                 sizeof(S) == sizeof(double) ? "double" : "single",
                                 sizeof(S) == sizeof(double) ? "" : ", or precision = \"double\""));
  };
  const double modulus = material.bulk_modulus + 4.0 / 3.0 * material.shear_modulus;
  require("bulk_modulus", material.bulk_modulus, static_cast<S>(material.bulk_modulus));
  if (!material.fluid) require("shear_modulus", material.shear_modulus, constants.material.mu);
  require("density", material.density, constants.material.density);
  require("1/density", 1 / material.density, constants.specific_volume);
  require("velocity of waves", std::sqrt(modulus / material.density), constants.material.sound_speed);
}

}  // namespace pinball

#include "model_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <solver/base/built_features.hpp>
#include <solver/scene_rules.hpp>

#include "material/material_held.hpp"
#include "material/material_laws.hpp"

namespace pinball {

namespace {

template <class S>
ElementConstants<S> constants_of(const Material& material, const ElementSettings& settings) {
  const double lambda = material.bulk_modulus - 2.0 / 3.0 * material.shear_modulus;
  const double modulus = lambda + 2 * material.shear_modulus;
  const double infinite = std::numeric_limits<double>::infinity();
  ElementConstants<S> c{};
  c.material.lambda = static_cast<S>(lambda);
  c.material.mu = static_cast<S>(material.shear_modulus);
  c.material.yield_stress = static_cast<S>(material.plastic ? material.yield_stress : infinite);
  c.material.plastic_modulus = static_cast<S>(material.plastic_modulus);
  c.material.ultimate_stress = static_cast<S>(material.ultimate_stress > 0 ? material.ultimate_stress : infinite);
  c.material.density = static_cast<S>(material.density);
  c.material.sound_speed = static_cast<S>(std::sqrt(modulus / material.density));
  const bool resists = settings.hourglass != HourglassControl::none;
  c.hourglass.coefficient = static_cast<S>(resists ? settings.hourglass_coefficient : 0.0);
  c.hourglass.assumed_strain = assumed_strain_moduli(c.material.lambda, c.material.mu, c.hourglass.coefficient);
  c.hourglass.modulus = c.hourglass.coefficient * hourglass_modulus(c.material.lambda, c.material.mu);
  c.specific_volume = static_cast<S>(1 / material.density);
  if (settings.bulk_viscosity) {
    c.viscosity.linear = static_cast<S>(settings.linear_viscosity);
    c.viscosity.quadratic = static_cast<S>(settings.quadratic_viscosity);
  }
  const NegativeVolume policy =
      settings.negative_volume.value_or(erodes(material) ? NegativeVolume::erode : NegativeVolume::stop);
  c.failure.plastic_strain = static_cast<S>(material.erosion_strain > 0 ? material.erosion_strain : infinite);
  c.failure.negative_volume = policy == NegativeVolume::erode;
  c.failure.inside_out = settings.inside_out == InsideOut::erode;
  // What does not yield has hourglass forces that resist.
  if (material.plastic) {
    c.folding_energy = static_cast<S>(settings.folding_resistance * material.bulk_modulus / (8 * material.density));
  }
  c.never_yields = !material.plastic;
  return c;
}

HourglassKind hourglass_kind(HourglassControl control) {
  switch (control) {
    case HourglassControl::assumed_strain:
      return HourglassKind::assumed_strain;
    case HourglassControl::stiffness:
      return HourglassKind::stiffness;
    case HourglassControl::viscous:
      return HourglassKind::viscous;
    case HourglassControl::none:
      break;
  }
  return HourglassKind::none;
}

/// erodes_anyway: for a reason other than its material's.
ElementFeatures features_of(const Material& material, const ElementSettings& settings, bool erodes_anyway) {
  ElementFeatures f{};
  f.erosion = erodes_anyway || erodes(material);
  // There is no kernel for erosion, nor for a general law, without plasticity.
  f.plastic = material.plastic || f.erosion || has_general_yield(material);
  f.bulk_viscosity = settings.bulk_viscosity;
  f.hourglass = hourglass_kind(settings.hourglass);
  if (has_general_yield(material)) f.yield = YieldLaw::general;
  return f;
}

/// Kernels of the general law alone know averaged volumes; one works all tetrahedra (tetrahedron_update.hpp).
void average_volumes(ElementFeatures& f, WorkedShape shape) {
  f.plastic = true;
  f.yield = YieldLaw::general;
  if (shape != WorkedShape::tetrahedron) return;
  f.tetrahedra = true;
  f.hourglass = HourglassKind::none;
}

/// Elements without hourglass control have the kernels of the viscous form (elements/element_features.hpp), but none of
/// its numbers.
bool stores_modes(const ElementFeatures& f) {
  return built::hourglass && !f.tetrahedra && f.hourglass != HourglassKind::none;
}

bool averages_volumes(const ElementPart& part) { return part.shape != WorkedShape::hexahedron; }

/// Constants of a part, with the curves that they point to, which are put into `curves`.
template <class E>
ElementConstants<E> constants_with_laws(const Scene& scene, const ElementPart& part,
                                        std::vector<std::shared_ptr<const YieldCurves<E>>>& curves) {
  const Material& material = scene.materials[part.material];
  ElementConstants<E> c = constants_of<E>(material, part.settings);
  require_held(scene, material, c);
  if (part.rigid || !(has_general_yield(material) || averages_volumes(part))) return c;
  c.averaged_volumes = averages_volumes(part);
  curves.push_back(std::make_shared<const YieldCurves<E>>(yield_curves<E>(material)));
  c.hardening = hardening_constants(material, *curves.back());
  c.johnson_cook = johnson_cook_constants<E>(material);
  c.brittle = brittle_constants<E>(material);
  c.granular = granular_constants<E>(material);
  c.foam = foam_constants<E>(material);
  c.rubber = rubber_constants<E>(material);
  c.ogden = ogden_constants<E>(material);
  c.orthotropic = orthotropic_constants<E>(material);
  c.fluid = fluid_constants<E>(material);
  c.pressure = pressure_constants<E>(material);
  c.places = material_places(material);
  return c;
}

}  // namespace

template <class S>
ElementStoreFeatures add_parts(Model<S>& model, const ElementParts& parts) {
  ElementStoreFeatures stored;
  for (const ElementPart& part : parts.parts) {
    const Material& material = model.scene.materials[part.material];
    model.constants.push_back(constants_with_laws(model.scene, part, model.yield_curves));
    if (is_mixed<S>(model.scene)) {
      model.single_constants.push_back(constants_with_laws(model.scene, part, model.single_yield_curves));
    }
    const ElementConstants<S>& constants = model.constants.back();
    const auto number = static_cast<std::int32_t>(part.material);
    if (part.rigid) {
      model.parts.push_back({number, {}, part.settings, true});
      continue;
    }
    stored.material_numbers = std::max(stored.material_numbers, constants.places.numbers);
    const FailureConstants<S>& failure = constants.failure;
    ElementFeatures f = features_of(material, part.settings, failure.negative_volume || failure.inside_out);
    if (averages_volumes(part)) average_volumes(f, part.shape);
    model.parts.push_back({number, f, part.settings});
    stored.plastic |= f.plastic;
    stored.erosion |= f.erosion;
    stored.bulk_viscosity |= f.bulk_viscosity;
    stored.hourglass_state |= stores_modes(f);
    stored.volume_ratio |= averages_volumes(part);
  }
  return stored;
}

template ElementStoreFeatures add_parts(Model<double>&, const ElementParts&);
template ElementStoreFeatures add_parts(Model<float>&, const ElementParts&);

}  // namespace pinball

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <solver/scene_rules.hpp>

namespace pinball {

namespace {

std::optional<Problem> problem_of_hardening(const Material& m) {
  const bool ends = m.ultimate_stress > 0 && std::isfinite(m.ultimate_stress);
  if (ends && m.ultimate_stress < m.yield_stress) {
    return Problem{"ultimate_stress",
                   fmt::format("expected a number >= yield_stress = {}, got {}", m.yield_stress, m.ultimate_stress)};
  }
  if (m.isotropic_share < 1 && ends) {
    return Problem{"ultimate_stress", fmt::format("expected none beside isotropic_share = {}", m.isotropic_share)};
  }
  if (m.isotropic_share < 1 && !m.yield_curves.empty()) {
    return Problem{"isotropic_share",
                   fmt::format("expected 1 beside yield curves, got {}: with them the yield surface only grows",
                               m.isotropic_share)};
  }
  if (!m.yield_curves.empty() && (m.plastic_modulus > 0 || ends)) {
    return Problem{ends ? "ultimate_stress" : "plastic_modulus", "expected none beside yield curves"};
  }
  return {};
}

std::optional<Problem> problem_of_power(const Material& m) {
  const PowerHardeningSettings& power = *m.power_hardening;
  const bool ends = m.ultimate_stress > 0 && std::isfinite(m.ultimate_stress);
  const char* const other = !m.yield_curves.empty() ? "yield_curves"
                            : m.plastic_modulus > 0 ? "plastic_modulus"
                            : ends                  ? "ultimate_stress"
                            : m.isotropic_share < 1 ? "isotropic_share"
                                                    : nullptr;
  if (other != nullptr) return Problem{other, "expected none beside power_hardening"};
  // e_0 has to be a number also in single precision, and so has the slope there.
  const double strain = std::pow(m.yield_stress / power.coefficient, 1 / power.exponent);
  if (strain >= 1e-12 && strain < 1e12) return {};
  return Problem{"power_hardening.coefficient",
                 fmt::format("expected one for which (yield_stress/coefficient)^(1/exponent), the strain at which the "
                             "power begins, is within 1e-12 and 1e12, got {} and {:.6g}",
                             power.coefficient, strain)};
}

/// Hardening or rates beside a law that has its own; none: nullptr.
const char* other_hardening(const Material& m) {
  const bool ends = m.ultimate_stress > 0 && std::isfinite(m.ultimate_stress);
  return !m.yield_curves.empty() ? "yield_curves"
         : m.plastic_modulus > 0 ? "plastic_modulus"
         : ends                  ? "ultimate_stress"
         : m.isotropic_share < 1 ? "isotropic_share"
         : m.rate_constant > 0   ? "rate_constant"
         : m.power_hardening     ? "power_hardening"
                                 : nullptr;
}

/// What is wrong with a table of a material, by the name that its key has there.
std::optional<Problem> inside(const char* table, std::optional<Problem> problem) {
  if (problem) problem->key = fmt::format("{}.{}", table, problem->key);
  return problem;
}

/// What gives a strength beside the law of that name; none: null.
const char* other_strength(const Material& m, std::string_view own) {
  const std::pair<const char*, bool> all[] = {{"yield_stress", m.yield_stress > 0},
                                              {"johnson_cook", m.johnson_cook.has_value()},
                                              {"johnson_holmquist", m.johnson_holmquist.has_value()},
                                              {"drucker_prager", m.drucker_prager.has_value()},
                                              {"crushable_foam", m.crushable_foam.has_value()},
                                              {"fluid", m.fluid.has_value()}};
  for (const auto& [name, is_there] : all) {
    if (is_there && own != name) return name;
  }
  return other_hardening(m);
}

/// What stands beside such a law, and the part that is wrong in itself.
std::optional<Problem> problem_of_johnson_cook(const Material& m) {
  const char* const other = other_hardening(m);
  if (other != nullptr) return Problem{other, "expected none beside johnson_cook"};
  return inside("johnson_cook", problem_of(*m.johnson_cook));
}

/// The same of a brittle one.
std::optional<Problem> problem_of_johnson_holmquist(const Material& m) {
  const char* const other = m.equation_of_state ? "equation_of_state" : other_strength(m, "johnson_holmquist");
  if (other != nullptr) return Problem{other, "expected none beside johnson_holmquist"};
  if (m.strain_rate == StrainRate::plastic) {
    return Problem{"strain_rate", "expected \"total\" or \"deviatoric\" beside johnson_holmquist"};
  }
  return inside("johnson_holmquist", problem_of(*m.johnson_holmquist, m.bulk_modulus));
}

/// The same of one whose strength is of the pressure alone.
std::optional<Problem> problem_of_drucker_prager(const Material& m) {
  const char* const other = other_strength(m, "drucker_prager");
  if (other != nullptr) return Problem{other, "expected none beside drucker_prager"};
  return inside("drucker_prager", problem_of(*m.drucker_prager));
}

/// The same of a foam.
std::optional<Problem> problem_of_crushable_foam(const Material& m) {
  const char* const other = m.equation_of_state ? "equation_of_state" : other_strength(m, "crushable_foam");
  if (other != nullptr) return Problem{other, "expected none beside crushable_foam"};
  return inside("crushable_foam", problem_of(*m.crushable_foam));
}

/// What stands beside a fluid that only solids have, and what it needs.
std::optional<Problem> problem_of_fluid(const Material& m) {
  const char* const other = m.erosion_strain > 0 ? "erosion_strain" : other_strength(m, "fluid");
  if (other != nullptr) return Problem{other, "expected none beside fluid, which has no strength"};
  if (!m.equation_of_state) return Problem{"equation_of_state", "missing, expected the pressure of the fluid"};
  if (m.shear_modulus > 0) return Problem{"shear_modulus", "expected none beside fluid, which has no strength"};
  return {};
}

std::optional<Problem> problem_of_equation_of_state(const Material& m) {
  return inside("equation_of_state", problem_of(*m.equation_of_state));
}

/// A pressure is no plasticity: model = "elastic", which turns that off, would leave another one, of bulk_modulus
/// alone.
std::optional<Problem> problem_of_elastic(const Material& m) {
  const auto& brittle = m.johnson_holmquist;
  const bool bends = brittle && (brittle->quadratic_modulus != 0 || brittle->cubic_modulus != 0);
  const char* const key = m.fluid               ? "fluid"
                          : m.equation_of_state ? "equation_of_state"
                          : bends               ? "johnson_holmquist"
                                                : nullptr;
  if (key == nullptr) return {};
  return Problem{key,
                 "expected model = \"von_mises\" beside it, got \"elastic\", whose pressure is of bulk_modulus alone"};
}

std::optional<Problem> problem_of_erosion(const Material& m) {
  if (const auto problem = inside("erosion", problem_of(*m.erosion))) return problem;
  const auto beyond = [&](const char* key, double limit) {
    return Problem{"erosion.tension",
                   fmt::format("expected a number < {} = {}, beyond which there is no tension, got {}", key, limit,
                               m.erosion->tension)};
  };
  if (m.equation_of_state && !m.equation_of_state->bears_tension && m.erosion->tension > 0) {
    return Problem{"erosion.tension", "expected 0 beside equation_of_state.bears_tension = false: there is no tension"};
  }
  const double limit = m.equation_of_state ? m.equation_of_state->tension_limit : 0;
  if (limit > 0 && m.erosion->tension >= limit) return beyond("equation_of_state.tension_limit", limit);
  if (const auto& law = m.johnson_holmquist;
      law && m.erosion->tension > 0 && m.erosion->tension >= law->tensile_strength)
    return beyond("johnson_holmquist.tensile_strength", law->tensile_strength);
  return {};
}

std::optional<Problem> problem_of_rates(const Material& m) {
  if (m.rate_constant > 0 && !(m.rate_exponent > 0)) {
    return Problem{"rate_exponent", "expected a number > 0 beside rate_constant"};
  }
  if (m.rate_constant > 0 && m.yield_curves.size() > 1) {
    return Problem{"rate_constant",
                   fmt::format("expected 0 beside yield curves of several rates, got {}", m.rate_constant)};
  }
  if (m.rate_stress > 0 && !(m.rate_constant > 0)) {
    return Problem{"rate_stress", "expected 0 without rate_constant"};
  }
  return {};
}

/// Of curve number c of a material.
std::optional<Problem> problem_of_curve(const Material& m, std::size_t c) {
  const YieldCurve& curve = m.yield_curves[c];
  if (const auto problem = problem_of(curve)) {
    return Problem{fmt::format("yield_curves.{}.{}", c, problem->key), problem->text};
  }
  for (std::size_t k = 1; k < curve.stress.size(); ++k) {
    const double slope =
        (curve.stress[k] - curve.stress[k - 1]) / (curve.plastic_strain[k] - curve.plastic_strain[k - 1]);
    if (slope > -3 * m.shear_modulus) continue;
    return Problem{m.yield_curves.size() > 1 ? "yield_curves" : "yield_curve",
                   fmt::format("expected slopes > -3 shear_modulus = {:.6g}, got {:.6g} behind plastic strain {:.6g}",
                               -3 * m.shear_modulus, slope, curve.plastic_strain[k - 1])};
  }
  if (m.yield_curves.size() == 1) return {};
  if (!(curve.rate >= 0) || !std::isfinite(curve.rate)) {
    return Problem{"yield_curves", fmt::format("expected rates >= 0, got {}", curve.rate)};
  }
  if (m.rate_interpolation == RateInterpolation::logarithmic && !(curve.rate > 0)) {
    return Problem{"yield_curves",
                   fmt::format("expected rates > 0 for rate_interpolation = \"logarithmic\", got {}", curve.rate)};
  }
  if (c > 0 && !(curve.rate > m.yield_curves[c - 1].rate)) {
    return Problem{"yield_curves", fmt::format("expected curves of ascending rates, got {} after {}", curve.rate,
                                               m.yield_curves[c - 1].rate)};
  }
  return {};
}

}  // namespace

std::optional<Problem> problem_of(const Material& material) {
  if (!material.plastic) {
    if (const auto problem = problem_of_elastic(material)) return problem;
  }
  if (const auto problem = problem_of_hardening(material)) return problem;
  for (std::size_t c = 0; c < material.yield_curves.size(); ++c) {
    if (const auto problem = problem_of_curve(material, c)) return problem;
  }
  if (const auto problem = problem_of_rates(material)) return problem;
  // Without a yield stress, before what begins at one.
  if (material.fluid) {
    if (const auto problem = problem_of_fluid(material)) return problem;
  }
  if (material.johnson_holmquist) {
    if (const auto problem = problem_of_johnson_holmquist(material)) return problem;
  }
  if (material.drucker_prager) {
    if (const auto problem = problem_of_drucker_prager(material)) return problem;
  }
  if (material.crushable_foam) {
    if (const auto problem = problem_of_crushable_foam(material)) return problem;
  }
  if (material.power_hardening) {
    if (const auto problem = problem_of_power(material)) return problem;
  }
  if (const auto& rubber = material.mooney_rivlin; rubber && !(rubber->a + rubber->b > 0)) {
    return Problem{"mooney_rivlin.a", fmt::format("expected a + b > 0, got {}", rubber->a + rubber->b)};
  }
  if (material.ogden) {
    if (material.mooney_rivlin) return Problem{"mooney_rivlin", "expected none beside ogden"};
    if (material.orthotropic) return Problem{"orthotropic", "expected none beside ogden"};
    if (const auto problem = inside("ogden", problem_of(*material.ogden))) return problem;
  }
  if (material.orthotropic) {
    if (material.mooney_rivlin) return Problem{"mooney_rivlin", "expected none beside orthotropic"};
    if (const auto problem = inside("orthotropic", problem_of(*material.orthotropic))) return problem;
  }
  if (material.johnson_cook) {
    if (const auto problem = problem_of_johnson_cook(material)) return problem;
  }
  if (material.equation_of_state) {
    if (const auto problem = problem_of_equation_of_state(material)) return problem;
  }
  return material.erosion ? problem_of_erosion(material) : std::nullopt;
}

double shear_modulus_of(const OgdenSettings& law) {
  double sum = 0;
  for (std::size_t p = 0; p < std::min(law.moduli.size(), law.exponents.size()); ++p)
    sum += law.moduli[p] * law.exponents[p];
  return sum / 2;
}

std::optional<Problem> problem_of(const OgdenSettings& law) {
  constexpr std::size_t most = OgdenSettings::most_terms;
  if (law.moduli.empty() || law.moduli.size() > most) {
    return Problem{"moduli", fmt::format("expected 1 to {} numbers, got {}", most, law.moduli.size())};
  }
  if (law.exponents.size() != law.moduli.size()) {
    return Problem{"exponents", fmt::format("expected one number for each of the {} moduli, got {}", law.moduli.size(),
                                            law.exponents.size())};
  }
  if (std::ranges::count(law.exponents, 0.0) > 0) return Problem{"exponents", "expected numbers that are not 0, got 0"};
  if (const double shear = shear_modulus_of(law); !(shear > 0)) {
    return Problem{"moduli",
                   fmt::format("expected a shear modulus, half the sum of moduli times exponents, > 0, got {}", shear)};
  }
  return {};
}

std::optional<Problem> problem_of(const Body& body, const Scene& scene) {
  const auto material = std::ranges::find(scene.materials, body.material, &Material::name);
  if (material == scene.materials.end()) return {};
  if (scene.time.subcycling && material->crushable_foam && material->crushable_foam->damping > 0) {
    return Problem{
        "material",
        fmt::format("expected time.subcycling = false with {}, whose crushable_foam has a damping: levels of "
                    "steps do not know of it",
                    material->name)};
  }
  if (!material->fluid) return {};
  if (scene.time.subcycling && material->fluid->viscosity > 0) {
    return Problem{
        "material",
        fmt::format("expected time.subcycling = false with {}, which is fluid: levels of steps do not know of "
                    "its viscosity",
                    material->name)};
  }
  const HourglassControl control = (body.element ? *body.element : scene.element).hourglass;
  if (control == HourglassControl::viscous || control == HourglassControl::none) return {};
  return Problem{"material",
                 fmt::format("expected elements with element.hourglass = \"viscous\" or \"none\" of {}, which "
                             "is fluid: other forms resist as solids do",
                             material->name)};
}

std::optional<Problem> problem_of(const DruckerPragerSettings& law) {
  if (law.constant > 0 || law.linear > 0 || law.quadratic > 0) return {};
  return Problem{"constant", "expected this, linear or quadratic > 0, got none: what has no strength is a fluid"};
}

std::optional<Problem> problem_of(const CrushableFoamSettings& law) {
  const auto& x = law.compaction;
  if (x.empty()) return Problem{"compaction", "missing, expected ascending numbers < 1"};
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!(std::isfinite(x[k]) && x[k] < 1)) {
      return Problem{"compaction", fmt::format("expected numbers < 1, of what is left of a volume, got {}", x[k])};
    }
    if (k > 0 && !(x[k] > x[k - 1])) {
      return Problem{"compaction", fmt::format("expected ascending numbers, got {} after {}", x[k], x[k - 1])};
    }
  }
  if (law.yield_stress.size() != x.size()) {
    return Problem{"yield_stress", fmt::format("expected one number for each of the {} compactions, got {}", x.size(),
                                               law.yield_stress.size())};
  }
  for (const double stress : law.yield_stress) {
    if (!(stress >= 0 && std::isfinite(stress)))
      return Problem{"yield_stress", fmt::format("expected numbers >= 0, got {}", stress)};
  }
  if (std::ranges::max(law.yield_stress) > 0) return {};
  return Problem{"yield_stress", "expected one > 0, got none: what has no strength is a fluid"};
}

bool erodes_by_damage(const Material& m) {
  return (m.johnson_cook && !m.johnson_cook->failure.empty()) || (m.johnson_holmquist && m.johnson_holmquist->erodes);
}

bool erodes(const Material& m) {
  if (m.erosion) return true;
  return m.plastic && (m.erosion_strain > 0 || erodes_by_damage(m));
}

std::optional<Problem> problem_of(const YieldCurve& curve) {
  const auto& e = curve.plastic_strain;
  if (e.empty() || e.front() != 0.0) {
    return Problem{"plastic_strain", e.empty() ? "missing, expected numbers from 0 on"
                                               : fmt::format("expected 0 as the first, got {}", e.front())};
  }
  for (std::size_t i = 1; i < e.size(); ++i) {
    if (e[i] > e[i - 1] && std::isfinite(e[i])) continue;
    return Problem{"plastic_strain", fmt::format("expected ascending numbers, got {} after {}", e[i], e[i - 1])};
  }
  if (curve.stress.size() != e.size()) {
    return Problem{"stress", fmt::format("expected one number for each of the {} plastic strains, got {}", e.size(),
                                         curve.stress.size())};
  }
  for (const double stress : curve.stress) {
    if (!(stress > 0) || !std::isfinite(stress)) {
      return Problem{"stress", fmt::format("expected numbers > 0, got {}", stress)};
    }
  }
  return {};
}

}  // namespace pinball

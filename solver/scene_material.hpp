#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/point.hpp"

/// The materials of a scene. Units are those of the scene; temperatures are in kelvin, or any other with its step.
namespace pinball {

enum class StrainRate { total, deviatoric, plastic };
enum class RateInterpolation { linear, logarithmic };

/// Yield stress over effective plastic strain: straight between its points, beyond the last as between the last two,
/// or as the last where it falls there.
struct YieldCurve {
  double rate = 0.0;                   ///< rate: at which it holds; of a single curve not used [1/time]
  std::vector<double> plastic_strain;  ///< plastic_strain: from 0, ascending [-]
  std::vector<double> stress;          ///< stress [stress]
};

/// power_hardening of a material: Y = K (e_0 + e)^n, which is its yield_stress at no plastic strain e.
struct PowerHardeningSettings {
  double coefficient = 0.0;  ///< coefficient: K [stress]
  double exponent = 0.0;     ///< exponent: n [-]

  bool operator==(const PowerHardeningSettings&) const = default;
};

/// johnson_cook of a material (Johnson and Cook 1983, 1985): Y = (A + B e^n) (1 + C ln r) (1 - h^m), A its
/// yield_stress; weakened by damage, (1 - w D) of it (kernels/material/johnson_cook.hpp).
struct JohnsonCookSettings {
  double hardening_coefficient = 0.0;  ///< hardening_coefficient: B [stress]
  double hardening_exponent = 1.0;     ///< hardening_exponent: n [-]
  double rate_coefficient = 0.0;       ///< rate_coefficient: C [-]
  double reference_rate = 0.0;         ///< reference_rate: at which r = 1; needed for C and D4 [1/time]
  double softening_exponent = 1.0;     ///< softening_exponent: m [-]
  double melting_temperature = 0.0;    ///< melting_temperature; 0: no softening [temperature]
  double room_temperature = 0.0;       ///< room_temperature: that of the undeformed material [temperature]
  double specific_heat = 0.0;          ///< specific_heat; needed for softening and D5 [energy/(mass temperature)]
  double heat_share = 1.0;             ///< heat_share: part of the plastic work that heats [-]
  std::vector<double> failure;         ///< failure: D1 ... D5; none: it does not fail so [-]
  double damage_weakening = 0.0;       ///< damage_weakening: part of Y that is lost at failure [-]

  bool operator==(const JohnsonCookSettings&) const = default;
};

/// johnson_holmquist of a material: a brittle one (Johnson and Holmquist 1994), of strength that grows with pressure
/// and falls with damage (kernels/material/johnson_holmquist.hpp). K_1 is its bulk_modulus.
struct JohnsonHolmquistSettings {
  double intact_strength = 0.0;         ///< intact_strength: A [-]
  double intact_exponent = 0.0;         ///< intact_exponent: N [-]
  double fractured_strength = 0.0;      ///< fractured_strength: B [-]
  double fractured_exponent = 1.0;      ///< fractured_exponent: M [-]
  double most_fractured = 0.0;          ///< most_fractured: F; 0: no such limit [-]
  double rate_coefficient = 0.0;        ///< rate_coefficient: C [-]
  double reference_rate = 0.0;          ///< reference_rate: above which it grows with the rate; needed for C [1/time]
  double tensile_strength = 0.0;        ///< tensile_strength: of a mean stress [stress]
  double elastic_limit = 0.0;           ///< elastic_limit: HEL, of the stress along a shock [stress]
  double elastic_limit_pressure = 0.0;  ///< elastic_limit_pressure: p_H, the pressure there [stress]
  double damage_coefficient = 0.0;      ///< damage_coefficient: D_1 [-]
  double damage_exponent = 1.0;         ///< damage_exponent: D_2 [-]
  double quadratic_modulus = 0.0;       ///< quadratic_modulus: K_2 [stress]
  double cubic_modulus = 0.0;           ///< cubic_modulus: K_3 [stress]
  double bulking = 0.0;                 ///< bulking: beta [-]
  bool erodes = false;                  ///< erodes: an element whose damage reaches 1 is eroded

  bool operator==(const JohnsonHolmquistSettings&) const = default;
};

/// drucker_prager of a material: ideally plastic strength that grows with the pressure, s:s/2 <= a0 + a1 p + a2 p^2
/// (kernels/material/drucker_prager.hpp).
struct DruckerPragerSettings {
  double constant = 0.0;   ///< constant: a0 [stress^2]
  double linear = 0.0;     ///< linear: a1 [stress]
  double quadratic = 0.0;  ///< quadratic: a2 [-]
  /// largest: which s:s/2 never exceeds; default: infinite [stress^2]
  double largest = std::numeric_limits<double>::infinity();
  /// tension_limit: minus the pressure at which, and below which, there is no strength; default: infinite [stress]
  double tension_limit = std::numeric_limits<double>::infinity();

  bool operator==(const DruckerPragerSettings&) const = default;
};

/// crushable_foam of a material: each principal stress yields by itself, at a stress of the compaction 1 - V/V_0
/// (kernels/material/crushable_foam.hpp).
struct CrushableFoamSettings {
  std::vector<double> compaction;    ///< compaction: of the points of the curve, ascending [-]
  std::vector<double> yield_stress;  ///< yield_stress: at them [stress]
  /// tension_cutoff: of a principal stress; default: infinite, which is the yield stress, as in compression [stress]
  double tension_cutoff = std::numeric_limits<double>::infinity();
  double damping = 0.0;       ///< damping: zeta, of all rates [-]
  double air_pressure = 0.0;  ///< air_pressure: P_0, of the air in closed cells at rest; 0: none [stress]
  double solid_share = 0.0;   ///< solid_share: phi, part of the volume at rest that is not air [-]

  bool operator==(const CrushableFoamSettings&) const = default;
};

/// mooney_rivlin of a material: an energy of A (I - 3) + B (II - 3) and of the volume
/// (kernels/material/mooney_rivlin.hpp).
struct MooneyRivlinSettings {
  double a = 0.0;              ///< a: A [stress]
  double b = 0.0;              ///< b: B [stress]
  double poisson_ratio = 0.0;  ///< poisson_ratio: of small strains [-]

  bool operator==(const MooneyRivlinSettings&) const = default;
};

/// ogden of a material: an energy of powers of the principal stretches (kernels/material/ogden.hpp).
struct OgdenSettings {
  static constexpr std::size_t most_terms = 10;

  std::vector<double> moduli;     ///< moduli: m_p, one per term [stress]
  std::vector<double> exponents;  ///< exponents: a_p, as many [-]
  double poisson_ratio = 0.0;     ///< poisson_ratio: of small strains [-]
  bool whole = false;             ///< stretches = "shape" | "whole": what the powers are of

  bool operator==(const OgdenSettings&) const = default;
};

/// orthotropic of an elastic material: moduli along the axes a, b and c of the undeformed material, which go with it
/// (kernels/material/orthotropic.hpp).
struct OrthotropicSettings {
  Point young_moduli{};    ///< young_moduli: E_a, E_b, E_c [stress]
  Point poisson_ratios{};  ///< poisson_ratios: nu_ab, nu_ac, nu_bc; nu_ij: contraction along j in tension along i [-]
  Point shear_moduli{};    ///< shear_moduli: G_ab, G_ac, G_bc [stress]
  Point first_axis{1, 0, 0};   ///< first_axis: a, of any length [-]
  Point second_axis{0, 1, 0};  ///< second_axis: a direction in the plane of a and b, on the side of b [-]

  bool operator==(const OrthotropicSettings&) const = default;
};

/// fluid of a material: no strength, s = 2 eta D'.
struct FluidSettings {
  double viscosity = 0.0;  ///< viscosity: eta [stress time]

  bool operator==(const FluidSettings&) const = default;
};

enum class VolumeMeasure { logarithmic, density };

enum class EquationOfStateForm { mie_grueneisen, polynomial, tabulated };

/// equation_of_state of a material: p = A(mu) + B(mu) e (kernels/material/equation_of_state.hpp).
struct EquationOfStateSettings {
  EquationOfStateForm form = EquationOfStateForm::mie_grueneisen;
  double sound_speed = 0.0;           ///< sound_speed: c of u_s = c + s1 u_p; Mie and Grueneisen [length/time]
  Point slopes{};                     ///< slopes: s1, s2, s3; the same [-]
  double gamma = 0.0;                 ///< gamma: Gamma_0; the same [-]
  double gamma_slope = 0.0;           ///< gamma_slope: a; the same [-]
  std::vector<double> coefficients;   ///< coefficients: c0 ... c3 [stress], c4 ... c6 [-]; polynomial
  std::vector<double> volume_strain;  ///< volume_strain: of the points of a table, rising or falling [-]
  std::vector<double> pressure;       ///< pressure: A at them [stress]
  std::vector<double> energy_factor;  ///< energy_factor: B at them; empty: 0 [-]
  double tension_limit = 0.0;         ///< tension_limit: pressure is never below minus this; 0: no limit [stress]
  bool bears_tension = true;          ///< bears_tension: false: pressure is never below 0
  VolumeMeasure volume_measure = VolumeMeasure::logarithmic;  ///< volume_measure: ln(V/V_0) or 1 - rho/rho_0
  /// unloading_modulus: K of what crushes, a number or one of each point; none: it goes back as it came [stress]
  std::vector<double> unloading_modulus;
  /// full_compaction: beyond which it goes back as it came: minus a volume_strain, or mu; default: infinite [-]
  double full_compaction = std::numeric_limits<double>::infinity();
  /// elastic_compaction: up to which it goes back as it came; negative: also in tension K is that of unloading [-]
  double elastic_compaction = -1.0;
  bool tears = false;  ///< tears: what has come to tension_limit once bears no tension any more

  bool operator==(const EquationOfStateSettings&) const = default;
};

/// erosion of a material: an element that is beyond one of these is eroded; 0: no such limit. What each is of:
/// kernels/material/failure.hpp
struct ErosionSettings {
  double tension = 0.0;           ///< tension: of the mean stress, which is minus the pressure [stress]
  double compression = 0.0;       ///< compression: of the pressure [stress]
  double principal_stress = 0.0;  ///< principal_stress: of the largest one [stress]
  double effective_stress = 0.0;  ///< effective_stress: of von Mises' [stress]
  double principal_strain = 0.0;  ///< principal_strain: of the largest one [-]
  double shear_strain = 0.0;      ///< shear_strain: half the difference of the largest and the smallest one [-]
  double time = 0.0;              ///< time: after which all elements of the material fail [time]
  double smallest_step = 0.0;     ///< smallest_step: an element with a smaller stable step fails [time]
  double step_share = 0.0;        ///< step_share: the same, as a part of the smallest stable step at the start [-]

  bool operator==(const ErosionSettings&) const = default;
};

/// One [[material]] table. model = "elastic" | "von_mises". What concerns plasticity is 0 if elastic.
struct Material {
  std::string name;
  bool plastic = false;
  double density = 0.0;          ///< density [mass/length^3]
  double bulk_modulus = 0.0;     ///< bulk_modulus; both moduli also from young_modulus + poisson_ratio [stress]
  double shear_modulus = 0.0;    ///< shear_modulus [stress]
  double yield_stress = 0.0;     ///< yield_stress [stress]
  double plastic_modulus = 0.0;  ///< plastic_modulus: H = d yield / d plastic strain [stress]
  double ultimate_stress = 0.0;  ///< ultimate_stress: hardening ends here; default: infinite [stress]
  double erosion_strain = 0.0;   ///< erosion_strain: effective plastic strain at which the element is eroded; 0: never
  /// isotropic_share: beta, part of the plastic modulus by which the yield surface grows; it moves by the rest [-]
  double isotropic_share = 1.0;
  /// yield_curve, yield_curves: in the place of yield_stress, plastic_modulus and ultimate_stress; ascending rates
  std::vector<YieldCurve> yield_curves;
  std::optional<PowerHardeningSettings> power_hardening;  ///< in the place of plastic_modulus and ultimate_stress
  RateInterpolation rate_interpolation = RateInterpolation::linear;  ///< rate_interpolation: between curves
  StrainRate strain_rate = StrainRate::total;  ///< strain_rate: which rate the yield stress depends on
  double rate_constant = 0.0;                  ///< rate_constant: C of Cowper and Symonds; 0: no such law [1/time]
  double rate_exponent = 0.0;                  ///< rate_exponent: p of that law [-]
  double rate_stress = 0.0;  ///< rate_stress: what the law adds a multiple of; 0: of the yield stress itself [stress]
  std::optional<JohnsonCookSettings> johnson_cook;            ///< in the place of hardening and rate laws above
  std::optional<JohnsonHolmquistSettings> johnson_holmquist;  ///< in the place of yield_stress, hardening and rates
  std::optional<DruckerPragerSettings> drucker_prager;        ///< the same
  std::optional<CrushableFoamSettings> crushable_foam;        ///< the same
  std::optional<MooneyRivlinSettings> mooney_rivlin;          ///< of an elastic one, in the place of its moduli
  std::optional<OgdenSettings> ogden;                         ///< the same
  std::optional<OrthotropicSettings> orthotropic;             ///< the same
  std::optional<FluidSettings> fluid;                         ///< in the place of all strength
  std::optional<EquationOfStateSettings> equation_of_state;   ///< in the place of the bulk modulus, which follows
  std::optional<ErosionSettings> erosion;                     ///< limits beside erosion_strain; of elastic ones, too
};

/// Whether its strength begins at a yield_stress.
inline bool has_yield_stress(const Material& material) {
  return material.plastic && !material.fluid && !material.johnson_holmquist && !material.drucker_prager &&
         !material.crushable_foam;
}

}  // namespace pinball

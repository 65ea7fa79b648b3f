#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <solver/formats/lsdyna/layouts/rigid_cards.hpp>

#include "deck_crushable_foam.hpp"
#include "deck_elastic_laws.hpp"
#include "deck_parts.hpp"
#include "deck_plastic_laws.hpp"
#include "deck_soil.hpp"
#include "keyword_rules.hpp"

namespace pinball {

namespace {

using MaterialKeys = DeckKeys<Material>;

MaterialKeys begin_material(std::int64_t id, const std::string& title, const KeywordBlock& block, const Fields& f,
                            DeckScene& scene) {
  const std::string kind = keyword_alias(block.name);
  const bool plastic = kind != "MAT_ELASTIC" && kind != "MAT_RIGID" && !energy_of(kind);
  auto keys = scene.entry<Material>("material", {block.star_name(), f.place()});
  keys.comment(title);
  keys.set("name", fmt::format("mat_{}", id));
  keys.set("model", plastic ? "von_mises" : "elastic");
  keys.set("density", f.number("RO"), "ro");
  return keys;
}

void set_elasticity(const Fields& f, const MaterialKeys& keys) {
  keys.set("young_modulus", f.number("E"), "e");
  keys.set("poisson_ratio", f.number("PR"), "pr");
}

const CardLayout& layout_of(const KeywordBlock& block) {
  const std::string kind = keyword_alias(block.name);
  if (const auto energy = energy_of(kind)) return layout_of(*energy);
  if (kind == "MAT_JOHNSON_COOK") return layout::johnson_cook;
  if (kind == "MAT_ELASTIC") return layout::elastic;
  if (kind == "MAT_RIGID") return layout::rigid;
  if (kind == "MAT_JOHNSON_HOLMQUIST_CERAMICS") return layout::johnson_holmquist;
  if (kind == "MAT_NULL") return layout::null;
  if (kind == "MAT_SOIL_AND_FOAM" || kind == "MAT_SOIL_AND_FOAM_FAILURE") return layout::soil;
  if (kind == "MAT_CRUSHABLE_FOAM") return layout::crushable_foam;
  if (kind == "MAT_POWER_LAW_PLASTICITY") return layout::power_law;
  if (kind == "MAT_ISOTROPIC_ELASTIC_PLASTIC") return layout::isotropic_plastic;
  if (kind == "MAT_SIMPLIFIED_JOHNSON_COOK") return layout::simplified_johnson_cook;
  return kind == "MAT_PLASTIC_KINEMATIC" ? layout::kinematic : layout::piecewise;
}

/// Fields that have a value and no effect are reported.
void not_used(DeckData& data, const KeywordBlock& block, const Fields& f, std::string_view fields, const char* reason) {
  data.report.unused(f.place(), fmt::format("{}: {}", block.star_name(), fields), reason);
}

double yield_stress(const Fields& f) {
  if (f.blank("SIGY")) f.fail("SIGY", "expected a number, got nothing");
  return f.number("SIGY");
}

/// E Et/(E - Et): slope over the plastic strain.
double plastic_modulus(const Fields& f) {
  const double young = f.number("E"), tangent = f.number("ETAN");
  if (tangent >= young) f.fail("ETAN", fmt::format("expected less than E = {:.6g}, got {:.6g}", young, tangent));
  return young * tangent / (young - tangent);
}

struct DeckRate {
  double constant = 0, exponent = 0;  ///< C and P; 0: no such law
  std::int64_t vp = 0;                ///< VP
  const char *constant_name, *exponent_name;

  DeckRate(const Fields& f, const char* constant_field, const char* exponent_field, std::int64_t formulation)
      : constant(f.number(constant_field)),
        exponent(f.number(exponent_field)),
        vp(formulation),
        constant_name(constant_field),
        exponent_name(exponent_field) {}
  bool is_law() const { return constant != 0 && exponent != 0; }
};

void set_strain_rate(const DeckRate& rate, const MaterialKeys& keys) {
  keys.set("strain_rate", rate.vp == 1 ? "plastic" : rate.vp == -1 ? "deviatoric" : "total", "vp");
}

/// Cowper and Symonds.
void set_rate(DeckData& data, const KeywordBlock& block, const Fields& f, const DeckRate& rate,
              const MaterialKeys& keys) {
  if (!rate.is_law() && (rate.constant != 0 || rate.exponent != 0))
    not_used(data, block, f, rate.constant != 0 ? rate.constant_name : rate.exponent_name,
             "a law of the strain rate has both of its constants");
  if (!rate.is_law()) return;
  keys.set("rate_constant", rate.constant, lower_case(rate.constant_name));
  keys.set("rate_exponent", rate.exponent, lower_case(rate.exponent_name));
  set_strain_rate(rate, keys);
}

void set_failure(const Fields& f, const char* name, const MaterialKeys& keys) {
  const double strain = f.number(name);
  if (strain < 0) f.fail(name, fmt::format("expected a strain >= 0, got {}", strain));
  if (strain > 0 && strain < 1e19) keys.set("erosion_strain", strain, lower_case(name));
}

/// *MAT_003
void set_plastic_kinematic(DeckData& data, const KeywordBlock& block, const Fields& f, Cards& cards,
                           const MaterialKeys& keys) {
  const Card card = cards.next_or_blank();
  const Fields more = data.fields(card, layout::kinematic_rate);
  keys.set("yield_stress", yield_stress(f), "sigy");
  keys.set("plastic_modulus", plastic_modulus(f), "etan");
  keys.set("isotropic_share", f.number("BETA"), "beta");
  set_rate(data, block, more, DeckRate(more, "SRC", "SRP", more.integer("VP")), keys);
  set_failure(more, "FS", keys);
}

/// Of *MAT_018, from SIGY: the yield stress itself, or below 0.02 the strain at which the power begins; without it the
/// power begins where it crosses E e.
double stress_of_power(const Fields& f, double given) {
  const double young = f.number("E"), coefficient = f.number("K"), exponent = f.number("N");
  if (!(coefficient > 0)) f.fail("K", fmt::format("expected a number > 0, got {}", coefficient));
  if (!(exponent > 0 && exponent < 1)) f.fail("N", fmt::format("expected a number > 0 and < 1, got {}", exponent));
  if (given >= 0.02) return given;
  const double strain = given > 0 ? given : std::pow(young / coefficient, 1 / (exponent - 1));
  return coefficient * std::pow(strain, exponent);
}

/// *MAT_018
void set_power_law(DeckData& data, const KeywordBlock& block, const Fields& f, Cards& cards, const MaterialKeys& keys) {
  const Card card = cards.next_or_blank();
  const Fields more = data.fields(card, layout::power_law_more);
  keys.set("yield_stress", stress_of_power(f, more.number("SIGY")), "sigy");
  InnerKeys<PowerHardeningSettings> power;
  power.set("coefficient", f.number("K"));
  power.set("exponent", f.number("N"));
  keys.set("power_hardening", power.value(), "k, n");
  set_rate(data, block, f, DeckRate(f, "SRC", "SRP", more.integer("VP")), keys);
  set_failure(more, "EPSF", keys);
}

/// PC, where SPALL says that it cuts off the pressure and nothing else.
double tension_limit(DeckData& data, const Fields& f) {
  const double cutoff = f.number("PC");
  if (cutoff == 0) return 0;
  if (f.number("SPALL") != 1)
    data.report.reject(f.place(), "*MAT_JOHNSON_COOK with PC and a SPALL other than 1",
                       "give 1: a limit of the pressure");
  return std::abs(cutoff);
}

/// *MAT_015. Temperatures are of the plastic work; its rate is that of the strain's deviator, or with VP of the plastic
/// strain.
void set_johnson_cook(DeckData& data, const Fields& f, Cards& cards, const DeckStateEquation& equation,
                      const MaterialKeys& keys) {
  const Card strength = cards.next_or_blank(), failure = cards.next_or_blank(), more = cards.next_or_blank();
  const Fields s = data.fields(strength, layout::johnson_cook_strength),
               d = data.fields(failure, layout::johnson_cook_failure),
               last = data.fields(more, layout::johnson_cook_more);
  if (s.number("C") != 0 && !(s.number("EPS0") > 0)) s.fail("EPS0", "expected more than 0 beside C");
  if (s.number("TM") != 0 && !(d.number("CP") > 0)) d.fail("CP", "expected more than 0 beside TM");
  if (s.number("B") != 0 && !(s.number("N") > 0)) s.fail("N", "expected more than 0 beside B");
  keys.set("shear_modulus", f.number("G"), "g");
  keys.set("yield_stress", s.number("A"), "a");
  keys.set("strain_rate", f.integer("VP") == 1 ? "plastic" : "deviatoric", "vp");
  InnerKeys<JohnsonCookSettings> law;
  if (s.number("B") != 0) {
    law.set("hardening_coefficient", s.number("B"));
    law.set("hardening_exponent", s.number("N"));
  } else if (s.number("N") != 0) {
    data.report.unused(s.place(), "*MAT_JOHNSON_COOK: N", "B is 0");
  }
  law.set("rate_coefficient", s.number("C"));
  law.set("reference_rate", s.number("EPS0"));
  law.set("room_temperature", s.number("TR"));
  law.set("specific_heat", d.number("CP"));
  if (s.number("TM") != 0) {
    law.set("melting_temperature", s.number("TM"));
    law.set("softening_exponent", s.number("M"));
  } else if (s.number("M") != 0) {
    data.report.unused(s.place(), "*MAT_JOHNSON_COOK: M", "TM is 0");
  }
  const double of_pressure = -std::abs(d.number("D3"));  // its pressure counts compression, and either sign is that
  if (d.number("D3") > 0)
    data.report.understood(
        fmt::format("*MAT_JOHNSON_COOK ({}): D3 of either sign counts as {:.6g}", d.place().text(), of_pressure));
  const std::vector<double> constants{d.number("D1"), d.number("D2"), of_pressure, d.number("D4"), last.number("D5")};
  if (std::ranges::any_of(constants, [](double one) { return one != 0; })) law.set("failure", constants);
  keys.set("johnson_cook", law.value(), "johnson_cook");
  keys.set("equation_of_state", given_state_equation(equation, tension_limit(data, d)), equation.card.text());
}

/// *MAT_009
void set_null(DeckData& data, const Fields& f, const DeckStateEquation& equation, const MaterialKeys& keys) {
  InnerKeys<FluidSettings> fluid;
  fluid.set("viscosity", f.number("MU"));
  keys.set("fluid", fluid.value(), "mu");
  const double limit = -f.number("PC");
  if (limit == 0) data.report.understood("*MAT_NULL with PC 0: its tension has no limit");
  keys.set("equation_of_state", given_state_equation(equation, limit), equation.card.text());
}

/// A curve as a value of a key; rate: negative: it is the only one.
GivenValue given_curve(const DeckCurve& curve, const DeckPlace& place, double factor = 1.0, double rate = -1.0) {
  std::vector<double> strain = curve.abscissa, stress = curve.ordinate;
  if (strain.front() > 0) {  // a curve begins at zero strain with its first stress
    strain.insert(strain.begin(), 0.0);
    stress.insert(stress.begin(), stress.front());
  }
  if (strain.front() < 0) fail_at(place, "yield stresses over plastic strain: expected no strain below 0");
  for (double& value : stress) value *= factor;
  InnerKeys<YieldCurve> keys;
  if (rate >= 0) keys.set("rate", rate);
  keys.set("plastic_strain", strain);
  keys.set("stress", stress);
  return keys.value();
}

std::vector<double> card_of_numbers(const DeckData& data, Cards& cards, const CardLayout& layout) {
  const Card card = cards.next_or_blank();
  const Fields f = data.fields(card, layout);
  std::vector<double> values;
  for (std::size_t i = 0; i < layout.size(); ++i) values.push_back(f.number(i));
  return values;
}

/// A table: a curve for each rate.
void set_table(DeckData& data, const Fields& f, std::int64_t lcss, const MaterialKeys& keys) {
  const DeckTable& table = *data.table(lcss);
  GivenArray curves;
  for (const auto& [rate, id] : table.curves) {
    curves.push_back(given_curve(data.yield_curve(id, f.place()), f.place(), 1.0, rate));
  }
  if (table.logarithmic) keys.set("rate_interpolation", "logarithmic", "lcss");
  keys.set("yield_curves", curves, "lcss");
}

/// LCSR: the static curve times what that curve gives for each rate.
void set_scaled_curves(const DeckCurve& factors, const DeckCurve& curve, const Fields& f, const MaterialKeys& keys) {
  GivenArray curves;
  for (std::size_t i = 0; i < factors.abscissa.size(); ++i) {
    curves.push_back(given_curve(curve, f.place(), factors.ordinate[i], factors.abscissa[i]));
  }
  keys.set("yield_curves", curves, "lcss");
}

/// EPS1 to EPS8 and ES1 to ES8: as many as ascend, in the units of the deck; none: all stresses are blank.
std::optional<DeckCurve> curve_of_points(const std::vector<double>& eps, const std::vector<double>& es,
                                         const DeckPlace& place) {
  const auto given = [](double value) { return value != 0; };
  if (std::ranges::none_of(es, given)) return {};
  DeckCurve curve;
  std::size_t i = 0;
  for (; i < eps.size() && (i == 0 || eps[i] > eps[i - 1]); ++i) {
    curve.abscissa.push_back(eps[i]);
    curve.ordinate.push_back(es[i]);
  }
  if (std::any_of(eps.begin() + i, eps.end(), given) || std::any_of(es.begin() + i, es.end(), given))
    fail_at(place, fmt::format("eps1 to eps8: expected ascending strains, got {} after {}", eps[i], eps[i - 1]));
  return curve;
}

/// SIGY and ETAN as a curve, whose slope goes on.
DeckCurve linear_curve(const Fields& f) {
  const double yield = yield_stress(f);
  return {{0, 1}, {yield, yield + plastic_modulus(f)}};
}

/// *MAT_024. Of several forms of hardening LCSS counts before EPS and ES, and these before SIGY and ETAN.
void set_piecewise_linear(DeckData& data, const KeywordBlock& block, const Fields& f, Cards& cards,
                          const MaterialKeys& keys) {
  const Card card = cards.next_or_blank();
  const Fields second = data.fields(card, layout::piecewise_rate);
  const auto to_curve = [&](std::int64_t id) { return id == 0 ? 0 : id + offset_of(block, &DeckTransform::curve); };
  const std::int64_t lcss = to_curve(second.integer("LCSS")), lcsr = to_curve(second.integer("LCSR"));
  const std::vector<double> eps = card_of_numbers(data, cards, layout::piecewise_strains),
                            es = card_of_numbers(data, cards, layout::piecewise_stresses);
  const auto points = curve_of_points(eps, es, f.place());
  if (!points && std::ranges::any_of(eps, [](double strain) { return strain != 0; }))
    not_used(data, block, f, "EPS1 to EPS8", "they have no stresses ES1 to ES8");
  if (points && lcss == 0)
    tell_first_strain(data.report, fmt::format("{} ({}): EPS1", block.star_name(), f.place().text()), *points);
  const DeckRate rate(second, "C", "P", second.integer("VP"));
  const bool is_table = data.table(lcss) != nullptr, by_curves = is_table || lcsr != 0;
  if (lcss != 0 && points) not_used(data, block, f, "EPS1 to EPS8, ES1 to ES8", "LCSS is used");
  if ((lcss != 0 || points) && f.number("ETAN") != 0)
    not_used(data, block, f, "ETAN", "hardening is that of the curve");
  if (is_table && lcsr != 0)
    data.report.reject(f.place(), "*MAT_024 with a table (LCSS) and with LCSR", "give one of both");
  if (by_curves && rate.is_law())
    data.report.reject(f.place(), "*MAT_024 with curves of the strain rate (LCSS, LCSR) and with C and P",
                       "give one of both");
  if (is_table) {
    set_table(data, f, lcss, keys);
  } else if (lcsr != 0) {
    const DeckCurve curve = lcss != 0 ? data.yield_curve(lcss, f.place()) : points ? *points : linear_curve(f);
    set_scaled_curves(data.rate_curve(lcsr, f.place()), curve, f, keys);
  } else if (lcss != 0) {
    keys.set("yield_curve", given_curve(data.yield_curve(lcss, f.place()), f.place()), "lcss, es");
  } else if (points) {
    keys.set("yield_curve", given_curve(*points, f.place()), "lcss, es");
  } else {
    keys.set("yield_stress", yield_stress(f), "sigy");
    keys.set("plastic_modulus", plastic_modulus(f), "etan");
  }
  if (by_curves) {
    set_strain_rate(rate, keys);
  } else {
    set_rate(data, block, second, rate, keys);
    // VP = 1: the law adds a multiple of SIGY; without SIGY, and with other VP, one of the static yield stress.
    if (rate.is_law() && rate.vp == 1 && f.number("SIGY") > 0) keys.set("rate_stress", yield_stress(f), "sigy");
  }
  if (f.number("FAIL") < 0) {
    data.report.reject(f.place(), "*MAT_024 with a failure that the user programs (FAIL < 0)", "give a strain");
  } else {
    set_failure(f, "FAIL", keys);
  }
}

}  // namespace

std::int64_t material_number(const DeckData& data, const KeywordBlock& block) {
  Cards cards(block);
  if (block.title) cards.next();
  const Card card = cards.require("the constants of the material");
  return data.fields(card, layout_of(block)).integer("MID") + offset_of(block, &DeckTransform::material);
}

void translate_material(DeckData& data, const KeywordBlock& block, const DeckLimits& limits, DeckScene& scene) {
  Cards cards(block);
  const std::string title = block.title ? std::string(trimmed(cards.require("a title").text)) : "";
  const Card card = cards.require("the constants of the material");
  const Fields f = data.fields(card, layout_of(block));
  const std::int64_t id = material_number(data, block);
  if (!data.is_used(id)) {
    data.report.unused(block.place,
                       fmt::format("{}, material {}, which no part with solids has", block.star_name(), id));
    if (block.log != nullptr) block.log->done(&block);
    return;
  }
  const std::string kind = keyword_alias(block.name);
  const MaterialKeys keys = begin_material(id, title, block, f, scene);
  if (limits.any) keys.set("erosion", limits.keys.value(), limits.card.text());
  if (kind == "MAT_JOHNSON_COOK" || kind == "MAT_NULL") {
    if (const auto equation = data.state_equation_of(id, "*" + kind)) {
      if (kind == "MAT_NULL") {
        set_null(data, f, *equation, keys);
      } else {
        set_johnson_cook(data, f, cards, *equation, keys);
      }
    } else if (block.log != nullptr) {
      block.log->done(&block);
    }
    return;
  }
  data.reject_state_equations(id, block.star_name());
  if (const auto energy = energy_of(kind)) {
    set_energy(data, *energy, block, f, cards, keys);
    return;
  }
  if (kind == "MAT_ISOTROPIC_ELASTIC_PLASTIC") {
    set_isotropic_plastic(f, keys);
    return;
  }
  if (kind == "MAT_JOHNSON_HOLMQUIST_CERAMICS") {
    set_johnson_holmquist(data, f, cards, keys);
    return;
  }
  if (kind == "MAT_SOIL_AND_FOAM" || kind == "MAT_SOIL_AND_FOAM_FAILURE") {
    set_soil(data, block, f, cards, keys);
    return;
  }
  set_elasticity(f, keys);
  if (kind == "MAT_CRUSHABLE_FOAM") set_crushable_foam(data, block, f, keys);
  if (kind == "MAT_PLASTIC_KINEMATIC") set_plastic_kinematic(data, block, f, cards, keys);
  if (kind == "MAT_SIMPLIFIED_JOHNSON_COOK") set_simplified_johnson_cook(data, f, cards, keys);
  if (kind == "MAT_POWER_LAW_PLASTICITY") set_power_law(data, block, f, cards, keys);
  if (kind == "MAT_PIECEWISE_LINEAR_PLASTICITY") set_piecewise_linear(data, block, f, cards, keys);
}

}  // namespace pinball

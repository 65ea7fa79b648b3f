#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <solver/formats/deck/given_once.hpp>
#include <solver/formats/radioss/layouts/radioss_material_cards.hpp>

#include "radioss_brittle.hpp"
#include "radioss_foam.hpp"
#include "radioss_hardening.hpp"
#include "radioss_keys.hpp"
#include "radioss_rubber.hpp"
#include "radioss_soil.hpp"

namespace pinball {

namespace {

using MaterialKeys = DeckKeys<Material>;

/// What stands beside a material under its number.
struct Beside {
  const RadiossBlock* state_equation = nullptr;
  const RadiossBlock* failure = nullptr;
};

bool is_done_material(const std::string& name) {
  return name == "MAT/ELAST" || name == "MAT/RIGID" || name == "MAT/PLAS_JOHNS" || name == "MAT/HYD_JCOOK" ||
         name == "MAT/HYDPLA" || name == "MAT/PLAS_TAB" || name == "MAT/COWPER" || name == "MAT/OGDEN" ||
         name == "MAT/VISC_HYP" || name == "MAT/JOHN_HOLM" || name == "MAT/DPRAG" || name == "MAT/DPRAG1" ||
         name == "MAT/FOAM_PLAS";
}

/// VP: 2 where it is 0.
const char* strain_rate(std::int64_t vp) { return vp == 1 ? "plastic" : vp == 3 ? "deviatoric" : "total"; }

void set_elasticity(const RadiossFields& f, const MaterialKeys& keys) {
  keys.set("young_modulus", f.number("E"), "e");
  keys.set("poisson_ratio", f.number("nu"), "nu");
}

bool is_limit(double value) { return value > 0 && value < 1e19; }

/// Temperatures of a law of Johnson and Cook. rho_cp: per volume, as Radioss has it.
struct RadiossHeat {
  double exponent = 1, melting = 0, rho_cp = 0, room = 300;

  bool softens() const { return is_limit(melting); }
};

/// A strain beyond which solids of Radioss go on without shear stress.
void reject_without_shear(RadiossData& data, const RadiossFields& f, const RadiossBlock& block, const char* name) {
  if (is_limit(f.number(name)))
    data.report.reject(f.place(), fmt::format("{} with {}", block.title, name), std::string(radioss::no_deletion));
}

void tell_without(RadiossData& data, const RadiossFields& f, const RadiossBlock& block, const char* name,
                  const char* why) {
  if (!f.blank(name) && f.number(name) != 0)
    data.report.unused(f.place(), fmt::format("{}: {}", block.title, name), why);
}

void set_heat(const RadiossHeat& heat, double density, InnerKeys<JohnsonCookSettings>& law) {
  law.set("room_temperature", heat.room > 0 ? heat.room : 300.0);
  if (heat.rho_cp > 0) law.set("specific_heat", heat.rho_cp / density);
  if (!heat.softens()) return;
  law.set("melting_temperature", heat.melting);
  law.set("softening_exponent", heat.exponent == 0 ? 1.0 : heat.exponent);
}

/// /FAIL/JOHNSON: D1 to D5, and the rate that D4 counts from.
void set_failure(RadiossData& data, const RadiossBlock& block, double reference_rate,
                 InnerKeys<JohnsonCookSettings>& law) {
  RadiossLines lines(block);
  const DataLine first = lines.require("D1 to D5"), second = lines.next_or_blank(), third = lines.next_or_blank();
  const RadiossFields d(first, block, radioss::fail_johnson), rate(second, block, radioss::fail_johnson_rate),
      points(third, block, radioss::fail_johnson_points);
  if (rate.integer("IFAIL_SO") == 2)
    data.report.reject(second.place, block.title + " with IFAIL_SO 2", "give 1: what fails is eroded");
  std::vector<double> constants;
  for (std::size_t i = 0; i < 5; ++i) constants.push_back(d.number(i));
  law.set("failure", constants);
  const double given = rate.number("EPSILON_DOT_0");
  if (constants[3] != 0 && reference_rate > 0 && given != reference_rate)
    data.report.reject(second.place, block.title + " with an EPSILON_DOT_0 other than EPS_DOT_0 of its material",
                       "give one rate for both");
  if (constants[3] != 0 && reference_rate == 0) law.set("reference_rate", given);
  if (constants[3] == 0) tell_without(data, rate, block, "EPSILON_DOT_0", "D4 is 0");
}

/// Y = (a + b e^n) (1 + c ln r) (1 - h^m), whatever the card that it stands on.
struct JohnsonCook {
  RadiossHardening hardening;
  double coefficient = 0, reference_rate = 0;
  RadiossHeat heat;
};

void set_johnson_cook(RadiossData& data, const DeckPlace& place, const JohnsonCook& of, double density,
                      const Beside& beside, const MaterialKeys& keys) {
  if (is_limit(of.hardening.limit))
    data.report.reject(place,
                       "a largest stress (SIG_max0, sig_max) beside rates, temperatures, failure or an equation "
                       "of state",
                       "leave it 0, or give /MAT/PLAS_TAB");
  InnerKeys<JohnsonCookSettings> law;
  keys.set("yield_stress", of.hardening.yield, "a");
  if (of.hardening.factor != 0) {
    law.set("hardening_coefficient", of.hardening.factor);
    law.set("hardening_exponent", of.hardening.exponent);
  }
  if (of.coefficient != 0) {
    law.set("rate_coefficient", of.coefficient);
    law.set("reference_rate", of.reference_rate);
  }
  set_heat(of.heat, density, law);
  if (beside.failure != nullptr) set_failure(data, *beside.failure, of.coefficient != 0 ? of.reference_rate : 0.0, law);
  keys.set("johnson_cook", law.value(), "c, m, T_melt");
}

/// Hardening without rates and temperatures: a line, or the points of a curve. kinematic: the share by which the yield
/// surface moves.
void set_hardening(RadiossData& data, const DeckPlace& place, const RadiossHardening& hardening, double kinematic,
                   const MaterialKeys& keys) {
  if (hardening.is_line()) {
    keys.set("yield_stress", hardening.yield, "a");
    keys.set("plastic_modulus", hardening.factor, "b");
    if (is_limit(hardening.limit)) keys.set("ultimate_stress", hardening.limit, "SIG_max0");
    if (kinematic > 0) keys.set("isotropic_share", 1 - kinematic, "Chard");
    return;
  }
  if (kinematic > 0)
    data.report.reject(place, "kinematic hardening (Chard, C_hard) along a curve",
                       "give n = 1 and no SIG_max0, or leave it 0");
  keys.set("yield_curve", hardening.curve(), "a, b, n, SIG_max0");
}

/// /MAT/PLAS_JOHNS
void set_plas_johns(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, double density,
                    const Beside& beside, const MaterialKeys& keys) {
  const DataLine l1 = lines.require("E and nu"), l2 = lines.require("a, b and n"), l3 = lines.next_or_blank(),
                 l4 = lines.next_or_blank();
  const RadiossFields e(l1, block, radioss::johnson_elasticity), h(l2, block, radioss::johnson_hardening),
      r(l3, block, radioss::johnson_rate), t(l4, block, radioss::johnson_heat);
  set_elasticity(e, keys);
  reject_without_shear(data, h, block, "EPS_p_max");
  JohnsonCook law{RadiossHardening(h.number("a"), h.number("b"), h.number("n"), h.number("SIG_max0")),
                  r.number("c"),
                  r.number("EPS_DOT_0"),
                  {t.number("m"), t.number("T_melt"), t.number("rhoC_p"), t.number("T_r")}};
  if (e.integer("Iflag") == 1) law.hardening.take_ultimate(e.number("E"), l2.place);
  const bool has_rate = law.coefficient != 0, has_limit = is_limit(law.hardening.limit);
  if (has_rate) {
    keys.set("strain_rate", strain_rate(e.integer("VP")), "VP");
  } else {
    tell_without(data, e, block, "VP", "c is 0");
    tell_without(data, r, block, "EPS_DOT_0", "c is 0");
  }
  if (!has_limit || !has_rate) tell_without(data, r, block, "ICC", "it is of SIG_max0 and c");
  if (!law.heat.softens()) {
    tell_without(data, t, block, "m", "T_melt is 0");
    if (beside.failure == nullptr) {
      tell_without(data, t, block, "rhoC_p", "T_melt is 0");
      tell_without(data, t, block, "T_r", "T_melt is 0");
    }
  }
  const bool is_law = has_rate || law.heat.softens() || beside.failure != nullptr || beside.state_equation != nullptr;
  const double kinematic = r.number("Chard");
  if (is_law && kinematic != 0)
    data.report.reject(l3.place, block.title + " with Chard beside rates, temperatures, failure or an /EOS",
                       "leave it 0");
  if (is_law) {
    set_johnson_cook(data, l2.place, law, density, beside, keys);
  } else {
    set_hardening(data, l2.place, law.hardening, kinematic, keys);
  }
}

/// /MAT/HYD_JCOOK and, without rates and heat, /MAT/HYDPLA.
void set_hydrodynamic(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, double density,
                      const Beside& beside, const MaterialKeys& keys) {
  const DataLine l1 = lines.require("E and nu"), l2 = lines.require("A, B and n"), l3 = lines.next_or_blank(),
                 l4 = lines.next_or_blank(), l5 = lines.next_or_blank();
  const bool plain = block.name == "MAT/HYDPLA";
  const RadiossFields e(l1, block, radioss::elasticity), h(l2, block, radioss::hydro_hardening),
      p(l3, block, radioss::hydro_cutoff), r(l4, block, radioss::hydro_rate), t(l5, block, radioss::hydro_heat);
  reject_without_shear(data, h, block, "eps_max");
  JohnsonCook law{RadiossHardening(h.number("A"), h.number("B"), h.number("n"), h.number("sig_max")), 0, 0, {}};
  if (!plain) {
    law.coefficient = r.number("C");
    law.reference_rate = r.number("EPS_DOT_0");
    law.heat = {r.number("M"), r.number("Tmelt"), t.number("rhoC_p"), t.number("T_r")};
    if (law.coefficient == 0) {
      tell_without(data, r, block, "EPS_DOT_0", "C is 0");
    } else {
      data.report.understood(
          fmt::format("{} ({}): the strain rate is sqrt(D:D), and in Radioss the largest "
                      "component of D",
                      block.title, block.place.text()));
    }
    if (!law.heat.softens()) {
      for (const char* name : {"M"}) tell_without(data, r, block, name, "Tmelt is 0");
      if (beside.failure == nullptr) {
        for (const char* name : {"rhoC_p", "T_r"}) tell_without(data, t, block, name, "Tmelt is 0");
      }
    }
  }
  keys.set("shear_modulus", e.number("E") / (2 * (1 + e.number("nu"))), "e, nu");
  const double cutoff = p.number("Pmin");
  if (beside.state_equation == nullptr) {
    data.report.reject(block.place,
                       block.title + " without an /EOS/GRUNEISEN, /EOS/POLYNOMIAL or /EOS/COMPACTION of its number",
                       "give it one");
    return;
  }
  keys.set("equation_of_state", given_radioss_state(data, *beside.state_equation, cutoff > -1e19 ? -cutoff : 0.0),
           beside.state_equation->place.text());
  set_johnson_cook(data, l2.place, law, density, beside, keys);
}

/// /MAT/COWPER
void set_cowper(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const MaterialKeys& keys) {
  const DataLine l1 = lines.require("E and nu"), l2 = lines.require("A, B and n"), l3 = lines.next_or_blank(),
                 l4 = lines.next_or_blank(), l5 = lines.next_or_blank();
  const RadiossFields e(l1, block, radioss::cowper_elasticity), h(l2, block, radioss::cowper_hardening),
      r(l3, block, radioss::cowper_rate), failure(l4, block, radioss::cowper_failure),
      function(l5, block, radioss::cowper_function);
  set_elasticity(e, keys);
  RadiossHardening hardening(h.number("A"), h.number("B"), h.number("n"), h.number("sigmax"));
  if (e.integer("Iflag") == 1) hardening.take_ultimate(e.number("E"), l2.place);
  const double constant = r.number("C"), given = r.number("P"), exponent = given == 0 ? 1 : given;
  const bool has_limit = is_limit(hardening.limit);
  if (constant == 0) {
    for (const char* name : {"P", "VP"}) tell_without(data, r, block, name, "C is 0");
  }
  if (!has_limit || constant == 0) tell_without(data, r, block, "ICC", "it is of sigmax and C");
  if (has_limit && constant != 0 && r.integer("ICC") == 2)
    data.report.reject(l3.place, block.title + " with ICC 2", "give 1: the largest stress grows with the rate, too");
  if (hardening.is_line() && has_limit && constant != 0) {
    keys.set("yield_curve", hardening.curve(), "A, B, n, sigmax");
  } else {
    set_hardening(data, l2.place, hardening, 0, keys);
  }
  if (constant == 0) return;
  keys.set("rate_constant", constant, "C");
  keys.set("rate_exponent", exponent, "P");
  keys.set("strain_rate", strain_rate(r.integer("VP")), "VP");
}

/// So many numbers, five to a line.
std::vector<double> read_list(const RadiossBlock& block, RadiossLines& lines, const CardLayout& layout,
                              std::size_t count, const char* what) {
  std::vector<double> values;
  while (values.size() < count) {
    const DataLine line = lines.require(what);
    const RadiossFields f(line, block, layout);
    for (std::size_t i = 0; i < layout.size() && values.size() < count; ++i) values.push_back(f.number(i));
  }
  return values;
}

GivenValue tabulated_curve(const RadiossData& data, std::int64_t function, double scale, std::optional<double> rate,
                           const DeckPlace& place) {
  auto [strain, stress] = data.function(function, place);
  if (strain.front() < 0) fail_at(place, fmt::format("/FUNCT {}: expected no plastic strain below 0", function));
  if (strain.front() > 0) {  // along its first piece, as in the engine (VINTER2)
    const bool is_piece = strain.size() > 1 && strain[1] > strain[0];
    const double slope = is_piece ? (stress[1] - stress[0]) / (strain[1] - strain[0]) : 0.0;
    stress.insert(stress.begin(), stress[0] - slope * strain[0]);
    strain.insert(strain.begin(), 0.0);
  }
  for (double& value : stress) value *= scale == 0 ? 1.0 : scale;
  InnerKeys<YieldCurve> keys;
  if (rate) keys.set("rate", *rate);
  keys.set("plastic_strain", strain);
  keys.set("stress", stress);
  return keys.value();
}

/// /MAT/PLAS_TAB
void set_plas_tab(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const MaterialKeys& keys) {
  const DataLine l1 = lines.require("E and nu"), l2 = lines.require("the number of functions"),
                 l3 = lines.next_or_blank();
  const RadiossFields e(l1, block, radioss::tabulated_elasticity), n(l2, block, radioss::tabulated_rates),
      p(l3, block, radioss::tabulated_pressure);
  set_elasticity(e, keys);
  const std::int64_t count = n.integer("N_funct");
  if (count < 1 || count > 100) n.fail("N_funct", fmt::format("expected 1 to 100, got {}", count));
  if (n.number("C_hard") != 0)
    data.report.reject(l2.place, block.title + " with C_hard", "leave it 0: with curves the yield surface only grows");
  const std::int64_t smoothing = n.integer("F_smooth");
  if (smoothing == 1 || (smoothing == 2 && count == 1))
    data.report.unused(l2.place, block.title + ": F_smooth",
                       smoothing == 1 ? std::string(radioss::not_smoothed) : "there is one function");
  const auto functions = read_list(block, lines, radioss::five_functions, count, "functions of yield stresses"),
             scales = read_list(block, lines, radioss::five_scales, count, "their factors"),
             rates = read_list(block, lines, radioss::five_rates, count, "their rates");
  if (count == 1) {
    tell_without(data, n, block, "VP", "there is one function");
    if (rates[0] != 0) data.report.unused(l2.place, block.title + ": Eps_dot_1", "there is one function");
    keys.set("yield_curve", tabulated_curve(data, static_cast<std::int64_t>(functions[0]), scales[0], {}, l2.place),
             "func_ID1");
    return;
  }
  GivenArray curves;
  for (std::int64_t i = 0; i < count; ++i)
    curves.push_back(tabulated_curve(data, static_cast<std::int64_t>(functions[i]), scales[i], rates[i], l2.place));
  keys.set("yield_curves", curves, "func_ID1");
  if (smoothing == 2) keys.set("rate_interpolation", "logarithmic", "F_smooth");
  data.report.understood(
      fmt::format("{} ({}): at rates above {} its last function holds", block.title, l2.place.text(), rates.back()));
  keys.set("strain_rate", n.integer("VP") == 1 ? "plastic" : "total", "VP");
}

void translate_material(RadiossData& data, const RadiossBlock& block, const Beside& beside, DeckScene& scene) {
  RadiossLines lines(block);
  const DataLine first = lines.require("the density of the material");
  const double density = RadiossFields(first, block, radioss::density).number("RHO_I");
  const auto keys = scene.entry<Material>("material", card_of(block, first.place));
  keys.comment(lines.title());
  keys.set("name", fmt::format("mat_{}", block.id()));
  const bool elastic = block.name == "MAT/ELAST" || block.name == "MAT/RIGID",
             rubber = block.name == "MAT/OGDEN" || block.name == "MAT/VISC_HYP";
  keys.set("model", elastic || rubber ? "elastic" : "von_mises");
  keys.set("density", density, "RHO_I");
  const bool johnson = block.name == "MAT/PLAS_JOHNS",
             hydro = block.name == "MAT/HYD_JCOOK" || block.name == "MAT/HYDPLA";
  if (beside.failure != nullptr && !johnson && !hydro)
    data.report.reject(beside.failure->place, beside.failure->title + " of a material without Johnson and Cook's law",
                       "give it one: /MAT/PLAS_JOHNS or /MAT/HYD_JCOOK");
  if (beside.state_equation != nullptr && !hydro && block.name != "MAT/DPRAG1")
    data.report.reject(beside.state_equation->place, beside.state_equation->title + " of such a material",
                       "give /MAT/HYD_JCOOK or /MAT/DPRAG1: others have a pressure");
  if (elastic) {
    const DataLine line = lines.require("E and nu");
    set_elasticity(RadiossFields(line, block, radioss::elasticity), keys);
  }
  if (johnson) set_plas_johns(data, block, lines, density, beside, keys);
  if (hydro) set_hydrodynamic(data, block, lines, density, beside, keys);
  if (block.name == "MAT/PLAS_TAB") set_plas_tab(data, block, lines, keys);
  if (block.name == "MAT/COWPER") set_cowper(data, block, lines, keys);
  if (block.name == "MAT/JOHN_HOLM") set_john_holm(data, block, lines, keys);
  if (block.name == "MAT/FOAM_PLAS") set_foam_plas(data, block, lines, keys);
  if (block.name == "MAT/DPRAG") set_dprag(data, block, lines, keys);
  if (block.name == "MAT/DPRAG1") set_dprag1(data, block, lines, beside.state_equation, keys);
  if (block.name == "MAT/OGDEN") set_ogden(data, block, lines, keys);
  if (block.name == "MAT/VISC_HYP") set_visc_hyp(data, block, lines, keys);
}

}  // namespace

void translate_radioss_materials(RadiossData& data, DeckScene& scene) {
  std::map<std::int64_t, const RadiossBlock*> materials;
  std::map<std::int64_t, Beside> beside;
  GivenOnce given;
  for (const RadiossBlock& block : data.deck.blocks) {
    const bool material = block.name.starts_with("MAT/"), state = block.name.starts_with("EOS/"),
               failure = block.name == "FAIL/JOHNSON";
    if (!material && !state && !failure) continue;
    given.add(fmt::format("{} {}",
                          material ? "material"
                          : state  ? "equation of state"
                                   : "failure",
                          block.id()),
              block.place);
    if (!data.has_material(block.id())) {
      data.report.unused(block.place, fmt::format("{}, which no part with solids has", block.title));
      if (block.log != nullptr) block.log->done(&block);
    } else if (material) {
      materials[block.id()] = &block;
    } else {
      (state ? beside[block.id()].state_equation : beside[block.id()].failure) = &block;
    }
  }
  for (const RadiossBody& body : data.bodies) {
    if (!materials.contains(body.part.material))
      fail_at(body.part.place, fmt::format("no /MAT has the number {}", body.part.material));
  }
  for (const auto& [id, block] : materials) {
    if (is_done_material(block->name)) translate_material(data, *block, beside[id], scene);
  }
}

}  // namespace pinball

#include "radioss_soil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <solver/formats/radioss/layouts/radioss_material_cards.hpp>

#include "radioss_foam.hpp"

namespace pinball {

namespace {

using SoilKeys = DeckKeys<Material>;

/// A0 + A1 p + A2 p^2, at most Amax. Where it has no root it is least at -A1/(2 A2).
struct SoilStrength {
  double constant = 0, linear = 0, quadratic = 0, most = 0;

  explicit SoilStrength(const RadiossFields& f)
      : constant(f.number("A0")), linear(f.number("A1")), quadratic(f.number("A2")), most(f.number("Amax")) {}
  bool has_no_root() const { return quadratic > 0 && linear * linear < 4 * constant * quadratic; }
  double least_at() const { return -linear / (2 * quadratic); }
  /// tension_limit: negative: none.
  void set(const SoilKeys& keys, double tension_limit = -1) const {
    InnerKeys<DruckerPragerSettings> law;
    law.set("constant", constant);
    law.set("linear", linear);
    law.set("quadratic", quadratic);
    if (most > 0) law.set("largest", most);
    if (tension_limit >= 0) law.set("tension_limit", tension_limit);
    keys.set("drucker_prager", law.value(), "A0, A1, A2, Amax");
  }
};

double shear_modulus(const RadiossFields& f) { return f.number("E") / (2 * (1 + f.number("nu"))); }
double bulk_modulus(const RadiossFields& f) { return f.number("E") / (3 * (1 - 2 * f.number("nu"))); }

/// 0, and what Radioss takes for it, are no limit.
double soil_cutoff(const RadiossFields& f) {
  const double least = f.number("P_min");
  return least > -1e19 ? -least : 0.0;
}

/// Points of mu >= 0, straight from one to the next; as in the engine (FINTER) the last pieces go on.
struct SoilFunction {
  std::vector<double> mu, pressure;

  double at(double x) const {
    std::size_t k = 1;
    while (k + 1 < mu.size() && x > mu[k]) ++k;
    return pressure[k - 1] + (pressure[k] - pressure[k - 1]) * (x - mu[k - 1]) / (mu[k] - mu[k - 1]);
  }
  /// A point more, where there is none.
  void add(double x) {
    const double y = at(x);
    const auto after = std::ranges::lower_bound(mu, x);
    if (after != mu.end() && *after == x) return;
    pressure.insert(pressure.begin() + (after - mu.begin()), y);
    mu.insert(after, x);
  }
};

/// In tension the line of Kt is below the function, or the function is refused.
SoilFunction soil_function(const RadiossData& data, std::int64_t id, double scale, double tension_modulus,
                           const DeckPlace& place) {
  const auto& [x, y] = data.function(id, place);
  SoilFunction function{x, y};
  if (x.size() < 2) fail_at(place, fmt::format("/FUNCT {}: expected two points or more, got {}", id, x.size()));
  for (double& pressure : function.pressure) pressure *= scale == 0 ? 1.0 : scale;
  for (std::size_t i = 0; i < x.size() && x[i] < 0; ++i) {
    if (function.pressure[i] < tension_modulus * x[i])
      fail_at(place, fmt::format("/FUNCT {}: expected no pressure below Kt mu = {:.6g} at mu = {:.6g}, got {:.6g}", id,
                                 tension_modulus * x[i], x[i], function.pressure[i]));
  }
  function.add(0);
  const auto negative = std::ranges::lower_bound(function.mu, 0.0) - function.mu.begin();
  function.mu.erase(function.mu.begin(), function.mu.begin() + negative);
  function.pressure.erase(function.pressure.begin(), function.pressure.begin() + negative);
  return function;
}

/// Along a function from 0 on, and back with moduli from `first` to `last` at mu = `most`; most 0: with the first
/// alone.
InnerKeys<EquationOfStateSettings> crushing_table(SoilFunction function, double first, double last, double most) {
  if (most > 0) function.add(most);
  std::vector<double> strain, moduli;
  for (const double mu : function.mu) {
    strain.push_back(0.0 - mu);
    moduli.push_back(first + (last - first) * (most > 0 ? std::min(1.0, mu / most) : 0.0));
  }
  InnerKeys<EquationOfStateSettings> pressure;
  pressure.set("form", "tabulated");
  pressure.set("volume_measure", "density");
  pressure.set("volume_strain", strain);
  pressure.set("pressure", function.pressure);
  pressure.set("unloading_modulus", most > 0 ? moduli : std::vector{first});
  if (most > 0) pressure.set("full_compaction", most);
  return pressure;
}

void set_linear_soil(const RadiossFields& e, double cutoff, const SoilKeys& keys) {
  InnerKeys<EquationOfStateSettings> pressure;
  pressure.set("form", "polynomial");
  pressure.set("coefficients", std::vector{0.0, bulk_modulus(e), 0.0, 0.0, 0.0, 0.0, 0.0});
  if (cutoff > 0) pressure.set("tension_limit", cutoff);
  keys.set("equation_of_state", pressure.value(), "e, nu, P_min");
}

/// LAW10's polynomial; B and Mu_max of 0 follow as in the starter: one from the slope at the other.
void set_polynomial_soil(RadiossData& data, const RadiossBlock& block, const RadiossFields& e, const RadiossFields& c,
                         const RadiossFields& unloading, double cutoff, const SoilKeys& keys) {
  const double c1 = c.number("C1") > 0 ? c.number("C1") : bulk_modulus(e), c2 = c.number("C2"), c3 = c.number("C3");
  double modulus = unloading.number("B"), most = unloading.number("Mu_max");
  if (most > 0 && modulus == 0) {
    if (c3 != 0) unloading.fail("B", "expected more than 0 beside Mu_max and C3");
    modulus = c1 + 2 * c2 * most;
  } else if (modulus > 0 && most == 0) {
    const double square = c2 * c2 + 3 * c3 * (modulus - c1);
    if (c3 != 0 && square < 0) unloading.fail("Mu_max", "expected more than 0 where the slope never comes to B");
    most = c3 != 0 ? (std::sqrt(square) - c2) / (3 * c3) : c2 != 0 ? (modulus - c1) / (2 * c2) : 0;
    if (most < 0) unloading.fail("Mu_max", "expected more than 0 where the slope never comes to B");
    if (modulus == c1 && most == 0) modulus = 0;
  }
  InnerKeys<EquationOfStateSettings> pressure;
  pressure.set("form", "polynomial");
  pressure.set("coefficients", std::vector{0.0, c1, c2, c3, 0.0, 0.0, 0.0});
  if (cutoff > 0) pressure.set("tension_limit", cutoff);
  if (modulus > 0) {
    pressure.set("unloading_modulus", std::vector{modulus});
    if (most > 0) pressure.set("full_compaction", most);
    pressure.set("elastic_compaction", 0.0);  // tension that it begins with has the modulus C1
  }
  if (c3 != 0)
    data.report.understood(
        fmt::format("{} ({}): C3 counts in tension, too, in Radioss not", block.title, block.place.text()));
  keys.set("equation_of_state", pressure.value(), "C1, C2, C3, P_min, B, Mu_max");
}

/// /EOS/COMPACTION2: in tension its function goes on below 0 as it begins.
GivenValue given_compaction_by_function(RadiossData& data, const RadiossBlock& block, double tension_limit) {
  RadiossLines lines(block);
  const DataLine first = lines.require("P_fun_id"), second = lines.next_or_blank(), third = lines.next_or_blank();
  const RadiossFields p(first, block, radioss::compaction_function), mu(second, block, radioss::compaction_moduli),
      shift(third, block, radioss::compaction_shift);
  const double least = mu.number("Mue_min"), most = mu.number("Mue_max"), modulus = mu.number("Bmax"),
               scale = p.number("Xscale") == 0 ? 1.0 : p.number("Xscale"),
               begin = p.integer("IFORM") == 1 ? modulus : mu.number("Bmin");
  SoilFunction function = soil_function(data, p.integer("P_fun_id"), p.number("Fscale"),
                                        std::numeric_limits<double>::infinity(), first.place);
  for (double& one : function.mu) one /= scale;
  if (data.function(p.integer("P_fun_id"), first.place).first.front() < 0)
    data.report.understood(fmt::format("{} ({}): below 0 its function goes on as it begins above, in Radioss as given",
                                       block.title, block.place.text()));
  if (least > 0 && most > 0 && least >= most)
    mu.fail("Mue_min", fmt::format("expected less than Mue_max = {:.6g}, got {:.6g}", most, least));
  if (most == 0 && modulus != begin)
    data.report.unused(second.place, block.title + ": Bmax", "without Mue_max it unloads with Bmin");
  InnerKeys<EquationOfStateSettings> keys = crushing_table(function, begin, modulus, most);
  if (tension_limit > 0) keys.set("tension_limit", tension_limit);
  keys.set("elastic_compaction", least);
  return keys.value();
}

}  // namespace

GivenValue given_radioss_state(RadiossData& data, const RadiossBlock& block, double tension_limit) {
  if (block.name == "EOS/COMPACTION") return given_compaction(data, block, tension_limit);
  if (block.name == "EOS/COMPACTION2") return given_compaction_by_function(data, block, tension_limit);
  RadiossLines lines(block);
  const DataLine first = lines.require("the constants of the equation of state");
  const DataLine second = block.name == "EOS/LINEAR" ? DataLine{} : lines.next_or_blank();
  InnerKeys<EquationOfStateSettings> keys;
  if (block.name == "EOS/GRUNEISEN") {
    const RadiossFields a(first, block, radioss::grueneisen), b(second, block, radioss::grueneisen_energy);
    const double gamma = b.number("GAMMA_0"), slope = b.number("a");
    keys.set("sound_speed", a.number("C"));
    keys.set("slopes", a.point("S1"));
    keys.set("gamma", gamma);
    keys.set("gamma_slope", slope == 0 ? gamma : slope);
  } else if (block.name == "EOS/LINEAR") {
    const RadiossFields a(first, block, radioss::linear_state);
    keys.set("form", "polynomial");
    keys.set("coefficients", std::vector{0.0, a.number("B"), 0.0, 0.0, 0.0, 0.0, 0.0});
  } else {
    const RadiossFields a(first, block, radioss::polynomial), b(second, block, radioss::polynomial_energy);
    keys.set("form", "polynomial");
    keys.set("coefficients", std::vector{a.number("C0"), a.number("C1"), a.number("C2"), a.number("C3"), b.number("C4"),
                                         b.number("C5"), 0.0});
  }
  if (tension_limit > 0) keys.set("tension_limit", tension_limit);
  return keys.value();
}

void set_dprag(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const SoilKeys& keys) {
  const DataLine l1 = lines.require("E and nu"), l2 = lines.require("A0, A1, A2 and Amax"),
                 l3 = lines.require("func_IDf and Kt"), l4 = lines.next_or_blank(), l5 = lines.next_or_blank();
  const RadiossFields e(l1, block, radioss::elasticity), a(l2, block, radioss::soil_strength),
      p(l3, block, radioss::soil_function), limits(l4, block, radioss::soil_limits),
      unloading(l5, block, radioss::soil_unloading);
  const SoilStrength strength(a);
  const double cutoff = soil_cutoff(limits), tension = p.number("Kt"),
               modulus = unloading.number("B") > 0 ? unloading.number("B") : tension,
               given = unloading.number("Mu_max"), most = given < 1e19 ? given : 0.0;
  if (!(tension > 0)) p.fail("Kt", fmt::format("expected a number > 0, got {}", tension));
  if (strength.has_no_root() && (cutoff == 0 || -cutoff < strength.least_at()))
    data.report.reject(l2.place, block.title + " whose strength has no root, and grows with tension",
                       fmt::format("give P_min >= {:.6g}, or A0 <= A1^2/(4 A2)", strength.least_at()));
  const SoilFunction function = soil_function(data, p.integer("func_IDf"), p.number("FscaleP"), tension, l3.place);
  keys.set("shear_modulus", shear_modulus(e), "e, nu");
  strength.set(keys);
  if (most == 0 && modulus != tension)
    data.report.understood(fmt::format("{} ({}): without Mu_max it unloads with Kt, and B has no effect", block.title,
                                       block.place.text()));
  InnerKeys<EquationOfStateSettings> pressure = crushing_table(function, tension, modulus, most);
  if (cutoff > 0) pressure.set("tension_limit", cutoff);
  keys.set("equation_of_state", pressure.value(), "func_IDf, FscaleP, Kt, P_min, B, Mu_max");
}

void set_dprag1(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const RadiossBlock* state,
                const SoilKeys& keys) {
  const DataLine l1 = lines.require("E and nu"), l2 = lines.require("A0, A1, A2 and Amax");
  const RadiossFields e(l1, block, radioss::elasticity), a(l2, block, radioss::soil_strength);
  const DataLine l3 = lines.next_or_blank();
  const std::optional<DataLine> l4 = lines.next();
  const DataLine l5 = lines.next_or_blank();
  const RadiossFields limits(l4 ? *l4 : l3, block, radioss::soil_limits);
  const SoilStrength strength(a);
  const double cutoff = soil_cutoff(limits);
  keys.set("shear_modulus", shear_modulus(e), "e, nu");
  double none = cutoff > 0 ? cutoff : -1;  // no strength at the cutoff, nor where a strength without a root is least
  if (strength.has_no_root()) none = none < 0 ? -strength.least_at() : std::min(none, -strength.least_at());
  strength.set(keys, none);
  if (l4) {
    if (state != nullptr)
      data.report.reject(state->place, state->title + " of a /MAT/DPRAG1 that has C1 and B", "leave out these lines");
    set_polynomial_soil(data, block, e, RadiossFields(l3, block, radioss::soil_polynomial),
                        RadiossFields(l5, block, radioss::soil_unloading), cutoff, keys);
  } else if (state != nullptr) {
    keys.set("equation_of_state", given_radioss_state(data, *state, cutoff), state->place.text());
  } else {
    set_linear_soil(e, cutoff, keys);
  }
}

}  // namespace pinball

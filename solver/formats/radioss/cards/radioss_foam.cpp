#include "radioss_foam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <solver/formats/deck/deck_foam.hpp>
#include <solver/formats/radioss/layouts/radioss_material_cards.hpp>

namespace pinball {

namespace {

void tell(RadiossData& data, const RadiossBlock& block, const std::string& what) {
  data.report.understood(fmt::format("{} ({}): {}", block.title, block.place.text(), what));
}

/// Of gamma = V/V_0 - 1, which is minus the compaction.
DeckFoamCurve curve_of_function(RadiossData& data, const RadiossBlock& block, const RadiossFields& f,
                                const DeckPlace& place) {
  const auto& [gamma, stress] = data.function(f.integer("func_IDf"), place);
  const double scale = f.number("Fscale_curv") == 0 ? 1.0 : f.number("Fscale_curv");
  DeckFoamCurve curve;
  for (const double one : gamma) curve.compaction.push_back(0.0 - one);
  for (const double one : stress) curve.stress.push_back(scale * one);
  curve.put_in_order();
  if (curve.end_below_one()) tell(data, block, "what its function has below -1, which no volume reaches, is left out");
  const auto& y = curve.stress;
  if (y.size() > 1 && y[0] != y[1])
    tell(data, block, "where it is less compressed than its function says, it yields as at the end of that");
  return curve;
}

/// |A + B (1 + C gamma)|, to twice the volume.
DeckFoamCurve curve_of_formula(double a, double b, double c) {
  DeckFoamCurve curve{{-1, 1}, {a + b + b * c, a + b - b * c}};
  const double zero = b * c == 0 ? 2 : (a + b) / (b * c);
  if (zero > -1 && zero < 1) {
    curve.compaction.insert(curve.compaction.begin() + 1, zero);
    curve.stress.insert(curve.stress.begin() + 1, 0.0);
  }
  for (double& stress : curve.stress) stress = std::abs(stress);
  curve.end_below_one();
  return curve;
}

}  // namespace

void set_foam_plas(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const DeckKeys<Material>& keys) {
  const DataLine l1 = lines.require("E and func_IDf"), l2 = lines.next_or_blank(), l3 = lines.next_or_blank();
  const RadiossFields e(l1, block, radioss::foam_modulus), air(l2, block, radioss::foam_air),
      y(l3, block, radioss::foam_yield);
  const std::int64_t kind = e.integer("Ka");
  if (kind == 1)
    data.report.reject(l1.place, block.title + " with Ka 1", "give 0 or 2: its skeleton has no viscosity here");
  const double a = y.number("A"), b = y.number("B"), c = y.number("C"), cutoff = y.number("SIG_COFF");
  const bool by_function = e.integer("func_IDf") != 0;
  const DeckFoamCurve curve = by_function ? curve_of_function(data, block, e, l1.place) : curve_of_formula(a, b, c);
  if (by_function && (a != 0 || b != 0 || c != 0))
    data.report.unused(l3.place, block.title + ": A, B and C", "func_IDf is used");
  if (kind == 0 && cutoff != 0) data.report.unused(l3.place, block.title + ": SIG_COFF", "Ka is 0");
  InnerKeys<CrushableFoamSettings> law;
  law.set("compaction", curve.compaction);
  law.set("yield_stress", curve.stress);
  if (kind == 2) {
    const double least = curve.stress.empty() ? 0 : std::ranges::min(curve.stress);
    if (cutoff > least)
      data.report.reject(l3.place, block.title + " whose SIG_COFF is above a yield stress, which is the limit then",
                         fmt::format("give no more than {:.6g}", least));
    if (cutoff > 0) law.set("tension_cutoff", cutoff);
    tell(data, block,
         "where its volume is larger than at rest it yields as at rest; in Radioss it bears no pressure then");
  }
  const double pressure = air.number("P0");
  if (pressure > 0) {
    law.set("air_pressure", pressure);
    law.set("solid_share", air.number("Phi"));
  } else if (air.number("Phi") != 0) {
    data.report.unused(l2.place, block.title + ": Phi", "P0 is 0");
  }
  keys.set("young_modulus", e.number("E"), "E");
  keys.set("poisson_ratio", 0.0);
  keys.set("crushable_foam", law.value(), "func_IDf, A, B, C, P0, Phi, SIG_COFF");
}

GivenValue given_compaction(RadiossData& data, const RadiossBlock& block, double tension_limit) {
  RadiossLines lines(block);
  const DataLine first = lines.require("C0, C1, C2 and C3"), second = lines.next_or_blank(),
                 third = lines.next_or_blank();
  const RadiossFields c(first, block, radioss::compaction), mu(second, block, radioss::compaction_unloading),
      shift(third, block, radioss::compaction_shift);
  const double c1 = c.number("C1"), c2 = c.number("C2"), c3 = c.number("C3"), modulus = mu.number("B"),
               least = mu.number("Mue_min"), most = mu.number("Mue_max");
  if (!(modulus >= c1)) mu.fail("B", fmt::format("expected a number >= C1 = {:.6g}, got {:.6g}", c1, modulus));
  InnerKeys<EquationOfStateSettings> keys;
  keys.set("form", "polynomial");
  keys.set("coefficients", std::vector{0.0, c1, c2, c3, 0.0, 0.0, 0.0});
  if (tension_limit > 0) keys.set("tension_limit", tension_limit);
  if (c2 != 0) tell(data, block, "C2 does not count in tension, in Radioss it does");
  if (!(most > 0)) {
    data.report.unused(second.place, block.title + ": B", "without Mue_max it goes back as it came");
    return keys.value();
  }
  if (least >= most) {
    data.report.unused(second.place, block.title + ": B", "up to Mue_min it goes back as it came");
    return keys.value();
  }
  const bool grows = c.integer("IFORM") != 1;
  keys.set("unloading_modulus", grows ? std::vector{c1, modulus} : std::vector{modulus});
  keys.set("full_compaction", most);
  keys.set("elastic_compaction", least);
  return keys.value();
}

}  // namespace pinball

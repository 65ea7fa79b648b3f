#include "radioss_brittle.hpp"

#include <fmt/format.h>

#include <solver/formats/deck/deck_brittle.hpp>
#include <solver/formats/radioss/layouts/radioss_material_cards.hpp>

namespace pinball {

void set_john_holm(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const DeckKeys<Material>& keys) {
  const DataLine l1 = lines.require("G"), l2 = lines.require("a, b, m and n"), l3 = lines.require("c"),
                 l4 = lines.require("T, HEL and PHEL"), l5 = lines.require("D1 and D2"), l6 = lines.require("K1");
  const RadiossFields g(l1, block, radioss::brittle_modulus), s(l2, block, radioss::brittle_strength),
      r(l3, block, radioss::brittle_rate), h(l4, block, radioss::brittle_limits), d(l5, block, radioss::brittle_damage),
      k(l6, block, radioss::brittle_pressure);
  keys.set("bulk_modulus", k.number("K1"), "K1");
  keys.set("shear_modulus", g.number("G"), "G");
  const std::int64_t erosion = d.integer("IDEL");
  const double strain = d.number("EPSMAX");
  const DeckBrittle law{{s.number("a"), s.number("n")},
                        {s.number("b"), s.number("m")},
                        r.number("SIGMA_FMAX"),
                        r.number("c"),
                        r.number("EPS_DOT_0"),
                        h.number("T"),
                        h.number("HEL"),
                        h.number("PHEL"),
                        {d.number("D1"), d.number("D2")},
                        k.number("K2"),
                        k.number("K3"),
                        k.number("BETA"),
                        erosion == 3};
  if (law.rate_coefficient != 0 && !(law.reference_rate > 0)) r.fail("EPS_DOT_0", "expected more than 0 beside c");
  if (law.rate_coefficient != 0) keys.set("strain_rate", "deviatoric", "EPS_DOT_0");
  for (const DeckBrittle::WithoutEffect& unused : law.without_effect({"EPS_DOT_0", "m", "SIGMA_FMAX", "D2"}))
    data.report.unused(block.place, fmt::format("{}: {}", block.title, unused.field), unused.reason);
  keys.set("johnson_holmquist", law.keys().value(), "a, b, m, n, c, T, HEL, PHEL, D1, D2, K2, K3, BETA");
  if (erosion == 1)
    data.report.reject(l5.place, block.title + " with IDEL 1", "give 0, or 2 or 3: tension alone erodes nothing");
  if (erosion == 2 && strain > 0) keys.set("erosion_strain", strain, "EPSMAX");
  if (erosion != 2 && strain != 0)
    data.report.unused(l5.place, fmt::format("{}: EPSMAX", block.title), "it is of IDEL 2");
}

}  // namespace pinball

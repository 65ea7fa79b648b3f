#include "radioss_rubber.hpp"

#include <fmt/format.h>

#include <solver/formats/radioss/layouts/radioss_material_cards.hpp>

namespace pinball {

namespace {

struct MooneyRivlinTerms {
  double a = 0, b = 0;  ///< of the invariants of b = F F^T [stress]

  double shear_modulus() const { return 2 * (a + b); }
};

/// Adds the terms of five moduli and their exponents.
void add_terms(RadiossData& data, const RadiossBlock& block, const RadiossFields& moduli,
               const RadiossFields& exponents, MooneyRivlinTerms& terms) {
  for (std::size_t i = 0; i < 5; ++i) {
    const double modulus = moduli.number(i), exponent = exponents.number(i);
    const std::string name(exponents.name(i));
    if (modulus == 0) {
      if (exponent != 0)
        data.report.unused(exponents.place(), fmt::format("{}: {}", block.title, name), "its modulus is 0");
    } else if (exponent == 2) {
      terms.a += modulus / 2;
    } else if (exponent == -2) {
      terms.b -= modulus / 2;
    } else {
      data.report.reject(exponents.place(), fmt::format("{} with {} = {}", block.title, name, exponent),
                         "exponents other than 2 and -2 are not done");
    }
  }
}

}  // namespace

void set_ogden(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const DeckKeys<Material>& keys) {
  const DataLine l1 = lines.require("nu"), l2 = lines.require("moduli"), l3 = lines.next_or_blank(),
                 l4 = lines.require("exponents"), l5 = lines.next_or_blank();
  const RadiossFields volume(l1, block, radioss::ogden_volume), moduli(l2, block, radioss::ogden_moduli),
      more_moduli(l3, block, radioss::ogden_moduli_more), exponents(l4, block, radioss::ogden_exponents),
      more_exponents(l5, block, radioss::ogden_exponents_more);
  const double given = volume.number("nu"), nu = given == 0 ? 0.495 : given;
  if (volume.integer("Iform") == 2)
    data.report.unused(l1.place, block.title + ": Iform", "the energy of volumes is that of this program");
  MooneyRivlinTerms terms;
  add_terms(data, block, moduli, exponents, terms);
  add_terms(data, block, more_moduli, more_exponents, terms);
  if (data.report.rejects()) return;
  if (!(terms.shear_modulus() > 0))
    moduli.fail("Mu_1", "expected moduli and exponents whose products have a sum above 0");
  if (terms.b == 0) {
    keys.set("young_modulus", 2 * (1 + nu) * terms.shear_modulus(), "Mu_1 to Mu_10, alpha_1 to alpha_10");
    keys.set("poisson_ratio", nu, "nu");
  } else {
    InnerKeys<MooneyRivlinSettings> law;
    law.set("a", terms.a);
    law.set("b", terms.b);
    law.set("poisson_ratio", nu);
    keys.set("mooney_rivlin", law.value(), "nu, Mu_1 to Mu_10, alpha_1 to alpha_10");
  }
  data.report.understood(fmt::format("{} ({}): {}, with this program's energy of volumes", block.title,
                                     block.place.text(), terms.b == 0 ? "neo-Hookean" : "of Mooney and Rivlin"));
}

}  // namespace pinball

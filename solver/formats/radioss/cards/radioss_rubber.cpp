#include "radioss_rubber.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include <solver/formats/radioss/layouts/radioss_material_cards.hpp>

namespace pinball {

namespace {

/// Powers of stretches; with the exponents 2 and -2 alone the invariants of Mooney and Rivlin.
struct OgdenTerms {
  std::vector<double> moduli{}, exponents{};

  /// W = sum of m/a (...), so that a modulus of an exponent is 2 A, or minus 2 B.
  double of(double exponent) const {
    double sum = 0;
    for (std::size_t p = 0; p < moduli.size(); ++p) sum += exponents[p] == exponent ? moduli[p] : 0;
    return sum;
  }
  bool are_mooneys() const {
    return std::ranges::all_of(exponents, [](double one) { return one == 2 || one == -2; });
  }
  double shear_modulus() const {
    double sum = 0;
    for (std::size_t p = 0; p < moduli.size(); ++p) sum += 0.5 * moduli[p] * exponents[p];
    return sum;
  }
};

/// Adds the terms of five moduli and their exponents.
void add_terms(RadiossData& data, const RadiossBlock& block, const RadiossFields& moduli,
               const RadiossFields& exponents, OgdenTerms& terms) {
  for (std::size_t i = 0; i < 5; ++i) {
    const double modulus = moduli.number(i), exponent = exponents.number(i);
    const std::string name(exponents.name(i));
    if (modulus == 0) {
      if (exponent != 0)
        data.report.unused(exponents.place(), fmt::format("{}: {}", block.title, name), "its modulus is 0");
    } else if (exponent == 0) {
      exponents.fail(name, "expected a number that is not 0, got 0");
    } else {
      terms.moduli.push_back(modulus);
      terms.exponents.push_back(exponent);
    }
  }
}

void require_stiffness(const OgdenTerms& terms, const RadiossFields& moduli) {
  if (!(terms.shear_modulus() > 0))
    moduli.fail("Mu_1", "expected moduli and exponents whose products have a sum above 0");
}

void set_powers(const OgdenTerms& terms, double nu, const char* stretches, const DeckKeys<Material>& keys) {
  InnerKeys<OgdenSettings> law;
  law.set("moduli", terms.moduli);
  law.set("exponents", terms.exponents);
  law.set("poisson_ratio", nu);
  law.set("stretches", stretches);
  keys.set("ogden", law.value(), "nu, Mu_1 to Mu_10, alpha_1 to alpha_10");
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
  OgdenTerms terms;
  add_terms(data, block, moduli, exponents, terms);
  add_terms(data, block, more_moduli, more_exponents, terms);
  if (data.report.rejects()) return;
  require_stiffness(terms, moduli);
  if (!terms.are_mooneys()) return set_powers(terms, nu, "shape", keys);
  const double a = terms.of(2) / 2, b = -terms.of(-2) / 2;
  if (b == 0) {
    keys.set("young_modulus", 2 * (1 + nu) * terms.shear_modulus(), "Mu_1 to Mu_10, alpha_1 to alpha_10");
    keys.set("poisson_ratio", nu, "nu");
  } else {
    InnerKeys<MooneyRivlinSettings> law;
    law.set("a", a);
    law.set("b", b);
    law.set("poisson_ratio", nu);
    keys.set("mooney_rivlin", law.value(), "nu, Mu_1 to Mu_10, alpha_1 to alpha_10");
  }
  data.report.understood(fmt::format("{} ({}): {}, with this program's energy of volumes", block.title,
                                     block.place.text(), b == 0 ? "neo-Hookean" : "of Mooney and Rivlin"));
}

/// W = sum of 2 mu/alpha^2 (...): m = 2 mu/alpha.
void set_visc_hyp(RadiossData& data, const RadiossBlock& block, RadiossLines& lines, const DeckKeys<Material>& keys) {
  const DataLine l1 = lines.require("nu and N");
  const RadiossFields head(l1, block, radioss::visc_hyp);
  const std::int64_t count = head.integer("N");
  const bool more = count > 5;
  const DataLine l2 = lines.require("moduli"), l3 = more ? lines.require("more moduli") : DataLine{{}, l2.place},
                 l4 = lines.require("exponents"), l5 = more ? lines.require("more exponents") : DataLine{{}, l4.place};
  const RadiossFields moduli(l2, block, radioss::ogden_moduli), more_moduli(l3, block, radioss::ogden_moduli_more),
      exponents(l4, block, radioss::ogden_exponents), more_exponents(l5, block, radioss::ogden_exponents_more);
  OgdenTerms terms;
  for (std::int64_t i = 0; i < count; ++i) {
    const std::size_t place = i % 5;
    const double exponent = (i < 5 ? exponents : more_exponents).number(place);
    const double a = exponent == 0 ? 1 : exponent, modulus = (i < 5 ? moduli : more_moduli).number(place);
    if (modulus == 0) continue;
    terms.moduli.push_back(2 * modulus / a);
    terms.exponents.push_back(a);
  }
  if (const auto next = lines.next_filled())
    data.report.reject(next->place, block.title + " with lines behind its exponents",
                       "there is no viscosity, and one Poisson's ratio");
  if (data.report.rejects()) return;
  require_stiffness(terms, moduli);
  const double nu = head.number("nu");
  set_powers(terms, nu >= 0.5 ? 0.499 : nu, "whole", keys);
}

}  // namespace pinball

#include "deck_elastic_laws.hpp"

#include <fmt/format.h>

#include <vector>

#include <solver/formats/lsdyna/layouts/definition_cards.hpp>

namespace pinball {

void set_rubber(DeckData& data, const Fields& f, Cards& cards, const DeckKeys<Material>& keys) {
  const Card card = cards.next_or_blank();
  const Fields more = data.fields(card, layout::mooney_rivlin_test);
  InnerKeys<MooneyRivlinSettings> rubber;
  rubber.set("a", f.number("A"));
  rubber.set("b", f.number("B"));
  rubber.set("poisson_ratio", f.number("PR"));
  keys.set("mooney_rivlin", rubber.value(), "a, b, pr");
}

void set_ogden(DeckData& data, const KeywordBlock& block, const Fields& f, Cards& cards,
               const DeckKeys<Material>& keys) {
  const Card first = cards.next_or_blank(), second = cards.next_or_blank();
  const Fields moduli = data.fields(first, layout::ogden_moduli),
               exponents = data.fields(second, layout::ogden_exponents);
  std::vector<double> m, a;
  for (int p = 1; p <= 8; ++p) {
    const double modulus = moduli.number(fmt::format("MU{}", p)),
                 exponent = exponents.number(fmt::format("ALPHA{}", p));
    if (modulus == 0 && exponent == 0) continue;
    if (modulus == 0 || exponent == 0)
      moduli.fail(fmt::format("MU{}", p), "expected a modulus with an exponent, both other than 0");
    m.push_back(modulus);
    a.push_back(exponent);
  }
  if (const auto next = cards.next_filled()) data.report.reject(next->place, block.star_name() + " with viscosity");
  InnerKeys<OgdenSettings> law;
  law.set("moduli", m);
  law.set("exponents", a);
  law.set("poisson_ratio", f.number("PR"));
  keys.set("ogden", law.value(), "mu1 to mu8, alpha1 to alpha8, pr");
  data.report.understood(
      fmt::format("{} ({}): with this program's energy of volumes", block.star_name(), f.place().text()));
}

/// PRBA is the contraction along a in tension along b, PRBA/EB = nu_ab/EA, and so on.
void set_orthotropic(DeckData& data, const Fields& f, Cards& cards, const DeckKeys<Material>& keys) {
  const Card shear = cards.next_or_blank(), first = cards.next_or_blank(), second = cards.next_or_blank();
  const Fields g = data.fields(shear, layout::orthotropic_shear), a = data.fields(first, layout::orthotropic_first),
               d = data.fields(second, layout::orthotropic_second);
  if (g.number("AOPT") != 2)
    g.fail("AOPT", fmt::format("expected 2, axes by A and D that are the same everywhere, got {}", g.number("AOPT")));
  const double ea = f.number("EA"), eb = f.number("EB"), ec = f.number("EC");
  if (!(eb > 0)) f.fail("EB", fmt::format("expected more than 0, got {}", eb));
  if (!(ec > 0)) f.fail("EC", fmt::format("expected more than 0, got {}", ec));
  InnerKeys<OrthotropicSettings> law;
  law.set("young_moduli", Point{ea, eb, ec});
  law.set("poisson_ratios", Point{f.number("PRBA") * ea / eb, f.number("PRCA") * ea / ec, f.number("PRCB") * eb / ec});
  law.set("shear_moduli", Point{g.number("GAB"), g.number("GCA"), g.number("GBC")});
  law.set("first_axis", a.point("A1"));
  law.set("second_axis", d.point("D1"));
  keys.set("orthotropic", law.value(), "ea, eb, ec, prba, prca, prcb, gab, gbc, gca, a, d");
}

}  // namespace pinball

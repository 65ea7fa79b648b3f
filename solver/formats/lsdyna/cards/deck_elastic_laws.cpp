#include "deck_elastic_laws.hpp"

#include <fmt/format.h>

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

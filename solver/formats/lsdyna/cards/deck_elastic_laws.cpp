#include "deck_elastic_laws.hpp"

#include <fmt/format.h>

#include <map>
#include <vector>

#include <solver/formats/lsdyna/layouts/definition_cards.hpp>

namespace pinball {

namespace {

/// Powers of stretches of a card; names: its keys, for messages.
struct Powers {
  std::vector<double> moduli{}, exponents{};  ///< m_p [stress], a_p [-]
  double poisson = 0;                         ///< of small strains [-]

  void add(double modulus, double exponent) {
    if (modulus == 0) return;
    moduli.push_back(modulus);
    exponents.push_back(exponent);
  }
  void set(const DeckKeys<Material>& keys, const char* stretches, const char* names) const {
    InnerKeys<OgdenSettings> law;
    law.set("moduli", moduli);
    law.set("exponents", exponents);
    law.set("poisson_ratio", poisson);
    law.set("stretches", stretches);
    keys.set("ogden", law.value(), names);
  }
};

/// Eight moduli on a line, and eight exponents on the next.
void add_pairs(const Fields& moduli, const Fields& exponents, const std::string& modulus_name,
               const std::string& exponent_name, Powers& powers) {
  for (int p = 1; p <= 8; ++p) {
    const double modulus = moduli.number(fmt::format("{}{}", modulus_name, p)),
                 exponent = exponents.number(fmt::format("{}{}", exponent_name, p));
    if ((modulus == 0) != (exponent == 0))
      moduli.fail(fmt::format("{}{}", modulus_name, p), "expected a modulus with an exponent, both other than 0");
    powers.add(modulus, exponent);
  }
}

void set_rubber(DeckData& data, const Fields& f, Cards& cards, const DeckKeys<Material>& keys) {
  const Card card = cards.next_or_blank();
  const Fields more = data.fields(card, layout::mooney_rivlin_test);
  InnerKeys<MooneyRivlinSettings> rubber;
  rubber.set("a", f.number("A"));
  rubber.set("b", f.number("B"));
  rubber.set("poisson_ratio", f.number("PR"));
  keys.set("mooney_rivlin", rubber.value(), "a, b, pr");
}

void tell_energy_of_volumes(DeckData& data, const KeywordBlock& block, const Fields& f) {
  data.report.understood(
      fmt::format("{} ({}): with this program's energy of volumes", block.star_name(), f.place().text()));
}

void set_ogden(DeckData& data, const KeywordBlock& block, const Fields& f, Cards& cards,
               const DeckKeys<Material>& keys) {
  const Card first = cards.next_or_blank(), second = cards.next_or_blank();
  const Fields moduli = data.fields(first, layout::ogden_moduli),
               exponents = data.fields(second, layout::ogden_exponents);
  Powers powers;
  add_pairs(moduli, exponents, "MU", "ALPHA", powers);
  if (const auto next = cards.next_filled()) data.report.reject(next->place, block.star_name() + " with viscosity");
  powers.poisson = f.number("PR");
  powers.set(keys, "shape", "mu1 to mu8, alpha1 to alpha8, pr");
  tell_energy_of_volumes(data, block, f);
}

/// sigma = G (b/J - J^(-1/(1 - 2 nu)) I) with nu = 0.463: the energy of Blatz and Ko (Trans. Soc. Rheol. 6, 223-251,
/// 1962) for solid rubber, of the whole stretches with one exponent, 2.
void set_blatz_ko(const Fields& f, const DeckKeys<Material>& keys) {
  Powers powers;
  powers.add(f.number("G"), 2);
  powers.poisson = 0.463;
  powers.set(keys, "whole", "g");
}

/// W = sum of C_pq (I - 3)^p (II - 3)^q of shape. With x_i the squares of its stretches, x_1 x_2 x_3 = 1, II is the sum
/// of 1/x_i, I^2 that of x_i^2 + 2/x_i and II^2 that of 1/x_i^2 + 2 x_i: (I - 3)^2 and (II - 3)^2 are sums of powers,
/// and I II and I^3 are not.
void set_hyperelastic(DeckData& data, const KeywordBlock& block, const Fields& f, Cards& cards,
                      const DeckKeys<Material>& keys) {
  const Card card = cards.next_or_blank();
  const Fields c = data.fields(card, layout::hyperelastic_constants);
  if (const auto next = cards.next_filled()) data.report.reject(next->place, block.star_name() + " with viscosity");
  const double c10 = c.number("C10"), c01 = c.number("C01"), c20 = c.number("C20"), c02 = c.number("C02");
  if (!(c10 + c01 > 0)) c.fail("C10", fmt::format("expected C10 + C01 > 0, got {:.6g}", c10 + c01));
  Powers powers;
  powers.add(2 * (c10 - 6 * c20 + 2 * c02), 2);
  powers.add(-2 * (c01 - 6 * c02 + 2 * c20), -2);
  powers.add(4 * c20, 4);
  powers.add(-4 * c02, -4);
  powers.poisson = f.number("PR");
  powers.set(keys, "shape", "c10, c01, c20, c02, pr");
  tell_energy_of_volumes(data, block, f);
}

/// W = sum of C_j/b_j (l_1^b_j + l_2^b_j + l_3^b_j - 3 + (J^(-N b_j) - 1)/N).
void set_hill_foam(DeckData& data, const Fields& f, Cards& cards, const DeckKeys<Material>& keys) {
  const Card first = cards.next_or_blank(), second = cards.next_or_blank(), third = cards.next_or_blank();
  const Fields moduli = data.fields(first, layout::hill_moduli),
               exponents = data.fields(second, layout::hill_exponents),
               unloading = data.fields(third, layout::hill_unloading);
  Powers powers;
  add_pairs(moduli, exponents, "C", "B", powers);
  const double n = f.number("N");
  powers.poisson = n / (1 + 2 * n);
  powers.set(keys, "whole", "c1 to c8, b1 to b8, n");
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

}  // namespace

std::optional<DeckEnergy> energy_of(const std::string& kind) {
  static const std::map<std::string, DeckEnergy> kinds{{"MAT_ORTHOTROPIC_ELASTIC", DeckEnergy::orthotropic},
                                                       {"MAT_BLATZ-KO_RUBBER", DeckEnergy::blatz_ko},
                                                       {"MAT_MOONEY-RIVLIN_RUBBER", DeckEnergy::mooney_rivlin},
                                                       {"MAT_HYPERELASTIC_RUBBER", DeckEnergy::hyperelastic},
                                                       {"MAT_OGDEN_RUBBER", DeckEnergy::ogden},
                                                       {"MAT_HILL_FOAM", DeckEnergy::hill_foam}};
  const auto found = kinds.find(kind);
  return found == kinds.end() ? std::nullopt : std::optional(found->second);
}

const CardLayout& layout_of(DeckEnergy energy) {
  switch (energy) {
    case DeckEnergy::orthotropic:
      return layout::orthotropic;
    case DeckEnergy::blatz_ko:
      return layout::blatz_ko;
    case DeckEnergy::mooney_rivlin:
      return layout::mooney_rivlin;
    case DeckEnergy::hyperelastic:
      return layout::hyperelastic;
    case DeckEnergy::ogden:
      return layout::ogden;
    case DeckEnergy::hill_foam:
      break;
  }
  return layout::hill_foam;
}

void set_energy(DeckData& data, DeckEnergy energy, const KeywordBlock& block, const Fields& f, Cards& cards,
                const DeckKeys<Material>& keys) {
  switch (energy) {
    case DeckEnergy::orthotropic:
      set_orthotropic(data, f, cards, keys);
      break;
    case DeckEnergy::blatz_ko:
      set_blatz_ko(f, keys);
      break;
    case DeckEnergy::mooney_rivlin:
      set_rubber(data, f, cards, keys);
      break;
    case DeckEnergy::hyperelastic:
      set_hyperelastic(data, block, f, cards, keys);
      break;
    case DeckEnergy::ogden:
      set_ogden(data, block, f, cards, keys);
      break;
    case DeckEnergy::hill_foam:
      set_hill_foam(data, f, cards, keys);
      break;
  }
}

}  // namespace pinball

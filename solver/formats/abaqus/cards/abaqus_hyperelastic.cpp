#include "abaqus_hyperelastic.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include <solver/base/error.hpp>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

/// What Abaqus/Explicit and CalculiX take where D1 is 0 or left out: K/G = 20.
constexpr double poisson_without_d1 = 29. / 61;

/// Of the constants behind the name of a keyword, so many to a line; of one set of them alone.
std::vector<double> constants_of(const AbaqusBlock& block, const char* what, std::size_t needed, std::size_t most) {
  DataLines lines(block);
  std::vector<double> numbers;
  while (numbers.size() < most) {
    const auto card = numbers.size() >= needed ? lines.next() : std::optional(lines.require(what));
    if (!card) break;
    const DataFields f(*card);
    for (std::size_t i = 0; i < 8 && numbers.size() < most; ++i)
      numbers.push_back(numbers.size() < needed ? f.number(i, what) : f.number(i, what, 0.0));
  }
  if (lines.next()) fail_at(block.place, block.star_name() + ": expected constants that do not depend on temperature");
  numbers.resize(most, 0.0);
  return numbers;
}

std::size_t terms_of(const AbaqusBlock& block, const std::string& form, double most) {
  const double given = block.number("N", 1);
  if (!(given >= 1 && given <= most && given == std::floor(given)))
    fail_at(block.place, fmt::format("{}: N: expected 1 to {}, got {}", form, most, given));
  return static_cast<std::size_t>(given);
}

/// Terms of OGDEN or of *HYPERFOAM: mu and alpha of each, then D or nu of each, which are returned.
std::vector<double> read_powers(const AbaqusBlock& block, const std::string& form, bool has_last,
                                AbaqusRubber& rubber) {
  const std::size_t count = terms_of(block, form, 6);
  std::vector<double> numbers = constants_of(block, "mu and alpha of each term", 2 * count, (has_last ? 3 : 2) * count);
  for (std::size_t p = 0; p < count; ++p) {
    const double mu = numbers[2 * p], alpha = numbers[2 * p + 1];
    if (mu == 0 || alpha == 0) fail_at(block.place, form + ": mu and alpha: expected numbers that are not 0, got 0");
    rubber.moduli.push_back(2 * mu / alpha);
    rubber.exponents.push_back(alpha);
  }
  numbers.erase(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(2 * count));
  return numbers;
}

/// (I - 3)^2 and (II - 3)^2 of shape are sums of powers of its stretches, whose product is 1: I^2 is the sum of l^4 and
/// 2 l^-2, II^2 that of l^-4 and 2 l^2.
void add_squares(double c20, double c02, AbaqusRubber& rubber) {
  if (c20 == 0 && c02 == 0) return;
  const std::array<double, 4> moduli{2 * (rubber.a - 6 * c20 + 2 * c02), -2 * (rubber.b - 6 * c02 + 2 * c20), 4 * c20,
                                     -4 * c02},
      exponents{2, -2, 4, -4};
  for (std::size_t p = 0; p < moduli.size(); ++p) {
    if (moduli[p] == 0) continue;
    rubber.moduli.push_back(moduli[p]);
    rubber.exponents.push_back(exponents[p]);
  }
  rubber.a = rubber.b = 0;
}

/// Places of C10, C01, C20, C02 among the constants of a form; below 0: it has none. Those that have no place have to
/// be 0; then D of each term.
struct Polynomial {
  std::string form;
  std::size_t terms = 1, constants = 1;
  int c01 = -1, c20 = -1, c02 = -1;
};

Polynomial polynomial_of(const AbaqusBlock& block) {
  if (block.has("NEOHOOKE")) return {"NEO HOOKE", 1, 1};
  if (block.has("MOONEY-RIVLIN")) return {"MOONEY-RIVLIN", 1, 2, 1};
  if (block.has("YEOH")) return {"YEOH", 3, 3, -1, 1};
  const bool is_reduced = block.has("REDUCEDPOLYNOMIAL");
  const std::string form = is_reduced ? "REDUCED POLYNOMIAL" : "POLYNOMIAL";
  const std::size_t n = terms_of(block, "*HYPERELASTIC, " + form, 6);
  if (is_reduced) return {form, n, n, -1, n > 1 ? 1 : -1};
  return {form, n, n * (n + 3) / 2, 1, n > 1 ? 2 : -1, n > 1 ? 4 : -1};
}

/// Returns D1.
double read_polynomial(const AbaqusBlock& block, AbaqusRubber& rubber) {
  const Polynomial which = polynomial_of(block);
  const std::string names = which.c01 < 0 ? "C10 and D1" : "C10, C01 and D1";
  const std::vector<double> c =
      constants_of(block, names.c_str(), which.c01 < 0 ? 1 : 2, which.constants + which.terms);
  const auto at = [&](int place) { return place < 0 ? 0.0 : c[place]; };
  for (std::size_t i = 1; i < which.constants; ++i) {
    const int place = static_cast<int>(i);
    if (c[i] != 0 && place != which.c01 && place != which.c20 && place != which.c02)
      fail_at(block.place,
              fmt::format("*HYPERELASTIC, {}: expected C10, C01, C20 and C02 alone: the others, as C11 and "
                          "C30, are no sums of powers of stretches",
                          which.form));
  }
  for (std::size_t i = 1; i < which.terms; ++i) {
    if (c[which.constants + i] != 0)
      fail_at(block.place,
              fmt::format("*HYPERELASTIC, {}: expected D1 alone: of D2 on there are no terms", which.form));
  }
  rubber.a = c[0];
  rubber.b = at(which.c01);
  add_squares(at(which.c20), at(which.c02), rubber);
  return c[which.constants];
}

void require_constants(bool good, const AbaqusBlock& block, const char* field, const std::string& expected) {
  if (!good) fail_at(block.place, fmt::format("{}: {}: expected {}", block.star_name(), field, expected));
}

/// W = sum of 2 mu/alpha^2 (l_1^alpha + l_2^alpha + l_3^alpha - 3 + (J^(-alpha beta) - 1)/beta): the energy of whole
/// stretches where all terms have one beta = nu/(1 - 2 nu).
AbaqusRubber abaqus_foam(const AbaqusBlock& block) {
  AbaqusRubber foam;
  foam.whole = true;
  const bool has_one = block.has("POISSON");
  const std::vector<double> ratios = read_powers(block, "*HYPERFOAM", !has_one, foam);
  foam.poisson = has_one ? block.number("POISSON", 0.0) : ratios.front();
  for (const double nu : ratios)
    require_constants(nu == foam.poisson, block, "nu",
                      fmt::format("one Poisson's ratio of all terms, got {:.6g} and {:.6g}", foam.poisson, nu));
  require_constants(foam.poisson >= 0 && foam.poisson < 0.5, block, "nu",
                    fmt::format("a number >= 0 and < 0.5, got {}", foam.poisson));
  require_constants(foam.shear_modulus() > 0, block, "mu", "constants with a sum above 0");
  return foam;
}

}  // namespace

double AbaqusRubber::shear_modulus() const {
  double sum = 2 * (a + b);
  for (std::size_t p = 0; p < moduli.size(); ++p) sum += 0.5 * moduli[p] * exponents[p];
  return sum;
}

/// K = 2/D1, and G = 2 (C10 + C01) or the sum of mu, at small strains.
AbaqusRubber abaqus_rubber(const AbaqusBlock& block) {
  if (block.name == "HYPERFOAM") return abaqus_foam(block);
  AbaqusRubber rubber;
  const bool is_ogden = block.has("OGDEN");
  double d1 = 0;
  if (is_ogden) {
    const std::vector<double> d = read_powers(block, "*HYPERELASTIC, OGDEN", true, rubber);
    d1 = d.front();
    for (std::size_t p = 1; p < d.size(); ++p) {
      if (d[p] != 0) fail_at(block.place, "*HYPERELASTIC, OGDEN: expected D1 alone: of D2 on there are no terms");
    }
  } else {
    d1 = read_polynomial(block, rubber);
  }
  const double shear = rubber.shear_modulus();
  require_constants(shear > 0, block, is_ogden ? "mu" : "C10", "constants with a sum above 0");
  require_constants(d1 >= 0, block, "D1", fmt::format("0 or more, got {}", d1));
  const double bulk = d1 > 0 ? 2 / d1 : 0;
  rubber.poisson = d1 > 0 ? (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear)) : poisson_without_d1;
  return rubber;
}

void set_hyperelasticity(AbaqusData& data, const WrittenMaterial& material, const AbaqusBlock& block,
                         MaterialKeys keys) {
  for (const char* other : {"ELASTIC", "PLASTIC"}) {
    if (const AbaqusBlock* beside = material.deck.option(other))
      data.report.reject(beside->place, beside->star_name() + " beside " + block.star_name(), "give one of both");
  }
  const AbaqusRubber rubber = abaqus_rubber(block);
  keys.from({block.star_name(), block.place});
  if (!rubber.moduli.empty()) {
    InnerKeys<OgdenSettings> law;
    law.set("moduli", rubber.moduli);
    law.set("exponents", rubber.exponents);
    law.set("poisson_ratio", rubber.poisson);
    if (rubber.whole) law.set("stretches", "whole");
    keys.set("ogden", law.value());
    data.report.understood(fmt::format("{} ({}): of powers of stretches, Poisson's ratio {:.6g}", block.star_name(),
                                       block.place.text(), rubber.poisson));
    return;
  }
  if (rubber.b == 0) {
    keys.set("young_modulus", rubber.young_modulus());
    keys.set("poisson_ratio", rubber.poisson);
  } else {
    InnerKeys<MooneyRivlinSettings> law;
    law.set("a", rubber.a);
    law.set("b", rubber.b);
    law.set("poisson_ratio", rubber.poisson);
    keys.set("mooney_rivlin", law.value());
  }
  data.report.understood(
      fmt::format("*HYPERELASTIC ({}): {}, Poisson's ratio {:.6g}, with this program's energy of "
                  "volumes",
                  block.place.text(), rubber.b == 0 ? "neo-Hookean" : "of Mooney and Rivlin", rubber.poisson));
}

}  // namespace pinball

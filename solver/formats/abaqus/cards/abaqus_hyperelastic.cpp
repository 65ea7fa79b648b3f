#include "abaqus_hyperelastic.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include <solver/base/error.hpp>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

/// What Abaqus/Explicit and CalculiX take where D1 is 0 or left out: K/G = 20.
constexpr double poisson_without_d1 = 29. / 61;

/// Terms of OGDEN: mu and alpha of each, then D of each, eight numbers to a line.
void read_powers(const AbaqusBlock& block, AbaqusRubber& rubber, double& d1) {
  const double given = block.number("N", 1);
  if (!(given >= 1 && given <= 6 && given == std::floor(given)))
    fail_at(block.place, fmt::format("*HYPERELASTIC, OGDEN: N: expected 1 to 6, got {}", given));
  const auto count = static_cast<std::size_t>(given);
  DataLines lines(block);
  std::vector<double> numbers;
  while (numbers.size() < 3 * count) {
    // D1 and all behind it may be left out
    const bool is_whole = numbers.size() >= 2 * count;
    const auto card = is_whole ? lines.next() : std::optional(lines.require("mu and alpha of each term"));
    if (!card) break;
    const DataFields f(*card);
    for (std::size_t i = 0; i < 8 && numbers.size() < 3 * count; ++i) {
      const bool of_term = numbers.size() < 2 * count;
      numbers.push_back(of_term ? f.number(i, numbers.size() % 2 == 0 ? "mu" : "alpha") : f.number(i, "D", 0.0));
      if (of_term && numbers.back() == 0) f.fail("mu and alpha", "expected numbers that are not 0, got 0");
    }
  }
  if (lines.next()) fail_at(block.place, "*HYPERELASTIC, OGDEN: expected constants that do not depend on temperature");
  numbers.resize(3 * count, 0.0);
  for (std::size_t p = 0; p < count; ++p) {
    rubber.moduli.push_back(2 * numbers[2 * p] / numbers[2 * p + 1]);
    rubber.exponents.push_back(numbers[2 * p + 1]);
    if (p > 0 && numbers[2 * count + p] != 0)
      fail_at(block.place, "*HYPERELASTIC, OGDEN: expected D1 alone: of D2 on there are no terms");
  }
  d1 = numbers[2 * count];
}

}  // namespace

double AbaqusRubber::shear_modulus() const {
  double sum = 2 * (a + b);
  for (std::size_t p = 0; p < moduli.size(); ++p) sum += 0.5 * moduli[p] * exponents[p];
  return sum;
}

/// K = 2/D1, and G = 2 (C10 + C01) or the sum of mu, at small strains.
AbaqusRubber abaqus_rubber(const AbaqusBlock& block) {
  AbaqusRubber rubber;
  double d1 = 0;
  if (block.has("OGDEN")) {
    read_powers(block, rubber, d1);
  } else {
    const bool is_neo_hookean = block.has("NEOHOOKE");
    const DataLine card = only_card(block, is_neo_hookean ? "C10 and D1" : "C10, C01 and D1");
    const DataFields f(card);
    rubber.a = f.number(0, "C10");
    if (!is_neo_hookean) rubber.b = f.number(1, "C01");
    d1 = f.number(is_neo_hookean ? 1 : 2, "D1", 0.0);
  }
  const double shear = rubber.shear_modulus();
  const auto require = [&](bool good, const char* field, const std::string& expected) {
    if (!good) fail_at(block.place, fmt::format("*HYPERELASTIC: {}: expected {}", field, expected));
  };
  require(shear > 0, block.has("OGDEN") ? "mu" : "C10", "constants with a sum above 0");
  require(d1 >= 0, "D1", fmt::format("0 or more, got {}", d1));
  const double bulk = d1 > 0 ? 2 / d1 : 0;
  rubber.poisson = d1 > 0 ? (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear)) : poisson_without_d1;
  return rubber;
}

void set_hyperelasticity(AbaqusData& data, const WrittenMaterial& material, const AbaqusBlock& block,
                         MaterialKeys keys) {
  for (const char* other : {"ELASTIC", "PLASTIC"}) {
    if (const AbaqusBlock* beside = material.deck.option(other))
      data.report.reject(beside->place, beside->star_name() + " beside *HYPERELASTIC", "give one of both");
  }
  const AbaqusRubber rubber = abaqus_rubber(block);
  keys.from({"*HYPERELASTIC", block.place});
  if (!rubber.moduli.empty()) {
    InnerKeys<OgdenSettings> law;
    law.set("moduli", rubber.moduli);
    law.set("exponents", rubber.exponents);
    law.set("poisson_ratio", rubber.poisson);
    keys.set("ogden", law.value());
    data.report.understood(fmt::format("*HYPERELASTIC ({}): of powers of stretches, Poisson's ratio {:.6g}",
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

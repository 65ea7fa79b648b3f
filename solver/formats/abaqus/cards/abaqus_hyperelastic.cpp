#include "abaqus_hyperelastic.hpp"

#include <fmt/format.h>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

/// What Abaqus/Explicit and CalculiX take where D1 is 0 or left out: K/G = 20.
constexpr double poisson_without_d1 = 29. / 61;

}  // namespace

/// K = 2/D1 and G = 2 (C10 + C01) at small strains.
AbaqusRubber abaqus_rubber(const AbaqusBlock& block) {
  const bool is_neo_hookean = block.has("NEOHOOKE");
  const DataLine card = only_card(block, is_neo_hookean ? "C10 and D1" : "C10, C01 and D1");
  const DataFields f(card);
  AbaqusRubber rubber;
  rubber.a = f.number(0, "C10");
  if (!is_neo_hookean) rubber.b = f.number(1, "C01");
  const double shear = 2 * (rubber.a + rubber.b), d1 = f.number(is_neo_hookean ? 1 : 2, "D1", 0.0);
  if (!(shear > 0)) f.fail("C10", "expected constants with a sum above 0");
  if (d1 < 0) f.fail("D1", fmt::format("expected 0 or more, got {}", d1));
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

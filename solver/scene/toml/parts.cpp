#include "parts.hpp"

#include <fmt/format.h>

#include <limits>
#include <string_view>

#include <solver/scene/machine.hpp>
#include <solver/scene/schema/scene.hpp>

#include "read_keys.hpp"

namespace pinball {

namespace {

/// K and G, given as they are or by E and nu.
void read_moduli(const SceneTable& table, Material& material) {
  const auto number = [&](const char* key) { return table.number(key, schema::about<Material>(key).bound); };
  if (material.mooney_rivlin || material.ogden || material.orthotropic) {
    const std::string_view law = material.mooney_rivlin ? "mooney_rivlin" : material.ogden ? "ogden" : "orthotropic";
    for (const char* key : {"bulk_modulus", "shear_modulus", "young_modulus", "poisson_ratio"}) {
      if (table.has(key)) table.fail(key, fmt::format("expected none beside {}, which has its own", law));
    }
    return;
  }
  if (material.equation_of_state) {  // K is that of its pressure
    for (const char* key : {"bulk_modulus", "young_modulus", "poisson_ratio"}) {
      if (table.has(key)) table.fail(key, "expected none beside equation_of_state, but shear_modulus");
    }
    if (material.fluid) {
      if (table.has("shear_modulus")) table.fail("shear_modulus", "expected none beside fluid, which has no strength");
      return;
    }
    material.shear_modulus = number("shear_modulus");
    return;
  }
  const bool young = table.has("young_modulus") || table.has("poisson_ratio");
  const bool bulk = table.has("bulk_modulus") || table.has("shear_modulus");
  if (young == bulk) {
    table.fail(young ? "young_modulus" : "bulk_modulus",
               fmt::format("expected either bulk_modulus and shear_modulus or young_modulus and poisson_ratio, got {}",
                           young ? "keys of both" : "none of them"));
  }
  if (bulk) {
    material.bulk_modulus = number("bulk_modulus");
    material.shear_modulus = number("shear_modulus");
    return;
  }
  const double E = number("young_modulus"), nu = number("poisson_ratio");
  material.bulk_modulus = E / (3.0 * (1.0 - 2.0 * nu));
  material.shear_modulus = E / (2.0 * (1.0 + nu));
}

YieldCurve read_yield_curve(const SceneTable& table, bool with_rate) {
  YieldCurve curve;
  if (with_rate) curve.rate = table.number("rate", schema::about<YieldCurve>("rate").bound);
  read_keys(table, curve);
  table.require_none(problem_of(curve));
  return curve;
}

/// One curve, or some of different rates, in the place of the numbers of linear hardening.
void read_yield_curves(const SceneTable& table, Material& material) {
  const bool one = table.has("yield_curve");
  if (!one && !table.has("yield_curves")) return;
  const std::string_view key = one ? "yield_curve" : "yield_curves";
  for (const std::string_view other : {"yield_curves", "yield_stress", "plastic_modulus", "ultimate_stress"}) {
    if (other != key && table.has(other)) table.fail(other, fmt::format("expected none beside {}", key));
  }
  if (one) {
    material.yield_curves.push_back(read_yield_curve(table.table(key, key), false));
    return;
  }
  for (const SceneTable& curve : table.tables(key, key)) material.yield_curves.push_back(read_yield_curve(curve, true));
  if (material.yield_curves.empty()) table.fail(key, "expected at least one curve, got none");
}

/// What only plasticity needs.
void forget_plasticity(Material& material) {
  Material elastic;
  elastic.name = material.name;
  elastic.density = material.density;
  elastic.bulk_modulus = material.bulk_modulus;
  elastic.shear_modulus = material.shear_modulus;
  elastic.mooney_rivlin = material.mooney_rivlin;
  elastic.ogden = material.ogden;
  elastic.orthotropic = material.orthotropic;
  elastic.erosion = material.erosion;
  material = elastic;
}

}  // namespace

Material read_material(const SceneTable& table) {
  Material material;
  material.ultimate_stress = std::numeric_limits<double>::infinity();
  read_keys(table, material);
  read_moduli(table, material);
  read_yield_curves(table, material);
  if (has_yield_stress(material) && material.yield_curves.empty() && !table.has("yield_stress")) {
    table.fail_missing("yield_stress", schema::about<Material>("yield_stress").bound.describe());
  }
  complete(material);
  table.require_none(problem_of(material));
  // An elastic material may carry these keys, so that model alone turns plasticity off; it does not use them.
  if (!material.plastic) forget_plasticity(material);
  return material;
}

Body read_body(const SceneTable& table, const Scene& scene) {
  Body body;
  if (table.has("element")) body.element = read_element(table.table("element", "element of a body"), scene.element);
  const ElementSettings& element = body.element ? *body.element : scene.element;
  read_keys(table, body);
  body.mesh = read_mesh(table, {scene.refine, least_bytes_of_element(scene, element)});
  return body;
}

}  // namespace pinball

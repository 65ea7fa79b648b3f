#include "parts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string_view>

namespace pinball {

namespace {

/// K and G, given as they are or by E and nu.
void read_moduli(const SceneTable& table, Material& material) {
  const bool young = table.has("young_modulus") || table.has("poisson_ratio");
  const bool bulk = table.has("bulk_modulus") || table.has("shear_modulus");
  if (young == bulk) {
    table.fail(young ? "young_modulus" : "bulk_modulus",
               fmt::format("expected either bulk_modulus and shear_modulus or young_modulus and poisson_ratio, got {}",
                           young ? "keys of both" : "none of them"));
  }
  if (bulk) {
    material.bulk_modulus = table.number("bulk_modulus", positive);
    material.shear_modulus = table.number("shear_modulus", positive);
    return;
  }
  const double E = table.number("young_modulus", positive);
  const double nu = table.number("poisson_ratio", {.low = -1.0, .low_open = true, .high = 0.5, .high_open = true});
  material.bulk_modulus = E / (3.0 * (1.0 - 2.0 * nu));
  material.shear_modulus = E / (2.0 * (1.0 + nu));
}

YieldCurve read_yield_curve(const SceneTable& table, bool with_rate) {
  YieldCurve curve;
  if (with_rate) curve.rate = table.number("rate", not_negative);
  curve.plastic_strain = table.numbers("plastic_strain", not_negative);
  curve.stress = table.numbers("stress", positive);
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

/// What only plasticity and erosion need.
void forget_plasticity(Material& material) {
  Material elastic;
  elastic.name = material.name;
  elastic.density = material.density;
  elastic.bulk_modulus = material.bulk_modulus;
  elastic.shear_modulus = material.shear_modulus;
  material = elastic;
}

}  // namespace

Point read_direction(const SceneTable& table, std::string_view key) {
  Point vector = table.point(key, any_number);
  table.require_none(direction_problem(key, vector));
  const double length = std::hypot(vector[0], vector[1], vector[2]);
  for (double& component : vector) component /= length;
  return vector;
}

Material read_material(const SceneTable& table) {
  Material material;
  material.name = table.name("name");
  material.plastic = table.choice<bool>("model", {{"elastic", false}, {"von_mises", true}});
  table.numbers_into(material);
  read_moduli(table, material);

  const double infinity = std::numeric_limits<double>::infinity();
  read_yield_curves(table, material);
  const bool needs_yield_stress = material.plastic && material.yield_curves.empty();
  material.yield_stress =
      needs_yield_stress ? table.number("yield_stress", positive) : table.number("yield_stress", positive, 0.0);
  material.ultimate_stress = table.number("ultimate_stress", positive, infinity);
  material.rate_interpolation = table.choice<RateInterpolation>(
      "rate_interpolation", {{"linear", RateInterpolation::linear}, {"logarithmic", RateInterpolation::logarithmic}},
      material.rate_interpolation);
  material.strain_rate = table.choice<StrainRate>(
      "strain_rate",
      {{"total", StrainRate::total}, {"deviatoric", StrainRate::deviatoric}, {"plastic", StrainRate::plastic}},
      material.strain_rate);
  complete(material);
  table.require_none(problem_of(material));
  // An elastic material may carry these keys, so that model alone turns plasticity off; it does not use them.
  if (!material.plastic) forget_plasticity(material);
  return material;
}

Body read_body(const SceneTable& table, const Scene& scene) {
  Body body;
  body.name = table.name("name");
  body.material = table.text("material");
  if (table.has("element")) body.element = read_element(table.table("element", "element of a body"), scene.element);
  const ElementSettings& element = body.element ? *body.element : scene.element;
  body.mesh = read_mesh(table, {scene.refine, least_bytes_of_element(scene, element)});
  table.numbers_into(body);
  if (table.has("axis")) body.axis = read_direction(table, "axis");
  body.velocity_gradient = table.matrix("velocity_gradient");
  return body;
}

PlaneConstraint read_constraint(const SceneTable& table) {
  PlaneConstraint constraint;
  table.choice<int>("type", {{"symmetry", 0}});
  if (table.has("name")) constraint.name = table.name("name");
  table.numbers_into(constraint);
  constraint.normal = read_direction(table, "normal");
  constraint.body = table.text("body", "");
  constraint.set = table.text("set", "");
  constraint.where = fmt::format("{}: {}", table.where(), table.path());
  return constraint;
}

}  // namespace pinball

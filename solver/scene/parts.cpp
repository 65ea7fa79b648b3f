#include "parts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

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
  material.yield_stress =
      material.plastic ? table.number("yield_stress", positive) : table.number("yield_stress", positive, 0.0);
  material.ultimate_stress = table.number("ultimate_stress", positive, infinity);
  table.require_none(problem_of(material));
  // An elastic material may carry these keys, so that model alone turns plasticity off; it does not use them.
  if (!material.plastic) {
    material.yield_stress = material.plastic_modulus = material.ultimate_stress = material.erosion_strain = 0;
  }
  return material;
}

Body read_body(const SceneTable& table, int refine) {
  Body body;
  body.name = table.name("name");
  body.material = table.text("material");
  body.mesh = read_mesh(table, refine);
  table.numbers_into(body);
  if (table.has("axis")) body.axis = read_direction(table, "axis");
  body.velocity_gradient = table.matrix("velocity_gradient");
  return body;
}

PlaneConstraint read_constraint(const SceneTable& table) {
  PlaneConstraint constraint;
  table.choice<int>("type", {{"symmetry", 0}});
  table.numbers_into(constraint);
  constraint.normal = read_direction(table, "normal");
  constraint.body = table.text("body", "");
  return constraint;
}

}  // namespace pinball

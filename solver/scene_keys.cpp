#include <pinball/solver/scene_table.hpp>

namespace pinball {

const std::vector<TableKeys>& scene_keys() {
  static const std::vector<TableKeys> keys{
      {"scene",
       "",
       {"title", "units", "precision", "time", "element", "contact", "skip", "guard", "output", "material", "body",
        "constraint", "variant"}},
      {"time", "time", {"end", "cfl", "steps", "subcycling"}},
      {"element",
       "element",
       {"hourglass", "hourglass_coefficient", "bulk_viscosity", "linear_viscosity", "quadratic_viscosity",
        "negative_volume"}},
      {"contact", "contact", {"method", "enforcement", "gap", "beta", "damping", "radius", "self", "skin"}},
      {"skip", "skip", {"contact_search", "resting"}},
      {"guard", "guard", {"energy_error"}},
      {"output", "output", {"interval", "field_interval", "field_times", "fields"}},
      {"material",
       "material.NAME",
       {"name", "model", "density", "bulk_modulus", "shear_modulus", "young_modulus", "poisson_ratio", "yield_stress",
        "plastic_modulus", "ultimate_stress", "erosion_strain"}},
      {"body",
       "body.NAME",
       {"name", "material", "mesh", "position", "axis", "velocity", "angular_velocity", "velocity_gradient",
        "velocity_noise"}},
      {"mesh",
       "body.NAME.mesh",
       {"type", "size", "elements", "length", "radius", "half", "section", "angle", "core", "ring", "radial", "layers",
        "grading", "file", "physical", "scale"}},
      {"block", "body.NAME.mesh", {"type", "size", "elements"}},
      {"round_nosed_rod", "body.NAME.mesh", {"type", "length", "radius", "half", "core", "ring", "layers"}},
      {"cylinder",
       "body.NAME.mesh",
       {"type", "radius", "length", "section", "angle", "core", "ring", "radial", "layers"}},
      {"sphere", "body.NAME.mesh", {"type", "radius", "section", "angle", "core", "ring", "grading"}},
      {"gmsh", "body.NAME.mesh", {"type", "file", "physical", "scale"}},
      {"constraint", "constraint.NUMBER", {"type", "point", "normal", "body"}},
  };
  return keys;
}

}  // namespace pinball

#include <pinball/solver/scene_table.hpp>

namespace pinball {

const std::vector<TableKeys>& scene_keys() {
  static const std::vector<TableKeys> keys{
      {"scene",
       "",
       {"title", "units", "precision", "time", "element", "contact", "skip", "guard", "output", "material", "body",
        "constraint", "rigid_wall", "prescribed_velocity", "load", "initial_velocity", "damping", "probe", "variant"}},
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
      {"mesh", "body.NAME.mesh", {"type", "size", "elements", "length", "radius", "half", "core", "ring", "layers"}},
      {"block", "body.NAME.mesh", {"type", "size", "elements"}},
      {"round_nosed_rod", "body.NAME.mesh", {"type", "length", "radius", "half", "core", "ring", "layers"}},
      {"constraint",
       "constraint.NUMBER",
       {"type", "point", "normal", "body", "directions", "frame", "axis", "plane", "line", "box", "nearest"}},
      {"symmetry", "constraint.NUMBER", {"type", "point", "normal", "body"}},
      {"fixed",
       "constraint.NUMBER",
       {"type", "directions", "frame", "axis", "body", "plane", "line", "box", "nearest"}},
      {"plane", "plane", {"point", "normal"}},
      {"line", "line", {"point", "direction"}},
      {"box", "box", {"low", "high"}},
      {"rigid_wall", "rigid_wall.NAME", {"name", "point", "normal", "body"}},
      {"prescribed_velocity",
       "prescribed_velocity.NUMBER",
       {"velocity", "direction", "speed", "times", "factors", "body", "plane", "line", "box", "nearest"}},
      {"load", "load.NUMBER", {"force", "times", "factors", "body", "plane", "line", "box", "nearest"}},
      {"initial_velocity", "initial_velocity.NUMBER", {"velocity", "body", "plane", "line", "box", "nearest"}},
      {"damping", "damping", {"mass"}},
      {"probe", "probe.NAME", {"name", "kind", "point", "body", "quantities"}},
  };
  return keys;
}

}  // namespace pinball

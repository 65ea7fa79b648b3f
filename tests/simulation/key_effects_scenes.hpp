#pragma once

#include <map>
#include <string>

/// Small scenes in which each key of the format is set to other values: each table of the format is in one of them, and
/// contact, hardening, times and selections in all combinations that let keys say nothing. Units are those of
/// every_key.toml.
namespace pinball::test {

/// Elements of 0.5, whose step is 0.09.
inline std::string body(const std::string& name, const std::string& material, const std::string& keys,
                        const std::string& mesh = R"({ type = "block", size = [1, 1, 1], elements = [2, 2, 2] })") {
  return "[[body]]\nname = \"" + name + "\"\nmaterial = \"" + material + "\"\nmesh = " + mesh + "\n" + keys;
}
inline std::string material(const std::string& name, const std::string& keys) {
  return "[[material]]\nname = \"" + name + "\"\ndensity = 8.0\n" + keys;
}
inline const std::string top = "[time]\nend = 2.0\n";
inline const std::string moduli = "young_modulus = 100.0\npoisson_ratio = 0.3\n";
inline const std::string yields = "model = \"von_mises\"\nyield_stress = 1.0\n" + moduli;
inline const std::string elastic = "model = \"elastic\"\n" + moduli;

/// Two blocks in impact, which also slide along each other.
inline std::string impact(const std::string& contact) {
  return top + "[contact]\n" + contact + material("m", yields + "plastic_modulus = 2.0\n") +
         body("a", "m", "velocity = [0.2, 0, 1]\n") +
         body("b", "m", "position = [0.1, 0.2, 1.01]\nvelocity = [0, 0.1, -0.5]\n");
}
/// One block that is stretched, sheared and turned.
inline std::string one(const std::string& material_keys, const std::string& more = "") {
  return top + more + material("m", material_keys) +
         body("a", "m",
              "velocity_gradient = [[0.9, 0.1, 0.0], [0.0, -0.2, 0.3], [0.0, 0.0, -0.5]]\nvelocity_noise = 0.1\n");
}
/// The same, but pressed together.
inline std::string pressed(const std::string& material_keys) {
  return top + material("m", material_keys) +
         body("a", "m",
              "velocity_gradient = [[-0.2, 0.4, 0.0], [0.0, -0.1, 0.2], [0.0, 0.0, -0.2]]\nvelocity_noise = 0.1\n");
}
/// The stretched one, and what acts on it.
inline std::string acted_on(const std::string& tables) {
  return one(yields) + body("b", "m", "position = [0, 0, 3]\n") + tables;
}
inline std::string meshed(const std::string& mesh) {
  return top + material("m", elastic) + body("a", "m", "velocity = [0, 0, 1]\nvelocity_noise = 0.1\n", mesh);
}

inline std::map<std::string, std::string> key_effects_scenes() {
  const std::string law = "model = \"von_mises\"\nyield_stress = 1.0\nshear_modulus = 50.0\n";
  const std::string mesh_file = R"({ type = "keyword", file = "cubes.k", part = "1" })";
  return {
      {"lagrange", impact("method = \"pinball\"\nfriction = 0.2\nstatic_friction = 0.3\n")},
      {"lagrange between balls", impact("method = \"pinball\"\ngap = \"pinball\"\n")},
      {"penalty", impact("method = \"pinball\"\nenforcement = \"penalty\"\n")},
      {"projection", impact("method = \"pinball\"\nenforcement = \"projection\"\nfriction = 0.2\n")},
      {"slideline by penalty", impact("method = \"slideline\"\nenforcement = \"penalty\"\n")},
      {"slideline by impulses", impact("method = \"slideline\"\nfriction = 0.2\n")},
      {"contact is off", impact("method = \"none\"\n")},
      {"contact is left open", impact("friction = 0.2\n")},
      {"every step searches", impact("method = \"pinball\"\n") + "[skip]\ncontact_search = false\n"},
      {"pairs", impact("method = \"pinball\"\n[[contact.pair]]\nfirst = \"a\"\nsecond = \"b\"\nfriction = 0.2\n"
                       "[[contact.pair]]\nfirst = \"b\"\n")},
      {"tied", top + "[contact]\nmethod = \"none\"\n[[contact.tied]]\nfirst = \"a\"\nsecond = \"b\"\n" +
                   material("m", elastic) + body("a", "m", "velocity = [0, 0, 1]\n") +
                   body("b", "m", "position = [0, 0, 1]\n")},
      {"elastic", one(elastic)},
      {"ideal plasticity", one(yields)},
      {"hardening", one(yields + "plastic_modulus = 2.0\n")},
      {"hardening that moves", one(yields + "plastic_modulus = 2.0\nisotropic_share = 0.5\n")},
      {"Cowper and Symonds", one(yields + "rate_constant = 10.0\nrate_exponent = 4.0\n")},
      {"a curve", one("model = \"von_mises\"\n" + moduli +
                      "yield_curve = { plastic_strain = [0.0, 0.1], stress = [1.0, 2.0] }\n")},
      {"curves", one("model = \"von_mises\"\n" + moduli +
                     "yield_curves = [{ rate = 0.1, plastic_strain = [0.0, 0.1], stress = [1.0, 2.0] }, "
                     "{ rate = 2.0, plastic_strain = [0.0, 0.1], stress = [1.5, 2.5] }]\n")},
      {"a power", one(yields + "power_hardening = { coefficient = 2.0, exponent = 0.2 }\n")},
      {"Johnson and Cook",
       one(yields + "[material.johnson_cook]\nhardening_coefficient = 1.0\nhardening_exponent = 0.3\n"
                    "rate_coefficient = 0.01\nreference_rate = 0.1\nmelting_temperature = 1500.0\n"
                    "room_temperature = 300.0\nspecific_heat = 0.001\nfailure = [0.9, 0.2, -1.5, 0.01, 0.5]\n")},
      {"Johnson and Holmquist",
       pressed("model = \"von_mises\"\n" + moduli +
               "[material.johnson_holmquist]\nintact_strength = 0.9\nintact_exponent = 0.6\nfractured_strength = 0.3\n"
               "fractured_exponent = 0.7\nmost_fractured = 0.5\nrate_coefficient = 0.01\nreference_rate = 0.1\n"
               "tensile_strength = 0.2\nelastic_limit = 3.0\nelastic_limit_pressure = 1.4\ndamage_coefficient = 0.05\n"
               "damage_exponent = 0.9\nquadratic_modulus = 10.0\ncubic_modulus = 20.0\nbulking = 0.9\n")},
      {"Drucker and Prager", pressed("model = \"von_mises\"\n" + moduli +
                                     "drucker_prager = { constant = 0.2, linear = 0.5, "
                                     "quadratic = 0.1 }\n")},
      {"what crushes",
       pressed("model = \"von_mises\"\nshear_modulus = 50.0\ndrucker_prager = { constant = 0.2, linear = 0.1, largest "
               "= 0.3 "
               "}\n[material.equation_of_state]\nform = \"tabulated\"\nvolume_strain = [0.0, -0.05, -0.6]\n"
               "pressure = [0.0, 1.0, 30.0]\nunloading_modulus = [90.0, 100.0, 110.0]\n")},
      {"a polynomial that crushes",
       pressed(law + "[material.equation_of_state]\nform = \"polynomial\"\n"
                     "coefficients = [0.0, 30.0, 80.0, 10.0, 0.0, 0.0, 0.0]\nunloading_modulus = [90.0]\n")},
      {"a foam", pressed("model = \"von_mises\"\n" + moduli +
                         "crushable_foam = { compaction = [0.0, 0.1], yield_stress = [0.3, 0.9], tension_cutoff = 0.2, "
                         "damping = 0.1, air_pressure = 0.5, solid_share = 0.2 }\n")},
      {"A of Johnson and Cook alone", one(yields + "[material.johnson_cook]\n")},
      {"shock", one(law + "[material.equation_of_state]\nform = \"mie_grueneisen\"\nsound_speed = 3.0\n"
                          "slopes = [1.4, 0.1, 0.0]\ngamma = 2.0\n")},
      {"polynomial", one(law + "[material.equation_of_state]\nform = \"polynomial\"\n"
                               "coefficients = [0.0, 70.0, 80.0, 10.0, 1.9, 0.6, 0.1]\n")},
      {"tabulated", one(law + "[material.equation_of_state]\nform = \"tabulated\"\nvolume_strain = [0.2, 0.0, -0.3]\n"
                              "pressure = [-12.0, 0.0, 30.0]\nenergy_factor = [1.5, 2.0, 2.2]\n")},
      {"fluid", one("model = \"von_mises\"\n[material.fluid]\nviscosity = 0.1\n[material.equation_of_state]\n"
                    "form = \"polynomial\"\ncoefficients = [0.0, 70.0, 80.0, 10.0, 1.9, 0.6, 0.1]\n",
                    "[element]\nhourglass = \"viscous\"\n")},
      {"rubber of powers", one("model = \"elastic\"\nogden = { moduli = [8.0, -1.0], exponents = [2.5, -2.0], "
                               "poisson_ratio = 0.45 }\n")},
      {"rubber", one("model = \"elastic\"\nmooney_rivlin = { a = 8.0, b = 1.0, poisson_ratio = 0.45 }\n")},
      {"orthotropic", one("model = \"elastic\"\n[material.orthotropic]\nyoung_moduli = [90.0, 50.0, 70.0]\n"
                          "poisson_ratios = [0.3, 0.25, 0.2]\nshear_moduli = [20.0, 30.0, 25.0]\n")},
      {"erosion", one(yields + "[material.erosion]\ntension = 0.5\n")},
      {"no hourglass control", one(yields, "[element]\nhourglass = \"none\"\nbulk_viscosity = false\n")},
      {"viscosity", one(yields,
                        "[element]\nhourglass = \"viscous\"\nhourglass_coefficient = 0.02\n"
                        "bulk_viscosity = true\n[damping]\nmass = 0.2\n")},
      {"tetrahedra", one(yields) + "elements = \"tetrahedra\"\n"},
      {"elements of a body", acted_on("[body.element]\nhourglass = \"viscous\"\nlinear_viscosity = 0.2\n")},
      {"larger steps", one(yields, "smallest_step = 0.12\n")},
      {"subcycling",
       one(yields, "subcycling = true\n") + body("b", "m", "position = [0, 0, 3]\nvelocity_noise = 0.1\n",
                                                 R"({ type = "block", size = [4, 4, 4], elements = [2, 2, 2] })")},
      {"fixed", acted_on("[[constraint]]\ntype = \"fixed\"\nname = \"f\"\ndirections = [\"x\"]\nbody = \"a\"\n"
                         "box = { low = [-1, -1, -1], high = [2, 2, 0.1] }\nend = 1.0\n"
                         "[[constraint]]\ntype = \"fixed\"\ndirections = \"all\"\nnearest = [1, 1, 1]\n")},
      {"equations", acted_on("[[equation]]\nname = \"e\"\ndirection = [0, 0, 1]\nbody = \"a\"\n"
                             "plane = { normal = [0, 0, 1] }\n[[equation]]\nname = \"e\"\ndirection = [0, 0, 1]\n"
                             "factor = -0.5\nbody = \"b\"\nplane = { point = [0, 0, 3], normal = [0, 0, 1] }\n")},
      {"fixed about an axis", acted_on("[[constraint]]\ntype = \"fixed\"\ndirections = [\"radial\"]\nframe = "
                                       "\"cylindrical\"\naxis = { direction = [0, 0, 1] }\nbody = \"a\"\n"
                                       "plane = { normal = [0, 0, 1] }\n")},
      {"symmetry", acted_on("[[constraint]]\ntype = \"symmetry\"\nname = \"s\"\nnormal = [0, 0, 1]\n")},
      {"a wall", acted_on("[[rigid_wall]]\npoint = [0, 0, -0.01]\nnormal = [0, 0, 1]\nfriction = 0.2\n"
                          "[[rigid_wall]]\npoint = [1.01, 0, 0]\nnormal = [-1, 0, 0]\nsliding = false\nbody = \"a\"\n"
                          "edge = [0, 1, 0]\nsize = [2, 3]\n")},
      {"walls that move", acted_on("[[rigid_wall]]\npoint = [0, 0, -0.01]\nnormal = [0, 0, 1]\nspeed = 0.2\n"
                                   "times = [0, 2]\nfactors = [1, 0]\n[[rigid_wall]]\npoint = [0, -0.01, 0]\n"
                                   "normal = [0, 1, 0]\nmass = 3\nspeed = 0.1\n")},
      {"prescribed", acted_on("[[prescribed_velocity]]\nname = \"p\"\nvelocity = [0, 0, 0.3]\nnearest = [0, 0, 0]\n"
                              "[[prescribed_velocity]]\ndirection = [0, 0, 1]\nspeed = 0.3\nbody = \"b\"\n"
                              "times = [0, 1, 2]\nfactors = [0, 1, 2]\nend = 1.5\n")},
      {"loads", acted_on("[[load]]\nforce = [1, 0, 0]\nbody = \"a\"\n[[pressure]]\npressure = 0.4\nbody = \"a\"\n"
                         "plane = { normal = [0, 0, 1] }\ntimes = [0, 1]\nfactors = [0, 1]\n"
                         "[[gravity]]\nacceleration = [0, 0, -9.8]\nname = \"weight\"\n")},
      {"point masses", acted_on("[[point_mass]]\nmass = 3.0\nbody = \"a\"\nplane = { normal = [0, 0, 1] }\n")},
      {"initial velocities", acted_on("[[initial_velocity]]\nvelocity = [0.1, 0, 0]\nbody = \"a\"\nplane = { normal = "
                                      "[0, 0, 1] }\n[[initial_velocity]]\nangular_velocity = [0.1, 0, 0]\nbody = "
                                      "\"b\"\n")},
      {"initial stresses", acted_on("[[initial_stress]]\nstress = [1e-3, 0, 2e-3]\nshear_stress = [0, 1e-3, 0]\n"
                                    "body = \"a\"\nbox = { low = [0, 0, 0], high = [1, 1, 0.5] }\n")},
      {"probes", acted_on("[[probe]]\nname = \"tip\"\npoint = [1, 1, 1]\n[[probe]]\nname = \"inner\"\n"
                          "kind = \"element\"\npoint = [0.2, 0.2, 0.2]\nbody = \"a\"\n")},
      {"rigid bodies", acted_on("velocity = [0, 0, -0.2]\n[body.element]\nhourglass = \"viscous\"\n[[rigid_body]]\n"
                                "name = \"r\"\nbodies = [\"b\"]\n[[rigid_nodes]]\nrigid_body = \"r\"\nbody = \"a\"\n"
                                "plane = { normal = [0, 0, 1] }\n[[load]]\nforce = [3, 0, 1]\nbody = \"b\"\n"
                                "nearest = [0, 0, 4]\n")},
      {"rigid bodies that are moved",
       acted_on("[[rigid_body]]\nname = \"r\"\nbodies = [\"b\"]\nheld = [\"x\"]\n[[rigid_motion]]\nrigid_body = "
                "\"r\"\ndirection = [0, 0, 1]\nspeed = 0.2\n[[rigid_motion]]\nrigid_body = \"r\"\naxis = [0, 0, 1]\n"
                "angular_speed = 0.2\ntimes = [0, 1, 2]\nfactors = [0, 1, 2]\nend = 1.5\n")},
      {"joints", acted_on("[[rigid_body]]\nname = \"pair\"\nbodies = [\"b\"]\n[[gravity]]\nacceleration = [1, 2, -9]\n"
                          "[[joint]]\nkind = \"universal\"\nbodies = [\"pair\", \"ground\"]\npoint = [0, 0, 3]\n"
                          "axis = [0, 1, 0]\nsecond_axis = [0, 0, 1]\n")},
      {"rigid alone", top + "[contact]\nmethod = \"pinball\"\n" + material("m", yields + "plastic_modulus = 2.0\n") +
                          body("a", "m", "velocity = [0.2, 0, 1]\n") + body("b", "m", "position = [0.1, 0.2, 1.01]\n") +
                          "[[rigid_body]]\nbodies = [\"a\"]\n[[rigid_body]]\nbodies = [\"b\"]\n"},
      {"of a file", top + material("m", elastic) +
                        body("g", "m", "velocity = [0, 0, 1]\nvelocity_noise = 0.1\n", mesh_file) +
                        "[[constraint]]\ntype = \"symmetry\"\nnormal = [0, 1, 0]\nset = \"7\"\n"
                        "[[load]]\nforce = [0, 1, 0]\nset = \"7\"\n[[load]]\nforce = [0, 1, 0]\nnodes = [8]\n"
                        "[[pressure]]\npressure = 0.3\nfaces = [[1, 2, 3, 4]]\n"},
      {"a block of lists", meshed(R"({ type = "block", size = [1, 1, [0.5, 0.5]], elements = [1, 1, [1, 2]] })")},
      {"a rod", meshed(R"({ type = "round_nosed_rod", length = 5, radius = 1, layers = 6 })")},
      {"a cylinder", meshed(R"({ type = "cylinder", radius = 1, length = 5, core = 2, layers = 3 })")},
      {"a wedge", meshed(R"({ type = "cylinder", radius = 1, length = 5, section = "wedge", angle = 10, radial = 2, )"
                         R"(layers = 3 })")},
      {"a sphere", meshed(R"({ type = "sphere", radius = 1, core = 2 })")},
      {"a wedge of a sphere",
       meshed(R"({ type = "sphere", radius = 1, section = "wedge", angle = 10, core = [2, 2] })")},
  };
}

}  // namespace pinball::test

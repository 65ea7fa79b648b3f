#include <gmock/gmock.h>

#include <solver/scene/material/orthotropic_moduli.hpp>
#include <solver/scene_rules.hpp>
#include <tests/support/scene_fixture.hpp>

/// johnson_cook, johnson_holmquist and equation_of_state of a material.
namespace pinball::material_laws_scene_test {
namespace {

using namespace test;
using testing::HasSubstr;

class MaterialLawsScene : public SceneTest {
 protected:
  /// The minimal scene with these lines in the place of the moduli and the yield stress, lines 8 to 10.
  std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> all = with(10, "yield_stress = 4e8\n" + text);
    all[7] = "", all[8] = "shear_modulus = 45e9";
    return all;
  }
  std::vector<std::string> with_law(const std::string& text) { return with(10, "yield_stress = 4e8\n" + text); }
  std::string problem_of_law(const std::string& text) { return error(with_law("johnson_cook = { " + text + " }")); }
  std::string problem_of_pressure(const std::string& text) {
    return error(lines("equation_of_state = { " + text + " }"));
  }
};

/// Of a brittle material: more lines, and more keys of its law.
std::string brittle(const std::string& more = "", const std::string& keys = "") {
  return more +
         "\njohnson_holmquist = { intact_strength = 0.93, intact_exponent = 0.6, tensile_strength = 2e8, "
         "elastic_limit = 2.79e9, elastic_limit_pressure = 1.46e9" +
         keys + " }";
}

constexpr const char* copper = "equation_of_state = { sound_speed = 3940.0, slopes = [1.489, 0, 0], gamma = 2.0 }";

TEST_F(MaterialLawsScene, ReadsJohnsonAndCook) {
  const Material m = read(with_law("strain_rate = \"plastic\"\n"
                                   "johnson_cook = { hardening_coefficient = 2.9e8, hardening_exponent = 0.31, "
                                   "rate_coefficient = 0.025, reference_rate = 1.0, softening_exponent = 1.09, "
                                   "melting_temperature = 1356, room_temperature = 298, specific_heat = 383, "
                                   "heat_share = 0.9, failure = [0.54, 4.89, -3.03, 0.014, 1.12], "
                                   "damage_weakening = 0.25 }"))
                         .materials.at(0);
  ASSERT_TRUE(m.johnson_cook);
  const JohnsonCookSettings expected{
      2.9e8, 0.31, 0.025, 1.0, 1.09, 1356, 298, 383, 0.9, {0.54, 4.89, -3.03, 0.014, 1.12}, 0.25};
  EXPECT_EQ(*m.johnson_cook, expected);
  EXPECT_EQ(m.yield_stress, 4e8);
  EXPECT_TRUE(erodes(m));
  EXPECT_FALSE(m.equation_of_state);
}

TEST_F(MaterialLawsScene, ReadsWhatIsBrittle) {
  const auto problem = [&](const std::string& more, const std::string& keys = "") {
    return error(with(10, brittle(more, keys)));
  };
  const Material m = read(with(10, brittle("", ", bulking = 1.0, erodes = true"))).materials.at(0);
  EXPECT_EQ(*m.johnson_holmquist,
            (JohnsonHolmquistSettings{0.93, 0.6, 0, 1, 0, 0, 0, 2e8, 2.79e9, 1.46e9, 0, 1, 0, 0, 1, true}));
  EXPECT_TRUE(erodes(m));
  EXPECT_FALSE(erodes(read(with(10, brittle())).materials.at(0)));
  EXPECT_FALSE(has_yield_stress(m));
  for (const char* other :
       {"yield_stress = 1e9", "plastic_modulus = 1e9", "ultimate_stress = 1e9", "isotropic_share = 0.5",
        "rate_constant = 40\nrate_exponent = 5", "power_hardening = { coefficient = 1e9, exponent = 0.2 }",
        "johnson_cook = {}", "fluid = {}"})
    EXPECT_THAT(problem(other), HasSubstr("expected none beside")) << other;
  EXPECT_THAT(problem("strain_rate = \"plastic\"", ", rate_coefficient = 0.01, reference_rate = 1.0"),
              HasSubstr("expected \"total\" or \"deviatoric\" beside johnson_holmquist"));
  EXPECT_THAT(problem("", ", rate_coefficient = 0.01"),
              HasSubstr("johnson_holmquist.reference_rate: expected a number > 0 beside rate_coefficient"));
  EXPECT_THAT(problem("", ", quadratic_modulus = -9e11"), HasSubstr("that rises up to mu = 0.2"));
  EXPECT_THAT(problem("", ", cubic_modulus = -9e12"),
              HasSubstr("johnson_holmquist.cubic_modulus: expected a pressure"));
  EXPECT_THAT(problem("erosion = { tension = 2e8 }"),
              HasSubstr("expected a number < johnson_holmquist.tensile_strength = 200000000, beyond which"));
  EXPECT_EQ(problem("erosion = { tension = 1.9e8 }"), "no error");
}

TEST_F(MaterialLawsScene, ReadsEquationsOfState) {
  const Material m = read(lines(copper)).materials.at(0);
  EXPECT_EQ(m.equation_of_state->sound_speed, 3940);
  EXPECT_EQ(m.equation_of_state->slopes, (Point{1.489, 0, 0}));
  EXPECT_DOUBLE_EQ(m.bulk_modulus, m.density * 3940 * 3940);
  EXPECT_FALSE(erodes(m));
  const Material polynomial =
      read(lines("equation_of_state = { form = \"polynomial\", coefficients = [0, 72e9, 172e9, 40e9, 1.9, 0.6, 0], "
                 "tension_limit = 1e9 }"))
          .materials.at(0);
  EXPECT_EQ(polynomial.bulk_modulus, 72e9);
  EXPECT_EQ(polynomial.equation_of_state->tension_limit, 1e9);
}

TEST_F(MaterialLawsScene, ReadsAPower) {
  const auto power = [&](const std::string& text) { return with_law("power_hardening = { " + text + " }"); };
  const Material m = read(power("coefficient = 8e8, exponent = 0.2")).materials.at(0);
  EXPECT_EQ(*m.power_hardening, (PowerHardeningSettings{8e8, 0.2}));
  EXPECT_THAT(error(power("coefficient = 8e8")), HasSubstr("exponent"));
  EXPECT_THAT(error(power("coefficient = 8e8, exponent = 1.1")), HasSubstr("exponent: expected a number"));
  EXPECT_THAT(error(power("coefficient = 8e8, exponent = 0.02")),
              HasSubstr("power_hardening.coefficient: expected one for which (yield_stress/coefficient)^(1/exponent)"));
  EXPECT_THAT(error(with(10,
                         "yield_stress = 4e8\nplastic_modulus = 1e8\n"
                         "power_hardening = { coefficient = 8e8, exponent = 0.2 }")),
              HasSubstr("plastic_modulus: expected none beside power_hardening"));
  EXPECT_THAT(error(with_law("johnson_cook = { hardening_coefficient = 2.9e8 }\n"
                             "power_hardening = { coefficient = 8e8, exponent = 0.2 }")),
              HasSubstr("power_hardening: expected none beside johnson_cook"));
}

TEST_F(MaterialLawsScene, ReadsFluids) {
  const auto fluid = [&](const std::string& text) {
    std::vector<std::string> all = with(10, text);
    all[7] = all[8] = "";
    all.push_back("[element]");
    all.push_back("hourglass = \"viscous\"");
    return all;
  };
  const std::string water = "fluid = { viscosity = 1e-3 }\n";
  const Material m = read(fluid(water + copper)).materials.at(0);
  EXPECT_EQ(m.fluid->viscosity, 1e-3);
  EXPECT_EQ(m.shear_modulus, 0);
  EXPECT_DOUBLE_EQ(m.bulk_modulus, m.density * 3940 * 3940);
  EXPECT_THAT(error(fluid(water + copper + "\nyield_stress = 1e6")),
              HasSubstr("yield_stress: expected none beside fluid"));
  EXPECT_THAT(error(fluid(water + copper + "\npower_hardening = { coefficient = 1e9, exponent = 0.2 }")),
              HasSubstr("power_hardening: expected none beside fluid"));
  EXPECT_THAT(error(fluid(water + copper + "\nshear_modulus = 1e6")), HasSubstr("shear_modulus: "));
  EXPECT_THAT(error(fluid("fluid = { viscosity = -1 }\n" + std::string(copper))), HasSubstr("fluid.viscosity"));
  EXPECT_THAT(error(with(10, water + "yield_stress = 4e8")), HasSubstr("fluid"));
  EXPECT_THAT(error(with(10, water)), HasSubstr("equation_of_state: missing, expected the pressure of the fluid"));
}

TEST_F(MaterialLawsScene, ReadsRubber) {
  const auto rubber = [&](const std::string& text, const std::string& more = "",
                          const std::string& law = "mooney_rivlin") {
    std::vector<std::string> all = with(10, more);
    all[7] = law + " = { " + text + " }", all[8] = "";
    for (std::string& line : all) {
      if (line.starts_with("model")) line = "model = \"elastic\"";
    }
    return all;
  };
  const Material m = read(rubber("a = 3e5, b = 1e5, poisson_ratio = 0.49")).materials.at(0);
  EXPECT_EQ(*m.mooney_rivlin, (MooneyRivlinSettings{3e5, 1e5, 0.49}));
  EXPECT_EQ(m.shear_modulus, 8e5);
  EXPECT_NEAR(m.bulk_modulus, 8e5 * 2 * 1.49 / (3 * 0.02), 1);
  EXPECT_THAT(error(rubber("a = 0, b = 0, poisson_ratio = 0.49")), HasSubstr("mooney_rivlin.a: expected a + b > 0"));
  EXPECT_THAT(error(rubber("a = 1, b = 0, poisson_ratio = 0.5")), HasSubstr("poisson_ratio: expected a number > 0"));
  EXPECT_THAT(error(rubber("a = 1, b = 0, poisson_ratio = 0.4", "young_modulus = 1e6")),
              HasSubstr("young_modulus: expected none beside mooney_rivlin"));
  const auto powers = [&](const std::string& text, const std::string& more = "") {
    return rubber(text + ", poisson_ratio = 0.4", more, "ogden");
  };
  const Material of_powers = read(powers("moduli = [3e5, -1e5], exponents = [1.5, -2]")).materials.at(0);
  EXPECT_EQ(*of_powers.ogden, (OgdenSettings{{3e5, -1e5}, {1.5, -2}, 0.4, false}));
  EXPECT_DOUBLE_EQ(of_powers.shear_modulus, 3.25e5);
  EXPECT_NEAR(of_powers.bulk_modulus, 3.25e5 * 2 * 1.4 / (3 * 0.2), 1e-6);
  EXPECT_TRUE(read(powers("moduli = [1], exponents = [2], stretches = \"whole\"")).materials.at(0).ogden->whole);
  EXPECT_THAT(error(powers("moduli = [], exponents = []")), HasSubstr("moduli: expected 1 to 10 numbers, got 0"));
  EXPECT_THAT(error(powers("moduli = [1, 2], exponents = [1]")), HasSubstr("each of the 2 moduli, got 1"));
  EXPECT_THAT(error(powers("moduli = [1], exponents = [0]")), HasSubstr("exponents: expected numbers that are not 0"));
  EXPECT_THAT(error(powers("moduli = [1], exponents = [-2]")), HasSubstr("moduli: expected a shear modulus"));
  EXPECT_THAT(error(powers("moduli = [1], exponents = [2]", "young_modulus = 1e6")),
              HasSubstr("young_modulus: expected none beside ogden"));
  EXPECT_THAT(error(powers("moduli = [1], exponents = [2]", "mooney_rivlin = { a = 1, poisson_ratio = 0.4 }")),
              HasSubstr("expected none beside ogden"));
}

TEST_F(MaterialLawsScene, ReadsModuliAlongAxes) {
  const auto wood = [&](const std::string& ratios, const std::string& more = "", const std::string& beside = "") {
    std::vector<std::string> all = with(10, beside);
    all[7] = "orthotropic = { young_moduli = [9e9, 5e9, 2e9], poisson_ratios = [" + ratios +
             "], shear_moduli = [7e8, 5e8, 3e8]" + more + " }";
    all[8] = "";
    for (std::string& line : all) {
      if (line.starts_with("model")) line = "model = \"elastic\"";
    }
    return all;
  };
  const Material m = read(wood("0.3, 0.2, 0.1")).materials.at(0);
  const ElasticMatrix c = moduli_along_axes(*m.orthotropic);
  // The strain of a stress along each axis: 1/E there, -nu/E across; nothing but that stress.
  const double ratios[3][3] = {{-1, 0.3, 0.2}, {0.3 * 5 / 9, -1, 0.1}, {0.2 * 2 / 9, 0.1 * 2 / 5, -1}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < 3; ++i) {
      double stress = 0;
      for (std::size_t j = 0; j < 3; ++j) stress -= c[i][j] * ratios[axis][j] / m.orthotropic->young_moduli[axis];
      EXPECT_NEAR(stress, i == axis ? 1 : 0, 1e-14);
    }
  }
  EXPECT_EQ(c[3][3], 7e8) << "ab";
  EXPECT_EQ(c[4][4], 3e8) << "bc";
  EXPECT_EQ(c[5][5], 5e8) << "ca";
  EXPECT_EQ(moduli_in_scene(*m.orthotropic), c);
  EXPECT_DOUBLE_EQ(m.bulk_modulus, (c[0][0] + c[1][1] + c[2][2] + 2 * (c[0][1] + c[0][2] + c[1][2])) / 9);
  const Material turned =
      read(wood("0.3, 0.2, 0.1", ", first_axis = [0, 3, 0], second_axis = [0, 1, 2]")).materials.at(0);
  const ElasticMatrix t = moduli_in_scene(*turned.orthotropic);  // a, b, c along y, z, x
  EXPECT_NEAR(t[1][1], c[0][0], 1e-6);
  EXPECT_NEAR(t[2][2], c[1][1], 1e-6);
  EXPECT_NEAR(t[0][0], c[2][2], 1e-6);
  EXPECT_NEAR(t[1][2], c[0][1], 1e-6);
  EXPECT_NEAR(t[4][4], c[3][3], 1e-6) << "yz is ab";
  EXPECT_NEAR(t[3][3], c[5][5], 1e-6) << "xy is ca";
  EXPECT_NEAR(turned.bulk_modulus, m.bulk_modulus, 1e-3);
  EXPECT_THAT(error(wood("1.4, 0.2, 0.1")), HasSubstr("orthotropic.poisson_ratios: expected |nu_ab| < sqrt(E_a/E_b)"));
  EXPECT_THAT(error(wood("1.2, 1.2, 0.5")), HasSubstr("that every strain has an energy"));
  EXPECT_THAT(error(wood("0.3, 0.2, 0.1", ", second_axis = [2, 0, 0]")), HasSubstr("not along first_axis"));
  EXPECT_THAT(error(wood("0.3, 0.2, 0.1", ", first_axis = [0, 0, 0]")), HasSubstr("expected a direction, not zero"));
  EXPECT_THAT(error(wood("0.3, 0.2, 0.1", "", "young_modulus = 1e6")),
              HasSubstr("young_modulus: expected none beside orthotropic"));
}

TEST_F(MaterialLawsScene, OverridesReachIntoThem) {
  const Scene scene = read(with_law("johnson_cook = { hardening_coefficient = 2.9e8 }"),
                           {.set = {"material.copper.johnson_cook.hardening_exponent=0.5"}});
  EXPECT_EQ(scene.materials[0].johnson_cook->hardening_exponent, 0.5);
}

TEST_F(MaterialLawsScene, AnElasticMaterialKeepsNothingOfThem) {
  const SceneOverrides elastic{.set = {"material.copper.model=elastic"}};
  const Scene scene = read(with_law("johnson_cook = { hardening_coefficient = 2.9e8 }"), elastic);
  EXPECT_FALSE(scene.materials[0].johnson_cook);
  EXPECT_GT(scene.materials[0].bulk_modulus, 1e11);
  EXPECT_FALSE(read(with(10, brittle()), elastic).materials[0].johnson_holmquist);
}

TEST_F(MaterialLawsScene, RefusesLawsThatLackSomething) {
  EXPECT_THAT(problem_of_law("rate_coefficient = 0.02"),
              HasSubstr("johnson_cook.reference_rate: expected a number > 0 beside rate_coefficient"));
  EXPECT_THAT(problem_of_law("melting_temperature = 1000, room_temperature = 1200"),
              HasSubstr("johnson_cook.melting_temperature: expected a number > room_temperature = 1200, got 1000"));
  EXPECT_THAT(problem_of_law("melting_temperature = 1000"),
              HasSubstr("johnson_cook.specific_heat: expected a number > 0 beside melting_temperature"));
  EXPECT_THAT(problem_of_law("failure = [1, 2]"),
              HasSubstr("johnson_cook.failure: expected five numbers, D1 to D5, got 2"));
  EXPECT_THAT(problem_of_law("failure = [1, 0, 0, 0, 0], damage_weakening = 1.5"), HasSubstr("damage_weakening"));
  EXPECT_THAT(problem_of_law("failure = [-1, 0.5, 0, 0, 0]"), HasSubstr("expected D1 + D2 > 0"));
  EXPECT_THAT(problem_of_law("failure = [1, 0, 0, 0.1, 0]"),
              HasSubstr("johnson_cook.reference_rate: expected a number > 0 beside D4"));
  EXPECT_THAT(problem_of_law("failure = [1, 0, 0, 0, 0.1]"),
              HasSubstr("johnson_cook.melting_temperature: expected a number > 0 beside D5"));
  EXPECT_THAT(problem_of_law("hardening_exponent = 0"), HasSubstr("hardening_exponent: expected a number > 0, got 0"));
}

TEST_F(MaterialLawsScene, RefusesWhatStandsBesideThem) {
  for (const char* other : {"plastic_modulus = 1e9", "ultimate_stress = 5e8", "isotropic_share = 0.5",
                            "rate_constant = 40\nrate_exponent = 5"}) {
    EXPECT_THAT(error(with_law(std::string(other) + "\njohnson_cook = { hardening_coefficient = 1e8 }")),
                HasSubstr("expected none beside johnson_cook"))
        << other;
  }
  EXPECT_THAT(error(with_law(copper)),
              HasSubstr("bulk_modulus: expected none beside equation_of_state, but shear_modulus"));
}

TEST_F(MaterialLawsScene, RefusesPressuresThatAreNone) {
  EXPECT_THAT(problem_of_pressure("gamma = 2"), HasSubstr("equation_of_state.sound_speed: missing"));
  EXPECT_THAT(problem_of_pressure("form = \"polynomial\", coefficients = [0, 1]"),
              HasSubstr("equation_of_state.coefficients: expected seven numbers, c0 to c6, got 2"));
  EXPECT_THAT(problem_of_pressure("form = \"polynomial\", coefficients = [1, 1, 0, 0, 0, 0, 0]"),
              HasSubstr("expected c0 = 0, a body at rest that presses on nothing, got 1"));
  EXPECT_THAT(problem_of_pressure("form = \"polynomial\", coefficients = [0, -1, 0, 0, 0, 0, 0]"),
              HasSubstr("expected c1 > 0, the bulk modulus at rest, got -1"));
  EXPECT_THAT(problem_of_pressure("sound_speed = 1, coefficients = [0, 1, 0, 0, 0, 0, 0]"),
              HasSubstr("equation_of_state.coefficients: not used but with form = \"polynomial\""));
}

TEST_F(MaterialLawsScene, RefusesTablesOfPressureThatAreNone) {
  const auto problem = [this](const std::string& table) {
    return problem_of_pressure("form = \"tabulated\", " + table);
  };
  EXPECT_THAT(problem("pressure = [0, 1]"), HasSubstr("volume_strain: expected 2 to 16 numbers, got 0"));
  EXPECT_THAT(problem("volume_strain = [0, -1]"),
              HasSubstr("pressure: expected as many numbers as volume_strain has, 2, got 0"));
  EXPECT_THAT(problem("volume_strain = [0], pressure = [0]"),
              HasSubstr("volume_strain: expected 2 to 16 numbers, got 1"));
  EXPECT_THAT(problem("volume_strain = [0, -1, -1], pressure = [0, 1, 2]"),
              HasSubstr("volume_strain: expected numbers that all rise or all fall, got -1 after -1"));
  EXPECT_THAT(problem("volume_strain = [0, -1], pressure = [0, 1, 2]"),
              HasSubstr("pressure: expected as many numbers as volume_strain has, 2, got 3"));
  EXPECT_THAT(problem("volume_strain = [0, -1], pressure = [0, 1], energy_factor = [1]"),
              HasSubstr("energy_factor: expected as many numbers as volume_strain has, 2, got 1"));
  EXPECT_THAT(problem("volume_strain = [1, -1], pressure = [0, 1]"),
              HasSubstr("pressure: expected 0 at a volume_strain of 0, where a body presses on nothing, got 0.5"));
  EXPECT_THAT(problem("volume_strain = [1, 0, -1], pressure = [1, 0, 1]"),
              HasSubstr("pressure: expected a bulk modulus at rest > 0, got -1"));
  EXPECT_THAT(problem("volume_strain = [0, -inf], pressure = [0, 1]"), HasSubstr("expected a finite number, got -inf"));
  EXPECT_THAT(problem_of_pressure("sound_speed = 1, pressure = [0, 1]"),
              HasSubstr("equation_of_state.pressure: not used but with form = \"tabulated\""));
}

/// Given from either end; where pieces meet at rest the stiffer one has the bulk modulus.
TEST_F(MaterialLawsScene, ReadsTablesOfPressure) {
  for (const char* table : {"volume_strain = [0.1, 0, -0.2], pressure = [-1e9, 0, 4e9]",
                            "volume_strain = [-0.2, 0, 0.1], pressure = [4e9, 0, -1e9]"}) {
    const Material m =
        read(lines(std::string("equation_of_state = { form = \"tabulated\", ") + table + " }")).materials.at(0);
    EXPECT_NEAR(m.bulk_modulus, 20e9, 1) << table;
  }
}

TEST_F(MaterialLawsScene, ReadsLimitsOfErosionOfAnyModel) {
  const std::string limits =
      "erosion = { tension = 1e9, compression = 2e9, principal_stress = 3e9, effective_stress = 4e9, principal_strain "
      "= "
      "0.5, shear_strain = 0.6, time = 7e-6, smallest_step = 1e-9, step_share = 0.1 }";
  const ErosionSettings expected{1e9, 2e9, 3e9, 4e9, 0.5, 0.6, 7e-6, 1e-9, 0.1};
  for (const char* model : {"von_mises", "elastic"}) {
    const Material m = read(with_law(limits), {.set = {std::string("material.copper.model=") + model}}).materials.at(0);
    ASSERT_TRUE(m.erosion) << model;
    EXPECT_EQ(*m.erosion, expected);
    EXPECT_TRUE(erodes(m));
  }
}

TEST_F(MaterialLawsScene, RefusesLimitsThatAreNone) {
  const auto problem = [&](const std::string& text) { return error(with_law("erosion = { " + text + " }")); };
  EXPECT_THAT(problem(""), HasSubstr("erosion.tension: expected this or another limit > 0, got none"));
  EXPECT_THAT(problem("tension = 0"), HasSubstr("erosion.tension: expected this or another limit > 0, got none"));
  EXPECT_THAT(problem("tension = -1"), HasSubstr("erosion.tension: expected a number >= 0, got -1"));
  EXPECT_THAT(problem("step_share = 1"), HasSubstr("erosion.step_share: expected a number >= 0 and < 1, got 1"));
  EXPECT_THAT(error(lines("equation_of_state = { sound_speed = 3940.0, tension_limit = 1e9 }\n"
                          "erosion = { tension = 2e9 }")),
              HasSubstr("erosion.tension: expected a number < equation_of_state.tension_limit = 1000000000"));
}

/// model = "elastic" turns plasticity off, and not the pressure.
TEST_F(MaterialLawsScene, RefusesPressuresThatElasticMaterialsHaveNot) {
  const auto elastic = [&](const std::vector<std::string>& scene) {
    return error(scene, {.set = {"material.copper.model=elastic"}});
  };
  EXPECT_THAT(elastic(lines(copper)), HasSubstr("equation_of_state: not used with model = \"elastic\""));
  std::vector<std::string> water = with(10, "fluid = { viscosity = 1e-3 }\n" + std::string(copper));
  water[7] = water[8] = "";
  EXPECT_THAT(elastic(water), HasSubstr("fluid: not used with model = \"elastic\""));
  EXPECT_THAT(elastic(with(10, brittle("", ", quadratic_modulus = 1e9"))),
              HasSubstr("johnson_holmquist: expected model = \"von_mises\" beside it, got \"elastic\""));
  EXPECT_EQ(elastic(with(10, brittle())), "no error") << "its pressure is that of bulk_modulus";
  EXPECT_EQ(elastic(with_law("johnson_cook = { hardening_coefficient = 2.9e8 }")), "no error");
  Scene host = read(lines(copper));
  host.materials[0].plastic = false;
  EXPECT_THROW(checked_scene(host), InputError);
}

TEST_F(MaterialLawsScene, HostsAreToldTheSame) {
  Scene scene = read(with_law("johnson_cook = { hardening_coefficient = 2.9e8 }"));
  scene.materials[0].johnson_cook->failure = {1, 2};
  EXPECT_THROW(checked_scene(scene), InputError);
}

}  // namespace
}  // namespace pinball::material_laws_scene_test

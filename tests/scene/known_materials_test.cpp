#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <solver/base/error.hpp>
#include <solver/scene.hpp>
#include <solver/scene/material/known_materials.hpp>
#include <tests/support/output_case.hpp>

/// Materials that scenes use by their names.
namespace pinball::known_materials_test {
namespace {

using testing::HasSubstr;

std::string text_of(const GivenTable& table, const char* key) {
  const GivenValue* value = table.find(key);
  return value != nullptr && value->as<std::string>() != nullptr ? *value->as<std::string>() : "";
}

class KnownMaterials : public testing::Test {
 protected:
  test::TemporaryFolder folder_{testing::UnitTest::GetInstance()->current_test_info()->name()};

  /// Of a scene of one cube; units: a line, or nothing.
  Scene scene_with(const std::string& units, const std::string& keys) const {
    const std::string path = folder_ / "scene.toml";
    std::ofstream(path) << units << "\ntime = { end = 1 }\n[[material]]\nname = \"m\"\n"
                        << keys
                        << "\n[[body]]\nname = \"b\"\nmaterial = \"m\"\nmesh = { type = \"block\", size = [1, 1, 1], "
                           "elements = [1, 1, 1] }\n";
    return read_scene(path);
  }
  Material material(const std::string& units, const std::string& keys) const {
    return scene_with("units = \"" + units + "\"", keys).materials.at(0);
  }
  std::string error(const std::string& units, const std::string& keys) const {
    try {
      scene_with(units, keys);
    } catch (const InputError& problem) {
      return problem.what();
    }
    return "none";
  }
};

const std::string copper = "use = \"copper OFHC, Johnson-Cook 1983\"\n";

TEST_F(KnownMaterials, AreThoseOfThePageEachWithSourceAndRange) {
  std::ifstream page(PINBALL_SOURCE_DIR "/data/materials/README.md");
  std::stringstream text;
  text << page.rdbuf();
  std::set<std::string> names;
  for (const GivenTable& known : known_materials()) {
    const std::string name = text_of(known, "name");
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_FALSE(text_of(known, "source").empty()) << name;
    EXPECT_FALSE(text_of(known, "range").empty()) << name;
    EXPECT_THAT(text.str(), HasSubstr("| `" + name + "` |"));
  }
  EXPECT_GE(names.size(), 12U);
}

/// Numbers without a unit are the same in all units, and each is read without a complaint.
TEST_F(KnownMaterials, AreTheSameInAllUnits) {
  for (const GivenTable& known : known_materials()) {
    const std::string use = "use = \"" + text_of(known, "name") + "\"";
    const Material si = material("SI", use);
    for (const auto& [units, density, stress, velocity] :
         {std::tuple{"g-mm-ms", 1e6, 1e6, 1.0}, {"tonne-mm-s", 1e12, 1e6, 1e-3}, {"g-cm-us", 1e3, 1e11, 1e4}}) {
      const Material other = material(units, use);
      const auto same = [&](double in_si, double there, double unit) {
        EXPECT_NEAR(there * unit, in_si, 1e-12 * std::abs(in_si)) << use << " in " << units;
      };
      same(si.density, other.density, density);
      same(si.bulk_modulus, other.bulk_modulus, stress);
      same(si.shear_modulus, other.shear_modulus, stress);
      same(si.yield_stress, other.yield_stress, stress);
      ASSERT_EQ(si.johnson_cook.has_value(), other.johnson_cook.has_value());
      if (si.johnson_cook) {
        same(si.johnson_cook->hardening_coefficient, other.johnson_cook->hardening_coefficient, stress);
        same(si.johnson_cook->specific_heat, other.johnson_cook->specific_heat, velocity * velocity);
        EXPECT_EQ(si.johnson_cook->hardening_exponent, other.johnson_cook->hardening_exponent);
        EXPECT_EQ(si.johnson_cook->melting_temperature, other.johnson_cook->melting_temperature);
        EXPECT_EQ(si.johnson_cook->failure, other.johnson_cook->failure);
      }
      ASSERT_EQ(si.johnson_holmquist.has_value(), other.johnson_holmquist.has_value());
      if (si.johnson_holmquist) {
        same(si.johnson_holmquist->tensile_strength, other.johnson_holmquist->tensile_strength, stress);
        same(si.johnson_holmquist->elastic_limit, other.johnson_holmquist->elastic_limit, stress);
        same(si.johnson_holmquist->cubic_modulus, other.johnson_holmquist->cubic_modulus, stress);
        EXPECT_EQ(si.johnson_holmquist->intact_strength, other.johnson_holmquist->intact_strength);
      }
      ASSERT_EQ(si.equation_of_state.has_value(), other.equation_of_state.has_value());
      if (si.equation_of_state) {
        same(si.equation_of_state->sound_speed, other.equation_of_state->sound_speed, velocity);
        EXPECT_EQ(si.equation_of_state->slopes, other.equation_of_state->slopes);
      }
    }
  }
}

/// Along a shock, at the pressure of the Hugoniot elastic limit, all is elastic, and the stress is that limit.
TEST_F(KnownMaterials, OfBrittleOnesHaveTheElasticLimitOfTheirPressure) {
  int brittle = 0;
  for (const GivenTable& known : known_materials()) {
    const Material m = material("SI", "use = \"" + text_of(known, "name") + "\"");
    if (!m.johnson_holmquist) continue;
    ++brittle;
    const JohnsonHolmquistSettings& law = *m.johnson_holmquist;
    const auto pressure = [&](double mu) {
      return mu * (m.bulk_modulus + mu * (law.quadratic_modulus + mu * law.cubic_modulus));
    };
    double mu = 0;
    while (pressure(mu) < law.elastic_limit_pressure) mu += 1e-6;
    const double effective = 2 * m.shear_modulus * mu / (1 + mu);  // small strains, of the pressed length
    EXPECT_NEAR(pressure(mu) + 2.0 / 3 * effective, law.elastic_limit, 0.01 * law.elastic_limit) << m.name;
  }
  EXPECT_EQ(brittle, 4);
}

TEST_F(KnownMaterials, HaveRatesInTheTimeOfTheScene) {
  EXPECT_DOUBLE_EQ(material("g-mm-ms", copper).johnson_cook->reference_rate, 1e-3);
  EXPECT_DOUBLE_EQ(material("g-mm-ms", copper).johnson_cook->specific_heat, 383e0);  // mJ/(g K), as J/(kg K)
}

TEST_F(KnownMaterials, GiveWayToWhatTheSceneSays) {
  const Material own = material("SI", copper + "density = 9000\njohnson_cook = { rate_coefficient = 0.03 }\n");
  EXPECT_EQ(own.density, 9000);
  EXPECT_EQ(own.johnson_cook->rate_coefficient, 0.03);
  EXPECT_EQ(own.johnson_cook->hardening_coefficient, 292e6) << "the rest is that of the name";
  const Material stiff = material("SI", copper + "bulk_modulus = 2e11\nshear_modulus = 5e10\n");
  EXPECT_EQ(stiff.bulk_modulus, 2e11);
  const Material elastic = material("SI", copper + "model = \"elastic\"\n");
  EXPECT_FALSE(elastic.plastic);
}

TEST_F(KnownMaterials, HaveTheirStrengthBesideAnOwnEquationOfState) {
  const Material known = material("kg-m-s", copper);
  const std::string pressures = "equation_of_state = { sound_speed = 3940, slopes = [1.489, 0, 0], gamma = 2.02 }\n";
  const Material own = material("kg-m-s", copper + pressures);
  EXPECT_DOUBLE_EQ(own.shear_modulus, known.shear_modulus);
  EXPECT_EQ(own.johnson_cook, known.johnson_cook);
  ASSERT_TRUE(own.equation_of_state);
  EXPECT_NEAR(own.bulk_modulus, own.density * 3940 * 3940, 1e-3 * own.bulk_modulus);
  EXPECT_DOUBLE_EQ(material("kg-m-s", copper + pressures + "shear_modulus = 4e10\n").shear_modulus, 4e10);
}

TEST_F(KnownMaterials, StandWhereTheirNameDoes) {
  GivenTable given, scene;
  given.set("name", GivenValue(std::string("m")));
  given.set("use", GivenValue(std::string("copper OFHC, Johnson-Cook 1983"), GivenPlace("the line of use")));
  scene.set("units", GivenValue(std::string("SI")));
  scene.set("material", GivenValue(GivenArray{GivenValue(given)}));
  take_known_materials(scene);
  const GivenTable& filled = *scene.find("material")->as<GivenArray>()->at(0).as<GivenTable>();
  ASSERT_GT(filled.entries().size(), 6U) << "so many that the entries have moved";
  for (std::size_t k = 2; k < filled.entries().size(); ++k) {
    EXPECT_EQ(filled.entries()[k].place.text(""), "the line of use") << filled.entries()[k].key;
  }
}

TEST_F(KnownMaterials, OfAFolderOfOnesOwnComeFirst) {
  std::filesystem::create_directories(folder_ / "materials");
  std::ofstream(folder_ / "materials/own.toml")
      << "[[material]]\nname = \"copper OFHC, Johnson-Cook 1983\"\nmodel = \"elastic\"\ndensity = 1000\n"
         "young_modulus = 1e9\npoisson_ratio = 0.3\n";
  ASSERT_EQ(::setenv("PINBALL_DATA", folder_.path.c_str(), 1), 0);
  EXPECT_EQ(material("SI", copper).density, 1000);
  std::ofstream(folder_ / "materials/own.toml") << "[[material]]\nname = \"curve\"\nyield_curve = { stress = [1] }\n";
  EXPECT_THAT(error("units = \"SI\"", "use = \"curve\""), HasSubstr("yield_curve: expected none in a material that"));
  std::ofstream(folder_ / "materials/own.toml") << "material = 1\n";
  EXPECT_THAT(error("units = \"SI\"", copper), HasSubstr("own.toml: expected tables [[material]]"));
  ::unsetenv("PINBALL_DATA");
}

TEST_F(KnownMaterials, ThatAreNoneAreRefused) {
  EXPECT_THAT(error("units = \"SI\"", "use = \"copper OFHC, Johnson-Cook 1984\""),
              HasSubstr("scene.toml:5:7: material.m.use: expected one of \"copper OFHC"));
  EXPECT_THAT(error("units = \"SI\"", "use = \"copper OFHC, Johnson-Cook 1984\""),
              HasSubstr("nearest is \"copper OFHC, Johnson-Cook 1983\""));
  EXPECT_THAT(error("units = \"SI\"", "use = 7"), HasSubstr("material.m.use: expected a text, got 7"));
  EXPECT_THAT(error("", copper), HasSubstr("material.m.use: expected `units` of the scene"));
  EXPECT_THAT(error("units = \"none\"", copper), HasSubstr("expected `units` of the scene"));
  EXPECT_THAT(error("units = \"mm\"", copper), HasSubstr("units: expected"))
      << "what is wrong with units is said first";
  EXPECT_THAT(error("units = 7", copper), HasSubstr("units: expected"));
  EXPECT_THAT(error("units = \"SI\"", copper + "density = -1"), HasSubstr("material.m.density: expected a number > 0"));
}

}  // namespace
}  // namespace pinball::known_materials_test

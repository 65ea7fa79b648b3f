#include <gmock/gmock.h>

#include <algorithm>

#include <solver/scene/units/unit_names.hpp>
#include <solver/scene/units/units.hpp>
#include <tests/support/error_of.hpp>

/// Names of units: what a scene may call its own, and what follows from them.
namespace pinball::units_test {
namespace {

using testing::HasSubstr;

std::string problem(const std::string& units) {
  const auto found = units_problem(units);
  return found ? found->text : "";
}

TEST(Units, AreFoundInAnyOrderAndByAnySeparator) {
  for (const char* text : {"g-mm-ms", "ms-mm-g", "mm-g-ms", "g/mm/ms", "g, mm, ms", "g_mm_ms", "mm-ms-N", "N/mm/ms",
                           "gram-millimetre-millisecond", "G-MM-MS", "ms-MPa-mm", "g-mm-ms-N-MPa-mJ"}) {
    const Units u = parse_units(text);
    EXPECT_EQ(problem(text), "") << text;
    EXPECT_EQ(u.length, "mm") << text;
    EXPECT_EQ(u.time, "ms") << text;
    EXPECT_NEAR(u.kilograms, 1e-3, 1e-15) << text;
    EXPECT_EQ(u.stress, "MPa") << text;
  }
}

TEST(Units, OfEveryQuantityHaveNamesWhereTheSystemHasThem) {
  const Units g = parse_units("g-mm-ms");
  EXPECT_EQ(g.mass, "g");
  EXPECT_EQ(g.force, "N");
  EXPECT_EQ(g.energy, "mJ");
  EXPECT_EQ(g.momentum, "N ms");
  EXPECT_EQ(g.velocity, "mm/ms");
  EXPECT_EQ(g.density, "g/mm^3");
  EXPECT_EQ(parse_units("tonne-mm-s").stress, "MPa");
  EXPECT_EQ(parse_units("N-mm-s").mass, "t");
  EXPECT_EQ(parse_units("N-mm-s").length, "mm");
  const Units kilogram = parse_units("kg/mm/ms");
  EXPECT_EQ(kilogram.stress, "GPa");
  EXPECT_EQ(kilogram.force, "kN");
  EXPECT_EQ(kilogram.energy, "J");
  const Units si = parse_units("SI");
  EXPECT_EQ(si.length, "m");
  EXPECT_EQ(si.stress, "Pa");
  EXPECT_EQ(si.density, "kg/m^3");
  EXPECT_EQ(parse_units("CGS").force, "dyn");
  const Units detonation = parse_units("g-cm-us");
  EXPECT_EQ(detonation.stress, "Mbar");
  EXPECT_EQ(detonation.force, "g cm/us^2");
  EXPECT_EQ(detonation.energy, "g cm^2/us^2");
  const Units inch = parse_units("in-lbf-s");
  EXPECT_EQ(inch.stress, "psi");
  EXPECT_EQ(inch.mass, "lbf s^2/in");
  EXPECT_EQ(inch.density, "lbf s^2/in^4");
  EXPECT_EQ(inch.energy, "lbf in");
  EXPECT_EQ(parse_units("lbf-ft-s").mass, "slug");
  EXPECT_EQ(parse_units("cm-N-s").stress, "N/cm^2");
}

TEST(Units, AreKnownInSI) {
  EXPECT_NEAR(parse_units("tonne-mm-s").density_si(), 1e12, 1);
  EXPECT_NEAR(parse_units("g-mm-ms").density_si(), 1e6, 1e-6);
  EXPECT_NEAR(parse_units("in-lbf-s").density_si() * 7.34e-4, 7850, 10);
  EXPECT_NEAR(parse_units("in-lbf-s").stress_si() * 30e6, 206.8e9, 1e8);
  EXPECT_NEAR(parse_units("cm-N-s").density_si() * 7.85e-5, 7850, 1);
  EXPECT_FALSE(parse_units("none").known());
}

TEST(Units, OfSystemsAreKnownHoweverTheirNamesAreWritten) {
  for (const char* name : {"SI", "si", "S.I.", "MKS", "M.K.S.", "m k s"}) {
    EXPECT_EQ(problem(name), "") << name;
    EXPECT_EQ(parse_units(name).stress, "Pa") << name;
    EXPECT_EQ(parse_units(name).metres, 1) << name;
  }
  for (const char* name : {"cgs", "CGS", "C.G.S.", "c g s"}) {
    EXPECT_EQ(problem(name), "") << name;
    EXPECT_DOUBLE_EQ(parse_units(name).density_si(), 1000) << name;
  }
}

TEST(Units, ThatAreNotUnderstoodAreRefused) {
  EXPECT_THAT(problem("foo-bar-baz"), HasSubstr("\"foo\" is the name of none"));
  EXPECT_THAT(problem("mm-ms"), HasSubstr("a mass, a force or a stress is missing"));
  EXPECT_THAT(problem("kg-m"), HasSubstr("a time is missing"));
  EXPECT_THAT(problem("kg-m-mm-s"), HasSubstr("\"mm\" is a length where there is one already"));
  EXPECT_THAT(problem("g-mm-ms-GPa"), HasSubstr("\"GPa\" is not a stress of these units, which is \"MPa\""));
  EXPECT_THAT(problem("MG-MM-S"), HasSubstr("\"MG\""));  // a milligram or a tonne
  EXPECT_THAT(problem("lb-in-s"), HasSubstr("\"lb\""));  // a mass or a force
  EXPECT_THAT(problem("in--s"), HasSubstr("missing"));
  for (const char* none : {"", "none"}) {
    EXPECT_EQ(problem(none), "");
    EXPECT_EQ(parse_units(none).length, "");
  }
  EXPECT_EQ(parse_units("foo-bar-baz").time, "");
}

TEST(Units, StandInOneLineForFiles) {
  EXPECT_EQ(units_line(""), "units: not named");
  EXPECT_EQ(units_line("ms, mm, g"),
            "units: ms  mm  g; time [ms]; length [mm]; velocity [mm/ms]; mass [g]; force [N]; momentum [N ms]; energy "
            "[mJ]; stress [MPa]");
}

TEST(Units, OfAHostsSceneAreCheckedToo) {
  Scene scene;
  scene.units = "N-mm";
  EXPECT_THAT(test::error_of([&] { checked_scene(scene); }), testing::StartsWith("units: expected a length"));
}

}  // namespace
}  // namespace pinball::units_test

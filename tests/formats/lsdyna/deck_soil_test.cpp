#include <gmock/gmock.h>

#include "deck_case.hpp"

/// *MAT_005 and *EOS_008: what crushes.
namespace pinball::test::deck_soil_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class DeckSoil : public DeckTest {
 protected:
  /// first: its card behind RO; options: VCR, REF and LCID.
  static std::string soil(const std::string& first, const std::string& options, const std::string& points,
                          const std::string& more = "") {
    return cube + ends + "*MAT_005\n1,1.8E-9," + first + "\n" + options + "\n" + points + more;
  }
  static constexpr const char* constants = "80.,900.,100.,3.,0.3,-2.";
  static constexpr const char* points = "0.,-0.02,-0.1\n\n0.,1.,10.\n\n";
  Material material(const std::string& deck) { return scene(deck).materials.at(0); }
  std::vector<std::string> told(const std::string& deck) { return translate(deck).understood; }
};

TEST_F(DeckSoil, HasAStrengthAndACurve) {
  const Material m = material(soil(constants, "", points));
  ASSERT_TRUE(m.plastic && m.drucker_prager && m.equation_of_state);
  EXPECT_EQ(*m.drucker_prager, (DruckerPragerSettings{100, 3, 0.3}));
  EXPECT_EQ(m.shear_modulus, 80);
  EXPECT_EQ(m.bulk_modulus, 900);
  EquationOfStateSettings expected;
  expected.form = EquationOfStateForm::tabulated;
  expected.volume_strain = {0, -0.02, -0.1};
  expected.pressure = {0, 1, 10};
  expected.unloading_modulus = {900};
  expected.tension_limit = 2;
  EXPECT_EQ(*m.equation_of_state, expected);
  expected.tension_limit = 0;
  expected.bears_tension = false;
  EXPECT_EQ(*material(soil("80.,900.,100.,3.,0.3", "0", points)).equation_of_state, expected);
  expected.unloading_modulus.clear();
  EXPECT_EQ(*material(soil("80.,900.,100.", "1", points)).equation_of_state, expected);
  EXPECT_THAT(told(soil("80.,900.,100.", "1", points)), Contains(HasSubstr("with VCR 1 it goes back along the curve")));
}

TEST_F(DeckSoil, MayHaveItsStrainsWithEitherSignAndAsACurve) {
  const std::string curve = "*DEFINE_CURVE\n5\n0.02,1\n0.1,10\n*DEFINE_CURVE\n6\n-0.1,10\n-0.02,1\n0,0\n";
  for (const std::string& deck :
       {soil(constants, "", "0.,0.02,0.1\n\n0.,1.,10.\n\n"), soil(constants, "0,0,5", "", curve),
        soil(constants, "0,0,6", "", curve), soil(constants, "", "-0.02,-0.1\n\n1.,10.\n\n")}) {
    const EquationOfStateSettings eos = *material(deck).equation_of_state;
    EXPECT_EQ(eos.volume_strain, (std::vector<double>{0, -0.02, -0.1}));
    EXPECT_EQ(eos.pressure, (std::vector<double>{0, 1, 10}));
  }
  EXPECT_THAT(told(soil(constants, "", "0.,0.02,0.1\n\n0.,1.,10.\n\n")),
              Contains(HasSubstr("EPS1 to EPS10: strains above 0 are compressions")));
  EXPECT_THAT(told(soil(constants, "0,0,5", "", curve)), Contains(HasSubstr("LCID: the curve begins at 0")));
  EXPECT_THAT(told(soil(constants, "0,0,6", "", curve)), Not(Contains(HasSubstr("begins at 0"))));
  EXPECT_THAT(told(soil(constants, "0,0,6", points, curve)), Contains(HasSubstr("P1 to P10")));
}

/// *MAT_014 is it, without tension after PC.
TEST_F(DeckSoil, MayTear) {
  const auto torn = [](const std::string& first) {
    return cube + ends + "*MAT_014\n1,1.8E-9," + first + "\n\n" + points;
  };
  EquationOfStateSettings expected = *material(soil(constants, "", points)).equation_of_state;
  EXPECT_FALSE(expected.tears);
  expected.tears = true;
  EXPECT_EQ(*material(torn(constants)).equation_of_state, expected);
  EXPECT_EQ(*material(torn(constants)).drucker_prager, *material(soil(constants, "", points)).drucker_prager);
  const EquationOfStateSettings dry = *material(torn("80.,900.,100.,3.,0.3")).equation_of_state;
  EXPECT_FALSE(dry.tears);
  EXPECT_FALSE(dry.bears_tension);
}

TEST_F(DeckSoil, RefusesWhatIsNotDone) {
  EXPECT_THAT(error(soil(constants, "", "")), HasSubstr("expected 2 to 10 points EPS and P, or a curve LCID"));
  EXPECT_THAT(error(soil(constants, "", "-0.1,0.,0.1\n\n1.,0.,10.\n\n")), HasSubstr("eps1 to eps10"));
  EXPECT_THAT(error(soil(constants, "", "-0.01,0.02\n\n1.,10.\n\n")), HasSubstr("expected strains of one sign"));
  EXPECT_THAT(error(soil(constants, "", "0.,-0.1\n\n5.,10.\n\n")), HasSubstr("expected 0 at a volume_strain of 0"));
  EXPECT_THAT(error(soil(constants, "0,1", points)), HasSubstr("the mesh has no stress"));
  EXPECT_THAT(error(soil(constants, "0.5", points)), HasSubstr("VCR"));
  EXPECT_THAT(error(soil("80.,900.,100.,3.,0.3,2.", "", points)), HasSubstr("PC"));
  EXPECT_THAT(error(soil("80.,0.,100.", "", points)), HasSubstr("KUN: expected more than 0 with VCR 0"));
  EXPECT_THAT(error(soil("80.,900.,0.,0.,0.,-2.", "", points)), HasSubstr("what has no strength is a fluid"));
  EXPECT_THAT(error(soil("80.,900.,100.,-3.", "", points)), HasSubstr("drucker_prager.linear: expected a number >= 0"));
  EXPECT_THAT(error(soil(constants, "0,0,7", "")), HasSubstr("no *DEFINE_CURVE has the number 7"));
}

TEST_F(DeckSoil, TellsOfAKunThatIsLessThanASlope) {
  EXPECT_THAT(told(soil("80.,100.,100.", "", points)),
              Contains(HasSubstr("KUN is less than the steepest slope of its curve, 112.5")));
  EXPECT_THAT(told(soil("80.,113.,100.", "", points)), Not(Contains(HasSubstr("KUN"))));
}

TEST_F(DeckSoil, AnEquationOfStateHasAModulusForEachPoint) {
  std::string deck = cube;
  const auto at = deck.find("1,1,1\n", deck.find("*PART\n"));
  deck.replace(at, 6, "1,1,1,7\n");
  const auto with = [&](const std::string& head, const std::string& moduli) {
    return deck + ends + "*MAT_NULL\n1,1.E-9,-0.1,1.E-9\n*EOS_008\n" + head +
           "\n0.,-0.1,-0.2\n\n0.,2.E4,6.E4\n\n1.,1.,0.5\n\n" + moduli + "\n\n";
  };
  const EquationOfStateSettings eos = *material(with("7,2.", "3.E5,4.E5,5.E5")).equation_of_state;
  EXPECT_EQ(eos.volume_strain, (std::vector<double>{0, -0.1, -0.2}));
  EXPECT_EQ(eos.pressure, (std::vector<double>{0, 2e4, 6e4}));
  EXPECT_EQ(eos.energy_factor, (std::vector<double>{2, 2, 1}));
  EXPECT_EQ(eos.unloading_modulus, (std::vector<double>{3e5, 4e5, 5e5}));
  EXPECT_EQ(eos.tension_limit, 0.1);
  EXPECT_THAT(told(with("7", "3.E5,4.E5,5.E5")), Contains(HasSubstr("*EOS_008: T1 to T10")));
  EXPECT_THAT(error(with("7,2.", "3.E5,0.,5.E5")), HasSubstr("unloading_modulus: expected numbers > 0, got 0"));
  EXPECT_THAT(error(with("7,2.,1.", "3.E5,4.E5,5.E5")), HasSubstr("E0"));
}

}  // namespace
}  // namespace pinball::test::deck_soil_test

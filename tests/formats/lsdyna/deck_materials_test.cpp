#include <gmock/gmock.h>

#include <cmath>

#include "deck_case.hpp"

/// Materials of decks: what of their cards is used, told or refused.
namespace pinball::test::deck_materials_test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::Contains;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class DeckMaterials : public DeckTest {
 protected:
  /// *MAT_024 of three cards, the fourth being of no use to most.
  static std::string with(const std::string& first, const std::string& second, const std::string& more = "") {
    return cube + ends + "*MAT_024\n1,7.85E-9,210000.,0.3," + first + "\n" + second + "\n" + more +
           "*DEFINE_CURVE\n5\n0,300\n0.1,400\n*DEFINE_CURVE\n6\n0,1\n100,1.5\n";
  }
  Material material(const std::string& deck) { return scene(deck).materials.at(0); }
  std::vector<std::string> told(const std::string& deck) { return translate(deck).understood; }
};

TEST_F(DeckMaterials, CurvesComeBeforePointsAndThesBeforeTheTangent) {
  const std::string points = "0,0.2\n250,350\n";
  const auto both = material(with("300,1000", "0,0,5", points));
  EXPECT_THAT(both.yield_curves.at(0).stress, ElementsAre(300, 400));
  EXPECT_THAT(told(with("300,0", "0,0,5", points)),
              Contains(AllOf(HasSubstr("*MAT_024: EPS1 to EPS8, ES1 to ES8 ("), HasSubstr("LCSS is used"))));
  EXPECT_THAT(told(with("300,1000", "0,0,5")),
              Contains(AllOf(HasSubstr("*MAT_024: ETAN ("), HasSubstr("that of the curve"))));
  EXPECT_THAT(told(with("300,0", "0,0,5")), Not(Contains(AnyOf(HasSubstr("EPS1"), HasSubstr("ETAN")))));
  EXPECT_THAT(material(with("300", "0", points)).yield_curves.at(0).stress, ElementsAre(250, 350));
  const auto before = Contains(HasSubstr("EPS1: before its first plastic strain, 0.05, it keeps the stress 250"));
  EXPECT_THAT(told(with("300", "0", "0.05,0.2\n250,350\n")), before);
  EXPECT_THAT(told(with("300", "0", points)), Not(Contains(HasSubstr("EPS1"))));
}

TEST_F(DeckMaterials, RatesScaleEveryKindOfHardening) {
  const auto scaled = [&](const std::string& first, const std::string& second, const std::string& points = "") {
    const Material m = material(with(first, second, points));
    EXPECT_EQ(m.yield_curves.size(), 2U);
    EXPECT_EQ(m.yield_curves.back().rate, 100);
    return m.yield_curves.back();
  };
  EXPECT_THAT(scaled("300", "0,0,5,6").stress, ElementsAre(450, 600));
  EXPECT_THAT(scaled("300", "0,0,0,6", "0,0.2\n250,350\n").stress, ElementsAre(375, 525));
  const YieldCurve linear = scaled("300,2100", "0,0,0,6");
  EXPECT_THAT(linear.plastic_strain, ElementsAre(0, 1));
  EXPECT_NEAR(linear.stress[0], 1.5 * 300, 1e-9);
  EXPECT_NEAR(linear.stress[1] - linear.stress[0], 1.5 * 210000. * 2100 / (210000 - 2100), 1e-9);
}

TEST_F(DeckMaterials, AViscoplasticRateAddsToTheYieldStress) {
  EXPECT_EQ(material(with("300", "40,5,5,0,1")).rate_stress, 300);
  EXPECT_EQ(material(with("300", "40,5,5,0,1")).strain_rate, StrainRate::plastic);
  EXPECT_EQ(material(with("0", "40,5,5,0,1")).rate_stress, 0);
  EXPECT_EQ(material(with("300", "40,5,5,0,0")).rate_stress, 0);
  EXPECT_EQ(material(with("300", "40,5,5,0,-1")).strain_rate, StrainRate::deviatoric);
}

/// Cowper and Symonds: 1 + (rate/C)^(1/P), of both materials.
TEST_F(DeckMaterials, ConstantsOfTheRateAreThoseOfTheCard) {
  for (const std::string& cards :
       {with("300", "40,5,0,0,1"), cube + ends + "*MAT_003\n1,7.85E-9,210000.,0.3,300,1000,0.5\n40,5\n"}) {
    EXPECT_EQ(material(cards).rate_constant, 40) << cards;
    EXPECT_EQ(material(cards).rate_exponent, 5) << cards;
  }
}

/// sigma_y = K (e_0 + e)^N, from SIGY or from where E e crosses K e^N.
TEST_F(DeckMaterials, APowerBeginsWhereSigySaysOrWhereTheElasticLineCrossesIt) {
  const auto power = [&](const std::string& sigy, const std::string& n = "0.2") {
    return cube + ends + "*MAT_018\n1,7.85E-9,210000.,0.3,600.," + n + ",40,5\n" + sigy + "\n";
  };
  const Material given = material(power("400,1,0.3"));
  EXPECT_EQ(given.yield_stress, 400);
  EXPECT_EQ(*given.power_hardening, (PowerHardeningSettings{600, 0.2}));
  EXPECT_EQ(given.rate_constant, 40);
  EXPECT_EQ(given.rate_exponent, 5);
  EXPECT_EQ(given.strain_rate, StrainRate::plastic);
  EXPECT_EQ(given.erosion_strain, 0.3);
  const double crossing = material(power("")).yield_stress;
  EXPECT_NEAR(crossing, 600 * std::pow(crossing / 210000, 0.2), 1e-9 * crossing);
  EXPECT_NEAR(material(power("0.01")).yield_stress, 600 * std::pow(0.01, 0.2), 1e-9);
  EXPECT_THAT(error(power("400", "1.2")), HasSubstr("N: expected a number > 0 and < 1, got 1.2"));
}

TEST_F(DeckMaterials, BetaIsTheIsotropicShareWhateverItIs) {
  for (const double beta : {0.0, 0.05, 0.2, 0.3, 0.7, 1.0}) {
    const std::string card = "*MAT_003\n1,7.85E-9,210000.,0.3,300,1000," + std::to_string(beta) + "\n";
    EXPECT_DOUBLE_EQ(material(cube + ends + card).isotropic_share, beta);
  }
}

/// SFA, SFO, OFFA and OFFO: factor times (value plus offset).
TEST_F(DeckMaterials, CurvesAreScaledAndShiftedInBothDirections) {
  const auto curve = [&](const std::string& head) {
    return material(cube + ends + "*MAT_024\n1,7.85E-9,210000.,0.3,300\n0,0,5\n*DEFINE_CURVE\n5,0," + head +
                    "\n0,300\n0.1,400\n0.3,450\n")
        .yield_curves.at(0);
  };
  EXPECT_THAT(curve("2,0").plastic_strain, ElementsAre(0, DoubleEq(0.2), DoubleEq(0.6)));
  EXPECT_THAT(curve("2,0").stress, ElementsAre(300, 400, 450));
  EXPECT_THAT(curve("0,3").plastic_strain, ElementsAre(0, 0.1, 0.3));
  EXPECT_THAT(curve("0,3").stress, ElementsAre(900, 1200, 1350));
  EXPECT_THAT(curve("2,3,0.1,50").plastic_strain, ElementsAre(0, DoubleEq(0.2), DoubleEq(0.4), DoubleEq(0.8)))
      << "and begins at zero strain with its first stress";
  EXPECT_THAT(curve("2,3,0.1,50").stress, ElementsAre(1050, 1050, 1350, 1500));
}

TEST_F(DeckMaterials, TwoLawsOfTheRateAreRefused) {
  EXPECT_THAT(error(with("300", "40,5,5,6")), HasSubstr("LCSR) and with C and P"));
  EXPECT_THAT(error(with("300", "0,0,9,6") + "*DEFINE_TABLE\n9\n0,5\n100,5\n"), HasSubstr("and with LCSR"));
}

TEST_F(DeckMaterials, WhatIsNotUsedIsTold) {
  const auto one_constant = [](const char* field) {
    return Contains(AllOf(HasSubstr(field), HasSubstr("a law of the strain rate has both of its constants")));
  };
  EXPECT_THAT(told(with("300", "40")), one_constant("*MAT_024: C ("));
  EXPECT_THAT(told(with("300,0,0,1e-9", "")), Contains(HasSubstr("TDEL")));
  const std::string part = "cube\n1,1,1\n", heated = "cube\n1,1,1,0,0,0,0,3\n";
  std::string hot = cube;
  hot.replace(hot.find(part), part.size(), heated);
  EXPECT_THAT(told(hot + ends + elastic),
              Contains(AllOf(HasSubstr("*PART: TMID ("), HasSubstr("heat is not computed"))));
  EXPECT_THAT(told(cube + ends + elastic), Not(Contains(HasSubstr("TMID"))));
  EXPECT_THAT(told(cube + ends + "*MAT_ELASTIC\n1,7.85E-9,210000.,0.3,0.1\n"),
              Contains(AllOf(HasSubstr("*MAT_ELASTIC: DA ("), HasSubstr("of beams"))));
  EXPECT_THAT(told(cube + ends + "*MAT_003\n1,7.85E-9,210000.,0.3,300,1000,0.5\n40,0\n"),
              one_constant("*MAT_003: SRC ("));
}

TEST_F(DeckMaterials, PointsThatDoNotAscendAreAnError) {
  EXPECT_THAT(error(with("300", "", "0,0.2,0.1\n250,350,400\n")),
              HasSubstr("expected ascending strains, got 0.1 after"));
  EXPECT_THAT(error(cube + ends + "*MAT_003\n1,7.85E-9,210000.,0.3,300,1000,0.5\n0,0,-1\n"), HasSubstr("FS: expected"));
}

/// In tons, seconds and millimetres, of a deck in kg, ms and mm: a stress of 1 is 1e-3, a rate 1e-3, a density 1e3.
TEST_F(DeckMaterials, OfAnIncludedFileAreConverted) {
  const auto converted = [&](const std::string& cards, const std::string& own = "") {
    std::ofstream(folder_ / "steel.k") << "*KEYWORD\n" << cards << "*END\n";
    return material(cube + ends + own + "*INCLUDE_TRANSFORM\nsteel.k\n\n\n1000,1000,1,1,0\n\n");
  };
  const std::string curves = "*DEFINE_CURVE\n5\n0,300\n0.1,400\n", ratio = "*DEFINE_CURVE\n6\n0,1\n100,1.5\n";
  const auto with_cards = [](const std::string& rest) { return "*MAT_024\n1,7.85E-9,210000.,0.3," + rest; };

  const Material linear = converted("*MAT_003\n1,7.85E-9,210000.,0.3,300,2100,0.5\n40,5,0.2\n");
  EXPECT_DOUBLE_EQ(linear.density, 7.85e-6);
  EXPECT_DOUBLE_EQ(linear.shear_modulus, 210. / 2.6);
  EXPECT_DOUBLE_EQ(linear.yield_stress, 0.3);
  EXPECT_DOUBLE_EQ(linear.plastic_modulus, 1e-3 * 210000. * 2100 / (210000 - 2100));
  EXPECT_DOUBLE_EQ(linear.rate_constant, 0.04);
  EXPECT_EQ(linear.rate_exponent, 5);
  EXPECT_EQ(linear.erosion_strain, 0.2);

  const Material points = converted(with_cards("300\n40,5,0,0,1\n0,0.2\n250,350\n"));
  EXPECT_THAT(points.yield_curves.at(0).stress, ElementsAre(DoubleEq(0.25), DoubleEq(0.35)));
  EXPECT_DOUBLE_EQ(points.rate_stress, 0.3);

  const Material rates = converted(with_cards("300\n0,0,5,6\n") + curves + ratio);
  EXPECT_THAT(rates.yield_curves.at(1).stress, ElementsAre(DoubleEq(0.45), DoubleEq(0.6)));
  EXPECT_DOUBLE_EQ(rates.yield_curves.at(1).rate, 0.1);

  const std::string logarithms = "*DEFINE_TABLE\n9\n-3.,5\n3.,7\n*DEFINE_CURVE\n7\n0,600\n0.1,800\n";
  const Material table = converted(with_cards("0\n0,0,9\n") + curves + logarithms);
  EXPECT_EQ(table.rate_interpolation, RateInterpolation::logarithmic);
  EXPECT_DOUBLE_EQ(table.yield_curves.at(0).rate, 1e-3 * std::exp(-3.));
  EXPECT_DOUBLE_EQ(table.yield_curves.at(1).rate, 1e-3 * std::exp(3.));
  EXPECT_THAT(table.yield_curves.at(1).stress, ElementsAre(DoubleEq(0.6), DoubleEq(0.8)));

  const Material mixed = converted(with_cards("0\n0,0,5\n"), curves);
  EXPECT_THAT(mixed.yield_curves.at(0).stress, ElementsAre(300, 400)) << "a curve is in the units of its own file";
}

/// Its ETAN is a slope over the plastic strain, and not the tangent modulus of others.
TEST_F(DeckMaterials, ReadsIsotropicElasticPlastic) {
  const Material m = material(cube + ends + "*MAT_012\n1,7.85E-9,80000.,400.,1000.,170000.\n");
  EXPECT_EQ(m.shear_modulus, 80000);
  EXPECT_EQ(m.bulk_modulus, 170000);
  EXPECT_EQ(m.yield_stress, 400);
  EXPECT_EQ(m.plastic_modulus, 1000);
  EXPECT_THAT(error(cube + ends + "*MAT_ISOTROPIC_ELASTIC_PLASTIC\n1,7.85E-9,80000.,400.,1000.\n"),
              HasSubstr("*MAT_ISOTROPIC_ELASTIC_PLASTIC: BULK"));
}

TEST_F(DeckMaterials, ReadsSimplifiedJohnsonAndCook) {
  const auto with = [](const std::string& vp, const std::string& second) {
    return cube + ends + "*MAT_098\n1,7.85E-9,210000.,0.3" + vp + "\n" + second + "\n";
  };
  const Material m = material(with(",1", "792.,510.,0.26,0.014,0.4,,,2."));
  ASSERT_TRUE(m.johnson_cook && !m.equation_of_state);
  const JohnsonCookSettings expected{510, 0.26, 0.014, 2, 1, 0, 0, 0, 1, {}};
  EXPECT_EQ(*m.johnson_cook, expected);
  EXPECT_EQ(m.yield_stress, 792);
  EXPECT_DOUBLE_EQ(m.shear_modulus, 210000. / 2.6);
  EXPECT_EQ(m.strain_rate, StrainRate::plastic);
  EXPECT_EQ(m.erosion_strain, 0.4);
  const Material plain = material(with("", "792.,510.,0.26,0.014"));
  EXPECT_EQ(plain.johnson_cook->reference_rate, 1) << "the default of EPS0";
  EXPECT_EQ(plain.strain_rate, StrainRate::deviatoric);
  EXPECT_EQ(material(with("", "792.,510.,0.26")).johnson_cook->rate_coefficient, 0);
  EXPECT_THAT(told(with(",1", "792.,,0.3")), AllOf(Contains(HasSubstr("*MAT_SIMPLIFIED_JOHNSON_COOK: N")),
                                                   Contains(HasSubstr("*MAT_SIMPLIFIED_JOHNSON_COOK: VP"))));
  EXPECT_THAT(error(with("", "792.,510.")), HasSubstr("*MAT_098: N: expected more than 0 beside B"));
  EXPECT_THAT(error(with("", "792.,,,0.1,,,,-1.")), HasSubstr("*MAT_098: EPS0: expected more than 0 beside C"));
  EXPECT_THAT(error(with("", "792.,,,,,900.")), HasSubstr("SIGMAX"));
  EXPECT_THAT(error(with("", "792.,,,,,,900.")), HasSubstr("SIGSAT"));
}

TEST_F(DeckMaterials, ReadsWhatIsBrittle) {
  const auto with = [](const std::string& third, const std::string& b = "0.31", const std::string& name = "110") {
    return cube + ends + "*MAT_" + name + "\n1,3.7E-9,90160.,0.93," + b +
           ",0.01,0.5,0.6\n2.,200.,0.4,2790.,1460.,0.9\n" + third + "\n";
  };
  const Material m = material(with("0.005,1.1,130950.,100.,200.,1.5"));
  ASSERT_TRUE(m.johnson_holmquist && m.plastic);
  EXPECT_EQ(*m.johnson_holmquist, (JohnsonHolmquistSettings{0.93, 0.6, 0.31, 0.5, 0.4, 0.01, 2, 200, 2790, 1460, 0.005,
                                                            1.1, 100, 200, 0.9, false}));
  EXPECT_EQ(m.bulk_modulus, 130950);
  EXPECT_EQ(m.shear_modulus, 90160);
  EXPECT_EQ(m.erosion_strain, 1.5);
  EXPECT_EQ(m.strain_rate, StrainRate::deviatoric);
  EXPECT_EQ(
      *material(with("0.005,1.1,130950.", "0.31", "JOHNSON_HOLMQUIST_CERAMICS")).johnson_holmquist,
      (JohnsonHolmquistSettings{0.93, 0.6, 0.31, 0.5, 0.4, 0.01, 2, 200, 2790, 1460, 0.005, 1.1, 0, 0, 0.9, false}));
  EXPECT_THAT(told(with("0.,1.1,130950.", "0.")),
              AllOf(Contains(HasSubstr("CERAMICS: M")), Contains(HasSubstr("CERAMICS: SFMAX")),
                    Contains(HasSubstr("CERAMICS: D2"))));
  EXPECT_THAT(error(with("0.005,1.,130950.,,,-1.")), HasSubstr("with FS < 0"));
  EXPECT_THAT(error(with("0.005,1.,130950.,-9E5")), HasSubstr("expected a pressure"));
}

/// Two parts of 4340 steel with an equation of state, in t, mm, s.
std::string steel(const std::string& equation, const std::string& failure = "0.05,3.44,-2.12,0.002") {
  std::string deck = cube;
  const auto at = deck.find("1,1,1\n", deck.find("*PART\n"));
  return deck.replace(at, 6, "1,1,1,7\n") + ends + "*MAT_015\n1,7.83E-9,77500.,200000.,0.29,0.,1\n" +
         "792.,510.,0.26,0.014,1.03,1793.,294.,1.\n4.77E8,0.,0.,0.," + failure + "\n0.61\n" + equation;
}
constexpr const char* grueneisen = "*EOS_GRUNEISEN\n7,4.569E6,1.49,0.1,0.2,2.17,0.46\n\n";

TEST_F(DeckMaterials, ReadsJohnsonAndCookWithItsEquationOfState) {
  const Material m = material(steel(grueneisen));
  const JohnsonCookSettings expected{510, 0.26, 0.014, 1, 1.03, 1793, 294, 4.77e8, 1, {0.05, 3.44, -2.12, 0.002, 0.61}};
  ASSERT_TRUE(m.johnson_cook && m.equation_of_state);
  EXPECT_EQ(*m.johnson_cook, expected);
  EXPECT_EQ(m.yield_stress, 792);
  EXPECT_EQ(m.shear_modulus, 77500);
  EXPECT_EQ(m.strain_rate, StrainRate::plastic);
  const EquationOfStateSettings eos{
      EquationOfStateForm::mie_grueneisen, 4.569e6, {1.49, 0.1, 0.2}, 2.17, 0.46, {}, {}, {}, {}, 0, true, {}, {}};
  EXPECT_EQ(*m.equation_of_state, eos);
  EXPECT_NEAR(m.bulk_modulus, 7.83e-9 * 4.569e6 * 4.569e6, 1e-6);
  EXPECT_THAT(error(steel(grueneisen, "0.,0.,0.,0.")), HasSubstr("expected D1 + D2 > 0"));  // D5 alone
  const Material polynomial = material(steel("*EOS_001\n7,0.,1.6E5,1.E5,2.E4,1.9,0.6,0.1\n\n"));
  EXPECT_EQ(polynomial.equation_of_state->coefficients, (std::vector<double>{0, 1.6e5, 1e5, 2e4, 1.9, 0.6, 0.1}));
}

/// "A negative input of D3 will be converted to its absolute value", of a pressure that counts compression.
TEST_F(DeckMaterials, D3OfJohnsonAndCookMeansTheSameWithEitherSign) {
  const std::string positive = steel(grueneisen, "0.05,3.44,2.12,0.002");
  EXPECT_EQ(material(positive).johnson_cook, material(steel(grueneisen)).johnson_cook);
  EXPECT_THAT(told(positive), Contains(HasSubstr("D3 of either sign counts as -2.12")));
  EXPECT_THAT(told(steel(grueneisen)), Not(Contains(HasSubstr("D3 of"))));
}

TEST_F(DeckMaterials, TablesHaveUpToTenPoints) {
  const auto with = [](const std::string& head, const std::string& strains, const std::string& factors) {
    return steel("*EOS_TABULATED\n" + head + "\n" + strains + "\n\n-5.E3,0.,2.E4,6.E4\n\n" + factors + "\n\n");
  };
  const EquationOfStateSettings eos = *material(with("7,2.", "0.1,0.,-0.1,-0.2", "1.,1.,0.5,0.5")).equation_of_state;
  EXPECT_EQ(eos.form, EquationOfStateForm::tabulated);
  EXPECT_EQ(eos.volume_strain, (std::vector<double>{0.1, 0, -0.1, -0.2}));
  EXPECT_EQ(eos.pressure, (std::vector<double>{-5e3, 0, 2e4, 6e4}));
  EXPECT_EQ(eos.energy_factor, (std::vector<double>{2, 2, 1, 1}));
  const std::string cold = with("7,2.", "0.1,0.,-0.1,-0.2", "");
  EXPECT_TRUE(material(cold).equation_of_state->energy_factor.empty());
  EXPECT_THAT(told(cold), Contains(HasSubstr("*EOS_TABULATED: GAMA")));
  EXPECT_THAT(told(with("7", "0.1,0.,-0.1,-0.2", "1.,1.,1.,1.")), Contains(HasSubstr("T1 to T10")));
  EXPECT_THAT(error(with("7,2.", "0.1,0.,-0.1,-0.05", "")),
              HasSubstr("EV4: expected rising or falling strains, and 0 behind the last point, got -0.05 behind -0.1"));
  EXPECT_THAT(error(with("7,2.,1.", "0.1,0.,-0.1,-0.2", "")), HasSubstr("E0"));
  EXPECT_THAT(error(with("7,2.,0.,0.9", "0.1,0.,-0.1,-0.2", "")), HasSubstr("V0"));
  EXPECT_THAT(error(with("7,2.,0.,1.,3", "0.1,0.,-0.1,-0.2", "")), HasSubstr("LCC"));
  EXPECT_THAT(error(with("7,2.", "0.1,0.,-0.1,-0.2", "") + "*EOS_009\n7\n"), HasSubstr("equation of state 7"));
}

TEST_F(DeckMaterials, JohnsonAndCookNameTheFieldThatIsMissing) {
  const auto with = [&](const std::string& given, const std::string& other) {
    std::string deck = steel(grueneisen);
    return error(deck.replace(deck.find(given), given.size(), other));
  };
  EXPECT_THAT(with("294.,1.\n", "294.,0.\n"), HasSubstr("deck.k:22: *MAT_015: EPS0: expected more than 0 beside C"));
  EXPECT_THAT(with("4.77E8,", "0.,"), HasSubstr("*MAT_015: CP: expected more than 0 beside TM"));
  EXPECT_THAT(with("510.,0.26,", "510.,0.,"), HasSubstr("*MAT_015: N: expected more than 0 beside B"));
}

TEST_F(DeckMaterials, NullIsAFluidWithAnEquationOfState) {
  const auto null = [](const std::string& card) {
    std::string deck = steel(grueneisen);
    const auto at = deck.find("*MAT_015");
    return deck.replace(at, deck.find("*EOS") - at, "*MAT_009\n1,1.E-9," + card + "\n");
  };
  const Material m = material(null("-0.1,1.E-9"));
  EXPECT_EQ(*m.fluid, FluidSettings{1e-9});
  EXPECT_EQ(m.equation_of_state->tension_limit, 0.1);
  EXPECT_EQ(m.equation_of_state->sound_speed, 4.569e6);
  EXPECT_EQ(m.shear_modulus, 0);
  EXPECT_THAT(told(null("0.,1.E-9")), Contains(HasSubstr("*MAT_NULL with PC 0: its tension has no limit")));
  EXPECT_THAT(told(null("-0.1,1.E-9,0.,0.,5.,0.3")), Contains(HasSubstr("of beams and shells")));
  EXPECT_THAT(error(null("0.1,1.E-9")), HasSubstr("PC"));
  EXPECT_THAT(error(null("-0.1,1.E-9,1.1")), HasSubstr("elements are not eroded by their volume"));
  std::string none = null("-0.1,1.E-9");
  none.replace(none.find("1,1,1,7\n"), 8, "1,1,1\n");
  EXPECT_THAT(error(none), HasSubstr("*MAT_NULL without an equation of state"));
}

TEST_F(DeckMaterials, RefusesEquationsOfStateThatAreMissingOrOfNoUse) {
  EXPECT_THAT(error(steel("")), HasSubstr("*PART with EOSID 7, which no *EOS_... has that is read"));
  std::string none = steel(grueneisen);
  none.replace(none.find("1,1,1,7\n"), 8, "1,1,1\n");
  EXPECT_THAT(error(none), HasSubstr("*MAT_JOHNSON_COOK without an equation of state"));
  std::string elastic = steel(grueneisen);
  elastic.replace(elastic.find("*MAT_015"), std::string::npos,
                  std::string("*MAT_001\n1,7.83E-9,2.E5,0.3\n") + grueneisen);
  EXPECT_THAT(error(elastic), HasSubstr("*PART with an equation of state (EOSID) and *MAT_"));
}

/// Limits of one material of two.
TEST_F(DeckMaterials, ReadsLimitsOfErosion) {
  const std::string steel_card = "*MAT_001\n1,7.85E-9,210000.,0.3\n", add = "*MAT_ADD_EROSION\n1,0.,900.\n";
  const Material m =
      material(cube + ends + steel_card + add + "-300.,400.,500.,0.6,0.7,0.,0.,5.E-7\n\n\n0.,0.,0.,1.E-9\n");
  const ErosionSettings expected{300, 900, 400, 500, 0.6, 0.7, 5e-7, 1e-9, 0};
  ASSERT_TRUE(m.erosion);
  EXPECT_EQ(*m.erosion, expected);
  EXPECT_FALSE(m.plastic);
  EXPECT_FALSE(material(cube + ends + steel_card + "*MAT_ADD_EROSION\n1\n\n").erosion);
  EXPECT_THAT(error(cube + ends + steel_card + add + "300.\n"), HasSubstr("MNPRES"));
  EXPECT_THAT(error(cube + ends + steel_card + "*MAT_ADD_EROSION\n1,0.,0.,0.,0.,0.,1.,2.\n\n"), HasSubstr("NCS"));
  EXPECT_THAT(error(cube + ends + steel_card + "*MAT_ADD_EROSION\n1,-999.,-999.\n-999.,,,,0.3\n"),
              HasSubstr("*MAT_ADD_EROSION with EXCL"))
      << "before what it stands for is held against bounds";
  EXPECT_THAT(error(cube + ends + steel_card + add + "-1.\n" + add + "-2.\n"), HasSubstr("erosion of material 1"));
}

TEST_F(DeckMaterials, ErodesElementsOfSmallStepsWhereTheDeckSaysSo) {
  const std::string steel_card = "*MAT_001\n1,7.85E-9,210000.,0.3\n", end = "*CONTROL_TERMINATION\n1.E-6,0,0.05\n";
  const Material m = material(cube + end + steel_card + "*CONTROL_TIMESTEP\n0.,0.9,0,0.,0.,0,1\n");
  ASSERT_TRUE(m.erosion);
  EXPECT_EQ(m.erosion->step_share, 0.05);
  EXPECT_FALSE(material(cube + end + steel_card).erosion);
}

}  // namespace
}  // namespace pinball::test::deck_materials_test

#include <gmock/gmock.h>

#include "radioss_card_decks.hpp"

/// Where Radioss does something else than what the same words would mean elsewhere: it is done, or refused by name.
namespace pinball::test::radioss_differences_test {
namespace {

using ::testing::Contains;
using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class RadiossDifferences : public RadiossTest {
 protected:
  static std::string surface(const std::string& kind, const std::string& members) {
    return "/SURF/" + kind + "/5\ns\n" + members;
  }
  static std::string top() { return "/GRNOD/NODE/5\ntop\n" + ten({"5", "6", "7", "8"}); }
  static std::string contact(const char* curvature, const std::string& lines) {
    return top() + surface("SEG", ten({"0", "1", "2", "3", "4"})) + "/INTER/TYPE7/1\nc\n" +
           ten({"5", "5", "-", "-", "-", "-", "-", "-", curvature}) + lines;
  }
};

TEST_F(RadiossDifferences, FunctionsOfTimeGoOnAlongTheirOuterPieces) {
  const auto table = [&](const std::string& points) {
    return scene(cube_with(top() + "/FUNCT/5\nf\n" + points + "/IMPVEL/1\nv\n" + ten({"5", "Z", "0", "0", "5"}) + "\n"))
        .prescribed_velocities.at(0)
        .table;
  };
  engine_ = "/RUN/cube/1\n4.0\n";
  const TimeTable both = table(twenty({1, 10}) + twenty({2, 20}) + twenty({3, 50}));
  EXPECT_THAT(both.times, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(both.factors, ElementsAre(0, 10, 20, 50, 80));
  EXPECT_THAT(table(twenty({0, 1}) + twenty({1, 2}) + twenty({2, 2})).times, ElementsAre(0, 1, 2)) << "level";
  EXPECT_THAT(table(twenty({0, 1}) + twenty({9, 2})).times, ElementsAre(0, 9)) << "longer than the run";
  EXPECT_THAT(table(twenty({1, 7})).factors, ElementsAre(7)) << "one point";
}

TEST_F(RadiossDifferences, LinesBehindACurvatureKeepTheirPlaces) {
  const std::string frictionless = "\n\n" + ten({"1", "2"}) + twenty({0, 0.25}) + "\n\n";
  EXPECT_THAT(error(cube_with(contact("1", frictionless))), HasSubstr("/INTER/TYPE7/1 with Icurv 1"));
  EXPECT_THAT(error(cube_with(contact("1", frictionless))), Not(HasSubstr("Fric")));
  EXPECT_THAT(error(cube_with(contact("3", "\n\n" + twenty({0, 0.25}) + "\n\n"))), HasSubstr("with Icurv 3"));
  const Scene made = scene(cube_with(contact("0", "\n\n" + twenty({0, 0.25}) + "\n\n")));
  EXPECT_EQ(made.contact_pairs.at(0).friction, 0.25);
}

TEST_F(RadiossDifferences, TiesThatBreakAreRefused) {
  const auto tie = [&](const char* flag) {
    return cube_with(top() + surface("SEG", ten({"0", "1", "2", "3", "4"})) + "/INTER/TYPE2/1\nt\n" +
                     ten({"5", "5", "0", flag}));
  };
  for (const char* flag : {"20", "21", "22"})
    EXPECT_THAT(error(tie(flag)), HasSubstr(std::string("/INTER/TYPE2/1 with Spotflag ") + flag));
  EXPECT_EQ(error(tie("25")), no_error);
}

TEST_F(RadiossDifferences, CurvesOfRatesAreInterpolatedAsTheirFlagSays) {
  const auto tabulated = [&](const char* smoothing) {
    return scene(radioss_begin + radioss_property + radioss_cube + "/FUNCT/5\nf\n" + twenty({0, 1}) + twenty({1, 2}) +
                 "/MAT/PLAS_TAB/1\nm\n" + twenty({7.85e-9, 0}) + twenty({210000, 0.3}) + ten({"2", smoothing}) + "\n" +
                 ten({"5", "5"}) + twenty({100, 200}) + twenty({0.1, 10}))
        .materials.at(0);
  };
  EXPECT_EQ(tabulated("0").rate_interpolation, RateInterpolation::linear);
  EXPECT_EQ(tabulated("2").rate_interpolation, RateInterpolation::logarithmic);
}

/// As behind their last point (VINTER2 of the engine).
TEST_F(RadiossDifferences, YieldStressesGoOnAlongTheirFirstPieceDownToZeroStrain) {
  const auto curve = [&](const std::string& points) {
    return scene(radioss_begin + radioss_property + radioss_cube + "/FUNCT/5\nf\n" + points + "/MAT/PLAS_TAB/1\nm\n" +
                 twenty({7.85e-9, 0}) + twenty({210000, 0.3}) + ten({"1", "0"}) + "\n" + ten({"5"}) + twenty({2}) +
                 twenty({0}))
        .materials.at(0)
        .yield_curves.at(0);
  };
  const YieldCurve steep = curve(twenty({0.125, 200}) + twenty({0.25, 300}));
  EXPECT_THAT(steep.plastic_strain, ElementsAre(0, 0.125, 0.25));
  EXPECT_THAT(steep.stress, ElementsAre(200, 400, 600));
  EXPECT_THAT(curve(twenty({0.125, 200})).stress, ElementsAre(400, 400)) << "one point";
  EXPECT_THAT(curve(twenty({0, 200}) + twenty({0.25, 300})).stress, ElementsAre(400, 600));
}

TEST_F(RadiossDifferences, AnIncludedFileThatEndsEndsNothingElse) {
  std::ofstream((folder_ / "steel.inc").string()) << radioss_steel << "/END\n";
  const std::string text = radioss_begin + "#include steel.inc\n" + radioss_property + radioss_cube;
  EXPECT_EQ(scene(text).materials.size(), 1U);
  EXPECT_EQ(scene(text).bodies.size(), 1U);
}

/// As OpenRadioss' reader has it; other lines that begin so are comments.
TEST_F(RadiossDifferences, IncludesHaveNoCase) {
  std::ofstream((folder_ / "steel.inc").string()) << radioss_steel;
  for (const char* keyword : {"#include", "#INCLUDE", "#Include"})
    EXPECT_EQ(
        scene(radioss_begin + "#inc\n" + keyword + " steel.inc\n" + radioss_property + radioss_cube).materials.size(),
        1U)
        << keyword;
}

TEST_F(RadiossDifferences, SkewsHaveAnOriginFromVersion120On) {
  const auto direction = [&](const char* version, const std::string& origin) {
    std::string begin = radioss_begin;
    begin.replace(begin.find("2022"), 4, version);
    return scene(begin + radioss_steel + radioss_property + radioss_cube + top() + "/SKEW/FIX/3\ns\n" + origin +
                 twenty({0, 0, 1}) + twenty({1, 0, 0}) + "/FUNCT/5\nf\n" + twenty({0, 1}) + "/IMPVEL/1\nv\n" +
                 ten({"5", "X", "3", "0", "5"}) + "\n")
        .prescribed_velocities.at(0)
        .direction.value();
  };
  EXPECT_THAT(direction("2022", "\n"), ElementsAre(0, 1, 0));  // Y x Z = z x x
  EXPECT_THAT(direction(" 110", ""), ElementsAre(0, 1, 0));
}

/// Z' stays, and Y' is turned into the plane at right angles to it.
TEST_F(RadiossDifferences, AxesThatAreNotAtRightAnglesKeepZ) {
  const auto direction = [&](const char* axis) {
    return scene(cube_with(top() + "/SKEW/FIX/3\ns\n\n" + twenty({0, 2, 0}) + twenty({0, 3, 4}) + "/FUNCT/5\nf\n" +
                           twenty({0, 1}) + "/IMPVEL/1\nv\n" + ten({"5", axis, "3", "0", "5"}) + "\n"))
        .prescribed_velocities.at(0)
        .direction.value();
  };
  EXPECT_EQ(direction("X"), (Point{1, 0, 0}));
  EXPECT_THAT(direction("Y"), ElementsAre(0, DoubleEq(0.8), DoubleEq(-0.6)));
  EXPECT_EQ(direction("Z"), (Point{0, 0.6, 0.8}));
  const Scene spins =
      scene(cube_with(top() + "/FRAME/FIX/3\nf\n" + twenty({0, 0, 0}) + twenty({0, 2, 0}) + twenty({0, 3, 4}) +
                      "/INIVEL/AXIS/1\nv\n" + ten({"Z", "3", "5"}) + twenty({0, 0, 10, 0})));
  EXPECT_THAT(spins.initial_velocities.at(0).velocity, ElementsAre(0, DoubleEq(6), DoubleEq(8)));
}

TEST_F(RadiossDifferences, GravityWithoutAFunctionHasAFactorOfOneWhereNoneIsGiven) {
  const auto gravity = [&](std::initializer_list<double> factors) {
    return scene(cube_with("/GRAV/1\ng\n" + ten({"0", "Z", "0", "0", "0", "-"}).substr(0, 60) + twenty(factors)))
        .gravities.at(0)
        .acceleration;
  };
  EXPECT_EQ(gravity({1, -9810}), (Point{0, 0, -9810}));
  EXPECT_EQ(gravity({1, 0}), (Point{0, 0, 1}));
}

TEST_F(RadiossDifferences, RatesOfHydrodynamicMaterialsAreTold) {
  const auto told = [&](double coefficient) {
    return translate(radioss_begin + "/MAT/HYD_JCOOK/1\nm\n" + twenty({7.85e-9, 0}) + twenty({210000, 0.3}) +
                     twenty({400, 500, 0.5}) + "\n" + twenty({coefficient, 1}) + "\n/EOS/POLYNOMIAL/1\ne\n" +
                     twenty({0, 175000}) + radioss_property + radioss_cube)
        .understood;
  };
  const auto note = Contains(HasSubstr("cube_0000.rad:7): the strain rate is sqrt(D:D), and in Radioss"));
  EXPECT_THAT(told(0.02), note);
  EXPECT_THAT(told(0), Not(note));
}

TEST_F(RadiossDifferences, PressuresPushAlongTheNormalsOfSegments) {
  const auto pressed = [&](const std::string& surface) {
    return cube_with(surface + "/FUNCT/5\nf\n" + twenty({0, 3}) + "/PLOAD/1\np\n" + ten({"5", "5"}));
  };
  const std::string out = surface("SEG", ten({"0", "5", "6", "7", "8"})),
                    in = surface("SEG", ten({"0", "5", "8", "7", "6"}));
  EXPECT_EQ(scene(pressed(out)).pressures.at(0).pressure, -1);
  EXPECT_EQ(scene(pressed(in)).pressures.at(0).pressure, 1);
  EXPECT_THAT(error(pressed(surface("PART/EXT", ten({"1"})))), HasSubstr("/PLOAD/1 of /SURF/PART/EXT/5"));
}

TEST_F(RadiossDifferences, OgdensEnergyIsMooneysAndRivlinsWhereItIs) {
  const auto rubber = [](const std::string& moduli, const std::string& exponents) {
    return radioss_begin + "/MAT/LAW42/1\nrubber\n" + twenty({1e-9}) + twenty({0.4}) + moduli + "\n" + exponents +
           "\n" + radioss_property + radioss_cube;
  };
  const Material neo = scene(rubber(twenty({3, 1}), twenty({2, 2}))).materials.at(0);
  EXPECT_FALSE(neo.mooney_rivlin);
  EXPECT_DOUBLE_EQ(neo.shear_modulus, 4);
  EXPECT_DOUBLE_EQ(neo.bulk_modulus, 4 * 2 * 1.4 / (3 * 0.2));
  const Material mooney = scene(rubber(twenty({3, -1}), twenty({2, -2}))).materials.at(0);
  EXPECT_EQ(*mooney.mooney_rivlin, (MooneyRivlinSettings{1.5, 0.5, 0.4}));
  const Material powers = scene(rubber(twenty({3, 1}), twenty({2, 1.3}))).materials.at(0);
  EXPECT_FALSE(powers.mooney_rivlin);
  EXPECT_EQ(*powers.ogden, (OgdenSettings{{3, 1}, {2, 1.3}, 0.4, false}));
  EXPECT_DOUBLE_EQ(powers.shear_modulus, 3.65);
  EXPECT_THAT(error(rubber(twenty({3, 1}), twenty({2, 0}))), HasSubstr("alpha_2"));
  EXPECT_THAT(error(rubber(twenty({3, 4}), twenty({2, -2}))), HasSubstr("Mu_1"));
}

/// As a number beyond all strains it is none.
TEST_F(RadiossDifferences, AStrainBeyondWhichNothingIsShearedIsRefused) {
  const auto steel = [](double limit) {
    return radioss_begin + "/MAT/LAW2/1\nsteel\n" + twenty({7.85e-9}) + twenty({210000, 0.3}) +
           twenty({400, 500, 1, limit}) + "\n\n" + radioss_property + radioss_cube;
  };
  EXPECT_THAT(error(steel(0.2)), HasSubstr("/MAT/LAW2/1 with EPS_p_max"));
  EXPECT_EQ(error(steel(1e30)), no_error);
  EXPECT_EQ(scene(steel(1e30)).materials.at(0).yield_stress, 400);
}

/// W = sum of 2 mu/alpha^2 (...): the moduli of powers are 2 mu/alpha, and their shear modulus the sum of mu.
TEST_F(RadiossDifferences, ViscHypWithoutViscosityIsOfWholeStretches) {
  const auto rubber = [](const std::string& orders, const std::string& lines) {
    return radioss_begin + "/MAT/LAW62/1\nrubber\n" + twenty({1e-9}) + "                 0.4" + orders + "\n" + lines +
           radioss_property + radioss_cube;
  };
  const Material two = scene(rubber("         2", twenty({3, 0.5}) + twenty({2, -4}))).materials.at(0);
  EXPECT_EQ(*two.ogden, (OgdenSettings{{3, -0.25}, {2, -4}, 0.4, true}));
  EXPECT_DOUBLE_EQ(two.shear_modulus, 3.5);
  const Material six =
      scene(rubber("         6", twenty({1, 1, 1, 1, 1}) + twenty({2}) + twenty({1, 2, 3, 4, 5}) + twenty({6})))
          .materials.at(0);
  EXPECT_EQ(six.ogden->exponents, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_DOUBLE_EQ(six.shear_modulus, 7);
  EXPECT_THAT(error(rubber("         1         1", twenty({3}) + twenty({2}) + twenty({0.5}) + twenty({1}))),
              HasSubstr("there is no viscosity"));
  EXPECT_THAT(error(rubber("         1", twenty({3}) + twenty({2}) + twenty({0.3}))),
              HasSubstr("with lines behind its exponents"));
  EXPECT_THAT(error(rubber("         1", twenty({-3}) + twenty({2}))), HasSubstr("Mu_1"));
}

TEST_F(RadiossDifferences, ABrittleMaterialErodesAsItsIdelSays) {
  const auto brittle = [](const std::string& erosion, double b = 0.31) {
    return radioss_begin + "/MAT/LAW79/1\nceramic\n" + twenty({3.7e-9}) + twenty({90160}) +
           twenty({0.93, b, 0.5, 0.6}) + twenty({0.01, 2, 0.4}) + twenty({200, 2790, 1460}) +
           "               0.005                 1.1          " + erosion + "\n" + twenty({130950, 100, 200, 0.9}) +
           radioss_property + radioss_cube;
  };
  JohnsonHolmquistSettings expected{0.93, 0.6,  0.31,  0.5, 0.4, 0.01, 2,   200,
                                    2790, 1460, 0.005, 1.1, 100, 200,  0.9, false};
  const Material lasting = scene(brittle("         0")).materials.at(0);
  EXPECT_EQ(*lasting.johnson_holmquist, expected);
  EXPECT_EQ(lasting.bulk_modulus, 130950);
  EXPECT_EQ(lasting.erosion_strain, 0);
  EXPECT_EQ(scene(brittle("         2                 1.5")).materials.at(0).erosion_strain, 1.5);
  expected.erodes = true;
  EXPECT_EQ(*scene(brittle("         3")).materials.at(0).johnson_holmquist, expected);
  EXPECT_THAT(error(brittle("         1")), HasSubstr("with IDEL 1"));
}

/// Its twelve nodes on edges and the seven that it gets; forces on a face are on the eight nodes that the deck has.
TEST_F(RadiossDifferences, BricksOfTwentyNodesAreEight) {
  const std::string bricks = "/BRIC20/1\n" + ten({"3", "1", "2", "3", "4", "5", "6", "7", "8"}) +
                             ten({"31", "32", "33", "34", "35", "36", "37", "38"}) + ten({"39", "40", "41", "42"});
  const std::string top = "/GRNOD/NODE/5\ntop\n" + ten({"5", "6", "7", "8", "39", "40", "41", "42"});
  const std::string text = radioss_begin + radioss_steel + radioss_property + "/PART/1\ncube\n" + ten({"1", "1", "0"}) +
                           of_radioss::nodes_of_edges();
  const Scene made = scene(text + bricks + top + "/FUNCT/5\nf\n" + twenty({0, 1}) + twenty({1, 1}) + "/CLOAD/1\nl\n" +
                           ten({"5", "X", "0", "0", "5"}));
  const Model<double> model = build_model<double>(made);
  EXPECT_EQ(model.element_count(), 8);
  for (const double mass : model.element_mass) EXPECT_DOUBLE_EQ(mass, 7.85e-9 / 8);
  EXPECT_EQ(made.loads.at(0).nodes.nodes.size(), 8U);
  const auto held = [&](const std::string& group) {
    return build_model<double>(scene(text + bricks + group + "/BCS/1\nb\n   111 000         0         5\n"));
  };
  EXPECT_EQ(held("/GRNOD/PART/5\nall\n" + ten({"1"})).constraints.size(), 3U * 27);
  EXPECT_EQ(held("/SURF/PART/EXT/6\nall\n" + ten({"1"}) + "/GRNOD/SURF/5\nall\n" + ten({"6"})).constraints.size(),
            3U * 27);
  const std::string apart = "/BRIC20/1\n" + ten({"3", "1", "2", "3", "4", "5", "6", "7", "8"}) +
                            ten({"31", "32", "33", "34", "39", "36", "37", "38"}) + ten({"35", "40", "41", "42"});
  EXPECT_THAT(error(text + apart), HasSubstr("middle"));
  EXPECT_THAT(error(text + bricks + bricks), HasSubstr("solid 3 is given twice"));
}

}  // namespace
}  // namespace pinball::test::radioss_differences_test

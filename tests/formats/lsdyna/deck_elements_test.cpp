#include <gmock/gmock.h>

#include <cmath>

#include <solver/model/model.hpp>

#include "deck_case.hpp"

/// Hourglass control, bulk viscosity and mass scaling of decks.
namespace pinball::test::deck_elements_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Two cubes, one on the other, with a face in common, parts 1 and 2, of which the second has *HOURGLASS 7.
const std::string two_parts = "*NODE\n" + cube_lines(1) + square_lines(9, 2) + R"(*ELEMENT_SOLID
10,1,1,2,3,4,5,6,7,8
11,2,5,6,7,8,9,10,11,12
*PART
first
1,1,1
*PART
second
2,1,1,0,7
*SECTION_SOLID
1,1
)" + elastic + ends;

class DeckElements : public DeckTest {
 protected:
  ElementSettings second(const std::string& cards) {
    const Scene s = scene(two_parts + cards);
    return s.bodies.at(1).element.value_or(s.element);
  }
};

TEST_F(DeckElements, HaveTheHourglassControlOfTheirPart) {
  const Scene s = scene(two_parts + "*HOURGLASS\n7,5,0.03\n*CONTROL_HOURGLASS\n2,0.08\n");
  EXPECT_EQ(s.element.hourglass, HourglassControl::viscous);
  EXPECT_EQ(s.element.hourglass_coefficient, 0.02);
  EXPECT_FALSE(s.bodies[0].element);
  ASSERT_TRUE(s.bodies[1].element);
  EXPECT_EQ(s.bodies[1].element->hourglass, HourglassControl::stiffness);
  EXPECT_EQ(s.bodies[1].element->hourglass_coefficient, 0.03);
  EXPECT_EQ(build_model<double>(s).parts.size(), 2U);
}

TEST_F(DeckElements, HaveTheBulkViscosityOfTheirPart) {
  const ElementSettings own = second("*HOURGLASS\n7,1,0.1,0,4.0,0.09\n");
  EXPECT_EQ(own.quadratic_viscosity, 2);
  EXPECT_EQ(own.linear_viscosity, 0.09);
  EXPECT_EQ(scene(two_parts + "*HOURGLASS\n7,1,0.1,0,4.0,0.09\n").element.linear_viscosity, 0.06);
}

TEST_F(DeckElements, HaveTheDefaultsOfControlsWhereTheyLeaveBlanks) {
  const std::string controls = "*CONTROL_HOURGLASS\n4,0.02\n*CONTROL_BULK_VISCOSITY\n1.0,0.1\n";
  EXPECT_EQ(second("*HOURGLASS\n7\n" + controls), scene(two_parts + "*HOURGLASS\n7\n" + controls).element);
  const ElementSettings form = second("*HOURGLASS\n7,5\n" + controls);
  EXPECT_EQ(form.hourglass_coefficient, 0.02);
  EXPECT_EQ(form.linear_viscosity, 0.1);
}

TEST_F(DeckElements, AreToldWhereTheirViscosityIsZero) {
  const auto told = [&](const std::string& fields) {
    return translate(cube + elastic + ends + "*CONTROL_BULK_VISCOSITY\n" + fields).understood;
  };
  EXPECT_THAT(told("0.,0.\n"), AllOf(Contains(HasSubstr("*CONTROL_BULK_VISCOSITY: Q1 of 0 (")),
                                     Contains(HasSubstr("*CONTROL_BULK_VISCOSITY: Q2 of 0 ("))));
  EXPECT_THAT(told("1.5\n"), Not(Contains(HasSubstr("of 0 ("))));
}

TEST_F(DeckElements, ThatAreAlikeShareASetting) {
  const Scene s = scene(two_parts + "*HOURGLASS\n7,1,0.1\n");
  EXPECT_FALSE(s.bodies[0].element);
  EXPECT_FALSE(s.bodies[1].element);
}

TEST_F(DeckElements, OfAssumedStrainHaveTheirCoefficient) {
  const ElementSettings own = second("*HOURGLASS\n7,6,0.7\n");
  EXPECT_EQ(own.hourglass, HourglassControl::assumed_strain);
  EXPECT_EQ(own.hourglass_coefficient, 0.7);
}

TEST_F(DeckElements, OfAnUnknownFormAreRefusedOnce) {
  EXPECT_THAT(error(two_parts + "*HOURGLASS\n7,9\n"),
              AllOf(HasSubstr("hourglass control of form 9 (IHQ) (deck.k:"), Not(HasSubstr("times"))));
  EXPECT_THAT(error(two_parts), HasSubstr("no *HOURGLASS has the number 7"));
}

TEST_F(DeckElements, OfAnotherBulkViscosityAreTold) {
  EXPECT_THAT(translate(cube + elastic + ends + "*CONTROL_BULK_VISCOSITY\n1.5,0.06,-2\n").understood,
              Contains(HasSubstr("the standard one in place of TYPE -2")));
}

const std::string one_cube = cube + elastic + ends;

TEST_F(DeckElements, GetMassForTheStep) {
  const Scene s = scene(one_cube + "*CONTROL_TIMESTEP\n0,0.8,0,0,-2.0e-7,0,0,1\n");
  EXPECT_EQ(s.time.cfl, 0.8);
  EXPECT_DOUBLE_EQ(s.time.smallest_step, 1.6e-7);
  EXPECT_EQ(s.time.mass_scaling, MassScaling::small);
  const Model<double> model = build_model<double>(s);
  ASSERT_EQ(model.added_mass.size(), 1U);
  EXPECT_GT(model.added_mass[0], 0);
  const auto none = build_model<double>(scene(one_cube + "*CONTROL_TIMESTEP\n0,0.8,0,0,-2.0e-9\n"));
  EXPECT_TRUE(none.added_mass.empty());
}

TEST_F(DeckElements, AllHaveOneStepWhereItIsPositive) {
  const Scene s = scene(one_cube + "*CONTROL_TIMESTEP\n0,0,0,0,2.0e-9\n");
  EXPECT_DOUBLE_EQ(s.time.smallest_step, 1.8e-9);
  EXPECT_EQ(s.time.mass_scaling, MassScaling::all);
  EXPECT_LT(build_model<double>(s).added_mass.at(0), 0);
}

TEST_F(DeckElements, AreToldWhenTheirMassIsAdded) {
  const std::string told = "mass is added at the start, and not again";
  EXPECT_THAT(translate(one_cube + "*CONTROL_TIMESTEP\n0,0.9,0,0,-2.0e-7\n").understood, Contains(HasSubstr(told)));
  EXPECT_THAT(translate(one_cube + "*CONTROL_TIMESTEP\n0,0.9,0,0,-2.0e-7,0,0,1\n").understood,
              Not(Contains(HasSubstr(told))));
}

TEST_F(DeckElements, OfOtherMassScalingAreRefused) {
  const auto refusal = [&](const std::string& cards) { return error(one_cube + "*CONTROL_TIMESTEP\n" + cards); };
  EXPECT_THAT(refusal("0,0.9,0,0,0,5\n"), HasSubstr("LCTM"));
  EXPECT_THAT(refusal("0,0.9,0,0,-2.0e-7\n0,0,1\n"), HasSubstr("IMSCL"));
  EXPECT_THAT(refusal("0,0.9\n0.5\n"), HasSubstr("DT2MSF"));
  EXPECT_THAT(refusal("0,0.9\n0,3\n"), HasSubstr("DT2MSLC"));
  EXPECT_EQ(refusal("0,0.9\n0,0,1\n"), "no error");
}

TEST_F(DeckElements, TellOfHourglassControlThatNoPartHas) {
  const auto lines = translate(two_parts + "*HOURGLASS\n7,5,0.03\n8,5,0.03\n").understood;
  EXPECT_THAT(lines, Contains(AllOf(HasSubstr("not used: *HOURGLASS that nothing of what is read names ("),
                                    HasSubstr("deck.k:32)"))));  // the second
  EXPECT_THAT(translate(two_parts + "*HOURGLASS\n7,5,0.03\n").understood, Not(Contains(HasSubstr("not used"))));
}

}  // namespace
}  // namespace pinball::test::deck_elements_test

#include <gmock/gmock.h>

#include "abaqus_case.hpp"

namespace pinball::test::abaqus_output_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class AbaqusOutput : public AbaqusTest {
 protected:
  static std::vector<std::string> names_of(const Scene& scene) {
    std::vector<std::string> names;
    for (const Probe& probe : scene.probes) names.push_back(probe.name);
    return names;
  }
  std::vector<std::string> probes(const std::string& output) {
    return names_of(scene(abaqus_cube + abaqus_steel + abaqus_step(output)));
  }
};

TEST_F(AbaqusOutput, OfHistoryIsAProbeOfEachNodeAndElement) {
  EXPECT_THAT(probes("*OUTPUT, HISTORY\n*NODE OUTPUT, NSET=base\nU, V\n*ELEMENT OUTPUT, ELSET=Cube\nS\n"),
              ElementsAre("node_1", "node_2", "node_3", "node_4", "element_10"));
  EXPECT_THAT(probes("*OUTPUT, HISTORY\n*NODE OUTPUT, NSET=7\nU\n*NODE OUTPUT, NSET=top\nV\n"),
              ElementsAre("node_7", "node_5", "node_6", "node_8"))
      << "each once";
}

TEST_F(AbaqusOutput, OfFieldIsIgnoredAndTold) {
  const std::string field = "*OUTPUT, FIELD\n*NODE OUTPUT, NSET=base\nU\n*ELEMENT OUTPUT, DIRECTIONS=YES\nS\n";
  EXPECT_THAT(probes(field), IsEmpty());
  EXPECT_THAT(probes("*OUTPUT, HISTORY\n" + field), IsEmpty());
  const TranslatedDeck deck = translate(abaqus_cube + abaqus_steel + abaqus_step(field));
  EXPECT_THAT(deck.ignored, ElementsAre(HasSubstr("*NODE OUTPUT ("), HasSubstr("*ELEMENT OUTPUT (")));
}

TEST_F(AbaqusOutput, NamesTellInstancesApart) {
  const auto two = [this](const std::string& first, const std::string& second) {
    return names_of(scene("*PART, NAME=c\n" + abaqus_cube + "*END PART\n*ASSEMBLY\n*INSTANCE, NAME=" + first +
                          ", PART=c\n*END INSTANCE\n*INSTANCE, NAME=" + second +
                          ", PART=c\n5., 0., 0.\n*END INSTANCE\n*NSET, NSET=w\n" + first + ".7, " + second +
                          ".7\n*END ASSEMBLY\n" + abaqus_steel +
                          abaqus_step("*OUTPUT, HISTORY\n*NODE OUTPUT, NSET=w\nU\n")));
  };
  EXPECT_THAT(two("Low", "High"), ElementsAre("node_Low_7", "node_High_7"));
  EXPECT_THAT(two("\"a b\"", "a_b"), ElementsAre("node_a_b_7", "node_a_b_7_"));
}

TEST_F(AbaqusOutput, OfWhatIsNotThereIsToldWithItsPlace) {
  const auto message = [this](const std::string& output) {
    return error(abaqus_cube + abaqus_steel + abaqus_step("*OUTPUT, HISTORY\n" + output));
  };
  EXPECT_THAT(message("*NODE OUTPUT, NSET=none\nU\n"), HasSubstr("deck.inp:27: there is no set of nodes none"));
  EXPECT_THAT(message("*ELEMENT OUTPUT, ELSET=11\nS\n"), HasSubstr("deck.inp:27: element 11 is not there"));
  const TranslatedDeck deck = translate(abaqus_cube + "*NODE, NSET=tip\n99, 0., 0., 9.\n" + abaqus_steel +
                                        abaqus_step("*OUTPUT, HISTORY\n*NODE OUTPUT, NSET=tip\nU\n"));
  EXPECT_THAT(deck.ignored,
              ElementsAre(AllOf(HasSubstr("*NODE OUTPUT of a node of no solid ("), HasSubstr("deck.inp:29"))));
}

}  // namespace
}  // namespace pinball::test::abaqus_output_test

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/support/tied_case.hpp>

/// What is told of nodes that a start moves: their bodies have other masses then.
namespace pinball::test::moved_nodes_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> warnings_of(const Scene& scene) { return build_model<double>(scene).mesh.warnings; }

TEST(MovedNodes, OfTiesAreToldWithTheMassesThatTheyChange) {
  EXPECT_THAT(warnings_of(glued(3, 2, 2e-4)), IsEmpty());
  EXPECT_THAT(warnings_of(glued(3, 2, 2e-4, 1e-4)), IsEmpty()) << "a thousandth of an element";
  Scene scene = glued(3, 2, 2e-4, 0.1);
  scene.tied_contacts[0].tolerance = 0.11;
  EXPECT_THAT(warnings_of(scene),
              ElementsAre(AllOf(HasSubstr("contact.tied has moved 16 nodes before the start, node"),
                                HasSubstr("by 0.1 the furthest, which changes the mass of body high by +16.7 %"),
                                Not(HasSubstr("low")))));
  scene.tied_contacts[0].start = 1e-4;
  EXPECT_THAT(warnings_of(scene), IsEmpty()) << "they stay where they are";
}

TEST(MovedNodes, OfOverlapsAreToldWithTheMassesThatTheyChange) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 1, {0, 0, 0}), block("b", {2, 2, 2}, 1, {0, 0, 1.8})}, 1);
  EXPECT_THAT(warnings_of(scene), IsEmpty());
  scene.contact.overlap = ContactOverlap::adjust;
  EXPECT_THAT(warnings_of(scene),
              ElementsAre(AllOf(HasSubstr("contact.overlap = \"adjust\" has moved 18 nodes before the start"),
                                HasSubstr("by 0.1 the furthest, which changes the mass of body a by -5 %, of body b "
                                          "by -5 %"))));
  scene.bodies[1].position[2] = 2;
  EXPECT_THAT(warnings_of(scene), IsEmpty()) << "none has moved";
  scene.bodies[1].position[2] = 1.8;
  scene.contact.method = ContactMethod::none;
  EXPECT_THAT(warnings_of(scene), IsEmpty()) << "there is no contact";
}

}  // namespace
}  // namespace pinball::test::moved_nodes_test

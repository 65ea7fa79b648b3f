#include <gmock/gmock.h>

#include <cmath>
#include <memory>

#include <solver/formats/lsdyna/mesh/keyword_transformation.hpp>
#include <tests/support/error_of.hpp>

/// Cards of *DEFINE_TRANSFORMATION, by what they leave where it is and where they take other points: every field.
namespace pinball::test::keyword_transformation_test {
namespace {

using testing::HasSubstr;

Transformation transformation_of(const std::string& cards) {
  const KeywordDeck deck = parse_keyword_deck("*KEYWORD\n*DEFINE_TRANSFORMATION\n4\n" + cards + "*END\n", "a.k");
  DeckTransform transform;
  transform.transformation = 4;
  KeywordBlock block;
  block.transform = std::make_shared<const DeckTransform>(transform);
  return *Transformations(deck).of(block);
}

void expect_moved(const Transformation& t, const Point& from, const Point& to) {
  const Point moved = t.apply(from);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(moved[k], to[k], 1e-12) << "component " << k;
}

Point along(const Point& from, const Point& direction, double length) {
  return {from[0] + length * direction[0], from[1] + length * direction[1], from[2] + length * direction[2]};
}

TEST(KeywordTransformation, MovesAndScalesEachComponent) {
  expect_moved(transformation_of("TRANSL,2,3,5\n"), {10, 20, 40}, {12, 23, 45});
  expect_moved(transformation_of("SCALE,2,3,5\n"), {10, 20, 40}, {20, 60, 200});
  expect_moved(transformation_of("SCALE,2,0,5\n"), {10, 20, 40}, {20, 20, 200});
}

/// The axis stays where it is; what is beside it goes round by the right hand.
TEST(KeywordTransformation, TurnsAboutAnyAxisThroughAnyPoint) {
  const Point axis{2.0 / 7, 3.0 / 7, 6.0 / 7}, through{5, -4, 3};
  const Point aside{3 / std::sqrt(13.0), -2 / std::sqrt(13.0), 0}, third = cross(axis, aside);
  for (const double degrees : {90.0, 30.0, -120.0}) {
    const Transformation t = transformation_of("ROTATE,2,3,6,5,-4,3," + std::to_string(degrees) + "\n");
    const double angle = degrees * M_PI / 180;
    expect_moved(t, through, through);
    expect_moved(t, along(through, axis, 11), along(through, axis, 11));
    const Point turned = along(along(through, aside, 2 * std::cos(angle)), third, 2 * std::sin(angle));
    expect_moved(t, along(through, aside, 2), turned);
    EXPECT_NEAR(t.determinant(), 1, 1e-12);
  }
  for (const char* nodes : {"ROTATE,7,8,9,0,0,0,0\n", "ROTATE,1,8,9\n", "ROTATE,1,0,9\n"}) {
    EXPECT_THAT(error_of([&] { transformation_of(nodes); }), HasSubstr("ROTATE about two nodes or points is not read"));
  }
  expect_moved(transformation_of("ROTATE,0,8,9,0,0,0,0\n"), {1, 2, 3}, {1, 2, 3});  // by an angle of nothing
  EXPECT_THAT(error_of([] { transformation_of("ROTATE,0,0,0,1,2,3,90\n"); }), HasSubstr("a vector of no length"));
}

TEST(KeywordTransformation, MirrorsAtAnyPlane) {
  const Point tail{5, -4, 3}, normal{2.0 / 7, 3.0 / 7, 6.0 / 7}, aside{3, -2, 0};
  const Transformation t = transformation_of("MIRROR,5,-4,3,7,-1,9\n");
  expect_moved(t, tail, tail);
  expect_moved(t, along(tail, aside, 4), along(tail, aside, 4));
  expect_moved(t, along(tail, normal, 2), along(tail, normal, -2));
  EXPECT_NEAR(t.determinant(), -1, 1e-12);
}

TEST(KeywordTransformation, CardsActInTheirOrder) {
  const Transformation t = transformation_of("SCALE,2,2,2\nROTATE,0,0,1,0,0,0,90\nTRANSL,10,0,0\n");
  expect_moved(t, {1, 2, 3}, {6, 2, 6});
  EXPECT_THAT(error_of([] { transformation_of("POINT,1,2,3\n"); }),
              HasSubstr("expected TRANSL, SCALE, ROTATE or MIRROR"));
}

}  // namespace
}  // namespace pinball::test::keyword_transformation_test

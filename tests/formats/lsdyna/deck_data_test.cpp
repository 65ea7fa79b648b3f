#include <gmock/gmock.h>

#include <solver/formats/lsdyna/cards/deck_data.hpp>
#include <solver/formats/lsdyna/mesh/keyword_mesh.hpp>

#include "deck_case.hpp"

/// What keywords of a deck refer to by number: every field of a card, and of each list its first and last member.
namespace pinball::test::deck_data_test {
namespace {

using testing::ElementsAre;

const DeckPlace here{std::make_shared<const std::string>("a.k"), 1};

/// The data of a deck, with what they are kept of.
class Data {
 public:
  explicit Data(const std::string& cards)
      : deck_(parse_keyword_deck("*KEYWORD\n" + cube + elastic + ends + cards + "*END\n", "a.k")),
        mesh_(keyword_mesh(deck_)),
        data_(deck_, mesh_, report_) {}
  const DeckData* operator->() const { return &data_; }

 private:
  KeywordDeck deck_;
  MeshFile mesh_;
  DeckReport report_;
  DeckData data_;
};

void expect_point(const Point& found, const Point& expected) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(found[k], expected[k]) << "component " << k;
}

TEST(DeckData, VectorsHaveTheirDirectionsInSpace) {
  const Data data("*DEFINE_VECTOR\n5,1,2,3,3,5,9\n*DEFINE_VECTOR\n6,4,0,0,-1,0,0\n7,0,0,0,0,-2,0\n");
  expect_point(data->vector(5, here), {2.0 / 7, 3.0 / 7, 6.0 / 7});
  expect_point(data->vector(6, here), {-1, 0, 0});
  expect_point(data->vector(7, here), {0, -1, 0});
}

TEST(DeckData, LocalSystemsHaveTheirAxesInSpace) {
  // e1 along (2, 3, 6) / 7, and a vector of their plane.
  const Data data(
      "*DEFINE_COORDINATE_VECTOR\n5,2,3,6,1,1,0\n*DEFINE_COORDINATE_SYSTEM\n6,10,20,30,12,23,36\n11,21,30\n"
      "*DEFINE_COORDINATE_VECTOR\n7,0,-4,0,3,5,0\n");
  const Point e1{2.0 / 7, 3.0 / 7, 6.0 / 7};
  Point e3 = cross(e1, {1, 1, 0});
  const double length = norm(e3);
  for (double& component : e3) component /= length;
  for (const std::int64_t system : {5, 6}) {
    const std::array<Point, 3> axes = data->axes(system, here);
    expect_point(axes[0], e1);
    expect_point(axes[1], cross(e3, e1));
    expect_point(axes[2], e3);
  }
  expect_point(data->axes(7, here)[0], {0, -1, 0});
  expect_point(data->axes(7, here)[1], {1, 0, 0});
  expect_point(data->axes(7, here)[2], {0, 0, 1});
  expect_point(data->axes(0, here)[0], {1, 0, 0});
}

TEST(DeckData, BoxesHaveTheirBoundsInTheOrderOfTheCard) {
  const Data data("*DEFINE_BOX\n5,1,2,3,4,5,6\n");
  const KeywordBox& box = data->boxes.find(data->deck.blocks.at(0), 5, here);
  expect_point(box.low, {1, 3, 5});
  expect_point(box.high, {2, 4, 6});
}

TEST(DeckData, SetsOfPartsHaveAllEightPlacesOfACard) {
  const Data data(
      "*SET_PART_LIST\n5\n11,12,13,14,15,16,17,18\n19\n*SET_PART_LIST\n6\n0,21\n*SET_PART_ADD\n7\n6,5\n"
      "*SET_PART_LIST_GENERATE\n8\n1,1\n");
  EXPECT_THAT(data->part_set(5, here), ElementsAre(11, 12, 13, 14, 15, 16, 17, 18, 19));
  EXPECT_THAT(data->part_set(6, here), ElementsAre(21));
  EXPECT_THAT(data->part_set(7, here), ElementsAre(21, 11, 12, 13, 14, 15, 16, 17, 18, 19));
  EXPECT_THAT(data->part_set(8, here), ElementsAre(1));
}

TEST(DeckData, CurvesAndTablesHaveTheirNumbers) {
  const Data data(
      "*DEFINE_CURVE\n5,0,2.,3.,10.,20.\n1.,4.\n2.,5.\n*DEFINE_TABLE\n6\n0.5,5\n7.,8\n*DEFINE_CURVE\n8\n0.,1.\n"
      "1.,2.\n");
  EXPECT_THAT(data->curve(5, here).abscissa, ElementsAre(22, 24)) << "2 (1 + 10)";
  EXPECT_THAT(data->curve(5, here).ordinate, ElementsAre(72, 75)) << "3 (4 + 20)";
  ASSERT_NE(data->table(6), nullptr);
  EXPECT_THAT(data->table(6)->curves, ElementsAre(std::pair(0.5, 5), std::pair(7.0, 8)));
  EXPECT_EQ(data->table(5), nullptr);
}

TEST(DeckData, SectionsHourglassControlsAndPartsHaveTheirNumbers) {
  const Data data("*SECTION_SOLID\n5,-1\n*HOURGLASS\n6,4,0.07,,1.3,0.04\n*PART\nof nothing\n7,5,9,0,6\n");
  EXPECT_EQ(data->section_form.at(5), -1);
  const DeckHourglass& hourglass = data->hourglass.at(6);
  EXPECT_EQ(hourglass.form, 4);
  EXPECT_EQ(hourglass.coefficient, 0.07);
  EXPECT_EQ(hourglass.quadratic, 1.3);
  EXPECT_EQ(hourglass.linear, 0.04);
  ASSERT_EQ(data->parts.size(), 1U);
  EXPECT_EQ(data->parts[0].id, 1);
  EXPECT_EQ(data->parts[0].body, "cube");
  EXPECT_TRUE(data->is_used(1));
  EXPECT_FALSE(data->is_used(9));
  EXPECT_EQ(data->body_of(1, here), "cube");
  EXPECT_EQ(data->body_of(7, here), std::nullopt) << "a part without solids";
  for (const std::int64_t none : {5, 6, 9}) EXPECT_THROW(data->body_of(none, here), InputError) << none;
}

}  // namespace
}  // namespace pinball::test::deck_data_test

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <solver/base/error.hpp>
#include <solver/mesh/element_types.hpp>
#include <solver/output/field_output.hpp>
#include <solver/output/page/surface/field_frame.hpp>
#include <solver/output/run_files.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/output_case.hpp>

/// Fields that several ranks have written, each its piece, beside those of one file.
namespace pinball::test::field_pieces_test {
namespace {

using testing::HasSubstr;

/// Two blocks and a tetrahedron on the nodes of the first.
FieldSnapshot blocks_and_tetrahedron() {
  FieldSnapshot s = two_blocks(2e-5, 0.125);
  const std::array<std::int32_t, 4> corners{0, 1, 5, 15};
  s.hexahedra.insert(s.hexahedra.begin() + 3, corners_of_cell(corners));
  s.stress.insert(s.stress.begin() + 3, {-1, -2, -3, -4, -5, -6});
  s.plastic_strain.insert(s.plastic_strain.begin() + 3, 0.75);
  s.pinball_radius.insert(s.pinball_radius.begin() + 3, 0.125);
  s.alive.insert(s.alive.begin() + 3, std::uint8_t{1});
  s.body.insert(s.body.begin() + 3, 0);
  return s;
}

class FieldPieces : public testing::Test {
 protected:
  FieldPieces() : whole_("whole_fields"), pieces_("pieces_of_fields") {
    base_.initial = initial_;
    for (std::int64_t n = 0; n < std::ssize(all_.position); ++n) base_.node_number.push_back(1000 - n);
    // Of four ranks, one of which has no elements.
    for (std::size_t e = 0; e < all_.hexahedra.size(); ++e) rank_.push_back(e % 4 == 1 ? 0 : static_cast<int>(e % 4));
    FieldWriter(whole_.path.string(), "fields", {}, "in-lbf-s", {}, {"a", "b"}, base_).write(all_);
    write_pieces();
  }

  void write_pieces(const FieldWriter::Written& kept = {}) {
    FieldWriter writer(pieces_.path.string(), "fields", {}, "in-lbf-s", kept, {"a", "b"});
    for (const int rank : {0, 2, 3}) {
      write_vtu(pieces_ / piece_name("fields", writer.next_number(), rank), piece(rank).snapshot, {}, "in-lbf-s",
                {"a", "b"}, piece(rank).base);
    }
    writer.list_pieces(piece(2), {0, 2, 3});
    written_ = writer.written();
  }
  const FieldPiece& piece(int rank) {
    static std::vector<FieldPiece> made(4);
    made[rank] = cut_piece(all_, base_, rank_, rank);
    return made[rank];
  }

  FieldSnapshot all_ = blocks_and_tetrahedron();
  std::vector<Point> initial_{all_.position.size(), Point{0.5, 0.25, 0.125}};
  FieldBase base_;
  std::vector<std::int32_t> rank_;
  TemporaryFolder whole_, pieces_;
  FieldWriter::Written written_;
};

TEST_F(FieldPieces, HaveTheArraysOfOneFile) {
  const FieldFrame whole = FieldFrame::of_file(whole_ / "fields_0000.vtu"),
                   joined = FieldFrame::of_file(pieces_ / "fields_0000.pvtu");
  ASSERT_EQ(joined.arrays().size(), whole.arrays().size());
  for (std::size_t a = 0; a < whole.arrays().size(); ++a) {
    const FieldFrame::Array &one = whole.arrays()[a], &other = joined.arrays()[a];
    EXPECT_EQ(other.name, one.name);
    EXPECT_EQ(other.section, one.section);
    EXPECT_EQ(other.components, one.components);
    std::vector<char> expected(one.bytes), found(other.bytes);
    one.read(expected.data());
    other.read(found.data());
    EXPECT_EQ(found, expected) << one.name;
  }
  EXPECT_GT(whole.arrays().size(), 12U);
}

TEST_F(FieldPieces, AreListedWithTheirTime) {
  EXPECT_EQ(written_, (FieldWriter::Written{{2e-5, "fields_0000.pvtu"}}));
  std::ifstream list(pieces_ / "fields.pvd");
  const std::string text(std::istreambuf_iterator<char>(list), {});
  EXPECT_THAT(text, HasSubstr("timestep=\"2.0000000000000002e-05\" group=\"\" part=\"0\" file=\"fields_0000.pvtu\""));
}

TEST_F(FieldPieces, GoWithTheNextRunAndStayWithOneThatGoesOn) {
  const auto names = [&] {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(pieces_.path))
      found.push_back(entry.path().filename().string());
    return found;
  };
  for (const std::string& name : names()) EXPECT_TRUE(is_run_file(name)) << name;
  write_pieces(written_);
  EXPECT_THAT(names(), testing::UnorderedElementsAre("fields.pvd", "fields_0000.pvtu", "fields_0000_0.vtu",
                                                     "fields_0000_2.vtu", "fields_0000_3.vtu", "fields_0001.pvtu",
                                                     "fields_0001_0.vtu", "fields_0001_2.vtu", "fields_0001_3.vtu"));
  FieldWriter(pieces_.path.string(), "fields", {}, "", {written_.front()});
  EXPECT_EQ(names().size(), 5U);
  FieldWriter(pieces_.path.string(), "fields");
  EXPECT_TRUE(names().empty());
}

TEST_F(FieldPieces, ThatAreNotThereAreNamed) {
  const auto read = [&] { FieldFrame::of_file(pieces_ / "fields_0000.pvtu"); };
  std::filesystem::remove(pieces_.path / "fields_0000_2.vtu");
  EXPECT_THAT(error_of<RunError>(read), HasSubstr("fields_0000_2.vtu"));
}

}  // namespace
}  // namespace pinball::test::field_pieces_test

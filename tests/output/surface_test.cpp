#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <solver/base/error.hpp>
#include <solver/output/field_output.hpp>
#include <solver/output/page/surface/outer_faces.hpp>
#include <solver/output/page/surface/packing.hpp>
#include <solver/output/page/surface/surface_block.hpp>
#include <tests/support/output_case.hpp>

namespace pinball::surface_test {
namespace {

using Hexahedra = std::vector<std::array<std::int32_t, 8>>;

/// n x n x n elements of a cube, x the fastest; element (i, j, k) is number i + n (j + n k).
Hexahedra cube(int n) {
  Hexahedra elements;
  const auto node = [n](int i, int j, int k) { return i + (n + 1) * (j + (n + 1) * k); };
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        elements.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
                            node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                            node(i, j + 1, k + 1)});
      }
    }
  }
  return elements;
}

Point place_in_cube(int n, std::int32_t node) {
  const int row = n + 1;
  return {1.0 * (node % row), 1.0 * (node / row % row), 1.0 * (node / row / row)};
}

std::size_t seen_at(const std::vector<OuterFace>& faces, std::int32_t frame) {
  return std::ranges::count_if(faces, [frame](const OuterFace& f) { return f.from <= frame && frame < f.until; });
}

TEST(Surface, OfACubeIsItsFacesWithNormalsOutward) {
  const std::vector<std::int32_t> body(27, 0), ends(27, 2);
  const std::vector<OuterFace> faces = outer_faces(cube(3), body, ends);
  ASSERT_EQ(faces.size(), 6U * 9U);
  for (const OuterFace& face : faces) {
    EXPECT_EQ(face.from, 0);
    EXPECT_EQ(face.until, 2);
    std::array<Point, 4> x{};
    for (std::size_t c = 0; c < 4; ++c) x[c] = place_in_cube(3, face.corners[c]);
    double outward = 0;  // area vector times the place of the face from the middle
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const double area = (x[2][j] - x[0][j]) * (x[3][k] - x[1][k]) - (x[2][k] - x[0][k]) * (x[3][j] - x[1][j]);
      outward += area * (0.25 * (x[0][i] + x[1][i] + x[2][i] + x[3][i]) - 1.5);
    }
    EXPECT_DOUBLE_EQ(outward, 2 * 1.5);
  }
}

TEST(Surface, OpensWhereElementsAreEroded) {
  const std::vector<std::int32_t> body(27, 0);
  std::vector<std::int32_t> ends(27, 4);
  ends[13] = 1;  // the middle: its six neighbours are seen from inside, itself never was
  ends[0] = 2;   // a corner: three faces go, three come
  const std::vector<OuterFace> faces = outer_faces(cube(3), body, ends);
  EXPECT_EQ(seen_at(faces, 0), 54U);
  EXPECT_EQ(seen_at(faces, 1), 54U + 6U);
  EXPECT_EQ(seen_at(faces, 2), 54U + 6U);
  EXPECT_EQ(seen_at(faces, 3), 54U + 6U);
  EXPECT_EQ(std::ranges::count(faces, 0, &OuterFace::element), 3);
  EXPECT_EQ(std::ranges::count(faces, 13, &OuterFace::element), 0);
  EXPECT_EQ(std::ranges::count(faces, 2, &OuterFace::from), 3);
  for (const OuterFace& face : faces) {
    if (face.from == 2) {
      EXPECT_THAT(face.element, testing::AnyOf(1, 3, 9));
    }
  }
}

TEST(Surface, OfElementsThatAreErodedTogetherIsNeverSeenBetweenThem) {
  const std::vector<OuterFace> faces = outer_faces(cube(2), std::vector<std::int32_t>(8, 0), {1, 1, 3, 3, 3, 3, 3, 3});
  for (const OuterFace& face : faces) {
    EXPECT_LT(face.from, face.until);
    if (face.element < 2) {
      EXPECT_EQ(face.until, 1);
    }
  }
  EXPECT_EQ(seen_at(faces, 0), 24U);
  EXPECT_EQ(seen_at(faces, 1), 24U - 6U + 4U) << "six of the two elements go, two behind and two above come";
}

TEST(Surface, OfBodiesThatShareNodesIsWholeForEach) {
  const Hexahedra elements = cube(2);
  std::vector<std::int32_t> body(8, 0);
  std::fill(body.begin() + 4, body.end(), 1);  // the upper half
  EXPECT_EQ(outer_faces(elements, body, std::vector<std::int32_t>(8, 1)).size(), 24U + 2U * 4U);
}

/// What viewer_data.js does.
std::vector<std::int64_t> integers_of(const std::string& bytes, std::size_t count) {
  std::vector<std::int64_t> numbers;
  std::int64_t last = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t code = 0;
    for (std::size_t k = 6; k-- > 0;) code = code << 8 | static_cast<unsigned char>(bytes[k * count + i]);
    last += code % 2 == 0 ? static_cast<std::int64_t>(code / 2) : -static_cast<std::int64_t>((code + 1) / 2);
    numbers.push_back(last);
  }
  return numbers;
}

TEST(Packing, OfIntegersIsExactUpTo46Bits) {
  constexpr std::int64_t most = (std::int64_t{1} << 46) - 1;
  const std::vector<std::int64_t> numbers{
      0, 5, -1, most, -most, -most - 1, 17, most + 1, std::numeric_limits<std::int64_t>::min()};
  std::string bytes;
  pack_integers(bytes, numbers);
  std::vector<std::int64_t> expected = numbers;
  expected[7] = expected[8] = -1;  // are none
  EXPECT_EQ(integers_of(bytes, numbers.size()), expected);
}

TEST(Packing, OfCodesIsExact) {
  const std::vector<std::uint16_t> first{0, 65535, 1, 32768, 7, 7, 40000}, second{65535, 0, 1, 32767, 9, 65000, 0};
  std::string bytes;
  pack_codes(bytes, first, {});
  pack_codes(bytes, second, first);
  const std::size_t count = first.size();
  std::vector<std::uint16_t> before(count, 0);
  for (std::size_t t = 0; t < 2; ++t) {
    std::uint16_t since = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const unsigned low = static_cast<unsigned char>(bytes[2 * t * count + i]);
      const unsigned code = low | static_cast<unsigned>(static_cast<unsigned char>(bytes[(2 * t + 1) * count + i]))
                                      << 8U;
      const int difference = static_cast<int>(code >> 1U) ^ -static_cast<int>(code & 1U);
      since = static_cast<std::uint16_t>(since + difference);
      before[i] = static_cast<std::uint16_t>(before[i] + since);
    }
    EXPECT_EQ(before, t == 0 ? first : second);
  }
}

TEST(Packing, WritesBase64AsRfc4648HasIt) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob\xff\xfe"), "Zm9vYv/+");
}

TEST(Surface, HasEvenlySpacedTimesWithBothEnds) {
  using testing::ElementsAre;
  EXPECT_THAT(evenly_spaced(5, 9), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(evenly_spaced(5, 3), ElementsAre(0, 2, 4));
  EXPECT_THAT(evenly_spaced(100, 2), ElementsAre(0, 99));
  EXPECT_THAT(evenly_spaced(100, 1), ElementsAre(99));
  EXPECT_THAT(evenly_spaced(1, 1), ElementsAre(0));
}

/// The same numbers by their names, whether they went through a file or not.
TEST(FieldFrame, HasInAFileWhatItHasInMemory) {
  const test::TemporaryFolder folder("frame");
  const FieldSnapshot s = test::two_blocks(2.5e-5, 0.01);
  FieldBase base;
  base.initial = s.position;
  base.node_number.assign(s.position.size(), 7);
  write_vtu(folder / "a.vtu", s, {}, "in-lbf-s", {"a", "b"}, base);
  const FieldFrame memory = FieldFrame::of_snapshot(s, base), file = FieldFrame::of_file(folder / "a.vtu");
  EXPECT_GT(memory.arrays().size(), 10U);
  for (const FieldFrame::Array& array : memory.arrays()) {
    const auto same = std::ranges::find(file.arrays(), array.name, &FieldFrame::Array::name);
    ASSERT_NE(same, file.arrays().end()) << array.name;
    EXPECT_EQ(same->section, array.section);
    EXPECT_EQ(same->type, array.type);
    EXPECT_EQ(same->components, array.components);
    ASSERT_EQ(same->bytes, array.bytes);
    std::string one(array.bytes, '\0'), other(array.bytes, '\0');
    array.read(one.data());
    same->read(other.data());
    EXPECT_EQ(one, other) << array.name;
  }
  EXPECT_EQ(file.read<std::int64_t>("node_number").front(), 7);
  EXPECT_THROW(file.read<float>("node_number"), RunError);
  EXPECT_THROW(file.read<float>("nothing"), RunError);
}

class SurfaceOfRun : public testing::Test {
 protected:
  SurfaceOfRun() {
    FieldWriter writer(folder_.path.string(), "fields", {}, "in-lbf-s", {}, {"a", "b"});
    for (int k = 0; k < 9; ++k) writer.write(test::two_blocks(1e-6 * k, 0.01 * k));
  }
  nlohmann::json json(std::size_t most = most_surface_characters) const {
    return nlohmann::json::parse(
        surface_json(gather_surface(frames_of_folder(folder_.path.string()), 1'000'000), {"a", "b"}, most));
  }
  test::TemporaryFolder folder_{"surface"};
};

TEST_F(SurfaceOfRun, HasEveryTimeAndFieldAndTheSameBytesEachTime) {
  const nlohmann::json surface = json();
  EXPECT_EQ(surface["times"].size(), 9U);
  EXPECT_EQ(surface["all_times"], 9);
  std::vector<std::string> names;
  for (const auto& field : surface["fields"]) names.push_back(field["name"]);
  for (const char* name :
       {"velocity", "contact_force", "von_mises", "pressure", "plastic_strain", "pinball_radius", "corner_share"}) {
    EXPECT_THAT(names, testing::Contains(name));
  }
  EXPECT_THAT(names, testing::Not(testing::Contains("stress")));
  EXPECT_EQ(surface.dump(), json().dump());
}

/// Positions are told in 65,000 parts of the largest extents that what is left of each body has at any time.
TEST_F(SurfaceOfRun, HasPositionsAsFineAsTheBodiesAreLarge) {
  std::vector<Point> extents(2, Point{});
  for (int k = 0; k < 9; ++k) {
    const FieldSnapshot s = test::two_blocks(1e-6 * k, 0.01 * k);
    for (int body = 0; body < 2; ++body) {
      for (std::size_t c = 0; c < 3; ++c) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (std::size_t e = 0; e < s.hexahedra.size(); ++e) {
          if (s.body[e] != body || s.alive[e] == 0) continue;
          for (const std::int32_t n : s.hexahedra[e]) {
            low = std::min(low, s.position[n][c]);
            high = std::max(high, s.position[n][c]);
          }
        }
        extents[body][c] = std::max(extents[body][c], high - low);
      }
    }
  }
  const nlohmann::json steps = json()["steps"];
  ASSERT_EQ(steps.size(), 2U);
  for (std::size_t b = 0; b < 2; ++b) {
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(steps[b][c].get<double>(), extents[b][c] / 65000, 1e-6 * extents[b][c] / 65000) << b << ", " << c;
  }
}

TEST_F(SurfaceOfRun, HasFewerTimesWhereAPageHasNoRoomForAll) {
  const std::size_t whole = json().dump().size();
  const nlohmann::json fewer = json(whole - 100);
  EXPECT_LT(fewer["times"].size(), 9U);
  EXPECT_GE(fewer["times"].size(), 2U);
  EXPECT_EQ(fewer["times"].front(), 0.0);
  EXPECT_EQ(fewer["times"].back(), 8e-6);
  EXPECT_EQ(fewer["all_times"], 9);
  EXPECT_TRUE(json(10).is_null());
}

TEST_F(SurfaceOfRun, SaysWhyThereIsNone) {
  const auto of = [&] {
    return nlohmann::json::parse(surface_json_of_run(folder_.path.string(), {"a", "b"}, nullptr, nullptr));
  };
  EXPECT_FALSE(of().contains("error"));
  const std::uintmax_t whole = std::filesystem::file_size(folder_.path / "fields_0004.vtu");
  for (const std::uintmax_t left : {whole - 60, whole - 200, whole / 2, std::uintmax_t{5000}}) {
    std::filesystem::resize_file(folder_.path / "fields_0004.vtu", left);
    EXPECT_THAT(of()["error"].get<std::string>(), testing::HasSubstr("fields_0004.vtu")) << left << " of " << whole;
  }
  std::filesystem::remove(folder_.path / "fields.pvd");
  EXPECT_TRUE(of().is_null());
}

/// A run that has written no fields shows its first and its last state.
TEST(Surface, OfALastStateBeginsWithTheFirst) {
  const FieldSnapshot last = test::two_blocks(2.5e-5, 0.01), first = test::two_blocks(0, 0);
  FieldBase base;
  base.initial = first.position;
  const test::TemporaryFolder folder("no_fields");
  const auto times = [&](const FieldSnapshot& of, const FieldBase& beside) -> nlohmann::json {
    return nlohmann::json::parse(surface_json_of_run(folder.path.string(), {"a", "b"}, &of, &beside))["times"];
  };
  EXPECT_THAT(times(last, base), testing::ElementsAre(0.0, 2.5e-5));
  EXPECT_THAT(times(last, {}), testing::ElementsAre(2.5e-5)) << "nothing is known of the first";
  EXPECT_THAT(times(first, base), testing::ElementsAre(0.0)) << "it is the first";
}

}  // namespace
}  // namespace pinball::surface_test

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "other_history_case.hpp"

namespace pinball::test::binary_histories_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using BinaryHistories = OtherHistories;

/// A T01 file: records of big-endian words, which begin and end with their length in bytes.
class T01 {
 public:
  template <class... Words>
  T01& record(const Words&... words) {
    const std::string own = (word(words) + ...);
    bytes += word(static_cast<std::int32_t>(own.size())) + own + word(static_cast<std::int32_t>(own.size()));
    return *this;
  }

  std::string bytes;

 private:
  static std::string word(std::uint32_t value) {
    std::string text;
    for (unsigned shift = 32; shift > 0; shift -= 8) text += static_cast<char>(value >> (shift - 8) & 0xFFU);
    return text;
  }
  static std::string word(std::int32_t value) { return word(static_cast<std::uint32_t>(value)); }
  static std::string word(float value) { return word(std::bit_cast<std::uint32_t>(value)); }
  static std::string word(const std::string& text) { return text; }
};

/// Of two parts, a subset, and two nodes of a group, behind a group of something else.
T01 t01_head(std::int32_t code, std::size_t title) {
  const std::string name(title, ' '), line(80, ' ');
  T01 file;
  file.record(code, line).record(line);
  if (code > 3050) file.record(2).record(100).record(1.0F, 1.0F, 1.0F);
  file.record(2, 1, 1, 1, 2, 4).record(1, 2, 8, 3);                               // counts; global quantities
  file.record(1, name, 0, 1, 1, 0).record(2, name, 0, 1, 1, 2).record(1, 2);      // parts
  file.record(1, name).record(1, name).record(0, 0, 0, 2, 0, name).record(1, 2);  // material, property, subset
  file.record(4, 6, 0, 1, 1, name).record(30, name).record(65);                   // a spring
  return file.record(2, 0, 0, 2, 3, name).record(5, name).record(6, name).record(1, 6, 9);
}
void add_state(T01& file, float t) {
  file.record(t).record(3 * t, 2 * t, t, 5.0F).record(7.0F, 8.0F).record(9.0F);
  file.record(t, 2 * t, 3 * t, 10 * t, 20 * t, 30 * t);
}

TEST_F(BinaryHistories, AT01HasEnergiesAndNodes) {
  for (const auto& [code, title] : {std::pair<std::int32_t, std::size_t>{3040, 40}, {3041, 80}, {4021, 100}}) {
    T01 file = t01_head(code, title);
    for (const float t : {0.0F, 0.5F, 1.0F}) add_state(file, t);
    const OtherHistory read_back = read(file.bytes);
    EXPECT_EQ(read_back.kind, "T01 of Radioss");
    EXPECT_THAT(read_back.times, ElementsAre(0, 0.5, 1)) << code;
    EXPECT_THAT(curve(read_back, "INTERNAL ENERGY").values, ElementsAre(0, 1.5, 3));
    EXPECT_THAT(curve(read_back, "KINETIC ENERGY").values, ElementsAre(0, 1.5, 3));  // with that of rotations
    EXPECT_THAT(curve(read_back, "X-MOMENTUM").values, ElementsAre(5, 5, 5));
    EXPECT_THAT(curve(read_back, "node_5_displacement_x").values, ElementsAre(0, 0.5, 1));
    EXPECT_THAT(curve(read_back, "node_6_velocity_z").values, ElementsAre(0, 10, 20));
    EXPECT_EQ(read_back.curves.size(), 7U);  // no accelerations
    const std::string whole = file.bytes;
    for (std::size_t cut = 1; cut < 40; ++cut)
      EXPECT_THAT(read(whole.substr(0, whole.size() - cut)).times, ElementsAre(0, 0.5)) << cut;
  }
}

TEST_F(BinaryHistories, AT01ThatIsWrongIsNamedWithItsByte) {
  T01 file = t01_head(4021, 100);
  EXPECT_THAT(problem(file.bytes), HasSubstr("expected two times at least, got 0"));
  EXPECT_THAT(problem(file.bytes.substr(0, 300)), HasSubstr("byte 280: expected a part"));
  std::string many = file.bytes;
  many[file.bytes.find(std::string("\0\0\0\x18", 4)) + 4] = '\x7F';  // a count of parts
  EXPECT_THAT(problem(many), HasSubstr("expected a count"));
  add_state(file, 0.0F);
  file.record(1.0F).record(1.0F);
  EXPECT_THAT(problem(file.bytes), HasSubstr("expected a longer record of a state"));
}

/// A binout: lengths of eight bytes, commands and types of one; of either order of bytes.
class Binout {
 public:
  explicit Binout(bool big) : big_(big) {
    bytes = std::string("\x8\x8\x8\x1\x1", 5) + static_cast<char>(big ? 0 : 1) + std::string(2, '\0');
    record(7, std::string(8, '\0'));
  }
  Binout& folder(const std::string& path) { return record(2, path); }
  Binout& put(const std::string& name, const std::vector<float>& values) {
    std::string data;
    for (const float value : values) data += word(std::bit_cast<std::uint32_t>(value), 4);
    return record(3, std::string(1, '\x9') + static_cast<char>(name.size()) + name + data);
  }
  Binout& put(const std::string& name, double value) {
    return record(3, std::string(1, '\xA') + static_cast<char>(name.size()) + name +
                         word(std::bit_cast<std::uint64_t>(value), 8));
  }
  Binout& numbers(const std::string& name, const std::vector<std::uint32_t>& values) {
    std::string data;
    for (const std::uint32_t value : values) data += word(value, 4);
    return record(3, std::string(1, '\x3') + static_cast<char>(name.size()) + name + data);
  }

  std::string bytes;

 private:
  Binout& record(char command, const std::string& data) {
    bytes += word(9 + data.size(), 8) + command + data;
    return *this;
  }
  std::string word(std::uint64_t value, std::size_t size) const {
    std::string text;
    for (std::size_t i = 0; i < size; ++i) text += static_cast<char>(value >> 8 * (big_ ? size - 1 - i : i) & 0xFFU);
    return text;
  }

  bool big_;
};

TEST_F(BinaryHistories, ABinoutHasGlstatAndNodout) {
  for (const bool big : {false, true}) {
    Binout file(big);
    file.folder("/").folder("/nodout/metadata").numbers("ids", {5, 6});
    for (int i = 1; i <= 3; ++i) {
      const float t = 0.5F * static_cast<float>(i);
      file.folder(fmt::format("/glstat/d{:06}", i)).put("time", t).put("kinetic_energy", {2 * t}).numbers("cycle", {7});
      file.put("energy_ratio", {1});
      if (i == 2) continue;  // written at other times
      file.folder(fmt::format("../../nodout/d{:06}", i)).put("time", {t}).put("x_displacement", {t, 10 * t});
      file.put("z_velocity", {3 * t, 4 * t}).put("rx_displacement", {1, 1});
    }
    file.folder("/");  // the end of the last state
    const OtherHistory all = read(file.bytes);
    EXPECT_EQ(all.kind, "binout of LS-DYNA");
    EXPECT_THAT(all.times, ElementsAre(0.5, 1, 1.5));
    EXPECT_THAT(curve(all, "kinetic_energy").values, ElementsAre(1, 2, 3));
    EXPECT_THAT(curve(all, "kinetic_energy").meaning.columns, ElementsAre("kinetic", "kinetic_below_zero"));
    EXPECT_TRUE(curve(all, "energy_ratio").meaning.columns.empty());
    EXPECT_THAT(curve(all, "node_6_displacement_x").values, ElementsAre(5, testing::IsNan(), 15));
    EXPECT_THAT(curve(all, "node_5_velocity_z").values, ElementsAre(1.5, testing::IsNan(), 4.5));
    EXPECT_EQ(read(file.bytes.substr(0, file.bytes.size() - 12)).times.size(), 3U);  // its last record is not whole
    EXPECT_THAT(problem(file.bytes + std::string(9, '\0')), HasSubstr("expected the length of a record, got 0"));
  }
}

/// Bytes are changed, taken away and put in: no damage may do more than to end in a message.
TEST_F(BinaryHistories, DamagedBinaryFilesAreReadOrRejected) {
  T01 t01 = t01_head(4021, 100);
  for (const float t : {0.0F, 0.5F, 1.0F}) add_state(t01, t);
  Binout binout(false);
  binout.folder("/nodout/metadata").numbers("ids", {5, 6}).folder("/nodout/d000001").put("time", 0.5);
  binout.put("x_displacement", {1, 2}).folder("/glstat/d000001").put("time", 1.0).put("kinetic_energy", {2});
  binout.folder("../d000002").put("time", 1.5).put("kinetic_energy", {3}).folder("/");
  std::mt19937 random(7);
  const auto any = [&](std::size_t below) { return std::uniform_int_distribution<std::size_t>(0, below - 1)(random); };
  int rejected = 0;
  for (int i = 0; i < 1'000; ++i) {
    std::string bytes = i % 2 == 0 ? t01.bytes : binout.bytes;
    for (std::size_t k = any(3) + 1; k > 0; --k) {
      const std::size_t at = any(bytes.size());
      const char other = static_cast<char>(any(256));
      if (any(3) == 0) {
        bytes.erase(at, any(9) + 1);
      } else if (any(3) == 0) {
        bytes.insert(at, any(9) + 1, other);
      } else {
        bytes[at] = other;
      }
    }
    try {
      read(bytes);
    } catch (const InputError&) {
      ++rejected;
    }
  }
  EXPECT_GT(rejected, 150);
}

}  // namespace
}  // namespace pinball::test::binary_histories_test

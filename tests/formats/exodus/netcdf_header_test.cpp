#include <gmock/gmock.h>

#include <fstream>
#include <string>

#include <solver/formats/exodus/netcdf_header.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/folder_case.hpp>

/// Headers of netCDF files in all three classic forms, written here number by number.
namespace pinball::test::netcdf_header_test {
namespace {

using testing::HasSubstr;

/// Text of a header; form: 1, 2 (64-bit offsets) or 5 (64-bit counts).
class Header {
 public:
  explicit Header(int form) : form_(form), text_("CDF") { text_ += static_cast<char>(form); }

  Header& number(std::uint64_t value, int bytes) {
    for (int i = bytes - 1; i >= 0; --i) text_ += static_cast<char>(value >> 8 * i & 0xff);
    return *this;
  }
  Header& count(std::uint64_t value) { return number(value, form_ == 5 ? 8 : 4); }
  Header& list(std::uint32_t tag, std::uint64_t length) { return number(tag, 4).count(length); }
  Header& none() { return list(0, 0); }
  Header& name(const std::string& name) {
    count(name.size());
    text_ += name + std::string((4 - name.size() % 4) % 4, '\0');
    return *this;
  }
  /// The name of an attribute, and its numbers.
  Header& attribute(const std::string& its, std::uint32_t type, std::uint64_t length, std::size_t bytes) {
    name(its).number(type, 4).count(length);
    text_ += std::string((bytes + 3) / 4 * 4, 'x');
    return *this;
  }
  Header& variable(const std::string& its, const std::vector<std::uint64_t>& dimensions, std::uint32_t type,
                   std::uint64_t begin) {
    name(its).count(dimensions.size());
    for (const std::uint64_t d : dimensions) count(d);
    return none().number(type, 4).count(0).number(begin, form_ == 1 ? 4 : 8);
  }
  /// With so many bytes in all.
  std::string file(std::size_t bytes) const {
    EXPECT_GE(bytes, text_.size());
    return text_ + std::string(bytes - text_.size(), 'x');
  }
  std::size_t size() const { return text_.size(); }

 private:
  int form_;
  std::string text_;
};

constexpr std::uint32_t dimensions = 10, variables = 11, attributes = 12, byte_type = 1, short_type = 3,
                        double_type = 6;

class NetcdfHeader : public FolderTest, public testing::WithParamInterface<int> {
 protected:
  std::string error(const std::string& bytes) const {
    const std::string path = (folder_ / "a.g").string();
    std::ofstream(path, std::ios::binary) << bytes;
    return error_of([&] { check_netcdf_header(path); });
  }
  /// Dimensions "n" of 5 and "record" of whatever, no attributes.
  static Header with_dimensions(std::uint64_t records = 0) {
    return Header(GetParam()).count(records).list(dimensions, 2).name("n").count(5).name("record").count(0).none();
  }
};
INSTANTIATE_TEST_SUITE_P(Forms, NetcdfHeader, testing::Values(1, 2, 5));

TEST_P(NetcdfHeader, AFileHasAllOfItsVariablesAndMayHaveMore) {
  const Header header =
      with_dimensions().list(variables, 2).variable("a", {0}, double_type, 400).variable("b", {0, 0}, byte_type, 450);
  EXPECT_EQ(error(header.file(475)), no_error) << "b is of 25 bytes";
  EXPECT_EQ(error(header.file(5000)), no_error);
  EXPECT_THAT(error(header.file(474)), HasSubstr("is cut short: its variables end at byte 475, and it has 474 bytes"));
  EXPECT_THAT(error(header.file(430)), HasSubstr("is cut short: its variables end at byte "));
  EXPECT_EQ(error(with_dimensions().none().file(300)), no_error) << "no variables";
}

TEST_P(NetcdfHeader, RecordsOfSeveralVariablesArePadded) {
  const auto file = [](std::uint64_t records, bool alone) {
    Header header = with_dimensions(records).list(variables, alone ? 1 : 2).variable("a", {1}, short_type, 400);
    if (!alone) header.variable("b", {1, 0}, byte_type, 404);
    return header;
  };
  EXPECT_EQ(error(file(3, true).file(406)), no_error) << "three numbers of two bytes";
  EXPECT_THAT(error(file(3, true).file(405)), HasSubstr("end at byte 406"));
  EXPECT_EQ(error(file(3, false).file(404 + 2 * 12 + 5)), no_error) << "records of 4 and 8 bytes";
  EXPECT_THAT(error(file(3, false).file(404 + 2 * 12 + 4)), HasSubstr("end at byte 433"));
  EXPECT_EQ(error(file(0, false).file(400)), no_error) << "no records";
}

TEST_P(NetcdfHeader, AnAttributeOfNoTypeOrBeyondTheFileIsDamage) {
  const auto file = [](std::uint32_t type, std::uint64_t length, std::size_t bytes) {
    return Header(GetParam()).count(0).none().list(attributes, 1).attribute("a", type, length, bytes).none().file(200);
  };
  EXPECT_EQ(error(file(double_type, 3, 24)), no_error);
  EXPECT_EQ(error(file(short_type, 3, 6)), no_error);
  for (const std::uint32_t type : {0U, 12U, 99U}) {
    EXPECT_THAT(error(file(type, 0, 0)), HasSubstr("an attribute is longer than the file")) << type;
  }
  EXPECT_THAT(error(file(byte_type, 201, 0)), HasSubstr("an attribute is longer than the file"));
  EXPECT_THAT(error(file(double_type, 100, 0)), HasSubstr("is cut short: the header"));
}

TEST_P(NetcdfHeader, ListsAndVariablesThatCannotBeAreDamage) {
  const auto begin = [] { return Header(GetParam()).count(0); };
  EXPECT_THAT(error(begin().list(attributes, 1).file(200)), HasSubstr("expected a list"));
  EXPECT_THAT(error(begin().list(0, 1).file(200)), HasSubstr("expected a list"));
  EXPECT_THAT(error(begin().list(dimensions, 1000).file(200)), HasSubstr("a list is longer than the file"));
  EXPECT_THAT(error(begin().list(dimensions, 1).count(1000).file(200)), HasSubstr("a name is longer than the file"));
  const auto variable = [](const std::vector<std::uint64_t>& of, std::uint32_t type) {
    return with_dimensions().list(variables, 1).variable("a", of, type, 300).file(400);
  };
  EXPECT_EQ(error(variable({0}, double_type)), no_error);
  EXPECT_THAT(error(variable({2}, double_type)), HasSubstr("a variable has a dimension that is not there"));
  EXPECT_THAT(error(variable({0}, 77)), HasSubstr("a variable has an unknown type"));
  EXPECT_THAT(error(variable({0, 0, 0, 0, 0}, double_type)), HasSubstr("a variable is longer than the file"));
  EXPECT_THAT(error(with_dimensions().list(variables, 1).name("a").count(900).file(400)),
              HasSubstr("a variable has too many dimensions"));
}

TEST_P(NetcdfHeader, NoByteOfAHeaderMayBeMissing) {
  const Header header = with_dimensions().list(variables, 1).variable("a", {}, byte_type, 0);
  const std::string whole = header.file(header.size());
  EXPECT_EQ(error(whole), no_error);
  for (std::size_t length = 4; length < whole.size(); ++length) {
    EXPECT_NE(error(whole.substr(0, length)), no_error) << length;
  }
}

}  // namespace
}  // namespace pinball::test::netcdf_header_test

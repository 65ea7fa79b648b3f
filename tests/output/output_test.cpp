#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include <solver/base/error.hpp>
#include <solver/output/field_output.hpp>
#include <solver/output/history.hpp>
#include <solver/output/output_file.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/output_case.hpp>

namespace pinball::output_test {
namespace {

using test::error_of;
using test::TemporaryFolder;
using test::two_blocks;

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// What a reader sees of a .vtu file: attributes of every DataArray and its bytes.
struct Vtu {
  struct Array {
    std::string tag, bytes;
    std::uint64_t offset = 0;

    template <class T>
    std::vector<T> as() const {
      std::vector<T> values(bytes.size() / sizeof(T));
      std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
      return values;
    }
  };
  std::string head;
  std::map<std::string, Array> arrays;

  static std::string attribute(const std::string& tag, const std::string& name) {
    const std::size_t begin = tag.find(" " + name + "=\"") + name.size() + 3;
    return tag.substr(begin, tag.find('"', begin) - begin);
  }

  explicit Vtu(const std::string& path) {
    const std::string text = read_text(path);
    const std::string mark = "<AppendedData encoding=\"raw\">\n_";
    const std::size_t at = text.find(mark);
    head = text.substr(0, at);
    const std::size_t data = at + mark.size();
    std::uint64_t end = 0;  // blocks lie one behind the other, in the order of the head
    for (std::size_t begin = head.find("<DataArray "); begin != std::string::npos;
         begin = head.find("<DataArray ", begin + 1)) {
      Array array;
      array.tag = head.substr(begin, head.find("/>", begin) - begin);
      array.offset = std::stoull(attribute(array.tag, "offset"));
      EXPECT_EQ(array.offset, end) << array.tag;
      std::uint64_t bytes = 0;
      std::memcpy(&bytes, text.data() + data + array.offset, sizeof bytes);
      array.bytes = text.substr(data + array.offset + sizeof bytes, bytes);
      end = array.offset + sizeof bytes + bytes;
      arrays[attribute(array.tag, "Name")] = array;
    }
    EXPECT_EQ(text.substr(data + end), "\n  </AppendedData>\n</VTKFile>\n");
  }
};

TEST(FieldOutput, HoldsEveryFieldOfTheSnapshot) {
  const TemporaryFolder folder("vtu");
  const FieldSnapshot s = two_blocks(2.5e-5, 0.0);
  write_vtu(folder / "a.vtu", s, {}, "in-lbf-s");
  const Vtu vtu(folder / "a.vtu");

  EXPECT_THAT(vtu.head,
              testing::HasSubstr(
                  R"(<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">)"));
  EXPECT_THAT(vtu.head, testing::HasSubstr(R"(<Piece NumberOfPoints="46" NumberOfCells="11">)"));
  EXPECT_THAT(vtu.head, testing::HasSubstr("velocity [in/s]"));
  EXPECT_THAT(
      vtu.arrays.at("stress").tag,
      testing::HasSubstr(
          R"(ComponentName0="xx" ComponentName1="yy" ComponentName2="zz" ComponentName3="xy" ComponentName4="yz" ComponentName5="zx")"));
  EXPECT_THAT(vtu.arrays.at("velocity").tag,
              testing::HasSubstr(R"(type="Float32" Name="velocity" NumberOfComponents="3")"));
  EXPECT_THAT(vtu.arrays.at("Points").tag, testing::HasSubstr(R"(type="Float64")"));

  EXPECT_EQ(vtu.arrays.at("TimeValue").as<double>(), std::vector<double>{2.5e-5});
  const auto points = vtu.arrays.at("Points").as<double>();
  const auto velocity = vtu.arrays.at("velocity").as<float>();
  const auto force = vtu.arrays.at("contact_force").as<float>();
  ASSERT_EQ(points.size(), 3 * s.position.size());
  ASSERT_EQ(velocity.size(), 3 * s.position.size());
  ASSERT_EQ(force.size(), 3 * s.position.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i], s.position[i / 3][i % 3]);
    EXPECT_EQ(velocity[i], static_cast<float>(s.velocity[i / 3][i % 3]));
    EXPECT_EQ(force[i], static_cast<float>(s.contact_force[i / 3][i % 3]));
  }

  const std::size_t elements = s.hexahedra.size();
  const auto connectivity = vtu.arrays.at("connectivity").as<std::int32_t>();
  const auto offsets = vtu.arrays.at("offsets").as<std::int64_t>();
  const auto types = vtu.arrays.at("types").as<std::uint8_t>();
  const auto stress = vtu.arrays.at("stress").as<float>();
  const auto von_mises = vtu.arrays.at("von_mises").as<float>();
  const auto strain = vtu.arrays.at("plastic_strain").as<float>();
  ASSERT_EQ(connectivity.size(), 8 * elements);
  ASSERT_EQ(stress.size(), 6 * elements);
  for (std::size_t e = 0; e < elements; ++e) {
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(connectivity[8 * e + i], s.hexahedra[e][i]);
    EXPECT_EQ(offsets.at(e), static_cast<std::int64_t>(8 * e + 8));
    EXPECT_EQ(types.at(e), 12);
    for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(stress[6 * e + c], static_cast<float>(s.stress[e][c]));
    const double a = 98.0 + static_cast<double>(e), b = a - 1.0;  // xx - yy, xx - zz
    EXPECT_FLOAT_EQ(von_mises.at(e), static_cast<float>(std::sqrt(0.5 * (a * a + 1.0 + b * b) + 3.0 * (16 + 25 + 36))));
    EXPECT_EQ(strain.at(e), static_cast<float>(s.plastic_strain[e]));
  }
  EXPECT_EQ(vtu.arrays.at("alive").as<std::uint8_t>(), s.alive);
  EXPECT_EQ(vtu.arrays.at("body").as<std::int32_t>(), s.body);
  EXPECT_EQ(vtu.arrays.at("pinball_radius").as<float>(), std::vector<float>(elements, 0.125F));
}

TEST(FieldOutput, TellsWhereElementsHaveTurnedOver) {
  const TemporaryFolder folder("corner_share");
  FieldSnapshot s = two_blocks(0.0, 0.0);
  const auto lift = [&s](std::size_t element, std::size_t corner, double height) {
    s.position[static_cast<std::size_t>(s.hexahedra[element][corner])][2] += height;
  };
  // Corner 4, alone above corner 0, is moved down to it: J_0 and J_4 become those of what is left of its edge.
  lift(8, 4, -0.125);
  for (std::size_t i = 4; i < 8; ++i) lift(10, i, -0.5);  // all of the last is turned over
  write_vtu(folder / "a.vtu", s, {"corner_share"});
  const auto share = Vtu(folder / "a.vtu").arrays.at("corner_share").as<float>();
  ASSERT_EQ(share.size(), s.hexahedra.size());
  EXPECT_FLOAT_EQ(share[0], 1.0F);
  EXPECT_FLOAT_EQ(share[8], 0.5F / 0.875F) << "half the edge of corner 0; an eighth of the volume is lost";
  EXPECT_FLOAT_EQ(share[10], -1.0F);
}

TEST(FieldOutput, HasDisplacementsPressureAndTheNumbersOfFiles) {
  const TemporaryFolder folder("derived");
  const FieldSnapshot s = two_blocks(2.5e-5, 0.125), start = two_blocks(0.0, 0.0);
  FieldBase base{start.position, {}, {}};
  for (std::size_t n = 0; n < s.position.size(); ++n)
    base.node_number.push_back(static_cast<std::int64_t>(5'000'000'000 + n));
  base.element_number.assign(s.hexahedra.size(), -1);
  write_vtu(folder / "a.vtu", s, {}, "in-lbf-s", {}, base);
  const Vtu vtu(folder / "a.vtu");
  EXPECT_THAT(vtu.arrays.at("displacement").tag, testing::HasSubstr(R"(NumberOfComponents="3")"));
  const auto displacement = vtu.arrays.at("displacement").as<float>();
  ASSERT_EQ(displacement.size(), 3 * s.position.size());
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    EXPECT_EQ(displacement[i], static_cast<float>(s.position[i / 3][i % 3] - start.position[i / 3][i % 3])) << i;
  }
  EXPECT_EQ(displacement[displacement.size() - 3], 0.125F) << "the second block has moved in x";
  const auto pressure = vtu.arrays.at("pressure").as<float>();
  ASSERT_EQ(pressure.size(), s.hexahedra.size());
  for (std::size_t e = 0; e < pressure.size(); ++e) {
    EXPECT_FLOAT_EQ(pressure[e], -(105.0F + static_cast<float>(e)) / 3.0F) << "positive in compression";
  }
  EXPECT_EQ(vtu.arrays.at("node_number").as<std::int64_t>(), base.node_number);
  EXPECT_EQ(vtu.arrays.at("element_number").as<std::int64_t>(), base.element_number);
}

TEST(FieldOutput, BringsDisplacementWithVelocityAndPressureWithStress) {
  const TemporaryFolder folder("brought");
  const FieldSnapshot s = two_blocks(0.0, 0.0);
  const FieldBase base{s.position, {}, {}};
  const auto names = [&](const std::vector<std::string>& fields) {
    write_vtu(folder / "a.vtu", s, fields, "", {}, base);
    std::vector<std::string> found;
    for (const auto& [name, array] : Vtu(folder / "a.vtu").arrays) {
      if (name == "displacement" || name == "pressure" || name == "stress" || name == "velocity") found.push_back(name);
    }
    return found;
  };
  EXPECT_THAT(names({"velocity"}), testing::UnorderedElementsAre("velocity", "displacement"));
  EXPECT_THAT(names({"stress"}), testing::UnorderedElementsAre("stress", "pressure"));
  EXPECT_THAT(names({"displacement", "pressure"}), testing::UnorderedElementsAre("displacement", "pressure"));
  EXPECT_THAT(names({"alive"}), testing::IsEmpty());
}

TEST(FieldOutput, WritesBlocksLongerThanItsBuffer) {
  const TemporaryFolder folder("long");
  FieldSnapshot s;
  test::add_block(s, {20, 20, 24}, 1.0, {}, 0);
  write_vtu(folder / "a.vtu", s);
  const auto strain = Vtu(folder / "a.vtu").arrays.at("plastic_strain").as<float>();
  ASSERT_EQ(strain.size(), 9600U);
  for (std::size_t e = 0; e < strain.size(); ++e) ASSERT_EQ(strain[e], 0.125F * static_cast<float>(e));
}

TEST(FieldOutput, WritesWhatIsAskedForAndThere) {
  const TemporaryFolder folder("wanted");
  FieldSnapshot s = two_blocks(0.0, 0.0);
  s.pinball_radius.clear();  // a scene without contact
  write_vtu(folder / "a.vtu", s, {"stress", "pinball_radius"});
  std::vector<std::string> names;
  for (const auto& [name, array] : Vtu(folder / "a.vtu").arrays) names.push_back(name);
  EXPECT_THAT(names, testing::UnorderedElementsAre("TimeValue", "stress", "von_mises", "pressure", "alive", "body",
                                                   "Points", "connectivity", "offsets", "types"));
}

TEST(FieldOutput, RejectsUnknownFieldsAndWrongSizes) {
  const TemporaryFolder folder("reject");
  EXPECT_THROW(FieldWriter(folder.path.string(), "fields", {"strain"}), InputError);
  FieldSnapshot s = two_blocks(0.0, 0.0);
  s.velocity.pop_back();
  EXPECT_THAT(error_of<RunError>([&] { write_vtu(folder / "a.vtu", s); }),
              testing::HasSubstr("velocity has 45 values"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.vtu"));
}

TEST(FieldOutput, ListsFilesWithTimesAfterEveryWrite) {
  const TemporaryFolder folder("list");
  for (const char* name : {"fields_0007.vtu", "fields.pvd", "fields_a.vtu", "fields_1.txt"}) {
    std::ofstream(folder / name) << "left by an earlier run";
  }
  FieldWriter writer(folder.path.string(), "fields", {"velocity"}, "m--s");
  EXPECT_FALSE(std::filesystem::exists(folder / "fields_0007.vtu"));
  EXPECT_FALSE(std::filesystem::exists(folder / "fields.pvd"));
  EXPECT_TRUE(std::filesystem::exists(folder / "fields_a.vtu"));
  EXPECT_TRUE(std::filesystem::exists(folder / "fields_1.txt"));

  writer.write(two_blocks(0.0, 0.0));
  std::string list = read_text(folder / "fields.pvd");
  EXPECT_THAT(list, testing::HasSubstr(R"(timestep="0" group="" part="0" file="fields_0000.vtu")"));
  EXPECT_THAT(list, testing::Not(testing::HasSubstr("fields_0001")));
  EXPECT_THAT(list, testing::HasSubstr("m- -s")) << "a comment must not hold two dashes";
  writer.write(two_blocks(2.5e-5, 0.1));
  list = read_text(folder / "fields.pvd");
  EXPECT_THAT(list,
              testing::HasSubstr(R"(timestep="2.5000000000000001e-05" group="" part="0" file="fields_0001.vtu")"));
  EXPECT_EQ(writer.count(), 2U);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path)) {
    EXPECT_NE(entry.path().extension(), ".part");
  }
}

TEST(FieldOutput, WritesTheLastGoodState) {
  const TemporaryFolder folder("last");
  const std::string path = write_last_good_state(folder / "new", two_blocks(1.0, 0.0));
  EXPECT_EQ(path, folder / "new/last_good.vtu");
  EXPECT_EQ(Vtu(path).arrays.count("contact_force"), 1U);
}

TEST(OutputErrors, NameTheFileAndTheReason) {
  const TemporaryFolder folder("errors");
  std::ofstream(folder / "file") << "no folder";
  EXPECT_THAT(error_of<RunError>([&] { FieldWriter(folder / "file/out", "fields"); }), testing::HasSubstr("file/out"));
  EXPECT_THAT(error_of<RunError>([&] { HistoryWriter(folder / "file/out", {}); }), testing::HasSubstr("file/out"));

  FieldWriter writer(folder.path.string(), "fields");
  std::filesystem::create_directory(folder / "fields_0000.vtu.part");
  EXPECT_THAT(error_of<RunError>([&] { writer.write(two_blocks(0.0, 0.0)); }),
              testing::AllOf(testing::HasSubstr("fields_0000.vtu: "), testing::HasSubstr("directory")));
  EXPECT_FALSE(std::filesystem::exists(folder / "fields.pvd"));
}

TEST(OutputErrors, ShowAFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
  const TemporaryFolder folder("full");
  std::filesystem::create_symlink("/dev/full", folder / "a.txt.part");
  EXPECT_THAT(error_of<RunError>([&] {
                OutputFile file(folder / "a.txt");
                file.write("text");
                file.commit();
              }),
              testing::AllOf(testing::HasSubstr("a.txt: "), testing::HasSubstr("space")));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
  std::filesystem::create_symlink("/dev/full", folder / "history.csv");
  EXPECT_THAT(error_of<RunError>([&] { HistoryWriter(folder.path.string(), {}); }),
              testing::HasSubstr("history.csv: "));
}

TEST(History, HasTheColumnsAndReachesTheFileRowByRow) {
  const TemporaryFolder folder("history");
  HistoryWriter writer(folder.path.string(), {"rod", "plate"});
  HistoryRow row = test::history_row(1, 1.0 / 3.0 * 1e-5);
  row.energy.hourglass = -std::numeric_limits<double>::quiet_NaN();
  writer.write(row);

  std::istringstream text(read_text(folder / "history.csv"));  // the writer is still open
  std::string names, values, more;
  std::getline(text, names);
  std::getline(text, values);
  EXPECT_FALSE(std::getline(text, more));
  EXPECT_EQ(names,
            "step,time,dt,kinetic,internal,hourglass,bulk_viscosity,contact_stored,contact_damped,eroded,external,"
            "total,balance_error,momentum_x,momentum_y,momentum_z,hourglass_plastic,folding,inside_out_elements,"
            "kinetic_below_zero,"
            "rod_velocity_x,rod_velocity_y,rod_velocity_z,rod_mass_remaining,rod_eroded_elements,"
            "rod_max_plastic_strain,plate_velocity_x,plate_velocity_y,plate_velocity_z,plate_mass_remaining,"
            "plate_eroded_elements,plate_max_plastic_strain");
  std::vector<std::string> cells;
  std::istringstream cell_text(values);
  for (std::string cell; std::getline(cell_text, cell, ',');) cells.push_back(cell);
  ASSERT_EQ(cells.size(), 32U);
  EXPECT_EQ(cells[0], "1");
  EXPECT_EQ(std::stod(cells[1]), row.time);  // every bit
  EXPECT_EQ(cells[5], "nan");
  EXPECT_EQ(std::stod(cells[9]), row.energy.eroded);
  EXPECT_EQ(std::stod(cells[15]), -3.0);
  EXPECT_EQ(cells[24], "1");
  EXPECT_EQ(std::stod(cells[31]), 1.0 / 3.0);
}

/// The first row of a history, by its columns.
std::map<std::string, double> columns_of(const std::string& path) {
  std::istringstream text(read_text(path));
  std::string names, values;
  std::getline(text, names);
  std::getline(text, values);
  std::istringstream name_text(names), value_text(values);
  std::map<std::string, double> columns;
  for (std::string name, value; std::getline(name_text, name, ',') && std::getline(value_text, value, ',');) {
    EXPECT_TRUE(columns.emplace(name, std::stod(value)).second) << name << " is there twice";
  }
  return columns;
}

/// Each number is another one, and every second below zero: what is taken for another shows. sign: of the first, so
/// that with both all numbers have been below zero.
void expect_own_columns(double sign) {
  const TemporaryFolder folder("columns");
  HistoryWriter writer(folder.path.string(), {"rod", "plate"}, {"wall_force", "tip_velocity_x"});
  HistoryRow row;
  row.step = 17;
  row.inside_out = 19;
  std::map<std::string, double> expected{{"step", 17}, {"inside_out_elements", 19}};
  double next = sign;
  const auto set = [&](const std::string& name, double& number) {
    next = -1.25 * next;
    expected[name] = number = next;
  };
  set("time", row.time);
  set("dt", row.dt);
  Energies& e = row.energy;
  set("kinetic", e.kinetic);
  set("internal", e.internal);
  set("hourglass", e.hourglass);
  set("bulk_viscosity", e.bulk_viscosity);
  set("contact_stored", e.contact_stored);
  set("contact_damped", e.contact_damped);
  set("eroded", e.eroded);
  set("external", e.external);
  set("hourglass_plastic", e.hourglass_plastic);
  set("folding", e.folding);
  set("kinetic_below_zero", e.kinetic_below_zero);
  set("balance_error", row.balance_error);
  for (std::size_t k = 0; k < 3; ++k) set(std::string("momentum_") + "xyz"[k], row.momentum[k]);
  std::int64_t eroded = 3;
  for (const char* name : {"rod", "plate"}) {
    BodyResult& body = row.bodies.emplace_back();
    const std::string head = std::string(name) + '_';
    for (std::size_t k = 0; k < 3; ++k) set(head + "velocity_" + "xyz"[k], body.velocity[k]);
    set(head + "mass_remaining", body.mass_remaining);
    set(head + "max_plastic_strain", body.max_plastic_strain);
    body.eroded_elements = eroded++;
    expected[head + "eroded_elements"] = static_cast<double>(body.eroded_elements);
  }
  row.more.resize(2);
  set("wall_force", row.more[0]);
  set("tip_velocity_x", row.more[1]);
  expected["total"] = e.kinetic + e.internal + e.hourglass + e.bulk_viscosity + e.contact_stored + e.contact_damped +
                      e.eroded + e.folding + e.kinetic_below_zero - e.external;
  writer.write(row);
  const std::map<std::string, double> columns = columns_of(folder / "history.csv");
  EXPECT_EQ(columns.size(), expected.size());
  for (const auto& [name, number] : expected) {
    ASSERT_TRUE(columns.contains(name)) << name;
    EXPECT_DOUBLE_EQ(columns.at(name), number) << name;
  }
}

TEST(History, EveryColumnHoldsItsOwnNumber) {
  expect_own_columns(1);
  expect_own_columns(-1);
}

TEST(History, RejectsARowOfOtherBodiesAndQuotesNames) {
  const TemporaryFolder folder("quotes");
  HistoryWriter writer(folder.path.string(), {"a,\"b\""});
  EXPECT_THAT(error_of<RunError>([&] { writer.write(test::history_row(0, 0.0)); }), testing::HasSubstr("2 bodies"));
  EXPECT_THAT(read_text(folder / "history.csv"), testing::HasSubstr(",\"a,\"\"b\"\"_velocity_x\","));
}

}  // namespace
}  // namespace pinball::output_test

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include <solver/base/error.hpp>
#include <solver/summary.hpp>
#include <tests/support/output_case.hpp>

namespace pinball {
namespace {

using Json = nlohmann::ordered_json;

RunSummary example() {
  RunSummary s;
  s.scene = "rod_plate";
  s.title = "Rod \"A\"";
  s.status = RunStatus::failed;
  s.error = "no volume";
  s.started = "2024-05-31T08:15:00Z";
  s.units = "in-lbf-s";
  s.version = "0.1.0";
  s.precision = "double";
  s.device = "none";
  s.threads = 2;
  s.simd_width = 8;
  s.elements = 1842;
  s.nodes = 3000;
  s.steps = 100;
  s.wall_seconds = 0.5;
  s.phases = {{"element_forces", 0.25}, {"contact", 0.125}, {"contact", 0.125}};
  s.energy.contact_stored = 1.0;
  s.energy.contact_damped = 2.0;
  s.momentum_final = {1.0, 2.0, 3.0};
  s.bodies = test::history_row(0, 0.0).bodies;
  s.contact_method = "pinball";
  s.contact_enforcement = "penalty";
  s.state_hash = 0xabc;
  s.walls = {{"wall", 1.0, 2.0, 3.0}};
  s.probes = {{"tip", "rod", 7, false, {1, 2, 3}, {{"velocity_x", 4.0}, {"velocity_y", 5.0}}}};
  s.bytes_per_element = 900;
  return s;
}

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;
}

TEST(Summary, HasTheKeysThatScriptsReadFrom) {
  const Json json = Json::parse(summary_json(example()));
  using testing::ElementsAre;
  EXPECT_THAT(
      keys(json),
      ElementsAre("scene", "title", "status", "error", "started", "units", "unit_names", "version", "precision",
                  "device", "threads", "simd_width", "elements", "nodes", "steps", "end_time", "dt", "wall_seconds",
                  "phase_seconds", "element_steps", "element_steps_skipped", "element_steps_eroded",
                  "element_steps_resting", "element_steps_subcycled", "element_steps_per_second", "energy", "momentum",
                  "bodies", "mass_scaling", "rigid_walls", "pressures", "contact", "inside_out", "skipped",
                  "skipped_seconds", "state_hash", "bytes_per_element", "probes", "warnings", "notes"));
  EXPECT_THAT(keys(json["dt"]), ElementsAre("min", "max", "limited_by"));
  EXPECT_THAT(
      keys(json["energy"]),
      ElementsAre("kinetic", "kinetic_below_zero", "internal", "hourglass", "hourglass_plastic", "bulk_viscosity",
                  "folding", "contact", "contact_stored", "contact_damped", "eroded", "external", "initial_total",
                  "final_total", "balance_error_max", "in_motion", "balance_error_in_motion_max",
                  "contact_created_share", "contact_swallowed_share", "hourglass_created_share", "hourglass_share",
                  "hourglass_plastic_share", "kinetic_below_zero_share", "internal_below_zero_share"));
  EXPECT_THAT(keys(json["momentum"]), ElementsAre("initial", "final"));
  ASSERT_EQ(json["bodies"].size(), 2U);
  EXPECT_THAT(keys(json["bodies"][0]), ElementsAre("name", "elements", "eroded_elements", "mass_initial",
                                                   "mass_remaining", "mass_added", "velocity", "max_plastic_strain"));
  EXPECT_THAT(
      keys(json["contact"]),
      ElementsAre("method", "because", "pairs", "tied", "overlaps", "enforcement", "gap", "pinballs", "pairs_max",
                  "solves", "unconverged", "residual_max", "residual_share_max", "sweeps", "searches",
                  "searches_skipped", "max_penetration_ratio", "max_penetration_time", "max_penetration_place"));
  EXPECT_THAT(keys(json["contact"]["sweeps"]), ElementsAre("mean", "largest", "solutions", "at_bound", "unsolved"));
  EXPECT_THAT(keys(json["skipped"]), ElementsAre("resting_element_steps", "subcycled_element_steps", "searches",
                                                 "inner_element_steps", "bytes_not_stored"));
  EXPECT_THAT(keys(json["skipped_seconds"]), ElementsAre("resting", "subcycling", "searches", "inner_elements"));
}

TEST(Summary, HoldsTheValues) {
  const Json json = Json::parse(summary_json(example()));
  EXPECT_EQ(json["scene"], "rod_plate");
  EXPECT_EQ(json["title"], "Rod \"A\"");
  EXPECT_EQ(json["status"], "failed");
  EXPECT_EQ(json["error"], "no volume");
  EXPECT_EQ(json["started"], "2024-05-31T08:15:00Z");
  EXPECT_EQ(json["element_steps_per_second"], 1842.0 * 100.0 / 0.5);
  EXPECT_EQ(json["phase_seconds"], (Json{{"element_forces", 0.25}, {"contact", 0.25}}));
  EXPECT_EQ(json["energy"]["contact"], 3.0);
  EXPECT_EQ(json["momentum"]["final"], (Json{1.0, 2.0, 3.0}));
  EXPECT_EQ(json["bodies"][1]["name"], "plate");
  EXPECT_EQ(json["bodies"][1]["velocity"], (Json{10.0, 0.0, -10.0}));
  EXPECT_EQ(json["state_hash"], "0000000000000abc");
  EXPECT_EQ(json["rigid_walls"], Json::parse(R"([{"name": "wall", "impulse": 3.0, "force_max": 2.0}])"));
  EXPECT_EQ(json["probes"], Json::parse(R"([{"name": "tip", "kind": "node", "body": "rod", "number": 7,
      "point": [1.0, 2.0, 3.0], "values": {"velocity_x": 4.0, "velocity_y": 5.0}}])"));
}

TEST(Summary, NamesTheUnitsOfTheColumnsOfTheHistory) {
  RunSummary s = example();
  s.units = "in-lbf-s";
  EXPECT_EQ(Json::parse(summary_json(s))["unit_names"],
            Json::parse(R"({"time": "s", "length": "in", "velocity": "in/s", "mass": "lbf s^2/in", "force": "lbf",
                            "momentum": "lbf s", "energy": "lbf in", "stress": "psi"})"));
  s.units = "";
  EXPECT_EQ(Json::parse(summary_json(s))["unit_names"], Json::object());
}

TEST(Summary, EmptyListsKeepTheirType) {
  const Json json = Json::parse(summary_json(RunSummary{}));
  EXPECT_TRUE(json["phase_seconds"].is_object());
  EXPECT_TRUE(json["bodies"].is_array());
  EXPECT_TRUE(json["element_steps_per_second"].is_null()) << "no wall time";
  EXPECT_EQ(json["status"], "running");
  EXPECT_TRUE(json["error"].is_null());
}

TEST(Summary, WritesNumbersThatAreNoneAsNull) {
  RunSummary s = example();
  s.final_total = std::nan("");
  s.dt_max = std::numeric_limits<double>::infinity();
  s.momentum_final[1] = -std::numeric_limits<double>::infinity();
  s.title = "\xff";  // not UTF-8
  const Json json = Json::parse(summary_json(s));
  EXPECT_TRUE(json["energy"]["final_total"].is_null());
  EXPECT_TRUE(json["dt"]["max"].is_null());
  EXPECT_TRUE(json["momentum"]["final"][1].is_null());
}

TEST(Summary, IsWrittenAsAFile) {
  const test::TemporaryFolder folder("summary");
  write_summary(folder / "new", example());
  std::ifstream file(folder / "new/summary.json");
  EXPECT_EQ(Json::parse(file)["steps"], 100);
  std::filesystem::create_directory(folder / "new/summary.json.part");
  try {
    write_summary(folder / "new", example());
    FAIL() << "no error";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("new/summary.json"));
  }
}

}  // namespace
}  // namespace pinball

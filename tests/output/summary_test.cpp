#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include <solver/base/error.hpp>
#include <solver/summary.hpp>
#include <tests/support/output_case.hpp>

namespace pinball::summary_test {
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
                  "element_steps_resting", "element_steps_subcycled", "element_steps_rigid", "element_steps_per_second",
                  "energy", "momentum", "bodies", "point_mass", "mass_scaling", "rigid_bodies", "joints", "rigid_walls",
                  "pressures", "contact", "inside_out", "skipped", "skipped_seconds", "parallel", "state_hash",
                  "bytes_per_element", "probes", "warnings", "notes"));
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

TEST(Summary, TellsHowRanksHaveSharedTheRun) {
  RunSummary s = example();
  EXPECT_TRUE(Json::parse(summary_json(s))["parallel"].is_null());
  s.parallel = {4, 1000, 12, 200, 30000, 1.25, {"one", "another"}};
  const Json parallel = Json::parse(summary_json(s))["parallel"];
  EXPECT_THAT(keys(parallel), testing::ElementsAre("ranks", "records", "messages", "common_nodes", "bytes_per_step",
                                                   "imbalance", "devices"));
  EXPECT_EQ(parallel["ranks"], 4);
  EXPECT_EQ(parallel["records"], 1000);
  EXPECT_EQ(parallel["messages"], 12);
  EXPECT_EQ(parallel["common_nodes"], 200);
  EXPECT_EQ(parallel["bytes_per_step"], 30000);
  EXPECT_EQ(parallel["imbalance"], 1.25);
  EXPECT_EQ(parallel["devices"], Json({"one", "another"}));
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

/// Numbers of the summary that are of their own, each another one, and every second below zero: with both signs of the
/// first, all of them.
class Numbers {
 public:
  explicit Numbers(double sign) : next_(sign) {}
  double operator()(const std::string& path) {
    next_ = -1.125 * next_;
    expected_[path] = next_;
    return next_;
  }
  std::int64_t whole(const std::string& path) {
    expected_[path] = static_cast<double>(++count_);
    return count_;
  }
  Point vector(const std::string& path) {
    Point v{};
    for (std::size_t k = 0; k < 3; ++k) v[k] = (*this)(path + '/' + std::to_string(k));
    return v;
  }
  void also(const std::string& path, double number) { expected_[path] = number; }
  void expect_in(const Json& json) const {
    for (const auto& [path, number] : expected_) {
      const Json::json_pointer place(path);
      ASSERT_TRUE(json.contains(place) && json[place].is_number()) << path;
      EXPECT_DOUBLE_EQ(json[place].get<double>(), number) << path;
    }
  }
  /// Numbers that nobody has named.
  void expect_all_of(const Json& json, const std::string& head = {}) const {
    for (const auto& item : json.items()) {
      const std::string path = head + '/' + item.key();
      if (item.value().is_structured()) expect_all_of(item.value(), path);
      EXPECT_TRUE(!item.value().is_number() || expected_.contains(path)) << path;
    }
  }

 private:
  std::map<std::string, double> expected_;
  double next_;
  std::int64_t count_ = 100;
};

void expect_own_numbers(double sign) {
  RunSummary s;
  Numbers n(sign);
  s.threads = static_cast<int>(n.whole("/threads"));
  s.simd_width = static_cast<int>(n.whole("/simd_width"));
  s.elements = n.whole("/elements");
  s.nodes = n.whole("/nodes");
  s.steps = n.whole("/steps");
  s.end_time = n("/end_time");
  s.dt_min = n("/dt/min");
  s.dt_max = n("/dt/max");
  s.wall_seconds = n("/wall_seconds");
  n.also("/element_steps_per_second", static_cast<double>(s.elements * s.steps) / s.wall_seconds);
  s.phases = {{"output", n("/phase_seconds/output")}};
  s.element_steps = n.whole("/element_steps");
  s.element_steps_eroded = n.whole("/element_steps_eroded");
  s.element_steps_resting = n.whole("/element_steps_resting");
  s.element_steps_subcycled = n.whole("/element_steps_subcycled");
  s.element_steps_rigid = n.whole("/element_steps_rigid");
  n.also("/skipped/resting_element_steps", static_cast<double>(s.element_steps_resting));
  n.also("/skipped/subcycled_element_steps", static_cast<double>(s.element_steps_subcycled));
  n.also("/element_steps_skipped", static_cast<double>(s.element_steps_eroded + s.element_steps_resting +
                                                       s.element_steps_subcycled + s.element_steps_rigid));
  Energies& e = s.energy;
  e.kinetic = n("/energy/kinetic");
  e.kinetic_below_zero = n("/energy/kinetic_below_zero");
  e.internal = n("/energy/internal");
  e.hourglass = n("/energy/hourglass");
  e.hourglass_plastic = n("/energy/hourglass_plastic");
  e.bulk_viscosity = n("/energy/bulk_viscosity");
  e.folding = n("/energy/folding");
  e.contact_stored = n("/energy/contact_stored");
  e.contact_damped = n("/energy/contact_damped");
  n.also("/energy/contact", e.contact_stored + e.contact_damped);
  e.eroded = n("/energy/eroded");
  e.external = n("/energy/external");
  s.initial_total = n("/energy/initial_total");
  s.final_total = n("/energy/final_total");
  s.balance_error_max = n("/energy/balance_error_max");
  s.energy_in_motion = n("/energy/in_motion");
  s.balance_error_in_motion.largest = n("/energy/balance_error_in_motion_max");
  s.contact_created.largest = n("/energy/contact_created_share");
  s.contact_swallowed.largest = n("/energy/contact_swallowed_share");
  s.hourglass_created.largest = n("/energy/hourglass_created_share");
  s.hourglass_large.largest = n("/energy/hourglass_share");
  s.hourglass_plastic.largest = n("/energy/hourglass_plastic_share");
  s.kinetic_below_zero.largest = n("/energy/kinetic_below_zero_share");
  s.internal_below_zero.largest = n("/energy/internal_below_zero_share");
  s.inside_out.elements = n.whole("/inside_out/elements");
  s.inside_out.most = n.whole("/inside_out/most");
  s.inside_out.first_time = n("/inside_out/first_time");
  s.momentum_initial = n.vector("/momentum/initial");
  s.momentum_final = n.vector("/momentum/final");
  double material_mass = 0;
  for (const std::string b : {"0", "1"}) {
    BodyResult& body = s.bodies.emplace_back();
    body.elements = n.whole("/bodies/" + b + "/elements");
    body.eroded_elements = n.whole("/bodies/" + b + "/eroded_elements");
    body.mass_initial = n("/bodies/" + b + "/mass_initial");
    body.mass_remaining = n("/bodies/" + b + "/mass_remaining");
    body.mass_added = n("/bodies/" + b + "/mass_added");
    body.velocity = n.vector("/bodies/" + b + "/velocity");
    body.max_plastic_strain = n("/bodies/" + b + "/max_plastic_strain");
    material_mass += body.mass_initial;
  }
  s.point_mass = n("/point_mass");
  s.mass_added = n("/mass_scaling/added");
  n.also("/mass_scaling/percent", 100 * s.mass_added / (material_mass - s.mass_added));
  RigidBodyResult& rigid = s.rigid_bodies.emplace_back();
  rigid.mass = n("/rigid_bodies/0/mass");
  for (std::size_t k = 0; k < 3; ++k) rigid.inertia[k] = n.vector("/rigid_bodies/0/inertia/" + std::to_string(k));
  rigid.centre = n.vector("/rigid_bodies/0/centre");
  rigid.velocity = n.vector("/rigid_bodies/0/velocity");
  rigid.angular_velocity = n.vector("/rigid_bodies/0/angular_velocity");
  rigid.angular_momentum = n.vector("/rigid_bodies/0/angular_momentum");
  JointResult& joint = s.joints.emplace_back();
  joint.force = n.vector("/joints/0/force");
  joint.moment = n.vector("/joints/0/moment");
  joint.work = n("/joints/0/work");
  joint.opening = n("/joints/0/opening");
  WallResult& wall = s.walls.emplace_back();
  wall.moves = true;
  wall.impulse = n("/rigid_walls/0/impulse");
  wall.force_max = n("/rigid_walls/0/force_max");
  wall.displacement = n("/rigid_walls/0/displacement");
  wall.velocity = n("/rigid_walls/0/velocity");
  s.pressures.push_back({"gas", n.vector("/pressures/0/force"), n("/pressures/0/work")});
  s.probes = {{"tip",
               "rod",
               n.whole("/probes/0/number"),
               false,
               n.vector("/probes/0/point"),
               {{"velocity_x", n("/probes/0/values/velocity_x")}}}};
  PairResult& pair = s.contact_pairs.emplace_back();
  pair.impulse = n.vector("/contact/pairs/0/impulse");
  pair.force_max = n("/contact/pairs/0/force_max");
  TiedResult& tied = s.tied.emplace_back();
  tied.nodes = n.whole("/contact/tied/0/nodes");
  tied.near = n.whole("/contact/tied/0/near");
  tied.held = n.whole("/contact/tied/0/held");
  tied.taken = n.whole("/contact/tied/0/taken");
  OverlapResult& overlap = s.overlaps.emplace_back();
  overlap.points = n.whole("/contact/overlaps/0/points");
  overlap.nodes = n.whole("/contact/overlaps/0/nodes");
  overlap.depth = n("/contact/overlaps/0/depth");
  overlap.share = n("/contact/overlaps/0/share");
  overlap.time = n("/contact/overlaps/0/time");
  s.pinballs = n.whole("/contact/pinballs");
  s.pairs_max = n.whole("/contact/pairs_max");
  s.iterations.solutions = n.whole("/contact/sweeps/solutions");
  n.also("/contact/solves", static_cast<double>(s.iterations.solutions));
  s.iterations.iterations = 7 * s.iterations.solutions;
  n.also("/contact/sweeps/mean", 7);
  s.iterations.largest = n.whole("/contact/sweeps/largest");
  s.iterations.at_bound = n.whole("/contact/sweeps/at_bound");
  n.also("/contact/unconverged", static_cast<double>(s.iterations.at_bound));
  s.iterations.unsolved = n.whole("/contact/sweeps/unsolved");
  s.iterations.residual = n("/contact/residual_max");
  s.iterations.relative = n("/contact/residual_share_max");
  s.searches = n.whole("/contact/searches");
  s.searches_skipped = n.whole("/contact/searches_skipped");
  n.also("/skipped/searches", static_cast<double>(s.searches_skipped));
  s.max_penetration_ratio = n("/contact/max_penetration_ratio");
  s.max_penetration_time = n("/contact/max_penetration_time");
  s.inner_element_steps = n.whole("/skipped/inner_element_steps");
  s.bytes_not_stored = n.whole("/skipped/bytes_not_stored");
  s.skipped_seconds.resting = n("/skipped_seconds/resting");
  s.skipped_seconds.subcycling = n("/skipped_seconds/subcycling");
  s.skipped_seconds.searches = n("/skipped_seconds/searches");
  s.skipped_seconds.inner_elements = n("/skipped_seconds/inner_elements");
  s.bytes_per_element = n.whole("/bytes_per_element");
  const Json json = Json::parse(summary_json(s));
  n.expect_in(json);
  n.expect_all_of(json);
}

TEST(Summary, EveryKeyHoldsItsOwnNumber) {
  expect_own_numbers(1);
  expect_own_numbers(-1);
}

TEST(Summary, EveryKeyHoldsItsOwnText) {
  RunSummary s;
  std::map<std::string, std::string> expected;
  const auto set = [&](const char* path, std::string& text) { expected[path] = text = "text of " + std::string(path); };
  set("/scene", s.scene);
  set("/title", s.title);
  set("/error", s.error);
  set("/started", s.started);
  set("/units", s.units);
  set("/version", s.version);
  set("/precision", s.precision);
  set("/device", s.device);
  set("/dt/limited_by", s.dt_limited_by);
  set("/inside_out/first_place", s.inside_out.first_place);
  set("/bodies/0/name", s.bodies.emplace_back().name);
  set("/rigid_bodies/0/name", s.rigid_bodies.emplace_back().name);
  set("/joints/0/name", s.joints.emplace_back().name);
  set("/rigid_walls/0/name", s.walls.emplace_back().name);
  set("/pressures/0/name", s.pressures.emplace_back().name);
  set("/probes/0/name", s.probes.emplace_back().name);
  set("/probes/0/body", s.probes[0].body);
  set("/contact/pairs/0/name", s.contact_pairs.emplace_back().name);
  set("/contact/tied/0/name", s.tied.emplace_back().name);
  OverlapResult& overlap = s.overlaps.emplace_back();
  set("/contact/overlaps/0/first", overlap.first);
  set("/contact/overlaps/0/second", overlap.second);
  set("/contact/overlaps/0/place", overlap.place);
  set("/contact/method", s.contact_method);
  set("/contact/because", s.contact_because);
  set("/contact/enforcement", s.contact_enforcement);
  set("/contact/gap", s.contact_gap);
  set("/contact/max_penetration_place", s.max_penetration_place);
  set("/notes/0", s.notes.emplace_back());
  const Json json = Json::parse(summary_json(s));
  for (const auto& [path, text] : expected) EXPECT_EQ(json[Json::json_pointer(path)], text) << path;
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
}  // namespace pinball::summary_test

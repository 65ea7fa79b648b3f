#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>

#include <solver/output/history.hpp>
#include <solver/program/study/quantities.hpp>
#include <solver/program/study/run_results.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/folder_case.hpp>

namespace pinball::run_results_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class RunResultsTest : public test::FolderTest {
 protected:
  RunResults read(const std::string& summary, const std::string& history) const {
    std::ofstream(folder_ / "summary.json") << summary;
    std::ofstream(folder_ / "history.csv") << history;
    return read_run_results(folder_.string());
  }
  RunResults sample() const {
    return read(R"({"status": "done", "energy": {"kinetic": 3, "hourglass": 1e-9, "contact": null},
                    "bodies": [{"name": "bar", "velocity": [1, 2, 3], "max_plastic_strain": 0.5}],
                    "sizes": [4, 5], "warnings": ["something"]})",
                "time,kinetic,hourglass,bar_velocity_x,bar_velocity_z,tip_stress_xx,foot_force_z\n"
                "0,5,0,1e-9,-4,1,0\n1,3,1e-9,2e-9,-1,7,2\n3,3,1e-9,1e-9,0,2,4\n");
  }
};

TEST_F(RunResultsTest, NamesNumbersOfTheSummaryByTheirPaths) {
  const RunResults run = sample();
  EXPECT_EQ(run.status, "done");
  EXPECT_THAT(run.warnings, ElementsAre("something"));
  EXPECT_EQ(run.value("energy.kinetic"), 3);
  EXPECT_EQ(run.value("bodies.bar.max_plastic_strain"), 0.5);
  EXPECT_EQ(run.value("bodies.bar.velocity.y"), 2);
  EXPECT_EQ(run.value("sizes.1"), 5);
  EXPECT_FALSE(run.value("energy.contact"));
  EXPECT_FALSE(run.value("energy"));
}

TEST_F(RunResultsTest, TellsWhatTheRunTookButForItsFiles) {
  const std::string history = "time,kinetic\n0,5\n";
  EXPECT_EQ(read(R"({"wall_seconds": 3, "phase_seconds": {"output": 0.5, "integration": 2}})", history).seconds(), 2.5);
  EXPECT_EQ(read(R"({"wall_seconds": 3})", history).seconds(), 3);
  EXPECT_EQ(sample().seconds(), 0);
}

TEST_F(RunResultsTest, TakesLastExtremesAndIntegralOfColumns) {
  const RunResults run = sample();
  EXPECT_EQ(run.value("bar_velocity_z"), 0);
  EXPECT_EQ(run.value("bar_velocity_z:last"), 0);
  EXPECT_EQ(run.value("bar_velocity_z:min"), -4);
  EXPECT_EQ(run.value("tip_stress_xx:max"), 7);
  EXPECT_EQ(run.value("foot_force_z:integral"), 1 + 6);
  EXPECT_FALSE(run.value("foot_force_z:mean"));
  EXPECT_FALSE(run.value("energy.kinetic:max"));
}

TEST_F(RunResultsTest, TakesCurvesAndLengths) {
  const RunResults run = read("{}",
                              "time,a_position_x,a_position_y,a_position_z,b_position_x,b_position_y,b_position_z,c_x\n"
                              "0,0,0,0,3,4,0,1\n1,1,2,3,1,2,5,1\n3,0,0,1,0,0,-9,2\n");
  EXPECT_EQ(run.value("length(a,b)"), 10);
  EXPECT_EQ(run.value("length(b,a):min"), 2);
  EXPECT_EQ(run.value("length(a,b):integral"), 3.5 + 12);
  EXPECT_FALSE(run.value("length(a,c)"));
  EXPECT_FALSE(run.value("length(a)"));
  EXPECT_EQ(run.scale("length(a,b)"), 10);
  EXPECT_THAT(run.curve("length(a,b):curve").value().values, ElementsAre(5, 2, 10));
  EXPECT_THAT(run.curve("c_x:curve").value().times, ElementsAre(0, 1, 3));
  EXPECT_FALSE(run.value("c_x:curve"));
  EXPECT_FALSE(run.curve("c_x"));
  EXPECT_FALSE(run.curve("d_x:curve"));
  EXPECT_NEAR(run.scale("c_x:curve"), std::sqrt((1 + 2 * (1 + 2 + 4) / 3.0) / 3), 1e-14);
  EXPECT_EQ(unit_of_quantity("length(a,b):max", parse_units("g-mm-ms")), "mm");
  EXPECT_EQ(unit_of_quantity("foot_force_z:curve", parse_units("g-mm-ms")), "N");
}

TEST_F(RunResultsTest, MeasuresByVectorsAndByAllEnergies) {
  const RunResults run = sample();
  EXPECT_EQ(run.scale("bar_velocity_x"), 4);
  EXPECT_EQ(run.scale("energy.hourglass"), 5);
  EXPECT_EQ(run.scale("hourglass:max"), 5);
  EXPECT_EQ(run.scale("bodies.bar.max_plastic_strain"), 0.5);
  EXPECT_EQ(run.scale("foot_force_z:integral"), 4 * 3);
}

TEST_F(RunResultsTest, FilesThatAreNoneOfARunAreNamed) {
  EXPECT_THROW(read_run_results((folder_ / "none").string()), RunError);
  EXPECT_THROW(read("{", "time\n0\n"), RunError);
  EXPECT_THROW(read("{}", ""), RunError);
  EXPECT_THROW(read("{}", "time,dt\n0\n"), RunError);
}

TEST_F(RunResultsTest, AskedForByDefaultIsWhatIsThereAndNotNegligible) {
  Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].name = "bar";
  scene.probes.resize(1);
  scene.probes[0].name = "tip";
  scene.fixed_constraints.resize(2);
  scene.fixed_constraints[0].name = "foot";
  EXPECT_THAT(default_quantities(scene, sample()),
              ElementsAre("energy.kinetic", "foot_force_z:integral", "tip_stress_xx", "tip_stress_xx:max"));
}

TEST_F(RunResultsTest, AnUnknownQuantityIsToldWithTheNearest) {
  require_quantities({"energy.kinetic", "bar_velocity_z:max"}, sample());
  const std::string error = test::error_of([&] { require_quantities({"bar_velocty_z:max"}, sample()); });
  EXPECT_THAT(error, HasSubstr("--of bar_velocty_z:max: expected"));
  EXPECT_THAT(error, HasSubstr("nearest is bar_velocity_z"));
  EXPECT_THROW(require_quantities({"bar_velocity_z:mean"}, sample()), InputError);
}

TEST(UnitOfQuantity, IsThatOfTheScene) {
  const Units units = parse_units("g-mm-ms");
  for (const auto& [quantity, unit] : {std::pair{"energy.kinetic", units.energy},
                                       {"kinetic:max", units.energy},
                                       {"energy.hourglass_share", std::string()},
                                       {"bar_kinetic", units.energy},
                                       {"bar_velocity_x", units.velocity},
                                       {"bodies.bar.velocity.x", units.velocity},
                                       {"tip_displacement_z:min", units.length},
                                       {"tip_stress_xx", units.stress},
                                       {"tip_effective_stress", units.stress},
                                       {"foot_force_z", units.force},
                                       {"foot_force_z:integral", units.momentum},
                                       {"rigid_walls.wall.force_max", units.force},
                                       {"contact.pairs.pair.impulse.x", units.momentum},
                                       {"bodies.bar.mass_remaining", units.mass},
                                       {"bodies.bar.max_plastic_strain", std::string()},
                                       {"load_work", units.energy},
                                       {"drum_angular_velocity_z", "1/ms"},
                                       {"drum_angular_velocity_z:integral", std::string()},
                                       {"rigid_bodies.drum.angular_velocity.z", "1/ms"},
                                       {"rigid_bodies.drum.angular_momentum.z", "N ms mm"},
                                       {"rigid_bodies.drum.inertia.2.x", "g mm^2"},
                                       {"rigid_bodies.drum.centre.x", units.length},
                                       {"drum_centre_x", units.length},
                                       {"drum_centre_velocity_x", units.velocity},
                                       {"drum_centre_velocity_x:integral", units.length},
                                       {"drum_reaction_moment_z", "N mm"},
                                       {"hinge_joint_moment_x:integral", "N ms mm"},
                                       {"joints.hinge.moment.x", "N mm"},
                                       {"joints.hinge.opening", std::string()},
                                       {"momentum_z", units.momentum},
                                       {"momentum.final.z", units.momentum},
                                       {"mass_scaling.added", units.mass},
                                       {"mass_scaling.percent", std::string()},
                                       {"contact.residual_max", units.velocity},
                                       {"contact.residual_share_max", std::string()},
                                       {"contact.overlaps.0.depth", units.length},
                                       {"probes.tip.point.y", units.length},
                                       {"dt.max", units.time},
                                       {"dt:min", units.time},
                                       {"steps", std::string()}}) {
    EXPECT_EQ(unit_of_quantity(quantity, units), unit) << quantity;
  }
  EXPECT_EQ(unit_of_quantity("tip_displacement_z:integral", units), units.length + " " + units.time);
  for (const char* quantity :
       {"kinetic", "drum_angular_velocity_z", "drum_reaction_moment_z", "tip_position_x:integral"})
    EXPECT_EQ(unit_of_quantity(quantity, parse_units("none")), "") << quantity;
}

/// All that a history has of a model without bodies, but for these.
TEST(UnitOfQuantity, OfEachEnergyOfAHistoryIsThatOfEnergies) {
  const Units units = parse_units("g-mm-ms");
  const std::set<std::string> others{"step",       "time",       "dt",         "balance_error",
                                     "momentum_x", "momentum_y", "momentum_z", "inside_out_elements"};
  for (const std::string& column : history_column_names({}, {})) {
    EXPECT_EQ(unit_of_quantity(column, units) == units.energy, others.count(column) == 0) << column;
  }
}

}  // namespace
}  // namespace pinball::run_results_test

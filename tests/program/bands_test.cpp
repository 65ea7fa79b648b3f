#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include <solver/program/study/convergence_study.hpp>
#include <tests/support/folder_case.hpp>

/// Whether the bands of a study contain what is exactly known: docs/accuracy.md has the same table of more scenes.
namespace pinball::bands_test {
namespace {

using testing::ElementsAre;

class Bands : public test::FolderTest {
 protected:
  /// Runs the scene on these meshes and sorts what is exactly known by what its band does; without a band it is
  /// neither.
  void compare(const std::string& scene, const std::string& meshes, const std::map<std::string, double>& exact) {
    StudySettings settings;
    settings.factors = parse_mesh_factors(meshes);
    settings.folder = {folder_.string(), 1, true};
    for (const auto& [name, value] : exact) settings.of.push_back(name);
    const ConvergenceStudy study = study_convergence(read_scene(find_scene(scene)), settings);
    ASSERT_EQ(study.quantities.size(), exact.size());
    for (const StudyQuantity& quantity : study.quantities) {
      ASSERT_TRUE(quantity.convergence);
      const GridConvergence& c = *quantity.convergence;
      if (!c.has_band()) continue;
      const double value = exact.at(quantity.name);
      (value >= c.low && value <= c.high ? hits_ : misses_).push_back(quantity.name);
    }
  }

  std::vector<std::string> hits_, misses_;
};

/// Stress at the wall, on its side of the element and behind both fronts, by
/// data/reference/plate_impact_copper_exact.csv; impulse and momentum follow from it until the elastic wave is back,
/// which is when the scene ends.
TEST_F(Bands, OfThePlateImpactContainTheExactSolution) {
  const double area = 1e-4, mass = 8.31e-8, stress = 138772.2, end = 10.66e-6, impulse = stress * area * end;
  compare("plate_impact", "1,2,3",
          {{"wall_impulse", impulse},
           {"plate_velocity_z", impulse / mass - 1000},
           {"middle_stress_zz", -315.20391},
           {"middle_effective_stress", 20946.841},
           {"rigid_walls.wall.force_max", stress * area}});
  EXPECT_THAT(hits_, ElementsAre("middle_effective_stress", "middle_stress_zz", "plate_velocity_z", "wall_impulse"));
  // All meshes stop their lowest nodes within one step, whatever their size: nothing in it is of the mesh.
  EXPECT_THAT(misses_, ElementsAre("rigid_walls.wall.force_max"));
}

/// The bars exchange their velocities, and nothing is lost.
TEST_F(Bands, OfTwoBarsContainTheExactSolution) {
  compare("two_bars", "2,4,8",
          {{"energy.kinetic", 0.05},
           {"energy.internal", 0},
           {"energy.bulk_viscosity", 0},
           {"energy.contact", 0},
           {"bar1_velocity_x", 0},
           {"bar2_velocity_x", 0.1},
           {"x10_velocity_x", 0},
           {"x10_5_velocity_x", 0.1},
           {"x10_5_velocity_x:max", 0.1},
           {"x15_5_velocity_x:max", 0.1}});
  EXPECT_EQ(hits_.size(), 9);
  // What contact damps falls with an order that looks higher on these meshes than it is.
  EXPECT_THAT(misses_, ElementsAre("energy.contact"));
}

}  // namespace
}  // namespace pinball::bands_test

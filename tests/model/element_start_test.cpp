#include <gtest/gtest.h>

#include <solver/model/elements/element_start.hpp>
#include <tests/support/solver_case.hpp>
#include <tests/support/tetrahedra_case.hpp>

/// What is said of elements before a run is what the run finds.
namespace pinball::element_start_test {
namespace {

using namespace test;

double step_said(const Scene& scene) {
  const ModelMesh mesh = build_mesh(scene);
  return scene.time.cfl * smallest_stable_step(scene, mesh, element_parts(scene, mesh), {});
}

double first_step(const Scene& scene) {
  Solver<double> solver(scene);
  solver.step();
  return solver.dt();
}

/// At rest, of cubes, of flat and of slender elements, and of tetrahedra; viscosity makes it shorter. (The run divides
/// its time into equal steps, which are shorter by some 1e-7.)
TEST(ElementStart, HasTheStepOfTheRun) {
  for (const bool tetrahedra : {false, true}) {
    for (const Point& size : {Point{0.1, 0.1, 0.1}, {0.1, 0.2, 0.05}, {0.3, 0.1, 0.1}}) {
      Body body = block("a", {2, 2, 2}, 0.1, {0, 0, 0});
      body.mesh = BlockMesh{{2 * size[0], 2 * size[1], 2 * size[2]}, {2, 2, 2}};
      Scene scene = scene_of({tetrahedra ? cut(body) : body}, 100, false);
      double without = 0;
      for (const double linear : {0.0, 0.06, 0.5}) {
        scene.element.bulk_viscosity = linear > 0;
        scene.element.linear_viscosity = linear;
        const double said = step_said(scene);
        EXPECT_NEAR(first_step(scene), said, 1e-6 * said) << tetrahedra << ", " << size[1] << ", " << linear;
        if (linear == 0) without = said;
        EXPECT_LE(said, (linear > 0.1 ? 0.9 : 1) * without);
      }
    }
  }
}

}  // namespace
}  // namespace pinball::element_start_test

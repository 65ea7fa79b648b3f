#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <solver/program/study/convergence_report.hpp>
#include <solver/program/study/error_sources.hpp>
#include <solver/program/study/sources_report.hpp>
#include <solver/scene_rules.hpp>
#include <tests/support/error_of.hpp>

namespace pinball::error_sources_test {
namespace {

using test::error_of;
using testing::HasSubstr;
using testing::Not;

Scene scene_at_speed(double speed) {
  Scene scene;
  scene.materials.resize(1);
  scene.materials[0].density = 4;
  scene.materials[0].bulk_modulus = 16;
  scene.bodies.resize(2);
  scene.bodies[1].velocity = {0, 0, speed};
  return scene;
}

TEST(ErrorSources, EachChangesItsOwnAlone) {
  Scene scene = scene_at_speed(-5);
  scene.bodies[0].element = ElementSettings{};
  const auto all =
      vary_sources(scene, {ErrorSource::step, ErrorSource::precision, ErrorSource::hourglass, ErrorSource::chance}, 2);
  ASSERT_EQ(all.size(), 6);
  EXPECT_EQ(all[0].scenes[0].time.cfl, 0.45);
  EXPECT_EQ(all[0].scenes[0].precision, Precision::float64);
  EXPECT_EQ(all[1].scenes[0].precision, Precision::float32);
  EXPECT_EQ(all[2].scenes[0].precision, Precision::mixed);
  EXPECT_EQ(all[3].scenes[0].element.hourglass, HourglassControl::viscous);
  EXPECT_EQ(all[3].scenes[0].element.hourglass_coefficient, 0.025);
  EXPECT_EQ(all[4].scenes[0].bodies[0].element->hourglass, HourglassControl::stiffness);
  ASSERT_EQ(all[5].scenes.size(), 2);
  EXPECT_DOUBLE_EQ(all[5].scenes[0].bodies[0].velocity_noise, 5e-9);
  EXPECT_DOUBLE_EQ(all[5].scenes[1].bodies[1].velocity_noise, 10e-9);
  scene.device = Device::mock;
  EXPECT_EQ(vary_sources(scene, {ErrorSource::precision}, 2).size(), 1) << "there is no mixed precision on devices";
  EXPECT_TRUE(vary_sources(scene, {}, 2).empty());
}

TEST(ErrorSources, ContactIsThatOfTheDefaultsAndASlideline) {
  Scene scene = scene_at_speed(-5);
  const auto names = [&scene](ContactMethod method, Enforcement enforcement, ContactGap gap) {
    scene.contact.method = method;
    scene.contact.enforcement = enforcement;
    scene.contact.gap = gap;
    complete(scene.contact);
    std::vector<std::string> found;
    for (const SourceVariation& other : vary_sources(scene, {ErrorSource::contact}, 1)) found.push_back(other.name);
    return found;
  };
  using testing::ElementsAre;
  EXPECT_THAT(names(ContactMethod::pinball, Enforcement::penalty, ContactGap::pinball),
              ElementsAre("contact faces", "contact slideline"));
  EXPECT_THAT(names(ContactMethod::pinball, Enforcement::lagrange, ContactGap::face), ElementsAre("contact slideline"));
  EXPECT_THAT(names(ContactMethod::slideline, Enforcement::lagrange, ContactGap::face), ElementsAre("contact faces"));
  const Scene faces = vary_sources(scene, {ErrorSource::contact}, 1)[0].scenes[0];
  EXPECT_EQ(faces.contact.method, ContactMethod::pinball);
  EXPECT_EQ(faces.contact.gap, ContactGap::face);
}

TEST(ErrorSources, BodiesAreRefinedApart) {
  Scene scene = scene_at_speed(-5);
  scene.bodies[0].name = "rod";
  scene.bodies[0].mesh = BlockMesh{{1, 1, 1}, {2, 3, 4}, {}};
  scene.bodies[1].name = "plate";
  scene.bodies[1].mesh = BlockMesh{{1, 1, 1}, {5, 6, 7}, {}};
  const auto apart = vary_bodies(scene, {parse_refined_body("plate=3"), parse_refined_body("rod=2")});
  ASSERT_EQ(apart.size(), 2);
  EXPECT_EQ(apart[0].name, "plate 3 times finer");
  EXPECT_EQ(apart[0].what, "rod: elements 2 x 3 x 4; plate: elements 15 x 18 x 21");
  EXPECT_EQ(apart[1].what, "rod: elements 4 x 6 x 8; plate: elements 5 x 6 x 7");
  EXPECT_THAT(error_of([&] {
                vary_bodies(scene, {{"plat", 2}});
              }),
              HasSubstr("expected one of the bodies, nearest is plate"));
  scene.bodies[0].mesh = FileMesh{};
  scene.bodies[1].mesh = FileMesh{};
  EXPECT_THAT(error_of([&] {
                vary_bodies(scene, {{"rod", 2}});
              }),
              HasSubstr("expected a body with a file of its own, plate"));
  for (const char* text : {"=2", "rod=", "rod=1", "rod=x", "rod=1001", "rod"}) {
    EXPECT_THAT(error_of([&] { parse_refined_body(text); }), HasSubstr("expected a number, or BODY=K")) << text;
  }
}

TEST(ErrorSources, TheBodyThatMovesAQuantityIsTheOneToRefine) {
  ConvergenceStudy study;
  study.sources = {{ErrorSource::step, "time step", "", {}},
                   {ErrorSource::body, "rod 2 times finer", "", {}},
                   {ErrorSource::body, "plate 2 times finer", "", {}}};
  StudyQuantity quantity{"q", "", {}, 1, {}, {9.0, 0.01, -0.3}};
  EXPECT_EQ(body_to_refine(study, quantity), "refine plate, not rod");
  quantity.moved = {9.0, 0.2, -0.3};
  EXPECT_EQ(body_to_refine(study, quantity), "refine plate and rod");
  quantity.moved = {9.0, std::nullopt, -0.3};
  EXPECT_EQ(body_to_refine(study, quantity), "");
  quantity.moved = {9.0, 1e-9, 1e-12};
  EXPECT_EQ(body_to_refine(study, quantity), "");
}

TEST(ErrorSources, HalfTheStepAddsNoMass) {
  Scene scene = scene_at_speed(-5);
  EXPECT_EQ(vary_sources(scene, {ErrorSource::step}, 1)[0].what, "time.cfl = 0.45");
  scene.time.smallest_step = 0.25;
  const SourceVariation half = vary_sources(scene, {ErrorSource::step}, 1)[0];
  EXPECT_EQ(half.what, "time.cfl = 0.45, time.smallest_step = 0.125");
  const TimeSettings& time = half.scenes[0].time;
  EXPECT_EQ(time.smallest_step / time.cfl, scene.time.smallest_step / scene.time.cfl);  // by which elements have mass
}

TEST(ErrorSources, ChanceIsThatOfThePrecisionAndOfSceneAtRest) {
  Scene scene = scene_at_speed(0);
  const auto noise = [&] {
    return vary_sources(scene, {ErrorSource::chance}, 1)[0].scenes[0].bodies[0].velocity_noise;
  };
  EXPECT_DOUBLE_EQ(noise(), 1e-9 * 1e-3 * 2);
  scene.precision = Precision::float32;
  EXPECT_DOUBLE_EQ(noise(), 1e-5 * 1e-3 * 2);
  scene.initial_velocities.resize(1);
  scene.initial_velocities[0].velocity = {3, 0, 4};
  EXPECT_DOUBLE_EQ(noise(), 1e-5 * 5);
  const Scene moved = vary_sources(scene, {ErrorSource::chance}, 1)[0].scenes[0];
  EXPECT_DOUBLE_EQ(moved.initial_velocities[0].velocity[2], 4 * (1 + 1e-5));
}

/// Decks say a speed of 1, and the rest by their curves.
TEST(ErrorSources, ChanceIsThatOfTheLargestSpeedOfTables) {
  Scene scene = scene_at_speed(-5);
  const auto noise = [&] {
    return vary_sources(scene, {ErrorSource::chance}, 1)[0].scenes[0].bodies[0].velocity_noise / 1e-9;
  };
  const TimeTable table{{0, 1, 2}, {0, -30, 10}};
  PrescribedVelocity moved;
  moved.velocity = {0, 1, 0};
  moved.table = table;
  scene.prescribed_velocities = {moved};
  EXPECT_DOUBLE_EQ(noise(), 30);
  scene.prescribed_velocities[0].quantity = MotionQuantity::displacement;
  EXPECT_DOUBLE_EQ(noise(), 5);
  RigidWall& wall = scene.rigid_walls.emplace_back();
  wall.speed = -0.3;
  wall.table = table;
  EXPECT_DOUBLE_EQ(noise(), 9);
  RigidMotion motion;
  motion.speed = 0.5;
  motion.table = table;
  scene.rigid_motions = {motion};
  EXPECT_DOUBLE_EQ(noise(), 15);
}

TEST(ErrorSources, ChanceLeavesRigidBodiesRigid) {
  Scene scene = scene_at_speed(-5);
  scene.bodies[0].name = "plate";
  scene.bodies[1].name = "ball";
  scene.bodies[1].angular_velocity = {0, 2, 0};
  scene.rigid_bodies.resize(2);
  scene.rigid_bodies[0].bodies = {"ball"};
  scene.rigid_bodies[1].velocity = {0, 8, 0};
  scene.rigid_bodies[1].angular_velocity = {1, 0, 0};
  const Scene moved = vary_sources(scene, {ErrorSource::chance}, 2)[0].scenes[1];
  EXPECT_DOUBLE_EQ(moved.bodies[0].velocity_noise, 2 * 1e-9 * 8);
  EXPECT_EQ(moved.bodies[1].velocity_noise, 0);
  EXPECT_DOUBLE_EQ(moved.bodies[1].velocity[2], -5 * (1 + 2e-9));
  EXPECT_DOUBLE_EQ(moved.bodies[1].angular_velocity[1], 2 * (1 + 2e-9));
  EXPECT_DOUBLE_EQ((*moved.rigid_bodies[1].velocity)[1], 8 * (1 + 2e-9));
  EXPECT_DOUBLE_EQ((*moved.rigid_bodies[1].angular_velocity)[0], 1 + 2e-9);
}

/// Of one quantity, with a band of 9 to 12 around 10 on the mesh of the sources, moved by chance by so much.
ConvergenceStudy study_with(double by_step, double by_chance) {
  ConvergenceStudy study;
  study.scene = "scene";
  study.meshes.resize(3);
  study.sources = {{ErrorSource::step, "time step", "half", {}}, {ErrorSource::chance, "chance", "noise", {}}};
  study.sources_mesh = 1;
  StudyQuantity quantity;
  quantity.name = "depth";
  quantity.values = {11, 10, 10};
  GridConvergence convergence;
  convergence.verdict = Convergence::monotone;
  convergence.observed_order = 1;
  convergence.low = 9;
  convergence.high = 12;
  quantity.convergence = convergence;
  quantity.moved = {by_step, by_chance};
  quantity.mean_of_chance = 10.5;
  study.quantities = {quantity};
  return study;
}

TEST(SourcesReport, NamesTheLargest) {
  const auto largest = [](const ConvergenceStudy& study) { return largest_source(study, study.quantities[0]); };
  const ConvergenceStudy mesh = study_with(-1, 0.5);
  EXPECT_EQ(error_of_mesh(mesh, mesh.quantities[0]), 2);
  EXPECT_EQ(largest(mesh), "mesh");
  EXPECT_EQ(largest(study_with(-2.5, 0.5)), "time step");
  EXPECT_EQ(largest(study_with(-2.5, 3)), "chance");
  ConvergenceStudy spread = mesh;
  spread.quantities[0].convergence->verdict = Convergence::oscillating;
  EXPECT_EQ(error_of_mesh(spread, spread.quantities[0]), 3);
  spread.quantities[0].convergence.reset();
  EXPECT_EQ(largest(spread), "time step");
  spread.quantities[0].scale = 1.1e6;  // a component that is small beside the others
  EXPECT_EQ(largest(spread), "");
}

/// The mesh by 2, from 10 to 12, and what each of the others is worst in, chance by two deviations.
TEST(SourcesReport, AddsUpTheErrorsOfAllSources) {
  const auto together = [](const ConvergenceStudy& study) { return error_together(study, study.quantities[0]); };
  ConvergenceStudy study = study_with(-1, 0.5);
  EXPECT_EQ(together(study), 2 + 1 + 2 * 0.5);
  const auto add = [&study](ErrorSource source, const std::string& name, std::optional<double> moved) {
    study.sources.push_back({source, name, "", {}});
    study.quantities[0].moved.push_back(moved);
  };
  add(ErrorSource::hourglass, "hourglass viscous", 0.25);
  add(ErrorSource::hourglass, "hourglass stiffness", -0.5);
  add(ErrorSource::contact, "contact slideline", 0.125);
  add(ErrorSource::contact, "contact faces", std::nullopt);  // its run failed
  add(ErrorSource::body, "rod 2 times finer", 7);            // part of the mesh
  EXPECT_EQ(together(study), 4 + 0.5 + 0.125);
  add(ErrorSource::precision, "float", 64);  // of a run in double, which has not that error
  EXPECT_EQ(together(study), 4 + 0.5 + 0.125);
  study.sources.back().name = "double";
  EXPECT_EQ(together(study), 4 + 0.5 + 0.125 + 64);
  EXPECT_THAT(sources_text(study), HasSubstr("together"));
  study.quantities[0].convergence->verdict = Convergence::oscillating;
  EXPECT_FALSE(together(study));
}

TEST(SourcesReport, SaysWhereChanceIsMoreThanTheMesh) {
  EXPECT_THAT(sources_text(study_with(-1, 0.5)), Not(HasSubstr("chance decides")));
  const ConvergenceStudy study = study_with(-1, 2.5);
  EXPECT_TRUE(chance_rules(study, study.quantities[0]));
  EXPECT_THAT(sources_text(study), HasSubstr("depth: chance decides, 10.5 +- 2.5, more than the error of the mesh"));
  EXPECT_EQ(sources_sentence(study), "the largest source of error is: chance for 1");
  EXPECT_EQ(sources_text(ConvergenceStudy{}), "");
  ConvergenceStudy small = study;
  small.quantities[0].scale = 3e6;
  EXPECT_FALSE(chance_rules(small, small.quantities[0]));
}

}  // namespace
}  // namespace pinball::error_sources_test

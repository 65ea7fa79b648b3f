#include <gmock/gmock.h>

#include <cmath>

#include <solver/model/look/initial_motion.hpp>
#include <solver/model/model.hpp>
#include <solver/scene_rules.hpp>
#include <tests/support/look_case.hpp>
#include <tests/support/solver_case.hpp>

/// What is seen in a scene before the first step: what is meant by nobody is told, in one sentence; what is meant is
/// not.
namespace pinball::look_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Two cubes of 3 x 3 x 3 elements of size 1, a gap of 1 between them, for one unit of time.
Scene two_cubes(const Point& first, const Point& second = {}) {
  Scene scene = scene_of({block("a", {3, 3, 3}, 1, {0, 0, 0}, first), block("b", {3, 3, 3}, 1, {0, 0, 4}, second)}, 1);
  scene.contact.method = ContactMethod::not_set;
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  return scene;
}

TEST(LookAtContact, IsOnWhereBodiesMeet) {
  EXPECT_EQ(decided(two_cubes({0, 0, 10})), ContactMethod::pinball);
  EXPECT_THAT(look(two_cubes({0, 0, 10})).contact_because, HasSubstr("bodies a and b can meet"));
  EXPECT_THAT(look(two_cubes({0, 0, 10})).unlikely, IsEmpty());
  EXPECT_EQ(decided(two_cubes({0, 0, 0}, {0, 0, -1.1})), ContactMethod::pinball);
  EXPECT_EQ(decided(two_cubes({0, 0, 10}, {0, 0, 8})), ContactMethod::pinball);  // overtakes
}

TEST(LookAtContact, IsOffWhereTheyMoveAwayOrTogetherOrMissEachOther) {
  for (const Scene& scene : {two_cubes({0, 0, 0}), two_cubes({0, 0, -10}), two_cubes({0, 0, 0}, {0, 0, 10}),
                             two_cubes({7, 0, 10}, {7, 0, 10}), two_cubes({0, 0, 0.9}), two_cubes({100, 0, 10})}) {
    EXPECT_EQ(decided(scene), ContactMethod::none) << scene.bodies[0].velocity[2];
  }
  EXPECT_THAT(look(two_cubes({0, 0, -10})).contact_because, HasSubstr("contact is off"));
}

TEST(LookAtContact, OfOneBodyIsOff) {
  Scene scene = two_cubes({0, 0, 10});
  scene.bodies.pop_back();
  EXPECT_EQ(decided(scene), ContactMethod::none);
  EXPECT_EQ(look(scene).contact_because, "");
}

TEST(LookAtContact, FollowsGravityPrescribedMotionLoadsAndRebounds) {
  Scene falls = two_cubes({});
  falls.gravities.push_back({.acceleration = {0, 0, 3}, .table = {}, .bodies = {"a"}, .name = {}});
  EXPECT_EQ(decided(falls), ContactMethod::pinball);  // 1.5 in this time
  falls.gravities[0].acceleration = {0, 0, 1.9};
  EXPECT_EQ(decided(falls), ContactMethod::none);
  falls.gravities[0] = {.acceleration = {0, 0, 50}, .table = {}, .bodies = {}, .name = {}};
  EXPECT_EQ(decided(falls), ContactMethod::none);  // both fall

  Scene moved = two_cubes({});
  PrescribedVelocity given;
  given.nodes.body = "b";
  given.direction = Point{0, 0, 1};
  given.velocity = {0, 0, -2};
  moved.prescribed_velocities = {given};
  EXPECT_EQ(decided(moved), ContactMethod::pinball);
  moved.prescribed_velocities[0].velocity = {0, 0, 2};
  EXPECT_EQ(decided(moved), ContactMethod::none);
  moved.prescribed_velocities[0].velocity = {0, 0, -2};
  moved.prescribed_velocities[0].when.end = 0.4;
  EXPECT_EQ(decided(moved), ContactMethod::pinball);  // and coasts

  Scene loaded = two_cubes({});
  NodalLoad load;
  load.nodes.body = "a";
  load.force = {0, 0, 2.2 * 27 * 7850};
  loaded.loads = {load};
  EXPECT_EQ(decided(loaded), ContactMethod::pinball);
  loaded.loads[0].force[2] *= -1;
  EXPECT_EQ(decided(loaded), ContactMethod::none);

  Scene rebounds = two_cubes({0, 0, -10});
  rebounds.rigid_walls.emplace_back().plane.normal = {0, 0, 1};
  EXPECT_EQ(decided(rebounds), ContactMethod::pinball);
}

TEST(LookAtContact, OfWhatTurnsKnowsHowFarItReaches) {
  Scene scene = two_cubes({});
  scene.time.end = 100;
  scene.bodies[0].angular_velocity = {0, 0, 1};
  scene.bodies[1].position = {0, 0, 8};
  EXPECT_EQ(decided(scene), ContactMethod::none);
  scene.bodies[0].angular_velocity = {1, 0, 0};
  scene.bodies[1].position = {0, 0, 3.2};  // its corners come by
  EXPECT_EQ(decided(scene), ContactMethod::pinball);
  const double reach = 1.5 + 1.5 * std::sqrt(3.0);
  scene.bodies[1].position = {0, 0, reach - 0.05};
  EXPECT_EQ(decided(scene), ContactMethod::pinball);
  scene.bodies[1].position = {0, 0, reach + 0.05};
  EXPECT_EQ(decided(scene), ContactMethod::none);
}

/// Two cubes at the ends of one rigid body do not turn on the spot.
TEST(LookAtContact, ARigidBodyOfSeveralBeginsAsOne) {
  Scene scene = two_cubes({});
  scene.bodies[0].position = {-6, -1.5, -1.5};
  scene.bodies[1].position = {3, -1.5, -1.5};
  scene.rigid_bodies.emplace_back().bodies = {"a", "b"};
  scene.rigid_bodies[0].angular_velocity = Point{0, 0, 2};
  complete_scene(scene);
  const InitialMotion motion = initial_motions(scene, build_mesh(scene), {0, 0}, 1)[0];
  EXPECT_NEAR(motion.turning, 2, 1e-9);
  EXPECT_NEAR(motion.speed, 2 * std::hypot(6, 1.5), 1e-9);
  EXPECT_NEAR(motion.velocity.size(), 0, 1e-9);
}

/// What flies by the corner of the box around a slanted bar does not meet the bar.
TEST(LookAtContact, OfASlantedBodyIsOffBesideIt) {
  Scene scene = two_cubes({});
  scene.bodies[1].mesh = BlockMesh{{1, 1, 30}, {1, 1, 30}};
  scene.bodies[1].position = {0, 0, 0};
  scene.bodies[1].axis = {1, 0, 1};  // up to 21 along x and z
  scene.bodies[0].position = {16, 0, -10};
  scene.bodies[0].velocity = {0, 0, 12};
  EXPECT_EQ(decided(scene), ContactMethod::none);
  scene.bodies[0].velocity = {0, 0, 30};
  EXPECT_EQ(decided(scene), ContactMethod::pinball);
}

TEST(LookAtContact, TakesWhatIsTiedForOne) {
  Scene scene = two_cubes({0, 0, 10}, {0, 0, 10});
  scene.bodies[1].position = {0, 0, 3};
  scene.bodies[1].velocity = {0, 0, 0};
  scene.tied_contacts = {{.name = "glue", .first = {.bodies = {"a"}}, .second = {.bodies = {"b"}}}};
  EXPECT_EQ(decided(scene), ContactMethod::none);
  scene.bodies.push_back(block("c", {3, 3, 3}, 1, {20, 0, 0}));
  scene.tied_contacts[0].second.bodies = {"c"};
  EXPECT_EQ(decided(scene), ContactMethod::pinball);
}

TEST(LookAtContact, ThatASceneSaysStays) {
  Scene scene = two_cubes({0, 0, 10});
  for (const ContactMethod method : {ContactMethod::none, ContactMethod::slideline, ContactMethod::pinball}) {
    scene.contact.method = method;
    EXPECT_EQ(decided(scene), method);
    EXPECT_EQ(look(scene).contact_because, "");
    EXPECT_THAT(look(scene).unlikely, IsEmpty());
  }
}

TEST(LookAtContact, OfADeckThatSaysNothingIsOffAndTold) {
  Scene scene = two_cubes({0, 0, 10});
  scene.contact.method = ContactMethod::none;
  scene.of_deck = true;
  EXPECT_THAT(look(scene).unlikely, ElementsAre(HasSubstr("bodies a and b meet from time 0.09375 s on, and no card")));
  scene.bodies[0].velocity = {0, 0, -10};
  EXPECT_THAT(look(scene).unlikely, IsEmpty());
}

TEST(LookAtContact, TellsThatNothingEverMeets) {
  Scene scene = two_cubes({0, 0, -10});
  scene.contact.method = ContactMethod::pinball;
  EXPECT_THAT(look(scene).unlikely, ElementsAre(HasSubstr("no two of the 2 bodies can meet until time.end = 1 s")));
  Scene wall = two_cubes({0, 0, 10});
  wall.bodies.pop_back();
  wall.rigid_walls.emplace_back().plane = {{0, 0, -1}, {0, 0, 1}};
  EXPECT_THAT(look(wall).unlikely, ElementsAre(HasSubstr("no body can reach a rigid wall")));
  wall.bodies[0].velocity = {0, 0, -10};
  EXPECT_THAT(look(wall).unlikely, IsEmpty());
}

TEST(LookAtSpeeds, TellsAnImpactBeyondTheSpeedOfWaves) {
  Scene scene = two_cubes({0, 0, 25 * 6000});
  scene.time.end = 1e-4;
  const Look found = look(scene);
  EXPECT_THAT(found.unlikely,
              ElementsAre(HasSubstr("bodies a and b meet at 1.5e+05 m/s, 25 times the speed of waves")));
  EXPECT_EQ(found.cause, found.unlikely[0]);
  scene.bodies[0].velocity = {0, 0, -25 * 6000};
  scene.contact.method = ContactMethod::none;
  EXPECT_THAT(look(scene).unlikely, IsEmpty());  // it flies off
  Scene wall = scene;
  wall.bodies.pop_back();
  wall.rigid_walls.emplace_back().plane = {{0, 0, -1}, {0, 0, 1}};
  EXPECT_THAT(look(wall).unlikely, ElementsAre(HasSubstr("body a and a rigid wall meet")));
  wall.bodies.push_back(wall.bodies[0]);
  wall.bodies[1].name = "b";
  wall.bodies[1].position[0] += 100;
  EXPECT_THAT(look(wall).unlikely, ElementsAre(HasSubstr("body a and a rigid wall meet"))) << "one stands for all";
}

/// Of a scene with these units.
std::vector<std::string> of_material(const std::string& units, double density, double young) {
  Scene scene = two_cubes({});
  scene.bodies.pop_back();
  scene.units = units;
  Material& m = scene.materials[0];
  m.density = density;
  m.bulk_modulus = young / (3 * (1 - 2 * 0.3));
  m.shear_modulus = young / (2 * (1 + 0.3));
  return look(scene).unlikely;
}

TEST(LookAtMaterials, KnowsSolidsInTheUnitsOfTheScene) {
  for (const auto& [units, density, young] :
       std::vector<std::tuple<const char*, double, double>>{{"SI", 7850, 210e9},
                                                            {"g-mm-ms", 7.85e-3, 210e3},
                                                            {"tonne-mm-s", 2.7e-9, 70e3},
                                                            {"kg-mm-ms", 8.93e-6, 117},
                                                            {"g-cm-us", 19.3, 4.0},
                                                            {"in-lbf-s", 7.34e-4, 30e6},
                                                            {"cm-N-s", 7.85e-5, 2.1e7},
                                                            {"g-mm-ms", 1.1e-3, 5},     // rubber
                                                            {"g-mm-ms", 0.05e-3, 10},   // foam
                                                            {"g-mm-ms", 0.785, 210e3},  // mass scaled by hand
                                                            {"in-lbf-s", 0.01, 1000},   // of the report
                                                            {"", 1, 1},
                                                            {"none", 1, 100},
                                                            {"", 7850, 2.1e11},
                                                            {"", 7.85e-9, 2.1e5}}) {
    EXPECT_THAT(of_material(units, density, young), IsEmpty()) << units << ' ' << density << ' ' << young;
  }
}

TEST(LookAtMaterials, TellsThoseOfOtherUnits) {
  EXPECT_THAT(of_material("g-mm-ms", 7.85e-3, 2.1e11),
              ElementsAre(HasSubstr("its density is that of steel, its Young's modulus 1e+06 times as large")));
  EXPECT_THAT(of_material("g-mm-ms", 7850, 210e3),
              ElementsAre(HasSubstr("its Young's modulus is that of steel, its density 1e+06 times as large")));
  EXPECT_THAT(of_material("g-mm-ms", 7850, 2.1e11), ElementsAre(HasSubstr("both are those of steel in kg-m-s")));
  EXPECT_THAT(of_material("SI", 2.7e-9, 70e3), ElementsAre(HasSubstr("both are those of aluminium in tonne-mm-s")));
  EXPECT_THAT(of_material("tonne-mm-s", 7.85e-6, 210e3), ElementsAre(HasSubstr("1e+03 times")));
  EXPECT_THAT(of_material("in-lbf-s", 0.283, 30e6), ElementsAre(HasSubstr("beyond all solids")));
  EXPECT_THAT(of_material("", 7850, 210e3),
              ElementsAre(HasSubstr("of steel in kg-m-s, its Young's modulus in g-mm-ms")));
  EXPECT_THAT(of_material("", 0.283, 30e6), ElementsAre(HasSubstr("of steel in lb/in^3")));
}

/// A plate of so many layers, of a material that yields, that a cube strikes.
Scene struck_plate(int layers, bool plastic = true) {
  Scene scene = two_cubes({0, 0, 10});
  scene.bodies[1].mesh = BlockMesh{{8, 8, 1}, {8, 8, layers}};
  scene.materials = {plastic ? plastic_material("steel", 4e8, 0) : elastic_material()};
  return scene;
}

TEST(LookAtContact, TellsBodiesThatMeetAndThatNoPairNames) {
  Scene scene = two_cubes({0, 0, 10});
  scene.contact.method = ContactMethod::pinball;
  scene.contact_pairs = {{.name = "p", .first = {.bodies = {"a"}}}};
  EXPECT_THAT(
      look(scene).unlikely,
      ElementsAre(HasSubstr("bodies a and b meet from time 0.09375 s on, and no contact.pair lets them touch")));
  scene.contact_pairs[0].second.bodies = {"b"};
  EXPECT_THAT(look(scene).unlikely, IsEmpty());
}

TEST(LookAtContact, OfOneBodyInPiecesSaysThatThesePass) {
  Scene scene = two_cubes({0, 0, 10});
  scene.tied_contacts.clear();
  complete_scene(scene);
  ModelMesh mesh = build_mesh(scene);
  std::ranges::fill(mesh.body, 0);
  std::ranges::fill(mesh.body_of_node, 0);
  scene.bodies.pop_back();
  mesh.body_names.pop_back();
  const Look found = look_at(scene, mesh);
  EXPECT_EQ(scene.contact.method, ContactMethod::none);
  EXPECT_THAT(found.contact_because, HasSubstr("all 2 pieces of the mesh are one body"));
}

TEST(LookAtMotions, TellsDisplacementsThatBeginElsewhere) {
  Scene scene = two_cubes({0, 0, 0.1});
  PrescribedVelocity given;
  given.nodes.body = "a";
  given.velocity = {0, 0, 2};
  given.quantity = MotionQuantity::displacement;
  scene.prescribed_velocities = {given};
  EXPECT_THAT(look(scene).unlikely,
              ElementsAre(HasSubstr("its displacement is 2 where it begins, at time 0: nothing leaps")));
  scene.prescribed_velocities[0].table = {{0, 1}, {0, 1}};
  EXPECT_THAT(look(scene).unlikely, IsEmpty());
  scene.prescribed_velocities[0].when.start = 0.5;
  EXPECT_THAT(look(scene).unlikely, ElementsAre(HasSubstr("is 1 where it begins, at time 0.5")));
  given.when.end = 0.5;
  given.table = {{0, 1}, {0, 1}};
  scene.prescribed_velocities.push_back(given);
  EXPECT_THAT(look(scene).unlikely, IsEmpty()) << "it goes on";
  scene.prescribed_velocities = {};
}

TEST(LookAtMotions, TellsWhatNeverBegins) {
  Scene scene = two_cubes({0, 0, 0.1});
  FixedConstraint fixed;
  fixed.nodes.body = "a";
  fixed.directions = {{1, 0, 0}};
  fixed.when.start = 1;
  scene.fixed_constraints = {fixed};
  EXPECT_THAT(look(scene).unlikely, ElementsAre("constraint.0: it begins at 1, and the run ends at time.end = 1"));
  scene.fixed_constraints[0].when.start = 0.99;
  EXPECT_THAT(look(scene).unlikely, IsEmpty());
}

TEST(LookAtProbes, TellsAPointFarAway) {
  Scene scene = two_cubes({0, 0, 0.1});
  Probe probe;
  probe.name = "p";
  probe.point = {3, 3, 9};  // the last corner is at 7
  scene.probes = {probe};
  EXPECT_THAT(look(scene).unlikely, ElementsAre(HasSubstr("probe p: its point lies 2 m away from all bodies")));
  scene.probes[0].body = "a";
  EXPECT_THAT(look(scene).unlikely, ElementsAre(HasSubstr("6 m away from body a")));
  scene.probes[0].point = {3.01, 1.5, 1.5};
  EXPECT_THAT(look(scene).unlikely, IsEmpty());
}

std::vector<std::string> of_gravity(const std::string& units, double acceleration, double factor = 1) {
  Scene scene = two_cubes({0, 0, 0.1});
  scene.units = units;
  Gravity gravity{{0, -acceleration, 0}};
  if (factor != 1) gravity.table = {{0, 1}, {0, factor}};
  scene.gravities = {gravity};
  Look found = look(scene);
  std::erase_if(found.unlikely, [](const std::string& sentence) { return !sentence.starts_with("gravity"); });
  return found.unlikely;
}

TEST(LookAtGravity, TellsThatOfOtherUnits) {
  EXPECT_THAT(of_gravity("SI", 9810), ElementsAre("gravity 0: 9810 m/s^2 is 1000 times the acceleration on earth, "
                                                  "which has this number in mm/s^2"));
  EXPECT_THAT(of_gravity("tonne-mm-s", 9.81), ElementsAre(HasSubstr("0.001 times the acceleration on earth")));
  EXPECT_THAT(of_gravity("kg-mm-ms", 9.81), ElementsAre(HasSubstr("9.81 mm/ms^2 is 1000 times")));
  EXPECT_THAT(of_gravity("g-mm-ms", 9806.65), ElementsAre(HasSubstr("this number in mm/s^2")));
  EXPECT_THAT(of_gravity("in-lbf-s", 9.81), ElementsAre(HasSubstr("this number in m/s^2")));
  EXPECT_THAT(of_gravity("SI", 386.4), ElementsAre(HasSubstr("this number in in/s^2")));
  EXPECT_THAT(of_gravity("SI", 32.2), ElementsAre(HasSubstr("this number in ft/s^2")));
  EXPECT_THAT(of_gravity("SI", 1, 9810), ElementsAre(HasSubstr("this number in mm/s^2")));
}

TEST(LookAtGravity, LeavesOutTheEarthsLoadsOfManyTimesThatAndUnknownUnits) {
  for (const auto& [units, value] : {std::pair{"SI", 9.81},
                                     {"SI", 9.8},
                                     {"tonne-mm-s", 9810.0},
                                     {"g-mm-ms", 9.81e-3},
                                     {"in-lbf-s", 386.1},
                                     {"SI", 981.0},
                                     {"SI", 98.1},
                                     {"SI", 1.62},
                                     {"SI", 10000.0},
                                     {"SI", 0.0},
                                     {"", 9810.0},
                                     {"CGS", 981.0},
                                     {"SI", 2942.0}})
    EXPECT_THAT(of_gravity(units, value), IsEmpty()) << units << ' ' << value;
  EXPECT_THAT(of_gravity("SI", 9810, 1e-3), IsEmpty());
}

TEST(LookAtLayers, TellsAPlateOfOne) {
  EXPECT_THAT(look(struck_plate(1)).unlikely, ElementsAre(HasSubstr("body b has one layer of elements")));
  EXPECT_THAT(look(struck_plate(2)).unlikely, IsEmpty());
  EXPECT_THAT(look(struck_plate(1, false)).unlikely, IsEmpty());
  Scene bar = struck_plate(2);
  bar.bodies[0].mesh = BlockMesh{{1, 1, 3}, {1, 1, 5}};
  EXPECT_THAT(look(bar).unlikely, ElementsAre(HasSubstr("body a has one layer of elements")));
}

TEST(LookAtLayers, LeavesOutPlaneStrainAndWhatIsHeld) {
  Scene scene = struck_plate(1);
  for (const double z : {4.0, 5.0}) {
    PlaneConstraint plane;
    plane.point = {0, 0, z};
    plane.normal = {0, 0, 1};
    scene.constraints.push_back(plane);
  }
  EXPECT_THAT(look(scene).unlikely, IsEmpty());
  Scene held = struck_plate(1);
  FixedConstraint fixed;
  fixed.nodes.body = "b";
  fixed.directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  held.fixed_constraints = {fixed};
  EXPECT_THAT(look(held).unlikely, IsEmpty());
}

TEST(LookAtLayers, LeavesOutRigidBodies) {
  Scene scene = struck_plate(1);
  scene.rigid_bodies.emplace_back().bodies = {"b"};
  EXPECT_THAT(look(scene).unlikely, IsEmpty());
  scene.rigid_bodies[0].bodies = {"a"};
  EXPECT_THAT(look(scene).unlikely, ElementsAre(HasSubstr("body b has one layer of elements")));
}

}  // namespace
}  // namespace pinball::look_test

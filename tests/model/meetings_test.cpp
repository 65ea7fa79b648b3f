#include <gmock/gmock.h>

#include <cmath>

#include <solver/model/look/time_course.hpp>
#include <solver/model/model.hpp>
#include <solver/scene_rules.hpp>
#include <tests/support/look_case.hpp>
#include <tests/support/solver_case.hpp>

/// Contact that a scene leaves open is on wherever bodies may meet, however they come to do so.
namespace pinball::meetings_test {
namespace {

using namespace test;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr bool on = true, off = false;

bool contact_of(const Scene& scene) { return decided(scene) != ContactMethod::none; }

/// A cube a of size 1 above another one b, at rest, for so long.
Scene above(double gap, double end = 15) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.5, {0, 0, 1 + gap}), block("b", {2, 2, 2}, 0.5, {0, 0, 0})}, end);
  scene.contact.method = ContactMethod::not_set;
  return scene;
}
Scene rigid(Scene scene) {
  scene.rigid_bodies.emplace_back().bodies = {"a"};
  return scene;
}
/// Of all nodes of a.
PrescribedVelocity moved(const Point& velocity, const TimeSpan& when = {}) {
  PrescribedVelocity given;
  given.nodes.body = "a";
  given.velocity = velocity;
  given.when = when;
  return given;
}
RigidMotion shifted(const Point& direction, double speed, const TimeSpan& when = {}) {
  return {.rigid_body = "a", .direction = direction, .speed = speed, .axis = {}, .table = {}, .when = when};
}
RigidMotion turned(const Point& axis, double speed, const TimeSpan& when = {}) {
  return {.rigid_body = "a", .direction = {}, .axis = axis, .angular_speed = speed, .table = {}, .when = when};
}
Gravity falling(const Point& acceleration) { return {.acceleration = acceleration, .table = {}, .bodies = {"a"}}; }

TEST(Meetings, ABodyCoastsWhenItsMotionEnds) {
  Scene scene = above(1.2);
  scene.prescribed_velocities = {moved({0, 0, -0.2}, {0, 1})};
  EXPECT_EQ(contact_of(scene), on);
  EXPECT_THAT(look(scene).contact_because, HasSubstr("bodies a and b can meet from time 5.9"));
  scene.time.end = 5.9;
  EXPECT_EQ(contact_of(scene), off);
  scene.time.end = 15;
  scene.prescribed_velocities[0].velocity[2] *= -1;
  EXPECT_EQ(contact_of(scene), off);
  scene.prescribed_velocities = {moved({0, 0, -0.4}, {0, 1})};  // slows down to -0.04
  scene.prescribed_velocities[0].table = {{0, 1}, {1, 0.1}};
  EXPECT_EQ(contact_of(scene), off);
  scene.time.end = 26;  // 0.22 and 25 times 0.04
  EXPECT_EQ(contact_of(scene), on);
  scene.prescribed_velocities[0].quantity = MotionQuantity::displacement;
  scene.prescribed_velocities[0].table = {{0, 1, 2}, {0, 0.25, 0.25}};
  EXPECT_EQ(contact_of(scene), on) << "with -0.1";
  scene.prescribed_velocities[0].when.end = 2;
  EXPECT_EQ(contact_of(scene), off) << "with nothing";
}

TEST(Meetings, OfADeckThatCoastsIsTold) {
  Scene scene = above(1.2);
  scene.prescribed_velocities = {moved({0, 0, -0.2}, {0, 1})};
  scene.contact.method = ContactMethod::none;
  scene.of_deck = true;
  EXPECT_THAT(look(scene).unlikely, ElementsAre(HasSubstr("bodies a and b meet from time 5.9")));
}

TEST(Meetings, ARigidBodyCoastsWhenItsMotionEnds) {
  Scene scene = rigid(above(1.2));
  scene.rigid_motions = {shifted({0, 0, -1}, 0.2, {0, 1})};
  EXPECT_EQ(contact_of(scene), on);
  scene.rigid_motions[0].speed = -0.2;
  EXPECT_EQ(contact_of(scene), off);
}

TEST(Meetings, ABodyFallsWhenWhatHoldsItEnds) {
  Scene scene = above(0.2);
  scene.prescribed_velocities = {moved({}, {0, 1})};
  scene.gravities = {falling({0, 0, -0.02})};
  EXPECT_EQ(contact_of(scene), on);
  scene.prescribed_velocities[0].when.end = 14;
  EXPECT_EQ(contact_of(scene), off) << "for too short a time";
  scene.prescribed_velocities[0].when.end = INFINITY;
  EXPECT_EQ(contact_of(scene), off);
}

TEST(Meetings, ABodyHasItsOwnVelocityUntilItsMotionBegins) {
  Scene scene = above(0.2, 12);
  scene.bodies[0].velocity = {0, 0, -0.2};
  scene.prescribed_velocities = {moved({}, {8})};
  EXPECT_EQ(contact_of(scene), on);
  scene.prescribed_velocities[0].when.start = 0.5;
  EXPECT_EQ(contact_of(scene), off);
}

/// One motion begins where another one ends.
TEST(Meetings, WaysOfMotionsThatFollowEachOtherAddUp) {
  Scene scene = above(0.75, 2);
  scene.prescribed_velocities = {moved({0, 0, -0.5}, {0, 1}), moved({0, 0, -0.5}, {1})};
  EXPECT_EQ(contact_of(scene), on);
  scene.prescribed_velocities[1].velocity = {0, 0, 0.5};
  EXPECT_EQ(contact_of(scene), off);
}

TEST(Meetings, WhatAMotionOfAPartLeavesBehindMayGoOn) {
  Scene scene = above(1.2);
  scene.prescribed_velocities = {moved({0, 0, -0.2}, {0, 1})};
  scene.prescribed_velocities[0].nodes.plane = Plane{{0, 0, 3.2}, {0, 0, 1}};
  EXPECT_EQ(contact_of(scene), on);
  scene.time.end = 5;
  EXPECT_EQ(contact_of(scene), off);
}

TEST(Meetings, WhatIsTurnedAsGivenMayStrikeWhatIsBesideIt) {
  Scene scene = rigid(above(0.1));
  scene.rigid_motions = {turned({0, 1, 0}, 0.3)};
  EXPECT_EQ(contact_of(scene), on);
  scene.bodies[0].position[2] = 1.4;  // its corners reach 0.366 further than its faces
  EXPECT_EQ(contact_of(scene), off);
  scene.bodies[0].position[2] = 1.01;
  scene.rigid_motions[0].angular_speed = 0.002;
  EXPECT_EQ(contact_of(scene), on);
  scene.bodies[0].position[2] = 1.1;
  EXPECT_EQ(contact_of(scene), off) << "as little as that is";
  scene.rigid_motions[0] = turned({0, 1, 0}, 0.3, {0, 0.1});
  EXPECT_EQ(contact_of(scene), on) << "it turns on";
}

TEST(Meetings, OfADeckThatTurnsNothingIsTold) {
  Scene scene = rigid(above(0.1));
  scene.rigid_motions = {turned({0, 1, 0}, 0.3)};
  scene.contact.method = ContactMethod::none;
  scene.of_deck = true;
  EXPECT_THAT(look(scene).unlikely, IsEmpty()) << "it may turn clear of it";
}

TEST(Meetings, OfADeckWhatLeavesOrSlidesIsNotTold) {
  Scene scene = above(0);
  scene.contact.method = ContactMethod::none;
  scene.of_deck = true;
  for (const Point& velocity : {Point{0, 0, 1}, Point{0.01, 0, 0}, Point{0, 0, 0}}) {
    scene.bodies[0].velocity = velocity;
    EXPECT_THAT(look(scene).unlikely, IsEmpty());
  }
  scene.bodies[0].velocity = {0, 0, -0.01};
  EXPECT_THAT(look(scene).unlikely, ElementsAre(HasSubstr("bodies a and b meet from the start on")));
  scene.contact.method = ContactMethod::not_set;
  scene.bodies[0].velocity = {0.01, 0, 0};
  EXPECT_EQ(contact_of(scene), on);
}

TEST(Meetings, ForcesTurnWhatTheyPushAtOneSide) {
  Scene couple = above(0.1, 6);
  NodalLoad left;
  left.nodes.body = "a";
  left.nodes.plane = Plane{{0, 0, 0}, {1, 0, 0}};
  left.force = {0, 0, -0.03 * 7850};
  NodalLoad right = left;
  right.nodes.plane->point = {1, 0, 0};
  right.force[2] *= -1;
  couple.loads = {left, right};
  EXPECT_EQ(contact_of(couple), on);
  couple.loads[1].force[2] *= -1;
  couple.loads[0].force[2] *= -1;
  EXPECT_EQ(contact_of(couple), on);
  couple.loads[1] = couple.loads[0];
  couple.loads[1].nodes.plane->point = {1, 0, 0};
  couple.loads[0].force[2] = couple.loads[1].force[2] = 0.03 * 7850;
  EXPECT_EQ(contact_of(couple), off) << "upwards, both";
  couple.loads.pop_back();
  EXPECT_EQ(contact_of(couple), on) << "one of them";
  couple.bodies[0].position[2] = 3;
  couple.loads[0].nodes.plane = Plane{{0, 0, 4}, {0, 0, 1}};
  couple.loads[0].force = {0.05 * 7850, 0, 0};
  EXPECT_EQ(contact_of(couple), off) << "too far";
  couple.bodies[0].position[2] = 1.1;
  couple.loads[0].nodes.plane->point[2] = 2.1;
  EXPECT_EQ(contact_of(couple), on) << "along its top";
  couple = rigid(couple);
  EXPECT_EQ(contact_of(couple), on);
  couple.rigid_bodies[0].held_rotations = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(contact_of(couple), off);
}

/// Pulled at both ends a cube grows longer.
TEST(Meetings, ForcesAgainstEachOtherStrain) {
  Scene scene = above(0.1, 6);
  NodalLoad down;
  down.nodes.body = "a";
  down.nodes.plane = Plane{{0, 0, 1.1}, {0, 0, 1}};
  down.force = {0, 0, -0.1 * 7850};
  NodalLoad up = down;
  up.nodes.plane->point[2] = 2.1;
  up.force[2] *= -1;
  scene.loads = {down, up};
  EXPECT_EQ(contact_of(scene), on);
  EXPECT_EQ(contact_of(rigid(scene)), off);
  scene.loads = {up, up};
  EXPECT_EQ(contact_of(scene), off);
  scene.loads = {down, up};
  for (NodalLoad& load : scene.loads) load.nodes.plane.reset();
  EXPECT_EQ(contact_of(scene), off) << "each on all nodes";

  Scene pressed = above(0.1, 6);
  Pressure& pressure = pressed.pressures.emplace_back();
  pressure.faces.body = "a";
  pressure.pressure = 7850;
  EXPECT_EQ(contact_of(pressed), on) << "from all sides";
}

TEST(Meetings, PressureOnHalfAFaceTurns) {
  Scene scene = above(0.1, 8);
  Pressure& pressure = scene.pressures.emplace_back();
  pressure.faces.body = "a";
  pressure.faces.box = Box{{-0.1, -0.1, 1.0}, {0.6, 1.1, 1.2}};
  pressure.pressure = 0.05 * 7850;  // from below
  EXPECT_EQ(contact_of(scene), on);
  pressure.faces.box->high[0] = 1.1;
  EXPECT_EQ(contact_of(scene), off);
}

TEST(Meetings, ARigidBodyHasTheMassThatItIsGiven) {
  Scene scene = rigid(above(0.5));
  NodalLoad load;
  load.nodes.body = "a";
  load.force = {0, 0, -0.002};  // 0.225 times over its mass
  scene.loads = {load};
  scene.rigid_bodies[0].mass = 0.01;
  EXPECT_EQ(contact_of(scene), on);
  scene.rigid_bodies[0].mass = 0.5;
  EXPECT_EQ(contact_of(scene), off);
  scene.rigid_bodies[0].mass = 0;
  EXPECT_EQ(contact_of(scene), off);
}

/// A stroke of a 140th of the run and back.
TEST(Meetings, ShortStrokesAreSeen) {
  Scene scene = above(0.2, 128);
  scene.prescribed_velocities = {moved({0, 0, -0.3})};
  scene.prescribed_velocities[0].quantity = MotionQuantity::displacement;
  scene.prescribed_velocities[0].table = {{0, 3.05, 3.5, 3.95}, {0, 0, 1, 0}};
  EXPECT_EQ(contact_of(scene), on);
  scene.prescribed_velocities[0].nodes.plane = Plane{{0, 0, 2.2}, {0, 0, 1}};
  EXPECT_EQ(contact_of(scene), on);
  scene.prescribed_velocities[0].velocity[2] = -0.1;
  EXPECT_EQ(contact_of(scene), off);

  Scene quick = above(0.1, 128);  // turns back between two points of its table
  quick.prescribed_velocities = {moved({0, 0, -0.6})};
  quick.prescribed_velocities[0].table = {{0, 3, 3.02, 3.98, 4}, {0, 0, 1, -1, 0}};
  EXPECT_EQ(contact_of(quick), on);

  Scene tool = rigid(above(0.2, 128));
  tool.rigid_motions = {shifted({0, 0, -1}, 0.3)};
  tool.rigid_motions[0].quantity = MotionQuantity::displacement;
  tool.rigid_motions[0].table = {{0, 3.05, 3.5, 3.95}, {0, 0, 1, 0}};
  EXPECT_EQ(contact_of(tool), on);
}

/// More points than times: the one stroke among them is not left out.
TEST(Meetings, StrokesOfLongTablesAreSeen) {
  Scene scene = above(0.2, 1);
  scene.prescribed_velocities = {moved({0, 0, -0.3})};
  PrescribedVelocity& given = scene.prescribed_velocities[0];
  given.quantity = MotionQuantity::displacement;
  for (int i = 0; i <= 20'000; ++i) {
    given.table.times.push_back(i / 20'000.0);
    given.table.factors.push_back(i % 2 == 0 ? 0.0 : 0.1);
  }
  EXPECT_EQ(contact_of(scene), off);
  EXPECT_LT(look_times(scene, 2).size(), 5000u);
  for (const std::size_t i : {7001, 7002, 7003, 7004, 7005, 7006}) {
    Scene one = scene;
    one.prescribed_velocities[0].table.factors[i] = 1;
    EXPECT_EQ(contact_of(one), on) << i;
  }
}

TEST(Meetings, ATieHoldsWhatItTiesAndWhileItDoes) {
  Scene scene = above(0, 6);
  scene.prescribed_velocities = {moved({0, 0, -0.02})};
  scene.tied_contacts = {{.name = "t", .first = {.bodies = {"b"}}, .second = {.bodies = {"a"}}}};
  scene.prescribed_velocities[0].nodes.plane = Plane{{0, 0, 2}, {0, 0, 1}};
  EXPECT_EQ(contact_of(scene), off);
  scene.tied_contacts[0].end = 2;
  EXPECT_EQ(contact_of(scene), on);
  scene.tied_contacts[0].end = 6;
  EXPECT_EQ(contact_of(scene), off);
  scene.tied_contacts[0].start = 1;
  EXPECT_EQ(contact_of(scene), on);
  scene.tied_contacts[0].start = 0;
  scene.bodies[0].position[2] = 1.1;  // beyond its tolerance
  scene.prescribed_velocities[0].nodes.plane->point[2] = 2.1;
  EXPECT_EQ(contact_of(scene), on);
  scene.tied_contacts[0].tolerance = 0.2;
  EXPECT_EQ(contact_of(scene), off);
}

TEST(Meetings, AGuideThatIsAskewLeadsAside) {
  Scene rail = above(0.3);  // a below and to the left of b
  rail.bodies[0].position = {0, 0, 0};
  rail.bodies[1].position = {1.3, 0, 1.3};
  rail.gravities = {falling({0.04, 0, 0})};
  EXPECT_EQ(contact_of(rail), off) << "it falls past";
  Scene tool = rigid(rail);
  tool.rigid_motions = {shifted({std::sqrt(0.5), 0, -std::sqrt(0.5)}, 0)};
  EXPECT_EQ(contact_of(tool), on);
  Scene one = rail;
  one.prescribed_velocities = {moved({})};
  one.prescribed_velocities[0].direction = Point{std::sqrt(0.5), 0, -std::sqrt(0.5)};
  EXPECT_EQ(contact_of(one), on);
  one.prescribed_velocities[0].direction = Point{0, 0, 1};
  EXPECT_EQ(contact_of(one), off);
  Scene round = rail;
  FixedConstraint& fixed = round.fixed_constraints.emplace_back();
  fixed.nodes.body = "a";
  fixed.directions = {{1, 0, 0}};
  fixed.frame = Frame::cylindrical;
  fixed.axis = {{10, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(contact_of(round), on);
}

TEST(TimeCourses, IntegrateATable) {
  const TimeTable table{{1, 2, 4}, {0, 2, 0}};
  const std::vector<double> times{0, 0.5, 1.5, 2, 3, 5};
  const TimeCourse course = time_course(table, times);
  for (std::size_t j = 0; j < times.size(); ++j) {
    EXPECT_NEAR(course.value[j], table.value(times[j]), 1e-12);
    EXPECT_NEAR(course.first[j], table.integral(times[j]), 1e-12);
    EXPECT_NEAR(course.second[j], table.second_integral(times[j]), 1e-12);
  }
  EXPECT_THAT(time_course({}, {-1, 0, 2}).second, ElementsAre(0, 0, 2));
}

TEST(TimeCourses, KnowHowFarAMotionGoesBetweenTimes) {
  PrescribedVelocity given = moved({0, 0, 1}, {1, 7});
  given.table = {{0, 2, 3, 8}, {0, 0, 4, -6}};  // goes to 6 at 5, and back to 2 at 7
  const MotionCourse course = course_of(given, {0, 2, 6, 8});
  EXPECT_THAT(course.way, ElementsAre(0, 0, DoubleNear(5, 1e-9), DoubleNear(2, 1e-9)));
  EXPECT_THAT(course.high, ElementsAre(0, 0, DoubleNear(6, 1e-9), DoubleNear(5, 1e-9)));
  EXPECT_THAT(course.rate, ElementsAre(0, 0, DoubleNear(-2, 1e-9), DoubleNear(-4, 1e-9)));
  EXPECT_EQ(course.from, 1);
  EXPECT_EQ(course.to, 7);
}

}  // namespace
}  // namespace pinball::meetings_test

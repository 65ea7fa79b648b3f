#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include <solver/program/commands.hpp>
#include <tests/support/folder_case.hpp>

/// What `pinball info` says of what holds, moves and loads bodies: with the units of what was given.
namespace pinball::info_boundary_test {
namespace {

using testing::HasSubstr;

class InfoBoundary : public test::FolderTest {
 protected:
  std::string info_of(const std::string& tables) const {
    const std::string path = folder_ / "scene.toml";
    std::ofstream(path) << R"(units = "kg-m-s"
time.end = 1e-4
[[material]]
name = "steel"
model = "elastic"
density = 7800.0
young_modulus = 2.0e11
poisson_ratio = 0.3
[[body]]
name = "cube"
material = "steel"
mesh = { type = "block", size = [0.1, 0.1, 0.1], elements = [1, 1, 1] }
)" << tables;
    InfoOptions options;
    options.scene = path;
    testing::internal::CaptureStdout();
    info_command(options);
    return testing::internal::GetCapturedStdout();
  }

  std::string moved(const std::string& quantity) const {
    return info_of("[[prescribed_velocity]]\nbody = \"cube\"\nvelocity = [0.0, 0.0, 3.0]\n" + quantity);
  }
};

TEST_F(InfoBoundary, GivesAPrescribedMotionAsWhatItIs) {
  EXPECT_THAT(moved(""), HasSubstr("prescribed velocity (0, 0, 3) m/s of 8 nodes"));
  EXPECT_THAT(moved("quantity = \"displacement\"\n"), HasSubstr("prescribed displacement (0, 0, 3) m of 8 nodes"));
  EXPECT_THAT(moved("quantity = \"acceleration\"\n"), HasSubstr("prescribed acceleration (0, 0, 3) m/s^2 of 8 nodes"));
}

TEST_F(InfoBoundary, GivesTheNodesThatGoWithARigidBody) {
  EXPECT_THAT(info_of("[[rigid_body]]\nname = \"r\"\n[[rigid_nodes]]\nrigid_body = \"r\"\n"
                      "plane = { point = [0.1, 0.0, 0.0], normal = [1.0, 0.0, 0.0] }\n"),
              HasSubstr("with rigid body r: 4 nodes on the plane through (0.1, 0, 0)"));
}

TEST_F(InfoBoundary, GivesTheMotionOfARigidBodyAsWhatItIs) {
  const auto rigid = [this](const std::string& motion) {
    return info_of("[[rigid_body]]\nname = \"r\"\nbodies = [\"cube\"]\n[[rigid_motion]]\nrigid_body = \"r\"\n" +
                   motion);
  };
  const std::string along = "direction = [0.0, 0.0, 1.0]\nspeed = 3.0\n", about = "axis = [0.0, 0.0, 1.0]\n";
  EXPECT_THAT(rigid(along), HasSubstr("moves along (0, 0, 1) with velocity 3 m/s (constant)"));
  EXPECT_THAT(rigid(along + "quantity = \"displacement\"\ntimes = [0.0, 1.0]\nfactors = [0.0, 1.0]\n"),
              HasSubstr("moves along (0, 0, 1) with displacement 3 m (2 points in time)"));
  EXPECT_THAT(rigid(about + "angular_speed = 2.0\nstart = 1e-5\n"),
              HasSubstr("turns about (0, 0, 1) with velocity 2 rad/s (constant, from time 1e-05 s)"));
  EXPECT_THAT(rigid(about + "angular_speed = 2.0\nquantity = \"displacement\"\n"),
              HasSubstr("turns about (0, 0, 1) with displacement 2 rad (constant)"));
}

TEST_F(InfoBoundary, SaysWhatItActsOnAlongWhatAndFromWhenOn) {
  EXPECT_THAT(info_of("[[constraint]]\ntype = \"fixed\"\nbody = \"cube\"\ndirections = [\"z\"]\n"),
              HasSubstr("fixed: 8 nodes of body cube along (0, 0, 1)\n"));
  EXPECT_THAT(info_of("[[gravity]]\nacceleration = [0.0, 0.0, -9.81]\nbodies = [\"cube\"]\n"),
              HasSubstr("gravity: (0, 0, -9.81) m/s^2 of cube (constant)"));
  EXPECT_THAT(info_of("[[pressure]]\nbody = \"cube\"\npressure = 5.0\nstart = 1e-5\n"),
              HasSubstr("5 Pa on 6 faces of body cube (constant, from time 1e-05 s)"));
  EXPECT_THAT(info_of("[[load]]\nbody = \"cube\"\nforce = [1.0, 0.0, 0.0]\neach = true\n"),
              HasSubstr("load: (1, 0, 0) N on each of 8 nodes of body cube (constant)"));
  EXPECT_THAT(info_of("[damping]\nmass = 2.0\n"), HasSubstr("damping: 2 1/s times mass and velocity"));
  EXPECT_THAT(
      info_of("[[initial_velocity]]\nbody = \"cube\"\nangular_velocity = [0.0, 0.0, 3.0]\ncomponents = [\"x\"]\n"),
      HasSubstr("initial velocity: (0, 0, 0) m/s along x of 8 nodes of body cube, turning with (0, 0, 3) 1/s "
                "about (0, 0, 0) m"));
  EXPECT_THAT(info_of("[[rigid_wall]]\nname = \"w\"\nnormal = [0.0, 0.0, 1.0]\nmass = 2.0\nspeed = 3.0\n"),
              HasSubstr(", pushed with its mass 2 kg, at first velocity 3 m/s"));
  EXPECT_THAT(info_of("[[rigid_wall]]\nname = \"w\"\nnormal = [0.0, 0.0, 1.0]\nspeed = 3.0\n"),
              HasSubstr(", moves with velocity 3 m/s (constant)"));
  EXPECT_THAT(info_of("[[rigid_wall]]\nname = \"w\"\npoint = [7.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\n"
                      "edge = [0.0, 1.0, 0.0]\nsize = [2.0, 0.0]\n"),
              HasSubstr("through (7, 0, 0) m, free side along (0, 0, 1), 2 x 0 m from there, the first along (0, 1, 0) "
                        "(0: without end)"));
}

TEST_F(InfoBoundary, GivesAllOfTheVelocityThatABodyBeginsWith) {
  EXPECT_THAT(info_of("velocity = [1, 0, 2]\n"), HasSubstr("    velocity (1, 0, 2) m/s\n"));
  EXPECT_THAT(info_of("angular_velocity = [0, 0, 50]\nvelocity_gradient = [[1, 0, 0], [0, 2, 0], [0, 0, 3]]\n"
                      "velocity_noise = 3\n"),
              HasSubstr("    velocity (0, 0, 0) m/s, turning with (0, 0, 50) 1/s, with a gradient of rows (1, 0, 0), "
                        "(0, 2, 0), (0, 0, 3) 1/s, noise of up to 3 m/s\n"));
}

TEST_F(InfoBoundary, SaysThatBodiesMayTouchThemselvesWhereAllTouchesAll) {
  const std::string contact = "[contact]\nmethod = \"pinball\"\n";
  EXPECT_THAT(info_of(contact), HasSubstr("bodies may touch themselves"));
  EXPECT_THAT(info_of(contact + "[[contact.pair]]\nname = \"p\"\nfirst = \"cube\"\nsecond = \"cube\"\n"),
              testing::Not(HasSubstr("bodies may touch themselves")));
}

TEST_F(InfoBoundary, SaysWhenAPairMayTouch) {
  EXPECT_THAT(info_of("[[contact.pair]]\nname = \"p\"\nfirst = \"cube\"\nstart = 1e-5\nend = 5e-5\n"),
              HasSubstr("of its first side alone, from time 1e-05 s, up to time 5e-05 s\n"));
}

}  // namespace
}  // namespace pinball::info_boundary_test

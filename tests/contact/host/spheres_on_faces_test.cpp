#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <solver/contact/embedded_contact.hpp>

/// Spheres of any size on the surfaces of elements, by springs: with what an instance does unless it is told otherwise.
namespace pinball::spheres_on_faces_test {
namespace {

using Vector = std::array<double, 3>;
using Shape = std::function<Vector(const Vector&)>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector times(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
Vector sum(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

constexpr double modulus = 1e4, light = 1e-2;

/// A block of cubes of edge 1, heavy and in the shape that a function gives it, and a light sphere.
class SphereAndBlock {
 public:
  SphereAndBlock(const std::array<int, 3>& cubes, const Shape& shape, double radius)
      : radius_(radius), modulus_(static_cast<std::size_t>(cubes[0] * cubes[1] * cubes[2]), modulus) {
    const auto node = [&](int x, int y, int z) { return (z * (cubes[1] + 1) + y) * (cubes[0] + 1) + x; };
    for (int z = 0; z <= cubes[2]; ++z) {
      for (int y = 0; y <= cubes[1]; ++y) {
        for (int x = 0; x <= cubes[0]; ++x) {
          add(shape({x - 0.5 * cubes[0], y - 0.5 * cubes[1], static_cast<double>(z - cubes[2])}), 1e6);
        }
      }
    }
    for (int z = 0; z < cubes[2]; ++z) {
      for (int y = 0; y < cubes[1]; ++y) {
        for (int x = 0; x < cubes[0]; ++x) {
          for (const int k : {0, 1}) {
            for (const auto& [i, j] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
              corners_.push_back(node(x + i, y + j, z + k));
            }
          }
        }
      }
    }
    sphere_ = static_cast<std::int32_t>(mass_.size());
    add({0, 0, 0}, light);
    options.threads = 1;
    options.log_user = &told;
    options.log = [](void* user, int level, const char* message) {
      if (level == PINBALL_CONTACT_WARNING) static_cast<std::vector<std::string>*>(user)->emplace_back(message);
    };
  }

  /// Lets the sphere go, for some steps; look is asked after each of them.
  void run(const Vector& from, const Vector& moving, double dt, int steps, const std::function<void()>& look) {
    position.back() = from;
    velocity.back() = moving;
    pinball_contact_mesh mesh = contact_mesh();
    mesh.node_count = sphere_ + 1;
    mesh.mass = mass_.data();
    mesh.element_count = static_cast<std::int64_t>(modulus_.size());
    mesh.corners = corners_.data();
    mesh.bulk_modulus = modulus_.data();
    mesh.sphere_count = 1;
    mesh.sphere_node = &sphere_;
    mesh.sphere_radius = &radius_;
    mesh.sphere_bulk_modulus = &modulus;
    EmbeddedContact contact(options, mesh, interleaved(position[0].data()));
    pinball_contact_arrays arrays = contact_arrays();
    arrays.position = interleaved(position[0].data());
    arrays.velocity = interleaved(velocity[0].data());
    arrays.force = interleaved_sums(force_[0].data());
    for (int i = 0; i < steps; ++i) {
      for (Vector& f : force_) f = {0, 0, 0};
      if (i == erodes_at) arrays.alive = alive.data();
      contact.update(arrays, i == 0 ? 0 : dt);
      result = contact.add_forces(arrays, dt);
      force_.back() = sum(force_.back(), times(light, gravity));
      for (std::size_t n = 0; n < mass_.size(); ++n) {
        velocity[n] = sum(velocity[n], times((i == 0 ? 0.5 : 1.0) * dt / mass_[n], force_[n]));
        position[n] = sum(position[n], times(dt, velocity[n]));
      }
      look();
    }
  }
  const Vector& at() const { return position.back(); }
  double speed() const { return std::sqrt(dot(velocity.back(), velocity.back())); }

  pinball_contact_options options = contact_options();
  pinball_contact_result result{};
  Vector gravity{0, 0, 0};
  std::vector<Vector> position, velocity;
  std::vector<std::string> told;
  std::vector<std::uint8_t> alive;  ///< of the elements, from a step on
  int erodes_at = -1;

 private:
  void add(const Vector& x, double heavy) {
    position.push_back(x);
    velocity.push_back({0, 0, 0});
    force_.push_back({0, 0, 0});
    mass_.push_back(heavy);
  }
  double radius_;
  std::vector<Vector> force_;
  std::vector<double> mass_, modulus_;
  std::vector<std::int32_t> corners_;
  std::int32_t sphere_ = 0;
};

/// p2 of a sphere and a cube of edge 1.
double stiffness(double radius) { return 0.5 * modulus * (std::cbrt(3 / (4 * M_PI)) + radius); }

const std::vector<double> radii{0.005, 0.01, 0.02, 0.05, 0.08, 0.0867, 0.1, 0.2, 0.5, 1.0, 2.0};

/// Over a node, an edge and the middle of a face, and anywhere.
std::vector<Vector> places(int random) {
  std::vector<Vector> all{{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0.5, 0.5, 0}, {1, 1, 0}, {1e-9, -1e-9, 0}};
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  for (int i = 0; i < random; ++i) all.push_back({anywhere(generator), anywhere(generator), 0});
  return all;
}

/// A rotation, with the axis z to where floors look.
Shape turned(double about_x, double about_y) {
  return [=](const Vector& p) {
    const double cx = std::cos(about_x), sx = std::sin(about_x), cy = std::cos(about_y), sy = std::sin(about_y);
    const Vector q{p[0], cx * p[1] - sx * p[2], sx * p[1] + cx * p[2]};
    return Vector{cy * q[0] + sy * q[2], q[1], -sy * q[0] + cy * q[2]};
  };
}

/// Faces of the rim of a plate look far along it, where its flat sides do not look as far up.
TEST(SpheresOnFaces, PassOverPlatesOfFlatElementsThatTheyDoNotTouch) {
  for (const Shape& turn : {turned(0, 0), turned(0.4, -0.7)}) {
    for (const double height : {0.11, 0.2, 0.3, 0.6, 0.9}) {
      for (const Vector& from : {Vector{-6, 0, height}, {-6, 4.9, height}, {-6, -6.1, height}}) {
        SphereAndBlock scene(
            {5, 5, 1},
            [&](const Vector& p) {
              return turn({2 * p[0], 2 * p[1], 0.5 * p[2]});
            },
            0.1);
        const Vector moving = turn(from[1] < -6 ? Vector{0.7, 0.7, 0} : Vector{1, 0, 0});
        scene.run(turn(from), moving, 0.1, 130, [&] { ASSERT_EQ(scene.result.pairs, 0) << height; });
        EXPECT_NEAR(dot(scene.velocity.back(), moving), dot(moving, moving), 1e-12) << height;
      }
    }
  }
}

/// Without damping it leaves as fast as it came, straight or aslant, wherever it meets the floor, and keeps its
/// velocity along it. The fast ones go in with their centres: deeper than their radius.
TEST(SpheresOnFaces, AreThrownBackByFloorsWhereverTheyMeetThem) {
  for (const Shape& turn : {turned(0, 0), turned(0.4, -0.7)}) {
    for (const double radius : radii) {
      for (const double speed : {0.5, 2.0, 20.0}) {
        for (const Vector& place : places(6)) {
          for (const double along : {0.0, 0.3}) {
            SphereAndBlock scene({4, 4, 1}, turn, radius);
            scene.options.damping = 0;
            const double period = 2 * M_PI * std::sqrt(light / stiffness(radius)), dt = 0.01 * period;
            const Vector up = turn({0, 0, 1});
            double deepest = 0;
            scene.run(turn(sum(place, {0, 0, radius + 1e-6})), turn({along * speed, 0, -speed}), dt, 100,
                      [&] { deepest = std::max(deepest, radius - dot(up, scene.at())); });
            ASSERT_NEAR(deepest, speed / (2 * M_PI / period), 0.02 * speed / (2 * M_PI / period));
            ASSERT_NEAR(dot(up, scene.velocity.back()), speed, 0.02 * speed)
                << radius << " at " << place[0] << ", " << place[1] << " with " << speed;
            ASSERT_NEAR(dot(turn({1, 0, 0}), scene.velocity.back()), along * speed, 1e-6 * speed);
            ASSERT_NEAR(dot(turn({0, 1, 0}), scene.velocity.back()), 0, 1e-6 * speed);
            ASSERT_EQ(scene.result.pairs, 0);
            ASSERT_NEAR(scene.result.dissipated, 0, 1e-9 * light * speed * speed);
            ASSERT_TRUE(scene.told.empty()) << scene.told[0];
          }
        }
      }
    }
  }
}

/// Under its weight, with the damping of the defaults, as deep as the spring needs to carry it.
TEST(SpheresOnFaces, RestOnFloors) {
  for (const Shape& turn : {turned(0, 0), turned(0.4, -0.7)}) {
    for (const double radius : radii) {
      for (const Vector& place : places(4)) {
        SphereAndBlock scene({4, 4, 1}, turn, radius);
        const double weight = 10 * light;
        scene.gravity = times(-10, turn({0, 0, 1}));
        const double period = 2 * M_PI * std::sqrt(light / stiffness(radius));
        scene.run(turn(sum(place, {0, 0, radius + 1e-6})), {0, 0, 0}, 0.02 * period, 1500, [&] {
          ASSERT_GT(dot(turn({0, 0, 1}), scene.at()), radius - 0.01);
        });
        EXPECT_EQ(scene.result.pairs, 1) << radius;
        EXPECT_NEAR(radius - dot(turn({0, 0, 1}), scene.at()), weight / stiffness(radius),
                    0.02 * weight / stiffness(radius));
        EXPECT_LT(scene.speed(), 1e-3);
      }
    }
  }
}

/// A sphere that slides over edges and nodes of a flat floor keeps its height and its speed.
TEST(SpheresOnFaces, SlideOverEdgesAndNodes) {
  for (const double radius : {0.01, 0.1, 0.5, 2.0}) {
    for (const Vector& along : {Vector{1, 0, 0}, {0.6, 0.8, 0}, {M_SQRT1_2, M_SQRT1_2, 0}}) {
      SphereAndBlock scene({8, 8, 1}, turned(0, 0), radius);
      scene.options.damping = 0;
      scene.gravity = {0, 0, -10};
      const double carried = 10 * light / stiffness(radius);
      double highest = -1, lowest = 1;
      // It begins just above the surface and so swings between that and twice as deep as it would rest.
      scene.run(sum(times(-3, along), {0, 0, radius + 1e-9}), times(5, along), 2e-4, 6000, [&] {
        highest = std::max(highest, scene.at()[2] - radius);
        lowest = std::min(lowest, scene.at()[2] - radius);
      });
      EXPECT_LT(highest, 0.05 * carried) << radius;
      EXPECT_GT(lowest, -2.05 * carried) << radius;
      EXPECT_NEAR(dot(scene.velocity.back(), along), 5, 1e-7);
      EXPECT_NEAR(scene.result.dissipated, 0, 1e-3 * light * 10 * carried);
    }
  }
}

/// A cube that is a ball: the surface between its nodes lies within it, by some part of the elements.
Vector ball(const Vector& p) {
  const Vector q{p[0], p[1], p[2] + 2};  // 4 x 4 x 4 cubes around the origin
  const double largest = std::max({std::abs(q[0]), std::abs(q[1]), std::abs(q[2])});
  const double size = std::sqrt(dot(q, q));
  return size > 0 ? times(largest / size, q) : q;
}

TEST(SpheresOnFaces, AreThrownBackByBalls) {
  std::mt19937 generator(3);
  std::normal_distribution<double> any(0, 1);
  for (const double radius : radii) {
    for (int i = 0; i < 14; ++i) {
      Vector from{any(generator), any(generator), any(generator)};
      if (i < 3) from = {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};  // right onto a node
      if (i == 3) from = {1, 1, 1};
      from = times(1 / std::sqrt(dot(from, from)), from);
      SphereAndBlock scene({4, 4, 4}, ball, radius);
      scene.options.damping = 0;
      const double period = 2 * M_PI * std::sqrt(light / stiffness(radius));
      double nearest = 9;
      // Its own distance from the surface is not more than that from the round ball and what the faces lie within it.
      scene.run(times(2 + radius, from), times(-2, from), 0.01 * period, 150 + static_cast<int>(0.5 / (0.02 * period)),
                [&] { nearest = std::min(nearest, std::sqrt(dot(scene.at(), scene.at()))); });
      EXPECT_GT(nearest, 2 + radius - 0.3 - 0.02) << radius << ", " << i;
      EXPECT_GT(std::sqrt(dot(scene.at(), scene.at())), 2 + radius - 0.3) << radius << ", " << i;
      const double motion = 0.5 * light * scene.speed() * scene.speed(), before = 0.5 * light * 4;
      EXPECT_NEAR(motion + scene.result.dissipated, before, 0.02 * before) << radius << ", " << i;
      EXPECT_NEAR(scene.speed(), 2, 0.06) << radius << ", " << i;
    }
  }
}

/// In a bowl of flat and warped faces a sphere touches several, and rolls from one to the next for long.
TEST(SpheresOnFaces, StayInABowl) {
  const Shape bowl = [](const Vector& p) {
    const double h = 0.08 * (p[0] * p[0] + p[1] * p[1]) + 0.1 * std::sin(3 * p[0]) * std::cos(2 * p[1]);
    return Vector{p[0], p[1], p[2] + h};
  };
  for (const double radius : radii) {
    for (const double damping : {0.0, 0.1}) {
      SphereAndBlock scene({8, 8, 1}, bowl, radius);
      scene.options.damping = damping;
      scene.gravity = {0, 0, -10};
      const double start = bowl({2.3, 1.1, 0})[2] + radius + 0.3;
      double highest = -9;
      bool through = false;
      scene.run({2.3, 1.1, start}, {0, 0, 0}, 2e-4, 8000, [&] {
        const Vector& x = scene.at();
        highest = std::max(highest, x[2] + 0.5 * dot(scene.velocity.back(), scene.velocity.back()) / 10);
        // Faces lie up to 0.12 beside the function.
        through = through || x[2] < bowl({x[0], x[1], 0})[2] + std::min(radius, 0.1) - 0.25;
      });
      EXPECT_FALSE(through) << radius << ", " << damping;
      EXPECT_LT(highest, start + 0.02) << radius << ", " << damping << ": as high as it began, with its motion";
    }
  }
}

/// The upper one of two layers goes: the sphere falls onto the lower one.
TEST(SpheresOnFaces, FollowErosion) {
  for (const double radius : {0.02, 0.3}) {
    SphereAndBlock scene({3, 3, 2}, turned(0, 0), radius);
    scene.gravity = {0, 0, -10};
    scene.alive.assign(18, 1);
    for (std::size_t e = 9; e < 18; ++e) scene.alive[e] = 0;
    scene.erodes_at = 1000;
    int step = 0;
    const double carried = 10 * light / stiffness(radius);
    scene.run({0.5, 0.5, radius + 1e-6}, {0, 0, 0}, 2e-4, 8000, [&] {
      if (++step == 1000) {
        EXPECT_NEAR(scene.at()[2], radius - carried, 0.2 * carried);
      }
    });
    EXPECT_GT(scene.at()[2], radius - 1 - 0.1) << "on the lower layer";
    EXPECT_LT(scene.at()[2], radius - 0.2);
    EXPECT_NEAR(scene.result.eroded, 0.5 * light * 10 * carried, 0.4 * light * 10 * carried);
  }
}

TEST(SpheresOnFaces, AreStoppedByImpulsesToo) {
  for (const double radius : {0.01, 0.05, 0.5}) {
    SphereAndBlock scene({4, 4, 1}, turned(0, 0), radius);
    scene.options.enforcement = PINBALL_CONTACT_LAGRANGE;
    scene.run({0, 0, radius + 1e-6}, {0, 0, -2}, 2e-4, 1000, [] {});
    EXPECT_NEAR(scene.at()[2], radius, 1e-3);
    EXPECT_TRUE(scene.told.empty());
  }
}

/// By the distance of balls, where that is asked for: holes are told.
TEST(SpheresOnFaces, FallBetweenBallsWhereTheseAreAskedFor) {
  for (const double radius : {0.05, 0.08, 0.1, 0.5}) {
    SphereAndBlock scene({4, 4, 1}, turned(0, 0), radius);
    scene.options.gap = PINBALL_CONTACT_GAP_PINBALL;
    scene.run({0, 0, radius + 1e-6}, {0, 0, -2}, 2e-4, 5000, [] {});
    const bool falls = scene.at()[2] < -0.5;
    EXPECT_EQ(falls, radius < 0.0867);
    EXPECT_EQ(scene.told.size(), falls ? 1U : 0U);
  }
}

/// A sphere at a node of an element, as a body of its own or as part of it: whatever the shape of the element becomes,
/// they do not touch.
TEST(SpheresOnFaces, DoNotTouchTheElementThatTheyAreANodeOf) {
  const std::vector<Vector> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                 {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const std::vector<std::int32_t> corners{0, 1, 2, 3, 4, 5, 6, 7};
  const std::vector<double> mass(8, 1.0);
  const double bulk_modulus = 1e4;
  const std::int32_t node = 0;
  for (const std::int32_t enforcement :
       {PINBALL_CONTACT_PENALTY, PINBALL_CONTACT_PROJECTION, PINBALL_CONTACT_LAGRANGE}) {
    for (const std::int32_t gap : {PINBALL_CONTACT_GAP_PINBALL, PINBALL_CONTACT_GAP_FACE}) {
      for (const std::int32_t body : {0, 3}) {
        for (const double radius : {0.3, 0.9, 1.5}) {
          std::vector<Vector> position = cube, velocity(8), force(8, Vector{0, 0, 0});
          for (std::size_t n = 0; n < 8; ++n) velocity[n] = {-cube[n][0], -cube[n][1], -cube[n][2]};
          pinball_contact_options options = contact_options();
          options.enforcement = enforcement;
          options.gap = gap;
          pinball_contact_mesh mesh = contact_mesh();
          mesh.node_count = 8;
          mesh.mass = mass.data();
          mesh.element_count = 1;
          mesh.corners = corners.data();
          mesh.bulk_modulus = &bulk_modulus;
          mesh.sphere_count = 1;
          mesh.sphere_node = &node;
          mesh.sphere_body = &body;
          mesh.sphere_radius = &radius;
          mesh.sphere_bulk_modulus = &bulk_modulus;
          EmbeddedContact contact(options, mesh, interleaved(position[0].data()));
          pinball_contact_arrays arrays = contact_arrays();
          arrays.position = interleaved(position[0].data());
          arrays.velocity = interleaved(velocity[0].data());
          arrays.force = interleaved_sums(force[0].data());
          for (int step = 0; step < 20; ++step) {
            contact.update(arrays, step == 0 ? 0 : 0.02);
            contact.add_forces(arrays, 0.02);
            for (std::size_t n = 0; n < 8; ++n)
              position[n] = sum(position[n], {0.02 * velocity[n][0], 0.02 * velocity[n][1], 0.02 * velocity[n][2]});
          }
          for (const Vector& f : force) {
            EXPECT_EQ(f, (Vector{0, 0, 0})) << enforcement << ", gap " << gap << ", body " << body << ", " << radius;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace pinball::spheres_on_faces_test

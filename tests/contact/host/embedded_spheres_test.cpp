#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include <solver/contact/embedded_contact.hpp>

/// Bodies that are rigid spheres, in the time loop of a host that has nothing else.
namespace pinball::embedded_spheres_test {
namespace {

using Vector = std::array<double, 3>;

Vector sum(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

class Spheres {
 public:
  std::vector<Vector> position, velocity, force;
  std::vector<double> mass, radius, bulk_modulus;
  std::vector<std::int32_t> node;
  pinball_contact_options options = contact_options();

  void add(const Vector& at, const Vector& moving, double heavy = 2.0, double size = 0.5) {
    node.push_back(static_cast<std::int32_t>(node.size()));
    position.push_back(at);
    velocity.push_back(moving);
    force.push_back({0, 0, 0});
    mass.push_back(heavy);
    radius.push_back(size);
    bulk_modulus.push_back(1e4);
  }

  EmbeddedContact contact(const std::vector<std::int32_t>& held = {}, const std::vector<double>& direction = {}) {
    pinball_contact_mesh mesh = contact_mesh();
    mesh.node_count = static_cast<std::int64_t>(mass.size());
    mesh.mass = mass.data();
    mesh.sphere_count = mesh.node_count;
    mesh.sphere_node = node.data();
    mesh.sphere_radius = radius.data();
    mesh.sphere_bulk_modulus = bulk_modulus.data();
    mesh.held_count = static_cast<std::int64_t>(held.size());
    mesh.held_node = held.data();
    mesh.held_direction = direction.data();
    return {options, mesh, interleaved(position[0].data())};
  }

  pinball_contact_arrays arrays() {
    pinball_contact_arrays a = contact_arrays();
    a.position = interleaved(position[0].data());
    a.velocity = interleaved(velocity[0].data());
    a.force = interleaved_sums(force[0].data());
    return a;
  }

  /// One step of central differences; held: of which nodes the velocities stay.
  pinball_contact_result step(EmbeddedContact& contact, double dt, const std::vector<std::int32_t>& held = {}) {
    for (Vector& f : force) f = {0, 0, 0};
    contact.update(arrays(), dt_before);
    const pinball_contact_result result = contact.add_forces(arrays(), dt);
    for (const std::int32_t n : held) force[static_cast<std::size_t>(n)] = {0, 0, 0};
    for (std::size_t n = 0; n < mass.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) {
        velocity[n][k] += 0.5 * (dt_before + dt) * force[n][k] / mass[n];
        position[n][k] += dt * velocity[n][k];
      }
    }
    dt_before = dt;
    return result;
  }

  Vector momentum() const {
    Vector p{};
    for (std::size_t n = 0; n < mass.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) p[k] += mass[n] * velocity[n][k];
    }
    return p;
  }
  double kinetic_energy() const {
    double twice = 0;
    for (std::size_t n = 0; n < mass.size(); ++n) {
      for (const double v : velocity[n]) twice += mass[n] * v * v;
    }
    return 0.5 * twice;
  }

  double dt_before = 0;
};

TEST(EmbeddedSpheres, OfEqualMassExchangeTheirVelocities) {
  Spheres two;
  two.options.damping = 0;
  const Vector v1{3, 0, 0}, v2{-1, 0, 0};
  two.add({0, 0, 0}, v1);
  two.add({1.01, 0, 0}, v2);
  EmbeddedContact contact = two.contact();
  const Vector before = two.momentum();
  // Both springs: k = beta K R, of the reduced mass m/2; half a period of contact.
  const double stiffness = 1e4 * 0.5, frequency = std::sqrt(stiffness / 1.0), dt = 0.01 / frequency;
  double deepest = 0;
  for (int i = 0; i < 1500; ++i) {
    const pinball_contact_result result = two.step(contact, dt);
    deepest = std::max(deepest, result.penetration_ratio);
    if (result.pairs > 0) {
      // Gershgorin: the rows of the pair are k (1 + 1) / m.
      EXPECT_NEAR(result.frequency2, 2 * stiffness / 2.0, 1e-9 * stiffness);
      EXPECT_NEAR(result.stable_step, 2 / frequency, 1e-9);
    }
    for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(two.momentum()[k], before[k], 1e-13);
  }
  EXPECT_NEAR(deepest, 4 / frequency, 1e-3 * 4 / frequency) << "relative speed over frequency, and R1 + R2 = 1";
  EXPECT_NEAR(two.velocity[0][0], v2[0], 1e-3);
  EXPECT_NEAR(two.velocity[1][0], v1[0], 1e-3);
  EXPECT_GT(two.position[1][0] - two.position[0][0], 1.0) << "they are to have parted";
}

TEST(EmbeddedSpheres, KeepMomentumAndEnergyInACloud) {
  // Many collide aslant, of different sizes and masses.
  Spheres cloud;
  cloud.options.damping = 0;
  cloud.options.beta = 2;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 4; ++k) {
        const double a = 0.7 * i + 1.3 * j + 2.1 * k;  // irregular, the same in every run
        cloud.add({1.3 * i + 0.1 * std::sin(a), 1.3 * j + 0.1 * std::cos(a), 1.3 * k + 0.1 * std::sin(2 * a)},
                  {5 * std::sin(5 * a), 5 * std::cos(3 * a), 5 * std::sin(7 * a)}, 1 + 0.5 * std::sin(a),
                  0.45 + 0.1 * std::cos(a));
      }
    }
  }
  EmbeddedContact contact = cloud.contact();
  const Vector before = cloud.momentum();
  const double energy = cloud.kinetic_energy();
  std::int64_t pairs = 0;
  pinball_contact_result result{};
  for (int i = 0; i < 3000; ++i) {
    result = cloud.step(contact, 1e-4);
    pairs = std::max(pairs, result.pairs);
  }
  EXPECT_GT(pairs, 3) << "at a time";
  EXPECT_GT(result.searches, 3);
  EXPECT_GT(result.searches_skipped, result.searches);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(cloud.momentum()[k], before[k], 1e-11);
  EXPECT_NEAR(cloud.kinetic_energy() + result.stored, energy, 5e-3 * energy);
}

TEST(EmbeddedSpheres, DoNotOverlapWithImpulses) {
  for (const std::int32_t enforcement : {PINBALL_CONTACT_PROJECTION, PINBALL_CONTACT_LAGRANGE}) {
    Spheres two;
    two.options.enforcement = enforcement;
    two.add({0, 0, 0}, {2, 0.5, 0}, 3.0);
    two.add({1.05, 0.3, 0.1}, {-2, 0, 0.25}, 1.0);
    EmbeddedContact contact = two.contact();
    const Vector before = two.momentum();
    const double energy = two.kinetic_energy();
    std::int64_t pushes = 0;
    for (int i = 0; i < 200; ++i) {
      const pinball_contact_result result = two.step(contact, 1e-3);
      pushes += result.pairs;
      EXPECT_LT(result.penetration_ratio, 1e-4);
      EXPECT_EQ(result.frequency2, 0);
      for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(two.momentum()[k], before[k], 1e-13);
    }
    EXPECT_GT(pushes, 0);
    EXPECT_LT(two.kinetic_energy(), energy);
  }
}

TEST(EmbeddedSpheres, AHeldSphereIsAWall) {
  // The impulse of the step in which they touch stops the sphere at the wall, as if that were infinitely heavy.
  Spheres two;
  two.options.enforcement = PINBALL_CONTACT_LAGRANGE;
  two.add({0, 0, 0}, {2, 0, 0});
  two.add({1.0005, 0, 0}, {0, 0, 0});
  const std::vector<std::int32_t> held{1, 1, 1};
  EmbeddedContact contact = two.contact(held, {1, 0, 0, 0, 1, 0, 0, 0, 1});
  two.dt_before = 1e-3;  // it has been flying
  const pinball_contact_result result = two.step(contact, 1e-3, held);
  EXPECT_EQ(result.pairs, 1);
  EXPECT_NEAR(two.velocity[0][0], 0.5, 1e-12) << "what closes the gap within the step";
  EXPECT_NEAR(two.position[0][0], 0.0005, 1e-15);
}

/// A sphere that slides along another, which is held and heavy: what acts across the line of centres is mu times what
/// acts along it.
TEST(EmbeddedSpheres, RubWithTheCoefficientThatWasGiven) {
  for (const double friction : {0.05, 0.3, 0.8}) {
    Spheres two;
    two.options.enforcement = PINBALL_CONTACT_LAGRANGE;
    two.options.friction = friction;
    two.add({0, 0, 0}, {0, 0, 0}, 1e9);
    two.add({0, 0, 1}, {50, 0, -1});
    EmbeddedContact contact = two.contact();
    two.dt_before = 1e-6;
    EXPECT_EQ(two.step(contact, 1e-6).pairs, 1);
    ASSERT_GT(two.force[1][2], 0);
    EXPECT_NEAR(-two.force[1][0] / two.force[1][2], friction, 1e-9);
  }
}

TEST(EmbeddedSpheres, TakeNoPartOnceTheyAreDead) {
  Spheres two;
  two.add({0, 0, 0}, {0, 0, 0});
  two.add({0.99, 0, 0}, {-1, 0, 0});
  EmbeddedContact contact = two.contact();
  EXPECT_EQ(two.step(contact, 1e-3).surface_elements, 2);
  pinball_contact_arrays arrays = two.arrays();
  const std::uint8_t alive[] = {1, 0};
  arrays.sphere_alive = alive;
  contact.update(arrays, 1e-3);
  const pinball_contact_result result = contact.add_forces(arrays, 1e-3);
  EXPECT_EQ(result.surface_elements, 1);
  EXPECT_EQ(result.pairs, 0);
}

/// A small sphere, node 8, beside a heavy cube, at rest.
class SphereAndCube {
 public:
  SphereAndCube(const Vector& at, const Vector& moving, double radius = 0.3) : radius_(radius) {
    all.options.damping = 0;
    all.node = {8};
    for (const Vector& c :
         {Vector{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}) {
      all.position.push_back(c);
      all.velocity.push_back({0, 0, 0});
      all.mass.push_back(1e3);
    }
    all.position.push_back(at);
    all.velocity.push_back(moving);
    all.mass.push_back(1e-2);
    all.force.resize(9);
    mesh.node_count = 9;
    mesh.mass = all.mass.data();
    mesh.element_count = 1;
    mesh.corners = corners_.data();
    mesh.bulk_modulus = &modulus_;
    mesh.sphere_count = 1;
    mesh.sphere_node = all.node.data();
    mesh.sphere_radius = &radius_;
    mesh.sphere_bulk_modulus = &modulus_;
  }
  SphereAndCube(const SphereAndCube&) = delete;
  SphereAndCube& operator=(const SphereAndCube&) = delete;

  Spheres all;
  pinball_contact_mesh mesh = contact_mesh();

 private:
  std::array<std::int32_t, 8> corners_{0, 1, 2, 3, 4, 5, 6, 7};
  double modulus_ = 1e4, radius_;
};

/// One that has gone in with its centre is stopped as one that has not, and goes out by the way that it came.
TEST(EmbeddedSpheres, AreStoppedBehindAFaceToo) {
  for (const double height : {1.299, 1.1, 0.99, 0.9}) {
    SphereAndCube scene({0.45, 0.55, height}, {0, 0, -2});
    Spheres& now = scene.all;
    now.options.enforcement = PINBALL_CONTACT_LAGRANGE;
    now.options.gap = PINBALL_CONTACT_GAP_FACE;
    EmbeddedContact contact(now.options, scene.mesh, interleaved(now.position[0].data()));
    now.dt_before = 1e-6;
    EXPECT_EQ(now.step(contact, 1e-6).pairs, 1) << height;
    EXPECT_GT(now.velocity[8][2], -1e-3) << height;
    EXPECT_NEAR(now.velocity[8][0], 0, 1e-9);
  }
}

TEST(EmbeddedSpheres, RubOnFacesToo) {
  SphereAndCube scene({0.45, 0.55, 1.3}, {70, 0, -1});
  Spheres& now = scene.all;
  now.options.enforcement = PINBALL_CONTACT_LAGRANGE;
  now.options.gap = PINBALL_CONTACT_GAP_FACE;
  now.options.friction = 0.3;
  EmbeddedContact contact(now.options, scene.mesh, interleaved(now.position[0].data()));
  now.dt_before = 1e-6;
  EXPECT_EQ(now.step(contact, 1e-6).pairs, 1);
  ASSERT_GT(now.force[8][2], 0);
  EXPECT_NEAR(-now.force[8][0] / now.force[8][2], 0.3, 1e-6);
}

TEST(EmbeddedSpheres, HitHexahedra) {
  // On the middle of a face.
  SphereAndCube scene({0.5, 0.5, 0.5 + std::cbrt(3 / (4 * M_PI)) + 0.3 + 1e-6}, {0, 0, -2});
  const Spheres& all = scene.all;
  const pinball_contact_mesh& mesh = scene.mesh;
  for (const std::int32_t gap : {PINBALL_CONTACT_GAP_PINBALL, PINBALL_CONTACT_GAP_FACE}) {
    for (const std::int32_t enforcement : {PINBALL_CONTACT_PENALTY, PINBALL_CONTACT_LAGRANGE}) {
      Spheres now = all;
      now.options.enforcement = enforcement;
      now.options.gap = gap;
      if (gap == PINBALL_CONTACT_GAP_FACE)
        now.position[8][2] = 1.3 + 1e-6;  // the ball of the cube reaches out of its face
      EmbeddedContact contact(now.options, mesh, interleaved(now.position[0].data()));
      const Vector before = now.momentum();
      std::int64_t pushes = 0;
      for (int i = 0; i < 1500; ++i) pushes += now.step(contact, 5e-6).pairs;
      EXPECT_GT(pushes, 0);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(now.momentum()[k], before[k], 1e-12);
      if (enforcement == PINBALL_CONTACT_PENALTY) {
        EXPECT_NEAR(now.velocity[8][2], 2, 2e-2) << "thrown back by what is 800,000 times as heavy";
      } else {
        EXPECT_GT(now.velocity[8][2], -1e-3) << "stopped";
      }
      Vector cube{};
      for (std::size_t n = 0; n < 8; ++n) cube = sum(cube, now.velocity[n]);
      EXPECT_NEAR(cube[0], 0, 1e-12);
      EXPECT_LT(cube[2], 0);
    }
  }
}

/// Over a face that meets the one below at less than a right angle, beside their edge: what is before the one is behind
/// the other, and outside. The impulse is along the normal of the face alone.
TEST(EmbeddedSpheres, ArePushedByTheFaceThatIsNearestAtASharpEdge) {
  struct Place {
    double degrees, radius;
  };
  for (const auto& [degrees, radius] : {Place{27, 0.3}, {45, 0.5}, {45, 0.2}, {60, 0.2}, {75, 0.05}}) {
    for (const std::int32_t enforcement : {PINBALL_CONTACT_PROJECTION, PINBALL_CONTACT_LAGRANGE}) {
      for (const std::int32_t keep_lists : {0, 1}) {
        const double slope = degrees * M_PI / 180, edge = 1 + 3 / std::tan(slope);
        const Vector normal{std::sin(slope), 0, std::cos(slope)}, upwards{-normal[2], 0, normal[0]};
        const double from_edge = 1.05 * radius * std::tan(slope) + 0.01, height = radius + 0.02;
        SphereAndCube scene(
            {edge + from_edge * upwards[0] + height * normal[0], 1, from_edge * upwards[2] + height * normal[2]},
            {-normal[0], 0, -normal[2]}, radius);
        Spheres& now = scene.all;
        for (std::size_t n = 0; n < 8; ++n) {
          Vector& x = now.position[n];
          x = {x[0] * (x[2] > 0 ? 1 : edge), 2 * x[1], 3 * x[2]};
          now.mass[n] = 1e6;
        }
        now.options.enforcement = enforcement;
        now.options.gap = PINBALL_CONTACT_GAP_FACE;
        now.options.keep_lists = keep_lists;
        EmbeddedContact contact(now.options, scene.mesh, interleaved(now.position[0].data()));
        Vector impulse{};
        for (int i = 0; i < 100; ++i) {
          now.step(contact, 2e-3);
          for (std::size_t k = 0; k < 3; ++k) impulse[k] += 2e-3 * now.force[8][k] / now.mass[8];
        }
        SCOPED_TRACE(::testing::Message() << degrees << " degrees, radius " << radius << ", enforcement " << enforcement
                                          << ", keep_lists " << keep_lists);
        EXPECT_GT(impulse[0] * normal[0] + impulse[2] * normal[2], 0.99) << "it is to be stopped";
        EXPECT_NEAR(impulse[0] * upwards[0] + impulse[2] * upwards[2], 0, 1e-6);
        EXPECT_NEAR(impulse[1], 0, 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace pinball::embedded_spheres_test

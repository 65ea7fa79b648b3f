// A host that is not ours: ODE (Open Dynamics Engine) owns and integrates rigid bodies, and Pinball gives the forces
// between them, in place of ODE's own collisions. Two spheres of unequal mass meet head-on; without damping the exact
// solution is that of an elastic impact. ODE accelerates first and then moves, as the central differences do that
// Pinball is made for.
#include <ode/ode.h>
#include <pinball/contact/contact.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

constexpr int spheres = 2;
constexpr double dt = 1e-3;
constexpr int steps = 4000;

void check(int status, const pinball_contact* contact) {
  if (status == PINBALL_CONTACT_OK) return;
  std::fprintf(stderr, "contact: %s\n", pinball_contact_message(contact));
  std::exit(1);
}

int bad = 0;

void expect_near(const char* name, double value, double expected, double tolerance) {
  const bool good = std::abs(value - expected) <= tolerance;
  std::printf("%s %s: %.12g, expected %.12g +- %.2g\n", good ? "ok  " : "BAD ", name, value, expected, tolerance);
  if (!good) ++bad;
}

}  // namespace

int main() {
  static_assert(sizeof(dReal) == sizeof(double));
  const std::array<double, spheres> mass{3.0, 1.0}, radius{0.5, 0.3}, bulk_modulus{1000.0, 1000.0};
  const std::array<double, spheres> start{0.0, 1.2}, speed{1.0, -0.5};
  const std::array<std::int32_t, spheres> node{0, 1};

  dInitODE2(0);
  const dWorldID world = dWorldCreate();
  std::array<dBodyID, spheres> bodies{};
  std::array<double, 3 * spheres> position{}, velocity{}, force{};
  for (std::size_t i = 0; i < spheres; ++i) {
    bodies[i] = dBodyCreate(world);
    dMass inertia;
    dMassSetSphereTotal(&inertia, mass[i], radius[i]);
    dBodySetMass(bodies[i], &inertia);
    dBodySetPosition(bodies[i], start[i], 0, 0);
    dBodySetLinearVel(bodies[i], speed[i], 0, 0);
    position[3 * i] = start[i];
  }

  // [create]
  pinball_contact_options options;
  pinball_contact_options_init(&options);
  options.damping = 0;
  pinball_contact_mesh mesh;
  pinball_contact_mesh_init(&mesh);
  mesh.node_count = spheres;
  mesh.mass = mass.data();
  mesh.sphere_count = spheres;
  mesh.sphere_node = node.data();
  mesh.sphere_radius = radius.data();
  mesh.sphere_bulk_modulus = bulk_modulus.data();
  const pinball_contact_input where{&position[0], &position[1], &position[2], 3};
  pinball_contact* contact = nullptr;
  check(pinball_contact_create(&options, &mesh, &where, &contact), contact);
  // [create]

  pinball_contact_arrays arrays;
  pinball_contact_arrays_init(&arrays);
  arrays.position = where;
  arrays.velocity = {&velocity[0], &velocity[1], &velocity[2], 3};
  arrays.force = {&force[0], &force[1], &force[2], 3};

  pinball_contact_result result{};
  double deepest = 0, shortest_step = HUGE_VAL;
  for (int step = 0; step < steps; ++step) {
    force.fill(0);
    for (std::size_t i = 0; i < spheres; ++i) {
      const dReal* x = dBodyGetPosition(bodies[i]);
      const dReal* v = dBodyGetLinearVel(bodies[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        position[3 * i + k] = x[k];
        velocity[3 * i + k] = v[k];
      }
    }
    check(pinball_contact_update(contact, &arrays, step == 0 ? 0 : dt), contact);
    check(pinball_contact_add_forces(contact, &arrays, dt, &result), contact);
    for (std::size_t i = 0; i < spheres; ++i) {
      dBodyAddForce(bodies[i], force[3 * i], force[3 * i + 1], force[3 * i + 2]);
    }
    if (dWorldStep(world, dt) == 0) return 1;
    deepest = std::fmax(deepest, radius[0] + radius[1] - (position[3] - position[0]));
    shortest_step = std::fmin(shortest_step, result.stable_step);
  }

  std::array<double, spheres> v{};
  for (std::size_t i = 0; i < spheres; ++i) v[i] = dBodyGetLinearVel(bodies[i])[0];
  const double total = mass[0] + mass[1];
  const double centre = (mass[0] * speed[0] + mass[1] * speed[1]) / total;
  const double before = mass[0] * speed[0] * speed[0] / 2 + mass[1] * speed[1] * speed[1] / 2;
  const double after = mass[0] * v[0] * v[0] / 2 + mass[1] * v[1] * v[1] / 2;
  expect_near("momentum", mass[0] * v[0] + mass[1] * v[1], total * centre, 1e-12);
  expect_near("energy", after, before, 1e-3 * before);
  expect_near("velocity of the heavy sphere", v[0], 2 * centre - speed[0], 1e-3);
  expect_near("velocity of the light sphere", v[1], 2 * centre - speed[1], 1e-3);
  expect_near("energy in springs after the impact", result.stored, 0, 0);
  // The bound on the step is that of the pair's own oscillation.
  std::printf("     deepest penetration %.3g, stable step %.3g\n", deepest, shortest_step);
  expect_near("stable step / that of the deepest penetration", shortest_step / (2 * deepest / (speed[0] - speed[1])), 1,
              0.5);

  pinball_contact_destroy(contact);
  dWorldDestroy(world);
  dCloseODE();
  return bad;
}

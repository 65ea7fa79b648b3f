#include <array>
#include <cmath>
#include <vector>

#include <solver/contact/embedded_contact.hpp>
#include <solver/mesh/generators.hpp>
#include <tests/contact/embedding_case.hpp>

#include "trial.hpp"

/// A rigid sphere of a host above a held plate of hexahedra: it has to touch the faces, edges and nodes of the plate
/// where it does, at a distance of its radius.
namespace pinball::sphere_trial_test {
namespace {

using namespace test;

class SphereTrial : public TrialTest {};
INSTANTIATE_TEST_SUITE_P(All, SphereTrial, testing::Values(variants[0], variants[1], variants[2]), variant_name);

constexpr double h = 1;      ///< size of the elements
constexpr int side = 4;      ///< elements along x and y, from 0
constexpr double speed = 1;  ///< of the sphere, downward

/// Distance of a point from the plate, which is below z = 0 [length].
double distance_from_plate(const double* x) {
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double low = k < 2 ? 0 : -h, high = k < 2 ? side * h : 0, outside = std::max({low - x[k], 0.0, x[k] - high});
    square += outside * outside;
  }
  return std::sqrt(square);
}

/// The plate and the sphere, whose node is the last.
struct Host {
  std::vector<double> position, velocity, force, mass, bulk_modulus, direction;
  std::vector<std::int32_t> corners, body, held, sphere_node;
  std::vector<double> radius, sphere_modulus{1e3};
  Scene scene;

  Host(double r, double x, double y, double above, const Variant& variant) : scene(with_contact({}, variant)) {
    const Mesh mesh = generate_block({{side * h, side * h, h}, {side, side, 1}, {}});
    for (const Point& node : mesh.nodes) {
      for (std::int32_t k = 0; k < 3; ++k) {
        held.push_back(static_cast<std::int32_t>(mass.size()));
        for (std::int32_t c = 0; c < 3; ++c) direction.push_back(c == k);
        position.push_back(node[k] - (k == 2 ? h : 0));
      }
      mass.push_back(1);
    }
    for (const auto& element : mesh.hexahedra) corners.insert(corners.end(), element.begin(), element.end());
    body.assign(mesh.hexahedra.size(), 0);
    bulk_modulus.assign(mesh.hexahedra.size(), 1e3);
    sphere_node = {static_cast<std::int32_t>(mass.size())};
    position.insert(position.end(), {x, y, above});
    mass.push_back(1);
    radius = {r};
    velocity.assign(position.size(), 0);
    velocity.back() = -speed;
    force.assign(position.size(), 0);
  }

  EmbeddedContact contact() {
    pinball_contact_mesh mesh = contact_mesh();
    mesh.node_count = static_cast<std::int64_t>(mass.size());
    mesh.mass = mass.data();
    mesh.element_count = static_cast<std::int64_t>(body.size());
    mesh.corners = corners.data();
    mesh.body = body.data();
    mesh.bulk_modulus = bulk_modulus.data();
    mesh.sphere_count = 1;
    mesh.sphere_node = sphere_node.data();
    mesh.sphere_radius = radius.data();
    mesh.sphere_bulk_modulus = sphere_modulus.data();
    mesh.held_count = static_cast<std::int64_t>(held.size());
    mesh.held_node = held.data();
    mesh.held_direction = direction.data();
    return {options_of(scene.contact), mesh, interleaved(position.data())};
  }
  pinball_contact_arrays arrays() {
    pinball_contact_arrays a = contact_arrays();
    a.position = interleaved(position.data());
    a.velocity = interleaved(velocity.data());
    a.force = interleaved_sums(force.data());
    return a;
  }
  const double* sphere() const { return position.data() + position.size() - 3; }
};

struct Touch {
  double depth = 0;    ///< when the first force acts, over the radius
  double deepest = 0;  ///< on the way, over the radius
};

/// The sphere falls for 1.5 of its radius, in steps of a hundredth of it.
Touch fall(double r, double x, double y, const Variant& variant) {
  Host host(r, x, y, 1.5 * r, variant);
  EmbeddedContact contact = host.contact();
  const double dt = 0.01 * r / speed;
  double before = 0;
  Touch touch;
  bool felt = false;
  for (int step = 0; step < 150; ++step) {
    std::fill(host.force.begin(), host.force.end(), 0);
    contact.update(host.arrays(), before);
    contact.add_forces(host.arrays(), dt);
    const double* const f = host.force.data() + host.force.size() - 3;
    const double depth = 1 - distance_from_plate(host.sphere()) / r;
    touch.deepest = std::max(touch.deepest, depth);
    if (!felt) touch.depth = depth;
    // A step may end just where the sphere touches: what is felt then is round-off.
    felt = felt || std::hypot(f[0], f[1], f[2]) > 1e-9 * host.mass.back() * speed / dt;
    for (int k = 0; k < 3; ++k) {
      const std::size_t place = host.position.size() - 3 + static_cast<std::size_t>(k);
      host.velocity[place] += 0.5 * (before + dt) * f[k] / host.mass.back();
      host.position[place] += dt * host.velocity[place];
    }
    before = dt;
  }
  return touch;
}

TEST_P(SphereTrial, ASphereTouchesAtItsRadius) {
  struct Place {
    const char* name;
    double x, y;
  };
  for (const double r : {2.0, 1.0, 0.5, 0.2, 0.08, 0.02}) {
    for (const Place& place :
         {Place{"a face", 1.5, 1.5}, Place{"a node", 2, 2}, Place{"an edge", 1.5, 2}, Place{"an odd place", 1.73, 2.09},
          Place{"the rim", 1.5, -0.6 * r}, Place{"a corner", -0.5 * r, -0.4 * r}}) {
      const std::string trial = fmt::format("sphere, r = {} h, over {}", r, place.name);
      const Touch found = run_of(trial, [&] { return fall(r, place.x, place.y, GetParam()); });
      compare(trial + ", depth/r", found.depth, 0, 0.011);  // a step
      if (GetParam().enforcement != Enforcement::penalty) at_most(trial + ", deepest/r", found.deepest, 0.011);
    }
  }
}

}  // namespace
}  // namespace pinball::sphere_trial_test

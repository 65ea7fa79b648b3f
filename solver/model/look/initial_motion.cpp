#include "initial_motion.hpp"

#include <algorithm>

#include <solver/base/moments_of_inertia.hpp>
#include <solver/model/rigid/rigid_nodes.hpp>
#include <solver/model/selection/node_selection.hpp>

namespace pinball {

namespace {

/// The means of the nodes of each body.
std::vector<Point> centres_of(const ModelMesh& mesh, std::size_t bodies) {
  std::vector<Point> centre(bodies, Point{});
  std::vector<double> count(bodies, 0.0);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const std::int32_t b = mesh.body_of_node[n];
    for (std::size_t k = 0; k < 3; ++k) centre[b][k] += mesh.nodes[n][k];
    ++count[b];
  }
  for (std::size_t b = 0; b < bodies; ++b) {
    for (double& c : centre[b]) c /= std::max(count[b], 1.0);
  }
  return centre;
}

Point mean_place(const ModelMesh& mesh, const std::vector<std::int32_t>& nodes) {
  Point mean{};
  for (const std::int32_t n : nodes) {
    for (std::size_t k = 0; k < 3; ++k) mean[k] += mesh.nodes[n][k] / static_cast<double>(nodes.size());
  }
  return mean;
}

}  // namespace

std::vector<std::vector<std::int32_t>> nodes_of_rigid_bodies(const Scene& scene, const ModelMesh& mesh) {
  std::vector<std::vector<std::int32_t>> nodes(scene.rigid_bodies.size());
  const std::vector<std::int32_t> rigid = rigid_body_of_bodies(scene);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const std::int32_t number = rigid[mesh.body_of_node[n]];
    if (number >= 0) nodes[number].push_back(static_cast<std::int32_t>(n));
  }
  for (const AttachedNodes& attached : scene.attached_nodes) {
    std::vector<std::int32_t>& with = nodes[rigid_body_of_name(scene, attached.rigid_body)];
    for (const std::int32_t n : matching_nodes(mesh, attached.nodes)) with.push_back(n);
  }
  return nodes;
}

std::vector<Point> initial_velocities(const Scene& scene, const ModelMesh& mesh) {
  const std::vector<Point> centre = centres_of(mesh, scene.bodies.size());
  std::vector<Point> velocity(mesh.nodes.size());
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const std::size_t b = mesh.body_of_node[n];
    const Body& body = scene.bodies[b];
    const Point r = minus(mesh.nodes[n], centre[b]), spin = cross(body.angular_velocity, r);
    for (std::size_t k = 0; k < 3; ++k) velocity[n][k] = body.velocity[k] + spin[k] + dot(body.velocity_gradient[k], r);
  }
  for (const InitialVelocity& given : scene.initial_velocities) {
    for (const std::int32_t n : matching_nodes(mesh, given.nodes)) {
      const std::size_t place = n;
      const Point spin = cross(given.angular_velocity, minus(mesh.nodes[place], given.centre));
      for (std::size_t k = 0; k < 3; ++k) {
        if (given.components[k]) velocity[place][k] = given.velocity[k] + spin[k];
      }
    }
  }
  const std::vector<std::vector<std::int32_t>> rigid = nodes_of_rigid_bodies(scene, mesh);
  for (std::size_t r = 0; r < rigid.size(); ++r) {
    const RigidBody& given = scene.rigid_bodies[r];
    if (rigid[r].empty() || (!given.velocity && !given.angular_velocity)) continue;
    const Point centre_of = given.centre.value_or(mean_place(mesh, rigid[r])), v = given.velocity.value_or(Point{});
    for (const std::size_t n : rigid[r]) {
      const Point spin = cross(given.angular_velocity.value_or(Point{}), minus(mesh.nodes[n], centre_of));
      for (std::size_t k = 0; k < 3; ++k) velocity[n][k] = v[k] + spin[k];
    }
  }
  return velocity;
}

namespace {

/// The angular velocity that explains most of the angular momentum of points of equal mass.
class Turning {
 public:
  void add(const Point& r, const Point& v) {
    const Point moment = cross(r, v);
    for (std::size_t k = 0; k < 3; ++k) momentum_[k] += moment[k];
    add_moments(inertia_, 1, r);
  }
  Point velocity() const {
    const double trace = inertia_[0][0] + inertia_[1][1] + inertia_[2][2];
    std::array<Point, 3> m = inertia_;
    for (std::size_t k = 0; k < 3; ++k) m[k][k] += 1e-12 * trace;
    const Point first = cross(m[1], m[2]);
    const double determinant = dot(m[0], first);
    if (!(determinant > 0)) return {};
    const Point second = cross(m[2], m[0]), third = cross(m[0], m[1]);
    Point w;
    for (std::size_t k = 0; k < 3; ++k)
      w[k] = (first[k] * momentum_[0] + second[k] * momentum_[1] + third[k] * momentum_[2]) / determinant;
    return w;
  }

 private:
  Point momentum_{};
  std::array<Point, 3> inertia_{};
};

struct Means {
  Point place{}, velocity{};
  double count = 0;
};

}  // namespace

std::vector<InitialMotion> initial_motions(const Scene& scene, const ModelMesh& mesh,
                                           const std::vector<std::int32_t>& group, std::size_t groups) {
  const std::vector<Point> velocity = initial_velocities(scene, mesh);
  const auto group_of = [&](std::size_t n) {
    return static_cast<std::size_t>(group[static_cast<std::size_t>(mesh.body_of_node[n])]);
  };
  std::vector<Means> mean(groups);
  for (std::size_t n = 0; n < velocity.size(); ++n) {
    Means& own = mean[group_of(n)];
    for (std::size_t k = 0; k < 3; ++k) {
      own.place[k] += mesh.nodes[n][k];
      own.velocity[k] += velocity[n][k];
    }
    ++own.count;
  }
  for (Means& own : mean) {
    for (std::size_t k = 0; k < 3; ++k) {
      own.place[k] /= own.count;
      own.velocity[k] /= own.count;
    }
  }
  std::vector<Turning> turning(groups);
  for (std::size_t n = 0; n < velocity.size(); ++n) {
    const Means& own = mean[group_of(n)];
    turning[group_of(n)].add(minus(mesh.nodes[n], own.place), minus(velocity[n], own.velocity));
  }
  std::vector<InitialMotion> motions(groups);
  std::vector<Point> spin(groups);
  for (std::size_t g = 0; g < groups; ++g) {
    spin[g] = turning[g].velocity();
    motions[g].centre = mean[g].place;
    motions[g].mean = mean[g].velocity;
    motions[g].turning = norm(spin[g]);
  }
  for (std::size_t n = 0; n < velocity.size(); ++n) {
    InitialMotion& own = motions[group_of(n)];
    const Point r = minus(mesh.nodes[n], own.centre);
    const double noise = std::sqrt(3.0) * scene.bodies[static_cast<std::size_t>(mesh.body_of_node[n])].velocity_noise;
    const Point rest = minus(velocity[n], cross(spin[group_of(n)], r));
    own.velocity.take(Point{rest[0] - noise, rest[1] - noise, rest[2] - noise});
    own.velocity.take(Point{rest[0] + noise, rest[1] + noise, rest[2] + noise});
    own.spread = std::max(own.spread, norm(minus(rest, own.mean)) + noise);
    own.radius = std::max(own.radius, norm(r));
    own.speed = std::max(own.speed, norm(velocity[n]) + noise);
  }
  return motions;
}

}  // namespace pinball

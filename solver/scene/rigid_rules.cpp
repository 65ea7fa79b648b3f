#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <solver/base/point.hpp>
#include <solver/scene_rules.hpp>

namespace pinball {

namespace {

std::optional<Problem> angle_problem(const char* key, const std::vector<Point>& directions) {
  constexpr double square = 1e-9;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (std::abs(dot(directions[i], directions[j])) < square) continue;
      return Problem{key, fmt::format("expected directions at right angles, numbers {} and {} are not", j + 1, i + 1)};
    }
  }
  return {};
}

/// Of a body, no principal moment is larger than the sum of the others, and all are > 0. Both hold where the tensor
/// J = tr(I)/2 - I, the integral of r r^T, has no principal value below 0 and at most one that is 0.
std::optional<Problem> inertia_problem(const std::array<Point, 3>& inertia) {
  double size = 0;
  for (const Point& row : inertia) {
    for (const double component : row) size = std::max(size, std::abs(component));
  }
  if (size == 0) return {};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (std::abs(inertia[i][j] - inertia[j][i]) <= 1e-9 * size) continue;
      return Problem{"inertia", fmt::format("expected a symmetric tensor, got {} and {} across the diagonal",
                                            inertia[i][j], inertia[j][i])};
    }
  }
  std::array<Point, 3> j = inertia;
  const double half = 0.5 * (inertia[0][0] + inertia[1][1] + inertia[2][2]);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) j[i][k] = (i == k ? half : 0.0) - inertia[i][k];
  }
  const double minors = j[0][0] * j[1][1] - j[0][1] * j[1][0] + j[1][1] * j[2][2] - j[1][2] * j[2][1] +
                        j[2][2] * j[0][0] - j[2][0] * j[0][2];
  const double determinant = dot(j[0], cross(j[1], j[2]));
  constexpr double little = 1e-9;
  if (half > 0 && minors > little * size * size && determinant >= -little * size * size * size) return {};
  return Problem{"inertia", "expected that of a body: principal moments > 0, none larger than the sum of the others"};
}

}  // namespace

std::optional<Problem> problem_of(const RigidBody& rigid) {
  if (rigid.bodies.empty() && rigid.name.empty())
    return Problem{"name", "missing, expected the name of a rigid body without bodies"};
  if (rigid.bodies.empty() && rigid.mass > 0) return Problem{"mass", "expected none without bodies"};
  if (auto problem = angle_problem("held", rigid.held)) return problem;
  if (auto problem = angle_problem("held_rotations", rigid.held_rotations)) return problem;
  if (rigid.centre && rigid.inertia == std::array<Point, 3>{})
    return Problem{"centre", "expected an inertia beside it, about this centre"};
  return inertia_problem(rigid.inertia);
}

std::optional<Problem> problem_of(const RigidMotion& motion) {
  if (motion.direction && motion.axis) return Problem{"axis", "expected either direction or axis, got both"};
  if (!motion.direction && !motion.axis) return Problem{"direction", "missing, expected a direction or an axis"};
  if (motion.direction && motion.angular_speed != 0)
    return Problem{"angular_speed", "expected speed beside direction, not angular_speed"};
  if (motion.axis && motion.speed != 0) return Problem{"speed", "expected angular_speed beside axis, not speed"};
  return {};
}

std::optional<Problem> problem_of(const Joint& joint) {
  if (joint.bodies.size() != 2 || joint.bodies[0] == joint.bodies[1])
    return Problem{"bodies", fmt::format("expected two rigid bodies, or one and \"ground\", got {}",
                                         joint.bodies.size() == 2 ? "one twice" : std::to_string(joint.bodies.size()))};
  if (!joint.point) return Problem{"point", "missing, expected where the joint is"};
  const bool has_axis = joint.kind != JointKind::spherical && joint.kind != JointKind::locking;
  if (has_axis != joint.axis.has_value())
    return Problem{"axis", has_axis ? "missing, expected what the joint turns about or slides along"
                                    : "expected none: the joint has no direction of its own"};
  const bool universal = joint.kind == JointKind::universal;
  if (universal != joint.second_axis.has_value())
    return Problem{"second_axis", universal ? "missing, expected the axis of the second body"
                                            : "expected none: only a universal joint has two axes"};
  if (universal && std::abs(dot(*joint.axis, *joint.second_axis)) > 1e-6 * norm(*joint.axis) * norm(*joint.second_axis))
    return Problem{"second_axis", "expected a direction at right angles to axis"};
  return {};
}

std::optional<Problem> problem_of(const Joint& joint, const Scene& scene) {
  for (const std::string& name : joint.bodies) {
    const bool known = std::ranges::find(scene.rigid_bodies, name, &RigidBody::name) != scene.rigid_bodies.end();
    if (name == ground && known)
      return Problem{"bodies", "a rigid body is named \"ground\": expected another name of it"};
    if (known || name == ground) continue;
    const bool deforms = std::ranges::find(scene.bodies, name, &Body::name) != scene.bodies.end();
    return Problem{"bodies", fmt::format("expected names of [[rigid_body]] or \"ground\", got \"{}\"{}", name,
                                         deforms ? ", a body that is no rigid one" : "")};
  }
  return {};
}

/// What rigid bodies are not there for is refused.
std::optional<Problem> problem_of(const RigidBody& rigid, const Scene& scene) {
  const auto refuse = [](const std::string& text) { return Problem{"bodies", text}; };
  for (const std::string& name : rigid.bodies) {
    std::size_t times = 0;
    for (const RigidBody& any : scene.rigid_bodies) times += std::ranges::count(any.bodies, name);
    if (times > 1) return refuse(fmt::format("expected each body once in all rigid bodies, got {} again", name));
    const auto body = std::ranges::find(scene.bodies, name, &Body::name);
    if (body == scene.bodies.end()) continue;  // said elsewhere
    if (body->velocity_noise > 0 || body->velocity_gradient != std::array<Point, 3>{})
      return refuse(fmt::format("body {} deforms by its velocity_gradient or velocity_noise: expected none", name));
  }
  if (scene.output.body_energies && rigid.inertia != std::array<Point, 3>{})
    return Problem{"inertia", "expected output.body_energies = false, whose sums are those of the masses of nodes"};
  if (rigid.centre && scene.damping.mass > 0)
    return Problem{"centre", "expected damping.mass = 0, whose forces are those of the masses of nodes"};
  if (scene.time.subcycling)
    return refuse("expected time.subcycling = false, with which there are no rigid bodies in this version");
  if (scene.contact.method != ContactMethod::none && scene.contact.enforcement == Enforcement::projection)
    return refuse("expected contact.enforcement = \"lagrange\" or \"penalty\", \"projection\" knows no rigid bodies");
  return {};
}

}  // namespace pinball

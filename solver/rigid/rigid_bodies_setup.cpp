#include <fmt/core.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include <solver/base/error.hpp>
#include <solver/base/moments_of_inertia.hpp>
#include <solver/model/elements/element_start.hpp>
#include <solver/model/ordering.hpp>

#include "eigen_points.hpp"
#include "joints.hpp"
#include "rigid_bodies.hpp"

namespace pinball {

namespace {

constexpr double least_steps = 1000;  ///< of a run in which nothing deforms

/// Mass, centre, and moments about it, of some nodes.
struct MassOfNodes {
  double mass = 0;
  Point centre{};
  std::array<Point, 3> inertia{};
  double far = 0;  ///< the farthest from the origin

  SlenderInertia slender() const { return slender_inertia(inertia, mass, far); }
};

/// mass, place: of the i-th of them.
template <class Mass, class Place>
MassOfNodes mass_of(std::size_t count, const Mass& mass, const Place& place) {
  MassOfNodes all;
  for (std::size_t i = 0; i < count; ++i) {
    all.mass += mass(i);
    for (std::size_t k = 0; k < 3; ++k) all.centre[k] += mass(i) * place(i)[k];
  }
  for (double& c : all.centre) c /= all.mass;
  Point rest{};  // the sum of large coordinates has lost something
  for (std::size_t i = 0; i < count; ++i) {
    const Point r = minus(place(i), all.centre);
    for (std::size_t k = 0; k < 3; ++k) rest[k] += mass(i) * r[k];
  }
  for (std::size_t k = 0; k < 3; ++k) all.centre[k] += rest[k] / all.mass;
  for (std::size_t i = 0; i < count; ++i) {
    const Point r = minus(place(i), all.centre);
    all.far = std::max(all.far, norm(place(i)));
    add_moments(all.inertia, mass(i), r);
  }
  return all;
}

/// A scene in which nothing deforms. Springs between bodies are as stiff as their elements would be: their step.
template <class S>
double longest_step_of_run(const Model<S>& model) {
  const double step = model.scene.time.end / least_steps;
  const ContactSettings& contact = model.scene.contact;
  if (contact.method == ContactMethod::none || contact.enforcement != Enforcement::penalty) return step;
  ElementParts as_if_elastic = element_parts(model.scene, model.mesh);
  for (ElementPart& part : as_if_elastic.parts) part.rigid = false;
  return std::min(step, model.scene.time.cfl * smallest_stable_step(model.scene, model.mesh, as_if_elastic, {}));
}

/// Of motions of velocity V and spin w of a body with a given inertia, of which the nodes' masses have the energy
///
///     m V^2/2 + m V.(w x o) + w.I_n w/2 ,
///
/// o: from the given centre to theirs; I_n: their inertia about the given centre, that of the body less `more`.
double lightness_of(const RigidBodyMotion& body, const std::array<Point, 3>& more, const Point& offset) {
  using Matrix = Eigen::Matrix<double, 6, 6>;
  const Eigen::Matrix3d translation = body.mass() * Eigen::Matrix3d::Identity(), inertia = eigen(body.inertia());
  Matrix own = Matrix::Zero(), of_nodes = Matrix::Zero();
  own << translation, Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero(), inertia;
  const Eigen::Matrix3d coupling = -body.mass() * skew(eigen(offset));
  of_nodes << translation, coupling, coupling.transpose(), inertia - eigen(more);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> solver(of_nodes, own, Eigen::EigenvaluesOnly);
  constexpr double rounding = 1e-9;
  const double largest = solver.eigenvalues().maxCoeff();
  return largest > 1 + rounding ? largest : 1.0;
}

void change(RigidBodyMotion& motion, const Twist& by) {
  Point v = motion.state().velocity, w = motion.angular_velocity();
  for (std::size_t k = 0; k < 3; ++k) {
    v[k] += by.velocity[k];
    w[k] += by.angular_velocity[k];
  }
  motion.set_velocities(v, w);
}

template <class S>
std::vector<S> velocities_of(Model<S>& model, const std::vector<std::int32_t>& nodes) {
  std::vector<S> all;
  for (const std::int32_t n : nodes) all.insert(all.end(), model.nodes.velocity_of(n), model.nodes.velocity_of(n) + 3);
  return all;
}

bool at_right_angles(const Point& a, const Point& b) { return std::abs(dot(a, b)) < 1e-6; }

bool overlap(const TimeSpan& a, const TimeSpan& b) {
  return std::max({0.0, a.start, b.start}) < std::min(a.end, b.end);
}

}  // namespace

template <class S>
RigidBodies<S>::RigidBodies(Model<S>& model) : motions_(model.scene.rigid_motions) {
  if (model.rigid.empty()) return;
  bool deforms = false;
  for (std::int32_t tile = 0; tile < model.tile_count(); ++tile) deforms = deforms || !model.is_rigid(tile);
  of_run_ = deforms ? std::numeric_limits<double>::infinity() : longest_step_of_run(model);
  sides_.body_of_node.assign(model.nodes.count, -1);
  const std::vector<std::int32_t> scene_node = inverse_permutation(model.node_of_scene_node);
  for (std::size_t r = 0; r < model.rigid.size(); ++r) add_body(model, r, scene_node);
  find_common_nodes(model);
  check_motions(model.scene);
  sides_.bodies.resize(bodies_.size());
  before_.resize(bodies_.size());
  for (std::size_t b = 0; b < bodies_.size(); ++b) take_velocities(model, b, scene_node, true);
  const ContactSettings& contact = model.scene.contact;
  by_impulses_ = contact.method != ContactMethod::none && contact.enforcement == Enforcement::lagrange;
  begin_step(0, 0);
  if (model.scene.joints.empty()) return;
  std::vector<const RigidBodyMotion*> motions;
  for (const Body& body : bodies_) motions.push_back(&body.motion);
  joints_ = std::make_unique<Joints>(model.scene.joints, model.scene.rigid_bodies, motions);
  keep_joints(model);
  begin_step(0, 0);
}

template <class S>
RigidBodies<S>::~RigidBodies() {}  // GCC 12 has defined a defaulted one when it comes to the instances below

template <class S>
void RigidBodies<S>::find_common_nodes(const Model<S>& model) {
  std::vector<bool> deforms(model.nodes.count, false);
  for (std::int64_t e = 0; e < model.mesh.element_count(); ++e) {
    if (model.rigid_of_body[model.mesh.body[e]] >= 0) continue;
    for (const std::int32_t n : model.mesh.hexahedra[e]) deforms[model.node_of_scene_node[n]] = true;
  }
  for (Body& body : bodies_) {
    for (std::size_t i = 0; i < body.nodes.size(); ++i) {
      if (deforms[body.nodes[i]]) body.common.push_back(static_cast<std::int32_t>(i));
    }
  }
}

template <class S>
void RigidBodies<S>::add_body(const Model<S>& model, std::size_t number, const std::vector<std::int32_t>& scene_node) {
  const RigidBody& given = model.scene.rigid_bodies[number];
  const std::vector<std::int32_t>& nodes = model.rigid[number].nodes;
  const auto place = [&](std::size_t i) { return model.mesh.nodes[scene_node[nodes[i]]]; };
  const MassOfNodes own = mass_of(
      nodes.size(), [&](std::size_t i) { return model.node_mass[nodes[i]]; }, place);
  const bool has_own = given.inertia != std::array<Point, 3>{};
  const Point centre = given.centre.value_or(own.centre);
  const SlenderInertia slender = has_own ? SlenderInertia{given.inertia, {}} : own.slender();
  Body& body = bodies_.emplace_back(Body{
      .name = given.name,
      .nodes = nodes,
      .common = {},
      .arm = Array<double>(4 * nodes.size()),
      .held = {},
      .motions = {},
      .given = {},
      .given_by = {},
      .has_own_inertia = has_own,
      .slender = slender,
      .gravities = {},
      .acting = {},
      .motion = RigidBodyMotion(own.mass, slender.inertia, centre),
  });
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Point r = minus(place(i), centre);
    std::copy(r.begin(), r.end(), record(body.arm.data(), static_cast<std::int64_t>(i)));
    body.radius = std::max(body.radius, std::hypot(r[0], r[1], r[2]));
    sides_.body_of_node[nodes[i]] = static_cast<std::int32_t>(number);
  }
  for (std::size_t k = 0; k < 3; ++k) body.more_inertia[k] = minus(slender.inertia[k], own.inertia[k]);
  if (given.centre) {
    set_offset(minus(own.centre, centre), body);
    take_gravities(model.scene, given, body);
  }
  if (has_own) body.lightness = lightness_of(body.motion, body.more_inertia, body.offset);
  body.held.along = model.rigid[number].held;
  body.held.about = model.rigid[number].held_rotations;
  body.held.speeds.assign(body.held.along.size(), 0.0);
  body.held.angular_speeds.assign(body.held.about.size(), 0.0);
  for (std::size_t m = 0; m < motions_.size(); ++m) {
    if (motions_[m].rigid_body == given.name) body.motions.push_back(m);
  }
}

/// The nodes' masses have their moments about a given centre as if they were in their own one.
template <class S>
void RigidBodies<S>::set_offset(const Point& offset, Body& body) const {
  body.offset = offset;
  add_moments(body.more_inertia, -body.motion.mass(), offset);
}

template <class S>
void RigidBodies<S>::take_gravities(const Scene& scene, const RigidBody& given, Body& body) const {
  for (const Gravity& gravity : scene.gravities) {
    const auto is_of = [&](const std::string& name) { return std::ranges::count(gravity.bodies, name) > 0; };
    const auto count = std::ranges::count_if(given.bodies, is_of);
    if (gravity.bodies.empty() || count == std::ssize(given.bodies)) {
      body.gravities.push_back(gravity);
    } else if (count > 0) {
      throw InputError(
          fmt::format("{}: expected [[gravity]] of all bodies of the rigid body {} with a centre, or of "
                      "none",
                      given.where, given.name));
    }
  }
}

/// What turns or holds nodes on one line about some axis does so by a moment about the line, too, of which they know
/// nothing.
template <class S>
void RigidBodies<S>::check_slender(const Scene& scene, const Body& body) const {
  if (body.slender.idle.empty()) return;
  const auto refuse = [&](const std::string& where, const char* what) {
    throw InputError(
        fmt::format("{}: {} a rigid body whose nodes are on one line or in one point, {}: expected nodes "
                    "beside it, or an inertia",
                    where, what, body.name));
  };
  for (const RigidBody& given : scene.rigid_bodies) {
    const std::size_t held = body.held.about.size();
    if (given.name == body.name && held > 0 && held < 3) refuse(given.where, "held_rotations about some axes hold");
  }
  for (const std::size_t m : body.motions) {
    if (scene.rigid_motions[m].axis) refuse(scene.rigid_motions[m].where, "it turns");
  }
  for (const Joint& joint : scene.joints) {
    if (std::ranges::count(joint.bodies, body.name) > 0) refuse(joint.where, "it joins");
  }
}

/// Each of what moves a body is beside what holds it, and beside what else moves it at the same time.
template <class S>
void RigidBodies<S>::check_motions(const Scene& scene) const {
  for (const Body& body : bodies_) {
    check_slender(scene, body);
    for (std::size_t i = 0; i < body.motions.size(); ++i) {
      const RigidMotion& motion = scene.rigid_motions[body.motions[i]];
      const Point& own = motion.axis ? *motion.axis : *motion.direction;
      bool fits = true;
      for (const Point& held : motion.axis ? body.held.about : body.held.along)
        fits = fits && at_right_angles(own, held);
      for (std::size_t j = 0; j < i; ++j) {
        const RigidMotion& other = scene.rigid_motions[body.motions[j]];
        if (other.axis.has_value() != motion.axis.has_value() || !overlap(motion.when, other.when)) continue;
        fits = fits && at_right_angles(own, other.axis ? *other.axis : *other.direction);
      }
      if (fits) continue;
      throw InputError(
          fmt::format("{}: expected a direction at right angles to those in which the rigid body {} is "
                      "held, or moved by another [[rigid_motion]]",
                      motion.where, body.name));
    }
  }
}

/// With momenta of those of its nodes that are of no other body before it: what other bodies say of their velocities
/// ends where they share nodes with a rigid one. What holds the body takes its part at once, as constraints of nodes
/// do.
template <class S>
void RigidBodies<S>::take_velocities(Model<S>& model, std::size_t number, const std::vector<std::int32_t>& scene_node,
                                     bool of_start) {
  Body& body = bodies_[number];
  const RigidBody& given = model.scene.rigid_bodies[number];
  if (of_start && (given.velocity || given.angular_velocity)) {
    body.motion.set_velocities(given.velocity.value_or(Point{}),
                               body.slender.moving(given.angular_velocity.value_or(Point{})));
    body.motion.obey(body.held);
    return put_nodes(model, body);
  }
  std::vector<std::int32_t> nodes;
  for (const std::int32_t n : body.nodes) {
    const bool is_own =
        model.rigid_of_body[model.mesh.body_of_node[scene_node[n]]] == static_cast<std::int32_t>(number);
    if (!of_start || is_own || given.bodies.empty()) nodes.push_back(n);
  }
  if (nodes.empty()) nodes = body.nodes;  // others have all of them, too
  const auto x = [&](std::size_t i) {
    const S* const p = model.nodes.position_of(nodes[i]);
    return Point{p[0], p[1], p[2]};
  };
  const auto v = [&](std::size_t i) {
    const S* const p = model.nodes.velocity_of(nodes[i]);
    return Point{p[0], p[1], p[2]};
  };
  const MassOfNodes own = mass_of(
      nodes.size(), [&](std::size_t i) { return model.node_mass[nodes[i]]; }, x);
  Point velocity{}, momentum{};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) velocity[k] += model.node_mass[nodes[i]] * v(i)[k] / own.mass;
  }
  double fastest = norm(velocity);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Point turn = cross(minus(x(i), own.centre), minus(v(i), velocity));
    for (std::size_t k = 0; k < 3; ++k) momentum[k] += model.node_mass[nodes[i]] * turn[k];
    fastest = std::max(fastest, norm(v(i)));
  }
  RigidBodyMotion of_nodes(own.mass, own.slender().inertia, own.centre);
  of_nodes.state().angular_momentum = momentum;
  of_nodes.begin({});
  const Point spin = of_nodes.angular_velocity();
  for (std::size_t i = 0; i < nodes.size() && of_start; ++i) {
    const double off = norm(minus(v(i), velocity_at(velocity, spin, minus(x(i), own.centre))));
    // Nodes that are attached have the noise of their bodies, which does not move these.
    const double noise = model.scene.bodies[model.mesh.body_of_node[scene_node[nodes[i]]]].velocity_noise;
    if (off <= (sizeof(S) == sizeof(double) ? 1e-6 : 1e-4) * fastest + 4 * noise) continue;
    throw InputError(
        fmt::format("{}: the initial velocities of its nodes are no motion of the rigid body {}: expected "
                    "velocity and angular_velocity of all of it alike",
                    given.where, body.name));
  }
  const Point to_centre = minus(body.motion.state().centre, own.centre);
  body.motion.set_velocities(velocity_at(velocity, spin, to_centre), spin);
  body.motion.obey(body.held);
  put_nodes(model, body);
}

/// What its joints do not let a body do it does not begin with. Bodies: since begin_step().
template <class S>
void RigidBodies<S>::keep_joints(Model<S>& model) {
  const std::vector<JointedBody> bodies = jointed();
  const std::vector<Twist> changes = joints_->corrections(bodies);
  joints_->check_start(bodies, changes);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (changes[b].velocity == Point{} && changes[b].angular_velocity == Point{}) continue;
    change(bodies_[b].motion, changes[b]);
    put_nodes(model, bodies_[b]);
  }
}

/// Bodies whose nodes have the motion of the body keep it to the bit. Joints hold in the middle of a step, where
/// velocities are, and let less be at the places after it, of what turns: they have a say in what others have changed
/// alone.
template <class S>
void RigidBodies<S>::take_velocities(Model<S>& model) {
  const std::vector<std::int32_t> scene_node = inverse_permutation(model.node_of_scene_node);
  const auto begin = [this] {
    for (Body& body : bodies_) body.motion.begin(body.given);
  };
  begin();
  std::vector<Point> spins;
  for (const Body& body : bodies_) spins.push_back(body.motion.angular_velocity());
  const std::vector<Twist> own = joints_ ? joints_->corrections(jointed()) : std::vector<Twist>();
  bool any = false;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const std::vector<S> given = velocities_of(model, bodies_[b].nodes);
    put_nodes(model, bodies_[b]);
    if (velocities_of(model, bodies_[b].nodes) == given) continue;
    for (std::size_t i = 0; i < bodies_[b].nodes.size(); ++i)
      std::copy_n(given.data() + 3 * i, 3, model.nodes.velocity_of(bodies_[b].nodes[i]));
    take_velocities(model, b, scene_node, false);
    any = true;
  }
  begin();
  if (joints_ && any) {
    const std::vector<Twist> all = joints_->corrections(jointed());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const Twist by{minus(all[b].velocity, own[b].velocity), minus(all[b].angular_velocity, own[b].angular_velocity)};
      if (by.velocity == Point{} && by.angular_velocity == Point{}) continue;
      change(bodies_[b].motion, by);
      put_nodes(model, bodies_[b]);
    }
    begin();
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    bodies_[b].change_of_spin = minus(bodies_[b].motion.angular_velocity(), spins[b]);
}

template RigidBodies<double>::RigidBodies(Model<double>&);
template RigidBodies<float>::RigidBodies(Model<float>&);
template RigidBodies<double>::~RigidBodies();
template RigidBodies<float>::~RigidBodies();
template void RigidBodies<double>::take_velocities(Model<double>&);
template void RigidBodies<float>::take_velocities(Model<float>&);

}  // namespace pinball

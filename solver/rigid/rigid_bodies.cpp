#include "rigid_bodies.hpp"

#include <algorithm>
#include <cmath>

#include <solver/boundary/force_factor.hpp>
#include <solver/boundary/prescribed_motions.hpp>
#include <solver/boundary/space/loops.hpp>

#include "joints.hpp"

namespace pinball {

namespace {

using Space = DefaultExecutionSpace;

Point times(const std::array<Point, 3>& rows, const double* v) {
  Point product;
  for (std::size_t i = 0; i < 3; ++i) product[i] = rows[i][0] * v[0] + rows[i][1] * v[1] + rows[i][2] * v[2];
  return product;
}

/// What a body has of a given motion at the time of the forces: a speed [length/time] or an angular one [1/time].
double present_speed(const RigidBodyMotion& body, const RigidMotion& given) {
  return given.axis ? dot(body.angular_velocity(), *given.axis) : dot(body.state().velocity, *given.direction);
}

/// The motion of a body as its nodes have it.
struct CommonMotion {
  std::array<Point, 3> rotation;
  Point acceleration, angular_acceleration;

  explicit CommonMotion(const RigidBodyMotion& motion)
      : rotation(motion.rotation()),
        acceleration(motion.acceleration()),
        angular_acceleration(motion.angular_acceleration()) {}
};

/// The force of a node of the mass in the common motion, as it is stored. One copy: what was stored is subtracted.
template <class S>
[[gnu::noinline]] void common_force(const CommonMotion& motion, const double* arm, double mass, S* force) {
  const Point a = velocity_at(motion.acceleration, motion.angular_acceleration, times(motion.rotation, arm));
  for (std::size_t k = 0; k < 3; ++k) force[k] = static_cast<S>(mass * a[k]);
}

}  // namespace

template <class S>
void RigidBodies<S>::begin_step(double time, double dt) {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Body& body = bodies_[b];
    choose_given(body, time);
    body.motion.begin(body.given);
    body.shared = false;
    sides_.bodies[b] = body.motion.side();
    const Point spin = minus(body.motion.angular_velocity(), body.change_of_spin);
    if (by_impulses_) sides_.bodies[b].way_before = body.motion.way_beside(before_[b], -dt, spin);
    body.change_of_spin = {};
    before_[b] = body.motion.state();
  }
  if (joints_ && by_impulses_) joints_->set_mobility(jointed(), sides_);
}

template <class S>
void RigidBodies<S>::choose_given(Body& body, double time) const {
  body.given = body.held;
  body.given_by.clear();
  for (const bool turns : {false, true}) {
    for (const std::size_t m : body.motions) {
      const RigidMotion& motion = motions_[m];
      if (motion.axis.has_value() != turns || !motion.when.contains(time)) continue;
      (turns ? body.given.about : body.given.along).push_back(turns ? *motion.axis : *motion.direction);
      (turns ? body.given.angular_speeds : body.given.speeds).push_back(0);
      body.given_by.push_back(m);
    }
  }
}

template <class S>
double RigidBodies<S>::given_speed(const Body& body, const RigidMotion& motion, double time, double later,
                                   const StepLengths& step) const {
  const double most = motion.axis ? motion.angular_speed : motion.speed;
  if (motion.quantity != MotionQuantity::acceleration)
    return most * mean_factor(motion.table, motion.quantity, motion.when, later, step);
  return most * factor_change(motion.table, motion.quantity, motion.when, time, later, step) +
         present_speed(body.motion, motion);
}

template <class S>
void RigidBodies<S>::set_speeds(Body& body, double time, const StepLengths& step) const {
  std::size_t along = body.held.along.size(), about = body.held.about.size();
  for (const std::size_t m : body.given_by) {
    const RigidMotion& motion = motions_[m];
    double& speed = motion.axis ? body.given.angular_speeds[about++] : body.given.speeds[along++];
    speed = given_speed(body, motion, time, time, step);
  }
}

template <class S>
double RigidBodies<S>::leap(double time, double later, const StepLengths& step) const {
  double largest = 0;
  for (const Body& body : bodies_) {
    const Point &v = body.motion.state().velocity, &w = body.motion.angular_velocity();
    double along = 0, about = 0;  // squares
    const auto add = [](double& squares, double change) { squares += change * change; };
    for (const Point& held : body.held.along) add(along, dot(v, held));
    for (const Point& held : body.held.about) add(about, dot(w, held));
    for (const std::size_t m : body.motions) {
      const RigidMotion& motion = motions_[m];
      if (!motion.when.contains(later)) continue;
      const double from = std::max(time, std::min(later, motion.when.start)), now = present_speed(body.motion, motion);
      add(motion.axis ? about : along, given_speed(body, motion, from, later, step) - now);
    }
    largest = std::max(largest, std::sqrt(along) + std::sqrt(about) * body.radius);
  }
  return largest;
}

/// Gravity acts in the given centre, and has acted in that of the nodes' masses.
template <class S>
Point RigidBodies<S>::gravity_beside(const Body& body, double time, const StepLengths& step) const {
  Point moment{};
  if (body.gravities.empty()) return moment;
  const Point offset = times(body.motion.rotation(), body.offset.data());
  for (const Gravity& gravity : body.gravities) {
    const Point turning = cross(gravity.acceleration, offset);
    const double factor = force_factor(gravity.table, time, step);
    for (std::size_t k = 0; k < 3; ++k) moment[k] += body.motion.mass() * factor * turning[k];
  }
  return moment;
}

/// The wrench of all but joints. Nodes that have forces of the common motion add what they have got since.
template <class S>
void RigidBodies<S>::sum_forces(const Model<S>& model, Body& body) const {
  const CommonMotion before(body.motion);
  const S* const forces = model.nodes.force.data();
  const auto add = [&](std::int64_t i, Wrench& partial) {
    const std::int32_t n = body.nodes[i];
    const double* const arm = record(body.arm.data(), i);
    S common[3] = {0, 0, 0};
    if (body.shared) common_force(before, arm, model.node_mass[n], common);
    const S* const f = record(forces, n);
    Wrench own;
    for (std::size_t k = 0; k < 3; ++k) own.force[k] = static_cast<double>(f[k]) - static_cast<double>(common[k]);
    own.moment = cross(times(before.rotation, arm), own.force);
    partial.join(own);
  };
  if (!body.shared) body.acting = Wrench();
  add_sum<Space>("forces of a rigid body", std::ssize(body.nodes), add, body.acting);
}

template <class S>
void RigidBodies<S>::put_forces(Model<S>& model, const Body& body) const {
  S* const forces = model.nodes.force.data();
  const CommonMotion now(body.motion);
  for_each<Space>("forces of nodes of a rigid body", std::ssize(body.nodes), [&](std::int64_t i) {
    const std::int32_t n = body.nodes[i];
    common_force(now, record(body.arm.data(), i), model.node_mass[n], record(forces, n));
  });
}

template <class S>
std::vector<JointedBody> RigidBodies<S>::jointed() const {
  std::vector<JointedBody> all;
  for (const Body& body : bodies_) all.push_back({&body.motion, &body.given, body.acting});
  return all;
}

/// Of the nodes in the coming step, should nothing else act.
template <class S>
RowTensor RigidBodies<S>::way_ahead(const Body& body, const StepLengths& step) const {
  Point spin = body.motion.angular_velocity();
  for (std::size_t k = 0; k < 3; ++k) spin[k] += step.velocity() * body.motion.angular_acceleration()[k];
  RigidBodyMotion ahead = body.motion;
  ahead.move(body.given, step);
  return body.motion.way_beside(ahead.state(), step.after, spin);
}

template <class S>
void RigidBodies<S>::share_forces(Model<S>& model, double time, const StepLengths& step) {
  for (Body& body : bodies_) {
    set_speeds(body, time, step);
    sum_forces(model, body);
    if (body.shared) continue;
    body.moment_beside = gravity_beside(body, time, step);
    body.acting.join({{}, body.moment_beside});
  }
  if (joints_) joints_->solve(jointed(), step);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Body& body = bodies_[b];
    Wrench sum = body.acting;
    if (joints_) sum.join(joints_->wrench(b));
    body.motion.load(sum, body.given, step.velocity());
    if (by_impulses_ && !body.shared) sides_.bodies[b].way_after = way_ahead(body, step);
    body.shared = true;
    put_forces(model, body);
  }
}

template <class S>
void RigidBodies<S>::move(Model<S>& model, const StepLengths& step) {
  done_ += last_.now + last_.later;
  last_ = {};
  if (joints_) joints_->book(jointed(), step);
  for (Body& body : bodies_) {
    const Point &before = body.motion.angular_velocity(), &faster = body.motion.angular_acceleration();
    for (std::size_t k = 0; k < 3; ++k)
      last_.join(work_of(body.moment_beside[k], before[k], before[k] + step.velocity() * faster[k], step));
    last_.join(body.motion.move(body.given, step));
    put_nodes(model, body);
  }
}

/// Places and velocities of the nodes by those of the body.
template <class S>
void RigidBodies<S>::put_nodes(Model<S>& model, const Body& body) const {
  RigidBodyMotion motion = body.motion;
  motion.begin({});
  const RigidState& state = motion.state();
  const std::array<Point, 3> rotation = motion.rotation();
  const Point angular_velocity = motion.angular_velocity();
  S* const positions = model.nodes.position.data();
  S* const velocities = model.nodes.velocity.data();
  for_each<Space>("nodes of a rigid body", std::ssize(body.nodes), [&](std::int64_t i) {
    const std::int32_t n = body.nodes[i];
    const Point r = times(rotation, record(body.arm.data(), i));
    const Point v = velocity_at(state.velocity, angular_velocity, r);
    for (std::size_t k = 0; k < 3; ++k) {
      record(positions, n)[k] = static_cast<S>(state.centre[k] + r[k]);
      record(velocities, n)[k] = static_cast<S>(v[k]);
    }
  });
}

template <class S>
void RigidBodies<S>::put_ways(Model<S>& model, double dt) const {
  if (!(dt > 0)) return;
  S* const velocities = model.nodes.velocity.data();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Body& body = bodies_[b];
    RigidBodyMotion before = body.motion;
    before.state() = before_[b];
    const std::array<Point, 3> from = before.rotation(), to = body.motion.rotation();
    const Point& velocity = body.motion.state().velocity;
    for_each<Space>("ways of nodes of a rigid body", std::ssize(body.common), [&](std::int64_t i) {
      const double* const arm = record(body.arm.data(), body.common[i]);
      const Point r = times(to, arm), way = minus(r, times(from, arm));
      S* const put = record(velocities, body.nodes[body.common[i]]);
      for (std::size_t k = 0; k < 3; ++k) put[k] = static_cast<S>(velocity[k] + way[k] / dt);
    });
  }
}

template <class S>
void RigidBodies<S>::put_velocities(Model<S>& model) const {
  for (const Body& body : bodies_) {
    if (!body.common.empty()) put_nodes(model, body);
  }
}

template <class S>
double RigidBodies<S>::kinetic_beside(const StepLengths& step) const {
  double twice = 0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Body& body = bodies_[b];
    if (!body.has_own_inertia) continue;
    RigidBodyMotion now = body.motion;
    now.begin({});  // others may have changed it since the step began
    const Point w = now.angular_velocity();
    Point later = w;
    for (std::size_t k = 0; k < 3; ++k) later[k] += step.before * body.motion.angular_acceleration()[k];
    twice += dot(w, times(body.motion.turned(body.more_inertia), later.data()));
    const Point offset = times(body.motion.rotation(), body.offset.data()), &v = body.motion.state().velocity;
    Point v_later = v;
    for (std::size_t k = 0; k < 3; ++k) v_later[k] += step.before * body.motion.acceleration()[k];
    twice -= body.motion.mass() * (dot(v, cross(later, offset)) + dot(v_later, cross(w, offset)));
  }
  return 0.5 * twice;
}

template <class S>
Point RigidBodies<S>::momentum_beside() const {
  Point sum{};
  for (const Body& body : bodies_) {
    if (body.offset == Point{}) continue;
    RigidBodyMotion now = body.motion;
    now.begin({});
    const Point apart = cross(times(now.rotation(), body.offset.data()), now.angular_velocity());
    for (std::size_t k = 0; k < 3; ++k) sum[k] += now.mass() * apart[k];
  }
  return sum;
}

template <class S>
void RigidBodies<S>::put_positions_of_forces(std::vector<Point>& positions) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    RigidBodyMotion then = bodies_[b].motion;
    then.state() = before_[b];
    const std::array<Point, 3> rotation = then.rotation();
    for (std::size_t i = 0; i < bodies_[b].nodes.size(); ++i)
      positions[bodies_[b].nodes[i]] = position_of_forces(b, i, rotation);
  }
}

template <class S>
Point RigidBodies<S>::position_of_forces(std::size_t b, std::size_t i, const std::array<Point, 3>& rotation) const {
  const Point r = times(rotation, record(bodies_[b].arm.data(), static_cast<std::int64_t>(i)));
  return {before_[b].centre[0] + r[0], before_[b].centre[1] + r[1], before_[b].centre[2] + r[2]};
}

template <class S>
std::optional<Point> RigidBodies<S>::position_of_forces(std::int32_t node) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const std::vector<std::int32_t>& nodes = bodies_[b].nodes;
    const auto found = std::ranges::lower_bound(nodes, node);
    if (found == nodes.end() || *found != node) continue;
    RigidBodyMotion then = bodies_[b].motion;
    then.state() = before_[b];
    return position_of_forces(b, found - nodes.begin(), then.rotation());
  }
  return {};
}

template <class S>
std::vector<RigidBodyResult> RigidBodies<S>::results() const {
  std::vector<RigidBodyResult> results;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    RigidBodyMotion now = bodies_[b].motion;
    now.begin({});
    RigidBodyResult& result = results.emplace_back();
    result.name = bodies_[b].name;
    result.mass = now.mass();
    result.inertia = now.inertia();
    for (std::size_t k = 0; k < 3 && !bodies_[b].slender.idle.empty(); ++k)
      result.inertia[k] = minus(result.inertia[k], bodies_[b].more_inertia[k]);
    result.centre = before_[b].centre;
    result.velocity = now.state().velocity;
    result.angular_velocity = now.angular_velocity();
    result.angular_momentum = now.state().angular_momentum;
    result.force = now.state().reaction.force;
    result.moment = now.state().reaction.moment;
  }
  return results;
}

template <class S>
std::vector<JointResult> RigidBodies<S>::joint_results() const {
  return joints_ ? joints_->results() : std::vector<JointResult>();
}

template <class S>
void RigidBodies<S>::persist(StateArchive& archive) {
  std::vector<RigidState> states;
  for (const Body& body : bodies_) states.push_back(body.motion.state());
  archive.of_fixed_size(states);
  archive.of_fixed_size(before_);
  archive(done_, last_);
  if (joints_) joints_->persist(archive);
  if (!archive.reads()) return;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    double square = 0;
    for (const double q : states[b].orientation) square += q * q;
    archive.require(std::abs(square - 1) < 1e-9);
    bodies_[b].motion.state() = states[b];
  }
}

template <class S>
std::size_t RigidBodies<S>::bytes() const {
  std::size_t sum = sides_.body_of_node.capacity() * sizeof(std::int32_t);
  for (const Body& body : bodies_) sum += body.arm.bytes() + body.nodes.capacity() * sizeof(std::int32_t);
  return sum;
}

template class RigidBodies<double>;
template class RigidBodies<float>;

}  // namespace pinball

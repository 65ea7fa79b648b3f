#include "joints.hpp"

#include <fmt/core.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include <solver/base/error.hpp>

#include "eigen_points.hpp"
#include "joint_system.hpp"

namespace pinball {

namespace {

constexpr int most_trials = 100;

/// How far apart the places and directions of a joint may come, over the size of its bodies: what joints on axes that
/// are given to some digits keep one another from.
constexpr double most_opening = 1e-3;

/// What of the velocities at the start may be rounding of numbers that were given.
constexpr double rounding_at_start = 1e-4;

/// The side of a body with its own part of the mobility of all that it hangs together with.
void join_side(const Eigen::Matrix<double, 6, 6>& own, std::int32_t mechanism, std::int32_t number, RigidSide& side) {
  const auto symmetric = [](const Eigen::Matrix3d& m) {
    return Symmetric<double>{m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)};
  };
  const auto most = [](const Eigen::Matrix3d& m) {
    return std::max(0.0, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m, Eigen::EigenvaluesOnly).eigenvalues()[2]);
  };
  constexpr double nothing = 1e-10;  // of what it has by itself: rounding of what its joints hold
  const Eigen::Matrix3d translation = own.topLeftCorner<3, 3>(), rotation = own.bottomRightCorner<3, 3>();
  side.mechanism = mechanism;
  side.in_mechanism = number;
  if (most(translation) <= nothing * side.most_translation && most(rotation) <= nothing * side.most_rotation) {
    side.translation = side.rotation = {};
    side.most_translation = side.most_rotation = 0;
    return;
  }
  side.translation = symmetric(translation);
  side.rotation = symmetric(rotation);
  side.most_translation = most(translation);
  side.most_rotation = most(rotation);
  for (int i = 0; i < 3; ++i) side.coupling[i] = {own(i, 3), own(i, 4), own(i, 5)};
}

double largest_of(const Eigen::Vector3d& v) { return v.cwiseAbs().maxCoeff(); }

}  // namespace

Joints::Joints(const std::vector<Joint>& joints, const std::vector<RigidBody>& bodies,
               const std::vector<const RigidBodyMotion*>& motions)
    : wrench_(bodies.size()), places_(bodies.size()) {
  for (const Joint& joint : joints) {
    const auto side = [&](const std::string& name) {
      JointSide of{-1, eigen(*joint.point)};
      const auto found = std::ranges::find(bodies, name, &RigidBody::name);
      if (found == bodies.end()) return of;
      of.body = static_cast<std::int32_t>(found - bodies.begin());
      of.arm -= eigen(motions[of.body]->state().centre);
      return of;
    };
    joints_.push_back({joint, side(joint.bodies[0]), side(joint.bodies[1]), joint_rows(joint), {}});
  }
  find_groups(bodies.size());
  for (Group& group : groups_) {
    for (const std::size_t b : group.bodies) {
      const Eigen::Matrix3d inertia = eigen(motions[b]->inertia());
      group.size = std::max(group.size, std::sqrt(0.5 * inertia.trace() / motions[b]->mass()));
    }
    for (const std::size_t j : group.joints) {
      for (const JointSide* side : {&joints_[j].first, &joints_[j].second}) {
        if (side->body >= 0) group.size = std::max(group.size, side->arm.norm());
      }
    }
  }
}

void Joints::find_groups(std::size_t bodies) {
  std::vector<std::size_t> first(bodies);
  for (std::size_t b = 0; b < bodies; ++b) first[b] = b;
  const auto root = [&](std::size_t b) {
    while (first[b] != b) b = first[b];
    return b;
  };
  const auto body_of = [](const One& one) {
    return static_cast<std::size_t>(std::max(one.first.body, one.second.body));
  };
  for (const One& one : joints_) {
    if (one.first.body < 0 || one.second.body < 0) continue;
    const std::size_t a = root(one.first.body), b = root(one.second.body);
    first[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::int64_t> group_of(bodies, -1);  // of a root
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    std::int64_t& group = group_of[root(body_of(joints_[j]))];
    if (group < 0) {
      group = std::ssize(groups_);
      groups_.emplace_back();
    }
    groups_[group].joints.push_back(j);
  }
  for (std::size_t b = 0; b < bodies; ++b) {
    if (const std::int64_t group = group_of[root(b)]; group >= 0) groups_[group].bodies.push_back(b);
  }
}

JointGeometry Joints::geometry(const One& one, std::span<const BodyPlace> places) const {
  const auto place = [&](const JointSide& side) { return side.body < 0 ? BodyPlace() : places[side.body]; };
  return {place(one.first), place(one.second), one.first.arm, one.second.arm};
}

JointSystem Joints::system(const Group& group, std::span<const JointedBody> bodies) const {
  JointSystem system;
  for (const std::size_t j : group.joints) {
    const One& one = joints_[j];
    const JointGeometry now = geometry(one, places_);
    for (const JointRow& row : one.rows) {
      RowGradient gradient = now.gradient(row);
      if (row.turns) gradient = {gradient.force, group.size * gradient.first, group.size * gradient.second};
      system.add({one.first.body, one.second.body, gradient});
    }
  }
  system.decompose([&](std::int32_t body) -> const RigidSide& { return bodies[body].motion->side(); });
  return system;
}

Eigen::VectorXd Joints::values(const Group& group, std::span<const BodyPlace> places) const {
  std::vector<double> all;
  for (const std::size_t j : group.joints) {
    const JointGeometry then = geometry(joints_[j], places);
    for (const JointRow& row : joints_[j].rows) all.push_back((row.turns ? group.size : 1) * then.value(row));
  }
  return Eigen::Map<const Eigen::VectorXd>(all.data(), std::ssize(all));
}

void Joints::place(std::span<const JointedBody> bodies) {
  for (std::size_t b = 0; b < bodies.size(); ++b) places_[b] = place_of(*bodies[b].motion);
}

void Joints::solve(std::span<const JointedBody> bodies, const StepLengths& step) {
  std::ranges::fill(wrench_, Wrench());
  place(bodies);
  for (const Group& group : groups_) {
    const JointSystem system = this->system(group, bodies);
    Eigen::VectorXd impulses = Eigen::VectorXd::Zero(system.size());
    if (step.after > 0) {
      close(group, system, bodies, step, impulses);
    } else if (step.velocity() > 0) {
      stop(group, system, bodies, step, impulses);
    }
    keep(group, system, impulses, step.velocity());
  }
}

/// A body with its acceleration by what acts on it and by its joints.
RigidBodyMotion Joints::loaded(const JointedBody& body, const Wrench& of_joints, const StepLengths& step) {
  RigidBodyMotion motion = *body.motion;
  Wrench sum = body.acting;
  sum.join(of_joints);
  motion.load(sum, *body.given, step.velocity());
  return motion;
}

void Joints::close(const Group& group, const JointSystem& system, std::span<const JointedBody> bodies,
                   const StepLengths& step, Eigen::VectorXd& impulses) {
  std::vector<BodyPlace> then(bodies.size());
  std::vector<Wrench> wrench(bodies.size());
  double before = std::numeric_limits<double>::infinity(), reach = group.size;
  for (const std::size_t j : group.joints) reach = std::max(reach, largest_of(geometry(joints_[j], places_).place()));
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * reach;
  Eigen::VectorXd open;
  for (int trial = 0; trial < most_trials; ++trial) {
    for (const std::size_t b : group.bodies) wrench[b] = Wrench();
    system.add_wrenches(impulses, 1 / step.velocity(), wrench);
    for (const std::size_t b : group.bodies) {
      RigidBodyMotion motion = loaded(bodies[b], wrench[b], step);
      motion.move(*bodies[b].given, step);
      then[b] = place_of(motion);
    }
    open = values(group, then);
    const double most = open.cwiseAbs().maxCoeff();
    if (!(most > rounding) || most > 0.5 * before) break;
    before = most;
    impulses -= system.solve(open) / step.after;
  }
  std::int64_t row = 0;
  for (const std::size_t j : group.joints) {
    One& one = joints_[j];
    const std::int64_t rows = std::ssize(one.rows);
    one.state.opening = open.segment(row, rows).cwiseAbs().maxCoeff() / group.size;
    row += rows;
    if (one.state.opening <= most_opening) continue;
    throw RunError(
        fmt::format("{}: joint {} of {} and {} cannot stay closed, they would part by {:.3g} of their size: expected "
                    "nothing that holds or moves its bodies, and no other joint, against it",
                    one.joint.where, one.joint.name, one.joint.bodies[0], one.joint.bodies[1], one.state.opening));
  }
}

void Joints::stop(const Group& group, const JointSystem& system, std::span<const JointedBody> bodies,
                  const StepLengths& step, Eigen::VectorXd& impulses) const {
  constexpr int trials = 3;  // it is linear: the others for what rounding has left
  std::vector<Twist> twists(bodies.size());
  std::vector<Wrench> wrench(bodies.size());
  for (int trial = 0; trial < trials; ++trial) {
    for (const std::size_t b : group.bodies) wrench[b] = Wrench();
    system.add_wrenches(impulses, 1 / step.velocity(), wrench);
    for (const std::size_t b : group.bodies) {
      const RigidBodyMotion motion = loaded(bodies[b], wrench[b], step);
      const Point &v = motion.state().velocity, &w = motion.angular_velocity();
      for (std::size_t k = 0; k < 3; ++k) {
        twists[b].velocity[k] = v[k] + step.velocity() * motion.acceleration()[k];
        twists[b].angular_velocity[k] = w[k] + step.velocity() * motion.angular_acceleration()[k];
      }
    }
    impulses -= system.solve(system.rates(twists));
  }
}

void Joints::keep(const Group& group, const JointSystem& system, const Eigen::VectorXd& impulses,
                  double velocity_step) {
  const double per = velocity_step > 0 ? 1 / velocity_step : 0.0;
  system.add_wrenches(impulses, per, wrench_);
  std::int64_t at = 0;
  for (const std::size_t j : group.joints) {
    One& one = joints_[j];
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;
    for (const JointRow& row : one.rows) {
      const RowGradient& gradient = system.gradient(at);
      const double size = per * impulses[at++];
      force -= size * gradient.force;
      if (row.turns) moment += size * gradient.first;
    }
    one.state.reaction = {point(force), point(moment)};
  }
}

/// The work of what it does to the first body and, opposite, to the second one.
void Joints::book(std::span<const JointedBody> bodies, const StepLengths& step) {
  for (One& one : joints_) {
    const Point place = point(geometry(one, places_).place());
    const auto twist = [&](const JointSide& side, double time) {
      if (side.body < 0) return Twist();
      const RigidBodyMotion& motion = *bodies[side.body].motion;
      Twist at{motion.state().velocity, motion.angular_velocity()};
      for (std::size_t k = 0; k < 3; ++k) {
        at.velocity[k] += time * motion.acceleration()[k];
        at.angular_velocity[k] += time * motion.angular_acceleration()[k];
      }
      at.velocity = velocity_at(at.velocity, at.angular_velocity, minus(place, motion.state().centre));
      return at;
    };
    const auto rates = [&](double time) {
      const Twist first = twist(one.first, time), second = twist(one.second, time);
      return Twist{minus(first.velocity, second.velocity), minus(first.angular_velocity, second.angular_velocity)};
    };
    const Twist before = rates(0), after = rates(step.velocity());
    State& state = one.state;
    state.done += state.last.now + state.last.later;
    state.last = {};
    for (std::size_t k = 0; k < 3; ++k) {
      state.last.join(work_of(state.reaction.force[k], before.velocity[k], after.velocity[k], step));
      state.last.join(work_of(state.reaction.moment[k], before.angular_velocity[k], after.angular_velocity[k], step));
    }
  }
}

std::vector<Twist> Joints::corrections(std::span<const JointedBody> bodies) {
  std::vector<Twist> changes(bodies.size()), twists;
  place(bodies);
  for (const JointedBody& body : bodies)
    twists.push_back({body.motion->state().velocity, body.motion->angular_velocity()});
  for (const Group& group : groups_) {
    const JointSystem system = this->system(group, bodies);
    std::vector<Wrench> impulse(bodies.size());
    system.add_wrenches(system.solve(system.rates(twists)), -1, impulse);
    for (const std::size_t b : group.bodies) {
      const RigidSide& side = bodies[b].motion->side();
      changes[b] = {point(eigen(side.translation) * eigen(impulse[b].force)),
                    point(eigen(side.rotation) * eigen(impulse[b].moment))};
    }
  }
  return changes;
}

void Joints::check_start(std::span<const JointedBody> bodies, const std::vector<Twist>& changes) const {
  for (const Group& group : groups_) {
    double fastest = 0;
    for (const std::size_t b : group.bodies) {
      const RigidBodyMotion& motion = *bodies[b].motion;
      fastest = std::max(fastest, norm(motion.state().velocity) + group.size * norm(motion.angular_velocity()));
    }
    for (const std::size_t j : group.joints) {
      for (const JointSide* side : {&joints_[j].first, &joints_[j].second}) {
        if (side->body < 0) continue;
        const Twist& change = changes[side->body];
        const double wrong = norm(change.velocity) + group.size * norm(change.angular_velocity);
        if (!(wrong > rounding_at_start * fastest)) continue;
        const Joint& joint = joints_[j].joint;
        throw InputError(
            fmt::format("{}: expected velocities of {} and {} at the start that joint {} lets them have; the "
                        "nearest such differ by {:.3g} of the fastest",
                        joint.where, joint.bodies[0], joint.bodies[1], joint.name, wrong / fastest));
      }
    }
  }
}

/// M^-1 - M^-1 G^T K^+ G M^-1, by what a unit of each impulse and moment does.
RigidMechanism Joints::mechanism(const Group& group, std::span<const JointedBody> bodies) const {
  const JointSystem system = this->system(group, bodies);
  const std::size_t width = 6 * group.bodies.size();
  RigidMechanism all;
  all.mobility.resize(width * width);
  for (const std::size_t b : group.bodies) all.bodies.push_back(static_cast<std::int32_t>(b));
  const auto moved = [&](std::size_t b, const Wrench& by) {
    const RigidSide& side = bodies[b].motion->side();
    return Twist{point(eigen(side.translation) * eigen(by.force)), point(eigen(side.rotation) * eigen(by.moment))};
  };
  for (std::size_t column = 0; column < width; ++column) {
    std::vector<Wrench> unit(bodies.size());
    std::vector<Twist> twists(bodies.size());
    const std::size_t own = group.bodies[column / 6], k = column % 6;
    (k < 3 ? unit[own].force : unit[own].moment)[k % 3] = 1;
    twists[own] = moved(own, unit[own]);
    system.add_wrenches(system.solve(system.rates(twists)), -1, unit);
    for (std::size_t row = 0; row < width; ++row) {
      const std::size_t b = group.bodies[row / 6];
      const Twist twist = moved(b, unit[b]);
      all.mobility[row * width + column] = (row % 6 < 3 ? twist.velocity : twist.angular_velocity)[row % 3];
    }
  }
  for (std::size_t row = 0; row < width; ++row) {  // as far as rounding lets it be
    for (std::size_t column = 0; column < row; ++column) {
      double &a = all.mobility[row * width + column], &b = all.mobility[column * width + row];
      a = b = 0.5 * (a + b);
    }
  }
  return all;
}

void Joints::set_mobility(std::span<const JointedBody> bodies, RigidSides& sides) {
  place(bodies);
  sides.mechanisms.clear();
  for (const Group& group : groups_) {
    const auto number = static_cast<std::int32_t>(sides.mechanisms.size());
    const RigidMechanism& all = sides.mechanisms.emplace_back(mechanism(group, bodies));
    const std::int64_t width = 6 * std::ssize(group.bodies);
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Map<const Rows> mobility(all.mobility.data(), width, width);
    for (std::int32_t i = 0; i < std::ssize(group.bodies); ++i)
      join_side(mobility.block(6 * i, 6 * i, 6, 6), number, i, sides.bodies[group.bodies[i]]);
  }
}

std::vector<JointResult> Joints::results() const {
  std::vector<JointResult> results;
  for (const One& one : joints_) {
    const State& state = one.state;
    results.push_back(
        {one.joint.name, state.reaction.force, state.reaction.moment, state.done + state.last.now, state.opening});
  }
  return results;
}

void Joints::persist(StateArchive& archive) {
  std::vector<State> states;
  for (const One& one : joints_) states.push_back(one.state);
  archive.of_fixed_size(states);
  for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j].state = states[j];
}

}  // namespace pinball

#include <algorithm>
#include <cmath>
#include <limits>

#include "rigid_bodies.hpp"

/// What rigid bodies ask of the length of a step.
namespace pinball {

namespace {

/// Of a step [rad]: contact sees velocities that are those of its beginning.
constexpr double most_turned = 0.01;

}  // namespace

template <class S>
double RigidBodies<S>::longest_step() const {
  double fastest = 0;
  for (const Body& body : bodies_) {
    fastest = std::max(fastest, norm(body.motion.angular_velocity()));
    for (const double speed : body.given.angular_speeds) fastest = std::max(fastest, std::abs(speed));
  }
  return std::min(of_run_, fastest > 0 ? most_turned / fastest : std::numeric_limits<double>::infinity());
}

template <class S>
double RigidBodies<S>::lightness_in_springs(const Model<S>& model) const {
  double most = 1;
  for (const Body& body : bodies_) {
    if (!(body.lightness > most)) continue;
    const bool touched =
        std::ranges::any_of(body.nodes, [&](std::int32_t n) { return record(model.nodes.force.data(), n)[3] > S(0); });
    if (touched) most = body.lightness;
  }
  return most;
}

/// Of many bodies nearly always all are known to be slower by what they have beside the first.
template <class S>
double RigidBodies<S>::relative_speed(const std::vector<BodySpeed>& others, double leap, double least) const {
  std::vector<BodySpeed> all;
  for (const Body& body : bodies_) {
    all.push_back({body.motion.state().velocity, norm(body.motion.angular_velocity()) * body.radius + leap});
  }
  const std::size_t own = all.size();
  all.insert(all.end(), others.begin(), others.end());
  double beside_first = 0;
  for (const BodySpeed& one : all) {
    beside_first = std::max(beside_first, norm(minus(one.velocity, all.front().velocity)) + one.spread);
  }
  if (2 * beside_first <= least) return 0;
  double fastest = 0;
  for (std::size_t a = 0; a < own; ++a) {
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      fastest = std::max(fastest, norm(minus(all[a].velocity, all[b].velocity)) + all[a].spread + all[b].spread);
    }
  }
  return fastest > least ? fastest : 0.0;
}

template double RigidBodies<double>::longest_step() const;
template double RigidBodies<float>::longest_step() const;
template double RigidBodies<double>::lightness_in_springs(const Model<double>&) const;
template double RigidBodies<float>::lightness_in_springs(const Model<float>&) const;
template double RigidBodies<double>::relative_speed(const std::vector<BodySpeed>&, double, double) const;
template double RigidBodies<float>::relative_speed(const std::vector<BodySpeed>&, double, double) const;

}  // namespace pinball

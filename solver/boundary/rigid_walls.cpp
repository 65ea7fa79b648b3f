#include "rigid_walls.hpp"

#include <algorithm>
#include <cmath>

namespace pinball {

template <class S>
void RigidWalls<S>::react(const NodeArrays<S>& nodes, Wall& wall, WallResult& result, double time,
                          const StepLengths& step) {
  // The last step has no length: the forces are those of one more step like the one before.
  const double position_step = step.after > 0 ? step.after : step.before;
  const double velocity_step = step.after > 0 ? step.velocity() : step.before;
  result.row_displacement = result.displacement;
  const auto way = static_cast<S>(result.displacement);
  WallStep<S> at{static_cast<S>(position_step), static_cast<S>(velocity_step), way, way};
  const auto ends_at = [&](double velocity) {
    at.after = static_cast<S>(result.displacement + position_step * velocity);
  };
  double velocity = 0;
  if (wall.motion.is_pushed()) {
    velocity = wall.motion.pushed_velocity(result.velocity, velocity_step, [&](double v) {
      ends_at(v);
      return wall.nodes->push(nodes, wall.plane, at);
    });
    ends_at(velocity);
  } else if (wall.motion.moves()) {
    velocity = wall.motion.given_velocity(time, step);
    ends_at(velocity);
  }
  const auto [sum, closing] = wall.nodes->stop(nodes, wall.plane, at);
  closing_ = std::max(closing_, closing);
  if (wall.motion.moves()) {
    result.velocity = wall.motion.velocity_after(result.velocity, velocity, step.velocity() * sum);
    result.displacement += step.after * result.velocity;
  }
  result.force = sum;
  result.force_max = std::max(result.force_max, sum);
  result.impulse += sum * step.velocity();
}

template <class S>
std::vector<NodeBound> RigidWalls<S>::bounds(const NodeArrays<S>& nodes, std::span<const std::int32_t> of, double time,
                                             const StepLengths& step) const {
  std::vector<NodeBound> found;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const Wall& wall = walls_[w];
    if (wall.takes.empty() || !wall.when.contains(time)) continue;
    const WallResult& result = results_[w];
    double velocity = 0;
    if (wall.motion.moves()) {
      velocity = wall.motion.is_pushed() ? result.velocity : wall.motion.given_velocity(time, step);
    }
    const double after = result.displacement + step.after * velocity;
    const S* const n = wall.plane.normal;
    for (const std::int32_t node : of) {
      const S* const x = nodes.position + 4 * std::int64_t(node);
      const S* const v = nodes.velocity + 4 * std::int64_t(node);
      if (wall.takes[node] == 0) continue;
      if (!wall_takes(wall.plane, x, static_cast<S>(result.displacement))) continue;
      const double rate = n[0] * v[0] + n[1] * v[1] + n[2] * v[2], height = wall_height(wall.plane, x);
      found.push_back({node,
                       static_cast<std::int32_t>(w),
                       {n[0], n[1], n[2]},
                       height - after,
                       height - result.displacement,
                       velocity - rate,
                       std::min<double>(wall.plane.friction, infinite_friction<double>),
                       {v[0] - rate * n[0], v[1] - rate * n[1], v[2] - rate * n[2]}});
    }
  }
  return found;
}

template <class S>
void RigidWalls<S>::apply(const NodeArrays<S>& nodes, double time, const StepLengths& step) {
  closing_ = 0;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    Wall& wall = walls_[w];
    WallResult& result = results_[w];
    if (!wall.when.contains(time)) {
      wall.nodes->clear_reactions();
      result.force = 0;
      if (!wall.motion.is_pushed()) result.velocity = 0;  // as its displacement, which stays
      result.row_displacement = result.displacement;
      continue;
    }
    react(nodes, wall, result, time, step);
  }
}

template <class S>
double RigidWalls<S>::leap(double time, double later, const StepLengths& step) const {
  double largest = 0;
  for (const Wall& wall : walls_) {
    if (!wall.motion.moves() || wall.motion.is_pushed()) continue;
    if (!wall.when.contains(time - step.before) || !wall.when.contains(later)) continue;
    const double before = step.before > 0 ? wall.motion.given_velocity(time - step.before, {0, step.before})
                                          : wall.motion.given_velocity(time, step);
    largest = std::max(largest, std::abs(wall.motion.given_velocity(later, step) - before));
  }
  return largest;
}

template <class S>
void RigidWalls<S>::add_held_parts(const NodeArrays<S>& nodes, double time) {
  for (Wall& wall : walls_) {
    if (wall.when.contains(time)) wall.nodes->push_held(nodes, wall.plane);
  }
}

template <class S>
ExternalWork RigidWalls<S>::work(const NodeArrays<S>& nodes, const StepLengths& step) const {
  ExternalWork sum;
  for (const Wall& wall : walls_) wall.nodes->add_work(nodes, wall.plane, step, sum);
  return sum;
}

template <class S>
std::size_t RigidWalls<S>::bytes() const {
  std::size_t sum = 0;
  for (const Wall& wall : walls_) sum += wall.nodes->bytes() + wall.takes.capacity();
  return sum;
}

template class RigidWalls<double>;
template class RigidWalls<float>;

}  // namespace pinball

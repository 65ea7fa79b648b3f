#pragma once

#include <cmath>

#include "node_arrays.hpp"
#include "wall_friction.hpp"

/// Planes that no node crosses. A node that would lie behind the plane after the step gets the normal force that puts
/// it on the plane:
///
///     N = -g / (dt_(n+1/2) (dt_(n-1/2) + dt_(n+1/2))/2 / m) ,  g = n.(x_(n+1) - p) < 0 without the wall.
namespace pinball {

/// Lengths of the coming step, and where the wall is before and after it.
template <class S>
struct WallStep {
  S position, velocity;  ///< [time]
  S before, after;       ///< way of the wall along its normal [length]
};

/// The nodes of a wall.
template <class S>
struct WallNodes {
  const std::int32_t* nodes;  ///< the last ones are held along directions to which the wall pushes or rubs them
  std::int64_t plain;         ///< how many of them are not
  const WallHold<S>* hold;    ///< of each of the last nodes
  S* reaction;                ///< per node [force]
  S* drag;                    ///< friction, three numbers per node with a reaction; null: there is none [force]
};

/// What nodes would do to a wall that ends the step with some velocity.
struct WallPush {
  double force = 0;  ///< that puts all of them on it [force]
  double slope = 0;  ///< how much more, over velocity [force time/length]

  PINBALL_FUNCTION void join(const WallPush& other) {
    force += other.force;
    slope += other.slope;
  }
};

/// What nodes and a wall come to in a step.
struct WallStop {
  double force = 0;    ///< of the reactions along the normal [force]
  double closing = 0;  ///< fastest of the nodes that would come to the wall in two more such steps [length/time]

  PINBALL_FUNCTION void join(const WallStop& other) {
    force += other.force;
    closing = closing > other.closing ? closing : other.closing;
  }
};

/// Direction in which the wall can push its i-th node.
template <class S>
PINBALL_FUNCTION const S* wall_direction(const WallPlane<S>& wall, const WallNodes<S>& of, std::int64_t i) {
  return i < of.plain ? wall.normal : of.hold[i - of.plain].free;
}

/// Whether a node is where the wall is, and, of a wall that ends, not past it. way: of the wall before the step.
template <class S>
PINBALL_FUNCTION bool wall_takes(const WallPlane<S>& wall, const S* x, S way) {
  if (!wall.ends) return true;
  S gap = -way, along[2] = {S(0), S(0)};
  for (int k = 0; k < 3; ++k) {
    gap += wall.normal[k] * (x[k] - wall.point[k]);
    along[0] += wall.edge[k] * (x[k] - wall.point[k]);
    along[1] += wall.across[k] * (x[k] - wall.point[k]);
  }
  for (int side = 0; side < 2; ++side) {
    if (wall.size[side] > S(0) && (along[side] < S(0) || along[side] > wall.size[side])) return false;
  }
  return gap > -wall.past;
}

/// What a force on a node moves it by within the step [length/force].
template <class S>
PINBALL_FUNCTION S wall_mobility(const NodeArrays<S>& nodes, std::int64_t node, const WallStep<S>& step) {
  return step.position * step.velocity * nodes.inverse_mass[node];
}

/// Of a node before the step, from where the wall was at the start.
template <class S>
PINBALL_FUNCTION S wall_height(const WallPlane<S>& wall, const S* x) {
  S height = 0;
  for (int k = 0; k < 3; ++k) height += wall.normal[k] * (x[k] - wall.point[k]);
  return height;
}

/// Of a node after the step, without the wall, from where the wall would be if it kept still.
template <class S>
PINBALL_FUNCTION S wall_gap(const NodeArrays<S>& nodes, const WallPlane<S>& wall, std::int64_t node,
                            const WallStep<S>& step) {
  const S *x = nodes.position + 4 * node, *v = nodes.velocity + 4 * node, *f = nodes.force + 4 * node;
  const S mobility = wall_mobility(nodes, node, step);
  S gap = 0;
  for (int k = 0; k < 3; ++k) {
    gap += wall.normal[k] * ((x[k] - wall.point[k]) + step.position * v[k] + mobility * f[k]);
  }
  return gap;
}

/// Velocity along the normal after the step, without the wall [length/time].
template <class S>
PINBALL_FUNCTION S wall_rate(const NodeArrays<S>& nodes, const WallPlane<S>& wall, std::int64_t node,
                             const WallStep<S>& step) {
  const S *v = nodes.velocity + 4 * node, *f = nodes.force + 4 * node;
  const S change = step.velocity * nodes.inverse_mass[node];
  S rate = 0;
  for (int k = 0; k < 3; ++k) rate += wall.normal[k] * (v[k] + change * f[k]);
  return rate;
}

/// What the gap of nodes after the step is made of, along the normal of a wall.
template <class T>
struct WallGap {
  T height, rise;  ///< above the plane; up from there within the step
  T size;          ///< of all that is added up

  /// The part along axis k of nodes with these places, ways by velocity and ways by force.
  PINBALL_FUNCTION void add(const WallPlane<ScalarOf<T>>& wall, int k, const T& x, const T& by_velocity,
                            const T& by_force) {
    const T normal(wall.normal[k]), from = normal * (x - T(wall.point[k]));
    const T coasting = normal * by_velocity, pushed = normal * by_force;
    height += from;
    rise += coasting + pushed;
    size += absolute(from) + absolute(coasting) + absolute(pushed);
  }
};

/// Whether all nodes of a pack are so far from a wall that StopAtWall has nothing to do for them: neither behind it
/// after the step, nor after two more like it. Not where rounding alone might say so, not of what is no number, nor
/// where nodes do not lie in a row. node: width_of<T> of them, in any order.
template <class T>
PINBALL_FUNCTION bool wall_is_far(const NodeArrays<ScalarOf<T>>& nodes, const WallPlane<ScalarOf<T>>& wall,
                                  const std::int32_t* node, const WallStep<ScalarOf<T>>& step) {
  using S = ScalarOf<T>;
  bool in_a_row = true;
  for (int lane = 1; lane < width_of<T>; ++lane) in_a_row = in_a_row && node[lane] == node[0] + lane;
  if (!in_a_row) return false;
  const std::int64_t first = node[0];
  const Vec3<T> x = vectors_from<T>(nodes.position, first), v = vectors_from<T>(nodes.velocity, first),
                f = vectors_from<T>(nodes.force, first);
  const T dt(step.position), mobility = T(step.position * step.velocity) * numbers_from<T>(nodes.inverse_mass, first);
  WallGap<T> of{T(0), T(0), T(absolute(step.after) + absolute(step.before))};
  of.add(wall, 0, x.x, dt * v.x, mobility * f.x);
  of.add(wall, 1, x.y, dt * v.y, mobility * f.y);
  of.add(wall, 2, x.z, dt * v.z, mobility * f.z);
  const T gap = of.height + of.rise - T(step.after);
  const T later = gap + T(2) * of.rise - T(S(2) * (step.after - step.before));
  const T room = T(sizeof(S) == 8 ? S(0x1p-46) : S(0x1p-17)) * of.size;  // 64 times the last digit
  return !any_lane(!(gap > room && later > room));
}

/// Sums up what the nodes do to a wall that ends up at step.after.
template <class S>
struct PushWall {
  using Number = S;

  NodeArrays<S> nodes;
  WallPlane<S> wall;
  WallNodes<S> of;
  WallStep<S> step;

  template <class T>
  PINBALL_FUNCTION bool passes(std::int64_t first) const {
    return wall_is_far<T>(nodes, wall, of.nodes + first, step);
  }
  PINBALL_FUNCTION void operator()(std::int64_t i, WallPush& sum) const {
    const auto node = std::int64_t(of.nodes[i]);
    const double depth = step.after - wall_gap(nodes, wall, node, step);
    const S mobility = wall_mobility(nodes, node, step);
    if (!(depth > 0) || !(mobility > S(0))) return;
    if (!wall_takes(wall, nodes.position + 4 * node, step.before)) return;
    const S* d = wall_direction(wall, of, i);
    const double give = mobility * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    sum.force += depth / give;
    sum.slope += step.position / give;
  }
};

/// Sets the reactions on the nodes of a wall and adds them to their forces.
template <class S>
struct StopAtWall {
  using Number = S;

  NodeArrays<S> nodes;
  WallPlane<S> wall;
  WallNodes<S> of;
  WallStep<S> step;

  template <class T>
  PINBALL_FUNCTION bool passes(std::int64_t first) const {
    if (!wall_is_far<T>(nodes, wall, of.nodes + first, step)) return false;
    store(T(0), of.reaction + first);
    return true;
  }
  PINBALL_FUNCTION void operator()(std::int64_t i, WallStop& sum) const {
    const auto node = std::int64_t(of.nodes[i]);
    const S *x = nodes.position + 4 * node, *v = nodes.velocity + 4 * node;
    S* f = nodes.force + 4 * node;
    const S mobility = wall_mobility(nodes, node, step);
    const S over = wall_gap(nodes, wall, node, step) - step.after;
    of.reaction[i] = S(0);
    if (of.drag != nullptr) {
      for (int k = 0; k < 3; ++k) of.drag[3 * i + k] = S(0);
    }
    if (!(mobility > S(0)) || !wall_takes(wall, x, step.before)) return;
    if (!(over < S(0))) {
      const S rate = (step.after - step.before) / step.position - wall_rate(nodes, wall, node, step);
      if (S(2) * step.position * rate > over) sum.join({0, rate});
      return;
    }
    const S* d = wall_direction(wall, of, i);
    const S free = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];  // 1 where nothing else holds the node
    const bool is_held = i >= of.plain;
    if (is_held && of.drag != nullptr) {
      rub_held(i, -over / mobility, v, f);
    } else {
      const S reaction = -over / (mobility * free);
      for (int k = 0; k < 3; ++k) f[k] += reaction * d[k];
      of.reaction[i] = reaction;
    }
    const S reaction = of.reaction[i];
    if (!is_held && of.drag != nullptr) {
      S stopping[3];
      wall_drag(wall, reaction, v, f, step.velocity, nodes.inverse_mass[node], stopping);
      for (int k = 0; k < 3; ++k) of.drag[3 * i + k] = stopping[k];
      for (int k = 0; k < 3; ++k) f[k] += stopping[k];
    }
    // A node that the wall puts on its plane still comes towards it; the next step takes that.
    const S left = wall_height(wall, x) - step.before;
    sum.join({reaction, left / step.position});
  }

 private:
  /// needed: N d.d without friction [force].
  PINBALL_FUNCTION void rub_held(std::int64_t i, S needed, const S* v, S* f) const {
    const WallHold<S>& hold = of.hold[i - of.plain];
    const S change = step.velocity * nodes.inverse_mass[of.nodes[i]];
    const S* d = hold.free;
    const S without = needed / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    S w[3], size = 0;
    for (int k = 0; k < 3; ++k) {
      w[k] = v[k] + change * (f[k] + without * d[k]);
      size += std::abs(v[k]) + change * (std::abs(f[k]) + std::abs(without * d[k]));
    }
    const S rounding = sizeof(S) == 8 ? S(0x1p-44) : S(0x1p-17);
    const WallRub<S> rub = wall_rub_of_held(wall, hold, needed, w, rounding * size, change);
    of.reaction[i] = rub.reaction;
    S push[3], follows[3];
    for (int k = 0; k < 3; ++k) {
      of.drag[3 * i + k] = rub.drag[k];
      push[k] = rub.reaction * wall.normal[k] + rub.drag[k];
    }
    across_held(hold, push, follows);
    for (int k = 0; k < 3; ++k) f[k] += follows[k];
  }
};

/// Adds the parts of the reactions that nodes which are held do not follow: what holds them takes these up.
template <class S>
struct PushHeldNodes {
  NodeArrays<S> nodes;
  WallPlane<S> wall;
  WallNodes<S> of;

  PINBALL_FUNCTION void operator()(std::int64_t held) const {
    const std::int64_t i = of.plain + held;
    if (of.reaction[i] == S(0)) return;
    S push[3], follows[3];
    for (int k = 0; k < 3; ++k) {
      push[k] = of.reaction[i] * wall.normal[k] + (of.drag == nullptr ? S(0) : of.drag[3 * i + k]);
    }
    across_held(of.hold[held], push, follows);
    S* f = nodes.force + 4 * std::int64_t(of.nodes[i]);
    for (int k = 0; k < 3; ++k) f[k] += push[k] - follows[k];
  }
};

/// Sums up the work of the reactions that StopAtWall has set.
template <class S>
struct WorkOfWall {
  using Number = S;

  NodeArrays<S> nodes;
  WallPlane<S> wall;
  WallNodes<S> of;
  StepLengths step;

  template <class T>
  PINBALL_FUNCTION bool passes(std::int64_t first) const {
    return !any_lane(!(load<T>(of.reaction + first) == T(0)));
  }
  PINBALL_FUNCTION void operator()(std::int64_t i, ExternalWork& sum) const {
    if (of.reaction[i] == S(0)) return;
    S reaction[3];
    for (int k = 0; k < 3; ++k) {
      reaction[k] = of.reaction[i] * wall.normal[k] + (of.drag == nullptr ? S(0) : of.drag[3 * i + k]);
    }
    sum.join(work_on_node(nodes, of.nodes[i], reaction, step));
  }
};

}  // namespace pinball

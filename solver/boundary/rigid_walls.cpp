#include "rigid_walls.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include <kernels/exec.hpp>
#include <solver/base/error.hpp>
#include <solver/base/point.hpp>
#include <solver/model/model_surface.hpp>
#include <solver/model/node_selection.hpp>

namespace pinball {

namespace {

/// A point of the plane that is not far from the mesh: what lies far away in the plane moves it across when it is
/// rounded.
Point near_point(const Plane& plane, const Point& node, double mesh_size) {
  const Point away = minus(node, plane.point);
  if (!(norm(away) > 16 * mesh_size)) return plane.point;
  const double gap = dot(away, plane.normal);
  Point foot = node;
  for (std::size_t k = 0; k < 3; ++k) foot[k] -= gap * plane.normal[k];
  return foot;
}

}  // namespace

template <class S>
RigidWalls<S>::RigidWalls(const Model<S>& model) {
  if (model.scene.rigid_walls.empty()) return;
  const HeldDirections held = held_directions(model);
  const double size = mesh_size(model.mesh), tolerance = 1e-9 * size;
  for (const RigidWall& given : model.scene.rigid_walls) {
    Wall wall{};
    const Point point = near_point(given.plane, model.mesh.nodes[0], size);
    for (std::size_t k = 0; k < 3; ++k) {
      wall.point[k] = static_cast<S>(point[k]);
      wall.normal[k] = static_cast<S>(given.plane.normal[k]);
    }
    wall.friction = static_cast<S>(given.friction);
    std::vector<std::pair<std::int32_t, std::array<S, 3>>> oblique;
    for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
      const std::string& body = model.mesh.body_names[model.mesh.body_of_node[n]];
      if (!given.body.empty() && given.body != body) continue;
      double gap = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        gap += (model.mesh.nodes[n][k] - given.plane.point[k]) * given.plane.normal[k];
      }
      if (gap < -tolerance) {
        throw InputError(fmt::format(
            "{}: expected all nodes on the free side, a node of body {} lies {:.6g} behind the plane at the start",
            given.where, body, -gap));
      }
      const std::int32_t node = model.node_of_scene_node[n];
      Point free = given.plane.normal;
      for (const Point& h : held.of(node)) {
        double along = 0;
        for (std::size_t k = 0; k < 3; ++k) along += free[k] * h[k];
        for (std::size_t k = 0; k < 3; ++k) free[k] -= along * h[k];
      }
      const double part = std::hypot(free[0], free[1], free[2]);
      if (part > 1 - 1e-12) {
        wall.nodes.push_back(node);
      } else if (part > 1e-6) {  // else the wall cannot move it
        oblique.push_back({node, {static_cast<S>(free[0]), static_cast<S>(free[1]), static_cast<S>(free[2])}});
      }
    }
    std::sort(wall.nodes.begin(), wall.nodes.end());  // in the order of memory
    for (const auto& [node, free] : oblique) {
      wall.nodes.push_back(node);
      wall.free.push_back(free);
    }
    wall.reaction.assign(wall.nodes.size(), S(0));
    if (wall.friction > S(0)) wall.drag.assign(wall.nodes.size(), {});
    walls_.push_back(std::move(wall));
    results_.push_back({given.name});
  }
}

/// Force that stops a node across the normal, as far as friction allows it. f: all other forces on the node.
template <class S>
std::array<S, 3> RigidWalls<S>::drag(const Wall& wall, S reaction, const S* v, const S* f, S step, S inverse_mass) {
  std::array<S, 3> stopping{};
  S along = 0, square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    stopping[k] = -v[k] / (step * inverse_mass) - f[k];
    along += stopping[k] * wall.normal[k];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    stopping[k] -= along * wall.normal[k];
    square += stopping[k] * stopping[k];
  }
  const S size = std::sqrt(square), most = wall.friction * reaction;
  if (size > most) {
    for (S& component : stopping) component *= most / size;
  }
  return stopping;
}

template <class S>
void RigidWalls<S>::apply(Model<S>& model, const StepLengths& step) {
  // The last step has no length: the forces are those of one more step like the one before.
  const auto position_step = static_cast<S>(step.after > 0 ? step.after : step.before);
  const auto velocity_step = static_cast<S>(step.after > 0 ? step.velocity() : step.before);
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    Wall& wall = walls_[w];
    double sum = 0;
    parallel_reduce(
        "rigid wall", RangePolicy<>{0, static_cast<std::int64_t>(wall.nodes.size())}, sum,
        [&](std::int64_t begin, std::int64_t end, double& partial) {
          for (std::int64_t index = begin; index < end; ++index) {
            const auto i = static_cast<std::size_t>(index);
            const auto node = static_cast<std::size_t>(wall.nodes[i]);
            const S* x = model.nodes.position.data() + 4 * node;
            const S* v = model.nodes.velocity.data() + 4 * node;
            S* f = model.nodes.force.data() + 4 * node;
            const S mobility = position_step * velocity_step * model.nodes.inverse_mass[node];
            S gap = 0;
            for (int k = 0; k < 3; ++k) {
              gap += wall.normal[k] * ((x[k] - wall.point[k]) + position_step * v[k] + mobility * f[k]);
            }
            wall.reaction[i] = S(0);
            if (wall.friction > S(0)) wall.drag[i] = {};
            if (!(gap < S(0)) || !(mobility > S(0))) continue;
            const S* d = wall.direction(i);
            const S free = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];  // 1 where nothing else holds the node
            const S reaction = -gap / (mobility * free);
            for (int k = 0; k < 3; ++k) f[k] += reaction * d[k];
            wall.reaction[i] = reaction;
            if (wall.friction > S(0)) {
              wall.drag[i] = drag(wall, reaction, v, f, velocity_step, model.nodes.inverse_mass[node]);
              for (std::size_t k = 0; k < 3; ++k) f[k] += wall.drag[i][k];
            }
            partial += static_cast<double>(reaction);
          }
        },
        [](double& whole, double partial) { whole += partial; });
    results_[w].force = sum;
    results_[w].force_max = std::max(results_[w].force_max, sum);
    results_[w].impulse += sum * step.velocity();
  }
}

template <class S>
ExternalWork RigidWalls<S>::work(const Model<S>& model, const StepLengths& step) const {
  ExternalWork sum;
  for (const Wall& wall : walls_) {
    parallel_reduce(
        "work of a rigid wall", RangePolicy<>{0, static_cast<std::int64_t>(wall.nodes.size())}, sum,
        [&](std::int64_t begin, std::int64_t end, ExternalWork& partial) {
          for (std::int64_t index = begin; index < end; ++index) {
            const auto i = static_cast<std::size_t>(index);
            if (wall.reaction[i] == S(0)) continue;
            const auto node = static_cast<std::size_t>(wall.nodes[i]);
            const S* d = wall.direction(i);
            S reaction[3], acceleration[3];
            for (std::size_t k = 0; k < 3; ++k) {
              reaction[k] = wall.reaction[i] * d[k] + (wall.drag.empty() ? S(0) : wall.drag[i][k]);
              acceleration[k] = model.nodes.force[4 * node + k] * model.nodes.inverse_mass[node];
            }
            partial.add(work_of(reaction, model.nodes.velocity.data() + 4 * node, acceleration, step));
          }
        },
        [](ExternalWork& whole, const ExternalWork& partial) { whole.add(partial); });
  }
  return sum;
}

template <class S>
std::size_t RigidWalls<S>::bytes() const {
  std::size_t sum = 0;
  for (const Wall& wall : walls_)
    sum += wall.nodes.size() * (sizeof(std::int32_t) + sizeof(S)) + wall.drag.capacity() * sizeof(wall.drag[0]);
  return sum;
}

template class RigidWalls<double>;
template class RigidWalls<float>;

}  // namespace pinball

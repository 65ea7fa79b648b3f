#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <solver/base/error.hpp>
#include <solver/base/point.hpp>
#include <solver/model/model_surface.hpp>
#include <solver/model/selection/wall_nodes.hpp>

#include "rigid_walls.hpp"

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

template <class S>
void copy_to(const Point& from, S* to) {
  for (std::size_t k = 0; k < 3; ++k) to[k] = static_cast<S>(from[k]);
}

/// Whether the foot of a node on the plane is on what there is of it.
template <class S>
bool is_over(const WallPlane<S>& plane, const S* x) {
  WallPlane<S> deep = plane;
  deep.past = std::numeric_limits<S>::infinity();
  return wall_takes(deep, x, S(0));
}

/// Of the elements at a node of the scene, from there to their other corners at the start [length].
template <class S>
double shortest_edge_at(const Model<S>& model, std::int32_t node) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& corners : model.mesh.hexahedra) {
    if (std::ranges::find(corners, node) == corners.end()) continue;
    for (const std::int32_t other : corners) {
      if (other != node) shortest = std::min(shortest, norm(minus(model.mesh.nodes[other], model.mesh.nodes[node])));
    }
  }
  return shortest;
}

}  // namespace

template <class S>
RigidWalls<S>::RigidWalls(const Model<S>& model, const BoundaryKernels<S>& kernels) {
  for (const RigidWall& given : model.scene.rigid_walls) {
    walls_.push_back(wall_of(model, given, kernels));
    WallResult& result = results_.emplace_back();
    result.name = given.name;
    result.moves = walls_.back().motion.moves();
    result.velocity = walls_.back().motion.is_pushed() ? given.speed : 0.0;
  }
  take_held_directions(model);
}

template <class S>
typename RigidWalls<S>::Wall RigidWalls<S>::wall_of(const Model<S>& model, const RigidWall& given,
                                                    const BoundaryKernels<S>& kernels) {
  WallPlane<S> plane{};
  const double size = mesh_size(model.mesh);
  copy_to(given.plane.normal, plane.normal);
  plane.friction = given.sliding ? static_cast<S>(given.friction) : std::numeric_limits<S>::infinity();
  plane.ends = given.edge || !given.when.always();
  double farthest = 0;
  for (const Point& x : model.mesh.nodes) {
    for (const double component : x) farthest = std::max(farthest, std::abs(component));
  }
  // Places have no more digits than that.
  plane.past = static_cast<S>(std::max(1e-5 * size, 8 * farthest * std::numeric_limits<S>::epsilon()));
  if (given.edge) {  // measured from the given point
    Point edge = *given.edge;
    make_orthogonal(edge, {given.plane.normal});
    copy_to(edge, plane.edge);
    copy_to(cross(given.plane.normal, edge), plane.across);
    for (std::size_t k = 0; k < 2; ++k) plane.size[k] = static_cast<S>(given.size[k]);
  }
  copy_to(given.edge ? given.plane.point : near_point(given.plane, model.mesh.nodes[0], size), plane.point);
  if (!plane.ends) stand_back(model, given, plane);
  Wall wall{plane, given.when, WallMotion(given), kernels.wall(plane.friction > S(0)), {}};
  if (model.scene.contact.method != ContactMethod::none) {
    wall.takes.assign(model.nodes.count, 0);
    for (const std::int32_t n : nodes_of_wall(model.mesh, given)) wall.takes[model.node_of_scene_node[n]] = 1;
  }
  return wall;
}

template <class S>
void RigidWalls<S>::stand_back(const Model<S>& model, const RigidWall& given, WallPlane<S>& plane) {
  const PlaceTolerance tolerance(model.mesh, given.nodes.tolerance);
  double deepest = 1e-9 * mesh_size(model.mesh);
  const double exact = deepest;
  for (const std::int32_t n : nodes_of_wall(model.mesh, given)) {
    double gap = 0;
    for (std::size_t k = 0; k < 3; ++k) gap += (model.mesh.nodes[n][k] - given.plane.point[k]) * given.plane.normal[k];
    if (gap < -tolerance.of(n)) {
      throw InputError(
          fmt::format("{}: expected all nodes on the free side, a node of body {} lies {:.6g} behind the plane at the "
                      "start",
                      given.where, model.mesh.body_names[model.mesh.body_of_node[n]], -gap));
    }
    deepest = std::max(deepest, -gap);
  }
  if (!(deepest > exact)) return;
  for (std::size_t k = 0; k < 3; ++k) plane.point[k] -= static_cast<S>(deepest) * plane.normal[k];
}

template <class S>
void RigidWalls<S>::take_held_directions(const Model<S>& model) {
  if (walls_.empty()) return;
  pushes_held_ = false;
  const HeldDirections held = held_directions(model);
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const RigidWall& given = model.scene.rigid_walls[w];
    std::vector<std::int32_t> nodes;
    std::vector<WallHold<S>> holds;
    std::vector<std::pair<std::int32_t, WallHold<S>>> held_nodes;
    const bool rubs = walls_[w].plane.friction > S(0);
    for (const std::int32_t n : nodes_of_wall(model.mesh, given)) {
      const std::int32_t node = model.node_of_scene_node[n];
      Point free = given.plane.normal;
      for (const Point& h : held.of(node)) {
        double along = 0;
        for (std::size_t k = 0; k < 3; ++k) along += free[k] * h[k];
        for (std::size_t k = 0; k < 3; ++k) free[k] -= along * h[k];
      }
      const double part = std::hypot(free[0], free[1], free[2]);
      if (part > 1 - 1e-12 && (!rubs || held.of(node).empty())) {
        nodes.push_back(node);
      } else if (part > 1e-6) {  // else the wall cannot move it
        WallHold<S> hold{};
        copy_to(free, hold.free);
        std::size_t count = 0;
        for (const Point& h : held.of(node)) copy_to(h, hold.held[count++]);
        held_nodes.push_back({node, hold});
      }
    }
    std::sort(nodes.begin(), nodes.end());  // in the order of memory
    for (const auto& [node, hold] : held_nodes) {
      nodes.push_back(node);
      holds.push_back(hold);
    }
    pushes_held_ = pushes_held_ || !holds.empty();
    walls_[w].nodes->set(nodes, holds);
  }
}

/// Of a wall that ends the nodes that have gone past it are none.
template <class S>
double RigidWalls<S>::leap_of_begun(const Model<S>& model, double from, double time, double to, double dt) const {
  double fastest = 0;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const Wall& wall = walls_[w];
    if (!begins(wall, from, to)) continue;
    const double start = std::max(time, wall.when.start);
    double speed = 0;
    if (wall.motion.moves())
      speed = wall.motion.is_pushed() ? results_[w].velocity : wall.motion.given_velocity(start, {0, dt});
    const S* const normal = wall.plane.normal;
    for (const std::int32_t n : nodes_of_wall(model.mesh, model.scene.rigid_walls[w])) {
      const std::int32_t node = model.node_of_scene_node[n];
      const S* const v = model.nodes.velocity_of(node);
      const double rate = normal[0] * v[0] + normal[1] * v[1] + normal[2] * v[2];
      const double height = wall_height(wall.plane, model.nodes.position_of(node)) - results_[w].displacement;
      const double then = height + rate * (start - time), closing = speed - rate;
      const bool is_past = then < -wall.plane.past - std::abs(rate) * dt;
      if (!is_past && then < closing * (to - start + 2 * dt)) fastest = std::max(fastest, closing);
    }
  }
  return fastest;
}

template <class S>
std::vector<InitialOverlap> RigidWalls<S>::passed_by_begun(const Model<S>& model, double from, double to) const {
  std::vector<InitialOverlap> found;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const Wall& wall = walls_[w];
    const RigidWall& given = model.scene.rigid_walls[w];
    if (!begins(wall, from, to) || !wall.when.contains(to)) continue;
    std::vector<InitialOverlap> of_body(model.mesh.body_names.size());
    std::vector<bool> is_above(of_body.size(), !given.edge);
    for (const std::int32_t n : nodes_of_wall(model.mesh, given)) {
      const S* const x = model.nodes.position_of(model.node_of_scene_node[n]);
      const double height = wall_height(wall.plane, x) - results_[w].displacement;
      const std::size_t body = model.mesh.body_of_node[n];
      InitialOverlap& of = of_body[body];
      if (wall_takes(wall.plane, x, static_cast<S>(results_[w].displacement))) {
        is_above[body] = true;
      } else if (height <= -wall.plane.past && is_over(wall.plane, x)) {
        ++of.nodes;
        if (-height > of.depth) {
          of.depth = -height;
          of.node = n;
        }
      }
    }
    for (std::size_t body = 0; body < of_body.size(); ++body) {
      InitialOverlap& of = of_body[body];
      if (of.nodes == 0 || !is_above[body]) continue;
      of.first = model.mesh.body_names[body];
      of.second = given.name.empty() ? given.where : given.name;
      of.share = of.depth / shortest_edge_at(model, of.node);
      of.time = to;
      found.push_back(of);
    }
  }
  return found;
}

template RigidWalls<double>::RigidWalls(const Model<double>&, const BoundaryKernels<double>&);
template RigidWalls<float>::RigidWalls(const Model<float>&, const BoundaryKernels<float>&);
template double RigidWalls<double>::leap_of_begun(const Model<double>&, double, double, double, double) const;
template double RigidWalls<float>::leap_of_begun(const Model<float>&, double, double, double, double) const;
template std::vector<InitialOverlap> RigidWalls<double>::passed_by_begun(const Model<double>&, double, double) const;
template std::vector<InitialOverlap> RigidWalls<float>::passed_by_begun(const Model<float>&, double, double) const;
template void RigidWalls<double>::take_held_directions(const Model<double>&);
template void RigidWalls<float>::take_held_directions(const Model<float>&);

}  // namespace pinball

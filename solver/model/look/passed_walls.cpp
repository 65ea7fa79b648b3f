#include "passed_walls.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <solver/base/counted.hpp>
#include <solver/model/place_names.hpp>
#include <solver/model/selection/wall_nodes.hpp>

#include "driven_motion.hpp"
#include "time_course.hpp"

namespace pinball {

namespace {

constexpr double aligned = 1 - 1e-9;  ///< of a direction with a normal [-]
constexpr double deep = 1e-6;         ///< what counts as through, over the size of the mesh [-]
constexpr double begun_deep = 1e-5;   ///< the same where a wall begins: less it takes (rigid_walls.hpp) [-]

/// One look at one wall.
class PassedWall {
 public:
  PassedWall(const ModelMesh& mesh, const RigidWall& wall, const std::vector<double>& times)
      : mesh_(mesh), wall_(wall), times_(times), gap_(mesh.nodes.size(), outside) {
    for (const std::int32_t n : nodes_of_wall(mesh, wall))
      gap_[n] = dot(minus(mesh.nodes[n], wall.plane.point), wall.plane.normal);
  }

  /// way: along the normal, at its lowest since the time before, at each of the times; until the time `to`.
  std::string sentence_of(const NodeSelection& selection, const std::vector<double>& way, double to,
                          const char* why) const {
    double at_start = 0, lowest = std::numeric_limits<double>::infinity(), time = 0;
    bool began = false;
    for (std::size_t j = 0; j < times_.size() && times_[j] <= to; ++j) {
      if (!wall_.when.contains(times_[j])) continue;
      const double offset = way[j] - wall_displacement(wall_, times_[j]);
      if (!std::exchange(began, true)) at_start = offset;
      if (offset >= lowest) continue;
      lowest = offset;
      time = times_[j];
    }
    if (!began) return "";
    const double size = deep * mesh_size(mesh_);
    std::int64_t passed = 0;
    std::int32_t deepest = -1;
    for (const std::int32_t n : matching_nodes(mesh_, selection)) {
      if (gap_[n] == outside || gap_[n] + at_start < -size || gap_[n] + lowest > -size) continue;
      ++passed;
      if (deepest < 0 || gap_[n] < gap_[deepest]) deepest = n;
    }
    if (passed == 0) return "";
    return fmt::format(
        "{}: {} {} {} through {}, the deepest, {}, {:.4g} behind it at time {:.4g}: a wall stops no node whose "
        "motion is given",
        selection.where, counted(passed, "node"), passed == 1 ? "goes" : "go", why, wall_.where,
        node_name(mesh_, deepest), -(gap_[deepest] + lowest), time);
  }

  const Point& normal() const { return wall_.plane.normal; }

 private:
  static constexpr double outside = std::numeric_limits<double>::infinity();  ///< of nodes that are not the wall's

  const ModelMesh& mesh_;
  const RigidWall& wall_;
  const std::vector<double>& times_;
  std::vector<double> gap_;  ///< of each node, at time 0 [length]
};

bool holds(const FixedConstraint& fixed, const Point& normal) {
  if (fixed.when.start > 0) return false;
  if (fixed.directions.size() == 3) return true;
  return fixed.frame == Frame::global && std::ranges::any_of(fixed.directions, [&normal](const Point& d) {
           return std::abs(dot(d, normal)) > aligned;
         });
}

struct NodesBehind {
  std::int64_t count = 0;
  std::int32_t deepest = -1;
  double lowest = 0;  ///< gap of it [length]

  void take(std::int32_t node, double gap) {
    ++count;
    if (gap >= lowest) return;
    lowest = gap;
    deepest = node;
  }
};

/// How far a displacement of a mover may at most bring a place along a direction [length].
double most_along(const Extent& moved, const Point& direction) {
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) most += std::max(direction[k] * moved.low[k], direction[k] * moved.high[k]);
  return most;
}

}  // namespace

std::vector<std::string> walls_begun_late(const Scene& scene, const ModelMesh& mesh, const Movers& movers) {
  std::vector<std::string> found;
  std::vector<std::size_t> mover_of(mesh.body_names.size(), 0);
  for (std::size_t m = 0; m < movers.all.size(); ++m) {
    for (const std::int32_t body : movers.all[m].bodies) mover_of[body] = m;
  }
  for (const RigidWall& wall : scene.rigid_walls) {
    const TimeSpan& when = wall.when;
    const auto later = std::ranges::lower_bound(movers.times, when.start);
    if (!(when.start > 0 && when.start < when.end) || wall.edge || later == movers.times.end()) continue;
    const std::size_t j = later - movers.times.begin();
    const double size = begun_deep * mesh_size(mesh);
    std::vector<NodesBehind> behind(movers.all.size());
    for (const std::int32_t n : nodes_of_wall(mesh, wall)) {
      const std::size_t m = mover_of[mesh.body_of_node[n]];
      const std::vector<Extent>& moved = movers.all[m].moved;  // at the times around that when the wall begins
      const double way = std::max(most_along(moved[j], wall.plane.normal), most_along(moved[j - 1], wall.plane.normal));
      const double gap = dot(minus(mesh.nodes[n], wall.plane.point), wall.plane.normal) + way;
      if (gap < -size) behind[m].take(n, gap);
    }
    for (const NodesBehind& of : behind) {
      if (of.count == 0) continue;
      found.push_back(fmt::format(
          "{} begins at time {:.4g}, when {} will lie behind it, the deepest, {}, by {:.4g} or more, if nothing that "
          "they meet keeps them from it: a wall that begins lets such nodes go on",
          wall.where, when.start, counted(of.count, "node"), node_name(mesh, of.deepest), -of.lowest));
    }
  }
  return found;
}

std::vector<std::string> passed_walls(const Scene& scene, const ModelMesh& mesh) {
  std::vector<std::string> found;
  if (scene.rigid_walls.empty() || (scene.prescribed_velocities.empty() && scene.fixed_constraints.empty()))
    return found;
  const std::vector<double> times = look_times(scene, 1);
  for (const RigidWall& given : scene.rigid_walls) {
    if (given.edge || given.mass > 0) continue;
    const PassedWall wall(mesh, given, times);
    const auto add = [&found](std::string sentence) {
      if (!sentence.empty()) found.push_back(std::move(sentence));
    };
    for (const PrescribedVelocity& motion : scene.prescribed_velocities) {
      const bool along = !motion.direction || std::abs(dot(*motion.direction, wall.normal())) > aligned;
      if (motion.when.start > 0 || motion.quantity == MotionQuantity::acceleration || !along) continue;
      const MotionCourse course = course_of(motion, times);
      const double part = dot(motion.velocity, wall.normal());
      std::vector<double> way(times.size());
      for (std::size_t j = 0; j < times.size(); ++j) way[j] = std::min(part * course.low[j], part * course.high[j]);
      add(wall.sentence_of(motion.nodes, way, motion.when.end, "as it says"));
    }
    if (given.speed == 0) continue;
    for (const FixedConstraint& fixed : scene.fixed_constraints) {
      if (!holds(fixed, wall.normal())) continue;
      add(wall.sentence_of(fixed.nodes, std::vector<double>(times.size(), 0.0), fixed.when.end, "as it holds them"));
    }
  }
  return found;
}

}  // namespace pinball

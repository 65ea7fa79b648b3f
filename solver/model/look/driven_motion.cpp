#include "driven_motion.hpp"

#include <algorithm>

#include <solver/base/error.hpp>
#include <solver/model/rigid/rigid_nodes.hpp>
#include <solver/model/selection/node_selection.hpp>
#include <solver/model/selection/pressed_faces.hpp>

namespace pinball {

namespace {

/// Of a prescribed motion, as a multiple of what stands beside its table; of an acceleration beside the motion that is
/// there when it begins.
template <class Motion>
double displacement(const Motion& given, double time) {
  const double from = std::max(0.0, given.when.start), to = std::min(time, given.when.end);
  if (to <= from) return 0;
  switch (given.quantity) {
    case MotionQuantity::velocity:
      return given.table.integral(to) - given.table.integral(from);
    case MotionQuantity::displacement:
      return given.table.value(to) - given.table.value(from);
    case MotionQuantity::acceleration:
      break;
  }
  const double speed_before = given.table.integral(from);
  return given.table.second_integral(to) - given.table.second_integral(from) - (to - from) * speed_before +
         (time - to) * (given.table.integral(to) - speed_before);
}

Point times(double factor, const Point& vector) { return {factor * vector[0], factor * vector[1], factor * vector[2]}; }

/// Nodes of each group; what acts on nodes of several acts on all of these.
class DrivenMotions {
 public:
  DrivenMotions(const Scene& scene, const ModelMesh& mesh, const std::vector<std::int32_t>& group, std::size_t groups,
                const std::vector<double>& times)
      : scene_(scene), mesh_(mesh), group_(group), times_(times), all_(groups), nodes_(groups, 0), mass_(groups, 0.0) {
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) ++nodes_[group_of(n)];
    for (DrivenMotion& own : all_) {
      own.moved.resize(times.size());
      own.pushed.assign(times.size(), Extent{{}, {}});
    }
    if (!scene.loads.empty() || !scene.pressures.empty()) weigh();
  }

  std::vector<DrivenMotion> find() {
    hold();
    for (const PrescribedVelocity& given : scene_.prescribed_velocities) prescribe(given);
    for (const RigidMotion& given : scene_.rigid_motions) prescribe(given);
    for (const Gravity& gravity : scene_.gravities) fall(gravity);
    for (const NodalLoad& load : scene_.loads) push(load);
    for (const Pressure& pressure : scene_.pressures) press(pressure);
    return std::move(all_);
  }

 private:
  std::size_t group_of(std::size_t node) const { return group_[mesh_.body_of_node[node]]; }
  /// How many nodes of each group a selection has.
  std::vector<std::int64_t> counts(const NodeSelection& selection) const {
    std::vector<std::int64_t> count(all_.size(), 0);
    for (const std::int32_t n : matching_nodes(mesh_, selection)) ++count[group_of(n)];
    return count;
  }
  void weigh() {
    const std::vector<std::size_t> material = material_of_bodies(scene_);
    for (std::size_t e = 0; e < mesh_.hexahedra.size(); ++e) {
      const std::size_t body = mesh_.body[e];
      mass_[group_[body]] += scene_.materials[material[body]].density * element_volume(mesh_, e);
    }
  }

  void hold() {
    for (const PlaneConstraint& plane : scene_.constraints) stop(counts(nodes_of(plane)), {plane.normal});
    for (const FixedConstraint& fixed : scene_.fixed_constraints) {
      if (fixed.frame == Frame::global) stop(counts(fixed.nodes), fixed.directions, fixed.when.always());
    }
    for (const RigidBody& rigid : scene_.rigid_bodies) hold(rigid);
  }
  /// That of its first body or, without bodies, of the first node that is attached to it.
  std::size_t group_of(const RigidBody& rigid) const {
    if (!rigid.bodies.empty())
      return group_[std::ranges::find(scene_.bodies, rigid.bodies.front(), &Body::name) - scene_.bodies.begin()];
    const auto attached = std::ranges::find(scene_.attached_nodes, rigid.name, &AttachedNodes::rigid_body);
    return group_of(matching_nodes(mesh_, attached->nodes).front());
  }
  DrivenMotion& motion_of(const RigidBody& rigid) { return all_[group_of(rigid)]; }
  void hold(const RigidBody& rigid) {
    const bool moved =
        std::ranges::find(scene_.rigid_motions, rigid.name, &RigidMotion::rigid_body) != scene_.rigid_motions.end();
    DrivenMotion& own = motion_of(rigid);
    if (rigid.held.size() == 3 && rigid.held_rotations.size() == 3 && !moved && rigid.bodies.size() == bodies_of(rigid))
      own.held = true;
    for (const Point& d : rigid.held) {
      for (std::size_t k = 0; k < 3; ++k) own.stopped[k] = own.stopped[k] || std::abs(d[k]) > 0.5;
    }
  }
  /// In its group: others hang on it by nodes or ties.
  std::size_t bodies_of(const RigidBody& rigid) const { return std::ranges::count(group_, group_of(rigid)); }
  void stop(const std::vector<std::int64_t>& count, const std::vector<Point>& directions, bool always = true) {
    for (std::size_t g = 0; g < all_.size(); ++g) {
      if (count[g] == 0) continue;
      all_[g].held |= always && directions.size() == 3 && count[g] == nodes_[g];
      for (const Point& d : directions) {
        for (std::size_t k = 0; k < 3; ++k) all_[g].stopped[k] = all_[g].stopped[k] || std::abs(d[k]) > 0.5;
      }
    }
  }

  void prescribe(const PrescribedVelocity& given) {
    const std::vector<std::int64_t> count = counts(given.nodes);
    for (std::size_t g = 0; g < all_.size(); ++g) {
      if (count[g] == 0) continue;
      DrivenMotion& own = all_[g];
      own.in_part = own.in_part || count[g] < nodes_[g];
      const bool adds = given.quantity == MotionQuantity::acceleration;
      own.wholly = own.wholly || (count[g] == nodes_[g] && !given.direction && !adds);
      double before = 0;
      for (std::size_t j = 0; j < times_.size(); ++j) {
        const double now = displacement(given, times_[j]);
        take(own, j, times(now, given.velocity), adds);
        if (j > 0) own.speed = std::max(own.speed, speed(now - before, j, given.velocity));
        before = now;
      }
    }
  }
  /// Of a direction that is given, others are free, but for those that are held.
  void prescribe(const RigidMotion& given) {
    const RigidBody& rigid = scene_.rigid_bodies[rigid_body_of_name(scene_, given.rigid_body)];
    DrivenMotion& own = motion_of(rigid);
    own.in_part = own.in_part || rigid.bodies.empty();
    double before = 0;
    for (std::size_t j = 0; j < times_.size(); ++j) {
      const double now = displacement(given, times_[j]);
      if (given.axis) {
        own.turned = std::max(own.turned, std::abs(now * given.angular_speed));
      } else {
        const Point way = times(given.speed, *given.direction);
        take(own, j, times(now, way), given.quantity == MotionQuantity::acceleration);
        if (j > 0) own.speed = std::max(own.speed, speed(now - before, j, way));
      }
      before = now;
    }
  }
  /// adds: to the motion that is there.
  static void take(DrivenMotion& own, std::size_t j, const Point& way, bool adds) {
    if (adds) {
      own.pushed[j] = own.pushed[j] + Extent{way, way};
    } else {
      own.moved[j].take(way);
    }
  }
  double speed(double change, std::size_t j, const Point& vector) const {
    return std::abs(change) * norm(vector) / (times_[j] - times_[j - 1]);
  }

  void fall(const Gravity& gravity) {
    std::vector<bool> falls(all_.size(), gravity.bodies.empty());
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
      if (std::ranges::find(gravity.bodies, scene_.bodies[b].name) != gravity.bodies.end()) falls[group_[b]] = true;
    }
    for (std::size_t g = 0; g < all_.size(); ++g) {
      if (falls[g]) add(all_[g], gravity.acceleration, gravity.table, 0);
    }
  }
  void add(DrivenMotion& own, const Point& acceleration, const TimeTable& table, double start) const {
    for (std::size_t j = 0; j < times_.size(); ++j) {
      if (times_[j] < start) continue;
      const Point to = times(table.second_integral(times_[j] - start), acceleration);
      own.pushed[j] = own.pushed[j] + Extent{to, to};
    }
  }

  void push(const NodalLoad& load) {
    const std::vector<std::int64_t> count = counts(load.nodes);
    for (std::size_t g = 0; g < all_.size(); ++g) {
      if (count[g] == 0 || !(mass_[g] > 0)) continue;
      const double factor = (load.each ? count[g] : 1.0) / mass_[g];
      add(all_[g], times(factor, load.force), load.table, 0);
    }
  }
  /// With the directions in which its faces look now.
  void press(const Pressure& pressure) {
    std::vector<Point> force(all_.size(), Point{});
    for (const PressedFace& face : pressed_faces(mesh_, scene_.constraints, pressure)) {
      const auto at = [&](std::size_t i) { return mesh_.nodes[face.corners[i]]; };
      const Point area = cross(minus(at(2), at(0)), minus(at(3), at(1)));
      Point& own = force[group_of(face.corners[0])];
      for (std::size_t k = 0; k < 3; ++k) own[k] -= pressure.pressure * area[k] / 2;
    }
    for (std::size_t g = 0; g < all_.size(); ++g) {
      if (mass_[g] > 0) add(all_[g], times(1 / mass_[g], force[g]), pressure.table, pressure.start);
    }
  }

  const Scene& scene_;
  const ModelMesh& mesh_;
  const std::vector<std::int32_t>& group_;
  const std::vector<double>& times_;
  std::vector<DrivenMotion> all_;
  std::vector<std::int64_t> nodes_;
  std::vector<double> mass_;
};

}  // namespace

std::vector<DrivenMotion> driven_motions(const Scene& scene, const ModelMesh& mesh,
                                         const std::vector<std::int32_t>& group, std::size_t groups,
                                         const std::vector<double>& times) {
  return DrivenMotions(scene, mesh, group, groups, times).find();
}

double wall_displacement(const RigidWall& wall, double time) {
  const double to = std::min(time, wall.when.end);
  return wall.mass > 0 ? wall.speed * to : wall.speed * wall.table.integral(to);
}

}  // namespace pinball

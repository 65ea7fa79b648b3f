#include "driven_motion.hpp"

#include <algorithm>

#include <solver/base/moments_of_inertia.hpp>
#include <solver/model/elements/element_parts.hpp>
#include <solver/model/rigid/rigid_nodes.hpp>
#include <solver/model/selection/node_selection.hpp>
#include <solver/model/selection/pressed_faces.hpp>
#include <solver/model/selection/selected_elements.hpp>

namespace pinball {

namespace {

Point times(double factor, const Point& vector) { return {factor * vector[0], factor * vector[1], factor * vector[2]}; }
Point sum(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

/// Mass, its centre, and its moments of inertia about that, of a mover, by the corners of its elements.
struct Weight {
  double mass = 0;
  Point centre{};
  std::array<Point, 3> inertia{};

  /// Angular acceleration by a moment [1/time^2].
  Point turned_by(const Point& moment) const {
    const Point first = cross(inertia[1], inertia[2]), second = cross(inertia[2], inertia[0]),
                third = cross(inertia[0], inertia[1]);
    const double determinant = dot(inertia[0], first);
    if (!(determinant > 0)) return {};
    Point turned;
    for (std::size_t k = 0; k < 3; ++k)
      turned[k] = (first[k] * moment[0] + second[k] * moment[1] + third[k] * moment[2]) / determinant;
    return turned;
  }
};

/// Whether a direction is that of an axis, and of which: otherwise 3.
std::size_t axis_of(const Point& direction) {
  const double length = norm(direction);
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(direction[k]) >= (1 - 1e-9) * length) return k;
  }
  return 3;
}

/// Nodes of each group; what acts on nodes of several acts on all of these.
class DrivenMotions {
 public:
  DrivenMotions(const Scene& scene, const ModelMesh& mesh, const std::vector<std::int32_t>& group, std::size_t groups,
                const std::vector<double>& times)
      : scene_(scene), mesh_(mesh), group_(group), times_(times), all_(groups), nodes_(groups, 0), weight_(groups) {
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) ++nodes_[group_of(n)];
    for (DrivenMotion& own : all_) {
      own.moved.resize(times.size());
      own.pushed.assign(times.size(), Point{});
      own.push_rate.assign(times.size(), Point{});
      own.carried.assign(times.size(), 0.0);
      own.strained = own.carried;
    }
    if (!scene.loads.empty() || !scene.pressures.empty()) weigh();
    swing_.assign(groups, std::vector<Point>(weighed_ ? times.size() : 0, Point{}));
    together_ = swing_;
    rigid_.assign(groups, false);
  }

  std::vector<DrivenMotion> find() {
    hold();
    for (const PrescribedVelocity& given : scene_.prescribed_velocities) prescribe(given);
    for (const RigidMotion& given : scene_.rigid_motions) prescribe(given);
    for (const Gravity& gravity : scene_.gravities) fall(gravity);
    for (const NodalLoad& load : scene_.loads) push(load);
    for (const Pressure& pressure : scene_.pressures) press(pressure);
    for (std::size_t g = 0; g < all_.size() && weighed_; ++g) {
      let_swing(all_[g], swing_[g]);
      strain(g);
    }
    if (!scene_.initial_stresses.empty()) release();
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
  /// Rigid bodies by the mass that they are given.
  void weigh() {
    weighed_ = true;
    const std::vector<std::size_t> material = material_of_bodies(scene_);
    std::vector<double> mass(scene_.bodies.size(), 0.0), share(mass.size(), 1.0);
    const auto mass_of = [&](std::size_t e) {
      return scene_.materials[material[mesh_.body[e]]].density * element_volume(mesh_, e);
    };
    for (std::size_t e = 0; e < mesh_.hexahedra.size(); ++e) mass[mesh_.body[e]] += mass_of(e);
    const std::vector<std::int32_t> rigid = rigid_body_of_bodies(scene_);
    std::vector<double> of_rigid(scene_.rigid_bodies.size(), 0.0);
    for (std::size_t b = 0; b < mass.size(); ++b) {
      if (rigid[b] >= 0) of_rigid[rigid[b]] += mass[b];
    }
    for (std::size_t b = 0; b < mass.size(); ++b) {
      if (rigid[b] >= 0 && scene_.rigid_bodies[rigid[b]].mass > 0 && of_rigid[rigid[b]] > 0)
        share[b] = scene_.rigid_bodies[rigid[b]].mass / of_rigid[rigid[b]];
    }
    const auto for_corners = [&](const auto& visit) {
      for (std::size_t e = 0; e < mesh_.hexahedra.size(); ++e) {
        const double of_element = share[mesh_.body[e]] * mass_of(e);
        const CornerShares of_corner = corner_shares(scene_, mesh_, e);
        for (std::size_t i = 0; i < 8; ++i)
          visit(weight_[group_[mesh_.body[e]]], of_element * of_corner[i], mesh_.corner(e, i));
      }
    };
    for_corners([](Weight& own, double m, const Point& x) {
      own.mass += m;
      own.centre = sum(own.centre, times(m, x));
    });
    for (Weight& own : weight_) {
      if (own.mass > 0) own.centre = times(1 / own.mass, own.centre);
    }
    for_corners([](Weight& own, double m, const Point& x) { add_moments(own.inertia, m, minus(x, own.centre)); });
    for (const RigidBody& given : scene_.rigid_bodies) {
      Weight& own = weight_[group_of(given)];
      const double trace = given.inertia[0][0] + given.inertia[1][1] + given.inertia[2][2];
      if (given.bodies.empty() || !(trace > 0) || given.bodies.size() != bodies_of(given)) continue;
      own.inertia = given.inertia;
      own.centre = given.centre.value_or(own.centre);
    }
  }

  void hold() {
    for (const PlaneConstraint& plane : scene_.constraints) stop(counts(nodes_of(plane)), {plane.normal});
    for (const FixedConstraint& fixed : scene_.fixed_constraints) {
      const std::vector<std::int64_t> count = counts(fixed.nodes);
      if (fixed.frame == Frame::global) stop(count, fixed.directions, fixed.when.always());
      for (std::size_t g = 0; g < all_.size(); ++g)
        all_[g].guided = all_[g].guided || (fixed.frame != Frame::global && count[g] > 0);
    }
    for (const RigidBody& rigid : scene_.rigid_bodies) hold(rigid);
  }
  std::size_t group_of(const RigidBody& rigid) const { return group_[body_with(scene_, mesh_, rigid)]; }
  DrivenMotion& motion_of(const RigidBody& rigid) { return all_[group_of(rigid)]; }
  void hold(const RigidBody& rigid) {
    const bool moved =
        std::ranges::find(scene_.rigid_motions, rigid.name, &RigidMotion::rigid_body) != scene_.rigid_motions.end();
    DrivenMotion& own = motion_of(rigid);
    if (rigid.held.size() == 3 && rigid.held_rotations.size() == 3 && !moved && rigid.bodies.size() == bodies_of(rigid))
      own.held = true;
    rigid_[group_of(rigid)] = rigid.bodies.size() == bodies_of(rigid);
    own.turns_not = own.turns_not || rigid.held_rotations.size() == 3;
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
    const MotionCourse course = course_of(given, times_);
    for (std::size_t g = 0; g < all_.size(); ++g) {
      if (count[g] > 0) prescribe(all_[g], given, course, given.direction, given.velocity, count[g] == nodes_[g]);
    }
  }
  void prescribe(const RigidMotion& given) {
    const RigidBody& rigid = scene_.rigid_bodies[rigid_body_of_name(scene_, given.rigid_body)];
    DrivenMotion& own = motion_of(rigid);
    const MotionCourse course = course_of(given, times_);
    own.in_part = own.in_part || rigid.bodies.size() != bodies_of(rigid);
    if (!given.axis) {
      prescribe(own, given, course, given.direction, times(given.speed, *given.direction), !rigid.bodies.empty());
      return;
    }
    double most = 0;
    for (std::size_t j = 0; j < times_.size(); ++j)
      most = std::max({most, std::abs(course.low[j]), std::abs(course.high[j]), std::abs(coasted(given, course, j))});
    own.turned += most * std::abs(given.angular_speed);
  }
  /// Of a direction that is given, others are free, but for those that are held. whole: all nodes are moved.
  template <class Motion>
  void prescribe(DrivenMotion& own, const Motion& given, const MotionCourse& course,
                 const std::optional<Point>& direction, const Point& vector, bool whole) {
    const bool adds = given.quantity == MotionQuantity::acceleration;
    const bool always = course.from <= 0 && course.to >= times_.back();
    const std::size_t axis = direction ? axis_of(*direction) : 3;
    own.in_part = own.in_part || !whole;
    own.guided = own.guided || (direction && axis == 3);
    own.wholly = own.wholly || (whole && !direction && !adds && always);
    for (std::size_t j = 1; j < times_.size(); ++j)
      own.speed = std::max(own.speed, speed(course.way[j] - course.way[j - 1], j, vector));
    if (whole && (!direction || axis < 3)) {
      WholeMotion& motion = own.whole.emplace_back(WholeMotion{{}, vector, adds, course});
      for (std::size_t k = 0; k < 3; ++k) motion.along[k] = !direction || k == axis;
      return;
    }
    if (!adds) {
      PartMotion& part = own.parts.emplace_back();
      part.direction = direction;
      for (const double way : course.way) part.way.push_back(times(way, vector));
    }
    for (std::size_t j = 0; j < times_.size(); ++j) {
      if (adds) {
        own.pushed[j] = sum(own.pushed[j], times(course.way[j], vector));
        own.push_rate[j] = sum(own.push_rate[j], times(course.rate[j], vector));
      } else {
        own.moved[j].take(times(course.low[j], vector));
        own.moved[j].take(times(course.high[j], vector));
        if (!always) own.carried[j] += std::abs(coasted(given, course, j)) * norm(vector);
      }
    }
  }
  /// The way, if it goes on as it ended.
  template <class Motion>
  double coasted(const Motion& given, const MotionCourse& course, std::size_t j) const {
    const bool adds = given.quantity == MotionQuantity::acceleration;
    return course.way[j] + (adds ? 0.0 : std::max(0.0, times_[j] - course.to) * course.rate[j]);
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
  TimeCourse course_from(double start, const TimeTable& table) const {
    std::vector<double> since = times_;
    for (double& t : since) t -= start;
    return time_course(table, since);
  }
  void add(DrivenMotion& own, const Point& acceleration, const TimeTable& table, double start) const {
    const TimeCourse course = course_from(start, table);
    for (std::size_t j = 0; j < times_.size(); ++j) {
      own.pushed[j] = sum(own.pushed[j], times(course.second[j], acceleration));
      own.push_rate[j] = sum(own.push_rate[j], times(course.first[j], acceleration));
    }
  }
  /// moment: about the origin. apart: sum of the sizes of the forces on single places that this one is of; 0: all
  /// places take the same share of it.
  void add(std::size_t g, const Point& force, const Point& moment, double apart, const TimeTable& table, double start) {
    const Weight& weight = weight_[g];
    if (!(weight.mass > 0)) return;
    add(all_[g], times(1 / weight.mass, force), table, start);
    const Point turning = weight.turned_by(minus(moment, cross(weight.centre, force)));
    const TimeCourse course = course_from(start, table);
    for (std::size_t j = 0; j < times_.size(); ++j) {
      swing_[g][j] = sum(swing_[g][j], times(course.second[j], turning));
      if (apart > 0) together_[g][j] = sum(together_[g][j], times(course.second[j] / weight.mass, force));
      all_[g].strained[j] += std::abs(course.second[j]) * apart / weight.mass;
    }
  }
  /// What no force holds: places go with up to twice the speed of a wave of the initial stress, and come to rest within
  /// twice the strain of it.
  void release() {
    const std::vector<std::size_t> material = material_of_bodies(scene_);
    std::vector<double> speed(all_.size(), 0.0), reach(all_.size(), 0.0);
    const double extent = mesh_size(mesh_);
    for (const InitialStress& given : scene_.initial_stresses) {
      const double size = std::hypot(norm(given.stress), std::sqrt(2.0) * norm(given.shear_stress));
      for (const std::int32_t e : select_elements(mesh_, given)) {
        const Material& of = scene_.materials[material[mesh_.body[e]]];
        const std::size_t g = group_[mesh_.body[e]];
        if (!(of.shear_modulus > 0)) continue;
        speed[g] = std::max(speed[g], 2 * size / std::sqrt(of.density * of.shear_modulus));
        reach[g] = std::max(reach[g], 2 * size / of.shear_modulus * extent);
      }
    }
    for (std::size_t g = 0; g < all_.size(); ++g) {
      for (std::size_t j = 0; j < times_.size(); ++j) all_[g].strained[j] += std::min(speed[g] * times_[j], reach[g]);
    }
  }

  /// What forces do beside moving the whole.
  void strain(std::size_t g) {
    for (std::size_t j = 0; j < times_.size(); ++j) {
      double& own = all_[g].strained[j];
      const double left = own - norm(together_[g][j]);
      own = rigid_[g] || left < 1e-9 * own ? 0.0 : left;
    }
  }
  static void let_swing(DrivenMotion& own, const std::vector<Point>& swing) {
    const bool stopped = own.stopped[0] || own.stopped[1] || own.stopped[2];
    if (own.held || own.wholly || own.in_part || own.turns_not || stopped) return;
    for (const Point& angle : swing) own.swung = std::max(own.swung, norm(angle));
  }

  void push(const NodalLoad& load) {
    std::vector<double> count(all_.size(), 0.0);
    std::vector<Point> places(all_.size(), Point{});
    for (const std::int32_t n : matching_nodes(mesh_, load.nodes)) {
      const std::size_t g = group_of(n);
      count[g] += 1;
      places[g] = sum(places[g], mesh_.nodes[n]);
    }
    for (std::size_t g = 0; g < all_.size(); ++g) {
      if (!(count[g] > 0)) continue;
      const Point force = times(load.each ? count[g] : 1.0, load.force);
      const double apart = count[g] < static_cast<double>(nodes_[g]) ? norm(force) : 0.0;
      add(g, force, times(1 / count[g], cross(places[g], force)), apart, load.table, 0);
    }
  }
  /// With the directions in which its faces look now.
  void press(const Pressure& pressure) {
    std::vector<Point> force(all_.size(), Point{}), moment = force;
    std::vector<double> apart(all_.size(), 0.0);
    for (const PressedFace& face : pressed_faces(mesh_, scene_.constraints, pressure)) {
      const auto at = [&](std::size_t i) { return mesh_.nodes[face.corners[i]]; };
      const Point area = cross(minus(at(2), at(0)), minus(at(3), at(1)));
      const Point own = times(-pressure.pressure / 2, area);
      const Point middle = times(0.25, sum(sum(at(0), at(1)), sum(at(2), at(3))));
      const std::size_t g = group_of(face.corners[0]);
      force[g] = sum(force[g], own);
      moment[g] = sum(moment[g], cross(middle, own));
      apart[g] += norm(own);
    }
    for (std::size_t g = 0; g < all_.size(); ++g) {
      if (apart[g] > 0) add(g, force[g], moment[g], apart[g], pressure.table, pressure.start);
    }
  }

  const Scene& scene_;
  const ModelMesh& mesh_;
  const std::vector<std::int32_t>& group_;
  const std::vector<double>& times_;
  std::vector<DrivenMotion> all_;
  std::vector<std::int64_t> nodes_;
  std::vector<Weight> weight_;
  bool weighed_ = false;
  std::vector<bool> rigid_;                   ///< whether all of a group is one rigid body
  std::vector<std::vector<Point>> together_;  ///< where forces on single places bring each group, at each time [length]
  std::vector<std::vector<Point>> swing_;     ///< angles by which forces turn each group, at each time [rad]
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

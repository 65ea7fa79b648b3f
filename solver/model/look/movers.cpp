#include "movers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <solver/model/interfaces/ties.hpp>
#include <solver/model/rigid/rigid_nodes.hpp>
#include <solver/model/selection/node_selection.hpp>

#include "driven_motion.hpp"
#include "initial_motion.hpp"
#include "led_movers.hpp"

namespace pinball {

namespace {

constexpr std::size_t cells_along = 5;  ///< of a body, along each axis
constexpr double turns = 0.05;          ///< an angle beyond which a mover is as good as turned all ways [rad]

/// Bodies that have nodes in common, or are tied all the time, or one rigid body takes along, have one number; numbers
/// count from 0.
class Groups {
 public:
  Groups(const Scene& scene, const ModelMesh& mesh) : group(scene.bodies.size()) {
    std::iota(group.begin(), group.end(), 0);
    join_by_nodes(mesh);
    join_tied(scene, mesh);
    const std::vector<std::int32_t> rigid = rigid_body_of_bodies(scene);
    join_rigid_bodies(rigid);
    join_attached(scene, mesh, rigid);
    std::vector<std::int32_t> number(group.size(), -1);
    for (std::int32_t& own : group) {
      std::int32_t& of_root = number[root(own)];
      if (of_root < 0) of_root = count++;
      named_.push_back(of_root);
    }
    group = std::move(named_);
  }
  std::vector<std::int32_t> group;
  std::int32_t count = 0;

 private:
  std::int32_t root(std::int32_t body) const {
    while (group[body] != body) body = group[body];
    return body;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = root(a);
    b = root(b);
    group[std::max(a, b)] = std::min(a, b);
  }
  void join_by_nodes(const ModelMesh& mesh) {
    for (std::size_t b = 0; b < mesh.shared.size(); ++b) {
      for (const std::int32_t n : mesh.shared[b]) join(b, mesh.body_of_node[n]);
    }
  }
  void join_rigid_bodies(const std::vector<std::int32_t>& rigid) {
    for (std::size_t b = 0; b < rigid.size(); ++b) {
      if (rigid[b] >= 0) join(std::ranges::find(rigid, rigid[b]) - rigid.begin(), b);
    }
  }
  /// Bodies whose nodes a rigid body takes along, with its own.
  void join_attached(const Scene& scene, const ModelMesh& mesh, const std::vector<std::int32_t>& rigid) {
    std::vector<std::int32_t> first(scene.rigid_bodies.size(), -1);
    for (std::size_t b = rigid.size(); b-- > 0;) {
      if (rigid[b] >= 0) first[rigid[b]] = static_cast<std::int32_t>(b);
    }
    for (const AttachedNodes& attached : scene.attached_nodes) {
      std::int32_t& with = first[rigid_body_of_name(scene, attached.rigid_body)];
      for (const std::int32_t n : select_nodes(mesh, attached.nodes)) {
        if (with < 0) with = mesh.body_of_node[n];
        join(with, mesh.body_of_node[n]);
      }
    }
  }
  /// By nodes that are tied: a tie may hold none. The ties that the model finds are not known here.
  void join_tied(const Scene& scene, const ModelMesh& mesh) {
    const auto lasts = [&scene](const TiedContact& tied) { return tied.start <= 0 && tied.end >= scene.time.end; };
    if (std::ranges::none_of(scene.tied_contacts, lasts)) return;
    ModelMesh found = mesh;
    std::vector<TiedResult> counts;
    for (const TiedNode& tied : find_ties(scene, found, counts)) {
      if (!lasts(scene.tied_contacts[tied.tie])) continue;
      for (const std::int32_t corner : tied.corner) join(mesh.body_of_node[tied.node], mesh.body_of_node[corner]);
    }
  }

  std::vector<std::int32_t> named_;
};

Extent box_of(const ModelMesh& mesh, std::size_t element) {
  Extent box;
  for (const std::int32_t n : mesh.hexahedra[element]) box.take(mesh.nodes[n]);
  return box;
}

/// Each body cut into boxes by a grid; an element belongs to the one in which its middle lies.
void cut_into_cells(const ModelMesh& mesh, const std::vector<std::int32_t>& group, std::vector<Mover>& movers) {
  const std::size_t bodies = mesh.body_names.size();
  std::vector<Extent> whole(bodies);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) whole[mesh.body_of_node[n]].take(mesh.nodes[n]);
  for (std::size_t b = 0; b < mesh.shared.size(); ++b) {
    for (const std::int32_t n : mesh.shared[b]) whole[b].take(mesh.nodes[n]);
  }
  constexpr std::size_t all = cells_along * cells_along * cells_along;
  std::vector<Extent> cells(bodies * all);
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    const std::size_t b = mesh.body[e];
    const Extent box = box_of(mesh, e);
    std::size_t cell = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = whole[b].high[k] - whole[b].low[k];
      const double place = length > 0 ? ((box.low[k] + box.high[k]) / 2 - whole[b].low[k]) / length : 0.0;
      cell = cell * cells_along + static_cast<std::size_t>(std::clamp(place, 0.0, 0.999) * cells_along);
    }
    cells[b * all + cell].take(box);
  }
  for (std::size_t b = 0; b < bodies; ++b) {
    Mover& mover = movers[group[b]];
    mover.bodies.push_back(b);
    for (std::size_t c = 0; c < all; ++c) {
      if (cells[b * all + c].empty()) continue;
      mover.cells.push_back({cells[b * all + c], static_cast<std::int32_t>(b)});
      mover.box.take(cells[b * all + c]);
    }
  }
}

Extent cube(const Point& c, double r) { return {{c[0] - r, c[1] - r, c[2] - r}, {c[0] + r, c[1] + r, c[2] + r}}; }

/// What turns is a sphere about its centre, as far as anybody knows.
void make_round(Mover& mover, const InitialMotion& motion) {
  mover.box = cube(motion.centre, motion.radius);
  mover.cells = {{mover.box, mover.bodies.front()}};
  mover.round = true;
}

Extent scaled(const Extent& velocity, double time) {
  Extent box = velocity;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] *= time;
    box.high[k] *= time;
  }
  return box;
}

/// The motion of all nodes that acts along an axis at a time; null: none does.
const WholeMotion* acting(const DrivenMotion& driven, std::size_t axis, double time) {
  const WholeMotion* last = nullptr;
  for (const WholeMotion& motion : driven.whole) {
    if (motion.along[axis] && motion.course.from <= time && time < motion.course.to) last = &motion;
  }
  return last;
}

/// Displacements along an axis, at each time, of what is free while nothing moves all of it: with the velocity that it
/// has then, and pushed or not.
void follow(const InitialMotion& initial, const DrivenMotion& driven, std::size_t k, bool is_pushed,
            const std::vector<double>& times, std::vector<Extent>& places) {
  double low = 0, high = 0, slowest = initial.velocity.low[k], fastest = initial.velocity.high[k];
  for (std::size_t j = 0; j < times.size(); ++j) {
    double least = 0, most = 0;  // on the way here, beside where it is now
    if (j > 0) {
      const double h = times[j] - times[j - 1];
      double way = 0, change = 0;
      if (const WholeMotion* motion = acting(driven, k, times[j] - h / 2)) {
        const MotionCourse& course = motion->course;
        const double one = motion->vector[k] * (course.low[j] - course.way[j]);
        const double other = motion->vector[k] * (course.high[j] - course.way[j]);
        least = std::min(one, other);
        most = std::max(one, other);
        way = motion->vector[k] * (course.way[j] - course.way[j - 1]);
        if (motion->adds) {
          way -= h * motion->vector[k] * course.rate[j - 1];
          change = motion->vector[k] * (course.rate[j] - course.rate[j - 1]);
        } else {
          slowest = fastest = 0;
          change = motion->vector[k] * course.rate[j];
        }
      } else if (is_pushed) {
        way = driven.pushed[j][k] - driven.pushed[j - 1][k] - h * driven.push_rate[j - 1][k];
        change = driven.push_rate[j][k] - driven.push_rate[j - 1][k];
      }
      low += slowest * h + way;
      high += fastest * h + way;
      slowest += change;
      fastest += change;
    }
    places[j].low[k] = low + least;
    places[j].high[k] = high + most;
  }
}

/// Displacements at each time. stopped: directions in which nothing pushes it.
std::vector<Extent> ways(const InitialMotion& initial, const DrivenMotion& driven, const std::array<bool, 3>& stopped,
                         const std::vector<double>& times) {
  std::vector<Extent> places;
  for (std::size_t j = 0; j < times.size(); ++j) {
    Point pushed = driven.pushed[j];
    for (std::size_t k = 0; k < 3; ++k) {
      if (stopped[k]) pushed[k] = 0;
    }
    places.push_back(scaled(initial.velocity, times[j]) + Extent{pushed, pushed});
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const bool any = std::ranges::any_of(driven.whole, [k](const WholeMotion& motion) { return motion.along[k]; });
    if (any) follow(initial, driven, k, !stopped[k], times, places);
  }
  return places;
}

Point middle_of(const Extent& box) {
  Point middle;
  for (std::size_t k = 0; k < 3; ++k) middle[k] = 0.5 * (box.low[k] + box.high[k]);
  return middle;
}

/// As `moved`: with its mean velocity, and as some of its nodes are moved beside that.
std::vector<Drift> drift_of(const InitialMotion& initial, const DrivenMotion& driven,
                            const std::vector<double>& times) {
  InitialMotion mean = initial;
  mean.velocity = {initial.mean, initial.mean};
  const std::vector<Extent> places = ways(mean, driven, driven.stopped, times);
  std::vector<Drift> all(times.size());
  for (std::size_t j = 0; j < times.size(); ++j) {
    const Point way = middle_of(places[j]);
    all[j] = {{way}, initial.spread * times[j] + 0.5 * norm(minus(places[j].high, places[j].low))};
    for (const PartMotion& part : driven.parts) {
      Point of_part = part.way[j];
      const double along = part.direction ? dot(way, *part.direction) : 0.0;
      for (std::size_t k = 0; k < 3 && part.direction; ++k) of_part[k] += way[k] - along * (*part.direction)[k];
      all[j].ways.push_back(of_part);
    }
  }
  return all;
}

void move(Mover& mover, const InitialMotion& initial, const DrivenMotion& driven, const std::vector<double>& times) {
  mover.held = driven.held;
  mover.speed = driven.held ? 0.0 : driven.wholly ? driven.speed : std::max(initial.speed, driven.speed);
  if (driven.held) {
    mover.moved.assign(times.size(), Extent{{}, {}});
    mover.strayed = mover.moved;
    mover.drift.assign(times.size(), Drift{{Point{}}, 0});
    return;
  }
  mover.drift = drift_of(initial, driven, times);
  const bool stopped = driven.stopped[0] || driven.stopped[1] || driven.stopped[2];
  // What is held or moved in part deforms, and what deforms spreads to all sides.
  const bool deforms = !driven.wholly && (driven.guided || driven.in_part || stopped);
  // Angles that are too small for a sphere.
  const double angle = std::max(driven.turned, driven.swung), leans = angle > turns ? 0.0 : angle;
  mover.moved = ways(initial, driven, driven.stopped, times);
  mover.strayed = stopped ? ways(initial, driven, {}, times) : mover.moved;
  double furthest = 0;
  for (std::size_t j = 0; j < times.size(); ++j) {
    if (!driven.moved[j].empty()) mover.moved[j].take(driven.moved[j]);
    Extent& strayed = mover.strayed[j];
    const double carried = strayed.reach() + driven.carried[j];
    strayed.take(mover.moved[j]);
    furthest = std::max({furthest, strayed.reach(), carried});
    if (deforms) strayed.take(cube({}, furthest));
    if (!driven.wholly && driven.strained[j] > 0) strayed.take(cube({}, carried + driven.strained[j]));
    if (leans > 0) strayed = strayed + cube({}, leans * initial.radius);
  }
}

/// Signed distance along a direction of the corner of a box that is furthest back.
double lowest(const Extent& box, const Point& normal) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += normal[k] * (normal[k] > 0 ? box.low[k] : box.high[k]);
  return sum;
}

/// Signed distances of the movers' nodes along a normal, the lowest of each: boxes of bodies that lie askew reach
/// further.
std::vector<double> lowest_nodes(const ModelMesh& mesh, const std::vector<std::int32_t>& group, std::size_t movers,
                                 const Point& normal) {
  std::vector<double> lowest(movers, INFINITY);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    double& own = lowest[group[mesh.body_of_node[n]]];
    own = std::min(own, dot(normal, mesh.nodes[n]));
  }
  return lowest;
}

/// Whether a wall is met, by which the mover may fly anywhere. With a wall that moves, or is pushed, whatever is in its
/// way is moved. lowest: of the mover at the start, per wall.
void meet_walls(const Scene& scene, const std::vector<double>& times, const std::vector<double>& lowest_at_start,
                Mover& mover) {
  for (std::size_t w = 0; w < scene.rigid_walls.size(); ++w) {
    const RigidWall& wall = scene.rigid_walls[w];
    const double place = dot(wall.plane.normal, wall.plane.point), margin = 1e-6 * mover.box.size();
    for (std::size_t j = 0; j < times.size() && !mover.meets_wall; ++j) {
      const double gap = lowest_at_start[w] + lowest(mover.strayed[j], wall.plane.normal) - place;
      mover.meets_wall = gap - wall_displacement(wall, times[j]) <= margin;
    }
    if (mover.meets_wall) mover.speed = std::max(mover.speed, std::abs(wall.speed));
  }
  if (!mover.meets_wall) return;
  double furthest = 0;
  for (std::size_t j = 0; j < times.size(); ++j) {
    furthest = std::max({furthest, mover.strayed[j].reach(), mover.speed * times[j]});
    mover.strayed[j].take(Extent{{-furthest, -furthest, -furthest}, {furthest, furthest, furthest}});
  }
}

}  // namespace

Movers find_movers(const Scene& scene, const ModelMesh& mesh) {
  Movers movers;
  const Groups groups(scene, mesh);
  const std::size_t count = groups.count;
  movers.all.resize(count);
  movers.times = look_times(scene, count);
  cut_into_cells(mesh, groups.group, movers.all);
  const std::vector<InitialMotion> initial = initial_motions(scene, mesh, groups.group, count);
  const std::vector<DrivenMotion> driven = driven_motions(scene, mesh, groups.group, count, movers.times);
  std::vector<std::vector<double>> of_walls;  // per wall, of each mover
  for (const RigidWall& wall : scene.rigid_walls)
    of_walls.push_back(lowest_nodes(mesh, groups.group, count, wall.plane.normal));
  for (std::size_t g = 0; g < count; ++g) {
    Mover& mover = movers.all[g];
    const double turned = std::max(initial[g].turning * scene.time.end, driven[g].turned);
    const bool is_round = turned > turns && !driven[g].held;
    const bool swings = driven[g].swung > turns && !driven[g].held;
    mover.turns = (driven[g].turned > 1e-9 || driven[g].swung > 1e-9) && !driven[g].held;
    if (swings) mover.sphere = cube(initial[g].centre, initial[g].radius);
    std::vector<double> lowest_at_start;
    for (std::size_t w = 0; w < of_walls.size(); ++w) {
      const double turning = dot(scene.rigid_walls[w].plane.normal, initial[g].centre) - initial[g].radius;
      lowest_at_start.push_back(is_round || swings ? turning : of_walls[w][g]);
    }
    if (is_round) make_round(mover, initial[g]);
    move(mover, initial[g], driven[g], movers.times);
    meet_walls(scene, movers.times, lowest_at_start, mover);
    const auto goes = [](const Extent& way) { return way.reach() > 0; };
    const bool moves = mover.speed > 0 || mover.turns || std::ranges::any_of(mover.strayed, goes);
    movers.anything_moves = movers.anything_moves || (moves && !mover.held);
  }
  let_others_lead(leads_of(scene, mesh, groups.group), driven, movers);
  return movers;
}

}  // namespace pinball

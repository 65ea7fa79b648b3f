#include "sphere_springs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pinball {

namespace {

/// What the depth of a sphere that has rolled on may differ by from what approach explains, over the depth [-].
constexpr double least_difference = 1e-6;

/// Spheres are no faces: with these all faces that are exposed are segments.
template <class S>
SurfaceTopology without_spheres(const SurfaceSource<S>& source, SurfaceTopology topology) {
  for (std::size_t slot = 0; slot < topology.alive.size(); ++slot) {
    if (topology.alive[slot] != 0 && source.element(slot).sphere) topology.exposed[slot] = 0;
  }
  return topology;
}

/// Rate at which the depth grows [length/time].
template <class S, class Touch>
double closing_rate(const NodeRecords<S>& nodes, const Touch& touch) {
  double rate = 0;
  for (int k = 0; k < 5; ++k) {
    rate -= touch.weight[k] * dot(double_vector_of(nodes.v(touch.node[k])), touch.direction);
  }
  return rate;
}

}  // namespace

template <class S>
bool SphereSprings<S>::wanted(const ContactSettings& settings, const SurfaceSource<S>& source,
                              const SurfaceTopology& topology) {
  if (settings.gap != ContactGap::face || settings.enforcement != Enforcement::penalty) return false;
  for (std::size_t slot = 0; slot < topology.alive.size(); ++slot) {
    if (topology.alive[slot] != 0 && source.element(slot).sphere) return true;
  }
  return false;
}

template <class S>
SphereSprings<S>::SphereSprings(const ContactSettings& settings, const SurfaceSource<S>& source,
                                SurfaceTopology topology)
    : settings_(settings),
      surface_(source, without_spheres(source, std::move(topology))),
      spheres_(source, surface_.topology()) {
  for (const auto& sphere : spheres_.spheres()) bulk_modulus_.push_back(source.element(sphere.slot).bulk_modulus);
  collect_stiffness(source);
}

template <class S>
void SphereSprings<S>::collect_stiffness(const SurfaceSource<S>& source) {
  stiffness_.clear();
  for (const auto& segment : surface_.segments()) {
    stiffness_.push_back(source.element(segment.slot).bulk_modulus * settings_.radius_factor * segment.radius);
  }
}

template <class S>
double SphereSprings<S>::remove_eroded(const std::vector<std::int64_t>& eroded) {
  if (!surface_.remove_eroded(eroded)) return 0;
  double lost = 0;
  const auto ends = [this](const Touch& touch) {
    return !surface_.exposed(touch.slot, touch.face) ||
           !surface_.topology().alive(spheres_.spheres()[touch.sphere].slot);
  };
  for (const Touch& touch : touches_) lost += ends(touch) ? touch.stored() : 0.0;
  touches_.erase(std::remove_if(touches_.begin(), touches_.end(), ends), touches_.end());
  return lost;
}

template <class S>
void SphereSprings<S>::build(const SurfaceSource<S>& source, const SurfaceMotion<S>& motion, const JoinedBodies& joined,
                             S horizon) {
  if (surface_.changed()) {
    surface_.collect(source);
    collect_stiffness(source);
  }
  lists_.build(source, surface_, spheres_, motion, settings_, joined, horizon);
}

template <class S>
std::vector<std::int32_t> SphereSprings<S>::listed_nodes() const {
  std::vector<std::int32_t> nodes;
  for (std::int32_t s = 0; s < spheres_.count(); ++s) {
    if (lists_.first(s) == lists_.first(s + 1)) continue;
    nodes.push_back(spheres_.spheres()[s].node);
    for (std::int64_t place = lists_.first(s); place < lists_.first(s + 1); ++place) {
      const auto& of = surface_.segments()[lists_.segment(place)].node;
      nodes.insert(nodes.end(), std::begin(of), std::end(of));
    }
  }
  return nodes;
}

template <class S>
bool SphereSprings<S>::Touch::is_beside(const Touch& other) const {
  return std::any_of(node + 1, node + 5, [&other](std::int32_t n) {
    return std::find(other.node + 1, other.node + 5, n) != other.node + 5;
  });
}

/// Mean of the faces around a node: so the spring does not jump where a sphere rolls from an element to a larger one.
template <class S>
double SphereSprings<S>::stiffness_at(std::int32_t slave) const {
  double sum = 0;
  int faces = 0;
  for (const std::int32_t s : surface_.around(slave)) {
    if (!surface_.active_segment(s)) continue;
    sum += stiffness_[s];
    ++faces;
  }
  return sum / std::max(faces, 1);
}

template <class S>
typename SphereSprings<S>::Touch SphereSprings<S>::touch_of(std::int32_t sphere, const FaceTouch& at) const {
  const auto& own = spheres_.spheres()[sphere];
  const std::size_t number = at.segment;
  const auto& segment = surface_.segments()[number];
  const double radius = own.radius;
  Touch touch{};
  touch.sphere = sphere;
  touch.slot = segment.slot;
  touch.face = segment.face;
  touch.node[0] = own.node;
  touch.weight[0] = 1;
  for (int k = 0; k < 4; ++k) {
    touch.node[k + 1] = segment.node[k];
    touch.weight[k + 1] = -at.weight[k];
  }
  touch.direction = at.direction;
  touch.depth = at.depth;
  double elements = 0;
  for (std::size_t k = 0; k < 4; ++k) elements += at.weight[k] * stiffness_at(surface_.slaves_of(at.segment)[k]);
  touch.stiffness = 0.5 * settings_.beta * (elements + bulk_modulus_[sphere] * radius);
  touch.ratio = at.depth / (radius + settings_.radius_factor * segment.radius);
  return touch;
}

template <class S>
void SphereSprings<S>::give_depth(Touch& touch, const Touch* before, double rate, double dt, Work& work) {
  const double approach = std::max(0.0, rate) * dt;
  touch.elastic = before != nullptr ? touch.depth - std::min(before->depth - before->elastic, touch.depth)
                                    : std::min(touch.depth, approach);
  Touch* from = nullptr;  // the contact that has moved on to this face
  for (Touch& ended : work.ended) {
    if (ended.is_beside(touch) && ended.elastic > (from != nullptr ? from->elastic : 0.0)) from = &ended;
  }
  if (from == nullptr) return;
  // No more energy than it had, on whatever spring it has come to.
  const double same_energy = from->elastic * std::sqrt(from->stiffness / touch.stiffness);
  const double taken = std::min(touch.depth, same_energy + least_difference * touch.depth);
  if (!(taken > touch.elastic)) return;
  const double own = before != nullptr ? touch.elastic : 0.0;
  work.lost -= 0.5 * touch.stiffness * (taken * taken - own * own);
  touch.elastic = taken;
  from->elastic = 0;
}

template <class S>
void SphereSprings<S>::give_force(const SurfaceSource<S>& source, Touch& touch, double rate) const {
  double inverse_mass = 0;
  for (int k = 0; k < 5; ++k) {
    inverse_mass += touch.weight[k] * touch.weight[k] * source.inverse_mass[touch.node[k]];
  }
  const double p1 = 2 * settings_.damping * std::sqrt(touch.stiffness / inverse_mass);
  const double spring = touch.stiffness * touch.elastic;
  touch.force = std::max(0.0, spring + p1 * rate);  // (3.8), no adhesion
  touch.damped = (touch.force - spring) * rate;
}

template <class S>
void SphereSprings<S>::compute_sphere(const SurfaceSource<S>& source, std::int32_t sphere, double dt,
                                      Work& work) const {
  const auto of_sphere = [](const Touch& touch, std::int32_t s) { return touch.sphere < s; };
  const auto begin = std::lower_bound(touches_.begin(), touches_.end(), sphere, of_sphere);
  const auto end = std::lower_bound(begin, touches_.end(), sphere + 1, of_sphere);
  const bool alive = surface_.topology().alive(spheres_.spheres()[sphere].slot);
  const std::size_t first = work.touches.size();
  if (alive) {
    for (const FaceTouch& at : work.near.find(source, surface_, spheres_, lists_, sphere)) {
      work.touches.push_back(touch_of(sphere, at));
    }
  }
  work.ended.clear();
  const auto now = work.touches.begin() + first;
  for (auto before = begin; before != end; ++before) {
    const bool goes_on = std::any_of(now, work.touches.end(), [&](const Touch& t) { return t.is_of(*before); });
    if (goes_on) continue;
    Touch ended = *before;  // with what the last step has made of it
    ended.elastic = std::max(0.0, ended.elastic + closing_rate<S>(source, ended) * dt);
    work.lost += ended.stored();
    work.ended.push_back(ended);
  }
  for (auto touch = now; touch != work.touches.end(); ++touch) {
    const auto before = std::find_if(begin, end, [&](const Touch& t) { return t.is_of(*touch); });
    const double rate = closing_rate<S>(source, *touch);
    give_depth(*touch, before != end ? &*before : nullptr, rate, dt, work);
    give_force(source, *touch, rate);
  }
}

template <class S>
SphereSums SphereSprings<S>::compute(const SurfaceSource<S>& source, double dt) {
  parallel_for("spheres on faces", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    Work& work = work_[piece];
    work.touches.clear();
    work.lost = 0;
    const auto until = [&](std::int64_t p) -> std::int32_t { return spheres_.count() * p / fixed_pieces; };
    for (std::int32_t s = until(piece); s < until(piece + 1); ++s) compute_sphere(source, s, dt, work);
  });
  touches_.clear();
  SphereSums sums;
  for (const Work& work : work_) {
    touches_.insert(touches_.end(), work.touches.begin(), work.touches.end());
    sums.lost += work.lost;
  }
  for (const Touch& touch : touches_) {
    sums.stored += touch.stored();
    sums.damped += touch.damped;
    ++sums.pairs;
    if (touch.ratio > sums.penetration_ratio) {
      sums.penetration_ratio = touch.ratio;
      sums.deepest = touch.node[0];
    }
  }
  return sums;
}

/// One after the other: two spheres may share nodes of their faces.
template <class S>
void SphereSprings<S>::add_forces(const SurfaceSource<S>& source) const {
  for (const Touch& touch : touches_) {
    for (int k = 0; k < 5; ++k) {
      S* f = source.f(touch.node[k]);
      const double along = touch.weight[k] * touch.force;
      f[0] += static_cast<S>(along * touch.direction.x);
      f[1] += static_cast<S>(along * touch.direction.y);
      f[2] += static_cast<S>(along * touch.direction.z);
      f[3] += static_cast<S>(2 * std::abs(touch.weight[k]) * touch.stiffness);  // Gershgorin: a row of k G G^T
    }
  }
}

template <class S>
void SphereSprings<S>::add_node_forces(std::span<Point> node_force) const {
  for (const Touch& touch : touches_) {
    for (int k = 0; k < 5; ++k) {
      Point& sum = node_force[touch.node[k]];
      const double along = touch.weight[k] * touch.force;
      sum[0] += along * touch.direction.x;
      sum[1] += along * touch.direction.y;
      sum[2] += along * touch.direction.z;
    }
  }
}

template <class S>
std::size_t SphereSprings<S>::bytes() const {
  std::size_t sum = surface_.bytes() + spheres_.bytes() + lists_.bytes() + touches_.capacity() * sizeof(Touch) +
                    (bulk_modulus_.capacity() + stiffness_.capacity()) * sizeof(double);
  for (const Work& work : work_) sum += (work.touches.capacity() + work.ended.capacity()) * sizeof(Touch);
  return sum;
}

template class SphereSprings<double>;
template class SphereSprings<float>;

}  // namespace pinball

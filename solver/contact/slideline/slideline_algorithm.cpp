#include "slideline_algorithm.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <kernels/exec.hpp>

namespace pinball {

namespace {

/// How far beyond an edge a foot may lie, over the radius of the segment: round-off on a common edge.
constexpr double edge_margin = 1e-3;

/// Velocity of the foot relative to its node: along the normal, how fast the gap closes [length/time].
template <class S>
Vec3<S> closing_velocity(const NodeRecords<S>& nodes, std::int32_t slave, const std::int32_t (&node)[4],
                         const FaceProjection<S>& at) {
  Vec3<S> v = S(-1) * vector_of(nodes.v(slave));
  for (int i = 0; i < 4; ++i) v = v + at.weight[i] * vector_of(nodes.v(node[i]));
  return v;
}

}  // namespace

template <class S>
SlidelineAlgorithm<S>::SlidelineAlgorithm(const ContactSettings& settings, const SurfaceSource<S>& source,
                                          InitialSurface start)
    : ContactAlgorithm<S>(settings, source, start),
      surface_(source, std::move(start.topology)),
      search_(source, surface_, settings.self),
      memory_(surface_.slaves().size()),
      beta_(static_cast<S>(settings.beta)),
      damping_(static_cast<S>(settings.damping)) {}

template <class S>
double SlidelineAlgorithm<S>::end_inactive_touches() {
  double lost = 0;
  for (std::size_t i = 0; i < memory_.size(); ++i) {
    PairMemory& memory = memory_[i];
    if (memory.slot < 0 || (surface_.active(i) && surface_.exposed(memory.slot, memory.face))) continue;
    lost += memory.stored;
    memory = {};
  }
  return lost;
}

template <class S>
void SlidelineAlgorithm<S>::collect_surface(const SurfaceSource<S>& source) {
  const std::vector<typename SegmentSurface<S>::Slave> before = surface_.slaves();
  const std::vector<PairMemory> old = std::move(memory_);
  surface_.collect(source);
  memory_.assign(surface_.slaves().size(), {});
  std::size_t now = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (old[i].slot < 0) continue;
    while (surface_.slaves()[now].node < before[i].node) ++now;  // what touches stays, and both are sorted by node
    memory_[now] = old[i];
  }
  search_.invalidate();
}

template <class S>
void SlidelineAlgorithm<S>::update_surface(const SurfaceSource<S>& source, const std::vector<std::int64_t>& eroded) {
  lost_energy_ = 0;
  if (surface_.remove_eroded(eroded)) {
    lost_energy_ = end_inactive_touches();
    if (!surface_.complete()) {
      search_.invalidate();
      return;  // the search collects it anew
    }
  }
  surface_.update(source);
}

template <class S>
void SlidelineAlgorithm<S>::search(const SurfaceSource<S>& source, double /*dt*/) {
  const bool reuse = source.lists_last;
  if (this->may_keep_lists(source) && search_.holds(source)) {
    ++this->searches_skipped_;
    return;
  }
  source.before_search();
  ++this->searches_;
  if (surface_.changed()) collect_surface(source);  // a good moment to let those behind the new surface wait
  search_.build(source, surface_, reuse ? static_cast<S>(this->settings_.skin) : S(0), this->pairs_.get());
  this->lists_outdated_ = false;
  surface_.choose_none();
  for (const std::int32_t segment : search_.listed()) surface_.choose(segment);
  for (std::size_t i = 0; i < surface_.slaves().size(); ++i) {
    if (search_.count(i) > 0) surface_.choose_around(i);
  }
  surface_.finish_choice();
  surface_.update(source);
}

template <class S>
bool SlidelineAlgorithm<S>::find_segment(const SurfaceSource<S>& source, std::size_t slave, S open_gap,
                                         Touch& touch) const {
  const std::int32_t* candidate = search_.candidates(slave);
  const std::int64_t count = search_.count(slave);
  const auto& own = surface_.slaves()[slave];
  const Vec3<S> x = vector_of(source.x(own.node));
  const PairMemory& memory = memory_[slave];
  const S* sphere = surface_.sphere().data();
  const S* plane = surface_.plane().data();
  bool found = false, found_like_before = false;
  for (std::int64_t c = 0; c < count; ++c) {
    const S* ball = record(sphere, candidate[c]);
    const Vec3<S> d = x - vector_of(ball);
    if (!(dot(d, d) < ball[3] * ball[3])) continue;
    const auto& segment = surface_.segments()[candidate[c]];
    const S* flat = record(plane, candidate[c]);
    const Vec3<S> normal = vector_of(flat);
    const S height = dot(d, normal);  // over the mean plane: most are well outside
    if (height > open_gap * segment.radius + flat[3] ||
        height < S(0) - SegmentSurface<S>::deepest * segment.radius - flat[3] || !surface_.faces(slave, normal) ||
        !search_.may_touch(own, segment)) {
      continue;
    }
    Vec3<S> corner[4];
    for (int i = 0; i < 4; ++i) corner[i] = vector_of(source.x(segment.node[i]));
    const bool same = memory.slot == segment.slot && memory.face == segment.face;
    const FaceProjection<S> at = project_onto_face(corner, x, same ? memory.xi : S(0), same ? memory.eta : S(0));
    // A node in contact stays with the side that it came in from, also where two segments meet in a valley and its foot
    // lies on neither.
    const bool like_before = memory.slot >= 0 && (same || dot(at.normal, memory.normal) > S(0.5));
    const S margin = maximum(static_cast<S>(edge_margin) * segment.radius, like_before ? absolute(at.gap) : S(0));
    if (!(at.outside <= margin)) continue;
    const S depth_limit = like_before ? SegmentSurface<S>::deepest * segment.radius : segment.radius;
    if (at.gap > open_gap * segment.radius || at.gap < -depth_limit) continue;
    const bool better =
        !found || (like_before && !found_like_before) ||
        (like_before == found_like_before && absolute(at.gap) + at.outside < absolute(touch.at.gap) + touch.at.outside);
    if (!better) continue;
    found = true;
    found_like_before = like_before;
    touch.slave = slave;
    touch.segment = candidate[c];
    touch.at = at;
  }
  return found;
}

template <class S>
template <class Work>
typename SlidelineAlgorithm<S>::Sums SlidelineAlgorithm<S>::find_touches(const SurfaceSource<S>& source, S open_gap,
                                                                         const Work& work) {
  const std::int64_t n = surface_.slaves().size();
  std::array<std::vector<Touch>, fixed_pieces> found;
  std::array<Sums, fixed_pieces> sums;
  parallel_for("slave nodes", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    const std::size_t p = piece;
    for (std::int64_t i = n * piece / fixed_pieces; i < n * (piece + 1) / fixed_pieces; ++i) {
      PairMemory& memory = memory_[i];
      Touch touch{};
      if (surface_.active(i) && find_segment(source, i, open_gap, touch)) {
        if (work(touch, sums[p])) found[p].push_back(touch);
        const auto& segment = surface_.segments()[touch.segment];
        if (touch.at.gap <= S(0)) {
          memory.slot = segment.slot;
          memory.face = segment.face;
          memory.xi = touch.at.xi;
          memory.eta = touch.at.eta;
          memory.normal = touch.at.normal;
          continue;
        }
      } else {
        sums[p].lost += static_cast<double>(memory.stored);
      }
      memory = {};
    }
  });
  touches_.clear();
  Sums whole;
  for (std::size_t p = 0; p < fixed_pieces; ++p) {
    touches_.insert(touches_.end(), found[p].begin(), found[p].end());
    whole.stored += sums[p].stored;
    whole.damped += sums[p].damped;
    whole.lost += sums[p].lost;
    whole.pairs += sums[p].pairs;
    whole.take_depth(sums[p].ratio, sums[p].deepest);
  }
  return whole;
}

template <class S>
bool SlidelineAlgorithm<S>::penalty_force(const SurfaceSource<S>& source, Touch& touch, S dt, Sums& sums) {
  const auto& slave = surface_.slaves()[touch.slave];
  const auto& segment = surface_.segments()[touch.segment];
  PairMemory& memory = memory_[touch.slave];
  // Faces that rest on each other have gaps of round-off, which differ with the segment that a node finds.
  const S round_off = S(4096) * std::numeric_limits<S>::epsilon() * segment.radius;
  const S depth = S(0) - touch.at.gap - round_off;
  if (!(depth > S(0)) && memory.slot < 0) return false;
  const Vec3<S> closing = closing_velocity<S>(source, slave.node, segment.node, touch.at);
  const bool is_next = memory.slot >= 0 && (memory.slot != segment.slot || memory.face != segment.face);
  // Forces of the last segment go on along its normal until now; the foot is the same point on the edge of both.
  const S rate = dot(closing, touch.at.normal), rate_before = is_next ? dot(closing, memory.normal) : rate;
  sums.damped += S(0.5) * memory.damping * rate_before * dt;  // the second half of the last one's work
  if (!(depth > S(0))) {                                      // open within round-off: the node keeps its segment
    memory.offset = memory.elastic = memory.stored = memory.damping = S(0);
    return false;
  }
  const S approach = maximum(S(0), rate) * dt;
  const S stiffness = S(0.25) * beta_ * (slave.stiffness + slave.share * segment.stiffness);
  S elastic = memory.slot >= 0 ? depth - minimum(memory.offset, depth) : minimum(depth, approach);
  if (is_next) elastic = minimum(elastic, memory.elastic + approach);
  const S stored = S(0.5) * stiffness * elastic * elastic;
  if (is_next) {
    // Where the next segment is not the continuation of the last, the depth jumps: it may not go up, and what the work
    // of the step put in and the spring has not is counted.
    const S force_before = memory.elastic > S(0) ? S(2) * memory.stored / memory.elastic : S(0);
    const S work = S(0.5) * (force_before * rate_before + stiffness * elastic * rate) * dt;
    sums.lost += memory.stored + work - stored;
  }
  memory.offset = depth - elastic;
  memory.elastic = elastic;
  memory.stored = stored;

  S inverse_mass = source.inverse_mass[slave.node];
  for (int i = 0; i < 4; ++i) {
    inverse_mass += touch.at.weight[i] * touch.at.weight[i] * source.inverse_mass[segment.node[i]];
  }
  const S p1 = S(2) * damping_ * square_root(stiffness / inverse_mass);
  // In the first and in the last step of a contact the spring works over a part of the step only. With the mean of 1
  // and that part the work of the trapezoid is the energy stored: else a contact of few steps gains or loses a tenth.
  const S opening = maximum(S(0), S(0) - rate) * dt;
  const S part_before = memory.slot < 0 && approach > elastic ? elastic / approach : S(1);
  const S part_after = opening > elastic ? elastic / opening : S(1);
  const S spring = S(0.5) * (part_before + part_after) * stiffness * elastic;
  touch.force = maximum(S(0), spring + p1 * rate);  // (3.8), no adhesion
  touch.stiffness = stiffness;
  sums.stored += memory.stored;
  memory.damping = touch.force - spring;
  sums.damped += S(0.5) * memory.damping * rate * dt;
  ++sums.pairs;
  sums.take_depth(depth / (slave.radius + segment.radius), slave.node);
  return true;
}

template <class S>
ContactWork SlidelineAlgorithm<S>::spring_forces(const SurfaceSource<S>& source, S dt) {
  search_.count_step(dt);
  const Sums sums = find_touches(
      source, S(0.25), [&](Touch& touch, Sums& partial) { return penalty_force(source, touch, dt, partial); });
  ContactWork work;
  work.stored = sums.stored;
  work.eroded = lost_energy_;
  work.dissipated = sums.damped + sums.lost;
  work.penetration_ratio = sums.ratio;
  work.deepest = sums.deepest;
  work.pairs = sums.pairs;
  return work;
}

template <class S>
PairOf SlidelineAlgorithm<S>::pair_of(const Touch& touch) const {
  if (!this->pairs_) return {};
  const auto& segment = surface_.segments()[touch.segment];
  return this->pairs_->node_and_face(surface_.slaves()[touch.slave].node, segment.slot, segment.face, segment.node);
}

template <class S>
void SlidelineAlgorithm<S>::add_pair_forces_of_springs(std::vector<Point>& sums) const {
  for (const Touch& touch : touches_) {
    const PairOf of = pair_of(touch);
    if (of.pair < 0) continue;
    const Vec3<S> force = touch.force * touch.at.normal;
    Point& sum = sums[of.pair];
    sum[0] += of.sign * static_cast<double>(force.x);
    sum[1] += of.sign * static_cast<double>(force.y);
    sum[2] += of.sign * static_cast<double>(force.z);
  }
}

template <class S>
void SlidelineAlgorithm<S>::add_spring_forces(const SurfaceSource<S>& source, ContactWork& work) {
  // One after the other: two slaves may share nodes of their segments.
  for (const Touch& touch : touches_) {
    const auto add = [&](std::int32_t node, S weight) {
      S* f = source.f(node);
      f[0] += weight * touch.force * touch.at.normal.x;
      f[1] += weight * touch.force * touch.at.normal.y;
      f[2] += weight * touch.force * touch.at.normal.z;
      f[3] += S(2) * absolute(weight) * touch.stiffness;  // Gershgorin: sum of a row of k G G^T
    };
    const auto& segment = surface_.segments()[touch.segment];
    add(surface_.slaves()[touch.slave].node, S(1));
    for (int i = 0; i < 4; ++i) add(segment.node[i], S(0) - touch.at.weight[i]);
  }
  S largest = 0;
  const auto row = [&](std::int32_t node) {
    largest = maximum(largest, source.f(node)[3] * source.inverse_mass[node]);
  };
  for (const Touch& touch : touches_) {
    row(surface_.slaves()[touch.slave].node);
    for (const std::int32_t node : surface_.segments()[touch.segment].node) row(node);
  }
  work.frequency2 = this->damping_factor_ * largest;
}

template <class S>
const std::vector<std::int32_t>& SlidelineAlgorithm<S>::nodes_of_springs() {
  loaded_.clear();
  for (const Touch& touch : touches_) {
    const auto& segment = surface_.segments()[touch.segment];
    loaded_.push_back(surface_.slaves()[touch.slave].node);
    loaded_.insert(loaded_.end(), std::begin(segment.node), std::end(segment.node));
  }
  return loaded_;
}

template <class S>
void SlidelineAlgorithm<S>::collect_impulses(const SurfaceSource<S>& source, double dt) {
  search_.count_step(static_cast<S>(dt));
  find_touches(source, S(0.5), [](Touch&, Sums&) { return true; });
  ImpulseSolver<S>& impulses = *this->impulses_;
  impulses.begin_rows();
  for (const Touch& touch : touches_) {
    const auto& slave = surface_.slaves()[touch.slave];
    const auto& segment = surface_.segments()[touch.segment];
    const Vec3<S>& n = touch.at.normal;
    // Named by the slave alone, which has one segment: what it remembers goes with it from one to the next.
    impulses.add_row(slave.node, -1, {n.x, n.y, n.z}, -static_cast<double>(touch.at.gap), slave.radius + segment.radius,
                     pair_of(touch));
    impulses.add_node(slave.node, -1);
    for (int i = 0; i < 4; ++i) impulses.add_node(segment.node[i], touch.at.weight[i]);
  }
  impulses.finish_rows(source, dt);
}

template <class S>
void SlidelineAlgorithm<S>::put_radii(const SurfaceSource<S>& /*source*/, std::vector<double>& /*slot_radius*/) const {}

template <class S>
void SlidelineAlgorithm<S>::add_node_forces(std::span<Point> node_force) const {
  if (this->impulses_) {
    this->impulses_->add_node_forces(node_force);
    return;
  }
  for (const Touch& touch : touches_) {
    const auto add = [&](std::int32_t node, S weight) {
      const double f = weight * touch.force;
      Point& sum = node_force[node];
      sum[0] += f * touch.at.normal.x;
      sum[1] += f * touch.at.normal.y;
      sum[2] += f * touch.at.normal.z;
    };
    add(surface_.slaves()[touch.slave].node, S(1));
    const auto& segment = surface_.segments()[touch.segment];
    for (int i = 0; i < 4; ++i) add(segment.node[i], S(0) - touch.at.weight[i]);
  }
}

template <class S>
void SlidelineAlgorithm<S>::persist(StateArchive& archive, const SurfaceSource<S>& source) {
  ContactAlgorithm<S>::persist(archive, source);
  surface_.persist(archive, source);
  search_.persist(archive, surface_, source.node_count);
  archive(memory_, touches_);  // touches: for the report alone
  archive.require(memory_.size() == surface_.slaves().size());
  for (const PairMemory& memory : memory_) {
    archive.require(memory.slot == -1 || (source.is_element(memory.slot) && memory.face >= 0 && memory.face < 6));
  }
  for (const Touch& touch : touches_) {
    archive.require(touch.slave < surface_.slaves().size() && touch.segment >= 0);
    archive.require(touch.segment < std::ssize(surface_.segments()));
  }
}

template <class S>
std::size_t SlidelineAlgorithm<S>::bytes() const {
  return surface_.bytes() + search_.bytes() + memory_.capacity() * sizeof(PairMemory) +
         touches_.capacity() * sizeof(Touch) + loaded_.capacity() * sizeof(loaded_[0]) +
         (this->impulses_ ? this->impulses_->bytes() : 0);
}

template class SlidelineAlgorithm<double>;
template class SlidelineAlgorithm<float>;

}  // namespace pinball

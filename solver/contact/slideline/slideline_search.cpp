#include "slideline_search.hpp"

#include <algorithm>
#include <limits>

#include <kernels/exec.hpp>

namespace pinball {

template <class S>
SlidelineSearch<S>::SlidelineSearch(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, bool self)
    : self_(self),
      joined_(source, surface.topology()),
      reference_node_(source.node_count),
      reference_centre_(source.slots) {
  for (auto& node : reference_node_) node[3] = std::numeric_limits<float>::max();
  const auto single = [](const Point& p) {
    return std::array{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  };
  for (std::int64_t slot = 0; slot < source.slots; ++slot) {
    if (!surface.topology().alive(slot)) continue;
    const ContactElement element = source.element(slot);
    reference_centre_[slot] = single(element.centre());
    const auto radius = static_cast<float>(element.radius);
    for (std::size_t i = 0; i < 8; ++i) {
      std::array<float, 4>& node = reference_node_[element.corners[i]];
      const std::array<float, 3> place = single(element.reference[i]);
      node = {place[0], place[1], place[2], std::min(node[3], radius)};
    }
  }
}

template <class S>
bool SlidelineSearch<S>::may_touch(const Slave& own, const Segment& other, S own_radius) const {
  if (!joined_.are_one(own.body, other.body)) return true;
  if (own.body == other.body && (!self_ || other.rigid)) return false;
  const std::array<float, 4>& p = reference_node_[own.node];
  const std::array<float, 3>& q = reference_centre_[other.slot];
  float d2 = 0;
  for (std::size_t k = 0; k < 3; ++k) d2 += (p[k] - q[k]) * (p[k] - q[k]);
  // Two and a half elements: from a node of a cube to the centre of the one after the next.
  const auto apart = 2.0F * static_cast<float>(own_radius + other.radius);
  return d2 > apart * apart;
}

template <class S>
void SlidelineSearch<S>::watch_nodes(const SurfaceSource<S>& source, const SegmentSurface<S>& surface) {
  const std::vector<Slave>& slaves = surface.slaves();
  motion_.watch(
      source.node_count, std::ssize(slaves), [&](std::int64_t i) { return slaves[i].node; },
      [&](std::int64_t i) { return least_radius(slaves[i]); });
}

/// Balls that hold whatever may touch the segments. The farthest corner goes straight relative to the centre, so that
/// its distance is largest at the beginning or at the end; both may stray.
template <class S>
void SlidelineSearch<S>::move_segments(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, S horizon) {
  const std::int32_t count = surface.segments().size();
  segments_.reset(count);
  parallel_for("segments", RangePolicy<>{0, count}, [&](std::int64_t s) {
    const auto& segment = surface.segments()[s];
    std::array<S, 3> centre{}, way{};
    for (const std::int32_t node : segment.node) {
      for (std::size_t k = 0; k < 3; ++k) {
        centre[k] += S(0.25) * source.x(node)[k];
        way[k] += S(0.25) * horizon * source.v(node)[k];
      }
    }
    S farthest2 = 0;
    for (const std::int32_t node : segment.node) {
      S now2 = 0, then2 = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const S now = source.x(node)[k] - centre[k];
        const S then = now + horizon * source.v(node)[k] - way[k];
        now2 += now * now;
        then2 += then * then;
      }
      farthest2 = std::max({farthest2, now2, then2});
    }
    const S touching = square_root(farthest2) + SegmentSurface<S>::deepest * segment.radius;
    segments_.set(s, centre, way, S(1.0001) * touching + 3 * motion_.allowance(segment.node));
  });
}

template <class S>
void SlidelineSearch<S>::move_slaves(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, S horizon) {
  const std::int32_t count = surface.slaves().size();
  slaves_.reset(count);
  parallel_for("slaves", RangePolicy<>{0, count}, [&](std::int64_t i) {
    const std::int32_t node = surface.slaves()[i].node;
    const S* x = source.x(node);
    const S* v = source.v(node);
    slaves_.set(i, {x[0], x[1], x[2]}, {horizon * v[0], horizon * v[1], horizon * v[2]},
                motion_.allowance(std::array{node}));
  });
}

template <class S>
void SlidelineSearch<S>::build(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, S skin,
                               const ContactPairs* pairs) {
  const S horizon = skin > S(0) ? horizon_steps * clock_.last_step() : S(0);
  if (watched_) motion_.adapt(source.position, clock_.elapsed(), horizon);
  if (!valid_) watch_nodes(source, surface);
  watched_ = true;
  source.before_motion(motion_.nodes());
  motion_.start(source.position, source.velocity, skin);
  clock_.restart(horizon);
  valid_ = true;
  move_segments(source, surface, horizon);
  move_slaves(source, surface, horizon);
  boxes_.build(segments_);
  find(surface, pairs);
}

template <class S>
void SlidelineSearch<S>::find(const SegmentSurface<S>& surface, const ContactPairs* pairs) {
  constexpr int G = ball_group<S>;
  const BallTreeView<S>& tree = boxes_.view();
  const std::int64_t groups = (slaves_.count() + G - 1) / G;
  start_.assign(slaves_.count() + 1, 0);
  // Slaves are searched in fixed pieces, each with a list of its own; the lists are joined in order.
  std::array<std::vector<std::int32_t>, fixed_pieces> found;
  parallel_for("slave candidates", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    std::vector<std::int32_t>& list = found[piece];
    NearBalls<S> near;
    const std::int64_t begin = groups * piece / fixed_pieces, end = groups * (piece + 1) / fixed_pieces;
    for (std::int64_t group = begin; group < end; ++group) {
      const S* own = slaves_.data() + group * 7 * G;
      near.enter(tree, finite_box_of_balls(own), 0);
      const auto near_groups = near.find(tree, own, 0);
      NearBalls<S>::leave_out_passing(tree, own, near_groups);
      for (int i = 0; i < G && group * G + i < slaves_.count(); ++i) {
        const std::size_t slave = group * G + i;
        const Slave& own_slave = surface.slaves()[slave];
        const S least = S(0.999) * least_radius(own_slave);  // for the rounding of means
        const std::size_t before = list.size();
        for (const auto& other : near_groups) {
          for (unsigned bits = other.balls.row(i); bits != 0; bits &= bits - 1) {
            const std::int32_t s = other.number * G + __builtin_ctz(bits);
            const Segment& segment = surface.segments()[s];
            if (!may_touch(own_slave, segment, least)) continue;
            if (pairs != nullptr &&
                !pairs->node_and_face(own_slave.node, segment.slot, segment.face, segment.node).may) {
              continue;
            }
            list.push_back(s);
          }
        }
        start_[slave + 1] = list.size() - before;
      }
    }
  });
  for (std::size_t i = 0; i + 1 < start_.size(); ++i) start_[i + 1] += start_[i];
  candidate_.clear();
  candidate_.reserve(start_.back());
  for (const std::vector<std::int32_t>& list : found) candidate_.insert(candidate_.end(), list.begin(), list.end());
}

template <class S>
void SlidelineSearch<S>::persist(StateArchive& archive, const SegmentSurface<S>& surface, std::int32_t node_count) {
  archive(valid_, watched_, start_, candidate_);
  clock_.persist(archive);
  motion_.persist(archive, node_count, valid_ || watched_);
  if (!archive.reads() || !valid_) return;
  archive.require(start_.size() == surface.slaves().size() + 1 && start_.front() == 0);
  archive.require(std::is_sorted(start_.begin(), start_.end()));
  archive.require(start_.back() == std::ssize(candidate_));
  archive.require_all(candidate_, 0, surface.segments().size());
}

template <class S>
std::size_t SlidelineSearch<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return joined_.bytes() + of(reference_node_) + of(reference_centre_) + of(start_) + of(candidate_) + motion_.bytes() +
         segments_.bytes() + slaves_.bytes() + boxes_.bytes();
}

template class SlidelineSearch<double>;
template class SlidelineSearch<float>;

}  // namespace pinball

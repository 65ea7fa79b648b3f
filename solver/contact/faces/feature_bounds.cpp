#include "feature_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>

#include <kernels/exec.hpp>
#include <kernels/gather.hpp>
#include <solver/base/lists_in_order.hpp>

namespace pinball {

namespace {

static_assert(near_gap > open_gap && 2 * near_gap >= deepest_edges);

template <class S>
void widen(MovingBox<S>& box, S by) {
  for (int k = 0; k < 12; ++k) box.bound[k] += k % 6 < 3 ? -by : by;
}

template <class S>
constexpr Facing<S> any_direction{{S(0), S(0), S(0)}, S(2)};

/// By how many allowances corners may stray before it matters to where a face looks: so that those that stray once need
/// not be looked for with all that is around them.
template <class S>
constexpr S strays_ahead = 4;

/// A bound of the box that nothing is in.
template <class T>
T number_of_nothing(int bound) {
  return number<T>(bound % 6 < 3 ? HUGE_VAL : -HUGE_VAL);
}

RangePolicy<> all_of(std::int64_t count) { return {0, count}; }

/// Segments, each once, in the order in which they come.
class SegmentsOfGroup {
 public:
  void clear() {
    // The last first: each is found past those that came before it.
    for (; !all_.empty(); all_.pop_back()) table_[place_of(all_.back())] = none;
  }
  void add(std::int32_t segment) {
    std::int32_t& place = table_[place_of(segment)];
    if (place == segment) return;
    place = segment;
    all_.push_back(segment);
    if (2 * all_.size() > table_.size()) grow();
  }
  std::span<const std::int32_t> all() const { return all_; }

 private:
  static constexpr std::int32_t none = -1;
  /// Where a segment is, or would go.
  std::size_t place_of(std::int32_t segment) const {
    std::size_t place = static_cast<std::size_t>(segment) & (table_.size() - 1);
    while (table_[place] != none && table_[place] != segment) place = (place + 1) & (table_.size() - 1);
    return place;
  }
  void grow() {
    table_.assign(2 * table_.size(), none);
    for (const std::int32_t s : all_) table_[place_of(s)] = s;
  }

  std::vector<std::int32_t> all_;
  std::vector<std::int32_t> table_ = std::vector<std::int32_t>(512, none);  ///< of a power of two, half empty at least
};

}  // namespace

template <class S>
MovingBox<S> FeatureBounds<S>::box_of(const Vec3<S>& x, const Vec3<S>& v, std::int32_t node) const {
  const Vec3<S> begin = x - last_step_ * v, end = x + horizon_ * v;
  const S stray = motion_->allowance(std::array{node}) + leap_;
  return {{begin.x - stray, begin.y - stray, begin.z - stray, begin.x + stray, begin.y + stray, begin.z + stray,
           end.x - stray, end.y - stray, end.z - stray, end.x + stray, end.y + stray, end.z + stray}};
}

template <class S>
void FeatureBounds<S>::update(const NodeRecords<S>& nodes, const SegmentSurface<S>& surface,
                              const SphereSurface<S>& spheres, const SurfaceMotion<S>& motion,
                              const ListScope<S>& scope) {
  motion_ = &motion;
  last_step_ = scope.last_step;
  leap_ = scope.leap;
  // What has closed within the step just made is found, and what closes within the step after the horizon.
  horizon_ = scope.horizon + 2 * last_step_;
  const std::int32_t segments = surface.segments().size();
  node_box_.renew(surface.slaves().size());
  facing_.renew(surface.segments().size());
  angle_on_way_.renew(surface.segments().size());
  boxes_.reset(segments + spheres.count());
  if (order_.empty()) {
    bound_segments(nodes, surface, scope, false);
    choose_order(surface);
  }
  bound_segments(nodes, surface, scope, true);
  find_directions(surface);
  parallel_for("boxes of nodes", all_of(node_box_.size()), [&](std::int64_t i) {
    const std::int32_t node = surface.slaves()[i].node;
    node_box_[i] = box_of(vector_of(nodes.x(node)), vector_of(nodes.v(node)), node);
    widen(node_box_[i], static_cast<S>(scope.depth[i]));
  });
  parallel_for("boxes of spheres", all_of(spheres.spheres().size()), [&](std::int64_t i) {
    const auto& sphere = spheres.spheres()[i];
    MovingBox<S> box = box_of(vector_of(nodes.x(sphere.node)), vector_of(nodes.v(sphere.node)), sphere.node);
    widen(box, S(1.01) * sphere.radius);
    boxes_.set(segments + static_cast<std::int32_t>(i), box);
  });
}

template <class S>
void FeatureBounds<S>::bound_segments(const NodeRecords<S>& nodes, const SegmentSurface<S>& surface,
                                      const ListScope<S>& scope, bool with_boxes) {
  using T = Pack<S, native_width<S>>;
  constexpr int W = width_of<T>;
  const std::int64_t segments = std::ssize(surface.segments());
  parallel_for("bounds of segments", all_of((segments + W - 1) / W), [&](std::int64_t pack) {
    std::int32_t number[W];
    alignas(64) std::int32_t node[4][W];
    alignas(64) S allowed[4][W], reach[4][W], wider[W], is_active[W];
    const int count = static_cast<int>(std::min<std::int64_t>(W, segments - pack * W));
    for (int i = 0; i < W; ++i) {  // padding repeats the last segment
      const std::int64_t place = pack * W + std::min(i, count - 1);
      number[i] = order_.empty() ? static_cast<std::int32_t>(place) : order_[place];
      const auto& segment = surface.segments()[number[i]];
      const auto& slaves = surface.slaves_of(number[i]);
      for (std::size_t k = 0; k < 4; ++k) {
        node[k][i] = segment.node[k];
        allowed[k][i] = motion_->allowance(std::array{segment.node[k]});
        reach[k][i] = allowed[k][i] + leap_ + static_cast<S>(scope.depth[slaves[k]]);
      }
      wider[i] = static_cast<S>(near_gap) * segment.size;
      is_active[i] = i < count && surface.active_segment(number[i]) ? S(1) : S(0);
    }
    Vec3<T> x[4], v[4];
    T allowance[4];
    for (int k = 0; k < 4; ++k) {
      x[k] = gather_vectors<T>(nodes.position, node[k]);
      v[k] = gather_vectors<T>(nodes.velocity, node[k]);
      allowance[k] = load<T>(allowed[k]);
    }
    T on_way;
    const Facing<T> facing = facing_of(x, v, allowance, strays_ahead<S>, &on_way);
    for (int i = 0; i < count; ++i) {
      angle_on_way_[number[i]] = lane(on_way, i);
      facing_[number[i]] = {{lane(facing.normal.x, i), lane(facing.normal.y, i), lane(facing.normal.z, i)},
                            lane(facing.angle, i)};
    }
    if (!with_boxes) return;
    T bound[12];
    for (int c = 0; c < 12; ++c) bound[c] = number_of_nothing<T>(c);
    for (int k = 0; k < 4; ++k) {
      const T by = load<T>(reach[k]);
      for (int end = 0; end < 2; ++end) {
        const Vec3<T> at = x[k] + T(end == 0 ? -last_step_ : horizon_) * v[k];
        const T along[3] = {at.x, at.y, at.z};
        for (int axis = 0; axis < 3; ++axis) {
          T &low = bound[6 * end + axis], &high = bound[6 * end + 3 + axis];
          low = minimum(low, along[axis] - by);
          high = maximum(high, along[axis] + by);
        }
      }
    }
    const T by = load<T>(wider);
    const auto active = load<T>(is_active) > T(0);
    for (int c = 0; c < 12; ++c) {
      bound[c] = select(active, c % 6 < 3 ? bound[c] - by : bound[c] + by, number_of_nothing<T>(c));
    }
    boxes_.set_pack(pack * W, bound);
  });
}

/// Within a group of groups by body and by the axis that segments look along, those that are not active last: so that
/// the groups of a surface look one way, and those on the two sides of a plate, or behind elements that may soon erode,
/// are not of the same ones.
template <class S>
void FeatureBounds<S>::choose_order(const SegmentSurface<S>& surface) {
  constexpr std::size_t part = ball_group<S> * ball_group<S>;
  const std::size_t segments = surface.segments().size();
  const auto way_of = [&](std::int32_t segment) {
    if (!surface.active_segment(segment)) return 6;
    const Vec3<S>& n = facing_[segment].normal;
    const S along[3] = {n.x, n.y, n.z};
    int axis = absolute(n.x) < absolute(n.y) ? 1 : 0;
    if (absolute(along[axis]) < absolute(n.z)) axis = 2;
    return 2 * axis + (along[axis] < S(0) ? 1 : 0);
  };
  struct Key {
    std::int32_t body, way, segment;
    auto operator<=>(const Key&) const = default;
  };
  std::vector<Key> keys(segments);
  order_.resize(segments);
  place_.resize(segments);
  parallel_for("order of segments", all_of((segments + part - 1) / part), [&](std::int64_t number) {
    const std::size_t begin = number * part, end = std::min(segments, begin + part);
    for (std::size_t s = begin; s < end; ++s) {
      const std::int32_t segment = s;
      keys[s] = {surface.segments()[s].body, way_of(segment), segment};
    }
    std::sort(keys.begin() + begin, keys.begin() + end);
    for (std::size_t place = begin; place < end; ++place) {
      order_[place] = keys[place].segment;
      place_[order_[place]] = place;
    }
  });
  find_around(surface);
}

/// Segments around the nodes of each group, each once, in the order in which they are come across.
template <class S>
void FeatureBounds<S>::find_around(const SegmentSurface<S>& surface) {
  constexpr std::int64_t G = ball_group<S>;
  const std::int64_t segments = std::ssize(order_), groups = (segments + G - 1) / G;
  std::array<std::vector<std::int32_t>, fixed_pieces> found;
  around_begin_.assign(groups, 0);
  parallel_for("segments around groups", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    SegmentsOfGroup of_group;
    const std::int64_t end = groups * (piece + 1) / fixed_pieces;
    for (std::int64_t group = groups * piece / fixed_pieces; group < end; ++group) {
      of_group.clear();
      for (std::int64_t place = group * G; place < std::min(segments, (group + 1) * G); ++place) {
        for (const std::int32_t slave : surface.slaves_of(order_[place])) {
          for (const std::int32_t s : surface.around(slave)) of_group.add(s);
        }
      }
      around_begin_[group] = std::ssize(of_group.all());
      found[piece].insert(found[piece].end(), of_group.all().begin(), of_group.all().end());
    }
  });
  const std::int64_t whole = make_offsets(around_begin_);
  around_begin_.push_back(whole);
  around_.resize(whole);
  parallel_for("copies around groups", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    std::copy(found[piece].begin(), found[piece].end(), around_.begin() + around_begin_[groups * piece / fixed_pieces]);
  });
}

template <class S>
void FeatureBounds<S>::find_directions(const SegmentSurface<S>& surface) {
  constexpr std::int64_t G = ball_group<S>;
  const std::int64_t segments = order_.size();
  directions_.reset(boxes_.groups());
  parallel_for("directions of groups", all_of(boxes_.groups()), [&](std::int64_t group) {
    const std::int64_t end = std::min(segments, (group + 1) * G);
    const bool has_spheres = (group + 1) * G > segments;
    const bool is_active = std::any_of(order_.begin() + std::min(end, group * G), order_.begin() + end,
                                       [&](std::int32_t s) { return surface.active_segment(s); });
    if (has_spheres) {
      directions_.set(group, {S(0), S(0), S(0)}, S(HUGE_VAL));
    } else if (!is_active) {
      directions_.set(group, {S(0), S(0), S(0)}, S(-8));  // but for spheres
    } else {
      const Facing<S> all = facing_of_all({&around_[around_begin_[group]], &around_[around_begin_[group + 1]]});
      directions_.set(group, all.normal, all.angle + S(0.5) * static_cast<S>(most_facing));
    }
  });
}

template <class S>
MovingBox<S> FeatureBounds<S>::edge_box(const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                                        std::int32_t edge) const {
  const auto& slaves = edges.edges()[edge].slave;
  MovingBox<S> box = node_box_[slaves[0]];
  include_box(box, node_box_[slaves[1]]);
  widen(box, static_cast<S>(near_gap) * size_at_edge(surface, edges, edge));
  return box;
}

template <class S>
void FeatureBounds<S>::move(const SegmentSurface<S>& surface, std::span<const std::int32_t> slaves,
                            const ListScope<S>& scope) {
  for (const std::int32_t slave : slaves) {
    node_box_[slave] =
        box_of(motion_->start_position(slave), motion_->start_velocity(slave), surface.slaves()[slave].node);
    widen(node_box_[slave], static_cast<S>(scope.depth[slave]));
  }
}

template <class S>
bool FeatureBounds<S>::turn(const SegmentSurface<S>& surface, std::int32_t segment) {
  const std::array<std::int32_t, 4>& corners = surface.slaves_of(segment);
  Vec3<S> x[4], v[4];
  S allowance[4];
  for (std::size_t k = 0; k < 4; ++k) {
    x[k] = motion_->start_position(corners[k]);
    v[k] = motion_->start_velocity(corners[k]);
    allowance[k] = motion_->allowance(std::array{surface.segments()[segment].node[k]});
  }
  Facing<S>& known = facing_[segment];
  const Facing<S> now = facing_of(x, v, allowance, S(1));
  const Vec3<S> d = now.normal - known.normal;
  const bool any_known = known.angle == any_direction<S>.angle, any_now = now.angle == any_direction<S>.angle;
  // A chord of up to a right angle, as in facing_of_all().
  if (any_known || (!any_now && S(1.12) * square_root(dot(d, d)) + now.angle <= known.angle)) return false;
  known = facing_of(x, v, allowance, strays_ahead<S>);
  return true;
}

template <class S>
void FeatureBounds<S>::renew_box(const SegmentSurface<S>& surface, std::int32_t segment) {
  MovingBox<S> box = empty_box<S>();
  for (const std::int32_t slave : surface.slaves_of(segment)) include_box(box, node_box_[slave]);
  widen(box, static_cast<S>(near_gap) * surface.segments()[segment].size);
  boxes_.set(place_[segment], box);
}

/// The diagonals span the face; each of their ends may go the way that it makes more than their mean, and stray.
template <class S>
template <class T>
Facing<T> FeatureBounds<S>::facing_of(const Vec3<T> (&x)[4], const Vec3<T> (&v)[4], const T (&allowance)[4], S strays,
                                      T* angle_on_way) const {
  Vec3<T> diagonal[2];
  T length[2], turned(0), turned_on_way(0);
  for (int d = 0; d < 2; ++d) {
    diagonal[d] = x[d + 2] - x[d];
    length[d] = square_root(dot(diagonal[d], diagonal[d]));
    const Vec3<T> apart = v[d + 2] - v[d];
    const T made = T(horizon_) * square_root(dot(apart, apart)), stray = allowance[d] + allowance[d + 2];
    turned = turned + (made + T(strays) * stray) / length[d];
    if (angle_on_way != nullptr) turned_on_way = turned_on_way + (made + stray) / length[d];
  }
  const Vec3<T> area = cross(diagonal[0], diagonal[1]);
  const T inverse = T(1) / square_root(dot(area, area));
  const auto angle_of = [&](const T& way) {  // the arcus sine of up to 0.8
    return number<T>(1.2) * way * (length[0] * length[1]) * inverse;
  };
  const T angle = angle_of(turned);
  if (angle_on_way != nullptr) *angle_on_way = angle_of(turned_on_way);
  // if (it is larger, or there is no area) any direction
  const auto known = angle < number<T>(0.96);
  const auto along = [&](const T& component) { return select(known, inverse * component, T(0)); };
  return {{along(area.x), along(area.y), along(area.z)}, select(known, angle, T(any_direction<S>.angle))};
}

template <class S>
Facing<S> FeatureBounds<S>::facing_of_all(std::span<const std::int32_t> segments) const {
  Vec3<S> sum{S(0), S(0), S(0)};
  for (const std::int32_t s : segments) sum = sum + facing_[s].normal;
  const S length = square_root(dot(sum, sum));
  Facing<S> all{(length > S(0) ? 1 / length : S(0)) * sum, S(0)};
  for (const std::int32_t s : segments) {
    const Vec3<S> d = facing_[s].normal - all.normal;
    const S chord2 = dot(d, d);
    if (!(length > S(0)) || !(chord2 < S(2))) return any_direction<S>;
    all.angle = maximum(all.angle, S(1.12) * square_root(chord2) + facing_[s].angle);  // up to a right angle
  }
  return all;
}

template <class S>
std::size_t FeatureBounds<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return boxes_.bytes() + node_box_.bytes() + facing_.bytes() + angle_on_way_.bytes() + of(order_) + of(place_) +
         of(around_) + of(around_begin_) + directions_.bytes();
}

template class FeatureBounds<double>;
template class FeatureBounds<float>;

}  // namespace pinball

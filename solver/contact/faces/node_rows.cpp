#include "node_rows.hpp"

#include <algorithm>
#include <cmath>

#include <kernels/compress.hpp>
#include <kernels/exec.hpp>
#include <kernels/gather.hpp>

namespace pinball {

namespace {

/// How far beyond an edge a foot may lie and still belong to the face [-].
constexpr double edge_margin = 1e-3;

/// How deep a node may be below both faces of a valley and still belong to them although its feet lie beyond the edge
/// between them, over the radius of the segment.
constexpr double valley = 0.05;

/// Weight of a node of a face from which on a node is as good as on it [-].
constexpr double on_a_node = 0.9;

/// Whether all of the surface around a node rises from it, seen along a normal: a sharp corner may touch although none
/// of its faces looks at the other body within 60 degrees.
template <class S>
bool is_lowest(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, std::int32_t slave,
               const Vec3<double>& normal, const Vec3<double>& facing) {
  const Vec3<double> own = double_vector_of(source.x(surface.slaves()[slave].node));
  double least = 1;  // cosine
  for (const std::int32_t s : surface.around(static_cast<std::size_t>(slave))) {
    if (!surface.active_segment(s)) continue;
    least = std::min(least, dot(double_vector_of(record(surface.plane().data(), s)), facing));
    for (const std::int32_t node : surface.segments()[s].node) {
      const Vec3<double> to = double_vector_of(source.x(node)) - own;
      const double height = dot(to, normal);
      if (height < 0 && height * height > 1e-3 * dot(to, to)) return false;
    }
  }
  return least < most_facing;
}

/// Whether a face belongs to an element that has a corner in common with one at a node: these are kept apart by the
/// mesh.
template <class S>
bool is_beside(const SegmentSurface<S>& surface, std::int32_t slave, std::int32_t segment) {
  if (surface.slaves()[slave].body != surface.segments()[segment].body) return false;
  const auto around = surface.around(static_cast<std::size_t>(slave));
  return std::any_of(around.begin(), around.end(), [&](std::int32_t own) {
    return surface.active_segment(own) && surface.share_corner(own, segment);
  });
}

}  // namespace

/// Pairs of which the node is near the ball and the plane of the segment.
template <class S>
void NodeRows<S>::find_near(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const NodePairs& pairs,
                            std::int64_t piece, const StepReach& step, Work& work) {
  using T = Pack<S, native_width<S>>;
  constexpr int W = width_of<T>;
  const std::int64_t begin = pairs.pieces.begin[piece], end = pairs.pieces.end[piece];
  work.near.resize(static_cast<std::size_t>(end - begin + 2 * W));
  std::int32_t* near = work.near.data();
  for (std::int64_t place = begin; place < end; place += W) {
    T within = number<T>(near_gap) * load<T>(pairs.size.data() + place) + number<T>(step.approach);
    if (step.some_deep) {
      alignas(64) S deep[W];
      for (int i = 0; i < W; ++i) deep[i] = static_cast<S>(step.depth[pairs.node[place + i]]);
      within = within + load<T>(deep);
    }
    const Vec3<T> x = gather_vectors<T>(source.position, pairs.node.data() + place);
    Vec3<T> centre, normal;
    T ball, warp;
    gather_records(surface.sphere().data(), pairs.segment.data() + place, centre.x, centre.y, centre.z, ball);
    gather_records(surface.plane().data(), pairs.segment.data() + place, normal.x, normal.y, normal.z, warp);
    const Vec3<T> d = x - centre;
    const T height = dot(d, normal);
    const T beside =
        ball + within -
        SegmentSurface<S>::deepest *
            load<T>(pairs.radius.data() + place);  // the distance of the farthest corner, and what counts as near
    unsigned bits =
        lane_bits<T>(ball > T(0) && dot(d, d) - height * height < beside * beside && absolute(height) < within + warp);
    if (place + W > end) bits &= (1U << (end - place)) - 1;
    near += write_numbers<W>(bits, static_cast<std::int32_t>(place), near);
  }
  work.near.resize(static_cast<std::size_t>(near - work.near.data()));
}

template <class S>
void NodeRows<S>::find_feet(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const NodePairs& pairs,
                            Work& work) {
  using T = Pack<double, native_width<double>>;
  constexpr int W = width_of<T>;
  work.feet.clear();
  for (std::size_t first = 0; first < work.near.size(); first += W) {
    const int count = static_cast<int>(std::min<std::size_t>(W, work.near.size() - first));
    alignas(64) double coordinate[5][3][W];
    for (int i = 0; i < W; ++i) {
      const std::int32_t place = work.near[first + static_cast<std::size_t>(std::min(i, count - 1))];
      const auto& segment = surface.segments()[pairs.segment[place]];
      for (int k = 0; k < 5; ++k) {
        const S* x = source.x(k < 4 ? segment.node[k] : pairs.node[place]);
        for (int c = 0; c < 3; ++c) coordinate[k][c][i] = static_cast<double>(x[c]);
      }
    }
    const auto point = [&](int k) {
      return Vec3<T>{load<T>(coordinate[k][0]), load<T>(coordinate[k][1]), load<T>(coordinate[k][2])};
    };
    const Vec3<T> corner[4] = {point(0), point(1), point(2), point(3)};
    const FaceProjection<T> at = foot_on_face(corner, point(4), edge_margin);
    for (int i = 0; i < count; ++i) {
      const std::int32_t place = work.near[first + static_cast<std::size_t>(i)];
      Foot foot{pairs.slave[place],
                pairs.segment[place],
                lane(at.gap, i),
                lane(at.outside, i),
                {lane(at.normal.x, i), lane(at.normal.y, i), lane(at.normal.z, i)},
                {lane(at.weight[0], i), lane(at.weight[1], i), lane(at.weight[2], i), lane(at.weight[3], i)}};
      if (!(foot.outside < INFINITY)) {  // a face that is much out of its plane
        Vec3<double> x[4];
        for (int k = 0; k < 4; ++k) x[k] = {coordinate[k][0][i], coordinate[k][1][i], coordinate[k][2][i]};
        const FaceProjection<double> one =
            project_onto_face(x, Vec3<double>{coordinate[4][0][i], coordinate[4][1][i], coordinate[4][2][i]}, 0.0, 0.0);
        foot.gap = one.gap;
        foot.outside = one.outside;
        foot.normal = one.normal;
        for (int k = 0; k < 4; ++k) foot.weight[k] = one.weight[k];
        if (!(foot.outside < INFINITY)) continue;
      }
      work.feet.push_back(foot);
    }
  }
}

template <class S>
void NodeRows<S>::add_rows(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const StepReach& step,
                           const Foot* begin, const Foot* end, std::vector<FeatureRow>& rows) {
  const auto slave_number = begin->slave;
  const auto& slave = surface.slaves()[slave_number];
  if (!surface.active(static_cast<std::size_t>(slave_number))) return;
  const Vec3<double> v = double_vector_of(source.v(slave.node));
  const auto depth_before = static_cast<double>(step.depth[slave.node]);
  const auto closing = [&](const Foot& foot) {  // within a step
    Vec3<double> u = (-1.0) * v;
    for (int k = 0; k < 4; ++k) {
      u = u + foot.weight[k] * double_vector_of(source.v(surface.segments()[foot.segment].node[k]));
    }
    return step.dt * dot(u, foot.normal);
  };
  const auto size_of = [&](const Foot& foot) { return static_cast<double>(surface.segments()[foot.segment].size); };
  // A foot beyond an edge belongs to the face on its side of the corner; inside, that is at the bottom of a valley, and
  // not beside another face.
  const auto belongs = [&](const Foot& foot) {
    const auto radius = static_cast<double>(surface.segments()[foot.segment].radius);
    if (foot.outside <= edge_margin * radius) return true;
    if (foot.gap > 0) {
      return foot.outside <= std::min(foot.gap, open_gap * static_cast<double>(surface.segments()[foot.segment].size));
    }
    if (foot.outside > std::min(0 - foot.gap, valley * radius)) return false;
    return std::none_of(begin, end, [&](const Foot& other) {
      return other.gap > 0 && other.gap < foot.outside - foot.gap && other.outside <= edge_margin * radius &&
             surface.segments()[other.segment].body == surface.segments()[foot.segment].body;
    });
  };
  const auto looks = [&](const Foot& foot) {
    if (!may_touch(foot.gap, closing(foot), size_of(foot), depth_before)) return false;
    const Vec3<S> n{static_cast<S>(foot.normal.x), static_cast<S>(foot.normal.y), static_cast<S>(foot.normal.z)};
    return (surface.faces(static_cast<std::size_t>(slave_number), n) ||
            is_lowest(source, surface, slave_number, foot.normal,
                      double_vector_of(record(surface.plane().data(), foot.segment)))) &&
           !is_beside(surface, slave_number, foot.segment);
  };
  const auto distance_of = [](const Foot& foot) {
    return std::sqrt(foot.gap * foot.gap + foot.outside * foot.outside);
  };
  const auto round_off = [&](const Foot& foot) {
    return 1e-6 * static_cast<double>(surface.segments()[foot.segment].radius);
  };
  // Right on an edge or a node the faces that meet there are as near: their mean, so that none is preferred.
  const auto mean_normal = [&](const Foot& foot) {
    Vec3<double> sum = foot.normal;
    for (const Foot* other = begin; other < end; ++other) {
      const bool as_near = other != &foot && std::abs(distance_of(*other) - distance_of(foot)) < round_off(foot) &&
                           other->outside < round_off(foot) && dot(other->normal, foot.normal) > 0.7 &&
                           surface.segments()[other->segment].body == surface.segments()[foot.segment].body;
      if (as_near) sum = sum + other->normal;
    }
    return (1 / std::sqrt(dot(sum, sum))) * sum;
  };
  const auto add = [&](const Foot& foot, std::int64_t name) {
    const auto& segment = surface.segments()[foot.segment];
    if (!may_close(foot.gap, closing(foot), size_of(foot))) return;
    FeatureRow& row = rows.emplace_back();
    row.first = slave.node;
    row.slave = slave_number;
    row.second = name;
    row.direction = mean_normal(foot);
    row.depth = 0 - foot.gap;
    row.size = static_cast<double>(slave.radius + segment.radius);
    row.reach = size_of(foot);
    row.add_node(slave.node, -1);
    row.add_side(segment.node, foot.weight, 1);
  };
  // One body after the other, by number: there are few.
  for (std::int32_t body = -1;;) {
    std::int32_t next = body;
    for (const Foot* foot = begin; foot < end; ++foot) {
      const std::int32_t of = surface.segments()[foot->segment].body;
      if (of > body && (next == body || of < next)) next = of;
    }
    if (next == body) return;
    body = next;
    const Foot* best = nullptr;
    double nearest = INFINITY;
    for (const Foot* foot = begin; foot < end; ++foot) {
      if (surface.segments()[foot->segment].body != body || !looks(*foot)) continue;
      const double distance = distance_of(*foot);
      // Two faces that meet in the nearest point are as near: then the one that the node is more in front of.
      const double same = round_off(*foot);
      const bool better =
          best == nullptr || distance < nearest - same || (distance < nearest + same && foot->gap > best->gap + same);
      if (!better) continue;
      nearest = distance;
      best = foot;
    }
    if (best == nullptr || !belongs(*best)) continue;
    add(*best, -1 - 2 * static_cast<std::int64_t>(body));
    for (const Foot* foot = begin; foot < end; ++foot) {  // a valley
      const double least = edge_margin * static_cast<double>(surface.segments()[foot->segment].radius);
      if (foot == best || surface.segments()[foot->segment].body != body || dot(foot->normal, best->normal) > 0.7 ||
          foot->gap < -least || best->gap < -least || foot->outside > least || !looks(*foot)) {
        continue;
      }
      add(*foot, -2 - 2 * static_cast<std::int64_t>(body));
      break;
    }
  }
}

template <class S>
void NodeRows<S>::find(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const NodePairs& pairs,
                       const StepReach& step) {
  pieces_ = pairs.pieces.count;
  parallel_for("node rows", RangePolicy<>{0, pairs.pieces.count}, [&](std::int64_t piece) {
    Work& work = work_[piece];
    work.rows.clear();
    find_near(source, surface, pairs, piece, step, work);
    find_feet(source, surface, pairs, work);
    for (std::size_t i = 0; i < work.feet.size();) {
      std::size_t end = i;
      while (end < work.feet.size() && work.feet[end].slave == work.feet[i].slave) ++end;
      add_rows(source, surface, step, work.feet.data() + i, work.feet.data() + end, work.rows);
      i = end;
    }
  });
  drop_mirrored(source, surface);
}

template <class S>
void NodeRows<S>::drop_mirrored(const SurfaceSource<S>& source, const SegmentSurface<S>& surface) {
  on_node_.resize(static_cast<std::size_t>(source.node_count), nullptr);
  // A node of the face that the row's node is as good as on; negative: none.
  const auto met_by = [](const FeatureRow& row) {
    for (int k = 1; k < row.nodes; ++k) {
      if (row.weight[k] > on_a_node) return row.node[k];
    }
    return -1;
  };
  const auto for_each = [this](const auto& visit) {
    for (std::int64_t piece = 0; piece < pieces_; ++piece) {
      for (FeatureRow& row : work_[piece].rows) visit(row);
    }
  };
  const auto is_corner = [&](const FeatureRow& row) {
    return is_lowest(source, surface, row.slave, row.direction, row.direction);
  };
  for_each([&](FeatureRow& row) {
    if (met_by(row) >= 0) on_node_[row.node[0]] = &row;
  });
  for_each([&](FeatureRow& row) {
    const std::int32_t met = met_by(row);
    const FeatureRow* const other = met >= 0 ? on_node_[met] : nullptr;
    if (other == nullptr || met_by(*other) != row.node[0]) return;
    if (dot(row.direction, other->direction) < -0.99) {
      if (row.nodes > 2 || other->nodes > 2 || row.node[0] < met) return;
      // Right on each other: the mean of both, so that none is preferred.
      FeatureRow& kept = *on_node_[met];
      const Vec3<double> mean = kept.direction - row.direction;
      kept.direction = (1 / std::sqrt(dot(mean, mean))) * mean;
      kept.depth = 0.5 * (kept.depth + row.depth);
      row.dropped = true;
    } else {  // where one of them is a corner, the other's face is the one that they meet at
      const bool corner = is_corner(row), corner_met = is_corner(*other);
      row.dropped = corner != corner_met ? corner_met : row.nodes == 2 && row.node[0] > met;
    }
  });
  for_each([this](FeatureRow& row) { on_node_[row.node[0]] = nullptr; });
  for (std::int64_t piece = 0; piece < pieces_; ++piece) {
    std::erase_if(work_[piece].rows, [](const FeatureRow& row) { return row.dropped; });
  }
}

template <class S>
void NodeRows<S>::give_to(ImpulseSolver<S>& impulses) const {
  for_each_row([&](const FeatureRow& row) { row.give_to(impulses); });
}

template <class S>
std::size_t NodeRows<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  std::size_t sum = 0;
  for (const Work& work : work_) sum += of(work.near) + of(work.feet) + of(work.rows);
  sum += of(on_node_);
  return sum;
}

template class NodeRows<double>;
template class NodeRows<float>;

}  // namespace pinball

#include "node_rows.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <kernels/face_projection.hpp>

namespace pinball {

namespace {

/// How deep a node may be below both faces of a valley and still belong to them although its feet lie beyond the edge
/// between them, over the radius of the segment.
constexpr double valley = 0.05;

/// Cosine between the normals of faces that are not one surface to a node on both.
constexpr double other_side = 0.7;

/// Difference of distances that is nothing but round-off, over the radius of the segments around a node.
constexpr double round_off = 1e-6;

/// Distance from the rim of a face, over the size of the segment, up to which a node is pushed along the normals of the
/// faces there and not along the line from the rim, which is none for what touches [-].
constexpr double near_rim = 0.005;

/// Least cosine between the normal of a face and the direction in which a node is pushed from it [-].
constexpr double least_rise = 0.05;

/// Way between the lines that the two forces of a row act along, over the radius of the segment, that is nothing but
/// round-off [-].
constexpr double no_moment = 1e-13;

/// Weight of a node of a face from which on a node is as good as on it [-].
constexpr double on_a_node = 0.9;
/// And from which on both are right on each other [-].
constexpr double right_on_a_node = 0.999;

/// Whether a face around a node may come to look at another. facing: mean unit normal of that.
template <class S>
bool may_face(const SegmentSurface<S>& surface, std::int32_t slave, const Vec3<double>& facing) {
  const auto around = surface.around(slave);
  return std::any_of(around.begin(), around.end(), [&](std::int32_t s) {
    return surface.active_segment(s) && dot(double_vector_of(record(surface.plane().data(), s)), facing) < most_facing;
  });
}

/// Whether all lists have a node and a face: others, whose faces look the same way, or which the mesh keeps apart, are
/// in some lists by chance.
template <class S>
bool counts(const SegmentSurface<S>& surface, const ListedNodes<S>& pairs, std::int32_t place) {
  const std::int32_t slave = pairs.first[place], segment = pairs.second[place];
  return surface.active(slave) && may_face(surface, slave, double_vector_of(record(surface.plane().data(), segment))) &&
         (pairs.apart[place] != 0 || !surface.beside(surface.around(slave), std::span(&segment, 1)));
}

/// Whether all of the surface around a node rises from it, seen along a normal: a sharp corner may touch although none
/// of its faces looks at the other body within 60 degrees.
template <class S>
bool is_lowest(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, std::int32_t slave,
               const Vec3<double>& normal) {
  const Vec3<double> own = double_vector_of(source.x(surface.slaves()[slave].node));
  for (const std::int32_t s : surface.around(slave)) {
    if (!surface.active_segment(s)) continue;
    for (const std::int32_t node : surface.segments()[s].node) {
      const Vec3<double> to = double_vector_of(source.x(node)) - own;
      const double height = dot(to, normal);
      if (height < 0 && height * height > 1e-3 * dot(to, to)) return false;
    }
  }
  return true;
}

/// A node and its feet in a step, on faces that all lists have with it.
template <class S>
class NodeMeeting {
 public:
  NodeMeeting(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const StepReach& step,
              std::span<const NodeFoot> feet)
      : source_(source),
        surface_(surface),
        step_(step),
        feet_(feet),
        slave_(surface.slaves()[feet.front().slave]),
        velocity_(double_vector_of(source.v(slave_.node))) {}

  /// Adds the rows of the node: of one body after the other, by number.
  void add_rows(std::vector<FeatureRow>& rows) const {
    if (std::ranges::none_of(feet_, [&](const NodeFoot& foot) { return may_have_row(foot); })) return;
    for (std::int32_t body = next_body(-1); body >= 0; body = next_body(body)) add_rows_with(body, rows);
  }

 private:
  const typename SegmentSurface<S>::Segment& segment_of(const NodeFoot& foot) const {
    return surface_.segments()[foot.segment];
  }
  double radius_of(const NodeFoot& foot) const { return segment_of(foot).radius; }
  double size_of(const NodeFoot& foot) const { return segment_of(foot).size; }
  /// Difference of distances that is nothing but round-off [length].
  double as_near() const { return round_off * slave_.radius; }

  /// Whether a foot is on the face or hardly beyond its edges.
  bool is_on_face(const NodeFoot& foot) const { return foot.past_margin <= edge_margin * radius_of(foot); }

  bool may_have_row(const NodeFoot& foot) const {
    return may_close(foot.gap, closing(foot), step_.leap, size_of(foot));
  }

  /// The least body above this one that the node has a foot on; negative: none.
  std::int32_t next_body(std::int32_t body) const {
    std::int32_t next = -1;
    for (const NodeFoot& foot : feet_) {
      const std::int32_t of = segment_of(foot).body;
      if (of > body && (next < 0 || of < next)) next = of;
    }
    return next;
  }

  /// What closes in a step [length].
  double closing(const NodeFoot& foot) const {
    Vec3<double> v = (-1.0) * velocity_;
    for (int k = 0; k < 4; ++k) v = v + foot.weight[k] * double_vector_of(source_.v(segment_of(foot).node[k]));
    return step_.dt * dot(v, foot.normal);
  }

  /// Whether node and face may touch: near each other, and looking at each other.
  bool looks(const NodeFoot& foot) const {
    const double depth_before = step_.depth[slave_.node];
    if (!may_touch(foot.gap, closing(foot), step_.leap, size_of(foot), depth_before)) return false;
    const Vec3<S> normal{static_cast<S>(foot.normal.x), static_cast<S>(foot.normal.y), static_cast<S>(foot.normal.z)};
    return surface_.faces(foot.slave, normal) || is_lowest(source_, surface_, foot.slave, foot.normal);
  }

  /// A foot beyond an edge belongs to the face on its side of the corner; inside, that is at the bottom of a valley,
  /// and not beside another face.
  bool belongs(const NodeFoot& foot) const {
    if (is_on_face(foot)) return true;
    if (foot.gap > 0) {
      return foot.outside <= open_gap * size_of(foot) && (foot.past_margin <= foot.gap || is_before_sharp_edge(foot));
    }
    if (foot.outside > std::min(0 - foot.gap, valley * radius_of(foot))) return false;
    return std::none_of(feet_.begin(), feet_.end(), [&](const NodeFoot& other) {
      return other.gap > 0 && other.gap < foot.outside - foot.gap && is_on_face(other) &&
             segment_of(other).body == segment_of(foot).body;
    });
  }

  /// The nearest face of a body that looks at the node, and of those that are as near, for they meet in the nearest
  /// point, the one that it is most in front of; null if there is none. Whatever the order of the faces.
  const NodeFoot* nearest(std::int32_t body) const {
    double least = INFINITY;
    for (const NodeFoot& foot : feet_) {
      if (segment_of(foot).body == body && foot.distance() < least && looks(foot)) least = foot.distance();
    }
    const NodeFoot* best = nullptr;
    for (const NodeFoot& foot : feet_) {
      if (segment_of(foot).body != body || !(foot.distance() < least + as_near()) || !looks(foot)) continue;
      if (best == nullptr || foot.gap > best->gap) best = &foot;
    }
    return best;
  }

  /// Whether two faces meet in the point that is nearest to the node, or are as near.
  bool ties(const NodeFoot& foot, const NodeFoot& other) const {
    return &foot != &other && segment_of(other).body == segment_of(foot).body &&
           std::abs(other.distance() - foot.distance()) < as_near();
  }

  /// Whether the middle of a face is behind the plane of another.
  bool bulges(const NodeFoot& foot, const NodeFoot& other) const {
    const auto middle = double_vector_of(record(surface_.sphere().data(), other.segment));
    const auto own_middle = double_vector_of(record(surface_.sphere().data(), foot.segment));
    return dot(middle - own_middle, foot.normal) < 0;
  }

  /// The node is in front of an edge that is sharper than a right angle, and further beside both of its faces than
  /// above.
  bool is_before_sharp_edge(const NodeFoot& foot) const {
    return std::any_of(feet_.begin(), feet_.end(), [&](const NodeFoot& other) {
      return ties(foot, other) && other.gap > 0 && dot(other.normal, foot.normal) < 0 && bulges(foot, other) &&
             looks(other);
    });
  }

  /// Where faces meet that are as near: their mean, so that none is preferred. In a valley each has its own.
  Vec3<double> mean_normal(const NodeFoot& foot) const {
    Vec3<double> sum = foot.normal;
    for (const NodeFoot& other : feet_) {
      if (!ties(foot, other)) continue;
      if (dot(other.normal, foot.normal) > other_side || (bulges(foot, other) && looks(other)))
        sum = sum + other.normal;
    }
    return unless_steep(foot, sum);
  }

  /// A vector made a unit vector; the normal where it hardly rises from the face.
  static Vec3<double> unless_steep(const NodeFoot& foot, const Vec3<double>& sum) {
    const double length = std::sqrt(dot(sum, sum));
    return dot(sum, foot.normal) > least_rise * length ? (1 / length) * sum : foot.normal;
  }

  /// Along the normal inside of a face; from its rim along the line to the node, and along normals where that is short.
  Vec3<double> direction_of(const NodeFoot& foot, const Vec3<double>& to) const {
    const Vec3<double> normal = mean_normal(foot);
    if (is_on_face(foot)) return normal;
    const double distance = std::sqrt(dot(to, to)), by_normal = near_rim * size_of(foot);
    if (distance <= by_normal) return normal;
    const double sign = foot.gap < 0 ? -1 : 1;
    const Vec3<double> sum = (sign * (1 - by_normal / distance)) * to + by_normal * normal;
    return unless_steep(foot, sum);
  }

  /// The nearest of the faces that make a valley, or a sharp edge that the node is right on, with another, if the node
  /// is outside of both; null if there is none.
  const NodeFoot* beside_edge(const NodeFoot& best) const {
    const NodeFoot* nearest = nullptr;
    for (const NodeFoot& foot : feet_) {
      const double margin = edge_margin * radius_of(foot);
      if (&foot == &best || segment_of(foot).body != segment_of(best).body) continue;
      if (dot(foot.normal, best.normal) > other_side) continue;
      if (foot.gap < -margin || best.gap < -margin || !is_on_face(foot) || !looks(foot)) continue;
      const double nearer = nearest == nullptr ? INFINITY : nearest->distance() - foot.distance();
      if (nearer > as_near() || (nearer > -as_near() && foot.gap > nearest->gap)) nearest = &foot;
    }
    return nearest;
  }

  void add_rows_with(std::int32_t body, std::vector<FeatureRow>& rows) const {
    const NodeFoot* const best = nearest(body);
    if (best == nullptr || !belongs(*best)) return;
    add_row(*best, -1 - 2 * static_cast<std::int64_t>(body), rows);
    if (const NodeFoot* const other = beside_edge(*best); other != nullptr) {
      add_row(*other, -2 - 2 * static_cast<std::int64_t>(body), rows);
    }
  }

  void add_row(const NodeFoot& foot, std::int64_t name, std::vector<FeatureRow>& rows) const {
    const auto& segment = segment_of(foot);
    if (!may_have_row(foot)) return;
    FeatureRow& row = rows.emplace_back();
    row.first = slave_.node;
    row.slave = foot.slave;
    row.second = name;
    row.size = slave_.radius + segment.radius;
    row.reach = size_of(foot);
    if (step_.pairs != nullptr) {
      row.pair = step_.pairs->node_and_face(slave_.node, segment.slot, segment.face, segment.node);
    }
    Vec3<double> x[4], to = double_vector_of(source_.x(slave_.node));
    for (int k = 0; k < 4; ++k) {
      x[k] = double_vector_of(source_.x(segment.node[k]));
      to = to - foot.weight[k] * x[k];
    }
    row.direction = direction_of(foot, to);
    row.depth = 0 - dot(to, row.direction);
    double weight[4];
    std::copy_n(foot.weight, 4, weight);
    const Vec3<double> beside = to + row.depth * row.direction;
    const double nothing = no_moment * radius_of(foot);
    if (dot(beside, beside) > nothing * nothing) row.depth = 0 - move_to_line(x, to, row.direction, weight);
    row.add_node(slave_.node, -1);
    row.add_side(segment.node, weight, 1);
  }

  const SurfaceSource<S>& source_;
  const SegmentSurface<S>& surface_;
  const StepReach& step_;
  std::span<const NodeFoot> feet_;
  const typename SegmentSurface<S>::Slave& slave_;
  Vec3<double> velocity_;
};

}  // namespace

template <class S>
void NodeRows<S>::find(const SurfaceSource<S>& source, const SegmentSurface<S>& surface, const NodePairs& pairs,
                       const StepReach& step, const ListShare& share) {
  rows_.find("node rows", share, [&](std::int64_t number, const ListPart& part, RowPieces::Piece& piece) {
    find_near_nodes<S>(source, surface, pairs, part, step, piece.near);
    std::erase_if(piece.near, [&](std::int32_t place) { return !counts(surface, pairs, place); });
    std::vector<NodeFoot>& feet = feet_[number];
    find_feet<S>(source, surface, pairs, piece.near, feet);
    for (auto begin = feet.begin(); begin != feet.end();) {
      const auto end =
          std::find_if(begin, feet.end(), [&](const NodeFoot& foot) { return foot.slave != begin->slave; });
      NodeMeeting<S>(source, surface, step, {begin, end}).add_rows(piece.rows);
      begin = end;
    }
  });
}

template <class S>
void NodeRows<S>::drop_mirrored(const SurfaceSource<S>& source, const SegmentSurface<S>& surface) {
  on_node_.resize(source.node_count, nullptr);
  // A node of the face that the row's node is as good as on; negative: none.
  const auto met_from = [](const FeatureRow& row, double least) {
    for (int k = 1; k < row.nodes; ++k) {
      if (row.weight[k] > least) return row.node[k];
    }
    return -1;
  };
  const auto met_by = [&](const FeatureRow& row) { return met_from(row, on_a_node); };
  const auto is_right_on = [&](const FeatureRow& row) { return met_from(row, right_on_a_node) >= 0; };
  const auto is_corner = [&](const FeatureRow& row) {
    return may_face(surface, row.slave, row.direction) && is_lowest(source, surface, row.slave, row.direction);
  };
  // The rows of a node are in one piece: the last of them remains.
  rows_.for_each_by_pieces("rows on nodes", [&](FeatureRow& row) {
    if (met_by(row) >= 0) on_node_[row.node[0]] = &row;
  });
  const auto drop = [&](FeatureRow& row, std::int32_t met) {
    const FeatureRow* const other = on_node_[met];
    if (other == nullptr || met_by(*other) != row.node[0]) return;
    if (dot(row.direction, other->direction) < -0.99) {
      if (!is_right_on(row) || !is_right_on(*other) || row.node[0] < met) return;
      row.dropped = true;
      if (row.nodes > 2 || other->nodes > 2) return;
      // The mean of both, so that none is preferred.
      FeatureRow& kept = *on_node_[met];
      const Vec3<double> mean = kept.direction - row.direction;
      kept.direction = (1 / std::sqrt(dot(mean, mean))) * mean;
      kept.depth = 0.5 * (kept.depth + row.depth);
    } else {  // where one of them is a corner, the other's face is the one that they meet at
      const bool corner = is_corner(row), corner_met = is_corner(*other);
      row.dropped = corner != corner_met ? corner_met : row.nodes == 2 && row.node[0] > met;
    }
  };
  // Only those that meet a lower node change another row than their own: the last of that node, which nobody else looks
  // at then, for all that do are of the one node that it meets.
  rows_.for_each_by_pieces("rows on higher nodes", [&](FeatureRow& row) {
    if (const std::int32_t met = met_by(row); met > row.node[0]) drop(row, met);
  });
  rows_.for_each_by_pieces("rows on lower nodes", [&](FeatureRow& row) {
    if (const std::int32_t met = met_by(row); met >= 0 && met < row.node[0]) drop(row, met);
  });
  rows_.for_each_by_pieces("rows forgotten", [this](FeatureRow& row) { on_node_[row.node[0]] = nullptr; });
  rows_.erase_dropped();
}

template <class S>
std::size_t NodeRows<S>::bytes() const {
  std::size_t sum = rows_.bytes() + on_node_.capacity() * sizeof(on_node_[0]);
  for (const auto& feet : feet_) sum += feet.capacity() * sizeof(feet[0]);
  return sum;
}

template class NodeRows<double>;
template class NodeRows<float>;

}  // namespace pinball

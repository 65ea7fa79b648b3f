#include "meetings.hpp"

#include <algorithm>
#include <cmath>

namespace pinball {

namespace {

constexpr std::size_t most_movers = 2000;
constexpr double touching = 1e-6;  ///< distance within which bodies touch, over their size [-]

using Moves = std::vector<Extent> Mover::*;

/// The cells of two movers that come near to each other while one moves within `way` beside the other.
const MoverCell* cells_meet(const Mover& a, const Mover& b, const Extent& way, double margin, const MoverCell** of_b) {
  for (const MoverCell& one : a.cells) {
    const Extent swept = one.box + way;
    if (!overlap(swept, b.box, margin)) continue;
    for (const MoverCell& other : b.cells) {
      if (!overlap(swept, other.box, margin)) continue;
      *of_b = &other;
      return &one;
    }
  }
  return nullptr;
}

/// What turns on the spot may strike what is beside it: that is possible, and no more is known.
bool is_at_rest(const Mover& mover, Moves moves) {
  if (mover.speed > 0 || (mover.turns && moves == &Mover::strayed)) return false;
  return std::ranges::all_of(mover.*moves, [](const Extent& moved) { return moved.reach() == 0; });
}

bool is_point(const Extent& moved) { return moved.low == moved.high; }

/// Largest way of a place of one as a place of the other sees it, from the j-th time before to that [length].
double relative_way(const Mover& a, const Mover& b, std::size_t j) {
  const auto has_one_way = [j](const Mover& mover) { return is_point(mover.moved[j - 1]) && is_point(mover.moved[j]); };
  if (has_one_way(a) && has_one_way(b)) {
    const Extent before = a.moved[j - 1] - b.moved[j - 1], now = a.moved[j] - b.moved[j];
    return norm(minus(now.low, before.low));
  }
  const Drift &before_a = a.drift[j - 1], &now_a = a.drift[j], &before_b = b.drift[j - 1], &now_b = b.drift[j];
  double largest = 0;
  for (std::size_t i = 0; i < now_a.ways.size(); ++i) {
    for (std::size_t k = 0; k < now_b.ways.size(); ++k) {
      const Point one = minus(now_a.ways[i], before_a.ways[i]), other = minus(now_b.ways[k], before_b.ways[k]);
      largest = std::max(largest, norm(minus(one, other)));
    }
  }
  return largest + std::abs(now_a.spread - before_a.spread) + std::abs(now_b.spread - before_b.spread);
}

/// The same over one length of time, that of the first [length].
double even_way(const Mover& a, const Mover& b, const std::vector<double>& times, std::size_t j) {
  const double time = times[j] - times[j - 1], even = std::abs(time - times[1]) < 1e-6 * times[1] ? 1 : times[1] / time;
  return even * relative_way(a, b, j);
}

/// near: distance within which they meet, over the size of the smaller one; negative: they go into each other [-].
std::optional<Meeting> meeting_of(const Mover& a, const Mover& b, const std::vector<double>& times, Moves moves,
                                  double near) {
  if (is_at_rest(a, moves) && is_at_rest(b, moves)) return {};
  const double margin = near * std::min(a.box.size(), b.box.size());
  double speed = 0;
  Extent before = (a.*moves)[0] - (b.*moves)[0];
  for (std::size_t j = 1; j < times.size(); ++j) {
    const Extent now = (a.*moves)[j] - (b.*moves)[j], way = hull(before, now);
    speed = std::max(speed, even_way(a, b, times, j));
    before = now;
    const MoverCell* of_b = nullptr;
    if (!overlap(a.box + way, b.box, margin)) continue;
    const MoverCell* of_a = cells_meet(a, b, way, margin, &of_b);
    if (of_a == nullptr) continue;
    return Meeting{std::min(of_a->body, of_b->body), std::max(of_a->body, of_b->body), times[j - 1],
                   speed / (times[1] - times[0])};
  }
  return {};
}

/// Places along a direction [length].
struct Reach {
  double low = INFINITY, high = -INFINITY;

  void take(double place) {
    low = std::min(low, place);
    high = std::max(high, place);
  }
};

/// The speeds at which movers that gain speed meet, by directions that turn with the scene: boxes of bodies that lie
/// askew meet earlier, while these are slow.
class SpeedsOfNodes {
 public:
  SpeedsOfNodes(const Movers& movers, const ModelMesh& mesh) : movers_(movers), mesh_(mesh) {}

  /// Of two movers whose boxes meet at `by_boxes`; none: the movers themselves do not meet.
  std::optional<double> at_meeting(const Mover& a, const Mover& b, const Meeting& by_boxes) {
    const std::vector<double>& times = movers_.times;
    double largest = 0;
    for (std::size_t j = 1; j < times.size(); ++j) largest = std::max(largest, even_way(a, b, times, j) / times[1]);
    if (a.round || b.round || largest <= (1 + 1e-9) * by_boxes.speed) return by_boxes.speed;
    if (nodes_.empty()) find_nodes();
    const std::vector<std::int32_t>& of_a = nodes_[number(a)];
    const std::vector<std::int32_t>& of_b = nodes_[number(b)];
    work_ += of_a.size() + of_b.size();
    if (of_a.empty() || of_b.empty() || work_ > most_work) return by_boxes.speed;
    const std::vector<Point> directions = directions_of(a, of_a, b, of_b);
    std::vector<std::array<Reach, 2>> reaches;
    for (const Point& direction : directions) reaches.push_back({reach(of_a, direction), reach(of_b, direction)});
    const double margin = touching * std::min(a.box.size(), b.box.size());
    double way = 0;
    for (std::size_t j = 1; j < times.size(); ++j) {
      way = std::max(way, even_way(a, b, times, j));
      bool apart = false;
      for (std::size_t d = 0; d < directions.size() && !apart; ++d) {
        const Reach one = swept(reaches[d][0], a, j, directions[d]), other = swept(reaches[d][1], b, j, directions[d]);
        apart = one.low > other.high + margin || other.low > one.high + margin;
      }
      if (!apart) return way / times[1];
    }
    return {};
  }

 private:
  static constexpr std::size_t most_work = 5'000'000;  ///< nodes: some hundredths of a second

  std::size_t number(const Mover& mover) const { return static_cast<std::size_t>(&mover - movers_.all.data()); }
  void find_nodes() {
    std::vector<std::size_t> of_body(mesh_.body_names.size(), 0);
    for (std::size_t m = 0; m < movers_.all.size(); ++m) {
      for (const std::int32_t body : movers_.all[m].bodies) of_body[static_cast<std::size_t>(body)] = m;
    }
    nodes_.resize(movers_.all.size());
    for (std::size_t n = 0; n < mesh_.nodes.size(); ++n)
      nodes_[of_body[static_cast<std::size_t>(mesh_.body_of_node[n])]].push_back(static_cast<std::int32_t>(n));
  }
  Point centre(const std::vector<std::int32_t>& nodes) const {
    Point sum{};
    for (const std::int32_t n : nodes) {
      for (std::size_t k = 0; k < 3; ++k) sum[k] += mesh_.nodes[n][k] / static_cast<double>(nodes.size());
    }
    return sum;
  }
  /// The line of centres, the way, and what faces of an element of each are normal to.
  std::vector<Point> directions_of(const Mover& a, const std::vector<std::int32_t>& of_a, const Mover& b,
                                   const std::vector<std::int32_t>& of_b) const {
    std::vector<Point> all{minus(centre(of_a), centre(of_b)),
                           minus(a.drift.back().ways.front(), b.drift.back().ways.front())};
    for (const Mover* mover : {&a, &b}) {
      const auto element =
          static_cast<std::size_t>(std::ranges::find(mesh_.body, mover->bodies.front()) - mesh_.body.begin());
      std::array<Point, 3> edge{};
      for (std::size_t i = 0; i < 8; ++i) {
        const double sign[3] = {i % 4 == 1 || i % 4 == 2 ? 1.0 : -1.0, i % 4 >= 2 ? 1.0 : -1.0, i >= 4 ? 1.0 : -1.0};
        for (std::size_t d = 0; d < 3; ++d) {
          for (std::size_t k = 0; k < 3; ++k) edge[d][k] += sign[d] * mesh_.corner(element, i)[k];
        }
      }
      for (std::size_t d = 0; d < 3; ++d) all.push_back(cross(edge[(d + 1) % 3], edge[(d + 2) % 3]));
    }
    std::erase_if(all, [](const Point& direction) { return !(norm(direction) > 0); });
    for (Point& direction : all) {
      const double length = norm(direction);
      for (double& component : direction) component /= length;
    }
    return all;
  }
  Reach reach(const std::vector<std::int32_t>& nodes, const Point& direction) const {
    Reach all;
    for (const std::int32_t n : nodes) all.take(dot(mesh_.nodes[n], direction));
    return all;
  }
  static Reach swept(const Reach& at_start, const Mover& mover, std::size_t j, const Point& direction) {
    Reach all;
    for (const Drift* drift : {&mover.drift[j - 1], &mover.drift[j]}) {
      for (const Point& way : drift->ways) {
        all.take(at_start.low + dot(way, direction) - drift->spread);
        all.take(at_start.high + dot(way, direction) + drift->spread);
      }
    }
    return all;
  }

  const Movers& movers_;
  const ModelMesh& mesh_;
  std::vector<std::vector<std::int32_t>> nodes_;  ///< of each mover; empty until asked for
  std::size_t work_ = 0;                          ///< nodes looked at
};

/// Everything that a mover sweeps.
std::vector<Extent> swept(const Movers& movers, Moves moves) {
  std::vector<Extent> boxes;
  for (const Mover& mover : movers.all) {
    Extent all;
    for (const Extent& moved : mover.*moves) all.take(moved);
    boxes.push_back(mover.box + all);
  }
  return boxes;
}

template <class Take>
void for_each_meeting(const Movers& movers, Moves moves, const Take& take) {
  const std::vector<Extent> boxes = swept(movers, moves);
  for (std::size_t a = 0; a < boxes.size(); ++a) {
    for (std::size_t b = a + 1; b < boxes.size(); ++b) {
      if (!overlap(boxes[a], boxes[b], touching * movers.all[a].box.size())) continue;
      const Mover &one = movers.all[a], &other = movers.all[b];
      if (const auto met = meeting_of(one, other, movers.times, moves, touching)) take(*met, one, other);
    }
  }
}

/// Those that forces turn, as the spheres that they are then.
Movers swung(const Movers& movers) {
  Movers all = movers;
  for (Mover& mover : all.all) {
    if (!mover.sphere) continue;
    mover.box = *mover.sphere;
    mover.cells = {{mover.box, mover.bodies.front()}};
  }
  return all;
}

void keep_first(std::optional<Meeting>& first, const Meeting& met) {
  if (!first || met.time < first->time) first = met;
}

}  // namespace

Meetings find_meetings(const Movers& movers, const ModelMesh& mesh,
                       const std::function<bool(std::int32_t, std::int32_t)>& may_touch) {
  Meetings meetings;
  SpeedsOfNodes speeds(movers, mesh);
  if (movers.all.size() > most_movers) {
    meetings.possible = Meeting{movers.all[0].bodies.front(), movers.all[1].bodies.front(), 0, 0};
    return meetings;
  }
  for_each_meeting(movers, &Mover::moved, [&](const Meeting& met, const Mover& one, const Mover& other) {
    keep_first(meetings.possible, met);
    if (const auto speed = speeds.at_meeting(one, other, met); speed) {
      if (!meetings.fastest || *speed > meetings.fastest->speed) {
        meetings.fastest = met;
        meetings.fastest->speed = *speed;
      }
    }
    const auto inside = meeting_of(one, other, movers.times, &Mover::moved, -touching);
    if (!inside) return;  // what lies on another and leaves it, or slides
    keep_first(meetings.expected, *inside);
    if (!may_touch(inside->first, inside->second)) keep_first(meetings.passing, *inside);
  });
  if (meetings.possible) return meetings;
  for_each_meeting(swung(movers), &Mover::strayed,
                   [&](const Meeting& met, const Mover&, const Mover&) { keep_first(meetings.possible, met); });
  return meetings;
}

}  // namespace pinball

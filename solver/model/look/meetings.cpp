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

/// near: distance within which they meet, over the size of the smaller one; negative: they go into each other [-].
std::optional<Meeting> meeting_of(const Mover& a, const Mover& b, const std::vector<double>& times, Moves moves,
                                  double near) {
  if (is_at_rest(a, moves) && is_at_rest(b, moves)) return {};
  const double margin = near * std::min(a.box.size(), b.box.size());
  double speed = 0;
  Extent before = (a.*moves)[0] - (b.*moves)[0];
  for (std::size_t j = 1; j < times.size(); ++j) {
    const Extent now = (a.*moves)[j] - (b.*moves)[j], way = hull(before, now);
    const double time = times[j] - times[j - 1],
                 even = std::abs(time - times[1]) < 1e-6 * times[1] ? 1 : times[1] / time;
    speed = std::max(speed, even * relative_way(a, b, j));
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

Meetings find_meetings(const Movers& movers, const std::function<bool(std::int32_t, std::int32_t)>& may_touch) {
  Meetings meetings;
  if (movers.all.size() > most_movers) {
    meetings.possible = Meeting{movers.all[0].bodies.front(), movers.all[1].bodies.front(), 0, 0};
    return meetings;
  }
  for_each_meeting(movers, &Mover::moved, [&](const Meeting& met, const Mover& one, const Mover& other) {
    keep_first(meetings.possible, met);
    if (!meetings.fastest || met.speed > meetings.fastest->speed) meetings.fastest = met;
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

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <solver/base/lists_in_order.hpp>

#include "impulse_solver.hpp"
#include "rigid_nodes_of_rows.hpp"

/// What follows from the impulses of a step: releases, forces on the nodes, energies, and what pairs remember.
namespace pinball {

namespace {

/// A row slides if its friction is at its bound, but for the first, and it does so faster than by the second of the
/// velocity that its friction can stop.
constexpr double of_bound = 1e-3, sliding = 1e-3;

/// The same over `sliding`, of rows of two rigid bodies, which creep together by what the compliance of few of them
/// leaves.
constexpr double of_rigid_pair = 10;

/// Part of the inverse mass of a node that rounding leaves where it is held in all directions.
constexpr double still = 1e-9;

/// Part of the impulse of the step before that one may have that opens.
constexpr double remainder = 2e-3;

}  // namespace

/// Whether a row that pushed in the step before opens in this one: nothing drives it together any more, but for what
/// its compliance has left.
template <class S>
bool ImpulseSolver<S>::opens(std::int64_t k) const {
  const std::size_t i = system_.original(k);
  const ImpulseRow& row = rows_.rows[i];
  const double little = remainder * row.impulse;
  return !is_bound(i) && pairs_[i].memory.force > 0 && (!rigid_ || has_free_node(rows_[i])) &&
         system_.impulse_as_added(k, iterations_.impulse(k)) <= little &&
         pairs_[i].rate_free + row.position_rate <= little * row.inverse_mass;
}

/// Finds opens_; returns whether there are any.
template <class S>
bool ImpulseSolver<S>::find_opening() {
  opens_.resize(system_.size());
  std::uint8_t any = 0;
  for_all("rows that open", opens_.size(), [&](std::int64_t k) {
    opens_[k] = opens(k) ? 1 : 0;
    if (opens_[k] != 0) set_mark(any);
  });
  return any != 0;
}

/// Bound of the row sum of G M^-1 G^T over the rows that open, weighted by their last forces over that of row k
/// [1/mass].
template <class S>
double ImpulseSolver<S>::shared_inverse_mass(std::int64_t k) const {
  const std::int32_t i = system_.original(k);
  const RowView row = system_.entries(k);
  double alone = 0, shared = 0;
  for (int e = 0; e < row.nodes; ++e) {
    const double* m = nodes_[row.node[e]].inverse_mass;
    if (nodes_[row.node[e]].body >= 0) continue;
    const double most = std::abs(row.weight[e]) * std::max({m[0], m[1], m[2]});
    alone += most * std::abs(row.weight[e]);
    shared += most * release_share_[row.node[e]];
  }
  if (rigid_) {
    for_rigid_entries(row, nodes_.data(), rigid_, [&](const RigidEntry& entry) {
      const double root = std::sqrt(entry.most(rigid_.side(entry.body)));
      alone += root * root;
      shared += root * rigid_release_share_[rigid_.first_of(entry.body)];
    });
  }
  const double inverse_mass = rows_.rows[i].inverse_mass;
  return alone > 0 ? inverse_mass * shared / (alone * pairs_[i].memory.force) : inverse_mass;
}

/// Impulse that a row that opens gives: half of the last, but no more than the largest for which
/// 1/2 p (rate_before + rate - p inverse_mass) >= -lost.
template <class S>
double ImpulseSolver<S>::released_by(std::int64_t k, double velocity_step) const {
  const std::int32_t i = system_.original(k);
  const Pair& pair = pairs_[i];
  const double inverse_mass = shared_inverse_mass(k);
  const double rate = dot(vector_of(rows_.rows[i].direction), system_.approach(k, velocity_.data()));
  const double sum = pair.rate_before + rate;
  const double root = std::sqrt(sum * sum + 8 * budget_of(pair) * inverse_mass);
  return std::clamp((sum + root) / (2 * inverse_mass), 0.0, 0.5 * pair.memory.force * velocity_step);
}

/// The part of what mobile nodes are moved by that is theirs alone: where there is none, a row is between rigid bodies,
/// or what nothing moves. Nothing of them swings back, so that no other half of an impulse is due.
template <class S>
bool ImpulseSolver<S>::has_free_node(const RowView& row) const {
  for (int e = 0; e < row.nodes; ++e) {
    const std::int32_t place = row.node[e];
    const double* const m = nodes_[place].inverse_mass;
    if (rigid_.sides->body_of_node[node_[place]] < 0 && m[0] + m[1] + m[2] > 0) return true;
  }
  return false;
}

/// Sums over the rows of each rigid body that open, in their order.
template <class S>
void ImpulseSolver<S>::share_releases() {
  rigid_release_share_.assign(rigid_.sides->bodies.size(), 0);
  for (std::int32_t k = 0; k < system_.size(); ++k) {
    if (opens_[k] == 0) continue;
    const double force = pairs_[system_.original(k)].memory.force;
    for_rigid_entries(system_.entries(k), nodes_.data(), rigid_, [&](const RigidEntry& entry) {
      rigid_release_share_[rigid_.first_of(entry.body)] += std::sqrt(entry.most(rigid_.side(entry.body))) * force;
    });
  }
}

template <class S>
void ImpulseSolver<S>::move_by_releases() {
  for_all("release of nodes", nodes_.size(), [&](std::int64_t place) {
    if (nodes_[place].body < 0) system_.move(place, row_vector_.data(), velocity_.data());
  });
  for_rigid_nodes(system_, 0, std::ssize(system_.groups()), IslandLoops(rows_.size() >= rows_worth_a_thread),
                  row_vector_.data(), [&](std::int32_t place, const Vec3<double>& change) {
                    double* const v = record(velocity_.data(), place);
                    put_vector(v, vector_of(v) - change);
                  });
}

/// Rows that open together move the same nodes: what one of them may give is measured by what all of them do, each by
/// its part of the last force. (Where rows outnumber nodes some hold nothing but round-off.)
template <class S>
void ImpulseSolver<S>::release(double velocity_step) {
  if (!find_opening()) return;
  release_share_.assign(nodes_.size(), 0);
  for_all("shares of rows that open", nodes_.size(), [&](std::int64_t place) {
    system_.for_rows_of(place, [&](std::int32_t k, double weight) {
      if (opens_[k] != 0) release_share_[place] += std::abs(weight) * pairs_[system_.original(k)].memory.force;
    });
  });
  if (rigid_) share_releases();
  row_vector_.reset(4 * active_.size());
  for_all("release", active_.size(), [&](std::int64_t k) {
    if (opens_[k] == 0) return;
    const double released = released_by(k, velocity_step);
    const Vec3<double> a = vector_of(rows_.rows[system_.original(k)].direction);
    if (released > 0) put_vector(record(row_vector_.data(), k), released * a);
  });
  move_by_releases();
  for_all("what is released", active_.size(), [&](std::int64_t k) {
    const Vec3<double> released = vector_of(record(row_vector_.data(), k));
    if (!(dot(released, released) > 0)) return;
    iterations_.set_impulse(k, released);
    pairs_[system_.original(k)].memory.force = -1;  // so that it does not count as a contact at the next step
  });
  if (has_friction()) rub_by_releases();
}

/// What is released is an impulse like others, and rubs: all rows see the same sliding, and stop no more of it than
/// together they can.
template <class S>
void ImpulseSolver<S>::rub_by_releases() {
  row_vector_.reset(4 * active_.size());
  for_all("friction of what is released", active_.size(), [&](std::int64_t k) {
    const std::int32_t i = system_.original(k);
    const RowSystem::Row& row = system_.row(k);
    if (!(pairs_[i].memory.force < 0) || !(row.coefficient > 0)) return;
    Vec3<double> slides = system_.approach(k, velocity_.data());
    if (rigid_) slides = slides + way_of(rows_[i]);
    slides = slides - dot(row.direction, slides) * row.direction;
    const Vec3<double> b = iterations_.impulse(k);
    const Vec3<double> with = allowed_impulse(b + (1 / row.sum_across) * slides, row.direction, {row.coefficient, 0});
    put_vector(record(row_vector_.data(), k), with - b);
    iterations_.set_impulse(k, with);
  });
  move_by_releases();
}

/// The two bodies that a row is of where they are rigid, -1: what does not move; nothing where anything moves by
/// itself.
template <class S>
std::optional<std::pair<std::int32_t, std::int32_t>> ImpulseSolver<S>::rigid_pair(const SurfaceSource<S>& source,
                                                                                  const RowView& row) const {
  std::int32_t least = std::numeric_limits<std::int32_t>::max(), most = -1;
  for (int e = 0; e < row.nodes; ++e) {
    const ImpulseNode& node = nodes_[row.node[e]];
    const double* const m = node.inverse_mass;
    const bool is_still = m[0] + m[1] + m[2] <= still * source.inverse_mass[node_[row.node[e]]];
    if (node.body < 0 && !is_still) return std::nullopt;
    least = std::min(least, node.body);
    most = std::max(most, node.body);
  }
  for (int e = 0; e < row.nodes; ++e) {
    const std::int32_t body = nodes_[row.node[e]].body;
    if (body != least && body != most) return std::nullopt;
  }
  return std::pair{least, most};
}

/// Most that friction gives in each row before it counts as slid, of rows of two rigid bodies that of all these: what
/// one of them cannot hold the others do, and nothing else says how the pressure is shared among them.
template <class S>
void ImpulseSolver<S>::find_most_friction(const SurfaceSource<S>& source) {
  most_friction_.assign(active_.size(), 0.0);
  for_all("most of friction", active_.size(), [&](std::int64_t k) {
    const std::int32_t i = system_.original(k);
    if (!is_bound(i))
      most_friction_[k] = frictions_[i].coefficient * dot(system_.row(k).direction, iterations_.impulse(k));
  });
  if (!rigid_) return;
  std::map<std::pair<std::int32_t, std::int32_t>, double> of_pair;
  std::vector<double*> sums(active_.size(), nullptr);
  for (std::size_t k = 0; k < active_.size(); ++k) {
    const std::int32_t i = system_.original(k);
    if (is_bound(i)) continue;
    if (const auto pair = rigid_pair(source, rows_[i])) *(sums[k] = &of_pair[*pair]) += most_friction_[k];
  }
  for (std::size_t k = 0; k < active_.size(); ++k) {
    if (sums[k] != nullptr) most_friction_[k] = of_rigid_pair * *sums[k];
  }
}

/// What a row takes out. Returns its force on body 1, with that of friction.
template <class S>
Vec3<double> ImpulseSolver<S>::finish_row(std::int64_t k, const StepLengths& step) {
  const std::int32_t i = system_.original(k);
  Pair& pair = pairs_[i];
  const Vec3<double> a = vector_of(rows_.rows[i].direction), after = system_.approach(k, velocity_.data());
  const double rate = dot(a, after);
  pair.force = std::max(0.0, system_.impulse_as_added(k, iterations_.impulse(k))) / step.velocity();
  if (is_bound(i)) {
    pair.memory.force = std::exchange(pair.force, 0);
    if (rubs_) {
      const Vec3<double> b = iterations_.impulse(k), friction = (1 / step.velocity()) * (b - dot(a, b) * a);
      pair.memory.friction[0] = friction.x;
      pair.memory.friction[1] = friction.y;
      pair.memory.friction[2] = friction.z;
    }
    return {0, 0, 0};
  }
  pair.lost = work_of(pair.force, pair.rate_before, rate, step);
  pair.taken = pair.lost.now + pair.lost.later;  // without friction
  pair.memory.lost += pair.taken;
  pair.memory.force = pair.memory.force < 0 ? 0 : pair.force;
  if (has_friction()) pair.lost.join(keep_friction(k, after - rate * a, step));
  if (!(pair.force > 0)) return {0, 0, 0};
  const Vec3<double> force = pair.force * a;
  return has_friction() ? force + vector_of(pair.memory.friction) : force;
}

/// Force of the friction of a row, and its work. after: sliding velocity.
template <class S>
ExternalWork ImpulseSolver<S>::keep_friction(std::int64_t k, const Vec3<double>& after, const StepLengths& step) {
  const std::int32_t i = system_.original(k);
  Pair& pair = pairs_[i];
  const FrictionRow& friction = frictions_[i];
  const Vec3<double> a = system_.row(k).direction, b = iterations_.impulse(k);
  const double p = dot(a, b);
  const Vec3<double> q = b - p * a;
  const double most = friction.coefficient * p;
  Vec3<double> slid = after;
  if (rigid_) {
    const Vec3<double> way = way_of(rows_[i]);
    slid = slid + way - dot(a, way) * a;
  }
  pair.memory.slides = std::sqrt(dot(q, q)) >= (1 - of_bound) * most &&
                       std::sqrt(dot(slid, slid)) > sliding * most_friction_[k] * friction.inverse_mass;
  const double impulse[3] = {q.x, q.y, q.z}, rate[3] = {after.x, after.y, after.z};
  ExternalWork lost;
  for (int c = 0; c < 3; ++c) {
    pair.memory.friction[c] = impulse[c] / step.velocity();
    lost.join(work_of(pair.memory.friction[c], pair.sliding_before[c], rate[c], step));
  }
  return lost;
}

/// Forces of the rows on their nodes: each node sums up those of its rows.
template <class S>
void ImpulseSolver<S>::give_forces(const SurfaceSource<S>& source, const StepLengths& step) {
  row_vector_.renew(4 * active_.size());
  if (has_friction()) find_most_friction(source);
  for_all("forces of rows", active_.size(),
          [&](std::int64_t k) { put_vector(record(row_vector_.data(), k), finish_row(k, step)); });
  for_all("forces of rows on nodes", nodes_.size(), [&](std::int64_t place) {
    const Vec3<double> sum = system_.impulse_at(place, row_vector_.data());
    S* const force = source.f(node_[place]);
    force[0] -= static_cast<S>(sum.x);
    force[1] -= static_cast<S>(sum.y);
    force[2] -= static_cast<S>(sum.z);
  });
}

template <class S>
void ImpulseSolver<S>::sum_up(ImpulseResult& result) {
  for (const std::int32_t i : active_) {
    const Pair& pair = pairs_[i];
    result.dissipated += pair.lost.now;
    pending_ += pair.lost.later;
    taken_ += pair.taken;
    result.pairs += pair.force > 0;
  }
}

template <class S>
void ImpulseSolver<S>::add_node_forces(std::span<Point> node_force) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Pair& pair = pairs_[i];
    if (!(pair.force > 0)) continue;
    const RowView row = rows_[i];
    for (int k = 0; k < row.nodes; ++k) {
      Point& force = node_force[node_[row.node[k]]];
      for (std::size_t c = 0; c < 3; ++c) {
        force[c] -= row.weight[k] * (pair.force * row.direction[c] + pair.memory.friction[c]);
      }
    }
  }
}

template <class S>
void ImpulseSolver<S>::add_pair_forces(std::vector<Point>& sums) const {
  for (std::size_t i = 0; i < pair_of_row_.size(); ++i) {
    const Pair& pair = pairs_[i];
    const PairOf of = pair_of_row_[i];
    if (!(pair.force > 0) || of.pair < 0) continue;
    Point& sum = sums[of.pair];
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += of.sign * (pair.force * rows_[i].direction[c] + (has_friction() ? pair.memory.friction[c] : 0));
    }
  }
}

template <class S>
void ImpulseSolver<S>::remember() {
  memory_.clear();
  for (const std::int32_t i : active_) {
    const PairMemory& memory = pairs_[i].memory;
    if (memory.force > 0 || memory.depth > 0) memory_.push_back(memory);
  }
  name_memory();
}

template <class S>
void ImpulseSolver<S>::name_memory() {
  names_.reset(memory_.size());
  for (std::size_t i = 0; i < memory_.size(); ++i) names_.add(memory_[i].first, memory_[i].second, i);
}

#define PINBALL_INSTANTIATE(S)                                                              \
  template void ImpulseSolver<S>::release(double);                                          \
  template void ImpulseSolver<S>::rub_by_releases();                                        \
  template bool ImpulseSolver<S>::has_free_node(const RowView&) const;                      \
  template void ImpulseSolver<S>::find_most_friction(const SurfaceSource<S>&);              \
  template void ImpulseSolver<S>::give_forces(const SurfaceSource<S>&, const StepLengths&); \
  template void ImpulseSolver<S>::sum_up(ImpulseResult&);                                   \
  template void ImpulseSolver<S>::add_node_forces(std::span<Point>) const;                  \
  template void ImpulseSolver<S>::add_pair_forces(std::vector<Point>&) const;               \
  template void ImpulseSolver<S>::remember();                                               \
  template void ImpulseSolver<S>::name_memory();
PINBALL_INSTANTIATE(double)
PINBALL_INSTANTIATE(float)
#undef PINBALL_INSTANTIATE

}  // namespace pinball

#include <algorithm>
#include <cmath>

#include "impulse_solver.hpp"

/// What follows from the impulses of a step: releases, forces on the nodes, energies, and what pairs remember.
namespace pinball {

namespace {

/// A row slides if it does so faster than by this part of the velocity that its friction can stop; the rest is what the
/// sweeps leave.
constexpr double sliding = 1e-3;

}  // namespace

/// Whether a row that pushed in the step before opens in this one.
template <class S>
bool ImpulseSolver<S>::opens(std::int64_t pack, int lane) const {
  const std::int32_t i = packs_.order().row(pack, lane);
  return i >= 0 && pairs_[i].memory.force > 0 && !(packs_.impulse(pack, lane) > 0) &&
         !(pairs_[i].rate_free + rows_.rows[i].position_rate > 0);
}

/// Rows that open together move the same nodes: what one of them may give is measured by what all of them do, each by
/// its part of the last force. (Where rows outnumber nodes some hold nothing but round-off.) Serial: few open in a
/// step.
template <class S>
bool ImpulseSolver<S>::share_release() {
  bool any = false;
  for (std::int64_t pack = 0; pack < static_cast<std::int64_t>(packs_.order().packs().size()); ++pack) {
    for (int lane = 0; lane < packs_.width(); ++lane) {
      if (!opens(pack, lane)) continue;
      if (!any) release_share_.assign(nodes_.size(), 0);
      any = true;
      const auto i = static_cast<std::size_t>(packs_.order().row(pack, lane));
      const RowView row = rows_[i];
      for (int k = 0; k < row.nodes; ++k) {
        release_share_[row.node[k]] += std::abs(row.weight[k]) * pairs_[i].memory.force;
      }
    }
  }
  return any;
}

/// Bound of the row sum of G M^-1 G^T over the rows that open, weighted by their last forces over that of row i
/// [1/mass].
template <class S>
double ImpulseSolver<S>::shared_inverse_mass(std::int32_t i) const {
  const RowView row = rows_[static_cast<std::size_t>(i)];
  double alone = 0, shared = 0;
  for (int k = 0; k < row.nodes; ++k) {
    const double* m = nodes_[row.node[k]].inverse_mass;
    const double most = std::abs(row.weight[k]) * std::max({m[0], m[1], m[2]});
    alone += most * std::abs(row.weight[k]);
    shared += most * release_share_[row.node[k]];
  }
  const double inverse_mass = rows_.rows[i].inverse_mass;
  return alone > 0 ? inverse_mass * shared / (alone * pairs_[i].memory.force) : inverse_mass;
}

template <class S>
void ImpulseSolver<S>::release(std::int64_t pack, double velocity_step) {
  bool any = false;
  for (int lane = 0; lane < packs_.width(); ++lane) any = any || opens(pack, lane);
  if (!any) return;
  Vec3<double> v[RowPacks::widest];
  packs_.find_approach(pack, velocity_.data(), v);
  double released[RowPacks::widest] = {};
  bool some = false;
  for (int l = 0; l < packs_.width(); ++l) {
    if (!opens(pack, l)) continue;
    const std::int32_t i = packs_.order().row(pack, l);
    Pair& pair = pairs_[i];
    const double inverse_mass = shared_inverse_mass(i);
    // Largest p for which 1/2 p (rate_before + rate - p inverse_mass) >= -lost.
    const double* a = rows_.rows[i].direction;
    const double sum = pair.rate_before + dot(Vec3<double>{a[0], a[1], a[2]}, v[l]);
    const double root = std::sqrt(sum * sum + 8 * budget_of(pair) * inverse_mass);
    const double missing = std::min(0.5 * pair.memory.force * velocity_step, (sum + root) / (2 * inverse_mass));
    if (!(missing > 0)) continue;
    released[l] = missing;
    some = true;
    packs_.set_impulse(pack, l, missing);
    pair.memory.force = -1;  // so that it does not count as a contact at the next step
  }
  if (some) packs_.take(pack, released, velocity_.data());
}

/// Forces of the rows of a pack, and what they take out.
template <class S>
void ImpulseSolver<S>::finish_pack(const SurfaceSource<S>& source, std::int64_t pack, const StepLengths& step) {
  Vec3<double> v[RowPacks::widest];
  packs_.find_approach(pack, velocity_.data(), v);
  for (int l = 0; l < packs_.width(); ++l) {
    const std::int32_t i = packs_.order().row(pack, l);
    if (i < 0) continue;
    Pair& pair = pairs_[i];
    const RowView row = rows_[static_cast<std::size_t>(i)];
    const double* a = row.direction;
    const Vec3<double> after = v[l];
    const double rate = a[0] * after.x + a[1] * after.y + a[2] * after.z;
    pair.force = packs_.impulse(pack, l) / step.velocity();
    pair.lost = work_of(pair.force, pair.rate_before, rate, step);
    pair.taken = pair.lost.now + pair.lost.later;  // without friction
    pair.memory.lost += pair.taken;
    pair.memory.force = pair.memory.force < 0 ? 0 : pair.force;
    if (has_friction()) pair.lost.join(keep_friction(pack, l, after - rate * Vec3<double>{a[0], a[1], a[2]}, step));
    if (!(pair.force > 0)) continue;
    for (int k = 0; k < row.nodes; ++k) {
      S* const force = source.f(node_[row.node[k]]);
      for (int c = 0; c < 3; ++c) force[c] -= static_cast<S>(pair.force * row.weight[k] * a[c]);
      if (!has_friction()) continue;
      for (int c = 0; c < 3; ++c) force[c] -= static_cast<S>(row.weight[k] * pair.memory.friction[c]);
    }
  }
}

/// Force of the friction of a row, and its work. after: sliding velocity.
template <class S>
ExternalWork ImpulseSolver<S>::keep_friction(std::int64_t pack, int lane, const Vec3<double>& after,
                                             const StepLengths& step) {
  const std::int32_t i = packs_.order().row(pack, lane);
  Pair& pair = pairs_[i];
  const FrictionRow& friction = frictions_[i];
  pair.memory.slides = std::sqrt(dot(after, after)) >
                       sliding * friction.coefficient * packs_.impulse(pack, lane) * friction.inverse_mass;
  const Vec3<double> q = packs_.friction(pack, lane);
  const double impulse[3] = {q.x, q.y, q.z}, rate[3] = {after.x, after.y, after.z};
  ExternalWork lost;
  for (int c = 0; c < 3; ++c) {
    pair.memory.friction[c] = impulse[c] / step.velocity();
    lost.join(work_of(pair.memory.friction[c], pair.sliding_before[c], rate[c], step));
  }
  return lost;
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
void ImpulseSolver<S>::add_node_forces(std::vector<Point>& node_force) const {
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
    Point& sum = sums[static_cast<std::size_t>(of.pair)];
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

#define PINBALL_INSTANTIATE(S)                                                                            \
  template bool ImpulseSolver<S>::share_release();                                                        \
  template void ImpulseSolver<S>::release(std::int64_t, double);                                          \
  template void ImpulseSolver<S>::finish_pack(const SurfaceSource<S>&, std::int64_t, const StepLengths&); \
  template void ImpulseSolver<S>::sum_up(ImpulseResult&);                                                 \
  template void ImpulseSolver<S>::add_node_forces(std::vector<Point>&) const;                             \
  template void ImpulseSolver<S>::add_pair_forces(std::vector<Point>&) const;                             \
  template void ImpulseSolver<S>::remember();                                                             \
  template void ImpulseSolver<S>::name_memory();
PINBALL_INSTANTIATE(double)
PINBALL_INSTANTIATE(float)
#undef PINBALL_INSTANTIATE

}  // namespace pinball

#include <algorithm>
#include <cmath>

#include "impulse_solver.hpp"

/// Planes that nodes do not cross, as rows of the system for as long as it is solved.
namespace pinball {

namespace {

/// Name of the first plane that bounds nodes, in the place of that of a second body.
constexpr std::int64_t first_bound = -(std::int64_t(1) << 61);

}  // namespace

/// Rows of one node each, as if the plane were a body that nothing moves. Only for as long as the system is solved.
template <class S>
void ImpulseSolver<S>::add_bounds(std::span<const NodeBound> bounds, double dt) {
  contacts_ = rows_.size();
  bound_friction_.clear();
  bounded_.clear();
  rubs_ = has_friction_;
  if (contacts_ == 0 || !(dt > 0)) return;
  double fastest = 0;
  for (const Pair& pair : pairs_) fastest = std::max(fastest, std::abs(pair.rate_before));
  std::size_t place = 0;  // bounds come in the order of the nodes
  for (const NodeBound& bound : bounds) {
    // A node may go with a plane that goes away.
    if (std::min(bound.gap, bound.present) > 2 * dt * (fastest + std::abs(bound.rate))) continue;
    while (node_[place] != bound.node) place = place + 1 < node_.size() ? place + 1 : 0;
    const auto& n = bound.normal;
    rows_.rows.push_back({{n[0], n[1], n[2]}, rows_.node.size(), 1});
    rows_.node.push_back(place);
    rows_.weight.push_back(-1);
    Pair& pair = pairs_.emplace_back();
    pair.depth = pair.seen = 0 - bound.gap;
    pair.rate_before = bound.rate;
    bound_friction_.push_back(bound.friction);
    bounded_.push_back(place);
    if (bound.friction > 0) {
      rubs_ = true;
      std::copy(bound.sliding.begin(), bound.sliding.end(), pair.sliding_before);
    }
    const std::int64_t second = first_bound - bound.wall;
    const auto is = [&](std::size_t at) { return memory_[at].first == bound.node && memory_[at].second == second; };
    const std::size_t at = names_.find(bound.node, second, is);
    if (at != PairNames::none) pair.memory = memory_[at];
    pair.memory.first = bound.node;
    pair.memory.second = second;
  }
  std::sort(bounded_.begin(), bounded_.end());
  bounded_.erase(std::unique(bounded_.begin(), bounded_.end()), bounded_.end());
}

template <class S>
void ImpulseSolver<S>::drop_bounds() {
  if (rows_.size() == contacts_) return;
  rows_.node.resize(rows_.rows[contacts_].first);
  rows_.weight.resize(rows_.rows[contacts_].first);
  rows_.rows.resize(contacts_);
  pairs_.resize(contacts_);
  if (!frictions_.empty()) frictions_.resize(contacts_);
}

template <class S>
void ImpulseSolver<S>::follow_bounds(const SurfaceSource<S>& source, const StepLengths& step) {
  const double velocity_step = step.velocity();
  for (const std::int32_t place : bounded_) {
    const std::int32_t n = node_[place];
    const Vec3<double> force = system_.impulse_at(place, row_vector_.data());  // taken from that of the node
    const Vec3<double> after =
        double_vector_of(source.v(n)) + (velocity_step * source.inverse_mass[n]) * double_vector_of(source.f(n));
    pending_ += 0.5 * velocity_step * dot(force, after - vector_of(record(velocity_.data(), place)));
  }
}

#define PINBALL_INSTANTIATE(S)                                                    \
  template void ImpulseSolver<S>::add_bounds(std::span<const NodeBound>, double); \
  template void ImpulseSolver<S>::drop_bounds();                                  \
  template void ImpulseSolver<S>::follow_bounds(const SurfaceSource<S>&, const StepLengths&);
PINBALL_INSTANTIATE(double)
PINBALL_INSTANTIATE(float)
#undef PINBALL_INSTANTIATE

}  // namespace pinball

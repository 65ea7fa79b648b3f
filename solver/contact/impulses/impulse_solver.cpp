#include "impulse_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <kernels/exec.hpp>
#include <solver/base/lists_in_order.hpp>

namespace pinball {

namespace {

/// Share of a penetration that is pushed out in a step. Gaps close exactly; what is overlapping nevertheless (a normal
/// has turned, rows beside each other disagree) leaves gently, because pushing it out at once gives the nodes a
/// velocity of g/dt.
constexpr double push_out = 0.1;

/// Over the mobility in all directions: less is none, but that of rounding, as directions are given in which nodes are
/// held.
constexpr double no_mobility = 1e-10;

/// Faster than anything closes, and still a number.
constexpr double more_than_any_rate = 1e100;
/// What is left where the bound of their number ends iterations, over what impulses were to change: more than this is
/// worth a warning.
constexpr double sound = 1e-2;

}  // namespace

template <class S>
ImpulseSolver<S>::ImpulseSolver(const ContactSettings& settings, std::int32_t node_count, HeldDirections held,
                                const ContactPairs* pairs)
    : lagrange_(settings.enforcement == Enforcement::lagrange),
      friction_{settings.friction, settings.static_friction, settings.friction_decay},
      contact_pairs_(pairs),
      has_friction_(settings.static_friction > 0 || settings.friction > 0 ||
                    (pairs != nullptr && pairs->has_friction())),
      node_place_(node_count, no_place),
      held_(std::move(held)) {}

template <class S>
void ImpulseSolver<S>::begin_rows() {
  rows_.clear();
  pairs_.clear();
  pair_of_row_.clear();
  active_.clear();
  node_.clear();
  last_entry_.clear();
  next_memory_ = 0;
}

template <class S>
void ImpulseSolver<S>::add_row(std::int64_t first, std::int64_t second, const Vec3<double>& direction, double depth,
                               double size, PairOf pair_of_row) {
  if (contact_pairs_ != nullptr) pair_of_row_.push_back(pair_of_row);
  rows_.rows.push_back({{direction.x, direction.y, direction.z}, rows_.node.size(), 0});
  Pair& pair = pairs_.emplace_back();
  pair.depth = depth;
  pair.size = size;
  pair.memory.first = first;
  pair.memory.second = second;
  recall(pair.memory, next_memory_);
}

template <class S>
void ImpulseSolver<S>::finish_rows(const SurfaceSource<S>& source, double dt) {
  // Each velocity is fetched once: a node has several rows.
  velocity_.renew(4 * node_.size());
  for_all("velocities of nodes", node_.size(), [&](std::int64_t i) {
    node_place_[node_[i]] = no_place;
    const S* const v = source.v(node_[i]);
    for (int c = 0; c < 3; ++c) record(velocity_.data(), i)[c] = v[c];
  });
  if (rigid_) find_ways(source, &RigidSide::way_before);
  if (has_friction()) slid_.resize(rows_.size());
  for_all("depths of rows", rows_.size(), [&](std::int64_t i) { limit_depth(source, i, dt); });
}

/// Part of the closing velocity of a row that the more mobile of its sides takes: 1/2 between equal ones.
template <class S>
double ImpulseSolver<S>::mobile_share(const SurfaceSource<S>& source, const RowView& row) const {
  const Point a{row.direction[0], row.direction[1], row.direction[2]};
  double mobility[2] = {0, 0};
  for (int k = 0; k < row.nodes; ++k) {
    const std::int32_t n = node_[row.node[k]];
    double free = 1;
    for (const Point& held : held_.of(n)) free -= std::pow(held[0] * a[0] + held[1] * a[1] + held[2] * a[2], 2);
    double inverse_mass = free > no_mobility ? free * source.inverse_mass[n] : 0.0;
    const std::int32_t body = rigid_ ? rigid_.sides->body_of_node[n] : -1;
    if (body >= 0) {
      const RigidSide& side = rigid_.side(body);
      const Vec3<double> direction{a[0], a[1], a[2]};
      inverse_mass = dot(direction, mobility_at(side, double_vector_of(source.x(n)) - side.centre) * direction);
    }
    mobility[row.weight[k] < 0] += std::abs(row.weight[k]) * inverse_mass;
  }
  const double larger = std::max(mobility[0], mobility[1]);
  return larger > 0 ? larger / (mobility[0] + mobility[1]) : 0.0;
}

template <class S>
double ImpulseSolver<S>::expected_change(const SurfaceSource<S>& source, double dt) const {
  double largest = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const double closing = pairs_[i].rate_before;
    if (closing > largest && pairs_[i].depth + 2 * dt * closing > 0) {
      largest = std::max(largest, closing * mobile_share(source, rows_[i]));
    }
  }
  return largest;
}

/// Velocities v* and what held directions leave of the inverse masses.
template <class S>
void ImpulseSolver<S>::load_nodes(const SurfaceSource<S>& source, double velocity_step) {
  nodes_.resize(node_.size());
  velocity_.renew(4 * node_.size());
  if (rigid_) arm_.renew(4 * node_.size());
  rigid_.arm = arm_.data();
  for_all("nodes of rows", node_.size(), [&](std::int64_t i) {
    const std::int32_t n = node_[i];
    const double m = source.inverse_mass[n];
    ImpulseNode& node = nodes_[i];
    node = {{m, m, m}, false};
    double* a = node.inverse_mass;
    const std::span<const Point> held = held_.of(n);
    if (held.size() == 3) node = {{0, 0, 0}, true};
    for (const auto& [x, y, z] : held.size() == 3 ? std::span<const Point>() : held) {
      node.held = true;
      a[0] -= m * x * x;
      a[1] -= m * y * y;
      a[2] -= m * z * z;
      a[3] -= m * x * y;
      a[4] -= m * y * z;
      a[5] -= m * z * x;
    }
    const std::int32_t body = rigid_ ? rigid_.sides->body_of_node[n] : -1;
    if (body >= 0) {
      const RigidSide& side = rigid_.side(body);
      const Vec3<double> arm = double_vector_of(source.x(n)) - side.centre;
      const Symmetric<double> t = mobility_at(side, arm);
      node = {{t.xx, t.yy, t.zz, t.xy, t.yz, t.zx}, true, side.is_mobile() ? body : -1};
      put_vector(record(arm_.data(), i), arm);
    }
    double* const v = record(velocity_.data(), i);
    for (std::size_t c = 0; c < 3; ++c) {
      v[c] = static_cast<double>(source.v(n)[c]) + velocity_step * m * static_cast<double>(source.f(n)[c]);
    }
    v[3] = 0;
  });
}

/// What a constraint has taken on beginning no row may count as its own: its work is on what moves.
template <class S>
void ImpulseSolver<S>::renew_rates_before(const SurfaceSource<S>& source) {
  for_all("rates before of rows", rows_.size(), [&](std::int64_t i) {
    const RowView row = rows_[i];
    const Vec3<double> a{row.direction[0], row.direction[1], row.direction[2]};
    Vec3<double> v{0, 0, 0};
    for (int k = 0; k < row.nodes; ++k) v = v + row.weight[k] * double_vector_of(source.v(node_[row.node[k]]));
    pairs_[i].rate_before = dot(a, v);
    const Vec3<double> slid = v - pairs_[i].rate_before * a;
    if (has_friction()) std::ranges::copy(std::array{slid.x, slid.y, slid.z}, pairs_[i].sliding_before);
  });
}

/// What each row may still close or has to push out, and its closing velocity without impulses.
/// What pairs have taken out is theirs to give back; but not what others have given back already.
template <class S>
void ImpulseSolver<S>::set_budget() {
  double positive = 0;
  for (const Pair& pair : pairs_) positive += std::max(0.0, pair.memory.lost);
  budget_share_ = positive > 0 ? std::clamp(taken_ / positive, 0.0, 1.0) : 0.0;
}

template <class S>
void ImpulseSolver<S>::set_rates(double velocity_step, double dt) {
  for_all("rates of rows", rows_.size(), [&](std::int64_t i) { set_rate(i, velocity_step, dt); });
}

/// The part of G M^-1 G^T of a row by itself that is of rigid bodies [1/mass].
template <class S>
double ImpulseSolver<S>::rigid_inverse_mass(std::size_t i, const Vec3<double>& direction) const {
  double sum = 0;
  for_rigid_entries(rows_[i], nodes_.data(), rigid_,
                    [&](const RigidEntry& entry) { sum += entry.along(rigid_.side(entry.body), direction); });
  return sum;
}

template <class S>
void ImpulseSolver<S>::set_rate(std::size_t i, double velocity_step, double dt) {
  ImpulseRow& own = rows_.rows[i];
  Pair& pair = pairs_[i];
  const RowView row = rows_[i];
  const Vec3<double> a{row.direction[0], row.direction[1], row.direction[2]};
  double inverse_mass = 0, in_all_directions = 0;
  Vec3<double> v{0, 0, 0};
  for (int k = 0; k < row.nodes; ++k) {
    const double* m = nodes_[row.node[k]].inverse_mass;
    const Symmetric<double> mobility{m[0], m[1], m[2], m[3], m[4], m[5]};
    if (nodes_[row.node[k]].body < 0) {
      inverse_mass += row.weight[k] * row.weight[k] * dot(a, mobility * a);
      in_all_directions += row.weight[k] * row.weight[k] * trace(mobility);
    }
    v = v + row.weight[k] * vector_of(record(velocity_.data(), row.node[k]));
  }
  if (rigid_) inverse_mass += rigid_inverse_mass(i, a);
  if (inverse_mass <= no_mobility * dot(a, a) * in_all_directions) inverse_mass = 0;
  own.inverse_mass = inverse_mass;
  if (is_bound(i)) {
    own.position_rate = pair.depth / dt;
  } else if (dt > 0 && pair.depth > 0) {  // with no more energy than the pair has taken out
    const double energy_limit = std::sqrt(2 * budget_of(pair) * inverse_mass);
    own.position_rate = std::min(push_out * pair.depth / dt, energy_limit);
  } else if (dt > 0) {
    own.position_rate = pair.depth / dt;
  } else {  // nothing moves any more: an open gap asks for nothing
    own.position_rate = pair.depth < -1e-9 * pair.size ? -more_than_any_rate : 0.0;
  }
  pair.rate_free = dot(a, v);
  own.impulse = std::max(0.0, pair.memory.force) * velocity_step;
}

/// Rows that nothing drives together only cost time.
template <class S>
void ImpulseSolver<S>::choose_active() {
  active_.clear();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Pair& pair = pairs_[i];
    const ImpulseRow& row = rows_.rows[i];
    const bool known = pair.memory.force > 0 || pair.depth > 0 || is_bound(i);
    const bool near = known || pair.rate_free + row.position_rate > -std::abs(pair.rate_free);
    if (near && row.inverse_mass > 0) active_.push_back(i);
  }
}

/// Begins with the friction of the step before, turned into the plane across the direction of now.
template <class S>
void ImpulseSolver<S>::begin_friction(double velocity_step) {
  if (!rubs_) {
    frictions_.clear();
    return;
  }
  frictions_.resize(rows_.size());
  for_all("friction of rows", rows_.size(), [&](std::int64_t i) {
    const RowView row = rows_[i];
    const double *a = row.direction, *before = pairs_[i].memory.friction;
    const double along = a[0] * before[0] + a[1] * before[1] + a[2] * before[2];
    FrictionRow& friction = frictions_[i];
    for (int c = 0; c < 3; ++c) friction.impulse[c] = velocity_step * (before[c] - along * a[c]);
    friction.inverse_mass = 0;
    for (int k = 0; k < row.nodes; ++k) {
      const ImpulseNode& node = nodes_[row.node[k]];
      if (node.body < 0) friction.inverse_mass += row.weight[k] * row.weight[k] * friction_mobility(node);
    }
    if (rigid_) {
      for_rigid_entries(row, nodes_.data(), rigid_,
                        [&](const RigidEntry& entry) { friction.inverse_mass += entry.most(rigid_.side(entry.body)); });
    }
    friction.coefficient = friction_of(i);
    friction.rubs = is_bound(i) ? friction.coefficient > 0 : has_friction();
  });
}

/// Coefficient of a row. With a decay that of the velocity in the middle of the step before.
template <class S>
double ImpulseSolver<S>::friction_of(std::size_t i) const {
  if (is_bound(i)) return bound_friction_[i - contacts_];
  const PairOf of = contact_pairs_ != nullptr ? pair_of_row_[i] : PairOf{};
  const PairRule& rule = of.pair < 0 ? friction_ : contact_pairs_->rule(of.pair);
  if (!(rule.friction_decay > 0)) return pairs_[i].memory.slides ? rule.friction : rule.static_friction;
  return rule.friction + (rule.static_friction - rule.friction) * std::exp(-rule.friction_decay * slid_[i]);
}

/// What a row is to change.
template <class S>
double ImpulseSolver<S>::rate_scale(std::size_t i) const {
  const Pair& pair = pairs_[i];
  const double scale = std::max({0.0, pair.rate_free + rows_.rows[i].position_rate, pair.rate_before});
  if (!rubs_) return scale;
  const double* s = pair.sliding_before;
  return std::max(scale, std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]));
}

/// The rows that take part, and the impulses of the step before to begin with.
template <class S>
void ImpulseSolver<S>::build_system(double velocity_step) {
  choose_active();
  begin_friction(velocity_step);
  system_.build(rows_, active_, nodes_, frictions_, rigid_);
  iterations_.reset(system_);
  for_all("rows to begin with", active_.size(), [&](std::int64_t k) {
    const std::size_t i = system_.original(k);
    const ImpulseRow& row = rows_.rows[i];
    system_.row(k).scale = rate_scale(i) / system_.row(k).length;
    Vec3<double> b = row.impulse * vector_of(row.direction);
    if (rubs_) b = b + vector_of(frictions_[i].impulse);
    iterations_.set_impulse(k, b);
  });
}

template <class S>
void ImpulseSolver<S>::solve_coupled(ImpulseResult& result) {
  const ImpulseIterations::Result solved = iterations_.solve(system_, velocity_.data());
  result.iterations = solved.steps;
  result.residual = solved.residual;
  result.scale = solved.scale;
  result.at_bound = !solved.converged;
  result.unsolved = !solved.converged && !(solved.residual <= sound * solved.scale);
}

/// The first of the deepest.
template <class S>
void ImpulseSolver<S>::find_deepest(ImpulseResult& result) const {
  struct Deepest {
    double ratio;
    std::size_t row;
  };
  std::array<Deepest, fixed_pieces> of_pieces;
  const std::size_t rows = pairs_.size();
  for_all_of("deepest rows", fixed_pieces, std::ssize(pairs_), [&](std::int64_t piece) {
    Deepest deepest{0, 0};
    const std::size_t end = rows * (piece + 1) / fixed_pieces;
    for (std::size_t i = rows * piece / fixed_pieces; i < end; ++i) {
      const double ratio = pairs_[i].seen / pairs_[i].size;
      if (ratio > deepest.ratio) deepest = {ratio, i};
    }
    of_pieces[piece] = deepest;
  });
  for (const Deepest& deepest : of_pieces) {
    if (!(deepest.ratio > result.penetration_ratio)) continue;
    result.penetration_ratio = deepest.ratio;
    result.deepest = node_[rows_[deepest.row].node[0]];
  }
}

template <class S>
ImpulseResult ImpulseSolver<S>::solve(const SurfaceSource<S>& source, const StepLengths& step,
                                      std::span<const NodeBound> bounds) {
  ImpulseResult result;
  result.dissipated = pending_;
  pending_ = 0;
  const double velocity_step = step.velocity();
  if (velocity_step == 0) {
    rows_.clear();
    pairs_.clear();
    pair_of_row_.clear();
  }
  find_deepest(result);
  load_nodes(source, velocity_step);
  if (std::exchange(has_stopped_nodes_, false)) renew_rates_before(source);
  if (rigid_) {
    find_ways(source, &RigidSide::way_after);
    move_on_ways(1);
  }
  add_bounds(bounds, step.after);
  set_budget();
  set_rates(velocity_step, step.after);
  build_system(velocity_step);
  if (lagrange_) {
    solve_coupled(result);
  } else {
    iterations_.project(system_, velocity_.data());
  }
  if (rigid_) move_on_ways(-1);
  release(velocity_step);
  give_forces(source, step);
  sum_up(result);
  remember();
  drop_bounds();
  return result;
}

template class ImpulseSolver<double>;
template class ImpulseSolver<float>;

}  // namespace pinball

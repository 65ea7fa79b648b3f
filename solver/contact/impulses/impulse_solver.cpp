#include "impulse_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pinball {

namespace {

/// Share of a penetration that is pushed out in a step. Gaps close exactly; what is overlapping nevertheless (a normal
/// has turned, rows beside each other disagree) leaves gently, because pushing it out at once gives the nodes a
/// velocity of g/dt.
constexpr double push_out = 0.1;

constexpr int most_sweeps = 200;
/// A row slides if it does so faster than by this part of the velocity that its friction can stop; the rest is what the
/// sweeps leave.
constexpr double sliding = 1e-3;
/// Of the sweeps, relative to the largest closing velocity. They begin with the impulses of the step before, so that
/// what one step leaves the next one takes up: from 1e-9 to 1e-3 the worst stress of the contact patch test errs by 1.6
/// to 2.4 %, and two bars by the same to all digits; 1e-4 takes a sixth of the time of 1e-9 in the patch test.
constexpr double tolerance = 1e-4;

}  // namespace

template <class S>
ImpulseSolver<S>::ImpulseSolver(const ContactSettings& settings, std::int32_t node_count, HeldDirections held)
    : lagrange_(settings.enforcement == Enforcement::lagrange),
      friction_at_rest_(settings.static_friction),
      friction_sliding_(settings.friction),
      node_place_(static_cast<std::size_t>(node_count), -1),
      held_(std::move(held)) {}

template <class S>
void ImpulseSolver<S>::begin_rows() {
  rows_.clear();
  pairs_.clear();
  nodes_.clear();
  node_.clear();
  last_entry_.clear();
}

template <class S>
void ImpulseSolver<S>::add_row(std::int32_t first, std::int32_t second, const Vec3<double>& direction, double depth,
                               double size) {
  ImpulseRow& row = rows_.emplace_back();
  row.direction[0] = direction.x;
  row.direction[1] = direction.y;
  row.direction[2] = direction.z;
  Pair& pair = pairs_.emplace_back();
  pair.depth = depth;
  pair.size = size;
  pair.memory.first = first;
  pair.memory.second = second;
  const auto before = std::lower_bound(memory_.begin(), memory_.end(), pair.memory, PairMemory::earlier);
  if (before != memory_.end() && !PairMemory::earlier(pair.memory, *before)) pair.memory = *before;
}

template <class S>
void ImpulseSolver<S>::finish_rows(const SurfaceSource<S>& source, double dt) {
  for (const std::int32_t n : node_) node_place_[n] = -1;
  for (std::size_t i = 0; i < rows_.size(); ++i) limit_depth(source, i, dt);
}

/// The depth of a pair grows by approach alone. Erosion exposes a face deep inside another body, a distorted element
/// turns another face to its partner: such depths are not pushed out.
template <class S>
void ImpulseSolver<S>::limit_depth(const SurfaceSource<S>& source, std::size_t i, double dt) {
  const ImpulseRow& row = rows_[i];
  Pair& pair = pairs_[i];
  pair.rate_before = 0;
  for (int k = 0; k < row.nodes; ++k) {
    // By place: with a pointer to the record GCC contracts these sums otherwise, and results change in their last bits.
    const auto place = 4 * static_cast<std::size_t>(node_[row.node[k]]);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto v = static_cast<double>(source.velocity[place + c]);
      pair.rate_before += row.weight[k] * row.direction[c] * v;
      if (has_friction()) pair.sliding_before[c] += row.weight[k] * v;
    }
  }
  for (int c = 0; c < 3; ++c) pair.sliding_before[c] -= pair.rate_before * row.direction[c];
  if (pair.depth > 0) pair.depth = std::min(pair.depth, pair.memory.depth + std::max(0.0, pair.rate_before) * dt);
  pair.memory.depth = std::max(0.0, pair.depth);
}

/// Velocities v* and what held directions leave of the inverse masses.
template <class S>
void ImpulseSolver<S>::load_nodes(const SurfaceSource<S>& source, double velocity_step) {
  nodes_.assign(node_.size(), {});
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::int32_t n = node_[i];
    const auto m = static_cast<double>(source.inverse_mass[n]);
    double* a = nodes_[i].inverse_mass;
    a[0] = a[1] = a[2] = m;
    for (const auto& [x, y, z] : held_.of(node_[i])) {
      a[0] -= m * x * x;
      a[1] -= m * y * y;
      a[2] -= m * z * z;
      a[3] -= m * x * y;
      a[4] -= m * y * z;
      a[5] -= m * z * x;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      nodes_[i].velocity[c] =
          static_cast<double>(source.v(n)[c]) + velocity_step * m * static_cast<double>(source.f(n)[c]);
    }
  }
}

/// Rows that nothing drives together only cost time.
template <class S>
void ImpulseSolver<S>::drop_rows_apart() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Pair& pair = pairs_[i];
    const bool known = pair.memory.force > 0 || pair.depth > 0;
    const bool near = known || pair.rate_free + rows_[i].position_rate > -std::abs(pair.rate_free);
    if (!near || !(rows_[i].inverse_mass > 0)) continue;
    rows_[kept] = rows_[i];
    pairs_[kept++] = pair;
  }
  rows_.resize(kept);
  pairs_.resize(kept);
}

/// Begins with the friction of the step before, turned into the plane across the direction of now.
template <class S>
void ImpulseSolver<S>::begin_friction(double velocity_step) {
  if (!has_friction()) return;
  frictions_.assign(rows_.size(), {});
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const double *a = rows_[i].direction, *before = pairs_[i].memory.friction;
    const double along = a[0] * before[0] + a[1] * before[1] + a[2] * before[2];
    for (int c = 0; c < 3; ++c) frictions_[i].impulse[c] = velocity_step * (before[c] - along * a[c]);
    frictions_[i].inverse_mass = friction_inverse_mass(rows_[i], nodes_.data());
    frictions_[i].coefficient = pairs_[i].memory.slides ? friction_sliding_ : friction_at_rest_;
  }
}

template <class S>
void ImpulseSolver<S>::solve_coupled() {
  double scale = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    scale = std::max({scale, pairs_[i].rate_free + rows_[i].position_rate, pairs_[i].rate_before});
    apply_impulse(rows_[i], rows_[i].impulse, nodes_.data());  // begin with those of the step before
    if (!has_friction()) continue;
    apply_friction(rows_[i], frictions_[i].impulse, nodes_.data());
    const double* s = pairs_[i].sliding_before;
    scale = std::max(scale, std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]));
  }
  const auto count = static_cast<std::int64_t>(rows_.size());
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    const double change = has_friction() ? gauss_seidel_sweep(rows_.data(), frictions_.data(), count, nodes_.data())
                                         : gauss_seidel_sweep(rows_.data(), count, nodes_.data());
    if (change <= tolerance * scale) break;
  }
}

/// Friction after a projection: that of the step before, as corrected by each row in turn.
template <class S>
void ImpulseSolver<S>::slow_sliding() {
  for (std::size_t i = 0; i < frictions_.size(); ++i) apply_friction(rows_[i], frictions_[i].impulse, nodes_.data());
  for (std::size_t i = 0; i < frictions_.size(); ++i) update_friction(rows_[i], frictions_[i], nodes_.data());
}

template <class S>
void ImpulseSolver<S>::release(double velocity_step) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    ImpulseRow& row = rows_[i];
    Pair& pair = pairs_[i];
    if (!(pair.memory.force > 0) || row.impulse > 0 || pair.rate_free + row.position_rate > 0) continue;
    // Largest p for which 1/2 p (rate_before + rate - p inverse_mass) >= -lost.
    const double sum = pair.rate_before + closing_rate(row, nodes_.data());
    const double root = std::sqrt(sum * sum + 8 * std::max(0.0, pair.memory.lost) * row.inverse_mass);
    const double missing = std::min(0.5 * pair.memory.force * velocity_step, (sum + root) / (2 * row.inverse_mass));
    if (!(missing > 0)) continue;
    apply_impulse(row, missing, nodes_.data());
    row.impulse = missing;
    pair.memory.force = -1;  // so that it does not count as a contact at the next step
  }
}

/// What each row may still close or has to push out, and its closing velocity without impulses.
template <class S>
void ImpulseSolver<S>::set_rates(double velocity_step, double dt) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    ImpulseRow& row = rows_[i];
    Pair& pair = pairs_[i];
    load_masses(row, nodes_.data());
    if (dt > 0 && pair.depth > 0) {  // with no more energy than the pair has taken out
      const double energy_limit = std::sqrt(2 * std::max(0.0, pair.memory.lost) * row.inverse_mass);
      row.position_rate = std::min(push_out * pair.depth / dt, energy_limit);
    } else if (dt > 0) {
      row.position_rate = pair.depth / dt;
    } else {  // nothing moves any more: an open gap asks for nothing
      row.position_rate = pair.depth < -1e-9 * pair.size ? -std::numeric_limits<double>::infinity() : 0.0;
    }
    pair.rate_free = closing_rate(row, nodes_.data());
    row.impulse = std::max(0.0, pair.memory.force) * velocity_step;
  }
}

template <class S>
ImpulseResult ImpulseSolver<S>::solve(const SurfaceSource<S>& source, const StepLengths& step) {
  ImpulseResult result;
  result.dissipated = pending_;
  pending_ = 0;
  const double velocity_step = step.velocity();
  if (velocity_step == 0) {
    rows_.clear();
    pairs_.clear();
  }
  for (const Pair& pair : pairs_) {
    result.penetration_ratio = std::max(result.penetration_ratio, pair.depth / pair.size);
  }
  load_nodes(source, velocity_step);
  set_rates(velocity_step, step.after);
  drop_rows_apart();
  begin_friction(velocity_step);
  if (lagrange_) {
    solve_coupled();
  } else {
    project_velocities(rows_.data(), static_cast<std::int64_t>(rows_.size()), nodes_.data());
    slow_sliding();
  }
  release(velocity_step);

  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const ImpulseRow& row = rows_[i];
    Pair& pair = pairs_[i];
    pair.force = row.impulse / velocity_step;
    const ExternalWork lost = work_of(pair.force, pair.rate_before, closing_rate(row, nodes_.data()), step);
    result.dissipated += lost.now;
    pending_ += lost.later;
    result.pairs += pair.force > 0;
    pair.memory.lost += lost.now + lost.later;
    pair.memory.force = pair.memory.force < 0 ? 0 : pair.force;
    if (has_friction()) count_friction(i, step, result);
    if (!(pair.force > 0)) continue;
    for (int k = 0; k < row.nodes; ++k) {
      S* const force = source.f(node_[row.node[k]]);
      for (int c = 0; c < 3; ++c) force[c] -= static_cast<S>(pair.force * row.weight[k] * row.direction[c]);
      if (!has_friction()) continue;
      for (int c = 0; c < 3; ++c) force[c] -= static_cast<S>(row.weight[k] * pair.memory.friction[c]);
    }
  }
  remember();
  return result;
}

/// Force of the friction of a row, and its work.
template <class S>
void ImpulseSolver<S>::count_friction(std::size_t i, const StepLengths& step, ImpulseResult& result) {
  Pair& pair = pairs_[i];
  double after[3];
  sliding_rate(rows_[i], nodes_.data(), after);
  const double speed = std::sqrt(after[0] * after[0] + after[1] * after[1] + after[2] * after[2]);
  const FrictionRow& friction = frictions_[i];
  pair.memory.slides = speed > sliding * friction.coefficient * rows_[i].impulse * friction.inverse_mass;
  for (int c = 0; c < 3; ++c) {
    pair.memory.friction[c] = frictions_[i].impulse[c] / step.velocity();
    const ExternalWork lost = work_of(pair.memory.friction[c], pair.sliding_before[c], after[c], step);
    result.dissipated += lost.now;
    pending_ += lost.later;
  }
}

template <class S>
void ImpulseSolver<S>::add_node_forces(std::vector<Point>& node_force) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const ImpulseRow& row = rows_[i];
    for (int k = 0; k < row.nodes; ++k) {
      Point& force = node_force[node_[row.node[k]]];
      for (std::size_t c = 0; c < 3; ++c) {
        force[c] -= row.weight[k] * (pairs_[i].force * row.direction[c] + pairs_[i].memory.friction[c]);
      }
    }
  }
}

/// Rows, their pairs and nodes are for the report of forces alone.
template <class S>
void ImpulseSolver<S>::persist(StateArchive& archive, const SurfaceSource<S>& source) {
  archive(memory_, pending_, rows_, pairs_, node_);
  if (archive.reads()) node_place_.assign(static_cast<std::size_t>(source.node_count), -1);
}

template <class S>
void ImpulseSolver<S>::remember() {
  memory_.clear();
  for (const Pair& pair : pairs_) {
    if (pair.memory.force > 0 || pair.memory.depth > 0) memory_.push_back(pair.memory);
  }
  std::sort(memory_.begin(), memory_.end(), PairMemory::earlier);
}

template <class S>
std::size_t ImpulseSolver<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return of(rows_) + of(frictions_) + of(pairs_) + of(nodes_) + of(node_) + of(last_entry_) + of(memory_) +
         of(node_place_) + held_.bytes();
}

template class ImpulseSolver<double>;
template class ImpulseSolver<float>;

}  // namespace pinball

#include "equations.hpp"

#include <fmt/core.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/base/records.hpp>

namespace pinball {

namespace {

/// Of equations with nodes in common: as dense a matrix takes 30 MB, and a solution of them some milliseconds.
constexpr std::size_t most_in_common = 2000;

/// Of what the diagonal would be were nothing held: a smaller pivot is that of an equation which others contain.
constexpr double zero_pivot = 1e-9;

/// Of the sizes of the terms: a larger sum is no round-off.
constexpr double not_kept = 1e-5;
/// Of the largest velocity of all nodes of equations: what is smaller is what sums of this precision are rounded by.
template <class S>
constexpr double rounded_off = std::is_same_v<S, float> ? 1e-5 : 1e-11;

Point times(const std::array<Point, 3>& matrix, const Point& x) {
  return {dot(matrix[0], x), dot(matrix[1], x), dot(matrix[2], x)};
}

}  // namespace

template <class S>
struct Equations<S>::Factor {
  Eigen::MatrixXd lower;  ///< L, its lower triangle
};

template <class S>
Equations<S>::Equations(const Model<S>& model) {
  const std::vector<EquationRow> rows = equation_rows(model);
  if (rows.empty()) return;
  for (const EquationRow& row : rows) {
    for (const EquationPart& part : row.parts) nodes_.push_back(part.node);
  }
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  for (const EquationRow& row : rows) {
    const std::int32_t first = parts_.size();
    for (const EquationPart& part : row.parts) {
      const std::int32_t at = std::ranges::lower_bound(nodes_, part.node) - nodes_.begin();
      parts_.push_back({at, part.coefficient});
    }
    const std::int32_t last = parts_.size();
    rows_.push_back({first, last});
    where_.push_back(row.where);
  }
  take_masses(model);
  take_held_directions(model);
}

template <class S>
bool Equations<S>::take_masses(const Model<S>& model) {
  std::vector<double> now;
  for (const std::int32_t n : nodes_) now.push_back(model.nodes.inverse_mass[n]);
  return std::exchange(inverse_mass_, now) != now;
}

template <class S>
void Equations<S>::take_held_directions(const Model<S>& model) {
  if (!any()) return;
  free_.assign(nodes_.size(), {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  const auto take = [this](const auto& held) {
    for (const auto& one : held) {
      const auto found = std::ranges::lower_bound(nodes_, one.node);
      if (found == nodes_.end() || *found != one.node) continue;
      Point d{one.normal[0], one.normal[1], one.normal[2]};  // of unit length in single precision
      const double size = std::sqrt(dot(d, d));
      std::array<Point, 3>& free = free_[found - nodes_.begin()];
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) free[i][k] -= d[i] / size * (d[k] / size);
      }
    }
  };
  take(model.constraints);
  take(model.prescribed);
  find_groups();
}

/// Entry of the matrix of two rows, apart from h.
template <class S>
double Equations<S>::common(std::int32_t one, std::int32_t other) const {
  double sum = 0;
  for (std::int32_t i = rows_[one].first; i < rows_[one].last; ++i) {
    for (std::int32_t j = rows_[other].first; j < rows_[other].last; ++j) {
      const Part &a = parts_[i], &b = parts_[j];
      if (a.at == b.at) sum += inverse_mass_[a.at] * dot(a.coefficient, times(free_[a.at], b.coefficient));
    }
  }
  return sum;
}

/// Rows are together that act on each other, by however many others; in the order of the first of them.
template <class S>
void Equations<S>::find_groups() {
  std::vector<std::int32_t> leader(rows_.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&leader](std::int32_t row) {
    while (leader[row] != row) row = leader[row] = leader[leader[row]];
    return row;
  };
  std::vector<std::vector<std::int32_t>> rows_of(nodes_.size());
  for (std::int32_t row = 0; row < std::ssize(rows_); ++row) {
    for (std::int32_t i = rows_[row].first; i < rows_[row].last; ++i) rows_of[parts_[i].at].push_back(row);
  }
  for (const std::vector<std::int32_t>& rows : rows_of) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = i + 1; j < rows.size(); ++j) {
        const std::int32_t a = find(rows[i]), b = find(rows[j]);
        if (a != b && common(rows[i], rows[j]) != 0) leader[std::max(a, b)] = std::min(a, b);
      }
    }
  }
  groups_.clear();
  std::vector<std::int32_t> group_of(rows_.size(), -1);
  for (std::int32_t row = 0; row < std::ssize(rows_); ++row) {
    std::int32_t& group = group_of[find(row)];
    if (group < 0) {
      group = groups_.size();
      groups_.emplace_back();
    }
    groups_[group].rows.push_back(row);
    if (groups_[group].rows.size() > most_in_common) {
      throw InputError(fmt::format("{}: more than {} equations have nodes in common, which are solved together",
                                   where_[row], most_in_common));
    }
  }
  left_out_.clear();
  for (Group& group : groups_) factorize(group);
}

/// Diagonal of the matrix, apart from h, were nothing held.
template <class S>
double Equations<S>::were_it_free(std::int32_t row) const {
  double sum = 0;
  for (std::int32_t p = rows_[row].first; p < rows_[row].last; ++p)
    sum += inverse_mass_[parts_[p].at] * dot(parts_[p].coefficient, parts_[p].coefficient);
  return sum;
}

/// Row by row, for whether one is left out follows from those before it: Eigen's own factorizations take the largest
/// pivots first, or none of zero.
template <class S>
void Equations<S>::factorize(Group& group) {
  const std::vector<std::int32_t> all = std::exchange(group.rows, {});
  const auto most = static_cast<Eigen::Index>(all.size());
  Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(most, most);
  Eigen::Index count = 0;
  for (const std::int32_t row : all) {
    Eigen::VectorXd beside(count);
    for (Eigen::Index k = 0; k < count; ++k) beside[k] = common(row, group.rows[k]);
    lower.topLeftCorner(count, count).template triangularView<Eigen::Lower>().solveInPlace(beside);
    const double pivot = common(row, row) - beside.squaredNorm();
    if (!(pivot > zero_pivot * were_it_free(row))) {
      left_out_.push_back(row);
      continue;
    }
    lower.row(count).head(count) = beside.transpose();
    lower(count, count) = std::sqrt(pivot);
    group.rows.push_back(row);
    ++count;
  }
  lower.conservativeResize(count, count);
  group.factor = std::make_shared<const Factor>(Factor{std::move(lower)});
}

/// Impulses per node that take from these velocities what the equations do not allow.
template <class S>
std::vector<Point> Equations<S>::changes(const std::vector<Point>& velocity) const {
  std::vector<Point> impulse(nodes_.size(), Point{});
  for (const Group& group : groups_) {
    const auto count = static_cast<Eigen::Index>(group.rows.size());
    Eigen::VectorXd x = Eigen::VectorXd::Zero(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Row& of = rows_[group.rows[i]];
      for (std::int32_t p = of.first; p < of.last; ++p) x[i] -= dot(parts_[p].coefficient, velocity[parts_[p].at]);
    }
    const auto lower = group.factor->lower.template triangularView<Eigen::Lower>();
    lower.solveInPlace(x);
    lower.transpose().solveInPlace(x);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Row& of = rows_[group.rows[i]];
      for (std::int32_t p = of.first; p < of.last; ++p) {
        for (std::size_t k = 0; k < 3; ++k) impulse[parts_[p].at][k] += x[i] * parts_[p].coefficient[k];
      }
    }
  }
  return impulse;
}

template <class S>
double Equations<S>::leap(const Model<S>& model) const {
  std::vector<Point> velocity;
  for (const std::int32_t n : nodes_) {
    const S* const v = record(model.nodes.velocity.data(), n);
    velocity.push_back({v[0], v[1], v[2]});
  }
  double largest = 0;
  const std::vector<Point> impulse = changes(velocity);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Point change = times(free_[i], impulse[i]);
    largest = std::max(largest, inverse_mass_[i] * std::sqrt(dot(change, change)));
  }
  return largest;
}

/// Of the rows that have been left out: others decide on them, or what holds and moves nodes.
template <class S>
void Equations<S>::require_kept(const std::vector<Point>& velocity, double fastest) const {
  for (const std::int32_t row : left_out_) {
    double sum = 0, size = 0, most = 0;
    for (std::int32_t p = rows_[row].first; p < rows_[row].last; ++p) {
      const Point& v = velocity[parts_[p].at];
      for (std::size_t k = 0; k < 3; ++k) {
        sum += parts_[p].coefficient[k] * v[k];
        size += std::abs(parts_[p].coefficient[k] * v[k]);
        most += std::abs(parts_[p].coefficient[k]) * fastest;
      }
    }
    if (std::abs(sum) > std::max(not_kept * size, rounded_off<S> * most)) {
      throw RunError(
          fmt::format("{}: the equation cannot hold, for other equations, constraints and prescribed "
                      "velocities say of all its nodes how they move: leave one of these out",
                      where_[row]));
    }
  }
}

template <class S>
void Equations<S>::add_forces(Model<S>& model, const StepLengths& step) {
  done_ += last_.now + last_.later;
  last_ = {};
  const double h = step.velocity();
  if (!(h > 0)) return;
  if (take_masses(model)) find_groups();
  std::vector<Point> velocity;
  double fastest = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const S *const v = record(model.nodes.velocity.data(), nodes_[i]), *const f =
                                                                           record(model.nodes.force.data(), nodes_[i]);
    Point& then = velocity.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) then[k] = v[k] + h * inverse_mass_[i] * f[k];
    fastest = std::max(fastest, norm(then));
  }
  const std::vector<Point> impulse = changes(velocity);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const S* const v = record(model.nodes.velocity.data(), nodes_[i]);
    S* const f = record(model.nodes.force.data(), nodes_[i]);
    const Point change = times(free_[i], impulse[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      velocity[i][k] += inverse_mass_[i] * change[k];
      const double force = impulse[i][k] / h;
      last_.join(work_of(force, static_cast<double>(v[k]), velocity[i][k], step));
      f[k] = static_cast<S>(f[k] + force);
    }
  }
  require_kept(velocity, fastest);
}

template <class S>
void Equations<S>::keep_forces(const Model<S>& model) {
  kept_force_.clear();
  for (const std::int32_t n : nodes_) {
    const S* const f = record(model.nodes.force.data(), n);
    kept_force_.push_back({f[0], f[1], f[2]});
  }
}

/// What is held takes up what acts on it.
template <class S>
void Equations<S>::require_kept_forces(const Model<S>& model, const StepLengths& step) const {
  const double h = step.velocity();
  if (!(h > 0)) return;
  std::vector<Point> change;  // of velocities
  double fastest = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const S *const v = record(model.nodes.velocity.data(), nodes_[i]), *const f =
                                                                           record(model.nodes.force.data(), nodes_[i]);
    const double share = h * inverse_mass_[i];
    Point of_node{}, then{};
    for (std::size_t k = 0; k < 3; ++k) {
      of_node[k] = share * (f[k] - kept_force_[i][k]);
      then[k] = v[k] + share * f[k];
    }
    change.push_back(times(free_[i], of_node));
    fastest = std::max({fastest, dot(then, then), dot(change.back(), change.back())});
  }
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    double sum = 0, size = 0;
    for (std::int32_t p = rows_[row].first; p < rows_[row].last; ++p) {
      sum += dot(parts_[p].coefficient, change[parts_[p].at]);
      size += std::sqrt(dot(parts_[p].coefficient, parts_[p].coefficient));
    }
    if (std::abs(sum) > not_kept * size * std::sqrt(fastest)) {
      throw RunError(fmt::format(
          "{}: contact by impulses, or a rigid wall, pushes nodes of the equation otherwise than it allows: "
          "expected that they touch nothing, or contact.enforcement = \"penalty\" and walls without them",
          where_[row]));
    }
  }
}

template <class S>
std::size_t Equations<S>::bytes() const {
  std::size_t sum = rows_.capacity() * sizeof(Row) + parts_.capacity() * sizeof(Part) +
                    nodes_.capacity() * sizeof(nodes_[0]) + inverse_mass_.capacity() * sizeof(double) +
                    free_.capacity() * sizeof(free_[0]) + kept_force_.capacity() * sizeof(kept_force_[0]);
  for (const Group& group : groups_) {
    sum += group.rows.capacity() * sizeof(group.rows[0]) + group.factor->lower.size() * sizeof(double);
  }
  return sum;
}

template class Equations<double>;
template class Equations<float>;

}  // namespace pinball

#pragma once

#include <cstdint>
#include <vector>

#include <solver/base/records.hpp>
#include <solver/contact/impulses/impulse_iterations.hpp>
#include <solver/contact/impulses/row_system.hpp>

namespace pinball::test {

/// A contact system by itself: nodes, rows, and their solution.
struct ImpulseSystem {
  std::vector<ImpulseNode> nodes;
  Array<double> velocities;
  ContactRows rows;
  std::vector<FrictionRow> frictions;
  RowSystem system;
  ImpulseIterations iterations;

  /// held: along y.
  void add_node(const Vec3<double>& v, double inverse_mass, bool held) {
    nodes.push_back({{inverse_mass, held ? 0.0 : inverse_mass, inverse_mass}, held});
    for (const double c : {v.x, v.y, v.z, 0.0}) given_.push_back(c);
  }
  void add_row(const Vec3<double>& direction, double rate) {
    rows.rows.push_back({{direction.x, direction.y, direction.z}, rows.node.size(), 0, rate});
  }
  void add_entry(int node, double weight) {
    rows.node.push_back(node);
    rows.weight.push_back(weight);
    ++rows.rows.back().nodes;
  }
  /// With friction unless mu is negative.
  void build(double mu = -1) {
    velocities.renew(given_.size());
    std::copy(given_.begin(), given_.end(), velocities.data());
    std::vector<std::int32_t> all;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      ImpulseRow& row = rows.rows[i];
      all.push_back(static_cast<std::int32_t>(i));
      row.inverse_mass = 0;
      FrictionRow friction{{0, 0, 0}, 0, mu};
      for (int k = 0; k < row.nodes; ++k) {
        const ImpulseNode& node = nodes[static_cast<std::size_t>(rows[i].node[k])];
        const double *m = node.inverse_mass, *a = row.direction, w2 = rows[i].weight[k] * rows[i].weight[k];
        row.inverse_mass += w2 * (m[0] * a[0] * a[0] + m[1] * a[1] * a[1] + m[2] * a[2] * a[2]);
        friction.inverse_mass += w2 * friction_mobility(node);
      }
      if (mu >= 0) frictions.push_back(friction);
    }
    system.build(rows, all, nodes, frictions);
    iterations.reset(system);
    for (std::int32_t k = 0; k < system.size(); ++k) {
      RowSystem::Row& row = system.row(k);
      row.scale = std::abs(row.rate + dot(row.direction, system.approach(k, velocities.data())));
      const ImpulseRow& added = rows.rows[static_cast<std::size_t>(system.original(k))];
      iterations.set_impulse(k, added.impulse * vector_of(added.direction));
    }
  }
  ImpulseIterations::Result solve() { return iterations.solve(system, velocities.data()); }

  const double* velocity(std::int64_t node) const {
    return record(velocities.empty() ? given_.data() : velocities.data(), node);
  }
  Vec3<double> momentum() const {
    Vec3<double> sum{0, 0, 0};
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      sum = sum + 1 / nodes[n].inverse_mass[0] * vector_of(velocity(static_cast<std::int64_t>(n)));
    }
    return sum;
  }
  double kinetic_energy() const {
    double sum = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const Vec3<double> v = vector_of(velocity(static_cast<std::int64_t>(n)));
      sum += 0.5 / nodes[n].inverse_mass[0] * dot(v, v);
    }
    return sum;
  }
  /// p of a row, by its number as it was added.
  double impulse(std::size_t row) const {
    const std::int32_t k = number_of(row);
    return system.impulse_as_added(k, iterations.impulse(k));
  }
  Vec3<double> friction(std::size_t row) const {
    const std::int32_t k = number_of(row);
    return iterations.impulse(k) - impulse(row) * vector_of(rows.rows[row].direction);
  }
  /// What still drives a row, with its compliance: zero where it is free, along q where it slides.
  Vec3<double> drive(std::size_t row) const {
    constexpr double e = ImpulseIterations::softness;
    const std::int32_t k = number_of(row);
    const RowSystem::Row& of = system.row(k);
    const Vec3<double> b = iterations.impulse(k), along = dot(of.direction, b) * of.direction;
    return e * (system.approach(k, given_.data()) - of.sum_along * along - of.sum_across * (b - along)) +
           (1 - e) * system.approach(k, velocities.data()) + of.rate * of.direction;
  }
  /// s of a row along its direction.
  double closing(std::size_t row) const {
    const std::int32_t k = number_of(row);
    return dot(system.row(k).direction, system.approach(k, velocities.data()));
  }

 private:
  std::int32_t number_of(std::size_t row) const {
    for (std::int32_t k = 0; k < system.size(); ++k) {
      if (system.original(k) == static_cast<std::int32_t>(row)) return k;
    }
    return -1;
  }
  std::vector<double> given_;
};

}  // namespace pinball::test

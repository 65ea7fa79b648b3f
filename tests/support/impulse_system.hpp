#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <solver/base/records.hpp>
#include <solver/contact/impulses/row_packs.hpp>

namespace pinball::test {

/// A contact system by itself: nodes, rows, and the packs of the rows.
struct ImpulseSystem {
  std::vector<ImpulseNode> nodes;
  Array<double> velocities;
  ContactRows rows;
  std::vector<FrictionRow> frictions;
  RowPacks packs;

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
  /// With friction unless mu is negative; width: rows to a pack.
  void build(double mu = -1, int width = RowPacks::widest) {
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
    packs.build(rows, all, nodes, frictions, width);
  }

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
  double impulse(std::size_t row) const {
    const auto [pack, lane] = place_of(row);
    return packs.impulse(pack, lane);
  }
  Vec3<double> friction(std::size_t row) const {
    const auto [pack, lane] = place_of(row);
    return packs.friction(pack, lane);
  }
  /// Pack and lane of a row.
  std::pair<std::int64_t, int> place_of(std::size_t row) const {
    for (std::size_t pack = 0; pack < packs.order().packs().size(); ++pack) {
      for (int lane = 0; lane < packs.width(); ++lane) {
        if (packs.order().row(static_cast<std::int64_t>(pack), lane) == static_cast<std::int32_t>(row)) {
          return {static_cast<std::int64_t>(pack), lane};
        }
      }
    }
    return {-1, -1};
  }

 private:
  std::vector<double> given_;
};

}  // namespace pinball::test

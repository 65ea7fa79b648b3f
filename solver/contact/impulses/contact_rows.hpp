#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pinball {

/// A row of the contact matrix, but for its nodes (kernels/contact_row.hpp).
struct ImpulseRow {
  double direction[3];       ///< a, from body 2 to body 1
  std::size_t first;         ///< of its entries
  std::int32_t nodes;        ///< number of its entries
  double position_rate = 0;  ///< r [length/time]
  double inverse_mass = 0;   ///< G M^-1 G^T [1/mass]
  double impulse = 0;        ///< p [mass length/time]
};

/// What friction adds to a row.
struct FrictionRow {
  double impulse[3];    ///< q [mass length/time]
  double inverse_mass;  ///< G M^-1 G^T across a, from above [1/mass]
  double coefficient;   ///< mu [-]
  bool rubs = true;     ///< whether it may; else it is solved as if there were no friction, where all others are, too
};

/// A row with its entries.
struct RowView {
  const double* direction;
  int nodes;
  const std::int32_t* node;  ///< places of the nodes
  const double* weight;      ///< w: negative for the nodes of body 1
};

/// Rows with as many entries each as they have nodes, one row after the other.
struct ContactRows {
  std::vector<ImpulseRow> rows;
  std::vector<std::int32_t> node;  ///< per entry
  std::vector<double> weight;      ///< per entry

  RowView operator[](std::size_t i) const {
    const ImpulseRow& row = rows[i];
    return {row.direction, row.nodes, node.data() + row.first, weight.data() + row.first};
  }
  std::size_t size() const { return rows.size(); }
  void clear() {
    rows.clear();
    node.clear();
    weight.clear();
  }
  std::size_t bytes() const {
    return rows.capacity() * sizeof(rows[0]) + node.capacity() * sizeof(node[0]) +
           weight.capacity() * sizeof(weight[0]);
  }
};

}  // namespace pinball

#pragma once

#include <cstdint>

#include "macros.hpp"
#include "simd.hpp"

/// Contact constraints enforced by impulses: find p >= 0 such that
///
///     u_i = sum_I G_iI . v_I + r_i <= 0 ,   p_i >= 0 ,   p_i u_i = 0 ,     v_I = v*_I - sum_i M_I^-1 G_iI p_i ,
///
/// G_iI = w_iI a_i (contact_row.hpp). r_i: the rate at which an open gap may still close (negative) or a penetration is
/// to be pushed out (positive). M_I^-1 is a tensor: a constraint leaves its node no mobility along its direction.
///
/// v is unique: it is the nearest to v* in the norm of the mass among those that close no gap. p is not where more rows
/// meet than nodes can follow, as in any flat contact; the sweeps below do not mind.
namespace pinball {

/// Vectors that the sweeps work on have a fourth component of 0: so they fill whole registers.
inline constexpr int vector_width = native_width<double> < 4 ? native_width<double> : 4;
using VectorRegister = Pack<double, vector_width>;

struct ImpulseNode {
  alignas(32) double velocity[4];
  double inverse_mass[6];  ///< xx yy zz xy yz zx [1/mass]
  double row_share;        ///< scratch: sum of |w| over the rows that close
};

struct ImpulseRow {
  std::int32_t node[16];
  double weight[16];  ///< w: negative for the nodes of body 1
  int nodes;
  alignas(32) double direction[4];  ///< a
  double position_rate;             ///< r [length/time]
  double inverse_mass;              ///< G M^-1 G^T [1/mass]
  double impulse;                   ///< p; where the sweeps begin
  alignas(32) double push[16][4];   ///< w M^-1 a: what a unit impulse takes from the velocity of each node [1/mass]
};

/// M_I^-1 times a vector.
PINBALL_FUNCTION void mobility(const ImpulseNode& node, const double* b, double (&result)[3]) {
  const double* a = node.inverse_mass;
  result[0] = a[0] * b[0] + a[3] * b[1] + a[5] * b[2];
  result[1] = a[3] * b[0] + a[1] * b[1] + a[4] * b[2];
  result[2] = a[5] * b[0] + a[4] * b[1] + a[2] * b[2];
}

/// sum_I G_I . v_I at the present velocities, or at others of the same nodes.
PINBALL_FUNCTION double closing_rate(const ImpulseRow& row, const ImpulseNode* nodes) {
  double rate = 0;
  for (int c = 0; c < 4; c += vector_width) {
    VectorRegister even = 0, odd = 0;  // two sums, because each addition waits for the one before
    int k = 0;
    for (; k + 1 < row.nodes; k += 2) {
      even += row.weight[k] * load<VectorRegister>(nodes[row.node[k]].velocity + c);
      odd += row.weight[k + 1] * load<VectorRegister>(nodes[row.node[k + 1]].velocity + c);
    }
    if (k < row.nodes) even += row.weight[k] * load<VectorRegister>(nodes[row.node[k]].velocity + c);
    add_lanes_to(rate, (even + odd) * load<VectorRegister>(row.direction + c));
  }
  return rate;
}

PINBALL_FUNCTION void apply_impulse(const ImpulseRow& row, double impulse, ImpulseNode* nodes) {
  for (int k = 0; k < row.nodes; ++k) {
    double* v = nodes[row.node[k]].velocity;
    for (int c = 0; c < 4; c += vector_width) {
      store(load<VectorRegister>(v + c) - impulse * load<VectorRegister>(row.push[k] + c), v + c);
    }
  }
}

/// Fills in what a row needs of the masses of its nodes: push, and the diagonal of G M^-1 G^T.
PINBALL_FUNCTION void load_masses(ImpulseRow& row, const ImpulseNode* nodes) {
  row.inverse_mass = 0;
  row.direction[3] = 0;
  for (int k = 0; k < row.nodes; ++k) {
    double change[3];
    mobility(nodes[row.node[k]], row.direction, change);
    double along = 0;
    for (int c = 0; c < 3; ++c) {
      row.push[k][c] = row.weight[k] * change[c];
      along += row.push[k][c] * row.direction[c];
    }
    row.push[k][3] = 0;
    row.inverse_mass += row.weight[k] * along;
  }
}

/// One projected Gauss-Seidel sweep: each row in turn closes no gap any more. Returns the largest change of a closing
/// velocity; repeated until that is small, the sweeps solve the coupled system.
PINBALL_FUNCTION double gauss_seidel_sweep(ImpulseRow* rows, std::int64_t count, ImpulseNode* nodes) {
  double largest = 0;
  for (std::int64_t i = 0; i < count; ++i) {
    ImpulseRow& row = rows[i];
    const double closing = closing_rate(row, nodes) + row.position_rate;
    const double impulse = maximum(0.0, row.impulse + closing / row.inverse_mass);
    const double change = impulse - row.impulse;
    if (change == 0) continue;
    apply_impulse(row, change, nodes);
    row.impulse = impulse;
    largest = maximum(largest, absolute(change) * row.inverse_mass);
  }
  return largest;
}

/// Velocity projection: all rows see the same velocities, and each gives the share of its impulse that keeps their sum
/// from overshooting (a Jacobi sweep with |G M^-1 G^T| summed over the row, bounded node by node, in the place of the
/// diagonal). Exact where neighbours close alike; takes out energy, never adds it (but for r).
PINBALL_FUNCTION void project_velocities(ImpulseRow* rows, std::int64_t count, ImpulseNode* nodes) {
  for (std::int64_t i = 0; i < count; ++i) {
    ImpulseRow& row = rows[i];
    row.impulse = maximum(0.0, closing_rate(row, nodes) + row.position_rate);  // for now: its closing velocity
    if (!(row.impulse > 0)) continue;
    for (int k = 0; k < row.nodes; ++k) nodes[row.node[k]].row_share += absolute(row.weight[k]);
  }
  for (std::int64_t i = 0; i < count; ++i) {
    ImpulseRow& row = rows[i];
    if (!(row.impulse > 0)) continue;
    double sum = 0;
    for (int k = 0; k < row.nodes; ++k) {
      const double* push = row.push[k];
      const double length = square_root(push[0] * push[0] + push[1] * push[1] + push[2] * push[2]);
      sum += nodes[row.node[k]].row_share * length;
    }
    row.impulse /= sum;
  }
  for (std::int64_t i = 0; i < count; ++i) {
    if (rows[i].impulse > 0) apply_impulse(rows[i], rows[i].impulse, nodes);
  }
}

}  // namespace pinball

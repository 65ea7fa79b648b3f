#pragma once

#include <cstdint>

#include "macros.hpp"
#include "record.hpp"
#include "tensor.hpp"

/// Contact constraints enforced by impulses. A row i of the contact matrix has the impulse b_i = p_i a_i + q_i, p_i
/// along its direction a_i and q_i of friction across it (contact_friction.hpp); nodes move with
///
///     v_I = v*_I - M_I^-1 sum_i w_iI b_i ,      s_i = sum_I w_iI v_I       approach of the sides of row i,
///
/// and without friction p >= 0 is sought such that
///
///     u_i = a_i . s_i + r_i <= 0 ,   p_i >= 0 ,   p_i u_i = 0 .
///
/// r_i: the rate at which an open gap may still close (negative) or a penetration is to be pushed out (positive).
/// M_I^-1 is a tensor: a constraint leaves its node no mobility along its direction.
///
/// v is then unique: it is the nearest to v* in the norm of the mass among those that close no gap. p is not where more
/// rows meet than nodes can follow, as in any flat contact. It is made so by a compliance: for A = G M^-1 G^T stands
///
///     (1 - e) A + e D ,      D_i = sum_I |w_iI| (sum_j |w_jI|) a_i . M_I^-1 a_i ,      e = 1e-4 .
///
/// D bounds the row sums of A, so that D - A is never negative, and nothing where neighbours are pressed alike: there,
/// and in a row by itself, gaps close exactly. Impulses that differ from those beside them leave a ten-thousandth of
/// that difference to the next step, and do not wander between rows that hardly differ.
///
/// Whoever solves this works by two kinds of sums, each by one thread in the order in which it is written down: over
/// the nodes of a row, and over the rows of a node. So there is no order among rows, and results are the same bits for
/// any number of threads.
namespace pinball {

/// M^-1 of a node.
struct ImpulseNode {
  double inverse_mass[6];  ///< xx yy zz xy yz zx [1/mass]
  bool held;               ///< in some direction: else the tensor is a number
  std::int32_t body = -1;  ///< number of a rigid body that it moves with, whatever its own mass is; -1: of none
};

/// M^-1 b.
PINBALL_FUNCTION Vec3<double> moved_by(const ImpulseNode& node, const Vec3<double>& b) {
  const double* const m = node.inverse_mass;
  if (!node.held) return m[0] * b;
  return Symmetric<double>{m[0], m[1], m[2], m[3], m[4], m[5]} * b;
}

/// Sum of weight[k] times the record number[k], of `count` terms: s of a row over its nodes, or sum_i w_iI b_i of a
/// node over its rows. records: of four numbers, the fourth unused.
PINBALL_FUNCTION Vec3<double> weighted_sum(int count, const std::int32_t* number, const double* weight,
                                           const double* records) {
  Vec3<double> sum{0, 0, 0};
  for (int k = 0; k < count; ++k) {
    const double* const of = record(records, number[k]);
    sum = sum + weight[k] * Vec3<double>{of[0], of[1], of[2]};
  }
  return sum;
}

}  // namespace pinball

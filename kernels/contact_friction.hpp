#pragma once

#include "contact_impulse.hpp"

/// Coulomb friction on contact constraints. Across the direction a of a row its two sides slide past each other with
///
///     s = (1 - a a^T) sum_I w_I v_I ,      v_I <- v_I - w_I M_I^-1 q      effect of the impulse q across a,
///
/// and q is the impulse that stops the sliding (s = 0), as long as |q| <= mu p; else it is mu p along s. p: the impulse
/// of the row; mu: its coefficient in this step, that of rest or that of sliding as the row was in the step before.
/// (Were it chosen by q within the step, the law would not be monotone, and rows that share nodes would drop to sliding
/// one after the other before their sweeps have found out that together they can hold.)
namespace pinball {

/// What friction adds to an ImpulseRow.
struct FrictionRow {
  double impulse[3];    ///< q
  double inverse_mass;  ///< G M^-1 G^T across a, from above [1/mass]
  double coefficient;   ///< mu [-]
};

/// s at the present velocities.
PINBALL_FUNCTION void sliding_rate(const ImpulseRow& row, const ImpulseNode* nodes, double (&s)[3]) {
  s[0] = s[1] = s[2] = 0;
  for (int k = 0; k < row.nodes; ++k) {
    for (int c = 0; c < 3; ++c) s[c] += row.weight[k] * nodes[row.node[k]].velocity[c];
  }
  const double* a = row.direction;
  const double along = a[0] * s[0] + a[1] * s[1] + a[2] * s[2];
  for (int c = 0; c < 3; ++c) s[c] -= along * a[c];
}

/// A constraint leaves 1/m of a node in some directions and nothing in the others: 1/m is the quotient of the sums of
/// squares and of the diagonal.
PINBALL_FUNCTION double friction_inverse_mass(const ImpulseRow& row, const ImpulseNode* nodes) {
  double sum = 0;
  for (int k = 0; k < row.nodes; ++k) {
    const double* m = nodes[row.node[k]].inverse_mass;
    const double trace = m[0] + m[1] + m[2];
    const double squares = m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + 2 * (m[3] * m[3] + m[4] * m[4] + m[5] * m[5]);
    if (trace > 0) sum += row.weight[k] * row.weight[k] * squares / trace;
  }
  return sum;
}

PINBALL_FUNCTION void apply_friction(const ImpulseRow& row, const double (&impulse)[3], ImpulseNode* nodes) {
  for (int k = 0; k < row.nodes; ++k) {
    ImpulseNode& node = nodes[row.node[k]];
    double change[3];
    mobility(node, impulse, change);
    for (int c = 0; c < 3; ++c) node.velocity[c] -= row.weight[k] * change[c];
  }
}

/// Brings q of a row up to the present velocities and to its p. Returns the change of the sliding velocity.
PINBALL_FUNCTION double update_friction(const ImpulseRow& row, FrictionRow& friction, ImpulseNode* nodes) {
  if (!(friction.inverse_mass > 0)) return 0;
  double s[3], wanted[3], change[3];
  sliding_rate(row, nodes, s);
  double wanted2 = 0, change2 = 0;
  for (int c = 0; c < 3; ++c) {
    wanted[c] = friction.impulse[c] + s[c] / friction.inverse_mass;
    wanted2 += wanted[c] * wanted[c];
  }
  const double size = square_root(wanted2), most = friction.coefficient * row.impulse;
  const double scale = size > most ? most / size : 1.0;
  for (int c = 0; c < 3; ++c) {
    change[c] = scale * wanted[c] - friction.impulse[c];
    friction.impulse[c] += change[c];
    change2 += change[c] * change[c];
  }
  if (!(change2 > 0)) return 0;
  apply_friction(row, change, nodes);
  return square_root(change2) * friction.inverse_mass;
}

/// As gauss_seidel_sweep, of impulses and friction together.
PINBALL_FUNCTION double gauss_seidel_sweep(ImpulseRow* rows, FrictionRow* frictions, std::int64_t count,
                                           ImpulseNode* nodes) {
  double largest = 0;
  for (std::int64_t i = 0; i < count; ++i) {
    largest = maximum(largest, gauss_seidel_sweep(rows + i, 1, nodes));
    largest = maximum(largest, update_friction(rows[i], frictions[i], nodes));
  }
  return largest;
}

}  // namespace pinball

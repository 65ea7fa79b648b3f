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

/// What friction adds to the numbers of a row.
enum FrictionNumber : int {
  friction_impulse = 0,       ///< q, three numbers
  friction_inverse_mass = 3,  ///< G M^-1 G^T across a, from above [1/mass]
  friction_mass,              ///< its inverse; 0 where nothing can move [mass]
  friction_coefficient,       ///< mu [-]
  friction_numbers
};

template <class T>
PINBALL_FUNCTION T friction_number(const RowPack& row, int which) {
  return load<T>(row.friction + which * width_of<T>);
}
template <class T>
PINBALL_FUNCTION Vec3<T> friction_of(const RowPack& row) {
  return {friction_number<T>(row, friction_impulse), friction_number<T>(row, friction_impulse + 1),
          friction_number<T>(row, friction_impulse + 2)};
}

/// s at the present velocities.
template <class T>
PINBALL_FUNCTION Vec3<T> sliding_rate(const RowPack& row, const double* velocity) {
  const Vec3<T> a = direction_of<T>(row), s = approach<T>(row, velocity);
  return s - dot(a, s) * a;
}

/// What a node adds to G M^-1 G^T across a, over w^2. A constraint leaves 1/m of a node in some directions and nothing
/// in the others: 1/m is the quotient of the sums of squares and of the diagonal.
PINBALL_FUNCTION double friction_mobility(const ImpulseNode& node) {
  const double* m = node.inverse_mass;
  const double trace = m[0] + m[1] + m[2];
  const double squares = m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + 2 * (m[3] * m[3] + m[4] * m[4] + m[5] * m[5]);
  return trace > 0 ? squares / trace : 0.0;
}

/// Gives the rows their friction q.
template <class T>
PINBALL_FUNCTION void apply_friction(const RowPack& row, double* velocity) {
  take_impulse(row, friction_of<T>(row), velocity);
}

/// Brings q up to the present velocities and to p. Returns the change of the sliding velocities.
template <class T>
PINBALL_FUNCTION T sweep_friction(const RowPack& row, double* velocity) {
  const T zero(0);
  const T mass = friction_number<T>(row, friction_mass), inverse_mass = friction_number<T>(row, friction_inverse_mass);
  const Vec3<T> before = friction_of<T>(row);
  const Vec3<T> wanted = before + mass * sliding_rate<T>(row, velocity);
  const T size = square_root(dot(wanted, wanted));
  const T most = friction_number<T>(row, friction_coefficient) * row_number<T>(row, row_impulse);
  // size > most ? most / size : 1; nothing where nothing can move
  const T scale = select(size > most, most / select(size > most, size, T(1)), T(1));
  Vec3<T> change = scale * wanted - before;
  const T moves = select(inverse_mass > zero, T(1), zero);
  change = moves * change;
  const T change2 = dot(change, change);
  if (!any_lane(change2 > zero)) return zero;
  store(before.x + change.x, row.friction + friction_impulse * width_of<T>);
  store(before.y + change.y, row.friction + (friction_impulse + 1) * width_of<T>);
  store(before.z + change.z, row.friction + (friction_impulse + 2) * width_of<T>);
  take_impulse(row, change, velocity);
  return square_root(change2) * inverse_mass;
}

}  // namespace pinball

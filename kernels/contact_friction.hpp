#pragma once

#include "contact_impulse.hpp"

/// Coulomb friction on contact constraints. Across the direction a of a row its two sides slide past each other with
///
///     t = (1 - a a^T) s ,
///
/// and q is the impulse that stops the sliding (t = 0), as long as |q| <= mu p; else it is mu p along t. p: the impulse
/// of the row; mu: its coefficient in this step, that of rest or that of sliding as the row was in the step before.
/// (Were it chosen by q within the step, the law would not be monotone, and rows that share nodes would drop to sliding
/// one after the other before iterations have found out that together they can hold.)
namespace pinball {

/// What a node adds to G M^-1 G^T across a, over w^2. A constraint leaves 1/m of a node in some directions and nothing
/// in the others: 1/m is the quotient of the sums of squares and of the diagonal.
PINBALL_FUNCTION double friction_mobility(const ImpulseNode& node) {
  const double* m = node.inverse_mass;
  const double trace = m[0] + m[1] + m[2];
  const double squares = m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + 2 * (m[3] * m[3] + m[4] * m[4] + m[5] * m[5]);
  return trace > 0 ? squares / trace : 0.0;
}

/// How long q may be.
struct FrictionBound {
  double coefficient = 0;  ///< times p [-]
  double besides = 0;      ///< for any p > 0 [mass length/time]

  PINBALL_FUNCTION double most(double p) const { return coefficient * p + besides; }
};

/// What a row of direction a may give, nearest to b: p not below zero, q within its bound.
PINBALL_FUNCTION Vec3<double> allowed_impulse(const Vec3<double>& b, const Vec3<double>& a,
                                              const FrictionBound& bound) {
  const double p = dot(a, b);
  if (!(p > 0)) return {0, 0, 0};
  const double most = bound.most(p);
  if (!(most > 0)) return p * a;
  const Vec3<double> q = b - p * a;
  const double size = square_root(dot(q, q));
  return p * a + (size > most ? most / size : 1.0) * q;
}

/// In which way the impulse of a row may change while no bound of it is met or left.
enum class RowFreedom : int {
  none,   ///< p is zero
  along,  ///< only along the direction: nothing rubs
  all,    ///< the friction holds: q is shorter than its bound
  round   ///< it slides: q keeps its size and may turn
};

/// A row whose freedom is chosen.
struct FreeRow {
  RowFreedom freedom = RowFreedom::none;
  Vec3<double> turning{0, 0, 0};  ///< across a and q, a unit vector; where freedom is `round`
  /// What turning q by a unit of impulse asks for besides what moves nodes, because t stays along q: |t| / |q|
  /// [1/mass].
  double stiffness = 0;
};

/// b: an allowed impulse; t: sliding of its row, positive along the q that it asks for.
PINBALL_FUNCTION FreeRow freedom_of(const Vec3<double>& b, const Vec3<double>& a, const FrictionBound& bound,
                                    const Vec3<double>& t) {
  constexpr double inside = 1 - 1e-9;
  FreeRow row;
  const double p = dot(a, b);
  if (!(p > 0)) return row;
  row.freedom = RowFreedom::along;
  const double most = bound.most(p);
  if (!(most > 0)) return row;
  const Vec3<double> q = b - p * a;
  const double size = square_root(dot(q, q));
  row.freedom = RowFreedom::all;
  if (size < inside * most) return row;
  row.freedom = RowFreedom::round;
  const Vec3<double> unit = (1 / size) * q;
  row.turning = cross(a, unit);
  row.stiffness = maximum(0.0, dot(t, unit)) / size;
  return row;
}

/// The part of a vector that a row is free in.
PINBALL_FUNCTION Vec3<double> free_part(const FreeRow& row, const Vec3<double>& a, const Vec3<double>& b) {
  if (row.freedom == RowFreedom::none) return {0, 0, 0};
  if (row.freedom == RowFreedom::all) return b;
  const Vec3<double> along = dot(a, b) * a;
  if (row.freedom == RowFreedom::along) return along;
  return along + dot(row.turning, b) * row.turning;
}

}  // namespace pinball

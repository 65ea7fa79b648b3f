#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <kernels/contact_friction.hpp>
#include <kernels/exec/array.hpp>
#include <solver/base/records.hpp>

#include "row_system.hpp"

namespace pinball {

namespace island {
template <bool friction>
class IslandSolution;
}

/// Solves a system of contact impulses (kernels/contact_impulse.hpp, kernels/contact_friction.hpp), island by island.
///
/// The impulses minimize, with friction's bounds as they are,
///
///     1/2 b . A b - c . b ,      c = G v* + r ,
///
/// A being G M^-1 G^T with its compliance, each b_i among those that are allowed. Proportioning with projections
/// (Dostal and Schoeberl, Comput. Optim. Appl. 30, 23-43, 2005), with conjugate residuals in place of gradients: a
/// projected step
///
///     b <- allowed(b - g / D) ,      g = A b - c ,      D: row sums of A from above,
///
/// finds out which bounds hold; then conjugate residuals go on over what is free, until that is small beside what the
/// bounds hold back, or an impulse would become negative. A row that slides is free to turn its friction, with the
/// stiffness |t|/|q| of the circle that it is bound to. How long q may be follows p at the projections; where that goes
/// to and fro, it follows by a part.
///
/// It ends when the projected step is small: D |allowed(b - g / D) - b|, a velocity, below 1e-9 (with friction 1e-10)
/// of the rates that the impulses of the island are to change.
class ImpulseIterations {
 public:
  static constexpr double softness = 1e-4;  ///< e of the compliance

  struct Result {
    int steps = 0;          ///< products with A, of the island that took the most
    double residual = 0;    ///< of the island with the largest over its scale [length/time]
    double scale = 0;       ///< of that island [length/time]
    bool converged = true;  ///< all islands have
  };

  /// For the rows of a system to begin with.
  void reset(const RowSystem& system);
  void set_impulse(std::int64_t k, const Vec3<double>& b) { put(impulse_, k, b); }
  /// velocity: records per place of a node: v* before, v afterwards.
  Result solve(const RowSystem& system, double* velocity);

  /// Velocity projection: all rows see the same velocities, and each gives the share of its impulse that keeps their
  /// sum from overshooting,
  ///
  ///     p_i = max(0, u_i) / sum_I ( |w_iI| |M_I^-1 a_i| sum_j |w_jI| )    j: rows with u_j > 0 .
  ///
  /// Exact where neighbours close alike; takes out energy, never adds it (but for r). Then friction, begun with that of
  /// the step before, takes one projected step.
  void project(const RowSystem& system, double* velocity);

  /// b of a row.
  Vec3<double> impulse(std::int64_t k) const { return get(impulse_, k); }
  std::size_t bytes() const;

 private:
  template <bool friction>
  friend class island::IslandSolution;
  using Records = Array<double>;  ///< of four numbers

  static Vec3<double> get(const Records& of, std::int64_t k) { return vector_of(record(of.data(), k)); }
  static void put(Records& of, std::int64_t k, const Vec3<double>& b) { put_vector(record(of.data(), k), b); }

  Records impulse_;  ///< b, per row
  // Of an island while it is solved: vectors, or, without friction, numbers along the direction. Those of its rows lie
  // from record first_row on.
  Records sought_, gradient_;         ///< b, g
  Records step_, of_step_;            ///< a change of b, and A times it
  Records direction_, of_direction_;  ///< of the search, and A times it
  Records residual_;                  ///< of what is free
  Records trial_;                     ///< a change of b as a vector
  Records change_;                    ///< of velocities by a trial, per place of a node
  Array<FreeRow> freedom_;            ///< with friction
  Array<double> free_;                ///< without: 1 where p is free, else 0
  Array<double> before_;              ///< p at the last projection, for bounds that follow it by a part
  std::vector<Result> results_;       ///< per island
};

}  // namespace pinball

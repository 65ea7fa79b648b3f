#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "impulse_iterations.hpp"
#include "island_loops.hpp"
#include "island_sums.hpp"
#include "rigid_nodes_of_rows.hpp"

namespace pinball::island {

/// Of the projected step, over the scale of an island: where iterations end, without and with friction, whose bounds
/// enlarge what is left; and where they count as converged if the bound of their number ends them.
constexpr double tolerance = 1e-9, tolerance_with_friction = 1e-10, good_enough = 1e-6;
/// Of an island, at least this part of velocities of its nodes: their differences have round-off.
constexpr double least_scale = 1e-5;
/// Products with A for an island; from how many on friction is given more time; and projections without success until
/// its bounds follow p more slowly.
constexpr int most_steps = 1000, long_time = 700, patience = 4;
/// What is free is solved to this part of the tolerance.
constexpr double of_free = 0.3;
/// What a projection may move besides without a product.
constexpr double negligible = 1e-3;

// An impulse of a row that rubs is a vector, of others a number along the direction.
inline double dot(double a, double b) { return a * b; }
inline double length(double a) { return std::abs(a); }
inline double length(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }

/// One island, while it is solved. friction: some of its rows may rub.
template <bool friction>
class IslandSolution {
 public:
  using Impulse = std::conditional_t<friction, Vec3<double>, double>;

  IslandSolution(const RowSystem& system, ImpulseIterations& of, const Island& island, double* velocity)
      : system_(system), of_(of), island_(island), velocity_(velocity), loops_(island.rows() >= rows_to_share) {}

  PINBALL_ONE_COPY ImpulseIterations::Result solve() {
    begin();
    double residual = find_projected_step();
    while (residual > enough_ && result_.steps < most_steps) {
      if (friction && part_ < 1) residual = follow_by_part();
      residual = take_projected_step();
      if (!(residual > enough_)) break;
      search();
      const double before = std::exchange(residual, project());
      if (friction) choose_bounds(before, residual);
    }
    finish();
    result_.residual = residual;
    result_.converged = residual <= good_enough * result_.scale;
    return result_;
  }

 private:
  using Row = RowSystem::Row;
  using Records = ImpulseIterations::Records;

  Impulse get(const Records& of, std::int64_t k) const {
    if constexpr (friction) {
      return vector_of(record(of.data(), k));
    } else {
      return of[3 * island_.first_row + k];
    }
  }
  void put(Records& of, std::int64_t k, const Impulse& b) {
    if constexpr (friction) {
      ImpulseIterations::put(of, k, b);
    } else {
      of[3 * island_.first_row + k] = b;
    }
  }
  /// b along the direction of a row, and as a vector.
  static double along(const Row& row, const Impulse& b) {
    if constexpr (friction) {
      return dot(row.direction, b);
    } else {
      return b;
    }
  }
  static Vec3<double> vector(const Row& row, const Impulse& b) {
    if constexpr (friction) {
      return b;
    } else {
      return b * row.direction;
    }
  }
  static Impulse seen_by(const Row& row, const Vec3<double>& b) {
    if constexpr (friction) {
      return b;
    } else {
      return dot(row.direction, b);
    }
  }

  template <class Body>
  void for_rows(const Body& body) const {
    loops_.for_each(island_.first_row, island_.end_row, body);
  }
  template <class Result, class Body>
  Result over_rows(const Body& body) const {
    return loops_.reduce<Result>(island_.first_row, island_.end_row, body);
  }
  /// Those that move by themselves.
  template <class Body>
  void for_nodes(const Body& body) const {
    loops_.for_each(island_.first_node, island_.end_free, [&](std::int64_t i) { body(system_.nodes()[i]); });
  }
  /// give(place, change) for the nodes of rigid bodies, moved by impulses.
  template <class Give>
  void for_nodes_of_bodies(const Records& impulses, const Give& give) const {
    for_rigid_nodes(system_, island_.first_group, island_.end_group, loops_, impulses.data(), give);
  }
  template <class Result, class Body>
  Result over_nodes(const Body& body) const {
    return loops_.reduce<Result>(island_.first_node, island_.end_node,
                                 [&](std::int64_t i, Result& sum) { body(system_.nodes()[i], sum); });
  }

  FrictionBound bound(std::int64_t k) const {
    const double mu = system_.row(k).coefficient;
    if (part_ == 1) return {mu, 0};
    return {part_ * mu, (1 - part_) * mu * of_.before_[k]};
  }
  Impulse allowed(std::int64_t k, const Impulse& b) const {
    if constexpr (friction) {
      return allowed_impulse(b, system_.row(k).direction, bound(k));
    } else {
      return std::max(0.0, b);
    }
  }
  /// The same with the bounds of friction that hold in the end.
  Impulse allowed_at_last(std::int64_t k, const Impulse& b) const {
    if constexpr (friction) {
      const Row& row = system_.row(k);
      return allowed_impulse(b, row.direction, {row.coefficient, 0});
    } else {
      return std::max(0.0, b);
    }
  }
  /// What of A d a row sees that is free: d, and A d.
  Impulse free_product(std::int64_t k, const Impulse& d, const Impulse& product) const {
    if constexpr (friction) {
      const FreeRow& free = of_.freedom_[k];
      return free_part(free, system_.row(k).direction, product) +
             (free.stiffness * dot(free.turning, d)) * free.turning;
    } else {
      return of_.free_[k] * product;
    }
  }
  /// P r: over the row sum, and the stiffness where friction turns.
  Impulse preconditioned(std::int64_t k, const Impulse& r) const {
    const Row& row = system_.row(k);
    if constexpr (friction) {
      const FreeRow& free = of_.freedom_[k];
      const Vec3<double> along = dot(row.direction, r) * row.direction;
      return (1 / row.bound) * along + (1 / (row.bound + free.stiffness)) * (r - along);
    } else {
      return r / row.bound;
    }
  }
  /// Finds out in what a row is free. Returns the part of -g that it is free in.
  Impulse set_free(std::int64_t k, const Impulse& b, const Impulse& g) {
    const Row& row = system_.row(k);
    if constexpr (friction) {
      const Vec3<double> sliding = dot(row.direction, g) * row.direction - g;
      const FreeRow& free = of_.freedom_[k] = freedom_of(b, row.direction, bound(k), sliding);
      return Vec3<double>{0, 0, 0} - free_part(free, row.direction, g);
    } else {
      const double free = of_.free_[k] = b > 0 ? 1.0 : 0.0;
      return -free * g;
    }
  }

  /// g of the impulses to begin with, and what is enough.
  void begin() {
    for_rows([&](std::int64_t k) {
      const Row& row = system_.row(k);
      const Impulse b = allowed(k, seen_by(row, of_.impulse(k)));
      put(of_.sought_, k, b);
      put(of_.step_, k, b);
      ImpulseIterations::put(of_.trial_, k, vector(row, b));
      if (friction) of_.before_[k] = along(row, b);
    });
    multiply();
    const double rate = over_rows<Largest>([&](std::int64_t k, Largest& largest) {
                          const Row& row = system_.row(k);
                          const Vec3<double> driven = system_.approach(k, velocity_) + row.rate * row.direction;
                          put(of_.gradient_, k, get(of_.of_step_, k) - seen_by(row, driven));
                          const double by_impulse = row.inverse_mass * length(get(of_.sought_, k));
                          largest.value = std::max({largest.value, row.scale, by_impulse});
                        }).value;
    const double speed = over_nodes<Largest>([&](std::int32_t place, Largest& largest) {
                           const double* const v = record(velocity_, place);
                           largest.value = std::max({largest.value, std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
                         }).value;
    result_.scale = std::max(rate, least_scale * speed);
    enough_ = (friction ? tolerance_with_friction : tolerance) * result_.scale;
  }

  /// of_step_ = A step_; trial_ is step_ as vectors.
  void multiply() {
    ++result_.steps;
    for_nodes([&](std::int32_t place) {
      ImpulseIterations::put(of_.change_, place,
                             moved_by(system_.node(place), system_.impulse_at(place, of_.trial_.data())));
    });
    for_nodes_of_bodies(of_.trial_, [&](std::int32_t place, const Vec3<double>& change) {
      ImpulseIterations::put(of_.change_, place, change);
    });
    for_rows([&](std::int64_t k) {
      constexpr double e = ImpulseIterations::softness;
      const Row& row = system_.row(k);
      const Impulse b = get(of_.step_, k), moved = seen_by(row, system_.approach(k, of_.change_.data()));
      if constexpr (friction) {
        const Vec3<double> along = dot(row.direction, b) * row.direction;
        put(of_.of_step_, k, (1 - e) * moved + e * (row.sum_along * along + row.sum_across * (b - along)));
      } else {
        put(of_.of_step_, k, (1 - e) * moved + e * row.sum_along * b);
      }
    });
  }
  void try_step(std::int64_t k, const Impulse& step) {
    put(of_.step_, k, step);
    ImpulseIterations::put(of_.trial_, k, vector(system_.row(k), step));
  }

  /// step_: the projected step. Returns the largest, by the bounds of friction that hold in the end.
  double find_projected_step() {
    return over_rows<Largest>([&](std::int64_t k, Largest& largest) {
             const Row& row = system_.row(k);
             const Impulse b = get(of_.sought_, k), wanted = b - (1 / row.bound) * get(of_.gradient_, k);
             const Impulse step = allowed(k, wanted) - b;
             try_step(k, step);
             const Impulse at_last = part_ < 1 ? allowed_at_last(k, wanted) - b : step;
             largest.value = std::max(largest.value, row.bound * length(at_last));
           })
        .value;
  }
  /// The bounds of friction follow p; where the residual will not become smaller, by a part, and for the rest what p
  /// was at the last projection; and where that takes long, too, the rest follows p by a part itself.
  void choose_bounds(double before, double residual) {
    stalled_ = residual > 0.7 * before ? stalled_ + 1 : 0;
    if (stalled_ >= patience) {
      stalled_ = 0;
      part_ = std::max(0.5 * part_, 0.125);
    }
    if (result_.steps >= long_time) part_ = 0.5;
  }
  double follow_by_part() {
    const double taken_up = result_.steps < long_time ? 1 : 0.25;
    for_rows([&](std::int64_t k) {
      const double p = std::max(0.0, along(system_.row(k), get(of_.sought_, k)));
      double& before = of_.before_[k];
      before = taken_up == 1 ? p : before + taken_up * (p - before);
    });
    return find_projected_step();
  }
  double take_projected_step() {
    multiply();
    for_rows([&](std::int64_t k) {
      put(of_.sought_, k, get(of_.sought_, k) + get(of_.step_, k));
      put(of_.gradient_, k, get(of_.gradient_, k) + get(of_.of_step_, k));
    });
    return find_projected_step();
  }
  /// Brings impulses back to what is allowed after a search. Returns the largest projected step then.
  double project() {
    const double moved = over_rows<Largest>([&](std::int64_t k, Largest& largest) {
                           const Impulse b = get(of_.sought_, k), change = allowed(k, b) - b;
                           try_step(k, change);
                           largest.value = std::max(largest.value, system_.row(k).bound * length(change));
                         }).value;
    if (moved > negligible * enough_) return take_projected_step();
    if (moved > 0) for_rows([&](std::int64_t k) { put(of_.sought_, k, allowed(k, get(of_.sought_, k))); });
    return find_projected_step();
  }

  /// Preconditioned conjugate residuals (Saad, Iterative methods for sparse linear systems, 2003, section 6.8) over
  /// what is free.
  void search() {
    const double begun = over_rows<Sum>([&](std::int64_t k, Sum& sum) {
                           const Impulse r = set_free(k, get(of_.sought_, k), get(of_.gradient_, k));
                           const Impulse z = preconditioned(k, r);
                           put(of_.residual_, k, r);
                           try_step(k, z);
                           sum.value += dot(r, z);
                         }).value;
    double size = 0;
    for (bool goes_on = begun > 0; goes_on && result_.steps < most_steps;) {
      multiply();
      const Along along = choose_direction(size > 0 ? conjugation() / size : 0.0, size == 0);
      size = along.size;
      if (!(along.size > 0 && along.descent > 0)) return;
      const double best = along.descent / along.size;
      goes_on = advance(std::min(best, along.room)) && best <= along.room;
    }
  }
  /// A z . P A d of the direction before.
  double conjugation() const {
    return over_rows<Sum>([&](std::int64_t k, Sum& sum) {
             const Impulse q = free_product(k, get(of_.direction_, k), get(of_.of_direction_, k));
             sum.value += dot(free_product(k, get(of_.step_, k), get(of_.of_step_, k)), preconditioned(k, q));
           })
        .value;
  }
  Along choose_direction(double beta, bool is_first) {
    return over_rows<Along>([&](std::int64_t k, Along& sums) {
      Impulse d = get(of_.step_, k), product = get(of_.of_step_, k);
      if (!is_first) {
        d = d - beta * get(of_.direction_, k);
        product = product - beta * get(of_.of_direction_, k);
      }
      put(of_.direction_, k, d);
      put(of_.of_direction_, k, product);
      const Impulse q = free_product(k, d, product), preconditioned_q = preconditioned(k, q);
      sums.descent += dot(get(of_.residual_, k), preconditioned_q);
      sums.size += dot(q, preconditioned_q);
      const Row& row = system_.row(k);
      const double less = -along(row, d), p = along(row, get(of_.sought_, k));
      if (less > 0) sums.room = std::min(sums.room, std::max(0.0, p) / less);
    });
  }
  /// Goes along the direction. Returns whether it pays to go on.
  bool advance(double step) {
    const auto progress = over_rows<Progress>([&](std::int64_t k, Progress& sum) {
      const Row& row = system_.row(k);
      const Impulse d = get(of_.direction_, k), product = get(of_.of_direction_, k);
      const Impulse b = get(of_.sought_, k) + step * d, g = get(of_.gradient_, k) + step * product;
      const Impulse r = get(of_.residual_, k) - step * free_product(k, d, product), z = preconditioned(k, r);
      put(of_.sought_, k, b);
      put(of_.gradient_, k, g);
      put(of_.residual_, k, r);
      try_step(k, z);
      sum.free += dot(r, z);
      sum.largest = std::max(sum.largest, row.bound * length(z));
      if constexpr (friction) {
        const RowFreedom freedom = of_.freedom_[k].freedom;
        if (freedom == RowFreedom::round) return;  // its bound is a circle, which it leaves as it turns
        if (freedom == RowFreedom::all) {
          const double p = along(row, b);
          sum.strays = sum.strays || length(b - p * row.direction) > bound(k).most(p);
        }
      }
      const Impulse held = allowed(k, b - (1 / row.bound) * g) - b - z;
      sum.bound += row.bound * dot(held, held);
    });
    return progress.largest > of_free * enough_ && !progress.strays && progress.bound <= progress.free;
  }

  /// Impulses, and velocities of the nodes.
  void finish() {
    for_rows([&](std::int64_t k) {
      ImpulseIterations::put(of_.impulse_, k, vector(system_.row(k), allowed_at_last(k, get(of_.sought_, k))));
    });
    for_nodes([&](std::int32_t place) { system_.move(place, of_.impulse_.data(), velocity_); });
    for_nodes_of_bodies(of_.impulse_, [&](std::int32_t place, const Vec3<double>& change) {
      put_vector(record(velocity_, place), vector_of(record(velocity_, place)) - change);
    });
  }

  const RowSystem& system_;
  ImpulseIterations& of_;
  const Island island_;
  double* velocity_;
  IslandLoops loops_;
  double part_ = 1;    ///< of p in the bounds of friction
  int stalled_ = 0;    ///< projections in a row that gained little
  double enough_ = 0;  ///< projected step that ends it [length/time]
  ImpulseIterations::Result result_;
};

}  // namespace pinball::island

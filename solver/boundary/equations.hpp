#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <kernels/boundary/external_work.hpp>
#include <solver/base/point.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/model/model.hpp>

#include "equation_rows.hpp"

namespace pinball {

/// Linear equations among displacements, [[equation]]:
///
///     sum over i of a_ri . u_i = 0 ,       kept by forces   f_i += sum over r of l_r a_ri ,
///
/// after all other forces and what constraints and prescribed velocities make of them, where the velocities would be
/// v_i + h f_i/m_i =: w_i (h: over which forces change velocities). The forces act along directions that are free, P_i,
///
///     sum over s of ( sum over i of a_ri . P_i a_si/m_i ) h l_s = - sum over i of a_ri . w_i ,
///
/// so that all velocities of a step fulfil them, and with these displacements, to round-off. What holds the others
/// takes the rest. Equations that have nothing in common are solved each by itself, others together, by a Cholesky
/// factorization that leaves out those which follow from ones before (zero pivots).
///
/// Impulses of contact and rigid walls come after them. What these do to the nodes of an equation is right as long as
/// it fulfils the equation, too: then all velocities do, and every force is along what it keeps. Where it does not, the
/// run ends.
///
/// The work of the forces is sum of l_r (sum over i of a_ri . v_i) = 0 as long as velocities fulfil the equations.
/// Where they do not, at the start, after a host has changed them or a constraint has begun, it is that of a plastic
/// impact, and is work from outside. Momentum is kept by equations whose coefficients add up to zero.
template <class S>
class Equations {
 public:
  /// Throws InputError (equation_rows()).
  explicit Equations(const Model<S>& model);

  bool any() const { return !rows_.empty(); }
  /// Of the store, ascending.
  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  /// What holds or moves nodes has changed. Throws InputError for too many equations with nodes in common.
  void take_held_directions(const Model<S>& model);
  /// Largest change of velocity by which the present ones come to fulfil the equations [length/time].
  double leap(const Model<S>& model) const;
  /// To forces, when all others are there and nodes are held. Throws RunError where an equation cannot be fulfilled.
  void add_forces(Model<S>& model, const StepLengths& step);
  /// Forces as they are are those with which the equations hold.
  void keep_forces(const Model<S>& model);
  /// When all forces are there. Throws RunError where what came after keep_forces() lets velocities no longer fulfil an
  /// equation.
  void require_kept_forces(const Model<S>& model, const StepLengths& step) const;
  double work() const { return done_ + last_.now; }  ///< done on the model up to the time of the forces [energy]
  void persist(StateArchive& archive) {
    if (any()) archive(done_, last_);
  }
  std::size_t bytes() const;

 private:
  struct Part {
    std::int32_t at;  ///< in nodes_
    Point coefficient;
  };
  struct Row {
    std::int32_t first, last;  ///< in parts_
  };
  struct Factor;
  /// Equations that have nodes in common, but for those left out.
  struct Group {
    std::vector<std::int32_t> rows;
    std::shared_ptr<const Factor> factor{};
  };
  void find_groups();
  double common(std::int32_t one, std::int32_t other) const;
  double were_it_free(std::int32_t row) const;
  void factorize(Group& group);
  bool take_masses(const Model<S>& model);
  std::vector<Point> changes(const std::vector<Point>& velocity) const;
  /// fastest: of the velocities before they were changed, of which what cancels is rounded.
  void require_kept(const std::vector<Point>& velocity, double fastest) const;

  std::vector<std::string> where_;  ///< per row
  std::vector<Row> rows_;
  std::vector<Part> parts_;
  std::vector<std::int32_t> nodes_;
  std::vector<double> inverse_mass_;        ///< per node [1/mass]
  std::vector<std::array<Point, 3>> free_;  ///< P, per node: rows of it
  std::vector<Group> groups_;
  std::vector<std::int32_t> left_out_;  ///< rows
  std::vector<Point> kept_force_;       ///< per node, of keep_forces() [force]
  double done_ = 0;                     ///< work of all steps before the last
  ExternalWork last_;
};

}  // namespace pinball

#pragma once

#include <array>
#include <cstdint>
#include <pinball/kernels/contact_impulse.hpp>
#include <pinball/kernels/contact_row.hpp>
#include <pinball/solver/external_work.hpp>
#include <pinball/solver/model.hpp>
#include <pinball/solver/neighbour_list.hpp>
#include <pinball/solver/pinball_store.hpp>
#include <pinball/solver/surface.hpp>
#include <vector>

namespace pinball {

/// Result of one solution of the contact impulses.
struct ImpulseResult {
  double dissipated = 0;         ///< energy taken out since the solution before, see ContactImpulses [energy]
  double penetration_ratio = 0;  ///< largest penetration over R1 + R2 [-]
  std::int64_t pairs = 0;        ///< pairs that push
};

/// Contact by impulses instead of springs: after accelerations are known and before positions move, impulses take out
/// the velocities v* with which gaps would close within the step (kernels/contact_impulse.hpp). They do not change the
/// stable step.
///
///   lagrange     the coupled system of the step, by sweeps until it is solved;
///   projection   one sweep over all pairs.
///
/// Release (Hughes, Taylor, Sackman, Curnier and Kanoknukulchai, Comp. Meths. Appl. Mech. Engrg. 8, 249-276, 1976): the
/// first impulse of a contact acts on nodes of half an element, so that it is half of what a step of a steady contact
/// gives. When a pair separates, its nodes get the other half; without it they ring for ever. It may not return more
/// energy than the pair has taken out.
///
/// Energy: an impulse p works over half the step before it and half the step after it, -p (u_before dt_before + u_after
/// dt_after)/(dt_before + dt_after), which is the trapezoid that all forces of the step are counted with.
///
/// The rows are solved in double and in one order, so that results do not depend on the number of threads.
template <class S>
class ContactImpulses {
 public:
  explicit ContactImpulses(const Model<S>& model);

  /// Rows of all pairs that may touch within the coming step, at the present positions. dt: the step just made.
  void collect(const Model<S>& model, PinballStore<S>& pinballs, const NeighbourList<S>& list, const Surface& surface,
               double dt);

  /// Solves for the impulses of the coming step and adds the forces that give them to the nodes and the pinballs.
  /// Loads, constraints and prescribed velocities must already be in the node forces and velocities; what the forces of
  /// the contact have in held directions is for them to take up again.
  ImpulseResult solve(Model<S>& model, PinballStore<S>& pinballs, const StepLengths& step);

  std::size_t bytes() const;

 private:
  /// What outlives a step, by the slots of the two elements.
  struct Memory {
    std::int32_t slot1, slot2;
    double depth;  ///< as far as approach has closed it, see limit_depth [length]
    double force;  ///< of the last step [force]
    double lost;   ///< energy that the pair has taken out [energy]
    static bool earlier(const Memory& a, const Memory& b) {
      return a.slot1 != b.slot1 ? a.slot1 < b.slot1 : a.slot2 < b.slot2;
    }
  };
  /// What a row of rows_ is besides.
  struct Pair {
    std::int32_t pinball1, pinball2;
    double depth;        ///< penetration, or negative gap; see limit_depth [length]
    double rate_before;  ///< G v in the middle of the step before [length/time]
    double rate_free;    ///< G v* [length/time]
    Memory memory;
  };

  void add_row(const PinballStore<S>& pinballs, std::int32_t p, std::int32_t q, const ContactRow& row);
  void limit_depth(const Model<S>& model, std::size_t row, double dt);
  void load_nodes(const Model<S>& model, double velocity_step);
  void drop_rows_apart();
  void solve_coupled();
  void release(double velocity_step);
  void add_forces(Model<S>& model, PinballStore<S>& pinballs, double velocity_step);
  void remember();

  bool lagrange_ = false, face_gap_ = false;
  std::vector<ImpulseRow> rows_;
  std::vector<Pair> pairs_;  ///< one per row
  std::vector<ImpulseNode> nodes_;
  std::vector<std::int32_t> node_;        ///< of the store, per entry of nodes_
  std::vector<Memory> memory_;            ///< of the last step, sorted by the slots
  std::vector<std::int32_t> node_place_;  ///< per node of the store: place in nodes_ or -1
  /// Directions in which constraints and prescribed velocities leave a node no mobility; orthonormal per node.
  std::vector<std::array<double, 3>> held_;
  std::vector<std::int32_t> held_first_;  ///< per node of the store and one more: into held_
  double pending_ = 0;                    ///< energy dissipated by the last impulses in the step after them
};

}  // namespace pinball

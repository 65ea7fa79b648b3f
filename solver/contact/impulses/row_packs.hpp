#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <kernels/contact_friction.hpp>
#include <kernels/exec/array.hpp>

#include "contact_rows.hpp"
#include "row_order.hpp"
#include "row_stages.hpp"

namespace pinball {

/// Rows in packs, and the sweeps over them, which go from pack to pack and from colour to colour (RowStages).
class RowPacks {
 public:
  static constexpr int widest = RowOrder::widest;
  using Lanes = Pack<double, widest>;

  /// Rows to a pack. Few rows hardly fill packs: each of them is one by itself, as it is where there are no packs.
  static int width_for(std::size_t rows) { return rows < 256 ? 1 : widest; }
  /// Lays out the rows that take part. active: their numbers, ascending; nodes: per place of a node; frictions: per
  /// row, empty without friction; width: rows to a pack, 1 or `widest`.
  void build(const ContactRows& rows, const std::vector<std::int32_t>& active, const std::vector<ImpulseNode>& nodes,
             const std::vector<FrictionRow>& frictions, int width);

  int width() const { return order_.width(); }
  const RowOrder& order() const { return order_; }
  /// Calls body(pack) colour by colour, for work that is done once in a step.
  template <class Body>
  void coloured_heavy(const char* name, const Body& body) const {
    heavy_.run(name, body);
  }
  RowPack pack(std::int64_t number);
  /// sum_I w_I v_I of each row of a pack (kernels/contact_impulse.hpp).
  void find_approach(std::int64_t pack, const double* velocity, Vec3<double> (&found)[widest]);
  /// Takes impulses along the directions of the rows of a pack from the velocities, one for each lane.
  void take(std::int64_t pack, const double (&impulses)[widest], double* velocity);
  /// Whether there are colours of so many rows that threads share their sweeps.
  bool sweeps_are_shared_out() const { return light_.shared_out(); }

  // What follows changes velocities: records of four numbers, one per place of a node.
  /// Gives the rows their impulses, and their friction.
  void apply(double* velocity);
  /// A sweep over all rows; friction after the impulse of each. Returns the largest change of a closing or sliding
  /// velocity.
  double sweep(double* velocity);
  /// Velocity projection, then one sweep of friction.
  void project(double* velocity);

  double impulse(std::int64_t pack, int lane) const { return numbers_[place(pack, row_impulse, lane)]; }
  void set_impulse(std::int64_t pack, int lane, double impulse) { numbers_[place(pack, row_impulse, lane)] = impulse; }
  Vec3<double> friction(std::int64_t pack, int lane) const;
  std::size_t bytes() const;

 private:
  /// Calls body(T()) with the number type of the packs.
  template <class Body>
  void in_lanes(const Body& body) const {
    if (width() == 1) {
      body(double());
    } else {
      body(Lanes());
    }
  }
  void fill(std::int64_t pack, const ContactRows& rows, const std::vector<ImpulseNode>& nodes,
            const std::vector<FrictionRow>& frictions);
  bool has_friction() const { return !frictions_.empty(); }
  std::size_t place(std::int64_t pack, int number, int lane) const {
    return static_cast<std::size_t>((pack * row_numbers + number) * width() + lane);
  }

  RowOrder order_;
  RowStages light_, heavy_;  ///< for sweeps, and for more work per row
  Array<std::int32_t> nodes_;
  Array<double> entries_, numbers_, frictions_;
  Array<double> changes_;  ///< of velocities by the last sweep, per row
};

}  // namespace pinball

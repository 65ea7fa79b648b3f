#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <kernels/contact_friction.hpp>
#include <kernels/exec.hpp>
#include <solver/base/aligned_array.hpp>

#include "contact_rows.hpp"
#include "row_order.hpp"

namespace pinball {

/// Rows in packs, and the sweeps over them. Packs of a colour are worked at the same time, which gives the same bits
/// for any number of threads; few packs by one thread alone, for whom no other has to wait.
class RowPacks {
 public:
  static constexpr int width = RowOrder::width;
  using Lanes = Pack<double, width>;

  /// Lays out the rows that take part. active: their numbers, ascending; nodes: per place of a node; frictions: per
  /// row, empty without friction.
  void build(const ContactRows& rows, const std::vector<std::int32_t>& active, const std::vector<ImpulseNode>& nodes,
             const std::vector<FrictionRow>& frictions);

  const RowOrder& order() const { return order_; }
  /// Calls body(pack) colour by colour.
  template <class Body>
  void coloured(const char* name, const Body& body) const {
    const std::vector<std::int32_t>& offsets = order_.colour_offsets();
    const auto colours = static_cast<std::int32_t>(offsets.size()) - 1;
    if (parallel_) {
      parallel_for_coloured(name, DefaultExecutionSpace{}, offsets.data(), colours, numbers_of_packs_.data(), body);
    } else {
      parallel_for_coloured(name, Serial{}, offsets.data(), colours, numbers_of_packs_.data(), body);
    }
  }
  RowPack pack(std::int64_t number);

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
  void fill(std::int64_t pack, const ContactRows& rows, const std::vector<ImpulseNode>& nodes,
            const std::vector<FrictionRow>& frictions);
  bool has_friction() const { return !frictions_.empty(); }
  static std::size_t place(std::int64_t pack, int number, int lane) {
    return static_cast<std::size_t>((pack * row_numbers + number) * width + lane);
  }

  RowOrder order_;
  bool parallel_ = false;
  std::vector<std::int32_t> numbers_of_packs_;  ///< 0, 1, ...
  AlignedArray<std::int32_t> nodes_;
  AlignedArray<double> entries_, numbers_, frictions_;
  AlignedArray<double> changes_;  ///< of velocities by the last sweep, per row
};

}  // namespace pinball

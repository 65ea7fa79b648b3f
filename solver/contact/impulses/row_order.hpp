#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <kernels/contact_impulse.hpp>

#include "contact_rows.hpp"

namespace pinball {

/// The order in which rows are worked: colour after colour, no two rows of one colour sharing a node; within a colour
/// those with held nodes first, then those with the most nodes, else as they were added. W of them make a pack. It
/// depends on the rows alone, so that whoever works the packs of a colour at the same time gets the same bits.
class RowOrder {
 public:
  static constexpr int widest = native_width<double>;

  struct PackPlace {
    std::size_t first_entry = 0;   ///< packs of nodes before its own
    std::size_t first_number = 0;  ///< packs of numbers of entries before its own
    std::int32_t entries = 0;      ///< nodes per row
    bool held = false;             ///< a node of its rows is held
  };

  /// active: the rows that take part, ascending; width: rows to a pack, 1 or `widest`.
  void build(const ContactRows& rows, const std::vector<std::int32_t>& active, const std::vector<ImpulseNode>& nodes,
             int width);

  int width() const { return width_; }

  const std::vector<PackPlace>& packs() const { return packs_; }
  /// The row in a lane of a pack, or -1.
  std::int32_t row(std::int64_t pack, int lane) const { return row_[static_cast<std::size_t>(pack * width_ + lane)]; }
  /// First pack of each colour; colours + 1.
  const std::vector<std::int32_t>& colour_offsets() const { return colour_offsets_; }
  std::size_t entry_packs() const { return entry_packs_; }    ///< packs of nodes
  std::size_t number_packs() const { return number_packs_; }  ///< packs of numbers of entries
  std::size_t bytes() const;

 private:
  void colour(const ContactRows& rows, const std::vector<std::int32_t>& active, std::size_t nodes);
  void sort(const ContactRows& rows, const std::vector<std::int32_t>& active, const std::vector<ImpulseNode>& nodes);

  int width_ = widest;
  std::vector<PackPlace> packs_;
  std::vector<std::int32_t> row_, colour_offsets_;
  std::size_t entry_packs_ = 0, number_packs_ = 0;
  // Only while the order is made; kept for their memory.
  std::vector<std::uint64_t> taken_;  ///< per node, bit c: a row of colour c has it
  std::vector<std::int32_t> colour_, left_, class_, place_, sorted_;
  std::int32_t colours_ = 0, most_nodes_ = 0;
};

}  // namespace pinball

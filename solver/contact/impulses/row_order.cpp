#include "row_order.hpp"

#include <algorithm>
#include <bit>

namespace pinball {

namespace {

constexpr std::int32_t colours_at_once = 64;

}  // namespace

/// Greedy: each row takes the first colour that is free at all its nodes. Rows that find none of 64 free (a face that
/// many small ones touch) begin anew with the next 64.
void RowOrder::colour(const ContactRows& rows, const std::vector<std::int32_t>& active, std::size_t nodes) {
  colour_.resize(active.size());
  left_.clear();
  for (std::size_t a = 0; a < active.size(); ++a) left_.push_back(static_cast<std::int32_t>(a));
  colours_ = 0;
  for (std::int32_t first = 0; !left_.empty(); first += colours_at_once) {
    taken_.assign(nodes, 0);
    std::size_t kept = 0;
    for (const std::int32_t a : left_) {
      const RowView row = rows[static_cast<std::size_t>(active[static_cast<std::size_t>(a)])];
      std::uint64_t taken = 0;
      for (int k = 0; k < row.nodes; ++k) taken |= taken_[row.node[k]];
      const int colour = std::countr_one(taken);
      if (colour == colours_at_once) {
        left_[kept++] = a;
        continue;
      }
      for (int k = 0; k < row.nodes; ++k) taken_[row.node[k]] |= std::uint64_t(1) << colour;
      colour_[a] = first + colour;
      colours_ = std::max(colours_, colour_[a] + 1);
    }
    left_.resize(kept);
  }
}

/// Counting sort by colour, held nodes and number of nodes.
void RowOrder::sort(const ContactRows& rows, const std::vector<std::int32_t>& active,
                    const std::vector<ImpulseNode>& nodes) {
  most_nodes_ = 0;
  for (const std::int32_t i : active) most_nodes_ = std::max(most_nodes_, rows.rows[i].nodes);
  class_.resize(active.size());
  place_.assign(static_cast<std::size_t>(colours_) * 2 * static_cast<std::size_t>(most_nodes_ + 1) + 1, 0);
  for (std::size_t a = 0; a < active.size(); ++a) {
    const RowView row = rows[static_cast<std::size_t>(active[a])];
    bool held = false;
    for (int k = 0; k < row.nodes; ++k) held = held || nodes[row.node[k]].held;
    class_[a] = (2 * colour_[a] + (held ? 0 : 1)) * (most_nodes_ + 1) + most_nodes_ - row.nodes;
    ++place_[class_[a] + 1];
  }
  for (std::size_t c = 1; c < place_.size(); ++c) place_[c] += place_[c - 1];
  sorted_.resize(active.size());
  for (std::size_t a = 0; a < active.size(); ++a) sorted_[place_[class_[a]]++] = static_cast<std::int32_t>(a);
}

void RowOrder::build(const ContactRows& rows, const std::vector<std::int32_t>& active,
                     const std::vector<ImpulseNode>& nodes, int width) {
  width_ = width;
  colour(rows, active, nodes.size());
  sort(rows, active, nodes);
  packs_.clear();
  row_.clear();
  colour_offsets_.assign(1, 0);
  std::int32_t colour = 0, kind = -1;
  int lane = width;
  for (const std::int32_t a : sorted_) {
    const std::int32_t own = class_[a] / (most_nodes_ + 1);  // colour and whether nodes are held
    if (own != kind) lane = width;
    kind = own;
    for (; colour < kind / 2; ++colour) colour_offsets_.push_back(static_cast<std::int32_t>(packs_.size()));
    if (lane == width) {
      lane = 0;
      PackPlace pack;
      pack.entries = rows.rows[active[a]].nodes;
      pack.held = kind % 2 == 0;
      packs_.push_back(pack);
      row_.resize(row_.size() + static_cast<std::size_t>(width), -1);
    }
    row_[(packs_.size() - 1) * static_cast<std::size_t>(width) + static_cast<std::size_t>(lane++)] = active[a];
  }
  if (!packs_.empty()) colour_offsets_.push_back(static_cast<std::int32_t>(packs_.size()));
  entry_packs_ = number_packs_ = 0;
  for (PackPlace& pack : packs_) {
    pack.first_entry = entry_packs_;
    pack.first_number = number_packs_;
    entry_packs_ += static_cast<std::size_t>(pack.entries);
    number_packs_ += static_cast<std::size_t>(pack.entries * (pack.held ? 7 : 2));
  }
}

std::size_t RowOrder::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return of(packs_) + of(row_) + of(colour_offsets_) + of(taken_) + of(colour_) + of(left_) + of(class_) + of(place_) +
         of(sorted_);
}

}  // namespace pinball

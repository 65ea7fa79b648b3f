#include "row_stages.hpp"

namespace pinball {

void RowStages::build(const RowOrder& order, std::int64_t least_entries) {
  const std::vector<std::int32_t>& offsets = order.colour_offsets();
  const std::vector<RowOrder::PackPlace>& packs = order.packs();
  const auto entries_before = [&](std::int32_t pack) {
    return static_cast<std::int64_t>(static_cast<std::size_t>(pack) < packs.size()
                                         ? packs[static_cast<std::size_t>(pack)].first_entry
                                         : order.entry_packs());
  };
  shared_out_ = false;
  packs_ = offsets.back();
  shares_.clear();
  stage_offsets_.assign(1, 0);
  bool small_before = false;
  for (std::size_t c = 0; c + 1 < offsets.size(); ++c) {
    const std::int32_t first = offsets[c], end = offsets[c + 1], count = end - first;
    const bool small = entries_before(end) - entries_before(first) < least_entries;
    if (small && small_before) {
      shares_.back().second = end;
      continue;
    }
    small_before = small;
    shared_out_ = shared_out_ || !small;
    const auto pieces = small ? 1 : static_cast<std::int32_t>(fixed_pieces);
    for (std::int32_t p = 0; p < pieces; ++p) {
      shares_.emplace_back(first + count * p / pieces, first + count * (p + 1) / pieces);
    }
    stage_offsets_.push_back(static_cast<std::int32_t>(shares_.size()));
  }
  for (std::size_t s = share_numbers_.size(); s < shares_.size(); ++s) {
    share_numbers_.push_back(static_cast<std::int32_t>(s));
  }
}

std::size_t RowStages::bytes() const {
  return shares_.capacity() * sizeof(shares_[0]) +
         (stage_offsets_.capacity() + share_numbers_.capacity()) * sizeof(std::int32_t);
}

}  // namespace pinball

#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <kernels/exec.hpp>

#include "row_order.hpp"

namespace pinball {

/// Who works which packs of rows: colour after colour, the packs of a large colour shared out among threads, which
/// gives the same bits for any number of them; small colours one after the other by one thread, because waiting for
/// another one would take longer.
class RowStages {
 public:
  /// least_entries: entries of a colour, in packs, from which on it is shared out.
  void build(const RowOrder& order, std::int64_t least_entries);

  /// Calls body(pack) for all packs.
  template <class Body>
  void run(const char* name, const Body& body) const {
    if (!shared_out_) {
      parallel_for(name, RangePolicy<Serial>{0, packs_}, body);
      return;
    }
    const auto stages = static_cast<std::int32_t>(stage_offsets_.size()) - 1;
    parallel_for_coloured(name, DefaultExecutionSpace{}, stage_offsets_.data(), stages, share_numbers_.data(),
                          [&](std::int32_t share) {
                            const auto [first, end] = shares_[static_cast<std::size_t>(share)];
                            for (std::int64_t pack = first; pack < end; ++pack) body(pack);
                          });
  }
  bool shared_out() const { return shared_out_; }
  std::size_t bytes() const;

 private:
  std::int64_t packs_ = 0;
  bool shared_out_ = false;
  /// Consecutive packs that one thread works. Those of a stage may be worked at the same time.
  std::vector<std::pair<std::int32_t, std::int32_t>> shares_;
  std::vector<std::int32_t> stage_offsets_;  ///< first share of each stage; stages + 1
  std::vector<std::int32_t> share_numbers_;  ///< 0, 1, ...
};

}  // namespace pinball

#pragma once

#include <algorithm>

#include <solver/base/error.hpp>

#include "ranks.hpp"

namespace pinball {

/// Ranks of which only the first is there, to count what all of them would send. What would come from another has the
/// numbers of this one instead: a step is made to its end, and its results are none.
class PlannedRanks final : public Ranks {
 public:
  PlannedRanks(int count, const Partition& given) : count_(count) { partition = given; }

  int number() const override { return 0; }
  int count() const override { return count_; }
  std::uint64_t program() const override { return 0; }
  /// Calls of gather() so far.
  std::int64_t gathers() const { return gathers_; }

  void broadcast(std::span<std::byte>) override {}
  void gather(std::span<const std::byte> own, const std::vector<std::size_t>&, std::span<std::byte> all,
              bool) override {
    ++gathers_;
    if (own.empty()) std::ranges::fill(all, std::byte{0});
    for (std::size_t place = 0; !own.empty() && place < all.size(); place += own.size())
      std::copy_n(own.begin(), std::min(own.size(), all.size() - place), all.begin() + place);
  }
  void exchange(std::span<const RankMessage> messages) override {
    for (const RankMessage& message : messages) std::ranges::fill(message.received, std::byte{0});
  }
  std::vector<std::int32_t> cut(const TileGraph&) const override {
    throw InputError("ranks that are planned have no partitioner: expected another --partition than metis");
  }

 private:
  int count_;
  std::int64_t gathers_ = 0;
};

}  // namespace pinball

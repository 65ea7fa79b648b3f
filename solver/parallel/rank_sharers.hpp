#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <solver/base/piece_share.hpp>

#include "ranks.hpp"

namespace pinball {

/// Ranks that work loops together of which each has all numbers.
class RankSharers final : public Sharers {
 public:
  explicit RankSharers(Ranks& ranks) : ranks_(ranks) {}
  int count() const override { return ranks_.count(); }
  int number() const override { return ranks_.number(); }
  std::int64_t worth_a_message() const override { return ranks_.worth_a_message; }
  std::vector<std::span<const std::byte>> to_all(std::span<const std::byte> own) override;
  std::size_t bytes() const { return all_.capacity(); }

 private:
  Ranks& ranks_;
  std::vector<std::byte> all_;
};

}  // namespace pinball

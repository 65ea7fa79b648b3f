#include "rank_sharers.hpp"

#include <numeric>

namespace pinball {

/// How much each has goes first.
std::vector<std::span<const std::byte>> RankSharers::to_all(std::span<const std::byte> own) {
  std::vector<std::size_t> bytes_of(count());
  const std::size_t own_bytes = own.size();
  ranks_.gather(std::as_bytes(std::span(&own_bytes, 1)), std::vector<std::size_t>(bytes_of.size(), sizeof own_bytes),
                std::as_writable_bytes(std::span(bytes_of)), true);
  all_.resize(std::reduce(bytes_of.begin(), bytes_of.end()));
  ranks_.gather(own, bytes_of, all_, true);
  ranks_.bytes_given += std::ssize(bytes_of) * static_cast<std::int64_t>(sizeof own_bytes) + std::ssize(all_);
  std::vector<std::span<const std::byte>> parts;
  std::span<const std::byte> rest = all_;
  for (const std::size_t bytes : bytes_of) {
    parts.push_back(rest.first(bytes));
    rest = rest.subspan(bytes);
  }
  return parts;
}

}  // namespace pinball

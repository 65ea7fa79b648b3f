#include "piece_share.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace pinball {

namespace {

Sharers* if_worth_it(Sharers* sharers, std::int64_t numbers) {
  const bool is_worth_it = sharers != nullptr && sharers->count() > 1 && numbers >= sharers->worth_a_message();
  return is_worth_it ? sharers : nullptr;
}

}  // namespace

PieceShare::PieceShare(Sharers* sharers, std::int64_t pieces, std::int64_t numbers)
    : sharers_(if_worth_it(sharers, numbers)) {
  if (!is_shared()) return;
  owner_.resize(pieces);
  for (std::int64_t piece = 0; piece < pieces; ++piece) {
    owner_[piece] = static_cast<std::int32_t>(piece % sharers->count());
  }
}

/// The largest piece first, each to the process that has the least so far.
PieceShare::PieceShare(Sharers* sharers, const std::vector<std::int64_t>& numbers_of)
    : sharers_(if_worth_it(sharers, std::reduce(numbers_of.begin(), numbers_of.end()))) {
  if (!is_shared()) return;
  std::vector<std::size_t> largest_first(numbers_of.size());
  std::iota(largest_first.begin(), largest_first.end(), 0);
  std::ranges::stable_sort(largest_first, std::greater(), [&](std::size_t piece) { return numbers_of[piece]; });
  std::vector<std::int64_t> given(sharers->count(), 0);
  owner_.resize(numbers_of.size());
  for (const std::size_t piece : largest_first) {
    const auto least = std::ranges::min_element(given);
    *least += numbers_of[piece];
    owner_[piece] = static_cast<std::int32_t>(least - given.begin());
  }
}

}  // namespace pinball

#include "box_pairs.hpp"

namespace pinball {

template <class S>
void BoxPairs<S>::Found::make_room(std::size_t more) {
  if (pairs + more <= second.size()) return;
  first.resize(std::max(pairs + more, 2 * second.size()));
  second.resize(first.size());
}

template <class S>
std::int32_t BoxPairs<S>::piece_begin(std::int64_t piece) const {
  const std::int64_t begin = groups_ * piece / fixed_pieces * ball_group<S>;
  return static_cast<std::int32_t>(std::min(begin, static_cast<std::int64_t>(count_)));
}

template <class S>
std::int64_t BoxPairs<S>::pairs() const {
  std::int64_t sum = 0;
  for (const Found& found : found_) sum += static_cast<std::int64_t>(found.pairs);
  return sum;
}

template <class S>
std::size_t BoxPairs<S>::bytes() const {
  std::size_t sum = tree_.bytes();
  for (const NearBoxes<S>& near : near_) sum += near.bytes();
  for (const Found& found : found_) sum += (found.first.capacity() + found.second.capacity()) * sizeof(std::int32_t);
  return sum;
}

template class BoxPairs<double>;
template class BoxPairs<float>;

}  // namespace pinball

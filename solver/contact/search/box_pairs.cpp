#include "box_pairs.hpp"

namespace pinball {

template <class S>
void BoxPairs<S>::cut_into_pieces(const MovingBoxes<S>& boxes) {
  for (std::int64_t piece = 0; piece <= fixed_pieces; ++piece) {
    const std::int64_t begin = boxes.groups() * piece / fixed_pieces * ball_group<S>;
    begins_[piece] = std::min<std::int64_t>(begin, boxes.count());
  }
}

template <class S>
ContactSearch BoxPairs<S>::choose(const MovingBoxes<S>& boxes, ContactSearch how) {
  has_tree_ = how != ContactSearch::hash;
  if (!has_tree_) return how;
  tree_.build(boxes);
  constexpr std::int64_t most_met = 100;  // above, the tree takes longer (docs/performance.md)
  return suitable_search(how, tree_.view(), 1, boxes.groups(), most_met);
}

template <class S>
void BoxPairs<S>::prepare_to_look_up(const MovingBoxes<S>& boxes) {
  if (!has_tree_) tree_.build(boxes);
  has_tree_ = true;
}

template <class S>
void BoxPairs<S>::find_groups(std::span<const MovingBox<S>> boxes, std::vector<std::int32_t>& groups) const {
  groups.clear();
  if (tree_.view().levels == 1) {
    groups.push_back(0);
    return;
  }
  MovingBox<S> around = empty_box<S>();
  for (const MovingBox<S>& box : boxes) include_box(around, box);
  for_each_meeting_box<Pack<S, native_width<S>>>(tree_.view(), around, 1, 0,
                                                 [&groups](std::int32_t group) { groups.push_back(group); });
}

template <class S>
std::int64_t BoxPairs<S>::pairs() const {
  std::int64_t sum = 0;
  for (const PairColumns& found : sorted_) sum += found.pairs;
  return sum;
}

template <class S>
std::size_t BoxPairs<S>::bytes() const {
  std::size_t sum = tree_.bytes() + hash_.bytes() + order_.bytes();
  for (const NearBoxes<S>& near : near_) sum += near.bytes();
  for (const NearCells<S>& cells : cells_) sum += cells.bytes();
  for (const PairColumns& found : sorted_) sum += found.bytes();
  return sum;
}

template class BoxPairs<double>;
template class BoxPairs<float>;

}  // namespace pinball

#include "box_tree.hpp"

#include <algorithm>

#include <kernels/compress.hpp>
#include <kernels/exec.hpp>

namespace pinball {

namespace {

/// Whether a box of a group has other bounds at the end than at the beginning.
template <class S>
bool any_box_moves(const S* boxes) {
  constexpr int G = ball_group<S>;
  bool moves = false;
  for (int i = 0; i < 6 * G; ++i) moves = moves || boxes[i] != boxes[6 * G + i];
  return moves;
}

}  // namespace

template <class S>
void BoxTree<S>::build(const MovingBoxes<S>& boxes) {
  constexpr int G = ball_group<S>;
  view_.moves = false;
  parallel_reduce(
      "moving boxes", RangePolicy<>{0, boxes.groups()}, view_.moves,
      [&boxes](std::int64_t begin, std::int64_t end, bool& moves) {
        for (std::int64_t g = begin; g < end && !moves; ++g) moves = any_box_moves(boxes.data() + g * 12 * G);
      },
      [](bool& whole, bool partial) { whole = whole || partial; });
  levels_.build(boxes.data(), boxes.groups(), view_);
}

template <class S>
ContactSearch suitable_search(ContactSearch asked, const BoxTreeView<S>& tree, int level, std::int64_t boxes,
                              std::int64_t most_met) {
  using T = Pack<S, native_width<S>>;
  if (asked != ContactSearch::automatic) return asked;
  if (boxes <= most_met) return ContactSearch::tree;
  std::int64_t samples = 0, met = 0;
  for (std::int64_t box = 0; box < boxes; box += std::max<std::int64_t>(16, boxes / 64), ++samples) {
    for_each_meeting_box<T>(tree, get_box(tree.box[level], box), level, 0, [&met](std::int32_t) { ++met; });
  }
  return met > samples * most_met ? ContactSearch::hash : ContactSearch::tree;
}

template <class S>
void NearBoxes<S>::enter(const BoxTreeView<S>& tree, std::int32_t group, bool anew) {
  using T = Pack<S, native_width<S>>;
  group_ = group;
  if (tree.levels == 1) {
    near_part_.clear();
    candidate_.resize(1);
    found_.resize(2 * G);
    return;
  }
  if (anew || group % G == 0) {  // groups of one box have much the same near them: it is looked for once
    part_.clear();
    if (tree.levels == 2) {
      part_.push_back(0);
    } else {
      for_each_meeting_box<T>(tree, get_box(tree.box[2], group / G), 2, group / G,
                              [this](std::int32_t part) { part_.push_back(part); });
    }
    candidate_.resize((part_.size() + 1) * G);
    found_.resize(std::max(found_.size(), candidate_.size() * G));
  }
  const MovingBox<S> box = get_box(tree.box[1], group);
  near_part_.resize(part_.size());
  std::size_t near = 0;
  for (const std::int32_t part : part_) {
    near_part_[near] = part;
    near += meeting_boxes<T>(tree.boxes(1, part), box) != 0 ? 1 : 0;
  }
  near_part_.resize(near);
}

/// No loop has a branch that depends on what is found: nothing tells the processor which boxes meet.
template <class S>
template <bool moves>
std::size_t NearBoxes<S>::find_moving(const BoxTreeView<S>& tree, int i) {
  using T = Pack<S, native_width<S>>;
  const MovingBox<S> box = get_box(tree.box[0], group_ * G + i);
  std::int32_t* candidate_end = candidate_.data();
  if (tree.levels == 1) *candidate_end++ = 0;
  for (const std::int32_t part : near_part_) {
    const unsigned bits = meeting_boxes<T, moves>(tree.boxes(1, part), box);
    const std::int32_t before = std::clamp(group_ - part * G, 0, G);  // those that do not count
    candidate_end += write_numbers<G>(bits >> before << before, part * G, candidate_end);
  }
  std::int32_t* end = found_.data();
  for (const std::int32_t* candidate = candidate_.data(); candidate < candidate_end; ++candidate) {
    const unsigned bits = meeting_boxes<T, moves>(tree.boxes(0, *candidate), box);
    const std::int32_t before = *candidate == group_ ? i + 1 : 0;  // each pair once
    end += write_numbers<G>(bits >> before << before, *candidate * G, end);
  }
  return end - found_.data();
}

template <class S>
std::span<const std::int32_t> NearBoxes<S>::find(const BoxTreeView<S>& tree, int i) {
  return {found_.data(), tree.moves ? find_moving<true>(tree, i) : find_moving<false>(tree, i)};
}

template ContactSearch suitable_search(ContactSearch, const BoxTreeView<double>&, int, std::int64_t, std::int64_t);
template ContactSearch suitable_search(ContactSearch, const BoxTreeView<float>&, int, std::int64_t, std::int64_t);
template class BoxTree<double>;
template class BoxTree<float>;
template class NearBoxes<double>;
template class NearBoxes<float>;

}  // namespace pinball

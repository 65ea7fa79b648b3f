#include "box_tree.hpp"

#include <algorithm>
#include <cmath>

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
void GroupDirections<S>::reset(std::int64_t groups) {
  const std::int64_t parts = std::max<std::int64_t>(1, (groups + G - 1) / G);
  value_.renew(parts * 4 * G);
  for (std::int64_t group = groups; group < parts * G; ++group) set(group, {S(0), S(0), S(0)}, S(-HUGE_VAL));
}

template <class S>
void GroupDirections<S>::set(std::int64_t group, const Vec3<S>& normal, S reach) {
  const S value[4] = {normal.x, normal.y, normal.z, reach};
  for (std::int64_t c = 0; c < 4; ++c) value_[(group / G * 4 + c) * G + group % G] = value[c];
}

template <class S>
unsigned GroupDirections<S>::with(std::int64_t group, std::int64_t part) const {
  using T = Pack<S, native_width<S>>;
  const auto own = [&](std::int64_t c) { return T(value_[(group / G * 4 + c) * G + group % G]); };
  unsigned bits = 0;
  for (int first = 0; first < G; first += width_of<T>) {
    const auto other = [&](std::int64_t c) { return load<T>(value_.data() + (part * 4 + c) * G + first); };
    const T cosine = own(0) * other(0) + own(1) * other(1) + own(2) * other(2);
    bits |= lane_bits<T>(cosine < own(3) + other(3)) << first;
  }
  return bits;
}

template <class S>
void NearBoxes<S>::enter(const BoxTreeView<S>& tree, std::int32_t group, bool anew,
                         const GroupDirections<S>* directions) {
  using T = Pack<S, native_width<S>>;
  group_ = group;
  one_level_ = tree.levels == 1;
  if (one_level_) {
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
  of_part_.resize(part_.size());
  std::size_t near = 0;
  for (const std::int32_t part : part_) {
    const std::int32_t before = std::clamp(group_ - part * G, 0, G);  // those that do not count
    unsigned bits = meeting_boxes<T>(tree.boxes(1, part), box) >> before << before;
    if (directions != nullptr) bits &= directions->with(group, part);
    near_part_[near] = part;
    of_part_[near] = bits;
    near += bits != 0 ? 1 : 0;
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
  for (std::size_t p = 0; p < near_part_.size(); ++p) {
    const unsigned bits = meeting_boxes<T, moves>(tree.boxes(1, near_part_[p]), box) & of_part_[p];
    candidate_end += write_numbers<G>(bits, near_part_[p] * G, candidate_end);
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
template class GroupDirections<double>;
template class GroupDirections<float>;
template class BoxTree<double>;
template class BoxTree<float>;
template class NearBoxes<double>;
template class NearBoxes<float>;

}  // namespace pinball

#include "pair_list.hpp"

#include <algorithm>
#include <cstddef>

#include <kernels/compress.hpp>
#include <kernels/exec.hpp>
#include <kernels/reference_balls.hpp>
#include <solver/base/lists_in_order.hpp>

namespace pinball {

template <class S>
void PairList<S>::build(const SurfacePinballs<S>& pinballs, const MovingBalls<S>& balls, bool self, ContactSearch how,
                        const ContactPairs* pairs, bool spheres_apart, Sharers* sharers, const JoinedBodies& joined) {
  const Wanted wanted{pinballs, pairs, spheres_apart};
  remember();
  boxes_.build(balls);
  collect_references(pinballs, joined);
  has_pair_.assign(pinballs.count, 0);
  constexpr std::int64_t most_met = 300;  // above, the tree takes longer (docs/performance.md)
  if (suitable_search(how, boxes_.view(), 0, boxes_.view().groups, most_met) == ContactSearch::hash) {
    find_by_hash(pinballs, self, wanted);
  } else {
    const PieceShare share(sharers, fixed_pieces, pinballs.count);
    find(pinballs, self, wanted, share);
    if (share.is_shared()) add_from_others(share);
  }
  number(pinballs);
  recall();
}

template <class S>
std::int32_t PairList<S>::piece_begin(std::int64_t piece) const {
  const std::int64_t begin = boxes_.view().groups * piece / fixed_pieces * ball_group<S>;
  return std::min<std::int64_t>(begin, has_pair_.size());
}

template <class S>
void PairList<S>::collect_references(const SurfacePinballs<S>& pinballs, const JoinedBodies& joined) {
  if (pinballs.count == 0) return;
  constexpr std::int64_t G = ball_group<S>;
  const std::int64_t groups = boxes_.view().groups;
  reference_.renew(groups * reference_components * G);
  parallel_for("reference balls", RangePolicy<>{0, groups}, [&](std::int64_t group) {
    float* reference = reference_.data() + group * reference_components * G;
    for (std::int64_t i = 0; i < G; ++i) {
      const std::int64_t last = pinballs.count - 1;
      const std::size_t p = std::min(group * G + i, last);  // padding repeats the last
      for (std::int64_t c = 0; c < 4; ++c) reference[c * G + i] = pinballs.reference[p][c];
      reference[4 * G + i] = joined.first(pinballs.body[p]);
    }
  });
}

/// The pairs of each piece, and which pinballs have any.
template <class S>
void PairList<S>::find(const SurfacePinballs<S>& pinballs, bool self, const Wanted& wanted, const PieceShare& share) {
  constexpr int G = ball_group<S>;
  const BallTreeView<S>& tree = boxes_.view();
  parallel_for("neighbours", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    Found& found = found_[piece];
    found.pairs = 0;
    if (!share.is_own(piece)) return;
    NearBalls<S>& near = near_[piece];
    const std::int32_t begin = piece_begin(piece) / G, end = (piece_begin(piece + 1) + G - 1) / G;
    for (std::int32_t group = begin; group < end; ++group) {
      // Groups of one box have much the same part of the tree near them: it is looked for once.
      if (group == begin || group % G == 0) {
        near.enter(tree, tree.levels > 1 ? get_box(tree.box[1], group / G) : empty_box<S>(), group);
      }
      const S* own = tree.balls(group);
      const auto groups = near.find(tree, own, group);
      leave_out(group, groups);
      NearBalls<S>::leave_out_passing(tree, own, groups);
      leave_out_neighbours(pinballs, self, group, groups);
      if (!wanted.all()) leave_out_unwanted(wanted, group, groups);
      append(group, groups, found);
    }
  });
}

template <class S>
void PairList<S>::add_from_others(const PieceShare& share) {
  std::vector<std::byte> message;
  for (const Found& found : found_) found.put_into(message);
  share.to_all(message, [this](std::span<const std::byte> theirs) {
    for (Found& found : found_) {
      const std::size_t before = found.pairs;
      found.add_from(theirs);
      for (std::size_t pair = before; pair < found.pairs; ++pair) {
        mark(found.first[pair]);
        mark(found.second[pair]);
      }
    }
  });
}

template <class S>
void PairList<S>::find_by_hash(const SurfacePinballs<S>& pinballs, bool self, const Wanted& wanted) {
  by_hash_.find(pinballs, boxes_.view(), reference_.data(), self);
  parallel_for("pairs by a hash", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    const auto firsts = by_hash_.pairs().firsts(piece), seconds = by_hash_.pairs().seconds(piece);
    Found& found = found_[piece];
    found.first.assign(firsts.begin(), firsts.end());
    found.second.assign(seconds.begin(), seconds.end());
    found.pairs = firsts.size();
    if (!wanted.all()) keep_wanted(wanted, found);
    for (std::size_t pair = 0; pair < found.pairs; ++pair) {
      mark(found.first[pair]);
      mark(found.second[pair]);
    }
  });
}

template <class S>
void PairList<S>::leave_out(std::int32_t group, std::span<typename NearBalls<S>::Group> near) const {
  constexpr int G = ball_group<S>;
  const auto reference = [this](std::int64_t g) { return reference_.data() + g * reference_components * G; };
  for (auto& other : near) {
    if (other.number == group) {  // each pair once
      for (int i = 0; i < G; ++i) other.balls.clear_in_row(i, (2U << i) - 1);
    }
    other.same = balls_of_one_body<S>(reference(group), reference(other.number));
    if (!other.same.any()) continue;
    const BallBits<G> apart = balls_apart<S>(reference(group), reference(other.number));
    for (int w = 0; w < apart.words; ++w) other.balls.word[w] &= apart.word[w] | ~other.same.word[w];
  }
}

template <class S>
void PairList<S>::leave_out_neighbours(const SurfacePinballs<S>& pinballs, bool self, std::int32_t group,
                                       std::span<typename NearBalls<S>::Group> near) const {
  constexpr int G = ball_group<S>;
  for (auto& other : near) {
    for (int w = 0; w < other.same.words; ++w) {
      for (std::uint64_t bits = other.balls.word[w] & other.same.word[w]; bits != 0; bits &= bits - 1) {
        const int bit = 64 * w + __builtin_ctzll(bits);
        const std::size_t a = group * G + bit / G;
        const std::size_t b = other.number * G + bit % G;
        const bool may =
            (self || pinballs.body[a] != pinballs.body[b]) && !share_corner(pinballs.corners[a], pinballs.corners[b]);
        if (!may) other.balls.clear_in_row(bit / G, 1U << bit % G);
      }
    }
  }
}

template <class S>
void PairList<S>::leave_out_unwanted(const Wanted& wanted, std::int32_t group,
                                     std::span<typename NearBalls<S>::Group> near) {
  constexpr int G = ball_group<S>;
  for (auto& other : near) {
    for (int w = 0; w < other.balls.words; ++w) {
      for (std::uint64_t bits = other.balls.word[w]; bits != 0; bits &= bits - 1) {
        const int bit = 64 * w + __builtin_ctzll(bits);
        const std::size_t a = group * G + bit / G;
        const std::size_t b = other.number * G + bit % G;
        if (!wanted(a, b)) other.balls.clear_in_row(bit / G, 1U << bit % G);
      }
    }
  }
}

template <class S>
void PairList<S>::keep_wanted(const Wanted& wanted, Found& found) {
  std::size_t kept = 0;
  for (std::size_t pair = 0; pair < found.pairs; ++pair) {
    const std::int32_t first = found.first[pair], second = found.second[pair];
    if (!wanted(first, second)) continue;
    found.first[kept] = first;
    found.second[kept++] = second;
  }
  found.pairs = kept;
}

template <class S>
bool PairList<S>::Wanted::operator()(std::size_t a, std::size_t b) const {
  if (spheres_apart && pinballs.is_sphere(a) != pinballs.is_sphere(b)) return false;
  return pairs == nullptr ||
         pairs->elements(pinballs.slot[a], pinballs.corners[a], pinballs.slot[b], pinballs.corners[b]).may;
}

template <class S>
double PairList<S>::stored_energy() const {
  double sum = 0;
  for (std::size_t i = 0; i < stored_.size(); ++i) sum += offset_[i] < S(0) ? 0.0 : static_cast<double>(stored_[i]);
  return sum;
}

template <class S>
void PairList<S>::append(std::int32_t group, std::span<const typename NearBalls<S>::Group> near, Found& found) {
  constexpr int G = ball_group<S>;
  const std::size_t most = found.pairs + (near.size() + 1) * G * G;  // and room to write more than there is
  if (found.second.size() < most) {
    found.first.resize(std::max(most, 2 * found.second.size()));
    found.second.resize(found.first.size());
  }
  const std::size_t before = found.pairs;
  std::int32_t* second = found.second.data() + before;
  const std::int32_t own = group * G;
  for (std::int32_t i = own; i < own + G; ++i) {
    std::int32_t* const begin = second;
    for (const auto& other : near) second += write_numbers<G>(other.balls.row(i - own), other.number * G, second);
    std::int32_t* first = found.first.data() + (begin - found.second.data());
    for (std::int32_t* const end = first + (second - begin); first < end; first += G) std::fill(first, first + G, i);
    if (second != begin) mark(i);
  }
  found.pairs = second - found.second.data();
  for (std::size_t pair = before; pair < found.pairs; ++pair) mark(found.second[pair]);
}

/// A pinball has a pair: several pieces may say this at the same time.
template <class S>
void PairList<S>::mark(std::int32_t pinball) {
  set_mark(has_pair_[pinball]);
}

/// Numbers the pinballs that have a pair, and puts the pairs one after the other.
template <class S>
void PairList<S>::number(const SurfacePinballs<S>& pinballs) {
  constexpr std::int64_t W = native_width<S>;
  const auto found = [this](std::int64_t p) -> Found& { return found_[p]; };
  parallel_for("listed pinballs", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t p) {
    found(p).pinballs = std::count(has_pair_.begin() + piece_begin(p), has_pair_.begin() + piece_begin(p + 1), 1);
  });
  std::int64_t places = 0;
  std::int32_t listed = 0;
  for (std::int64_t p = 0; p < fixed_pieces; ++p) {
    const std::int64_t end = places + found(p).pairs;
    piece_[p] = {places, end, listed, listed + found(p).pinballs};
    places = (end + W - 1) / W * W;
    listed += found(p).pinballs;
  }
  number_.resize(has_pair_.size());
  listed_.resize(listed);
  slot_.resize(listed);
  parallel_for("numbers", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t p) {
    std::size_t next = piece(p).pinballs_begin;
    for (std::int32_t i = piece_begin(p); i < piece_begin(p + 1); ++i) {
      if (has_pair_[i] == 0) continue;
      number_[i] = next;
      listed_[next] = i;
      slot_[next] = pinballs.slot[i];
      ++next;
    }
  });
  first_.renew(places);
  second_.renew(places);
  offset_.renew(places);
  stored_.renew(places);
  parallel_for("pairs", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t p) {
    const auto number_of = [this](std::int32_t pinball) { return number_[pinball]; };
    const std::size_t begin = piece(p).begin;
    const auto end = p + 1 < fixed_pieces ? piece(p + 1).begin : first_.size();
    const std::size_t pairs = found(p).pairs, place = begin + pairs;
    const std::int32_t *first = found(p).first.data(), *second = found(p).second.data();
    std::transform(first, first + pairs, first_.data() + begin, number_of);
    std::transform(second, second + pairs, second_.data() + begin, number_of);
    std::fill(first_.data() + place, first_.data() + end, 0);
    std::fill(second_.data() + place, second_.data() + end, 0);
    std::fill(offset_.data() + begin, offset_.data() + end, S(-1));
    std::fill(stored_.data() + begin, stored_.data() + end, S(0));
  });
}

template <class S>
void PairList<S>::remember() {
  parallel_for("pairs in contact", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t p) {
    std::vector<PairMemory>& memory = memory_[p];
    memory.clear();
    for (std::int64_t i = piece(p).begin; i < piece(p).end; ++i) {
      if (offset_[i] < S(0)) continue;
      memory.push_back({slot_[first_[i]], slot_[second_[i]], offset_[i], stored_[i]});
    }
  });
}

template <class S>
std::int64_t PairList<S>::find_pair(std::int32_t first, std::int32_t second) const {
  const auto piece = std::partition_point(piece_.begin(), piece_.end(),
                                          [first](const PairPiece& p) { return p.pinballs_end <= first; });
  std::int64_t low = piece->begin, high = piece->end;
  while (low < high) {
    const std::int64_t middle = (low + high) / 2;
    if (first_[middle] < first || (first_[middle] == first && second_[middle] < second)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < piece->end && first_[low] == first && second_[low] == second ? low : -1;
}

template <class S>
void PairList<S>::recall() {
  const auto number_of_slot = [this](std::int32_t slot) {
    const auto found = std::lower_bound(slot_.begin(), slot_.end(), slot);  // pinballs are in the order of slots
    return found != slot_.end() && *found == slot ? static_cast<std::int32_t>(found - slot_.begin()) : -1;
  };
  parallel_for("pairs still in contact", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t p) {
    for (const PairMemory& m : memory_[p]) {
      const std::int32_t first = number_of_slot(m.first), second = number_of_slot(m.second);
      if (first < 0 || second < 0) continue;
      const std::int64_t place = find_pair(first, second);
      if (place < 0) continue;
      offset_[place] = m.offset;
      stored_[place] = m.stored;
    }
  });
}

template <class S>
double PairList<S>::end_pairs_of_inactive(const S* outward) {
  const auto inactive = [outward](std::int32_t p) { return !(record(outward, p)[3] > S(0)); };
  double sum = 0;
  for (std::size_t i = 0; i < offset_.size(); ++i) {
    if (offset_[i] < S(0) || !(inactive(first_[i]) || inactive(second_[i]))) continue;
    sum += stored_[i];
    offset_[i] = S(-1);
    stored_[i] = S(0);
  }
  return sum;
}

template <class S>
void PairList<S>::persist(StateArchive& archive, const SurfacePinballs<S>& pinballs) {
  archive(piece_, listed_, slot_, first_, second_, offset_, stored_);
  if (archive.reads()) check(archive, pinballs);
}

/// Of a list that was read: that it is one of these pinballs.
template <class S>
void PairList<S>::check(const StateArchive& archive, const SurfacePinballs<S>& pinballs) const {
  constexpr std::int64_t W = native_width<S>;
  archive.require_all(listed_, 0, pinballs.count);
  archive.require(slot_.size() == listed_.size());
  for (std::size_t i = 0; i < listed_.size(); ++i) {
    archive.require(slot_[i] == pinballs.slot[listed_[i]] && (i == 0 || listed_[i - 1] < listed_[i]));
  }
  const std::int64_t count = first_.size();
  archive.require(second_.size() == first_.size() && offset_.size() == first_.size() &&
                  stored_.size() == first_.size());
  archive.require_all(first_, 0, size());
  archive.require_all(second_, 0, size());
  std::int64_t place = 0;
  std::int32_t pinball = 0;
  for (const PairPiece& p : piece_) {
    archive.require(p.begin >= place && p.begin % W == 0 && p.end >= p.begin && p.end <= count);
    place = (p.end + W - 1) / W * W;
    archive.require(place <= count && p.pinballs_begin == pinball && p.pinballs_end >= pinball);
    pinball = p.pinballs_end;
    archive.require(pinball <= size());
    for (std::int64_t i = p.begin; i < p.end; ++i) {
      archive.require(first_[i] >= p.pinballs_begin && first_[i] < pinball && first_[i] < second_[i]);
    }
  }
  archive.require(pinball == size());
}

template <class S>
std::int64_t PairList<S>::pairs() const {
  std::int64_t sum = 0;
  for (const PairPiece& p : piece_) sum += p.end - p.begin;
  return sum;
}

template <class S>
std::size_t PairList<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  std::size_t sum = of(listed_) + of(slot_) + of(has_pair_) + of(number_) + first_.bytes() + second_.bytes() +
                    offset_.bytes() + stored_.bytes() + boxes_.bytes() + reference_.bytes() + by_hash_.bytes();
  for (const NearBalls<S>& near : near_) sum += near.bytes();
  for (const std::vector<PairMemory>& memory : memory_) sum += of(memory);
  for (const Found& found : found_) sum += found.PairColumns::bytes();
  return sum;
}

template class PairList<double>;
template class PairList<float>;

}  // namespace pinball

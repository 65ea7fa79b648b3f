#include "pair_forces.hpp"

#include <algorithm>

#include <kernels/compress.hpp>
#include <kernels/exec.hpp>

namespace pinball {

/// Pairs that overlap, until there are enough of them for full packs.
template <class S>
struct PairForces<S>::Waiting {
  static constexpr int most = 256;  // so that all of it stays in the nearest cache
  int count = 0;
  alignas(64) std::int32_t place[most + 2 * W], first[most + 2 * W], second[most + 2 * W];
  alignas(64) S offset[most + 2 * W];

  /// Takes the pairs of a pack of the list that the mask tells.
  void append(unsigned bits, std::int32_t place_of_first, const ListedPairs<S>& pairs, std::int64_t from) {
    write_lanes<W>(bits, pairs.first + from, first + count);
    write_lanes<W>(bits, pairs.second + from, second + count);
    write_lanes<W>(bits, pairs.offset + from, offset + count);
    count += write_numbers<W>(bits, place_of_first, place + count);
  }
  /// Keeps those after the first `done`.
  void drop(int done) {
    for (int i = done; i < count; ++i) {
      place[i - done] = place[i];
      first[i - done] = first[i];
      second[i - done] = second[i];
      offset[i - done] = offset[i];
    }
    count -= done;
  }
  /// Fills the last pack with its last pair.
  void pad() {
    for (int i = count; i % W != 0; ++i) {
      place[i] = place[count - 1];
      first[i] = first[count - 1];
      second[i] = second[count - 1];
      offset[i] = offset[count - 1];
    }
  }
};

template <class S>
void PairForces<S>::compute_pack(const PinballView<S>& view, const PenaltyConstants<S>& constants, const List& list,
                                 S dt, const PairPiece& piece, const Waiting& waiting, int begin, int pairs,
                                 Work& work) {
  using T = Pack<S, W>;
  const std::size_t number = work.pairs / W;
  if (number == work.touches.size()) work.touches.resize(std::max<std::size_t>(16, 2 * number));
  Touch& touch = work.touches[number];
  T offsets = load<T>(waiting.offset + begin);
  const PairForce<T> f = pair_force(view, constants, waiting.first + begin, waiting.second + begin, offsets, dt);
  alignas(64) S offset[W], stored[W], damped[W], ratio[W];
  store(offsets, offset);
  store(f.stored, stored);
  store(f.damped, damped);
  store(f.penetration_ratio, ratio);
  store(f.force.x, touch.force[0]);
  store(f.force.y, touch.force[1]);
  store(f.force.z, touch.force[2]);
  store(f.stiffness, touch.force[3]);
  S* const offset_of = list.pairs.offset + piece.begin;
  S* const stored_of = list.pairs.stored + piece.begin;
  for (int i = 0; i < W; ++i) {
    touch.first[i] = waiting.first[begin + i];
    touch.second[i] = waiting.second[begin + i];
  }
  for (int i = 0; i < pairs; ++i) {  // pairs without contact have zeros
    const std::int32_t place = waiting.place[begin + i];
    offset_of[place] = offset[i];
    stored_of[place] = stored[i];
    work.sums.add(stored[i], damped[i], ratio[i], touch.first[i], !(offset[i] < S(0)));
    if (touch.second[i] < piece.pinballs_end) continue;
    work.elsewhere.push_back(
        {touch.second[i], {-touch.force[0][i], -touch.force[1][i], -touch.force[2][i], touch.force[3][i]}});
  }
  work.pairs += pairs;
}

template <class S>
void PairForces<S>::compute_piece(const PinballView<S>& view, const PenaltyConstants<S>& constants, const List& list,
                                  S dt, const PairPiece& piece, Work& work) {
  using T = Pack<S, W>;
  work.pairs = 0;
  work.elsewhere.clear();
  work.sums = {};
  const std::int64_t first = piece.begin, end = piece.end;
  const ListedPairs<S>& pairs = list.pairs;
  Waiting waiting;
  for (std::int64_t place = first; place < end; place += W) {
    unsigned bits = touching_pairs<T>(view.centre, pairs.first + place, pairs.second + place, pairs.offset + place);
    if (place + W > end) bits &= (1U << (end - place)) - 1;
    waiting.append(bits, place - first, pairs, place);
    if (waiting.count < Waiting::most) continue;
    const int full = waiting.count / W * W;
    for (int i = 0; i < full; i += W) compute_pack(view, constants, list, dt, piece, waiting, i, W, work);
    waiting.drop(full);
  }
  waiting.pad();
  for (int i = 0; i < waiting.count; i += W) {
    compute_pack(view, constants, list, dt, piece, waiting, i, std::min(W, waiting.count - i), work);
  }
}

template <class S>
PairSums<S> PairForces<S>::compute(const PinballView<S>& view, const PenaltyConstants<S>& constants, const List& list,
                                   S dt, S* force) {
  const auto work_of = [this](std::int64_t piece) -> Work& { return work_[piece]; };
  const auto piece_of = [&list](std::int64_t piece) -> const PairPiece& { return list.pieces[piece]; };
  parallel_for("contact forces", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    const PairPiece& range = piece_of(piece);
    compute_piece(view, constants, list, dt, range, work_of(piece));
    std::fill(record(force, range.pinballs_begin), record(force, range.pinballs_end), S(0));
  });
  // Second pinballs of other pieces: these pairs come before all that begin with the pinball's own piece.
  for (const Work& work : work_) {
    for (const Elsewhere& e : work.elsewhere) {
      for (int k = 0; k < 4; ++k) record(force, e.pinball)[k] += e.force[k];
    }
  }
  parallel_for("contact force sums", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    const Work& work = work_of(piece);
    for (std::int64_t i = 0; i < work.pairs; i += W) {
      const int pairs = std::min<std::int64_t>(W, work.pairs - i);
      add_to_pinballs<Pack<S, W>>(work.touches[i / W], pairs, piece_of(piece).pinballs_end, force);
    }
  });
  PairSums<S> sums;
  for (const Work& work : work_) sums.join(work.sums);
  return sums;
}

template <class S>
std::size_t PairForces<S>::bytes() const {
  std::size_t sum = 0;
  for (const Work& work : work_) {
    sum += work.touches.capacity() * sizeof(Touch) + work.elsewhere.capacity() * sizeof(Elsewhere);
  }
  return sum;
}

template class PairForces<double>;
template class PairForces<float>;

}  // namespace pinball

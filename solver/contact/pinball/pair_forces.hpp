#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <kernels/contact_force.hpp>
#include <kernels/exec/host_loops.hpp>
#include <kernels/pinball_sums.hpp>
#include <solver/base/point.hpp>
#include <solver/contact/algorithm/pinball_kernels.hpp>

namespace pinball {

/// The penalty forces of the pairs of a list, summed per pinball. Every pinball sums its pairs in the order of the
/// other pinball's number, so that results depend neither on the number of threads nor on what else is listed.
template <class S>
class PairForces {
 public:
  /// A list in fixed_pieces, as the host has it.
  struct List {
    ListedPairs<S> pairs;
    std::span<const PairPiece> pieces;
  };
  /// force: records of all listed pinballs, written: F, sum of p2 [force], [force/length]. dt: the step just made.
  PairSums<S> compute(const PinballView<S>& view, const PenaltyConstants<S>& constants, const List& list, S dt,
                      S* force);
  /// Calls visit(first, second, force on the first) for the pairs of the last compute(), in one order.
  template <class Visit>
  void for_each_touch(const Visit& visit) const;
  std::size_t bytes() const;

 private:
  static constexpr int W = native_width<S>;
  using Touch = PairTouch<S, W>;
  /// A pair whose second pinball belongs to another piece.
  struct Elsewhere {
    std::int32_t pinball;
    S force[4];  ///< on it, and p2
  };
  /// Of one piece, kept for their memory.
  struct Work {
    std::vector<Touch> touches;  ///< pairs that overlap in full packs; with room for more
    std::int64_t pairs = 0;      ///< of these, the first
    std::vector<Elsewhere> elsewhere;
    PairSums<S> sums;
  };
  struct Waiting;
  static void compute_piece(const PinballView<S>& view, const PenaltyConstants<S>& constants, const List& list, S dt,
                            const PairPiece& piece, Work& work);
  static void compute_pack(const PinballView<S>& view, const PenaltyConstants<S>& constants, const List& list, S dt,
                           const PairPiece& piece, const Waiting& waiting, int begin, int pairs, Work& work);

  std::array<Work, fixed_pieces> work_;
};

template <class S>
template <class Visit>
void PairForces<S>::for_each_touch(const Visit& visit) const {
  for (const Work& work : work_) {
    for (std::int64_t i = 0; i < work.pairs; ++i) {
      const Touch& touch = work.touches[i / W];
      const std::size_t lane = i % W;
      visit(touch.first[lane], touch.second[lane],
            Point{touch.force[0][lane], touch.force[1][lane], touch.force[2][lane]});
    }
  }
}

}  // namespace pinball

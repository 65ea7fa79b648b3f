#pragma once

#include <array>
#include <cstdint>
#include <pinball/solver/aligned_array.hpp>
#include <pinball/solver/moving_balls.hpp>
#include <pinball/solver/surface_pinballs.hpp>
#include <vector>

namespace pinball {

/// For each pinball the pinballs that it may touch in a time to come. Pinballs that may touch none are left out: the
/// list numbers the others, in the same order. Every pair stands in both lists; lists are sorted, and padded to whole
/// packs with the pinball itself. Per entry it keeps what a pair in contact remembers (contact_force.hpp); this
/// survives a rebuild.
template <class S>
class NeighbourList {
 public:
  /// Builds the list from nothing. balls: one per pinball; self: a body may touch itself.
  void build(const SurfacePinballs<S>& pinballs, const MovingBalls<S>& balls, bool self);

  std::int32_t size() const { return static_cast<std::int32_t>(listed_.size()); }  ///< pinballs that have neighbours
  /// Number among all pinballs of each one that is listed.
  const std::vector<std::int32_t>& listed() const { return listed_; }
  const std::int32_t* neighbours(std::int32_t pinball) const {
    return neighbour_.data() + start_[static_cast<std::size_t>(pinball)];
  }
  std::int32_t count(std::int32_t pinball) const { return count_[static_cast<std::size_t>(pinball)]; }
  /// Depths at which the pairs of a pinball began, negative for pairs that are not in contact.
  S* offsets(std::int32_t pinball) { return offset_.data() + start_[static_cast<std::size_t>(pinball)]; }
  /// Spring energy of the pairs of a pinball, half of each pair [energy].
  S* stored(std::int32_t pinball) { return stored_.data() + start_[static_cast<std::size_t>(pinball)]; }
  /// Ends all pairs of which a pinball takes no part any more; returns their spring energy [energy].
  /// outward: records of the listed pinballs, whose fourth number is B R, or 0.
  double end_pairs_of_inactive(const S* outward);
  std::int64_t pairs() const;  ///< listed, each counted once
  /// Entries and padding.
  std::int64_t places() const { return start_.empty() ? 0 : start_.back(); }
  std::size_t bytes() const;

 private:
  /// A pair in contact, by the slots of its elements: what a rebuild carries over.
  struct Memory {
    std::int32_t slot, other;
    S offset, stored;
  };
  std::vector<Memory> remember() const;
  void recall(const std::vector<Memory>& memory);
  /// First pinball of a piece.
  std::int32_t piece_begin(std::int64_t piece) const;
  void find(const SurfacePinballs<S>& pinballs, const MovingBalls<S>& balls, bool self);
  void join(const SurfacePinballs<S>& pinballs);

  static constexpr std::int64_t pieces = 64;  ///< of the work; the result does not depend on it
  std::vector<std::int64_t> start_;
  std::vector<std::int32_t> count_;
  std::vector<std::int32_t> listed_, slot_;
  std::vector<std::int32_t> neighbour_;
  AlignedArray<S> offset_, stored_;  ///< per entry of neighbour_
  // What follows is kept for its memory alone.
  BallTree<S> boxes_;
  struct Pair {
    std::int32_t first, second;
  };
  std::array<std::vector<std::int32_t>, pieces> above_;  ///< neighbours of higher number of each piece's pinballs
  std::array<std::vector<Pair>, pieces> crossing_;       ///< those of them that belong to another piece
  std::vector<std::int32_t> count_above_, count_below_;  ///< neighbours of higher and lower number, per pinball
  std::vector<std::int32_t> number_;                     ///< in the list, of each pinball that is listed
  std::vector<std::int64_t> next_;                       ///< entry of the list to be filled next
};

}  // namespace pinball

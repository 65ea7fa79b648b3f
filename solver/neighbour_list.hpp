#pragma once

#include <array>
#include <cstdint>
#include <pinball/kernels/spatial_hash.hpp>
#include <pinball/solver/pinball_store.hpp>
#include <vector>

namespace pinball {

/// For each pinball the pinballs that it may touch before something has moved by half the skin. Every pair stands in
/// both lists; lists are sorted, and padded to whole packs with the pinball itself. Per entry it keeps what a pair in
/// contact remembers (contact_force.hpp); this survives a rebuild.
template <class S>
class NeighbourList {
 public:
  /// What decides whether two pinballs of one body may touch.
  struct SameBody {
    bool allowed = true;                                                  ///< contact of a body with itself
    const std::vector<std::array<float, 3>>* reference_centre = nullptr;  ///< per slot, of the undeformed mesh [length]
  };

  /// Builds the list from nothing: spatial hash, then candidates in fixed pieces, then one list in order. It is to hold
  /// the pairs whose distance is less than reach_factor (R1 + R2).
  void build(const PinballStore<S>& pinballs, S reach_factor, S skin, const SameBody& same_body);

  /// True while no pinball has moved by more than half the skin since the list was built.
  bool holds(const PinballStore<S>& pinballs) const;

  void invalidate() { valid_ = false; }
  const std::int32_t* neighbours(std::int32_t pinball) const {
    return neighbour_.data() + start_[static_cast<std::size_t>(pinball)];
  }
  std::int32_t count(std::int32_t pinball) const { return count_[static_cast<std::size_t>(pinball)]; }
  /// Depths at which the pairs of a pinball began, negative for pairs that are not in contact.
  S* offsets(std::int32_t pinball) { return offset_.data() + start_[static_cast<std::size_t>(pinball)]; }
  /// Spring energy of the pairs of a pinball, half of each pair [energy].
  S* stored(std::int32_t pinball) { return stored_.data() + start_[static_cast<std::size_t>(pinball)]; }
  /// Ends all pairs of which a pinball takes no part any more (B R = 0); returns their spring energy [energy].
  double end_pairs_of_inactive(const PinballStore<S>& pinballs);
  std::int64_t pairs() const { return pairs_; }  ///< listed, each counted once
  std::size_t bytes() const;

 private:
  /// A pair in contact, by the slots of its elements: what a rebuild carries over.
  struct Memory {
    std::int32_t slot, other;
    S offset, stored;
  };
  std::vector<Memory> remember() const;
  void recall(const std::vector<Memory>& memory);

  bool valid_ = false;
  S skin_ = 0;
  std::int64_t pairs_ = 0;
  std::vector<std::int64_t> start_;
  std::vector<std::int32_t> count_;
  std::vector<std::int32_t> neighbour_;
  AlignedArray<S> offset_, stored_;  ///< per entry of neighbour_
  std::vector<std::int32_t> slot_;   ///< of each pinball when the list was built
  std::vector<S> built_at_;          ///< centres when the list was built, records of four
  std::vector<std::int32_t> bucket_start_, entry_point_;
  std::vector<std::uint64_t> entry_cell_, cell_;
  std::vector<S> entry_record_;
};

}  // namespace pinball

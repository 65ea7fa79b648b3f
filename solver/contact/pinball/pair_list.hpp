#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/contact/algorithm/pinball_kernels.hpp>
#include <solver/contact/search/moving_balls.hpp>
#include <solver/contact/surface/joined_bodies.hpp>

#include "ball_pairs.hpp"
#include "surface_pinballs.hpp"

namespace pinball {

/// The pairs of pinballs that may touch in a time to come, each once. Pinballs that may touch none are left out: the
/// list numbers the others, in the same order. Pairs are sorted by their first pinball, which has the lower number, and
/// then by their second. Per pair the list keeps what a pair in contact remembers (contact_force.hpp); this survives a
/// rebuild.
///
/// For work in parallel the list comes in fixed_pieces: consecutive pinballs and the pairs of which they are the first.
/// Each piece begins at a whole pack, so that there are places without a pair between pieces.
template <class S>
class PairList {
 public:
  /// Builds the list from nothing. balls: one per pinball; self: a body may touch itself; how: the list is the same;
  /// pairs: of the scene, which may touch, or null; spheres_apart: balls of spheres meet each other alone; sharers: who
  /// all have these pinballs and build the list together, or null; joined: bodies that hang together.
  void build(const SurfacePinballs<S>& pinballs, const MovingBalls<S>& balls, bool self,
             ContactSearch how = ContactSearch::automatic, const ContactPairs* pairs = nullptr,
             bool spheres_apart = false, Sharers* sharers = nullptr, const JoinedBodies& joined = {});
  double stored_energy() const;  ///< of the springs of all pairs [energy]

  std::int32_t size() const { return listed_.size(); }  ///< pinballs that have a pair
  /// Number among all pinballs of each one that is listed.
  const std::vector<std::int32_t>& listed() const { return listed_; }
  const PairPiece& piece(std::int64_t number) const { return piece_[number]; }
  std::span<const PairPiece> pieces() const { return piece_; }
  std::int64_t pairs() const;
  std::int64_t places() const { return first_.size(); }  ///< of pairs, and between pieces
  /// Listed pinballs of each place; any valid ones where there is no pair.
  const std::int32_t* first() const { return first_.data(); }
  const std::int32_t* second() const { return second_.data(); }
  /// Depth at which each pair began, negative for pairs that are not in contact [length].
  S* offset() { return offset_.data(); }
  const S* offset() const { return offset_.data(); }
  S* stored() { return stored_.data(); }  ///< spring energy of each pair [energy]
  /// All of these, as loops work on them. Where there is no pair a pinball is named twice.
  ListedPairs<S> listed_pairs() { return {places(), first(), second(), offset(), stored()}; }
  /// Ends all pairs of which a pinball takes no part any more; returns their spring energy [energy].
  /// outward: records of the listed pinballs, whose fourth number is B R, or 0.
  double end_pairs_of_inactive(const S* outward);
  void persist(StateArchive& archive, const SurfacePinballs<S>& pinballs);
  std::size_t bytes() const;

 private:
  /// A pair in contact, by the slots of its elements: what a rebuild carries over.
  struct PairMemory {
    std::int32_t first, second;
    S offset, stored;
  };
  /// The pairs of which the pinballs of a piece are the first, in the order of the list.
  struct Found : PairColumns {  // numbers among all pinballs
    std::int32_t pinballs = 0;  ///< of the piece, that have a pair
  };
  void check(const StateArchive& archive, const SurfacePinballs<S>& pinballs) const;
  void remember();
  void recall();
  /// Place of a pair of listed pinballs; -1 if it is not listed.
  std::int64_t find_pair(std::int32_t first, std::int32_t second) const;
  /// First of all pinballs of a piece.
  std::int32_t piece_begin(std::int64_t piece) const;
  void collect_references(const SurfacePinballs<S>& pinballs, const JoinedBodies& joined);
  /// Of two pinballs, by their numbers: whether their pair is wanted, and whether there are some that are not.
  struct Wanted {
    const SurfacePinballs<S>& pinballs;
    const ContactPairs* pairs;
    bool spheres_apart;
    bool all() const { return pairs == nullptr && !spheres_apart; }
    bool operator()(std::size_t a, std::size_t b) const;
  };
  void find(const SurfacePinballs<S>& pinballs, bool self, const Wanted& wanted, const PieceShare& share);
  void add_from_others(const PieceShare& share);
  void find_by_hash(const SurfacePinballs<S>& pinballs, bool self, const Wanted& wanted);
  /// What may come near the balls of a group without what is listed already, and without pairs of one body, or of
  /// joined ones, that were not apart in the undeformed mesh.
  void leave_out(std::int32_t group, std::span<typename NearBalls<S>::Group> near) const;
  /// The same without pairs of elements that share a corner, and without those of one body if it may not touch itself.
  void leave_out_neighbours(const SurfacePinballs<S>& pinballs, bool self, std::int32_t group,
                            std::span<typename NearBalls<S>::Group> near) const;
  static void leave_out_unwanted(const Wanted& wanted, std::int32_t group,
                                 std::span<typename NearBalls<S>::Group> near);
  static void keep_wanted(const Wanted& wanted, Found& found);
  void append(std::int32_t group, std::span<const typename NearBalls<S>::Group> near, Found& found);
  void mark(std::int32_t pinball);
  void number(const SurfacePinballs<S>& pinballs);

  std::array<PairPiece, fixed_pieces> piece_{};
  std::vector<std::int32_t> listed_, slot_;
  Array<std::int32_t> first_, second_;
  Array<S> offset_, stored_;
  // What follows is kept for its memory alone.
  BallTree<S> boxes_;
  BallPairs<S> by_hash_;
  Array<float> reference_;  ///< groups of G balls of the undeformed mesh (reference_balls.hpp)
  std::array<std::vector<PairMemory>, fixed_pieces> memory_;  ///< of the pairs of a piece
  std::array<NearBalls<S>, fixed_pieces> near_;
  std::array<Found, fixed_pieces> found_;
  std::vector<std::uint8_t> has_pair_;  ///< per pinball
  std::vector<std::int32_t> number_;    ///< in the list, of each pinball that is listed
};

}  // namespace pinball

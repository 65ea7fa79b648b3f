#pragma once

#include <cstdint>

#include "contact_force.hpp"
#include "pinball_geometry.hpp"

/// Penalty forces by one thread for each pair, pinball and node, each of which adds what others have found for it in
/// the order in which the host's packs do: no two threads write to one place.
namespace pinball {

/// Sums over the pairs in contact.
template <class S>
struct PairSums {
  double stored = 0;          ///< energy of the springs [energy]
  double damped = 0;          ///< power of the damping [power]
  S penetration_ratio = 0;    ///< largest g / (R1 + R2) [-]
  std::int32_t deepest = -1;  ///< first pinball of that pair; negative: there is none
  std::int64_t pairs = 0;

  /// A pair, and whether it is in contact; of those with the largest ratio the one of the lowest pinball counts.
  PINBALL_FUNCTION void add(S stored_by_it, S damped_by_it, S ratio, std::int32_t first, bool in_contact) {
    stored += stored_by_it;
    damped += damped_by_it;
    keep_deepest(ratio, first);
    pairs += in_contact ? 1 : 0;
  }
  PINBALL_FUNCTION void join(const PairSums& other) {
    stored += other.stored;
    damped += other.damped;
    keep_deepest(other.penetration_ratio, other.deepest);
    pairs += other.pairs;
  }

 private:
  PINBALL_FUNCTION void keep_deepest(S ratio, std::int32_t first) {
    if (!(ratio > penetration_ratio || (ratio == penetration_ratio && first < deepest))) return;
    penetration_ratio = ratio;
    deepest = first;
  }
};

/// The records of pinballs that forces follow from.
template <class S>
PINBALL_FUNCTION PinballView<S> pinballs_of(const PinballGeometryView<S>& of) {
  return {of.centre, of.velocity, of.outward, of.two_sided};
}

/// Pairs of listed pinballs and what each remembers (pair_force). Places between pairs name one pinball twice.
template <class S>
struct ListedPairs {
  std::int64_t places = 0;
  const std::int32_t* first = nullptr;
  const std::int32_t* second = nullptr;
  S* offset = nullptr;  ///< negative: not in contact [length]
  S* stored = nullptr;  ///< spring energy [energy]
};

/// The force of each pair in contact.
template <class S>
struct FindPairForces {
  PinballView<S> pinballs;
  PenaltyConstants<S> constants;
  ListedPairs<S> pairs;
  S* force;  ///< records of the pairs: on the first, and p2; others than those in contact have anything
  S dt;      ///< the step just made

  PINBALL_FUNCTION void operator()(std::int64_t i, PairSums<S>& sum) const {
    const std::int32_t *const first = pairs.first + i, *const second = pairs.second + i;
    if (touching_pairs<S>(pinballs.centre, first, second, pairs.offset + i) == 0) return;
    S offset = pairs.offset[i];
    const PairForce<S> pair = pair_force<S>(pinballs, constants, first, second, offset, dt);
    pairs.offset[i] = offset;
    pairs.stored[i] = pair.stored;
    S* const own = record(force, i);
    own[0] = pair.force.x;
    own[1] = pair.force.y;
    own[2] = pair.force.z;
    own[3] = pair.stiffness;
    sum.add(pair.stored, pair.damped, pair.penetration_ratio, *first, !(offset < S(0)));
  }
};

/// Of each of some things those entries of a list that are its own: first[i] ... first[i + 1] - 1.
struct EntriesOf {
  const std::uint32_t* first = nullptr;
  const std::uint32_t* entry = nullptr;
};

/// Sums per pinball over its pairs, in the order of the other pinball's number.
template <class S>
struct SumPairForces {
  EntriesOf pairs;      ///< of each pinball: twice the place of the pair, and one more where it is its first
  const S* offset;      ///< of pairs
  const S* pair_force;  ///< of FindPairForces
  S* force;             ///< records of the pinballs: F, sum of p2

  PINBALL_FUNCTION void operator()(std::int64_t p) const {
    S sum[4] = {};
    for (std::uint32_t e = pairs.first[p]; e < pairs.first[p + 1]; ++e) {
      const std::int64_t pair = pairs.entry[e] / 2;
      if (offset[pair] < S(0)) continue;
      const S* const of = record(pair_force, pair);
      const S sign = pairs.entry[e] % 2 != 0 ? S(1) : S(-1);
      for (int k = 0; k < 3; ++k) sum[k] += sign * of[k];
      sum[3] += of[3];
    }
    for (int k = 0; k < 4; ++k) record(force, p)[k] = sum[k];
  }
};

/// The largest of some numbers that are not negative.
template <class S>
struct LargestOf {
  S number = 0;
  PINBALL_FUNCTION void join(const LargestOf& other) { number = other.number > number ? other.number : number; }
};

/// Row of a node in the stiffness matrix over its mass, as its contacts bound it (add_to_node) [1/time^2].
template <class S>
PINBALL_FUNCTION S contact_row(const S* force, const S* inverse_mass, std::int64_t node) {
  return record(force, node)[3] * inverse_mass[node];
}

/// Adds the shares of their pinballs to the nodes of a list.
template <class S>
struct LoadNodes {
  const std::int32_t* node;
  EntriesOf pinballs;      ///< of each of these nodes, a pinball as often as the node is its corner
  const S* pinball_force;  ///< records of SumPairForces
  S* force;                ///< node records
  const S* inverse_mass;   ///< per node of the store

  PINBALL_FUNCTION void operator()(std::int64_t i, LargestOf<S>& row) const {
    const std::int64_t n = node[i];
    for (std::uint32_t e = pinballs.first[i]; e < pinballs.first[i + 1]; ++e) {
      const S* const of = record(pinball_force, pinballs.entry[e]);
      if (of[3] > S(0)) add_to_node(record(force, n), of);
    }
    row.join({contact_row(force, inverse_mass, n)});
  }
};

}  // namespace pinball

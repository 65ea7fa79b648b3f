#pragma once

#include <cstdint>

#include "corner_differences.hpp"
#include "element_data.hpp"
#include "tensor.hpp"

/// What becomes of the results of an element kernel (element_update.hpp): sums, and forces of corners.
namespace pinball {

/// What a tile of elements reports, per lane until the end of the tile.
template <class T>
struct ElementSums {
  T internal = T(0);           ///< increment of the internal energy [energy]
  T hourglass = T(0);          ///< increment of the hourglass energy, stored or (viscous form) lost [energy]
  T viscous = T(0);            ///< increment of the bulk viscosity energy [energy]
  T eroded = T(0);             ///< internal energy of elements eroded in this step [energy]
  T stable_rate = T(0);        ///< largest 2/dt of a stable step dt [1/time]
  T stable_rate_pack = T(0);   ///< pack in which it was found, counted in the tile
  T hourglass_plastic = T(0);  ///< of `internal`: what yield has taken from the hourglass modes [energy]
  T folding = T(0);            ///< stored now by corners that are about to turn over [energy]
  int eroded_count = 0;
  int inside_out_count = 0;  ///< elements with a corner whose Jacobian is not positive, eroded ones left out
  int inverted_count = 0;    ///< elements with a volume that is not positive (or NaN) and that are not eroded for it
};

/// What a caller that asks for nothing ahead puts between the parts of update_element_pack.
struct NothingAhead {
  PINBALL_FUNCTION void operator()(int /*part*/) const {}
};

/// Forces of corners are added to the records of their nodes, corner after corner, and of each lane after lane. In
/// mixed precision that of corner 0 is what balances the others (add_balance_to_records).
template <class N>
struct AddedToNodes {
  N* force;  ///< records of four (NodeView) [force]

  template <class T, int L>
  PINBALL_FUNCTION void take(std::int64_t /*first*/, const std::int32_t* corner, const Vec3<T> (&value)[8]) const {
    constexpr bool mixed = sizeof(N) != sizeof(ScalarOf<T>);
    if constexpr (mixed) add_balance_to_records(force, corner, value);
    PINBALL_UNROLL
    for (int i = mixed ? 1 : 0; i < 8; ++i) {
      add_to_records(force, corner + i * L, value[i].x, value[i].y, value[i].z, T(0));
    }
  }
};

/// Forces of corners are kept for who adds them up later: component c of corner i is number 3 i + c of an array of
/// N = 24 like those of ElementView. Those of dead packs stay as they are: zero since their elements eroded.
template <class S>
struct KeptAtCorners {
  S* force;                ///< [force]
  std::int64_t begin = 0;  ///< element with which the array begins, the first of a row

  template <class T, int L>
  PINBALL_FUNCTION void take(std::int64_t first, const std::int32_t* /*corner*/, const Vec3<T> (&value)[8]) const {
    S* const place = force + place_in_rows<L>(first - begin, 24);
    PINBALL_UNROLL
    for (int i = 0; i < 8; ++i) {
      store(value[i].x, place + (3 * i + 0) * L);
      store(value[i].y, place + (3 * i + 1) * L);
      store(value[i].z, place + (3 * i + 2) * L);
    }
  }
};

}  // namespace pinball

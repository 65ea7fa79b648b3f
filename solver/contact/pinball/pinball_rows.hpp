#pragma once

#include <solver/contact/impulses/impulse_solver.hpp>
#include <solver/contact/surface/surface.hpp>

#include "pair_list.hpp"
#include "pinball_store.hpp"

namespace pinball {

/// Distance, over R1 + R2, up to which a pair may get a row [-]: what the list has to hold. Balls have to overlap, but
/// for what they approach within a step.
inline constexpr double pinball_pair_margin = 1.1;

/// Adds a row for each pair of listed pinballs that may touch within the coming step, in the order of the list: named
/// by the slots of their elements (kernels/contact_row.hpp). pairs: by which pairs of the scene they touch, or null.
template <class S>
void add_pinball_rows(const PinballStore<S>& pinballs, const PairList<S>& list, const ContactPairs* pairs,
                      ImpulseSolver<S>& impulses);

}  // namespace pinball

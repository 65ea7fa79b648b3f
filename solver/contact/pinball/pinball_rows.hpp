#pragma once

#include <solver/contact/impulses/impulse_solver.hpp>
#include <solver/contact/surface/surface.hpp>

#include "pair_list.hpp"
#include "pinball_store.hpp"

namespace pinball {

/// Distance, over R1 + R2, up to which a pair may get a row [-]: what the list has to hold.
double pinball_pair_margin(ContactGap gap);

/// Adds a row for each pair of listed pinballs that may touch within the coming step, in the order of the list: named
/// by the slots of their elements, with a gap of the kind asked for (kernels/contact_row.hpp).
template <class S>
void add_pinball_rows(const SurfaceSource<S>& source, ContactGap gap, const PinballStore<S>& pinballs,
                      const PairList<S>& list, const Surface& surface, ImpulseSolver<S>& impulses);

}  // namespace pinball

#pragma once

#include <vector>

#include <solver/contact/impulses/impulse_solver.hpp>
#include <solver/contact/surface/surface.hpp>

#include "pair_list.hpp"
#include "pinball_store.hpp"

namespace pinball {

/// Distance, over R1 + R2, up to which a pair may get a row [-]: what the list has to hold.
double pinball_pair_margin(ContactGap gap);

/// Pairs of listed pinballs that may touch within the coming step, for enforcement by impulses: each pair once, named
/// by the slots of its elements, with the gap that the scene chooses (kernels/contact_row.hpp).
template <class S>
std::vector<ContactPair> pinball_pairs(const SurfaceSource<S>& source, const PinballStore<S>& pinballs,
                                       const PairList<S>& list, const Surface& surface);

}  // namespace pinball

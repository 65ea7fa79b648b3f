#pragma once

#include <solver/model/model.hpp>

namespace pinball {

/// The longest step in which no body can jump over the surface elements of another: the smallest pinball radius over
/// the largest speed, relative to each other, that two bodies have at the start. Infinite where they have none.
///
/// The stable step is shorter for all impacts below about the wave speed, so that this limits only faster ones.
template <class S>
double longest_contact_step(const Model<S>& model);

}  // namespace pinball

#pragma once

#include "model.hpp"

namespace pinball {

/// Velocities of the store at the start: those of the bodies, and of [[initial_velocity]]. A node that bodies with
/// different velocities share has their mean by the masses that their elements give it, so that all has the momentum of
/// the bodies; where one of them is rigid, the first body's, of which the rigid one takes what is its own.
template <class S>
void set_initial_velocities(Model<S>& model);

}  // namespace pinball

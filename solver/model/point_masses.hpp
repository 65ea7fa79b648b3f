#pragma once

#include "model.hpp"

namespace pinball {

/// [[point_mass]]: puts masses at nodes onto those that their elements give them. `rigid` is in the numbers of the
/// scene. Throws InputError for nodes of a rigid body whose mass, centre or inertia is given.
template <class S>
void add_point_masses(Model<S>& model);

}  // namespace pinball

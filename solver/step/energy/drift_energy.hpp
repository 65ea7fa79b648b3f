#pragma once

#include <solver/model/model.hpp>

namespace pinball {

/// Kinetic energy of what is common to all motion [energy]: |P|^2 / 2M of the momentum along the directions in which
/// nothing tells motion from rest. A scene that is watched from a vehicle has more of it, and nothing in it happens by
/// that. Not common are directions in which nodes are held or their velocities prescribed, the normals of rigid walls,
/// and with friction of walls or damping all directions: there rest is what these say.
/// momentum: of all nodes [mass length/time].
template <class S>
double drift_energy(const Model<S>& model, const Point& momentum);

/// What is less is that of nothing but rounding [energy]: of all mass with 1e-13 of the fastest speed of sound, and of
/// elements in single precision whose laws see volumes with 1e-6 of theirs, for what is rounded of volumes presses;
/// with joints, also what gravity, loads and pressures do over 1e-13 of the scene's reach, to which they keep places.
template <class S>
double energy_at_rest(const Model<S>& model);

}  // namespace pinball

#pragma once

#include <vector>

#include "model.hpp"

namespace pinball {

/// Stresses and plastic strains of the store at the start: those of [[initial_stress]], of which the last that selects
/// an element counts. Where elements keep their internal energy, it is that of initial_strain_energies().
/// Throws InputError that names the table for elements of a rigid body, of a law whose stress is one of the whole
/// deformation, and of a mean stress where a law has its pressure from the volume.
template <class S>
void set_initial_stresses(Model<S>& model);

/// What the initial stresses have stored in each body: by Hooke's law, with the bulk modulus K and the shear modulus G,
///
///     V (s:s/(4 G) + p^2/(2 K)) ,     s and p: deviator and mean of the stress, V: volume of the element [energy]
///
/// Empty where the scene has none.
template <class S>
std::vector<double> initial_strain_energies(const Model<S>& model);

}  // namespace pinball

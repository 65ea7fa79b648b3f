#pragma once

#include <array>

#include <solver/scene_rules.hpp>

namespace pinball {

/// 6 by 6, symmetric: xx yy zz xy yz zx, the last three with engineering shear strains.
using ElasticMatrix = std::array<std::array<double, 6>, 6>;

/// Stress over strain in the axes a, b, c of the material [stress]. law: without a problem.
ElasticMatrix moduli_along_axes(const OrthotropicSettings& law);
/// The same in the axes of the scene.
ElasticMatrix moduli_in_scene(const OrthotropicSettings& law);

/// Of an isotropic material [stress].
struct IsotropicModuli {
  double bulk, shear;
};
/// The mean of the moduli over all directions (Voigt, Lehrbuch der Kristallphysik, 1928): for what knows one stiffness
/// of a material, such as contact and hourglass control.
IsotropicModuli mean_moduli(const OrthotropicSettings& law);

}  // namespace pinball

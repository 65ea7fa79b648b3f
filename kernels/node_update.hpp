#pragma once

#include <cstdint>
#include <pinball/kernels/macros.hpp>

/// Accelerations and central-difference integration of one node (report figure 4, 5 and 6):
///
///     a_n = f_n / m ,  v_(n+1/2) = v_(n-1/2) + (dt_(n-1/2) + dt_(n+1/2))/2 a_n ,  x_(n+1) = x_n + dt_(n+1/2) v_(n+1/2)
///
/// Constraints act on the force and the velocity before (constrain_node), so that a constrained direction stays exactly
/// at rest and does no work.
namespace pinball {

/// Removes the components of force and velocity along a unit normal (a plane of symmetry, a single-direction
/// constraint).
template <class S>
PINBALL_FUNCTION void constrain_node(S* force, S* velocity, const S* normal) {
  const S f = force[0] * normal[0] + force[1] * normal[1] + force[2] * normal[2];
  const S v = velocity[0] * normal[0] + velocity[1] * normal[1] + velocity[2] * normal[2];
  for (int c = 0; c < 3; ++c) {
    force[c] -= f * normal[c];
    velocity[c] -= v * normal[c];
  }
}

/// Integrates one node record and clears its force for the next step.
/// velocity_step: (dt_(n-1/2) + dt_(n+1/2))/2; position_step: dt_(n+1/2); energy_step: dt_(n-1/2) [time].
///
/// Returns v_(n-1/2) . (v_(n-1/2) + dt_(n-1/2) a_n): half of it times the mass is the kinetic energy at time n whose
/// sum with the trapezoidal work of the forces is constant to round-off at a constant step.
template <class S>
PINBALL_FUNCTION S integrate_node(S* position, S* velocity, S* force, S inverse_mass, S velocity_step, S position_step,
                                  S energy_step) {
  const S factor = velocity_step * inverse_mass, energy_factor = energy_step * inverse_mass;
  S product[3];
  for (int c = 0; c < 3; ++c) {
    const S old = velocity[c];
    const S updated = old + factor * force[c];
    velocity[c] = updated;
    position[c] += position_step * updated;
    product[c] = old * (old + energy_factor * force[c]);
  }
  for (int c = 0; c < 4; ++c) force[c] = S(0);
  return product[0] + product[1] + product[2];
}

}  // namespace pinball

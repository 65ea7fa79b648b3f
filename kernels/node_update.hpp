#pragma once

#include <cstdint>

#include "simd.hpp"

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

/// What integration has to tell of a node, or of components of it.
template <class T>
struct NodeMotion {
  T kinetic;  ///< v_(n-1/2) . (v_(n-1/2) + dt_(n-1/2) a_n) [velocity^2]
  T change;   ///< |v_(n+1/2) - v_(n-1/2)|^2 [velocity^2]
};

/// Sums over nodes.
struct MotionEnergy {
  double kinetic = 0;  ///< at the time of the forces [energy]
  double change = 0;   ///< of what the step has changed velocities by: 1/2 m |v_(n+1/2) - v_(n-1/2)|^2 [energy]

  template <class T>
  PINBALL_FUNCTION void add(double mass, const NodeMotion<T>& node) {
    kinetic += 0.5 * mass * node.kinetic;
    change += 0.5 * mass * node.change;
  }
  PINBALL_FUNCTION void join(const MotionEnergy& other) {
    kinetic += other.kinetic;
    change += other.change;
  }
};

/// Integrates components of a node record, as many as T has lanes. factor: velocity_step / m, energy_factor:
/// energy_step / m of each.
template <class T>
PINBALL_FUNCTION NodeMotion<T> integrate_components(ScalarOf<T>* position, ScalarOf<T>* velocity,
                                                    const ScalarOf<T>* force, const T& factor, const T& energy_factor,
                                                    const T& position_step) {
  const T old = load<T>(velocity), f = load<T>(force);
  const T updated = old + factor * f, change = updated - old;
  store(updated, velocity);
  store(load<T>(position) + position_step * updated, position);
  return {old * (old + energy_factor * f), change * change};
}

/// Integrates one node record and clears its force for the next step; records are aligned to four scalars.
/// velocity_step: (dt_(n-1/2) + dt_(n+1/2))/2; position_step: dt_(n+1/2); energy_step: dt_(n-1/2) [time].
///
/// Half of NodeMotion::kinetic times the mass is the kinetic energy at time n whose sum with the trapezoidal work of
/// the forces is constant to round-off at a constant step.
template <class S>
PINBALL_FUNCTION NodeMotion<S> integrate_node(S* position, S* velocity, S* force, S inverse_mass, S velocity_step,
                                              S position_step, S energy_step) {
  const S factor = velocity_step * inverse_mass, energy_factor = energy_step * inverse_mass;
  NodeMotion<S> sum;
  if constexpr (native_width<S> >= 4) {  // a record is a pack, of which the fourth number stays as it is
    using T = Pack<S, 4>;
    const auto component = [](S value) { return select(lane_numbers<T>() < T(3), T(value), T(0)); };
    const NodeMotion<T> of = integrate_components<T>(position, velocity, force, component(factor),
                                                     component(energy_factor), component(position_step));
    sum.kinetic = lane(of.kinetic, 0) + lane(of.kinetic, 1) + lane(of.kinetic, 2);
    sum.change = lane(of.change, 0) + lane(of.change, 1) + lane(of.change, 2);
    store(T(0), force);
  } else {
    sum = {S(0), S(0)};
    for (int c = 0; c < 3; ++c) {
      const NodeMotion<S> of =
          integrate_components<S>(position + c, velocity + c, force + c, factor, energy_factor, position_step);
      sum.kinetic += of.kinetic;
      sum.change += of.change;
    }
    for (int c = 0; c < 4; ++c) force[c] = S(0);
  }
  return sum;
}

}  // namespace pinball

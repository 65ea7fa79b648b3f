#pragma once

#include "../hexahedron.hpp"
#include "../stable_time_step.hpp"

/// The shapes of a pack's elements that a step needs: at its end, from which forces come, and in its middle, from which
/// strains come. Divisions and roots begin here, as early as they can (element_update.hpp).
namespace pinball {

/// At the end of the step just made, x_n.
template <class T>
struct EndGeometry {
  /// x: modes of x_n; needs_length: whether anything asks for the length.
  PINBALL_FUNCTION EndGeometry(const HexahedronModes<T>& x, const T& mass, const MaskOf<T>& alive, bool needs_length)
      : b(uniform_gradient(x)),
        volume(hexahedron_volume(b, x)),
        square(gradient_square(b)),
        trace_square(trace(square)),
        largest_square(largest_principal_value(square)),
        inverse_mass(T(1) / select(alive, mass, T(1))),
        area(face_area(trace_square)),
        length(0) {
    if (needs_length) length = volume / area;
  }

  UniformGradient<T> b;
  T volume;             ///< of any sign [length^3]
  Symmetric<T> square;  ///< sum_I B_I (x) B_I [length^4]
  T trace_square;       ///< its trace
  T largest_square;     ///< its largest principal value, from above
  T inverse_mass;       ///< 1 where there is no element [1/mass]
  T area, length;       ///< of the edge and the face of a cube: face_area [length^2], V/area [length]
};

/// In the middle of the step just made, x_(n-1/2) = x_n - dt/2 v, so that a rigid rotation of any size gives no strain.
template <class T>
struct MiddleGeometry {
  /// x, v: modes of x_n and v_(n-1/2); dt: [time]; end_volume: at the end of the step.
  PINBALL_FUNCTION MiddleGeometry(const HexahedronModes<T>& x_end, const HexahedronModes<T>& v, ScalarOf<T> dt,
                                  const T& end_volume, const MaskOf<T>& alive)
      : x(half_a_step_back(x_end, v, dt)),
        b(uniform_gradient(x)),
        volume(hexahedron_volume(b, x)),
        has_volume(minimum(end_volume, volume) > T(0)),
        whole(alive && has_volume) {
    // Both inverses from one division. An element that is not there, or has lost its volume, has no rates and no
    // forces.
    const T inverse_both = select(whole, T(1) / (end_volume * volume), T(0));
    inverse_end_volume = inverse_both * volume;
    inverse_volume = inverse_both * end_volume;
  }

  HexahedronModes<T> x;  ///< the mean of the corners is left out
  UniformGradient<T> b;
  T volume;                              ///< [length^3]
  MaskOf<T> has_volume;                  ///< here and at the end of the step; no number is none
  MaskOf<T> whole;                       ///< there, with volumes
  T inverse_volume, inverse_end_volume;  ///< zero where not whole [1/length^3]

 private:
  PINBALL_FUNCTION static HexahedronModes<T> half_a_step_back(const HexahedronModes<T>& x_end,
                                                              const HexahedronModes<T>& v, ScalarOf<T> dt) {
    HexahedronModes<T> back;
    const T minus_half_dt(ScalarOf<T>(-0.5) * dt);
    PINBALL_UNROLL
    for (int m = 0; m < 3; ++m) back.linear[m] = x_end.linear[m] + minus_half_dt * v.linear[m];
    PINBALL_UNROLL
    for (int m = 0; m < 4; ++m) back.hourglass[m] = x_end.hourglass[m] + minus_half_dt * v.hourglass[m];
    return back;
  }
};

}  // namespace pinball

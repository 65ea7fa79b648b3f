#pragma once

#include "../hexahedron.hpp"
#include "../stable_time_step.hpp"

/// The shapes of a pack's elements that a step needs: at its end, from which forces come, and in its middle, from which
/// strains come. Divisions and roots begin here, as early as they can (element_update.hpp).
namespace pinball {

/// What laws of materials and the stable step ask of the shape of an element, whatever it is, at the end of the step
/// just made, x_n.
template <class T>
struct EndSize {
  T volume;          ///< of any sign [length^3]
  T trace_square;    ///< of sum_I B_I (x) B_I, over eight corners of an eighth of the mass each [length^4]
  T largest_square;  ///< its largest principal value, from above
  T inverse_mass;    ///< 1 where there is no element [1/mass]
  T area, length;    ///< of the face and the edge of a cube: face_area [length^2], V/area [length]
};

/// The same in the middle of the step, x_(n-1/2) = x_n - dt/2 v, so that a rigid rotation of any size gives no strain.
template <class T>
struct MiddleSize {
  T volume;                              ///< [length^3]
  MaskOf<T> has_volume;                  ///< here and at the end of the step; no number is none
  MaskOf<T> whole;                       ///< there, with volumes
  T inverse_volume, inverse_end_volume;  ///< zero where not whole [1/length^3]

  /// end_volume: at the end of the step.
  PINBALL_FUNCTION void set(const T& middle_volume, const T& end_volume, const MaskOf<T>& alive) {
    volume = middle_volume;
    has_volume = minimum(end_volume, volume) > T(0);
    whole = alive && has_volume;
    // Both inverses from one division. An element that is not there, or has lost its volume, has no rates and no
    // forces.
    const T inverse_both = select(whole, T(1) / (end_volume * volume), T(0));
    inverse_end_volume = inverse_both * volume;
    inverse_volume = inverse_both * end_volume;
  }
};

/// Of hexahedra.
template <class T>
struct EndGeometry : EndSize<T> {
  /// x: modes of x_n; needs_length: whether anything asks for the length.
  PINBALL_FUNCTION EndGeometry(const HexahedronModes<T>& x, const T& mass, const MaskOf<T>& alive, bool needs_length)
      : b(uniform_gradient(x)) {
    this->volume = hexahedron_volume(b, x);
    square = gradient_square(b);
    this->trace_square = trace(square);
    this->largest_square = largest_principal_value(square);
    this->inverse_mass = T(1) / select(alive, mass, T(1));
    this->area = face_area(this->trace_square);
    this->length = T(0);
    if (needs_length) this->length = this->volume / this->area;
  }

  UniformGradient<T> b;
  Symmetric<T> square;  ///< sum_I B_I (x) B_I [length^4]
};

template <class T>
struct MiddleGeometry : MiddleSize<T> {
  /// x, v: modes of x_n and v_(n-1/2); dt: [time]; end_volume: at the end of the step.
  PINBALL_FUNCTION MiddleGeometry(const HexahedronModes<T>& x_end, const HexahedronModes<T>& v, ScalarOf<T> dt,
                                  const T& end_volume, const MaskOf<T>& alive)
      : x(half_a_step_back(x_end, v, dt)), b(uniform_gradient(x)) {
    this->set(hexahedron_volume(b, x), end_volume, alive);
  }

  HexahedronModes<T> x;  ///< the mean of the corners is left out
  UniformGradient<T> b;

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

#pragma once

#include "../element_data.hpp"
#include "../rotation.hpp"

/// How a pack's elements move in a step: its strain and its spin, from the velocities over the geometry of its middle.
/// Factors of a half belong to the length of the step, which is one number for all: the same bits for fewer operations.
namespace pinball {

/// dt sym(L)
template <class T>
PINBALL_FUNCTION Symmetric<T> strain_of_step(const Tensor<T>& gradient, ScalarOf<T> dt) {
  const T whole(dt), half(ScalarOf<T>(0.5) * dt);
  return {whole * gradient.row_x.x,
          whole * gradient.row_y.y,
          whole * gradient.row_z.z,
          half * (gradient.row_x.y + gradient.row_y.x),
          half * (gradient.row_y.z + gradient.row_z.y),
          half * (gradient.row_z.x + gradient.row_x.z)};
}

/// Half of the axial vector of dt skew(L) [rad].
template <class T>
PINBALL_FUNCTION Vec3<T> half_spin_of_step(const Tensor<T>& gradient, ScalarOf<T> dt) {
  const T quarter(ScalarOf<T>(0.25) * dt);
  return {quarter * (gradient.row_z.y - gradient.row_y.z), quarter * (gradient.row_x.z - gradient.row_z.x),
          quarter * (gradient.row_y.x - gradient.row_x.y)};
}

/// What no feature asks for is not set.
template <class T, ElementFeatures features>
struct StepMotion {
  /// velocity_gradient: over the geometry of the middle of the step [1/time]; dt: [time].
  PINBALL_FUNCTION StepMotion(const Tensor<T>& velocity_gradient, ScalarOf<T> dt) : gradient(velocity_gradient) {
    if constexpr (features.plastic || features.hourglass == HourglassKind::stiffness) {
      rotation = rotation_of_half_spin(half_spin_of_step(gradient, dt));
    }
    if constexpr (features.plastic) {
      strain = strain_of_step(gradient, dt);
    } else {
      half_gradient = T(ScalarOf<T>(0.5) * dt) * gradient;
      strain = twice_symmetric_part(half_gradient);
    }
    volumetric = trace(strain);
  }

  Tensor<T> gradient;       ///< L; zero where an element is not whole [1/time]
  Rotation<T> rotation;     ///< what yields, or has hourglass forces that turn
  Tensor<T> half_gradient;  ///< h = L dt/2 of neo_hookean.hpp, of what does not yield [-]
  Symmetric<T> strain;      ///< of the step [-]
  T volumetric;             ///< its trace [-]
};

}  // namespace pinball

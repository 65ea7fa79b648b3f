#pragma once

#include "../element_data.hpp"
#include "../rotation.hpp"

/// How a pack's elements move in a step: its strain and its spin, from the velocities over the geometry of its middle.
namespace pinball {

/// What no feature asks for is not set.
template <class T, ElementFeatures features>
struct StepMotion {
  /// velocity_gradient: over the geometry of the middle of the step [1/time]; dt: [time].
  PINBALL_FUNCTION StepMotion(const Tensor<T>& velocity_gradient, ScalarOf<T> dt) : gradient(velocity_gradient) {
    if constexpr (features.plastic || features.hourglass == HourglassKind::stiffness) {
      rotation = hughes_winget_rotation(T(dt) * axial_vector(gradient));
    }
    if constexpr (features.plastic) {
      strain = T(dt) * symmetric_part(gradient);
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

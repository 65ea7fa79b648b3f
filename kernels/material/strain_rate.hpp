#pragma once

#include "von_mises.hpp"

/// The rates of strain that a yield stress may depend on.
namespace pinball {

enum class StrainRateMeasure {
  total,       ///< sqrt(D:D) of the rate of deformation
  deviatoric,  ///< sqrt(2/3 D':D') of its deviator
  plastic      ///< d(plastic strain)/dt, which the return finds
};

/// Of the whole strain [1/time]; 0 of the plastic strain, which is not known beforehand. deformation: rate of it, D.
template <class T>
PINBALL_FUNCTION T strain_rate(StrainRateMeasure measure, const Symmetric<T>& deformation) {
  if (measure == StrainRateMeasure::plastic) return T(0);
  if (measure == StrainRateMeasure::total) return square_root(contract(deformation, deformation));
  const Symmetric<T> deviator = deviator_of(deformation);
  return number<T>(0.81649658092772603273) * square_root(contract(deviator, deviator));  // sqrt(2/3)
}

}  // namespace pinball

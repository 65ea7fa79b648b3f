#pragma once

#include "../element_results.hpp"
#include "../material/bulk_viscosity.hpp"
#include "element_pack.hpp"

/// Bulk viscosity of a pack over a step: q of bulk_viscosity.hpp, its work, and its place in the forces. The element
/// keeps q until the next step; its work is that of the mean of old and new q.
namespace pinball {

template <class T>
class ViscousStep {
  using S = ScalarOf<T>;

 public:
  /// acts: whether there is any; then density at the end of the step, length of EndGeometry, gradient of the velocity.
  PINBALL_FUNCTION ViscousStep(bool acts, const ViscosityConstants<S>& constants, const MaterialConstants<S>& material,
                               const T& density, const T& length, const Tensor<T>& gradient)
      : acts_(acts), coefficient_(0), dilatation_(0) {
    if (acts) {
      dilatation_ = gradient.row_x.x + gradient.row_y.y + gradient.row_z.z;
      coefficient_ = bulk_viscosity(T(constants.linear), T(constants.quadratic), density, T(material.sound_speed),
                                    length, dilatation_);
    }
  }

  PINBALL_FUNCTION bool acts() const { return acts_; }
  /// Zero where it does not act [stress time].
  PINBALL_FUNCTION const T& coefficient() const { return coefficient_; }
  /// q, tension positive [stress].
  PINBALL_FUNCTION T stress() const { return coefficient_ * dilatation_; }
  PINBALL_FUNCTION void let_go(const MaskOf<T>& fails) { coefficient_ = select(fails, T(0), coefficient_); }

  /// Keeps q, counts its work in the step, and adds it to the stress that acts. volume: in the middle of the step
  /// [length^3]; volumetric: strain of the step [-].
  template <int L>
  PINBALL_FUNCTION void act(const ElementPack<T, L>& own, const T& volume, const T& volumetric, Symmetric<T>& stress,
                            ElementSums<T>& sums) const {
    if (acts_) {
      const T q_old = own.get(own.arrays.viscous_stress), q = this->stress();
      own.set(own.arrays.viscous_stress, q);
      sums.viscous += number<T>(0.5) * volume * (q_old + q) * volumetric;
      stress.xx += q;
      stress.yy += q;
      stress.zz += q;
    }
  }

 private:
  bool acts_;
  T coefficient_, dilatation_;
};

}  // namespace pinball

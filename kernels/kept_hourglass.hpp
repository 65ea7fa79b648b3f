#pragma once

#include "assumed_strain.hpp"
#include "material/bending_yield.hpp"
#include "rotation.hpp"

/// The two forms of hourglass control that keep a state, with the same functions for the element kernel: the state of
/// one pack of elements over a step, elastic at first, then what yield leaves.
namespace pinball {

template <class T, HourglassKind kind>
class KeptHourglass {};

/// What a loss of state takes: of the stored energy, and of the work of the new state over the step [energy].
template <class T>
struct LostHourglassEnergy {
  T stored, work;
};

template <class T>
class KeptHourglass<T, HourglassKind::assumed_strain> {
 public:
  using Moduli = AssumedStrainModuli<ScalarOf<T>>;

  /// whole: where there is an element with a volume; h: hourglass displacements of the step [length];
  /// reference_volume: of the undeformed element, volume: in the middle of the step [length^3];
  /// state: ElementNumbers before the step.
  template <class State>
  PINBALL_FUNCTION void begin(const Moduli& moduli, const HexahedronModes<T>& x_mid, const HexahedronModes<T>& x,
                              const MaskOf<T>& whole, const Vec3<T> (&h)[4], const T& reference_volume, const T& volume,
                              const State& state) {
    moduli_ = &moduli;
    volume_ = reference_volume;
    acting_volume_ = minimum(reference_volume, T(3) * volume);
    const ElementEdges<T> mid = edges_of(x_mid, whole);
    edges_ = edges_later(x, mid);
    strain_ = assumed_strain(mid, h);
    const AssumedField<T> increment = assumed_stress(moduli, strain_);
    AssumedField<T> sum;
    PINBALL_UNROLL
    for (int c = 0; c < 12; ++c) {
      const T old = state.get(c);
      stress_.c[c] = old + increment.c[c];
      sum.c[c] = old + stress_.c[c];
    }
    work_ = number<T>(0.5) * acting_volume_ * contract(sum, strain_);
  }

  /// Over the step, of the mean of the old and the elastic new state [energy].
  PINBALL_FUNCTION T work() const { return work_; }
  PINBALL_FUNCTION T component(int c) const { return stress_.c[c]; }
  PINBALL_FUNCTION HourglassForce<T> force() const {
    return assumed_strain_force(edges_, stress_, number<T>(0.125) * acting_volume_);
  }
  /// What is lost where the present state is all lost.
  PINBALL_FUNCTION LostHourglassEnergy<T> everything() const {
    return {number<T>(0.5) * volume_ * compliance_product(*moduli_, stress_, stress_),
            acting_volume_ * contract(stress_, strain_)};
  }

  /// Square of its effective stress [stress^2].
  PINBALL_FUNCTION T variation() const { return effective_square(stress_); }
  /// Returns what is lost. material: as of bending_yield.hpp; deviator: of the stress less the back stress; mean: its
  /// q_s^2.
  template <class Law>
  PINBALL_FUNCTION LostHourglassEnergy<T> yield(const Law& material, const Symmetric<T>& deviator, const T& mean,
                                                const T& variation, Symmetric<T>& stress, T& plastic_strain) {
    const CommonStress<T> common = common_stress(edges_, deviator, stress_, material.mu);
    const YieldFactors<T> left = return_in_bending(material, mean, variation, common.alignment, plastic_strain);
    reduce(stress, T(1) - left.mean, deviator);
    // Where S is small, k g S is of its square.
    const auto bends = variation > number<T>(0.01) * mean;
    if (any_lane(bends)) {
      const T to_mean = select(bends, number<T>(1.1547005383792515290) * left.difference, T(0));
      stress = stress + to_mean * deviator_of_shares(edges_, stress_, common.share);
    }
    const T to_field = number<T>(0.86602540378443864676) * left.difference;
    AssumedField<T> lost, sum;
    PINBALL_UNROLL
    for (int c = 0; c < 12; ++c) {
      T remaining = left.mean * stress_.c[c];
      if (c < 9) remaining += to_field * common.of_mean[c];
      lost.c[c] = stress_.c[c] - remaining;
      sum.c[c] = stress_.c[c] + remaining;
      stress_.c[c] = remaining;
    }
    return {number<T>(0.5) * volume_ * compliance_product(*moduli_, lost, sum),
            acting_volume_ * contract(lost, strain_)};
  }

 private:
  const Moduli* moduli_;
  ElementEdges<T> edges_;  ///< at the end of the step
  T volume_, acting_volume_, work_;
  AssumedField<T> strain_, stress_;
};

template <class T>
class KeptHourglass<T, HourglassKind::stiffness> {
 public:
  /// modulus: kappa M; area: face_area at the end of the step, zero where there is no element with a volume; square:
  /// sum_I B_I (x) B_I there, and its trace; volume: of the undeformed element, and its inverse; the others as above.
  template <class State>
  PINBALL_FUNCTION void begin(ScalarOf<T> modulus, const T& area, const Symmetric<T>& square, const T& trace_square,
                              const Symmetric<T>& strain, const Rotation<T>& rotation, const Vec3<T> (&h)[4],
                              const T& volume, const T& inverse_volume, const State& state) {
    modulus_ = modulus;
    area_ = area;
    volume_ = volume;
    work_ = T(0);
    area_mid_ = half_a_step_earlier(area, square, trace_square, strain);
    const T factor = T(ScalarOf<T>(0.75) * modulus) * inverse_volume * area_mid_;
    PINBALL_UNROLL
    for (int a = 0; a < 4; ++a) {
      h_[a] = h[a];
      const Vec3<T> old{state.get(3 * a), state.get(3 * a + 1), state.get(3 * a + 2)};
      const Vec3<T> half = factor * h[a];  // of the increment; turns as half of the stress increment
      z_[a] = rotate(rotation, old + half) + half;
      work_ += dot(old + z_[a], h[a]);
    }
    work_ = T(4) * area_mid_ * work_;
  }

  PINBALL_FUNCTION T work() const { return work_; }
  PINBALL_FUNCTION T component(int c) const {
    const Vec3<T>& z = z_[c / 3];
    return c % 3 == 0 ? z.x : c % 3 == 1 ? z.y : z.z;
  }
  PINBALL_FUNCTION HourglassForce<T> force() const {
    return {{area_ * z_[0], area_ * z_[1], area_ * z_[2], area_ * z_[3]}};
  }

  /// As of the stresses 4 P/A that have these forces in a cube.
  PINBALL_FUNCTION T variation() const { return T(16) * square(); }
  PINBALL_FUNCTION LostHourglassEnergy<T> everything() const { return lost(T(1), T(1)); }
  /// The forces have no tensor that the stress could have something in common with.
  template <class Law>
  PINBALL_FUNCTION LostHourglassEnergy<T> yield(const Law& material, const Symmetric<T>& deviator, const T& mean,
                                                const T& variation, Symmetric<T>& stress, T& plastic_strain) {
    const T left = return_in_bending_unaligned(material, mean, variation, plastic_strain), taken = T(1) - left;
    reduce(stress, taken, deviator);
    const LostHourglassEnergy<T> energy = lost(taken * (T(1) + left), taken);
    PINBALL_UNROLL
    for (int a = 0; a < 4; ++a) z_[a] = left * z_[a];
    return energy;
  }

 private:
  PINBALL_FUNCTION T square() const {
    return dot(z_[0], z_[0]) + dot(z_[1], z_[1]) + dot(z_[2], z_[2]) + dot(z_[3], z_[3]);
  }
  PINBALL_FUNCTION LostHourglassEnergy<T> lost(const T& of_squares, const T& of_state) const {
    const ScalarOf<T> compliance = modulus_ > 0 ? ScalarOf<T>(8.0 / 3.0) / modulus_ : ScalarOf<T>(0);
    const T work = dot(z_[0], h_[0]) + dot(z_[1], h_[1]) + dot(z_[2], h_[2]) + dot(z_[3], h_[3]);
    return {of_squares * T(compliance) * volume_ * square(), of_state * T(8) * area_mid_ * work};
  }

  ScalarOf<T> modulus_;
  T area_, area_mid_, volume_;
  Vec3<T> h_[4], z_[4];
  T work_;
};

}  // namespace pinball

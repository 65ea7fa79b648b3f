#pragma once

#include "../element_results.hpp"
#include "../kept_hourglass.hpp"
#include "element_pack.hpp"
#include "step_geometry.hpp"
#include "step_motion.hpp"

/// Hourglass control of a pack over a step, in any form (hourglass.hpp): forms that keep a state begin elastically,
/// yield with the stress, and store what is left; the viscous form has forces of the present rates, and keeps them for
/// their work alone.
///
/// Work is that of the mean of old and new forces over the step, as that of stresses is: what central differences take
/// from motion. The work of kept forces is stored. What yield and erosion take of the store is plastic work, but for
/// what they take of the work itself.
namespace pinball {

template <class T, ElementFeatures features>
class HourglassStep {
  using S = ScalarOf<T>;
  static constexpr HourglassKind kind = features.hourglass;
  static constexpr bool keeps = keeps_hourglass_state(kind);

 public:
  /// Of what has no hourglass modes.
  HourglassStep() = default;
  /// Begins a step of length dt. x, v: modes of x_n and v_(n-1/2).
  template <int L>
  PINBALL_FUNCTION HourglassStep(const ElementConstants<S>& constants, const ElementPack<T, L>& own,
                                 const HexahedronModes<T>& x, const HexahedronModes<T>& v, const EndGeometry<T>& end,
                                 const MiddleGeometry<T>& middle, const StepMotion<T, features>& motion, S dt) {
    if constexpr (kind != HourglassKind::none) {
      PINBALL_UNROLL
      for (int a = 0; a < 4; ++a) h_[a] = T(dt) * hourglass_rate(motion.gradient, middle.x, v, a);
    }
    if constexpr (kind == HourglassKind::assumed_strain) {
      kept.begin(constants.hourglass.assumed_strain, middle.x, x, middle.whole, h_,
                 own.mass * T(constants.specific_volume), middle.volume, state(own));
    } else if constexpr (kind == HourglassKind::stiffness) {
      kept.begin(constants.hourglass.modulus, select(middle.whole, end.area, T(0)), end.square, end.trace_square,
                 motion.strain, motion.rotation, h_, own.mass * T(constants.specific_volume),
                 T(constants.material.density) * end.inverse_mass, state(own));
    }
  }

  /// Of what is lost: what has become plastic work [energy].
  PINBALL_FUNCTION T taken() const { return lost.stored - number<T>(0.5) * lost.work; }
  /// After yield.
  PINBALL_FUNCTION void count_yield(ElementSums<T>& sums) const {
    if constexpr (keeps) {
      if (any_lost) sums.hourglass_plastic += taken();
    }
  }

  /// After yield: stores the state, and sets the forces that come of it.
  template <int L>
  PINBALL_FUNCTION void store_state(const ElementPack<T, L>& own, ElementSums<T>& sums) {
    if constexpr (keeps) {
      force = kept.force();
      const ElementNumbers<T, L> stored = state(own);
      PINBALL_UNROLL
      for (int c = 0; c < 12; ++c) stored.set(c, kept.component(c));
      sums.hourglass += kept.work();
    }
  }

  /// Elements that fail lose all.
  template <int L>
  PINBALL_FUNCTION void let_go(const ElementPack<T, L>& own, const MaskOf<T>& fails) {
    if constexpr (keeps) {
      any_lost = true;
      const LostHourglassEnergy<T> everything = kept.everything();
      lost.stored += select(fails, everything.stored, T(0));
      lost.work += select(fails, everything.work, T(0));
      PINBALL_UNROLL
      for (int a = 0; a < 4; ++a) force.p[a] = select(fails, Vec3<T>{T(0), T(0), T(0)}, force.p[a]);
      const ElementNumbers<T, L> stored = state(own);
      PINBALL_UNROLL
      for (int c = 0; c < 12; ++c) stored.set(c, select(fails, T(0), kept.component(c)));
    }
  }

  /// Ends a step. Kept forms: what has gone from the store is work of the element. Viscous form: sets the forces, none
  /// where an element fails. density: at the end of the step; area: of EndGeometry; work: of the element's stresses.
  template <int L>
  PINBALL_FUNCTION void end(const ElementConstants<S>& constants, const ElementPack<T, L>& own, const T& density,
                            const T& area, S dt, const MaskOf<T>& fails, T& work, ElementSums<T>& sums) {
    if constexpr (keeps) {
      if (any_lost) {
        sums.hourglass -= lost.stored;
        work += taken();
      }
    } else if constexpr (kind == HourglassKind::viscous) {
      resist_rates(constants, own, density, area, dt, fails, sums);
    }
  }

  KeptHourglass<T, kind> kept;
  HourglassForce<T> force{};
  LostHourglassEnergy<T> lost{T(0), T(0)};  ///< to yield and to erosion
  bool any_lost = false;                    ///< whether any lane may have lost something

 private:
  template <int L>
  PINBALL_FUNCTION static ElementNumbers<T, L> state(const ElementPack<T, L>& own) {
    return own.numbers(own.arrays.hourglass_state, 12);
  }

  template <int L>
  PINBALL_FUNCTION void resist_rates(const ElementConstants<S>& constants, const ElementPack<T, L>& own,
                                     const T& density, const T& area, S dt, const MaskOf<T>& fails,
                                     ElementSums<T>& sums) {
    // h are displacements of the step; before the first there are none.
    const S inverse_dt = dt > S(0) ? S(1) / dt : S(0);
    const T impedance = T(constants.hourglass.coefficient * constants.material.sound_speed * inverse_dt) * density;
    T factor = hourglass_viscosity(impedance, area);
    if constexpr (features.erosion) factor = select(fails, T(0), factor);
    PINBALL_UNROLL
    for (int a = 0; a < 4; ++a) force.p[a] = factor * h_[a];
    if (own.arrays.hourglass_state == nullptr) return;  // without control, whose factor is zero
    const ElementNumbers<T, L> kept_forces = state(own);
    T done(0);
    PINBALL_UNROLL
    for (int a = 0; a < 4; ++a) {
      const Vec3<T> before{kept_forces.get(3 * a), kept_forces.get(3 * a + 1), kept_forces.get(3 * a + 2)};
      done += dot(before + force.p[a], h_[a]);
      kept_forces.set(3 * a, force.p[a].x);
      kept_forces.set(3 * a + 1, force.p[a].y);
      kept_forces.set(3 * a + 2, force.p[a].z);
    }
    sums.hourglass += T(4) * done;
  }

  Vec3<T> h_[4];  ///< displacements of the step [length]
};

}  // namespace pinball

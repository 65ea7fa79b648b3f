#pragma once

#include "../wedge.hpp"
#include "element_pack.hpp"
#include "stability.hpp"
#include "step_geometry.hpp"
#include "step_motion.hpp"

/// What the laws of materials see of a step: the strain and the volumes of a pack's elements or, for tetrahedra and
/// wedges, with volumes that are averaged over nodes (Bonet and Burton, Commun. Numer. Meth. Engng 14, 437-449, 1998).
///
/// A mesh of linear tetrahedra has far more elements than nodes, one of wedges twice as many. Were each to keep its
/// volume, as what flows has to, the nodes could hardly move: it would lock. So the volumes are kept of nodes. With V
/// the undeformed volumes, v the present ones, and sums over the elements at a node a, each with an equal share for
/// each of its nodes,
///
///     J_a = sum v / sum V ,     J = mean of J_a over the nodes of an element ,
///
/// and an element's strain is its own but for its volume, which is that of J. Its forces are those of the stress that
/// follows, over its own shape: with a linear bulk modulus they are the gradient of sum_a K/2 (J_a - 1)^2 sum V, and no
/// stiffer than without averages, so that the stable step of the element holds. Where the mean stress comes of shears,
/// too, they would be the gradient of nothing: elements of orthotropic materials have J = v / V of their own
/// (solver/elements/volume_groups.cpp).
namespace pinball {

/// Of features without such elements: what is there.
template <class T, ElementFeatures features, bool may_average = features.yield == YieldLaw::general>
struct LawStep {
  template <int L>
  PINBALL_FUNCTION LawStep(const ElementPack<T, L>&, const ElementConstants<ScalarOf<T>>&, const EndSize<T>& own_end,
                           const MiddleSize<T>& own_middle, const StepMotion<T, features>& own_motion, ScalarOf<T>)
      : shape(own_end), middle(own_middle), motion(own_motion) {}

  PINBALL_FUNCTION const StabilityBound<T>& bound(const StabilityBound<T>& own, const MiddleSize<T>&) const {
    return own;
  }

  const EndSize<T>& shape;
  const MiddleSize<T>& middle;
  const StepMotion<T, features>& motion;
};

template <class T, ElementFeatures features>
struct LawStep<T, features, true> {
  /// own: whose arrays have the ratios J; dt: [time].
  template <int L, class End>
  PINBALL_FUNCTION LawStep(const ElementPack<T, L>& own, const ElementConstants<ScalarOf<T>>& constants,
                           const End& own_end, const MiddleSize<T>& own_middle,
                           const StepMotion<T, features>& own_motion, ScalarOf<T> dt)
      : shape(own_end), end(own_end), middle(own_middle), motion(own_motion) {
    if constexpr (features.tetrahedra) {
      average(own, constants.specific_volume, dt);
    } else if (constants.averaged_volumes) [[unlikely]] {
      weigh_nodes(wedge_gradient_square(own_end.b, own_end.square));
      average(own, constants.specific_volume, dt);
    }
  }

  /// The bound on the stable step where the volume is the averaged one.
  PINBALL_FUNCTION StabilityBound<T> bound(const StabilityBound<T>& own, const MiddleSize<T>& own_middle) const {
    return {end, own_middle.inverse_end_volume * middle.inverse_end_volume, own.inverse_inertia, own.viscosity};
  }

  EndSize<T> shape;  ///< of the elements themselves, for the stable step; of wedges by the masses of their nodes
  EndSize<T> end;    ///< with the averaged volume
  MiddleSize<T> middle;
  StepMotion<T, features> motion;

 private:
  /// square: of wedge_gradient_square.
  PINBALL_FUNCTION void weigh_nodes(const Symmetric<T>& square) {
    end.trace_square = shape.trace_square = trace(square);
    end.largest_square = shape.largest_square = largest_principal_value(square);
  }
  /// specific_volume: of the undeformed material [length^3/mass].
  template <int L>
  PINBALL_FUNCTION void average(const ElementPack<T, L>& own, ScalarOf<T> specific_volume, ScalarOf<T> dt) {
    using S = ScalarOf<T>;
    const ElementNumbers<T, L> ratios = own.numbers(own.arrays.volume_ratio, 2);
    const T now = select(middle.whole, ratios.get(0), T(1)), before = select(middle.whole, ratios.get(1), T(1));
    const T undeformed = own.mass * T(specific_volume), sum = now + before;
    end.volume = select(middle.whole, undeformed * now, end.volume);
    middle.volume = select(middle.whole, number<T>(0.5) * undeformed * sum, middle.volume);
    middle.inverse_end_volume = select(middle.whole, T(1) / end.volume, T(0));
    middle.inverse_volume = select(middle.whole, T(1) / middle.volume, T(0));
    // Strain of the mean volume, in the place of its own.
    const T volumetric = T(2) * (now - before) / sum;
    const T third = select(middle.whole, number<T>(1.0 / 3.0) * (volumetric - motion.volumetric), T(0));
    const T rate = T(dt > S(0) ? S(1) / dt : S(0)) * third;
    motion.volumetric += T(3) * third;
    motion.gradient.row_x.x += rate;
    motion.gradient.row_y.y += rate;
    motion.gradient.row_z.z += rate;
    motion.strain.xx += third;
    motion.strain.yy += third;
    motion.strain.zz += third;
  }
};

}  // namespace pinball

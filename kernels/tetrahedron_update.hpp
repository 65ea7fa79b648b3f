#pragma once

#include <cstdint>

#include "element/averaged_step.hpp"
#include "element/element_pack.hpp"
#include "element/failure.hpp"
#include "element/hourglass_control.hpp"
#include "element/pressure.hpp"
#include "element/stability.hpp"
#include "element/step_motion.hpp"
#include "element/strength.hpp"
#include "element/tetrahedron_step.hpp"
#include "element/viscosity.hpp"
#include "element/work.hpp"
#include "element_data.hpp"
#include "element_results.hpp"

/// One pack of tetrahedra through one step, as element_update.hpp does it with hexahedra: the same parts, but for the
/// geometry, and without hourglass modes and corners that may fold, which tetrahedra have not. Before it the volumes
/// of the step have been averaged over nodes (averaged_step.hpp).
namespace pinball {

/// features: plastic, with YieldLaw::general and no hourglass control. Parameters as of update_element_pack.
template <class T, ElementFeatures features, int L = width_of<T>, class N, class Forces>
PINBALL_KERNEL void update_tetrahedron_pack(const ElementView<ScalarOf<T>>& elements, const NodeView<N>& nodes,
                                            const ElementConstants<ScalarOf<T>>& constants,
                                            const ElementStep<ScalarOf<T>>& step, std::int64_t pack, int pack_in_tile,
                                            ElementSums<T>& sums, const Forces& forces) {
  static_assert(features.plastic && features.hourglass == HourglassKind::none && features.yield == YieldLaw::general);
  const ScalarOf<T> dt = step.length;
  const ElementPack<T, L> own(elements, pack * width_of<T>);
  if (!any_lane(own.alive)) return;
  const TetrahedronEdges<T> v = gather_edges<T, L>(nodes.velocity, own.corner());
  const TetrahedronEdges<T> x = gather_edges<T, L>(nodes.position, own.corner());
  const TetrahedronEnd<T> end(x, own.mass, own.alive);
  const TetrahedronMiddle<T> middle(x, v, dt, end.volume, own.alive);
  const StepMotion<T, features> motion(velocity_gradient(middle.b, v, middle.inverse_volume), dt);
  const LawStep<T, features> law(own, constants, end, middle, motion, dt);

  const bool viscous = features.bulk_viscosity && has_bulk_viscosity(constants.viscosity);
  const T density = own.mass * middle.inverse_end_volume;
  ViscousStep<T> viscosity(viscous, constants.viscosity, constants.material, density, end.length, law.motion.gradient);
  StabilityBound<T> bound = stability_bound(own, end, middle.inverse_end_volume, viscosity.coefficient());
  T stable_rate = bound.rate(T(constants.material.lambda), T(constants.material.mu));
  const StabilityBound<T> of_law = law.bound(bound, middle);

  const Symmetric<T> stress_old = load_stress(own);
  Symmetric<T> stress =
      stress_without_yield<features>(constants, own, of_law, law.middle, law.motion, dt, stress_old, stable_rate);
  HourglassStep<T, features> hourglass;
  const ElementNumbers<T, L> numbers = own.numbers(elements.material_state, elements.material_numbers);
  T plastic_strain = own.get(elements.plastic_strain);
  MaskOf<T> failed(false);
  if (never_yields_generally<features>(constants)) {
    follow_energy_generally(constants, own, numbers, of_law, law.middle, law.motion, dt, stress_old, stress,
                            stable_rate);
  } else {
    failed = yield<features>(constants, own, numbers, law, dt, hourglass, stress, plastic_strain);
  }
  follow_equation_of_state<features>(constants, own, numbers, of_law, law.middle, law.motion, viscosity, hourglass,
                                     stress_old, stress, stable_rate);

  failed = failed || limits_exceeded<features>(constants, numbers, law.motion, stress, stable_rate, step.time);
  const ElementFailure<T> failure = find_failure<features>(constants.failure, own.alive, end, middle, plastic_strain,
                                                           failed, own.alive && !middle.has_volume);
  if (features.erosion && failure.any) let_go(failure, own, stress, plastic_strain, hourglass, viscosity, sums);
  if (any_lane(failure.inverted)) sums.inverted_count += count_lanes(failure.inverted);

  own.set(elements.plastic_strain, plastic_strain);
  store_stress(stress, own);
  keep_largest(stable_rate, failure.carries, pack_in_tile, sums);
  count_work<features>(own, work_of_stresses(middle, motion, stress_old, stress), failure, sums);
  viscosity.act(own, middle.volume, motion.volumetric, stress, sums);
  Vec3<T> value[8];
  forces_of_nodes(stress, end.b, step.weight, value);
  forces.template take<T, L>(own.first, own.corner(), value);
}

}  // namespace pinball

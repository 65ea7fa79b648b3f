#pragma once

#include <cstdint>

#include "element/averaged_step.hpp"
#include "element/corners.hpp"
#include "element/element_pack.hpp"
#include "element/failure.hpp"
#include "element/forces.hpp"
#include "element/hourglass_control.hpp"
#include "element/pressure.hpp"
#include "element/stability.hpp"
#include "element/step_geometry.hpp"
#include "element/step_motion.hpp"
#include "element/strength.hpp"
#include "element/viscosity.hpp"
#include "element/work.hpp"
#include "element_data.hpp"
#include "element_results.hpp"

/// One pack of elements through one step: gather, strain, stress, erosion, forces, scatter (report figure 4, 3a-c).
///
/// At entry positions are x_n and velocities v_(n-1/2). Strains come from the geometry of the middle of the step just
/// made, forces from x_n.
///
/// Which parts exist is chosen at compile time (ElementFeatures): a scene pays only for what it uses. Each has a file
/// in element/; all are inlined here, and become one straight piece of code.
///
/// The order of the stages, and of the statements in them, is part of the kernel's speed. Divisions and roots take 20
/// to 30 cycles, and the processor looks ahead by less than a tenth of the kernel: each such chain begins as early as
/// it can, and is followed by work that does not need its result.
namespace pinball {

/// N: of the nodes' numbers; they may have more digits than the elements' (corner_differences.hpp).
/// pack: number of the pack; pack_in_tile: the same counted from the start of its tile. L: of the rows (ElementView).
/// forces: AddedToNodes or KeptAtCorners. ahead(0) ... ahead(7) are called in turn, spread over the work: places to ask
/// the caches for what is computed next. All at once would fill the queue of lines on their way, and the processor
/// would stand still. What an element keeps from step to step, but for its mass, is loaded after ahead(2). Returns
/// whether the pack is done: false where it is one of the rare cases that the features leave out, and then nothing has
/// changed, and nothing after ahead(1) was called.
template <class T, ElementFeatures features, int L = width_of<T>, class N, class Forces, class Ahead = NothingAhead>
PINBALL_KERNEL bool update_element_pack(const ElementView<ScalarOf<T>>& elements, const NodeView<N>& nodes,
                                        const ElementConstants<ScalarOf<T>>& constants,
                                        const ElementStep<ScalarOf<T>>& step, std::int64_t pack, int pack_in_tile,
                                        ElementSums<T>& sums, const Forces& forces, const Ahead& ahead = {}) {
  const ScalarOf<T> dt = step.length;
  const ElementPack<T, L> own(elements, pack * width_of<T>);
  if (!any_lane(own.alive)) return true;
  const bool viscous = features.bulk_viscosity && has_bulk_viscosity(constants.viscosity);
  const HexahedronModes<T> v = gather_modes<T, L>(nodes.velocity, own.corner());
  const HexahedronModes<T> x = gather_modes<T, L>(nodes.position, own.corner());
  ahead(0);
  const EndGeometry<T> end(x, own.mass, own.alive, viscous);
  ahead(1);
  const MaskOf<T> distorted = may_fold<features.rare_cases>(x, end, own.alive);
  if (!features.rare_cases && any_lane(distorted)) return false;
  const MiddleGeometry<T> middle(x, v, dt, end.volume, own.alive);
  ahead(2);
  const StepMotion<T, features> motion(velocity_gradient(middle.b, v, middle.inverse_volume), dt);
  const LawStep<T, features> law(own, constants, end, middle, motion, dt);
  const T density = own.mass * middle.inverse_end_volume;
  ViscousStep<T> viscosity(viscous, constants.viscosity, constants.material, density, end.length, law.motion.gradient);
  const StabilityBound<T> bound = stability_bound(own, law.shape, middle.inverse_end_volume, viscosity.coefficient());
  T stable_rate(0);
  if constexpr (features.plastic) stable_rate = bound.rate(T(constants.material.lambda), T(constants.material.mu));
  const auto& limit = law.bound(bound, middle);
  ahead(3);
  const Symmetric<T> stress_old = load_stress(own);
  Symmetric<T> stress =
      stress_without_yield<features>(constants, own, limit, law.middle, law.motion, dt, stress_old, stable_rate);
  ahead(4);
  HourglassStep<T, features> hourglass(constants, own, x, v, end, middle, motion, dt);
  T plastic_strain(0);
  MaskOf<T> failed(false);
  [[maybe_unused]] const ElementNumbers<T, L> numbers = own.numbers(elements.material_state, elements.material_numbers);
  if constexpr (features.plastic) {
    plastic_strain = own.get(elements.plastic_strain);
    if (never_yields_generally<features>(constants)) [[unlikely]] {
      follow_energy_generally(constants, own, numbers, limit, law.middle, law.motion, dt, stress_old, stress,
                              stable_rate);
    } else {
      failed = yield<features>(constants, own, numbers, law, dt, hourglass, stress, plastic_strain);
    }
    hourglass.count_yield(sums);
  }
  follow_equation_of_state<features>(constants, own, numbers, limit, law.middle, law.motion, viscosity, hourglass,
                                     stress_old, stress, stable_rate);
  hourglass.store_state(own, sums);
  ahead(5);
  CornerResistance<T> corners;
  MaskOf<T> inside_out(false);
  const bool any_distorted = features.rare_cases && any_lane(distorted);
  bool any_resists = false;
  if (any_distorted) {
    inside_out = resist_at_corners(own, nodes, constants.folding_energy, bound, x, middle.whole, corners, any_resists,
                                   stable_rate);
  }
  failed = failed || limits_exceeded<features>(constants, numbers, law.motion, stress, stable_rate, step.time);
  const ElementFailure<T> failure =
      find_failure<features>(constants.failure, own.alive, end, middle, plastic_strain, failed, inside_out);
  if (features.erosion && failure.any) let_go(failure, own, stress, plastic_strain, hourglass, viscosity, sums);
  if (any_lane(failure.inverted)) sums.inverted_count += count_lanes(failure.inverted);
  if (any_distorted) sums.inside_out_count += count_lanes(inside_out && !failure.fails);
  ahead(6);

  if constexpr (features.plastic) own.set(elements.plastic_strain, plastic_strain);
  store_stress(stress, own);
  keep_largest(stable_rate, failure.carries, pack_in_tile, sums);
  T work = work_of_stresses(middle, motion, stress_old, stress);
  hourglass.end(constants, own, density, end.area, dt, failure.fails, work, sums);
  count_work<features>(own, work, failure, sums);
  viscosity.act(own, middle.volume, motion.volumetric, stress, sums);
  ahead(7);
  Vec3<T> value[8];
  forces_of_corners<features.hourglass>(stress, hourglass.force, x, end.b, middle.inverse_end_volume, step.weight,
                                        value);
  if (any_resists) add_resistance<features>(failure, corners, T(step.weight), value, sums);
  forces.template take<T, L>(own.first, own.corner(), value);
  return true;
}

}  // namespace pinball

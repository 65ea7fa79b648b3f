#pragma once

#include <cstdint>

#include "element_data.hpp"
#include "element_results.hpp"
#include "folding.hpp"
#include "gather.hpp"
#include "hexahedron.hpp"
#include "kept_hourglass.hpp"
#include "material/bulk_viscosity.hpp"
#include "material/general_material.hpp"
#include "material/neo_hookean.hpp"
#include "rotation.hpp"
#include "stable_time_step.hpp"

/// One pack of elements through one step: gather, strain, stress, erosion, forces, scatter (report figure 4, 3a-c).
///
/// At entry positions are x_n and velocities v_(n-1/2). Strains come from the geometry of the middle of the step just
/// made, x_(n-1/2) = x_n - dt/2 v, so that a rigid rotation of any size gives no strain; forces from x_n.
///
/// Which parts exist is chosen at compile time (ElementFeatures): a scene pays only for what it uses.
///
/// The order of the statements is part of the kernel's speed. Divisions and roots take 20 to 30 cycles, and the
/// processor looks ahead by less than a tenth of the kernel: each such chain begins as early as it can, and is followed
/// by work that does not need its result.
namespace pinball {

/// pack: number of the pack; pack_in_tile: the same counted from the start of its tile. L: of the rows (ElementView).
/// forces: AddedToNodes or KeptAtCorners. ahead(0) ... ahead(7) are called in turn, spread over the work: places to ask
/// the caches for what is worked next. All at once would fill the queue of lines on their way, and the processor would
/// stand still.
template <class T, ElementFeatures features, int L = width_of<T>, class Forces, class Ahead = NothingAhead>
PINBALL_FUNCTION void update_element_pack(const ElementView<ScalarOf<T>>& elements, const NodeView<ScalarOf<T>>& nodes,
                                          const ElementConstants<ScalarOf<T>>& constants,
                                          const ElementStep<ScalarOf<T>>& step, std::int64_t pack, int pack_in_tile,
                                          ElementSums<T>& sums, const Forces& forces, const Ahead& ahead = {}) {
  using S = ScalarOf<T>;
  const S dt = step.length;
  const std::int64_t first = pack * width_of<T>;
  const MaterialConstants<S>& material = constants.material;
  const bool viscous = features.bulk_viscosity && has_bulk_viscosity(constants.viscosity);

  const T mass = load<T>(elements.mass + first);
  const auto alive = mass > T(0);
  if (!any_lane(alive)) return;
  const auto state = [&alive](const S* array) { return select(alive, load<T>(array), T(0)); };

  // Gather
  const std::int32_t* corner = elements.corner + place_in_rows<L>(first, 8);
  Vec3<T> value[8];
  PINBALL_UNROLL
  for (int i = 0; i < 8; ++i) value[i] = gather_vectors<T>(nodes.velocity, corner + i * L);
  const HexahedronModes<T> v = to_modes(value);
  PINBALL_UNROLL
  for (int i = 0; i < 8; ++i) value[i] = gather_vectors<T>(nodes.position, corner + i * L);
  const HexahedronModes<T> x = to_modes(value);
  ahead(0);

  // Geometry at the end of the step, and the roots that only it goes into
  const UniformGradient<T> b = uniform_gradient(x);
  const T volume = hexahedron_volume(b, x);
  const Symmetric<T> b_b = gradient_square(b);
  const T trace_b_b = trace(b_b);
  const T largest_b_b = largest_principal_value(b_b);
  const T inverse_mass = T(1) / select(alive, mass, T(1));
  [[maybe_unused]] const T area = face_area(trace_b_b);
  [[maybe_unused]] T length(0);
  if (viscous) length = volume / area;
  ahead(1);

  // Corners are looked at where they may be near turning over, also where a number is none.
  const auto distorted = alive && !(largest_distortion(x, largest_b_b) < T(sound_distortion<S>) * (volume * volume));

  // Geometry in the middle of the step
  HexahedronModes<T> x_mid;
  const T minus_half_dt(S(-0.5) * dt);
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) x_mid.linear[m] = x.linear[m] + minus_half_dt * v.linear[m];
  PINBALL_UNROLL
  for (int m = 0; m < 4; ++m) x_mid.hourglass[m] = x.hourglass[m] + minus_half_dt * v.hourglass[m];
  const UniformGradient<T> b_mid = uniform_gradient(x_mid);
  const T volume_mid = hexahedron_volume(b_mid, x_mid);
  const auto has_volume = minimum(volume, volume_mid) > T(0);
  // Both inverses from one division. An element that is not there, or has lost its volume, has no rates and no forces.
  const auto whole = alive && has_volume;
  const T inverse_both = select(whole, T(1) / (volume * volume_mid), T(0));
  const T inverse_volume = inverse_both * volume_mid, inverse_volume_mid = inverse_both * volume;
  ahead(2);

  // Strain increment and spin
  const Tensor<T> gradient = velocity_gradient(b_mid, v, inverse_volume_mid);
  [[maybe_unused]] Rotation<T> rotation;
  if constexpr (features.plastic || features.hourglass == HourglassKind::stiffness) {
    rotation = hughes_winget_rotation(T(dt) * axial_vector(gradient));
  }
  [[maybe_unused]] Tensor<T> half_gradient;  // times the step: h of neo_hookean.hpp
  if constexpr (!features.plastic) half_gradient = T(S(0.5) * dt) * gradient;
  Symmetric<T> strain;
  if constexpr (features.plastic) {
    strain = T(dt) * symmetric_part(gradient);
  } else {
    strain = twice_symmetric_part(half_gradient);
  }
  const T volumetric = trace(strain);

  // Bulk viscosity and, with it, the stable step of the next step
  T viscosity(0);
  [[maybe_unused]] T dilatation(0);
  const T density = mass * inverse_volume;
  if (viscous) {
    dilatation = gradient.row_x.x + gradient.row_y.y + gradient.row_z.z;
    viscosity = bulk_viscosity(T(constants.viscosity.linear), T(constants.viscosity.quadratic), density,
                               T(material.sound_speed), length, dilatation);
  }
  const T inverse_square = inverse_volume * inverse_volume;
  T inverse_inertia = inverse_mass;
  if (elements.mass_share != nullptr) inverse_inertia = inverse_inertia * load<T>(elements.mass_share + first);
  const auto stable_rate_of = [&](const T& lambda, const T& mu) {
    return element_stable_rate(inverse_square * largest_b_b, inverse_square * trace_b_b, volume, inverse_inertia,
                               lambda, mu, viscosity);
  };
  T stable_rate(0);
  if constexpr (features.plastic) stable_rate = stable_rate_of(T(material.lambda), T(material.mu));
  ahead(3);

  // Stress
  S* stored = elements.stress + place_in_rows<L>(first, 6);
  const Symmetric<T> stress_old{state(stored),         state(stored + L),     state(stored + 2 * L),
                                state(stored + 3 * L), state(stored + 4 * L), state(stored + 5 * L)};
  Symmetric<T> stress;
  if constexpr (features.plastic) {
    // The increment belongs to the middle of the rotation: half of it turns with the old stress. Added whole after the
    // rotation it would be turned by half a step, a skew part of the stiffness that feeds the high modes of a spinning
    // body.
    const Symmetric<T> half_increment = elastic_increment(T(S(0.5) * material.lambda), T(S(0.5) * material.mu), strain);
    stress = rotate(rotation, stress_old + half_increment) + half_increment;
  }
  // What yields has a rate law, and what never does has an energy; erosion has no kernel of its own for that.
  constexpr bool may_be_elastic = features.erosion && features.yield == YieldLaw::linear;
  if (!features.plastic || (may_be_elastic && constants.never_yields)) {
    const VolumeChange<T> change{mass * T(constants.specific_volume), T(material.density) * inverse_mass, volume_mid,
                                 volume, inverse_volume};
    NeoHookeanState<T> now;
    if constexpr (features.plastic) {
      update_neo_hookean<T>(material.lambda, material.mu, T(S(0.5) * dt) * gradient, change, whole, stress_old, now);
    } else {
      now = neo_hookean_step<T>(material.lambda, material.mu, half_gradient, change, whole, stress_old);
    }
    stress = now.stress;
    stable_rate = stable_rate_of(now.lambda, now.mu);
  }
  ahead(4);

  // Hourglass modes
  constexpr bool keeps_hourglass = keeps_hourglass_state(features.hourglass);
  [[maybe_unused]] Vec3<T> h[4];  // displacements of the step
  if constexpr (features.hourglass != HourglassKind::none) {
    PINBALL_UNROLL
    for (int a = 0; a < 4; ++a) h[a] = T(dt) * hourglass_rate(gradient, x_mid, v, a);
  }
  [[maybe_unused]] KeptHourglass<T, features.hourglass> kept;
  [[maybe_unused]] S* const hourglass_state =
      keeps_hourglass ? elements.hourglass_state + place_in_rows<L>(first, 12) : nullptr;
  [[maybe_unused]] const auto before = [&](int c) { return state(hourglass_state + c * L); };
  if constexpr (features.hourglass == HourglassKind::assumed_strain) {
    kept.begin(constants.hourglass.assumed_strain, x_mid, x, whole, h, mass * T(constants.specific_volume), volume_mid,
               before);
  } else if constexpr (features.hourglass == HourglassKind::stiffness) {
    kept.begin(constants.hourglass.modulus, select(whole, area, T(0)), b_b, trace_b_b, strain, rotation, h,
               mass * T(constants.specific_volume), T(material.density) * inverse_mass, before);
  }

  // Yield of both
  T plastic_strain(0);
  [[maybe_unused]] LostHourglassEnergy<T> lost{T(0), T(0)};
  [[maybe_unused]] bool any_lost = false;
  [[maybe_unused]] MaskOf<T> failed(false);  // for a reason of the material's own
  [[maybe_unused]] const MaterialNumbers<T, L> numbers(elements, first, alive);
  if constexpr (features.plastic) {
    plastic_strain = state(elements.plastic_strain + first);
    if constexpr (features.yield == YieldLaw::general) {
      const Symmetric<T> deformation = symmetric_part(gradient);
      const YieldOutcome<T> outcome =
          yield_generally(constants, {deformation, rotation, dt, density}, numbers, kept, stress, plastic_strain);
      lost = outcome.lost;
      any_lost = outcome.any_lost;
      failed = outcome.failed;
    } else if constexpr (keeps_hourglass) {
      const Symmetric<T> deviator = deviator_of(stress);
      const T mean = effective_square(deviator), variation = kept.variation();
      const T yield = yield_stress(material, plastic_strain);
      // Packs without yield are done with the comparison; a lane is returned, or not, whatever its neighbours do.
      any_lost = any_lane(largest_effective_square(mean, variation) > yield * yield);
      if (any_lost) lost = kept.yield(material, deviator, mean, variation, stress, plastic_strain);
    } else {
      radial_return(material, stress, plastic_strain);
    }
  }
  if constexpr (features.plastic && keeps_hourglass) {
    if (any_lost) sums.hourglass_plastic += lost.stored - number<T>(0.5) * lost.work;
  }
  if constexpr (features.yield == YieldLaw::general) {
    if (constants.pressure.law != PressureLaw::linear) {
      // Of the work of the step, see below, what is none of the pressure's.
      const Symmetric<T> sum = stress_old + stress;
      const T half_volume = number<T>(0.5) * volume_mid;
      T heat = half_volume * (contract(sum, strain) - number<T>(1.0 / 3.0) * trace(sum) * volumetric);
      if (viscous) {
        heat += half_volume * (state(elements.viscous_stress + first) + viscosity * dilatation) * volumetric;
      }
      if (any_lost) heat += lost.stored - number<T>(0.5) * lost.work;
      const T bulk_modulus =
          set_pressure(constants.pressure, numbers, constants.places.energy, whole, mass * T(constants.specific_volume),
                       inverse_volume, volume_mid * volumetric, heat, stress_old, stress);
      stable_rate = stable_rate_of(bulk_modulus - T(S(2.0 / 3.0) * material.mu), T(material.mu));
    }
  }
  HourglassForce<T> hourglass{};
  if constexpr (keeps_hourglass) {
    hourglass = kept.force();
    PINBALL_UNROLL
    for (int c = 0; c < 12; ++c) store(kept.component(c), hourglass_state + c * L);
    sums.hourglass += kept.work();
  }
  ahead(5);

  // Corners that are about to turn over, and those that have
  CornerResistance<T> corners;
  MaskOf<T> inside_out(false);
  const bool any_distorted = any_lane(distorted);
  if (any_distorted) {
    T onset(constants.folding_energy > S(0) ? folding_onset<S> : S(0));
    if (elements.folding_onset != nullptr) onset = minimum(onset, load<T>(elements.folding_onset + first));
    resist_folding<T, L>(nodes.position, nodes.velocity, corner, T(constants.folding_energy) * mass, onset,
                         inverse_inertia, whole, corners);
    // A corner takes at least two steps to close by half of what it is open.
    stable_rate = maximum(square_root(stable_rate * stable_rate + corners.rate_square), T(4) * corners.closing_rate);
    inside_out = alive && !(corners.worst > T(0));
  }

  // Erosion: the element keeps its nodes and their mass, and carries no stress from now on.
  MaskOf<T> fails(false);
  [[maybe_unused]] bool any_fails = false;
  auto carries = whole;
  auto inverted = alive && !has_volume;
  if constexpr (features.erosion) {
    fails = plastic_strain > T(constants.failure.plastic_strain) && alive;
    if constexpr (features.yield == YieldLaw::general) fails = fails || (alive && failed);
    // A volume that is not a number is no reason to erode: it is counted, and stops the run.
    if (constants.failure.negative_volume) fails = fails || (alive && minimum(volume, volume_mid) <= T(0));
    if (constants.failure.inside_out) fails = fails || inside_out;
    any_fails = any_lane(fails);
    if (any_fails) {
      carries = carries && !fails;
      inverted = inverted && !fails;
      sums.eroded_count += count_lanes(fails);
      store(select(fails, T(0), mass), elements.mass + first);
      stress = select(fails, Symmetric<T>{T(0), T(0), T(0), T(0), T(0), T(0)}, stress);
      if constexpr (keeps_hourglass) {
        any_lost = true;
        const LostHourglassEnergy<T> everything = kept.everything();
        lost.stored += select(fails, everything.stored, T(0));
        lost.work += select(fails, everything.work, T(0));
        PINBALL_UNROLL
        for (int a = 0; a < 4; ++a) hourglass.p[a] = select(fails, Vec3<T>{T(0), T(0), T(0)}, hourglass.p[a]);
        PINBALL_UNROLL
        for (int c = 0; c < 12; ++c) store(select(fails, T(0), kept.component(c)), hourglass_state + c * L);
      }
      viscosity = select(fails, T(0), viscosity);
    }
  }
  if (any_lane(inverted)) sums.inverted_count += count_lanes(inverted);
  if (any_distorted) sums.inside_out_count += count_lanes(inside_out && !fails);
  ahead(6);

  // State of the next step
  if constexpr (features.plastic) store(plastic_strain, elements.plastic_strain + first);
  store(stress.xx, stored);
  store(stress.yy, stored + L);
  store(stress.zz, stored + 2 * L);
  store(stress.xy, stored + 3 * L);
  store(stress.yz, stored + 4 * L);
  store(stress.zx, stored + 5 * L);
  const auto larger = carries && stable_rate > sums.stable_rate;
  sums.stable_rate = select(larger, stable_rate, sums.stable_rate);
  sums.stable_rate_pack = select(larger, T(static_cast<S>(pack_in_tile)), sums.stable_rate_pack);

  // Work of the stresses, V/2 (sigma_old + sigma_new) : strain; an element that erodes in this step has sigma_new = 0,
  // as its forces are. Strains of padding and of elements without volume are zero.
  T work = number<T>(0.5) * volume_mid * contract(stress_old + stress, strain);
  // The work of kept hourglass forces is stored. What yield and erosion take of the store is plastic work, but for what
  // they take of the work itself, which is that of the mean of old and new forces.
  if constexpr (keeps_hourglass) {
    if (any_lost) {
      sums.hourglass -= lost.stored;
      work += lost.stored - number<T>(0.5) * lost.work;
    }
  } else if constexpr (features.hourglass == HourglassKind::viscous) {
    // h are displacements of the step; before the first there are none.
    const S inverse_dt = dt > S(0) ? S(1) / dt : S(0);
    const T impedance = T(constants.hourglass.coefficient * material.sound_speed * inverse_dt) * density;
    T factor = hourglass_viscosity(impedance, area);
    if constexpr (features.erosion) factor = select(fails, T(0), factor);
    T done(0);
    PINBALL_UNROLL
    for (int a = 0; a < 4; ++a) {
      hourglass.p[a] = factor * h[a];
      done += dot(hourglass.p[a], h[a]);
    }
    sums.hourglass += T(8) * done;
  }
  sums.internal += work;
  if (features.erosion && elements.internal_energy != nullptr) {
    const T energy = state(elements.internal_energy + first) + work;
    store(energy, elements.internal_energy + first);
    if (any_fails) sums.eroded += select(fails, energy, T(0));
  }
  if (viscous) {
    const T q_old = state(elements.viscous_stress + first), q = viscosity * dilatation;
    store(q, elements.viscous_stress + first);
    sums.viscous += number<T>(0.5) * volume_mid * (q_old + q) * volumetric;
    stress.xx += q;
    stress.yy += q;
    stress.zz += q;
  }
  ahead(7);

  // What acts through B: the stress, and a tensor of the hourglass forces
  Tensor<T> acting;
  if constexpr (features.hourglass == HourglassKind::none) {
    acting = to_tensor(stress);
  } else {
    acting = hourglass_stress(hourglass, x, inverse_volume) + stress;
  }

  // Forces: minus the internal ones, first of the modes, then of the corners
  const T weight(step.weight), minus_weight(-step.weight);
  acting = minus_weight * acting;
  Vec3<T> force_linear[3], force_hourglass[4];
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) {
    force_linear[m] = acting * b.linear[m];
    force_hourglass[m] = acting * b.hourglass[m] - weight * hourglass.p[m];
  }
  force_hourglass[3] = minus_weight * hourglass.p[3];
  from_modes(force_linear, force_hourglass, value);
  if (any_distorted) {
    if constexpr (features.erosion) {
      if (any_fails) {
        PINBALL_UNROLL
        for (int i = 0; i < 8; ++i) corners.force[i] = select(fails, Vec3<T>{T(0), T(0), T(0)}, corners.force[i]);
        const T taken_along = select(fails, corners.energy, T(0));
        sums.internal += taken_along;
        sums.eroded += taken_along;
        corners.energy = select(fails, T(0), corners.energy);
      }
    }
    sums.folding += corners.energy;
    PINBALL_UNROLL
    for (int i = 0; i < 8; ++i) value[i] = value[i] + weight * corners.force[i];
  }

  forces.template take<T, L>(first, corner, value);
}

}  // namespace pinball

#pragma once

#include <cstdint>

#include <pinball/kernels/bulk_viscosity.hpp>
#include <pinball/kernels/gather.hpp>
#include <pinball/kernels/hexahedron.hpp>
#include <pinball/kernels/hourglass.hpp>
#include <pinball/kernels/material.hpp>
#include <pinball/kernels/rotation.hpp>
#include <pinball/kernels/stable_time_step.hpp>

/// One pack of elements through one step: gather, strain, stress, erosion, forces, scatter (report figure 4, 3a-c).
///
/// At entry positions are x_n and velocities v_(n-1/2). Strains come from the geometry of the middle of the step just
/// made, x_(n-1/2) = x_n - dt/2 v, so that a rigid rotation of any size gives no strain; forces from x_n.
///
/// Which parts exist is chosen at compile time (ElementFeatures): a scene pays only for what it uses.
namespace pinball {

enum class HourglassKind { none, viscous, stiffness };

struct ElementFeatures {
  bool plastic;             ///< von Mises plasticity; else elastic, without plastic strain
  bool erosion;             ///< elements may be eroded; keeps an internal energy per element
  bool bulk_viscosity;
  HourglassKind hourglass;
};

/// Element arrays in tiles of W = pack width: entry c of element e is at [(e / W) * N + c] * W + e % W for an array of N
/// components. All aligned to the pack. Padding elements repeat the nodes of a real one and have mass 0.
template <class S>
struct ElementView {
  const std::int32_t* corner;   ///< N = 8: node numbers
  S* mass;                      ///< N = 1: element mass [mass]; 0 marks padding and eroded elements
  S* stress;                    ///< N = 6: xx yy zz xy yz zx [stress]
  S* plastic_strain;            ///< N = 1, plastic only [-]
  S* hourglass_force;           ///< N = 12: Q_1..Q_4, stiffness form only [force]
  S* viscous_stress;            ///< N = 1: bulk viscosity of the previous step, bulk_viscosity only [stress]
  S* internal_energy;           ///< N = 1, erosion only [energy]
};

/// Node records of four scalars (gather.hpp).
template <class S>
struct NodeView {
  const S* position;
  const S* velocity;
  S* force;
};

template <class S>
struct ElementConstants {
  MaterialConstants<S> material;
  S hourglass_coefficient;      ///< kappa of the stiffness form, k of the viscous form [-]
  S linear_viscosity;           ///< b1 [-]
  S quadratic_viscosity;        ///< b2 [-]
  bool erode_negative_volume;   ///< an element whose volume is not positive is eroded; else it is counted as inverted
};

/// What a tile of elements reports, per lane until the end of the tile.
template <class T>
struct ElementSums {
  T internal = T(0);            ///< increment of the internal energy [energy]
  T hourglass = T(0);           ///< increment of the hourglass energy [energy]
  T viscous = T(0);             ///< increment of the bulk viscosity energy [energy]
  T eroded = T(0);              ///< internal energy of elements eroded in this step [energy]
  T time_step;                  ///< smallest stable step [time]
  T time_step_pack = T(0);      ///< pack in which it was found, counted in the tile
  int eroded_count = 0;
  int inverted_count = 0;       ///< elements with a volume that is not positive (or NaN) and that are not eroded for it
};

/// dt: the step just made [time]. pack: number of the pack; pack_in_tile: the same counted from the start of its tile.
template <class T, ElementFeatures features>
PINBALL_FUNCTION void update_element_pack(const ElementView<ScalarOf<T>>& elements, const NodeView<ScalarOf<T>>& nodes,
                                          const ElementConstants<ScalarOf<T>>& constants, ScalarOf<T> dt,
                                          std::int64_t pack, int pack_in_tile, ElementSums<T>& sums) {
  using S = ScalarOf<T>;
  constexpr int W = width_of<T>;
  const MaterialConstants<S>& material = constants.material;

  const T mass = load<T>(elements.mass + pack * W);
  const auto alive = mass > T(0);
  if (!any_lane(alive)) return;

  // Gather
  const std::int32_t* corner = elements.corner + pack * 8 * W;
  Vec3<T> value[8];
  PINBALL_UNROLL
  for (int i = 0; i < 8; ++i) value[i] = gather_vectors<T>(nodes.velocity, corner + i * W);
  const HexahedronModes<T> v = to_modes(value);
  PINBALL_UNROLL
  for (int i = 0; i < 8; ++i) value[i] = gather_vectors<T>(nodes.position, corner + i * W);
  const HexahedronModes<T> x = to_modes(value);

  // Strain increment and spin of the mid-step geometry
  HexahedronModes<T> x_mid;
  const T minus_half_dt(S(-0.5) * dt);
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) x_mid.linear[m] = x.linear[m] + minus_half_dt * v.linear[m];
  PINBALL_UNROLL
  for (int m = 0; m < 4; ++m) x_mid.hourglass[m] = x.hourglass[m] + minus_half_dt * v.hourglass[m];
  const UniformGradient<T> b_mid = uniform_gradient(x_mid);
  const T volume_mid = hexahedron_volume(b_mid, x_mid);
  const T inverse_volume_mid = select(alive, T(1) / volume_mid, T(0));
  const Tensor<T> gradient = velocity_gradient(b_mid, v, inverse_volume_mid);
  const Symmetric<T> rate = symmetric_part(gradient);
  const Symmetric<T> strain = T(dt) * rate;
  const Rotation<T> rotation = hughes_winget_rotation(T(dt) * axial_vector(gradient));

  // Geometry at the end of the step
  const UniformGradient<T> b = uniform_gradient(x);
  const T volume = hexahedron_volume(b, x);
  const auto has_volume = volume > T(0) && volume_mid > T(0);  // false for NaN
  const T inverse_volume = select(alive, T(1) / volume, T(0));

  // Stress
  S* stored = elements.stress + pack * 6 * W;
  const Symmetric<T> stress_old{load<T>(stored),         load<T>(stored + W),     load<T>(stored + 2 * W),
                                load<T>(stored + 3 * W), load<T>(stored + 4 * W), load<T>(stored + 5 * W)};
  Symmetric<T> stress = rotate(rotation, stress_old) + elastic_increment(T(material.lambda), T(material.mu), strain);
  T plastic_strain(0);
  if constexpr (features.plastic) {
    plastic_strain = load<T>(elements.plastic_strain + pack * W);
    radial_return(material, stress, plastic_strain);
    store(plastic_strain, elements.plastic_strain + pack * W);
  }

  // Erosion: the element keeps its nodes and their mass, and carries no stress from now on.
  auto carries = alive;
  if constexpr (features.erosion) {
    auto fails = plastic_strain > T(material.erosion_strain);
    if (constants.erode_negative_volume) fails = fails || !has_volume;
    fails = fails && alive;
    carries = alive && !fails;
    if (any_lane(fails)) {
      sums.eroded_count += count_lanes(fails);
      store(select(fails, T(0), mass), elements.mass + pack * W);
    }
  }
  sums.inverted_count += count_lanes(carries && !has_volume);
  const T inverse_volume_now = select(carries, inverse_volume, T(0));
  const Symmetric<T> carried{select(carries, stress.xx, T(0)), select(carries, stress.yy, T(0)),
                             select(carries, stress.zz, T(0)), select(carries, stress.xy, T(0)),
                             select(carries, stress.yz, T(0)), select(carries, stress.zx, T(0))};
  stress = carried;  // a copy: where packs live in memory, GCC 12 builds "stress = {select(.., stress.xx, ..)}" in place
  store(stress.xx, stored);
  store(stress.yy, stored + W);
  store(stress.zz, stored + 2 * W);
  store(stress.xy, stored + 3 * W);
  store(stress.yz, stored + 4 * W);
  store(stress.zx, stored + 5 * W);

  // Work of the stresses, V/2 (sigma_old + sigma_new) : strain; for an element that erodes in this step sigma_new = 0,
  // as its forces are. Padding has strain 0 because its inverse volume is 0; an eroding element of no volume adds none.
  const T usable_volume = select(alive && has_volume, volume_mid, T(0));
  const T work = number<T>(0.5) * usable_volume * contract(stress_old + stress, strain);
  sums.internal += select(alive && has_volume, work, T(0));
  if constexpr (features.erosion) {
    const T energy = load<T>(elements.internal_energy + pack * W) + select(alive && has_volume, work, T(0));
    sums.eroded += select(alive && !carries, energy, T(0));
    store(energy, elements.internal_energy + pack * W);
  }

  // Bulk viscosity
  T viscosity(0);
  const T density = mass * inverse_volume_now;
  if constexpr (features.bulk_viscosity) {
    const T length = volume / square_root(number<T>(2.0 / 3.0) * gradient_norm_squared(b));
    const T volumetric = trace(rate);
    viscosity = bulk_viscosity(T(constants.linear_viscosity), T(constants.quadratic_viscosity), density,
                               T(material.sound_speed), length, volumetric);
    const T q_old = load<T>(elements.viscous_stress + pack * W);
    const T q = select(carries, viscosity * volumetric, T(0));
    store(q, elements.viscous_stress + pack * W);
    sums.viscous += select(alive && has_volume, T(S(0.5) * dt) * usable_volume * (q_old + q) * volumetric, T(0));
    stress.xx += q;
    stress.yy += q;
    stress.zz += q;
  }

  // Forces in modes
  Vec3<T> force_linear[3], force_hourglass[4];
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) {
    force_linear[m] = stress * b.linear[m];
    force_hourglass[m] = stress * b.hourglass[m];
  }
  force_hourglass[3] = {T(0), T(0), T(0)};

  // Hourglass control
  if constexpr (features.hourglass == HourglassKind::stiffness) {
    const T modulus(constants.hourglass_coefficient * (material.lambda + 2 * material.mu));
    const T stiffness = select(carries && has_volume,
                               T(dt) * hourglass_stiffness(modulus, b_mid, inverse_volume_mid), T(0));
    HourglassForce<T> hourglass;
    T power(0);
    PINBALL_UNROLL
    for (int a = 0; a < 4; ++a) {
      S* q = elements.hourglass_force + (pack * 12 + 3 * a) * W;
      const Vec3<T> old{load<T>(q), load<T>(q + W), load<T>(q + 2 * W)};
      const Vec3<T> hourglass_velocity = hourglass_rate(gradient, x_mid, v, a);
      const Vec3<T> turned = rotate(rotation, old) + stiffness * hourglass_velocity;
      hourglass.q[a] = {select(carries, turned.x, T(0)), select(carries, turned.y, T(0)),
                        select(carries, turned.z, T(0))};
      store(hourglass.q[a].x, q);
      store(hourglass.q[a].y, q + W);
      store(hourglass.q[a].z, q + 2 * W);
      power += dot(old + hourglass.q[a], hourglass_velocity);
    }
    sums.hourglass += select(alive && has_volume, T(S(0.5) * dt) * power, T(0));
    add_hourglass_forces(hourglass, x, b, inverse_volume_now, force_linear, force_hourglass);
  } else if constexpr (features.hourglass == HourglassKind::viscous) {
    const T impedance = T(constants.hourglass_coefficient * material.sound_speed) * density;
    const T factor = select(carries && has_volume, hourglass_viscosity(impedance, b), T(0));
    HourglassForce<T> hourglass;
    T power(0);
    PINBALL_UNROLL
    for (int a = 0; a < 4; ++a) {
      const Vec3<T> hourglass_velocity = hourglass_rate(gradient, x_mid, v, a);
      hourglass.q[a] = factor * hourglass_velocity;
      power += dot(hourglass.q[a], hourglass_velocity);
    }
    sums.hourglass += select(carries && has_volume, T(dt) * power, T(0));
    add_hourglass_forces(hourglass, x, b, inverse_volume_now, force_linear, force_hourglass);
  }

  // Stable step of the next step
  const T volume_per_mass = volume / select(carries, mass, T(1));
  const T step = element_stable_time_step(b, inverse_volume_now, volume_per_mass, T(material.lambda), T(material.mu),
                                          viscosity);
  const auto smaller = carries && step < sums.time_step;
  sums.time_step = select(smaller, step, sums.time_step);
  sums.time_step_pack = select(smaller, T(static_cast<S>(pack_in_tile)), sums.time_step_pack);

  // Scatter: nodal forces are minus the internal forces.
  PINBALL_UNROLL
  for (int m = 0; m < 3; ++m) force_linear[m] = T(-1) * force_linear[m];
  PINBALL_UNROLL
  for (int m = 0; m < 4; ++m) force_hourglass[m] = T(-1) * force_hourglass[m];
  from_modes(force_linear, force_hourglass, value);
  PINBALL_UNROLL
  for (int i = 0; i < 8; ++i) {
    add_to_records(nodes.force, corner + i * W, value[i].x, value[i].y, value[i].z, T(0));
  }
}

}  // namespace pinball

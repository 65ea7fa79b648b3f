#pragma once

#include <cmath>
#include <cstdint>

#include "gather.hpp"
#include "pinball.hpp"
#include "rows.hpp"

/// Centres, velocities, normals and (on demand) radii of a pack of pinballs from the corners of their elements
/// (report figure 3, steps 1 to 3).
namespace pinball {

/// Surface elements in packs of `row` lanes, as in ElementView; records of four scalars per pinball, as in PinballView.
template <class S>
struct PinballGeometryView {
  const std::int32_t* corner;  ///< N = 8: node numbers
  const S* exposed;            ///< N = 6: 1 where the face is exposed, else 0
  const S* bulk_modulus;       ///< N = 1 [stress]
  S* centre;                   ///< C, R
  S* velocity;                 ///< V, (mass: kept)
  S* outward;                  ///< outward normal, B R
  S* two_sided;                ///< two-sided normal, (1 for an element of a bar one element thick, else 0: kept)
  int row = 1;                 ///< lanes of a pack
  S radius_factor = 1;         ///< on the radius of (3.2) [-]
};

/// Writes the records of pinballs pack * W ... + W - 1; a pack is as wide as a row, or one lane. With update_radius the
/// radius follows the current volume.
template <class T, bool update_radius>
PINBALL_FUNCTION void update_pinball_pack(const PinballGeometryView<ScalarOf<T>>& view, const ScalarOf<T>* position,
                                          const ScalarOf<T>* velocity, std::int64_t pack) {
  using S = ScalarOf<T>;
  constexpr int W = width_of<T>;
  const int row = row_of<T>(view.row);
  const std::int32_t* corner = view.corner + first_in_rows<T>(view.row, pack, 8);
  Vec3<T> value[8];
  PINBALL_UNROLL
  for (int i = 0; i < 8; ++i) value[i] = gather_vectors<T>(velocity, corner + i * row);
  Vec3<T> v = value[0];
  PINBALL_UNROLL
  for (int i = 1; i < 8; ++i) v = v + value[i];
  v = number<T>(0.125) * v;
  PINBALL_UNROLL
  for (int i = 0; i < 8; ++i) value[i] = gather_vectors<T>(position, corner + i * row);
  const HexahedronModes<T> x = to_modes(value);
  const Vec3<T> centre = x.constant;  // (3.1)
  const S* const faces = view.exposed + first_in_rows<T>(view.row, pack, 6);
  T exposed[6];
  PINBALL_UNROLL
  for (int f = 0; f < 6; ++f) exposed[f] = load<T>(faces + f * row);
  alignas(64) S of_bar[W];
  for (int i = 0; i < W; ++i) of_bar[i] = view.two_sided[4 * (pack * W + i) + 3];
  const PinballNormal<T> normal = pinball_normal(x, exposed, load<T>(of_bar));
  T volume(0);
  if constexpr (update_radius) volume = hexahedron_volume(uniform_gradient(x), x);

  for (int i = 0; i < W; ++i) {
    const std::int64_t p = 4 * (pack * W + i);
    view.centre[p] = lane(centre.x, i);
    view.centre[p + 1] = lane(centre.y, i);
    view.centre[p + 2] = lane(centre.z, i);
    if constexpr (update_radius) {
      const S v_abs = absolute(lane(volume, i));
      view.centre[p + 3] = view.radius_factor * ball_radius_of_cube(static_cast<S>(::cbrt(v_abs)));  // (3.2)
      const S takes_part = view.outward[p + 3] > S(0) ? S(1) : S(0);
      view.outward[p + 3] = takes_part * view.bulk_modulus[pack * W + i] * view.centre[p + 3];
    }
    view.velocity[p] = lane(v.x, i);
    view.velocity[p + 1] = lane(v.y, i);
    view.velocity[p + 2] = lane(v.z, i);
    view.outward[p] = lane(normal.outward.x, i);
    view.outward[p + 1] = lane(normal.outward.y, i);
    view.outward[p + 2] = lane(normal.outward.z, i);
    view.two_sided[p] = lane(normal.two_sided.x, i);
    view.two_sided[p + 1] = lane(normal.two_sided.y, i);
    view.two_sided[p + 2] = lane(normal.two_sided.z, i);
  }
}

/// The same for pack after pack, or lane after lane.
template <class T, bool update_radius>
struct UpdatePinballs {
  using S = ScalarOf<T>;
  PinballGeometryView<S> pinballs;
  const S *position, *velocity;  ///< node records

  PINBALL_FUNCTION void operator()(std::int64_t pack) const {
    update_pinball_pack<T, update_radius>(pinballs, position, velocity, pack);
  }
};

/// Radius of the ball of an element's present volume, as update_pinball_pack finds it but for the rounding of the cube
/// root [length]. position: node records; corner: eight nodes; factor: on the radius of (3.2).
template <class S>
PINBALL_FUNCTION S present_radius(const S* position, const std::int32_t* corner, S factor) {
  Vec3<S> x[8];
  for (int i = 0; i < 8; ++i) {
    const S* const of = record(position, corner[i]);
    x[i] = {of[0], of[1], of[2]};
  }
  const HexahedronModes<S> modes = to_modes(x);
  return factor * ball_radius_of_cube(S(std::cbrt(absolute(hexahedron_volume(uniform_gradient(modes), modes)))));
}

/// Whether the ball of an element has grown beyond `most` times what it was; also where a position is not a number.
template <class S>
struct BallsGrow {
  const std::int32_t* corner;  ///< eight nodes of each element, one after the other
  const S* radius;             ///< as it was [length]
  const S* position;           ///< node records
  S most;                      ///< [-]
  S factor;                    ///< on the radius of (3.2) [-]

  PINBALL_FUNCTION bool operator()(std::int64_t p) const {
    return !(present_radius(position, corner + 8 * p, factor) <= most * radius[p]);
  }
};

}  // namespace pinball

#pragma once

#include "hexahedron.hpp"

/// A pinball: the sphere embedded in a surface element (report section 3, equations (3.1) to (3.12)).
///
///     C = 1/8 sum_I x_I                          centre, the mean of the corners            (3.1)
///     R = (3 V / 4 pi)^(1/3)                     radius of the sphere of equal volume       (3.2)
///     |C1 - C2 + g n| = R1 + R2                  penetration g >= 0 along n                 (3.4)
///     n = (n2 - n1) / 2, made a unit vector      n1, n2 outward element normals             (3.5)
///     F = (p1 gdot + p2 g) n on pinball 1        penalty force, never adhesive              (3.8)
///     gdot = (V2 - V1) . n                       rate of penetration                        (3.10)  (see penetration)
///     p2 = beta/2 (B1 R1 + B2 R2)                                                           (3.11)
///
/// The report's n is not of unit length, which (3.8) and (3.10) need; here it is normalised first.
namespace pinball {

/// Radius of the ball of a volume, (3.2), for what is computed once [length].
PINBALL_FUNCTION double ball_radius(double volume) { return ::cbrt(volume * 3.0 / (4.0 * M_PI)); }

/// The same of the volume of a cube, given its edge: for radii that follow the present volumes, in the precision of S.
/// It rounds otherwise than ball_radius, and how the cube root is rounded is for the caller to choose.
template <class S>
PINBALL_FUNCTION S ball_radius_of_cube(S edge) {
  return S(0.62035049089940009) * edge;
}

/// Normals of a pinball [length^2]. `outward` is the sum of the area vectors of those exposed faces whose opposite face
/// is not exposed. An element exposed on two opposite sides (a plate one element thick, or what erosion leaves) has no
/// net normal across them: `two_sided` is the area vector of that pair of faces, whose sign each partner chooses. With
/// two or more such pairs (a bar one element thick, a single element) the line of centres decides: there are none, but
/// that the end of a bar looks at partners in front of it. Of a bar that the mesh has as one, not of what erosion has
/// left of more, `two_sided` is the opposite of `outward` there: the sum of both is zero for all that are beside the
/// end, or behind it.
template <class T>
struct PinballNormal {
  Vec3<T> outward;
  Vec3<T> two_sided;
};

/// x: modes of the corners; exposed[f]: 1 where face f (xi-, xi+, eta-, eta+, zeta-, zeta+) is exposed, else 0; bar: 1
/// for an element of a bar one element thick, else 0.
template <class T>
PINBALL_FUNCTION PinballNormal<T> pinball_normal(const HexahedronModes<T>& x, const T (&exposed)[6],
                                                 const T& bar = T(0)) {
  PinballNormal<T> n{{T(0), T(0), T(0)}, {T(0), T(0), T(0)}};
  T pairs(0);
  PINBALL_UNROLL
  for (int i = 0; i < 3; ++i) {
    Vec3<T> minus, plus;
    face_areas(x, i, minus, plus);
    const T both = exposed[2 * i] * exposed[2 * i + 1];
    n.outward = n.outward + (exposed[2 * i] - both) * minus + (exposed[2 * i + 1] - both) * plus;
    n.two_sided = n.two_sided + (number<T>(0.5) * both) * (plus - minus);
    pairs += both;
  }
  const T keep = select(pairs > number<T>(1.5), T(0), T(1));  // if (pairs >= 2) two_sided = 0
  n.two_sided = keep * n.two_sided;
  const auto ends = pairs > number<T>(1.5) && bar > number<T>(0.5);
  n.two_sided = {select(ends, T(0) - n.outward.x, n.two_sided.x), select(ends, T(0) - n.outward.y, n.two_sided.y),
                 select(ends, T(0) - n.outward.z, n.two_sided.z)};
  return n;
}

/// Unit normal of a pinball towards a partner in direction `to_partner` (any length); zero where it has none.
template <class T>
PINBALL_FUNCTION Vec3<T> unit_normal_towards(const PinballNormal<T>& normal, const Vec3<T>& to_partner) {
  // if (two_sided points away from the partner) subtract it; else add it
  const T sign = select(dot(normal.two_sided, to_partner) < T(0), T(-1), T(1));
  const Vec3<T> n = normal.outward + sign * normal.two_sided;
  const T length2 = dot(n, n);
  const auto some = length2 > T(0);
  const T inverse = select(some, T(1) / square_root(select(some, length2, T(1))), T(0));
  return inverse * n;
}

/// Which way a pair is pushed apart.
template <class T>
struct PairDirection {
  MaskOf<T> opposed;  ///< the two surfaces can touch
  Vec3<T> direction;  ///< n, unit, from pinball 2 to pinball 1
};

/// d = C1 - C2; n1, n2: unit normals of both (zero allowed). The direction is that of the mean normal (3.5), or the
/// line of centres where there is none, or where it is more than 18 degrees off (see penetration).
template <class T>
PINBALL_FUNCTION PairDirection<T> pair_direction(const Vec3<T>& d, const Vec3<T>& n1, const Vec3<T>& n2) {
  const T d2 = dot(d, d);
  // Pairs whose normals look the same way belong to one surface, or to opposite faces of a thin body; unless each looks
  // at the other by more than 12 degrees: aslant, as where two edges (n1.n2 = 0) or corners (1/3) meet face to face.
  const T least = number<T>(0.04) * d2, towards1 = T(0) - dot(n1, d), towards2 = dot(n2, d);
  const auto face_each_other =
      minimum(towards1, towards2) > T(0) && towards1 * towards1 > least && towards2 * towards2 > least;
  const auto opposed = !(dot(n1, n2) > number<T>(0.3)) || face_each_other;

  // if (|n| >= 0.2 and n.d >= cos(18 degrees) |n| |d|) direction = n = (n2 - n1)/2; else direction = d
  const Vec3<T> mean = number<T>(0.5) * (n2 - n1);
  const T mean2 = dot(mean, mean), along = dot(mean, d);
  const auto use_mean = mean2 >= number<T>(0.04) && along >= T(0) && along * along >= number<T>(0.9045) * mean2 * d2;
  const Vec3<T> chosen{select(use_mean, mean.x, d.x), select(use_mean, mean.y, d.y), select(use_mean, mean.z, d.z)};
  const T length2 = select(use_mean, mean2, d2);
  const auto defined = length2 > T(0);  // false for coincident centres without normals: no direction, no force
  const T inverse = T(1) / square_root(select(defined, length2, T(1)));
  return {opposed && defined, inverse * chosen};
}

/// Geometry of a penetrating pair.
template <class T>
struct Penetration {
  MaskOf<T> active;   ///< the balls overlap and their normals oppose each other
  T depth;            ///< g [length]
  Vec3<T> direction;  ///< n, unit, from pinball 2 to pinball 1
  Vec3<T> gradient;   ///< e/(e.n), e = (d + g n)/reach: gdot = gradient.(V2 - V1), and p2 g gradient is the force on 1
};

/// d = C1 - C2; reach = R1 + R2; n1, n2: unit normals of both (zero allowed).
///
/// With b = n.d and c = d.d - reach^2 the depth is g = -b + sqrt(b^2 - c), (3.6), here as -c / (b + sqrt(b^2 - c))
/// without its cancellation; the test on c comes before the square root.
///
/// With n held fixed the depth changes by gdot = e.(V2 - V1)/(e.n), not by n.(V2 - V1) as in (3.10), and the force that
/// does the work of the energy p2 g^2/2 is p2 g e/(e.n), not p2 g n as in (3.8). The report's forms agree with these
/// where n is along the line of centres; aslant to it they create energy: with normals up to 37 degrees off, a tenth of
/// 300 random oblique impacts of two elastic blocks gained more than 22 % of their energy, the worst 128 %; with the
/// conjugate force and normals up to 18 degrees off, all stay within 3 %. Beyond that, and where |n| < 0.2, the line of
/// centres takes the place of n.
template <class T>
PINBALL_FUNCTION Penetration<T> penetration(const Vec3<T>& d, const T& reach, const Vec3<T>& n1, const Vec3<T>& n2) {
  const T c = dot(d, d) - reach * reach;
  const auto overlaps = c < T(0);
  const PairDirection<T> pair = pair_direction(d, n1, n2);
  const Vec3<T>& n = pair.direction;

  const T b = dot(n, d);  // never negative
  const T root = square_root(maximum(T(0), b * b - c));
  const T g = (T(0) - c) / select(overlaps, b + root, T(1));
  const Vec3<T> gradient = (T(1) / select(overlaps, root, T(1))) * (d + g * n);  // root = (d + g n).n
  return {overlaps && pair.opposed, g, n, gradient};
}

}  // namespace pinball

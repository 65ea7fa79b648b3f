#pragma once

#include "neo_hookean.hpp"

/// Rubber after Mooney (J. Appl. Phys. 11, 582-592, 1940) and Rivlin (Phil. Trans. R. Soc. A 241, 379-397, 1948), with
/// the compressible energy per initial volume that is LS-DYNA's of material 27 (not compared with its manual):
///
///     W = A (I - 3) + B (II - 3) + C (III^-2 - 1) + D (III - 1)^2 ,     I, II, III: invariants of b = F F^T ,
///     C = A/2 + B ,   D = (A (5 nu - 2) + B (11 nu - 5))/(2 (1 - 2 nu)) ,
///
/// so that there is no stress without strain, and small strains follow Hooke's law of mu = 2 (A + B) and nu. Its Cauchy
/// stress, with E = b - I, which elements keep, and J^2 = III of the volume:
///
///     sigma = 2/J ( p I + (A + B + B tr E) E - B E^2 ) ,   p = B tr E + 2 C (1 - III^-2) + 2 D III (III - 1) .
///
/// Closed forms: 2 (A + B) k, 2 A k^2 and -2 B k^2 in simple shear by k. b <- f b f^T is exact for any strain and
/// rotation, with f of neo_hookean.hpp.
namespace pinball {

template <class S>
struct MooneyRivlinConstants {
  bool used = false;
  S a = S(0), b = S(0);  ///< A, B [stress]
  S c = S(0), d = S(0);  ///< C, D [stress]
};

/// E^2.
template <class T>
PINBALL_FUNCTION Symmetric<T> square_of(const Symmetric<T>& e) {
  const Vec3<T> x{e.xx, e.xy, e.zx}, y{e.xy, e.yy, e.yz}, z{e.zx, e.yz, e.zz};
  return {dot(x, x), dot(y, y), dot(z, z), dot(x, y), dot(y, z), dot(z, x)};
}

/// E after a step: f (I + E) f^T - I, f = (I - h)^-1 (I + h). half: h = L dt/2, of the mid-step configuration [-].
template <class T>
PINBALL_FUNCTION Symmetric<T> strain_after(const Tensor<T>& half, const Symmetric<T>& e) {
  const Tensor<T> g = gradient_of_step(half);
  const Vec3<T>&ga = g.row_x, &gb = g.row_y, &gc = g.row_z;
  const Symmetric<T> whole{T(1) + e.xx, T(1) + e.yy, T(1) + e.zz, e.xy, e.yz, e.zx};
  const Vec3<T> na = whole * ga, nb = whole * gb, nc = whole * gc;  // rows of g b
  return {e.xx + (T(2) * na.x + dot(na, ga)), e.yy + (T(2) * nb.y + dot(nb, gb)), e.zz + (T(2) * nc.z + dot(nc, gc)),
          e.xy + (na.y + nb.x + dot(na, gb)), e.yz + (nb.z + nc.y + dot(nb, gc)), e.zx + (nc.x + na.z + dot(nc, ga))};
}

/// Stress of the strain E and the volume ratio J, and moduli of a linear material that is at least as stiff.
///
/// Twice the energy of a small motion of gradient H, per volume, with t = tr H, h = tr HH and k = III b^-1, is 1/J
/// times
///
///     2 A H b : H + B (2 (t I - H^T) k : (t I - H^T) + 4 cof(H) : k) + J^2 U'' t^2 + J U' (t^2 - h) ,
///
/// U(J) what depends on J alone. With the largest principal values of b and k, tr cof(H) = (t^2 - h)/2, |h| <= H : H
/// and |cof H| <= H : H/sqrt(3) it is no more than P H : H + Q t^2,
///
///     P = 2 A b_1 + 2 B k_1 + 4/sqrt(3) B |dev k| + |w| ,   Q = 2 B k_1 + J^2 U'' + w ,   w = 2/3 B II + J U' ,
///
/// exact without strain: there P = 4 (A + B), Q = lambda.
template <class T>
PINBALL_FUNCTION NeoHookeanState<T> mooney_rivlin_state(const MooneyRivlinConstants<ScalarOf<T>>& law,
                                                        const Symmetric<T>& e, const T& ratio) {
  using S = ScalarOf<T>;
  const T a(law.a), b(law.b), j2 = ratio * ratio, inverse_j4 = T(1) / (j2 * j2), inverse = T(1) / ratio;
  const T more = (ratio - T(1)) * (ratio + T(1));  // III - 1
  const T strain = trace(e), inflation = T(2 * law.c) * inverse_j4 * more * (j2 + T(1)) + T(2 * law.d) * j2 * more;
  const Symmetric<T> e2 = square_of(e);
  const T p = b * strain + inflation;
  const T two = T(2) * inverse;
  NeoHookeanState<T> now;
  now.stress = two * ((a + b + b * strain) * e - b * e2);
  now.stress.xx += two * p;
  now.stress.yy += two * p;
  now.stress.zz += two * p;

  const T third = number<T>(1.0 / 3.0), root = number<T>(0.81649658092772603273);  // sqrt(2/3)
  const Symmetric<T> of_b = deviator_of(e), of_k = deviator_of(e2 - (T(1) + strain) * e);
  const T k_size = square_root(contract(of_k, of_k));
  const T first = T(3) + strain, square = T(3) + T(2) * strain + trace(e2);  // I, tr b^2
  const T k_mean = third * number<T>(0.5) * (first * first - square);
  const T b_1 = T(1) + third * strain + root * square_root(contract(of_b, of_b)), k_1 = k_mean + root * k_size;
  // J U' and J^2 U''
  const T slope = T(4 * law.d) * j2 * more - T(4 * law.c) * inverse_j4;
  const T curvature = T(20 * law.c) * inverse_j4 + T(4 * law.d) * j2 * (T(3) * j2 - T(1));
  const T w = T(2) * b * k_mean + slope;
  now.mu = T(S(0.5)) * inverse *
           (T(2) * a * b_1 + T(2) * b * k_1 + number<T>(2.3094010767585030580) * b * k_size + absolute(w));
  now.lambda = maximum(T(0), inverse * (T(2) * b * k_1 + curvature + w));
  return now;
}

/// Over a step. strain: E, of the old state and then of the new; where `whole` is not set, half must be zero, and
/// strain and stress stay.
template <class T>
PINBALL_OUTLINED void update_mooney_rivlin(const MooneyRivlinConstants<ScalarOf<T>>& law, const Tensor<T>& half,
                                           const VolumeChange<T>& volume, const MaskOf<T>& whole,
                                           const Symmetric<T>& old, Symmetric<T>& strain, NeoHookeanState<T>& now) {
  strain = select(whole, strain_after(half, strain), strain);
  // What is pressed to a thousandth of its volume is as stiff as that.
  const T ratio = select(whole, maximum(volume.end * volume.inverse_initial, number<T>(1e-3)), T(1));
  now = mooney_rivlin_state(law, strain, ratio);
  now.stress = select(whole, now.stress, old);
}

}  // namespace pinball

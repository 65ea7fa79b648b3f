#pragma once

#include <cmath>

#include "macros.hpp"
#include "simd.hpp"
#include "tensor.hpp"

/// Projection of a slave node onto a master segment: the narrow phase of a slideline (Belytschko and Lin,
/// Computers and Structures 25, 95-104, 1987; Hallquist, Goudreau and Benson, Comp. Meths. Appl. Mech. Engrg. 51,
/// 107-137, 1985).
///
/// The segment is the bilinear face x(xi, eta) = sum_I N_I x_I of four nodes in the order of face_nodes; the foot of
/// the node x is where x - x(xi, eta) is normal to it, found by Newton iteration:
///
///     r_a = (x - x(xi, eta)) . t_a = 0 ,     t_1 = dx/dxi , t_2 = dx/deta .
namespace pinball {

template <class S>
struct FaceProjection {
  S xi{}, eta{};     ///< of the foot, beyond +-1 where it lies outside
  S weight[4]{};     ///< N_I at the foot, moved to the edge if it lies outside [-]
  Vec3<S> normal{};  ///< unit outward normal there [-]
  S gap{};           ///< (x - foot) . normal, negative if x has penetrated [length]
  S outside{};       ///< how far the foot lies beyond the edges, 0 inside; infinity if there is none [length]
};

template <class T>
PINBALL_FUNCTION Vec3<T> face_tangent(const Vec3<T> (&x)[4], int along, const T& other) {
  const T quarter = number<T>(0.25);
  const T low = quarter * (T(1) - other), high = quarter * (T(1) + other);
  return along == 0 ? low * (x[1] - x[0]) + high * (x[2] - x[3]) : low * (x[3] - x[0]) + high * (x[2] - x[1]);
}

template <class T>
PINBALL_FUNCTION void face_weights_at(const T& xi, const T& eta, T (&weight)[4]) {
  const T quarter = number<T>(0.25);
  weight[0] = quarter * (T(1) - xi) * (T(1) - eta);
  weight[1] = quarter * (T(1) + xi) * (T(1) - eta);
  weight[2] = quarter * (T(1) + xi) * (T(1) + eta);
  weight[3] = quarter * (T(1) - xi) * (T(1) + eta);
}

/// The foot on a triangle, a face with two corners of a side in one place, in closed form; none on other faces.
/// Newton's iteration may go round in circles there, for a node above the middle of a side, say, and where the two
/// corners are the face has no tangents. With the shares a and b that the corners across have of the foot, the
/// coordinate away from the two is 2 (a + b) - 1, and the other one (b - a)/(a + b).
template <class T>
PINBALL_FUNCTION FaceProjection<T> foot_on_triangle(const Vec3<T> (&x)[4], const Vec3<T>& node) {
  const T zero(0), one(1), none = number<T>(INFINITY);
  const auto within = [](const T& at, const T& end) { return maximum(T(0) - end, minimum(end, at)); };
  FaceProjection<T> foot;
  foot.normal = {zero, zero, zero};
  T outside = none;
  for (int k = 0; k < 4; ++k) {
    const Vec3<T> side = x[(k + 1) % 4] - x[k], to = node - x[k];
    const Vec3<T> to_a = x[(k + 2) % 4] - x[k], to_b = x[(k + 3) % 4] - x[k], area = cross(to_a, to_b);
    const T square = dot(area, area), inverse = one / square;
    const auto here = dot(side, side) <= zero && square > zero;
    const T a = inverse * dot(cross(to, to_b), area), b = inverse * dot(cross(to_a, to), area), across = a + b;
    // if (the foot is where the two corners are) in the middle of these
    const T between = select(absolute(across) > zero, (b - a) / across, zero);
    const T along = within(k < 2 ? T(0) - between : between, number<T>(3));
    const T away = within(k % 3 == 0 ? T(2) * across - one : one - T(2) * across, number<T>(3));
    const T xi = k % 2 == 0 ? along : away, eta = k % 2 == 0 ? away : along;
    const T inner_xi = within(xi, one), inner_eta = within(eta, one);
    const Vec3<T> normal = (one / square_root(square)) * area;
    const Vec3<T> beyond =
        (xi - inner_xi) * face_tangent(x, 0, inner_eta) + (eta - inner_eta) * face_tangent(x, 1, inner_xi);
    T weight[4];
    face_weights_at(inner_xi, inner_eta, weight);
    foot.xi = select(here, xi, foot.xi);
    foot.eta = select(here, eta, foot.eta);
    for (int i = 0; i < 4; ++i) foot.weight[i] = select(here, weight[i], foot.weight[i]);
    foot.normal = select(here, normal, foot.normal);
    foot.gap = select(here, dot(to, normal), foot.gap);
    outside = select(here, square_root(dot(beyond, beyond)), outside);
  }
  // if (the gap or the way is not a number) none
  foot.outside = select(outside < none && absolute(foot.gap) < none, outside, none);
  return foot;
}

/// x: corners of the face; node: the point to project; xi, eta: where the iteration begins.
template <class S>
PINBALL_FUNCTION FaceProjection<S> project_onto_face(const Vec3<S> (&x)[4], const Vec3<S>& node, S xi, S eta) {
  constexpr int most_iterations = 12;
  constexpr S tolerance = sizeof(S) == 8 ? S(1e-14) : S(1e-5);
  constexpr S far = S(3);  // a foot out there is of no use: it keeps the iteration from running away
  // Relative to the node, so that the iteration ends wherever the face lies: at a hundred times its size from the
  // origin the round-off of absolute places exceeds the tolerance.
  const Vec3<S> y[4] = {x[0] - node, x[1] - node, x[2] - node, x[3] - node};
  const auto from_node = [&y](const S(&w)[4]) { return w[0] * y[0] + w[1] * y[1] + w[2] * y[2] + w[3] * y[3]; };
  const Vec3<S> twist = S(0.25) * ((x[0] - x[1]) + (x[2] - x[3]));  // d2x/dxi deta
  FaceProjection<S> result;
  result.outside = INFINITY;
  bool found = false;
  for (int i = 0; i < most_iterations && !found; ++i) {
    const Vec3<S> t1 = face_tangent(x, 0, eta), t2 = face_tangent(x, 1, xi);
    face_weights_at(xi, eta, result.weight);
    const Vec3<S> d = S(-1) * from_node(result.weight);
    const S a11 = dot(t1, t1), a22 = dot(t2, t2), gauss_newton = dot(t1, t2);
    S a12 = gauss_newton - dot(d, twist);
    S determinant = a11 * a22 - a12 * a12;
    if (!(determinant > S(0.01) * a11 * a22)) {  // far from the face the second derivative misleads
      a12 = gauss_newton;
      determinant = a11 * a22 - a12 * a12;
    }
    if (!(determinant > S(0))) return foot_on_triangle(x, node);
    const S r1 = dot(d, t1), r2 = dot(d, t2);
    const S change_xi = (a22 * r1 - a12 * r2) / determinant, change_eta = (a11 * r2 - a12 * r1) / determinant;
    const S next_xi = maximum(-far, minimum(far, xi + change_xi));
    const S next_eta = maximum(-far, minimum(far, eta + change_eta));
    found = absolute(next_xi - xi) + absolute(next_eta - eta) < tolerance;
    xi = next_xi;
    eta = next_eta;
  }
  if (!found) return foot_on_triangle(x, node);
  result.xi = xi;
  result.eta = eta;
  const S inner_xi = maximum(S(-1), minimum(S(1), xi)), inner_eta = maximum(S(-1), minimum(S(1), eta));
  const Vec3<S> t1 = face_tangent(x, 0, inner_eta), t2 = face_tangent(x, 1, inner_xi);
  const Vec3<S> area = cross(t1, t2);
  const S size = square_root(dot(area, area));
  if (!(size > S(0))) return foot_on_triangle(x, node);
  result.normal = (S(1) / size) * area;
  face_weights_at(inner_xi, inner_eta, result.weight);
  result.gap = S(0) - dot(from_node(result.weight), result.normal);
  const Vec3<S> beyond = (xi - inner_xi) * t1 + (eta - inner_eta) * t2;
  result.outside = square_root(dot(beyond, beyond));
  return result;
}

/// Takes another foot in the lanes of a mask.
template <class M, class T>
PINBALL_FUNCTION void replace_foot(const M& where, const FaceProjection<T>& other, FaceProjection<T>& foot) {
  foot.xi = select(where, other.xi, foot.xi);
  foot.eta = select(where, other.eta, foot.eta);
  for (int k = 0; k < 4; ++k) foot.weight[k] = select(where, other.weight[k], foot.weight[k]);
  foot.normal = select(where, other.normal, foot.normal);
  foot.gap = select(where, other.gap, foot.gap);
  foot.outside = select(where, other.outside, foot.outside);
}

/// The same for a pack of faces and nodes, from the middle: the lanes whose feet are found wait for the others, so that
/// none depends on which these are.
template <class T>
PINBALL_FUNCTION FaceProjection<T> foot_on_face(const Vec3<T> (&x)[4], const Vec3<T>& node) {
  constexpr int most_iterations = 12;
  const T far = number<T>(3), tolerance = number<T>(1e-9), one = T(1);
  const Vec3<T> y[4] = {x[0] - node, x[1] - node, x[2] - node, x[3] - node};
  const auto from_node = [&y](const T(&w)[4]) { return w[0] * y[0] + w[1] * y[1] + w[2] * y[2] + w[3] * y[3]; };
  const Vec3<T> twist = number<T>(0.25) * ((x[0] - x[1]) + (x[2] - x[3]));
  FaceProjection<T> result;
  T xi(0), eta(0);
  auto going = far > T(0);
  for (int i = 0; i < most_iterations && any_lane(going); ++i) {
    const Vec3<T> t1 = face_tangent(x, 0, eta), t2 = face_tangent(x, 1, xi);
    face_weights_at(xi, eta, result.weight);
    const Vec3<T> d = from_node(result.weight);
    const T a11 = dot(t1, t1), a22 = dot(t2, t2), gauss_newton = dot(t1, t2);
    const T full = gauss_newton + dot(d, twist), with_full = a11 * a22 - full * full;
    // if (far from the face the second derivative misleads) without it
    const auto leads = with_full > number<T>(0.01) * a11 * a22;
    const T a12 = select(leads, full, gauss_newton);
    const T determinant = a11 * a22 - a12 * a12;
    const T inverse = one / determinant;
    const T r1 = dot(d, t1), r2 = dot(d, t2);
    const T next_xi = maximum(T(0) - far, minimum(far, xi - (a22 * r1 - a12 * r2) * inverse));
    const T next_eta = maximum(T(0) - far, minimum(far, eta - (a11 * r2 - a12 * r1) * inverse));
    // What is not a number may become the end of the range, and stay there: the gap tells.
    const auto moving = !(absolute(next_xi - xi) + absolute(next_eta - eta) < tolerance);
    xi = select(going, next_xi, xi);
    eta = select(going, next_eta, eta);
    going = going && moving;
  }
  result.xi = xi;
  result.eta = eta;
  const T inner_xi = maximum(T(0) - one, minimum(one, xi)), inner_eta = maximum(T(0) - one, minimum(one, eta));
  const Vec3<T> t1 = face_tangent(x, 0, inner_eta), t2 = face_tangent(x, 1, inner_xi);
  const Vec3<T> area = cross(t1, t2);
  result.normal = (one / square_root(dot(area, area))) * area;
  face_weights_at(inner_xi, inner_eta, result.weight);
  result.gap = T(0) - dot(from_node(result.weight), result.normal);
  const Vec3<T> beyond = (xi - inner_xi) * t1 + (eta - inner_eta) * t2;
  const T outside = square_root(dot(beyond, beyond));
  // if (it has not ended, or the gap or the way is not a number) that on a triangle, or none
  const T none = number<T>(INFINITY);
  const auto found = !going && outside < none && absolute(result.gap) < none;
  result.outside = select(found, outside, none);
  if (any_lane(!found)) replace_foot(!found, foot_on_triangle(x, node), result);
  return result;
}

/// Moves a foot that lies beyond the sides of its face to the nearest point of these. Faces that share a side then have
/// one point there for a node that is beyond both.
template <class T>
PINBALL_FUNCTION void move_to_nearest_side(const Vec3<T> (&x)[4], const Vec3<T>& node, FaceProjection<T>& foot) {
  const T one(1), none = number<T>(INFINITY);
  const auto inner = [&](const T& at) { return maximum(T(0) - one, minimum(one, at)); };
  const auto from_node = [&](const T& xi, const T& eta) {
    T w[4];
    face_weights_at(xi, eta, w);
    return w[0] * (x[0] - node) + w[1] * (x[1] - node) + w[2] * (x[2] - node) + w[3] * (x[3] - node);
  };
  const T side_xi = inner(foot.xi), side_eta = inner(foot.eta);
  const Vec3<T> along_eta = face_tangent(x, 1, side_xi), along_xi = face_tangent(x, 0, side_eta);
  const T near_eta = inner(T(0) - dot(from_node(side_xi, T(0)), along_eta) / dot(along_eta, along_eta));
  const T near_xi = inner(T(0) - dot(from_node(T(0), side_eta), along_xi) / dot(along_xi, along_xi));
  const Vec3<T> at_xi_side = from_node(side_xi, near_eta), at_eta_side = from_node(near_xi, side_eta);
  const auto beyond_xi = absolute(foot.xi) > one, beyond_eta = absolute(foot.eta) > one;
  const auto on_eta_side = beyond_eta && !(beyond_xi && dot(at_xi_side, at_xi_side) <= dot(at_eta_side, at_eta_side));
  const auto moves = (beyond_xi || beyond_eta) && foot.outside < none;
  const T xi = select(on_eta_side, near_xi, side_xi), eta = select(on_eta_side, side_eta, near_eta);
  const Vec3<T> area = cross(face_tangent(x, 0, eta), face_tangent(x, 1, xi));
  const T size = square_root(dot(area, area)), inverse = one / size;
  // if (two corners are one there) the normal of the triangle
  const Vec3<T> normal = select(size > T(0), inverse * area, foot.normal), to = from_node(xi, eta);
  const T gap = T(0) - dot(to, normal);
  const Vec3<T> beside = to + gap * normal;
  FaceProjection<T> moved{foot.xi, foot.eta, {}, normal, gap, square_root(dot(beside, beside))};
  face_weights_at(xi, eta, moved.weight);
  replace_foot(moves, moved, foot);
  // if (the face is flat to nothing there) none
  foot.outside = select(foot.outside < none && absolute(foot.gap) < none, foot.outside, none);
}

/// Moves a foot in the plane of the face, beyond its sides if need be, to where it is seen from the node along a
/// direction: a force along that, on the node and on the face, has no moment then. Returns the gap along the direction.
/// to: from the foot to the node; direction: of unit length, not along the plane; weight: of the foot.
template <class S>
PINBALL_FUNCTION S move_to_line(const Vec3<S> (&x)[4], const Vec3<S>& to, const Vec3<S>& direction, S (&weight)[4]) {
  const S quarter(0.25);
  const S xi = (weight[1] + weight[2]) - (weight[0] + weight[3]),
          eta = (weight[2] + weight[3]) - (weight[0] + weight[1]);
  const Vec3<S> t1 = face_tangent(x, 0, eta), t2 = face_tangent(x, 1, xi), area = cross(t1, t2);
  const S gap = dot(to, area) / dot(direction, area);
  const Vec3<S> way = to - gap * direction;
  const S a11 = dot(t1, t1), a22 = dot(t2, t2), a12 = dot(t1, t2), r1 = dot(way, t1), r2 = dot(way, t2);
  const S determinant = a11 * a22 - a12 * a12;
  const S along_xi = quarter * (a22 * r1 - a12 * r2) / determinant,
          along_eta = quarter * (a11 * r2 - a12 * r1) / determinant;
  weight[0] -= along_xi * (S(1) - eta) + along_eta * (S(1) - xi);
  weight[1] += along_xi * (S(1) - eta) - along_eta * (S(1) + xi);
  weight[2] += along_xi * (S(1) + eta) + along_eta * (S(1) + xi);
  weight[3] += along_eta * (S(1) - xi) - along_xi * (S(1) + eta);
  return gap;
}

}  // namespace pinball

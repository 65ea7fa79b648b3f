#pragma once

#include <cstdint>

#include <solver/contact/surface/surface.hpp>
#include <solver/model/model.hpp>
#include <solver/model/model_surface.hpp>

/// Bytes that a stage of the step has to move at least when nothing stays in a cache: every array that it reads once,
/// and those that it also writes twice. They follow from the layout of the stores alone.
namespace pinball::bench {

template <class S>
double element_traffic(const Model<S>& model) {
  const ElementStore& e = model.elements;
  const NodeStore<S>& n = model.nodes;
  const double once = static_cast<double>(e.corner.bytes() + e.mass.bytes());
  const double state = static_cast<double>(e.stress.bytes() + e.plastic_strain.bytes() + e.hourglass_state.bytes() +
                                           e.viscous_stress.bytes() + e.internal_energy.bytes());
  return once + 2 * state + static_cast<double>(n.position.bytes() + n.velocity.bytes() + 2 * n.force.bytes());
}

template <class S>
double integration_traffic(const Model<S>& model) {
  const NodeStore<S>& n = model.nodes;
  return static_cast<double>(2 * (n.position.bytes() + n.velocity.bytes() + n.force.bytes()) + n.inverse_mass.bytes()) +
         static_cast<double>(model.node_mass.size() * sizeof(double));
}

/// Exposed faces: the segments of a slideline.
template <class S>
std::int64_t exposed_faces(const Model<S>& model) {
  return Surface(surface_topology(model)).exposed_faces();
}

/// Records of four numbers that a stage reads (once) or writes (twice: a line is read before it is written).
template <class S>
constexpr double records(double read, double written = 0) {
  return 4 * sizeof(S) * (read + 2 * written);
}

/// Of the listed pinballs: corners, exposed faces and the nodes in; centre, velocity and two normals out.
template <class S>
double pinball_traffic(double pinballs, double nodes) {
  return pinballs * (8 * sizeof(std::int32_t) + 6 * sizeof(S) + records<S>(0, 4)) + records<S>(2) * nodes;
}

/// Per place of the list the numbers of both pinballs and the depth at which the pair began; per pinball its four
/// records in and its force out.
template <class S>
double pair_traffic(double places, double pinballs) {
  return places * (2 * sizeof(std::int32_t) + sizeof(S)) + pinballs * records<S>(4, 1);
}

/// Forces and corners of the pinballs in, forces of the nodes in and out, their inverse masses in.
template <class S>
double scatter_traffic(double pinballs, double nodes) {
  return pinballs * (records<S>(1) + 8 * sizeof(std::int32_t)) + nodes * (records<S>(0, 1) + sizeof(S));
}

/// Corners of the segments and the nodes in, sphere and plane out.
template <class S>
double segment_traffic(double segments, double nodes) {
  return segments * (4 * sizeof(std::int32_t) + records<S>(0, 2)) + records<S>(1) * nodes;
}

/// Candidates of each slave in; every segment (sphere, plane, corners) and every node once, and the state of the slave.
template <class S>
double narrow_traffic(double candidates, double segments, double slaves) {
  const double state = 2 * sizeof(std::int32_t) + 9 * sizeof(S);
  return candidates * sizeof(std::int32_t) + segments * (4 * sizeof(std::int32_t) + records<S>(2)) +
         slaves * (records<S>(2) + 2 * state);
}

/// Number, position, and where each node was, how it moved and how far it may stray.
template <class S>
double watching_traffic(double nodes) {
  return nodes * (sizeof(std::int32_t) + records<S>(1) + 7 * sizeof(S));
}

/// Positions and velocities of nodes taken down; balls of 7 numbers written, and read.
template <class S>
double moving_traffic(double nodes, double balls) {
  return nodes * (sizeof(std::int32_t) + records<S>(2) + 2 * 7 * sizeof(S)) + balls * 3 * 7 * sizeof(S);
}

/// Corners in; pairs found and numbered, offset and energy of each place, and the store of the listed pinballs
/// (corners twice, exposed faces, records) out.
template <class S>
double pinball_search_traffic(double pinballs, double nodes, double listed, double places) {
  const double store = 2 * (16 * sizeof(std::int32_t) + 6 * sizeof(S)) + records<S>(0, 4);
  return moving_traffic<S>(nodes, pinballs) + pinballs * 8 * sizeof(std::int32_t) + listed * store +
         places * 2 * (4 * sizeof(std::int32_t) + 2 * sizeof(S));
}

/// Corners of the segments in, candidates of each slave written twice: as found, and joined.
template <class S>
double slideline_search_traffic(double segments, double slaves, double candidates) {
  return moving_traffic<S>(slaves, segments + slaves) + segments * 4 * sizeof(std::int32_t) +
         candidates * 5 * sizeof(std::int32_t);
}

}  // namespace pinball::bench

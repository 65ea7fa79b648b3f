#pragma once

#include "node_arrays.hpp"

/// Forces on nodes: lists of forces as node_arrays.hpp has them. What is the same for all nodes is one vector, which
/// follow() takes in.
namespace pinball {

/// f_i = s_i F: shares of a force.
template <class S>
struct SharedForce {
  const std::int32_t* nodes;
  const S* share;  ///< [-]
  S total[3];      ///< F [force]

  void follow(const double* vector) {
    for (int k = 0; k < 3; ++k) total[k] = static_cast<S>(vector[k]);
  }
  PINBALL_FUNCTION std::int64_t node(std::int64_t i) const { return nodes[i]; }
  PINBALL_FUNCTION void find(const NodeArrays<S>& /*of*/, std::int64_t i, S* force) const {
    for (int k = 0; k < 3; ++k) force[k] = share[i] * total[k];
  }
};

/// f = m g, on all nodes.
template <class S>
struct GravityForce {
  double acceleration[3];  ///< g [length/time^2]

  void follow(const double* vector) {
    for (int k = 0; k < 3; ++k) acceleration[k] = vector[k];
  }
  PINBALL_FUNCTION std::int64_t node(std::int64_t n) const { return n; }
  PINBALL_FUNCTION void find(const NodeArrays<S>& of, std::int64_t n, S* force) const {
    for (int k = 0; k < 3; ++k) force[k] = static_cast<S>(of.mass[n] * acceleration[k]);
  }
};

/// f_i = m_i g: on the parts of nodes that belong to some bodies. Their masses are those without ties: what is tied
/// gives its mass to corners that may be of others.
template <class S>
struct PartGravityForce {
  const std::int32_t* nodes;
  const double* share;     ///< m_i [mass]
  double acceleration[3];  ///< g [length/time^2]

  void follow(const double* vector) {
    for (int k = 0; k < 3; ++k) acceleration[k] = vector[k];
  }
  PINBALL_FUNCTION std::int64_t node(std::int64_t i) const { return nodes[i]; }
  PINBALL_FUNCTION void find(const NodeArrays<S>& /*of*/, std::int64_t i, S* force) const {
    for (int k = 0; k < 3; ++k) force[k] = static_cast<S>(share[i] * acceleration[k]);
  }
};

/// f = -a m v, with the velocity of the middle of the step before.
template <class S>
struct DampingForce {
  double rate;  ///< a [1/time]

  PINBALL_FUNCTION std::int64_t node(std::int64_t n) const { return n; }
  PINBALL_FUNCTION void find(const NodeArrays<S>& of, std::int64_t n, S* force) const {
    const auto factor = static_cast<S>(-rate * of.mass[n]);
    for (int k = 0; k < 3; ++k) force[k] = factor * of.velocity[4 * n + k];
  }
};

/// Forces as given, in records of four like those of the nodes.
template <class S>
struct GivenForce {
  const S* given;  ///< [force]

  PINBALL_FUNCTION std::int64_t node(std::int64_t n) const { return n; }
  PINBALL_FUNCTION void find(const NodeArrays<S>& /*of*/, std::int64_t n, S* force) const {
    for (int k = 0; k < 3; ++k) force[k] = given[4 * n + k];
  }
};

}  // namespace pinball

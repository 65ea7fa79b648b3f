#pragma once

#include <cstdint>

#include "../gather.hpp"
#include "external_work.hpp"

namespace pinball {

/// What boundary conditions work on, in the memory of an execution space. Records of four numbers per node
/// (gather.hpp).
template <class S>
struct NodeArrays {
  S* position = nullptr;                       ///< x, y, z, unused [length]
  S* velocity = nullptr;                       ///< at the middle of the last step, unused [length/time]
  S* force = nullptr;                          ///< force, contact stiffness [force], [force/length]
  const S* inverse_mass = nullptr;             ///< one per node; 0 for a node that is tied [1/mass]
  const double* mass = nullptr;                ///< one per node [mass]
  const S* element_mass = nullptr;             ///< one per place of an element; 0: eroded [mass]
  const float* single_element_mass = nullptr;  ///< in its place, where elements have fewer digits than nodes

  PINBALL_FUNCTION bool has_element(std::int64_t place) const {
    return single_element_mass != nullptr ? single_element_mass[place] > 0 : element_mass[place] > S(0);
  }
};

/// What the nodes first ... first + width_of<T> - 1 have in an array with one number of each.
template <class T>
PINBALL_FUNCTION T numbers_from(const ScalarOf<T>* array, std::int64_t first) {
  if constexpr (width_of<T> == 1) {
    return array[first];
  } else {
#if !defined(PINBALL_DEVICE_COMPILER)
    return T(array + first, stdx::element_aligned);
#endif
  }
}

/// The vectors that they have in records of four.
template <class T>
PINBALL_FUNCTION Vec3<T> vectors_from(const ScalarOf<T>* records, std::int64_t first) {
  constexpr std::int32_t number[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  static_assert(width_of<T> <= 16);
  return gather_vectors<T>(record(records, first), number);
}

/// Work of a force on node n, one of all those whose sum is in nodes.force; in the place of that a tied node, which has
/// no mass, has its acceleration there (TiedNodes::put_accelerations).
template <class S>
PINBALL_FUNCTION ExternalWork work_on_node(const NodeArrays<S>& nodes, std::int64_t n, const S* force,
                                           const StepLengths& step) {
  const S mobility = nodes.inverse_mass[n] > S(0) ? nodes.inverse_mass[n] : S(1);
  S acceleration[3];
  for (int k = 0; k < 3; ++k) acceleration[k] = nodes.force[4 * n + k] * mobility;
  return work_of(force, nodes.velocity + 4 * n, acceleration, step);
}

/// Adds a force to that of node n.
template <class S>
PINBALL_FUNCTION void add_to_force(const NodeArrays<S>& nodes, std::int64_t n, const S* force) {
  for (int k = 0; k < 3; ++k) nodes.force[4 * n + k] += force[k];
}

/// Three numbers that are summed up.
struct VectorSum {
  double x = 0, y = 0, z = 0;

  PINBALL_FUNCTION void join(const VectorSum& other) {
    x += other.x;
    y += other.y;
    z += other.z;
  }
};

/// A list of forces on nodes is anything with
///
///     std::int64_t node(std::int64_t i) const            which node the i-th of them acts on
///     void find(const NodeArrays<S>&, std::int64_t i, S* force) const
///
/// for i below the length of the list. Three things are done with it: they are added to the forces of the nodes,
template <class S, class Forces>
struct AddForces {
  NodeArrays<S> nodes;
  Forces forces;

  PINBALL_FUNCTION void operator()(std::int64_t i) const {
    S force[3];
    forces.find(nodes, i, force);
    add_to_force(nodes, forces.node(i), force);
  }
};

/// their work is summed up, when all forces are known,
template <class S, class Forces>
struct WorkOfForces {
  NodeArrays<S> nodes;
  Forces forces;
  StepLengths step;

  PINBALL_FUNCTION void operator()(std::int64_t i, ExternalWork& sum) const {
    S force[3];
    forces.find(nodes, i, force);
    sum.join(work_on_node(nodes, forces.node(i), force, step));
  }
};

/// and so are they themselves.
template <class S, class Forces>
struct TotalOfForces {
  NodeArrays<S> nodes;
  Forces forces;

  PINBALL_FUNCTION void operator()(std::int64_t i, VectorSum& sum) const {
    S force[3];
    forces.find(nodes, i, force);
    sum.join({force[0], force[1], force[2]});
  }
};

}  // namespace pinball

#pragma once

#include <cstdint>

#include "../../kernels/record.hpp"
#include "../../kernels/tensor.hpp"

/// Records of four numbers, of nodes or of what else is numbered (kernels/gather.hpp).
namespace pinball {

/// The first three numbers of a record.
template <class S>
Vec3<S> vector_of(const S* record) {
  return {record[0], record[1], record[2]};
}

/// The same in double.
template <class S>
Vec3<double> double_vector_of(const S* record) {
  return {record[0], record[1], record[2]};
}

/// Writes a vector to a record, and zero behind it.
template <class S>
void put_vector(S* record, const Vec3<S>& v) {
  record[0] = v.x;
  record[1] = v.y;
  record[2] = v.z;
  record[3] = 0;
}

/// Arrays of records of nodes, each aligned to four numbers, and the records of node n in them.
template <class S>
struct NodeRecords {
  const S* position = nullptr;  ///< x, y, z, unused [length]
  const S* velocity = nullptr;  ///< at the middle of the last step, unused [length/time]
  S* force = nullptr;           ///< force, contact stiffness [force], [force/length]; stiffness zero between steps

  const S* x(std::int64_t n) const { return record(position, n); }
  const S* v(std::int64_t n) const { return record(velocity, n); }
  S* f(std::int64_t n) const { return record(force, n); }
};

}  // namespace pinball

#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pinball {

/// A face of an element that is seen for some time: none of its body's elements is on the other side then.
struct OuterFace {
  std::array<std::int32_t, 4> corners{};  ///< nodes, counterclockwise seen from outside
  std::int32_t element = 0;
  std::int32_t from = 0, until = 0;  ///< number of the first frame with it, and of the first without it again
};

/// Faces that bound a body in any of the frames, in the order of their elements. `body`: of each element. `ends`: of
/// each element the number of the first frame in which it is eroded; of those that never are the number of all frames.
/// What lies behind an element that is eroded is seen from then on. Bodies that share nodes hide nothing of each other.
/// Throws InputError as face_neighbours does.
std::vector<OuterFace> outer_faces(const std::vector<std::array<std::int32_t, 8>>& hexahedra,
                                   const std::vector<std::int32_t>& body, const std::vector<std::int32_t>& ends);

}  // namespace pinball

#include "outer_faces.hpp"

#include <solver/base/face_corners.hpp>
#include <solver/base/faces.hpp>

namespace pinball {

std::vector<OuterFace> outer_faces(const std::vector<std::array<std::int32_t, 8>>& hexahedra,
                                   const std::vector<std::int32_t>& body, const std::vector<std::int32_t>& ends) {
  const std::vector<std::array<std::int32_t, 6>> neighbours = face_neighbours(hexahedra);
  std::vector<OuterFace> faces;
  for (std::size_t element = 0; element < hexahedra.size(); ++element) {
    for (std::size_t face = 0; face < 6; ++face) {
      const std::int32_t beyond = neighbours[element][face];
      if (beyond == collapsed_face) continue;
      const bool covered = beyond >= 0 && body[beyond] == body[element];
      const std::int32_t from = covered ? ends[beyond] : 0, until = ends[element];
      if (from >= until) continue;
      faces.push_back({face_of(hexahedra[element], face), static_cast<std::int32_t>(element), from, until});
    }
  }
  return faces;
}

}  // namespace pinball

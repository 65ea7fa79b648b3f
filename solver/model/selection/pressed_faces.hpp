#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <solver/model/model.hpp>

namespace pinball {

/// A face of an element on which a pressure acts.
struct PressedFace {
  std::int64_t element = 0;
  std::array<std::int32_t, 4> corners{};  ///< nodes of the mesh, counterclockwise seen from outside the element
};

/// The faces that are listed, those of a set, or, where there is neither, the exposed faces all of whose corners are
/// selected; in the order of the elements. What else is selected by applies to the corners of a set's faces, too. Which
/// way round a file lists the corners of a face means nothing: pressure acts on the element. Throws InputError if there
/// is none, for a face of a set that no element has, and for one between two elements.
std::vector<PressedFace> pressed_faces(const ModelMesh& mesh, const std::vector<PlaneConstraint>& symmetry,
                                       const Pressure& pressure);

}  // namespace pinball

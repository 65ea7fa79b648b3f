#pragma once

#include <string>

#include <solver/model/model.hpp>

namespace pinball {

/// A body that can yield and has one layer of elements between sides that are free, as a sentence; empty: there is
/// none. Sides in planes of symmetry, or held against each other, are not free.
std::string find_thin_body(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball

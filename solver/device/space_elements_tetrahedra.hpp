#pragma once

#include <solver/elements/tetrahedron_features.hpp>

#include "space_elements.hpp"

/// Included by one source for each space.
namespace pinball {

template <class S, class Space>
ElementKernel<S> tetrahedron_kernel() {
  return update_elements<S, Space, tetrahedron_features>;
}

}  // namespace pinball

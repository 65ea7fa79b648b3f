#pragma once

#include "space_elements.hpp"

/// Included by one source for each precision and space: compiling it takes long.
namespace pinball {

template <class S, class Space>
ElementKernel<S> choose_linear_kernel(const ElementFeatures& features) {
  return choose_linear_features(UpdatesElementsIn<S, Space>{}, features);
}

}  // namespace pinball

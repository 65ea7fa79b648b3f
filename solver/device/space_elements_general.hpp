#pragma once

#include "space_elements.hpp"

/// Included by one source for each precision and space: compiling it takes long.
namespace pinball {

template <class S, class Space>
ElementKernel<S> choose_general_kernel(const ElementFeatures& features) {
  return choose_general_features(UpdatesElementsIn<S, Space>{}, features);
}

}  // namespace pinball

#pragma once

#include <solver/model/model.hpp>

#include "elements/element_parts.hpp"

namespace pinball {

/// Gives a model its parts with their constants and what their kernels need to know. Returns what the elements of all
/// of them need to store. Throws InputError where the precision cannot hold a material.
template <class S>
ElementStoreFeatures add_parts(Model<S>& model, const ElementParts& parts);

}  // namespace pinball

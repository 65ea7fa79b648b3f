#pragma once

#include <solver/model/model.hpp>

namespace pinball {

/// Throws InputError where a scene asks for something that this program was built without (PINBALL_WITHOUT).
/// with_boundary_conditions: whether anything acts on its nodes from outside.
template <class S>
void require_built(const Model<S>& model, bool with_boundary_conditions);

}  // namespace pinball

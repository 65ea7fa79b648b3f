#pragma once

#include <kernels/boundary/node_arrays.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// The arrays of a model, in the memory of the host.
template <class S>
NodeArrays<S> node_arrays(Model<S>& model) {
  NodeStore<S>& nodes = model.nodes;
  const bool mixed = is_mixed<S>(model.scene);
  return {nodes.position.data(),
          nodes.velocity.data(),
          nodes.force.data(),
          nodes.inverse_mass.data(),
          model.node_mass.data(),
          model.elements.mass.template data<S>(),
          mixed ? model.elements.mass.template data<float>() : nullptr};
}

}  // namespace pinball

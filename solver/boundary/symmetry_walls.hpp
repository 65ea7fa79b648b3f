#pragma once

#include <memory>
#include <vector>

#include <solver/model/model.hpp>

#include "space/boundary_kernels.hpp"

namespace pinball {

/// What erosion sets free may fly at a plane of symmetry: a mass point without elements, or a fragment. Its mirror
/// image comes from the other side at the same time, and the two bounce off each other. A node that would cross the
/// plane in the coming step has the normal part of its velocity turned, which keeps its energy and, with the image, all
/// momentum. Nodes in the plane itself are held by their constraints. In a scene without erosion there is nothing to
/// do.
template <class S>
class SymmetryWalls {
 public:
  SymmetryWalls(const Model<S>& model, const BoundaryKernels<S>& kernels);

  bool any() const { return !walls_.empty(); }
  /// To be called after the integration; position_step: the step just made with the present velocities [time].
  void reflect(const NodeArrays<S>& nodes, S position_step) const {
    for (const auto& wall : walls_) wall->reflect(nodes, position_step);
  }

  std::size_t bytes() const;

 private:
  std::vector<std::unique_ptr<ReflectionKernels<S>>> walls_;  ///< each with the nodes of its bodies that are not in it
};

}  // namespace pinball

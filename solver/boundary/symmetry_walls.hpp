#pragma once

#include <cstdint>
#include <vector>

#include <solver/model/model.hpp>

namespace pinball {

/// What erosion sets free may fly at a plane of symmetry: a mass point without elements, or a fragment. Its mirror
/// image comes from the other side at the same time, and the two bounce off each other. A node that would cross the
/// plane in the coming step has the normal part of its velocity turned, which keeps its energy and, with the image, all
/// momentum. Nodes in the plane itself are held by their constraints. In a scene without erosion there is nothing to
/// do.
template <class S>
class SymmetryWalls {
 public:
  explicit SymmetryWalls(const Model<S>& model);

  /// To be called after the integration; position_step: the step just made with the present velocities [time].
  void reflect(Model<S>& model, S position_step) const;

  std::size_t bytes() const;

 private:
  struct Wall {
    Point point, inward;              ///< inward: unit normal towards the bodies
    std::vector<std::int32_t> nodes;  ///< of the bodies that the plane belongs to, without those that lie in it
  };
  std::vector<Wall> walls_;
};

}  // namespace pinball

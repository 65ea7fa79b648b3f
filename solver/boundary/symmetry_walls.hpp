#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/model/model.hpp>
#include <solver/results.hpp>

#include "space/boundary_kernels.hpp"

namespace pinball {

/// What erosion sets free may fly at a plane of symmetry: a mass point without elements, or a fragment. Its mirror
/// image comes from the other side at the same time, and the two bounce off each other. A node that would cross the
/// plane in the coming step has the normal part of its velocity turned, which keeps its energy and, with the image, all
/// momentum. Nodes in the plane itself are held by their constraints. Bodies that reach through the plane, or lie on a
/// side on which it holds none, have no image there: it only holds others, and they pass. In a scene without erosion
/// there is nothing to do.
template <class S>
class SymmetryWalls {
 public:
  SymmetryWalls(const Model<S>& model, const BoundaryKernels<S>& kernels);

  bool any() const { return !walls_.empty(); }
  /// When the nodes have the forces of elements, and no others.
  void keep_forces(const NodeArrays<S>& nodes) {
    for (Wall& wall : walls_) {
      for (Side& side : wall.sides) side.nodes->keep_forces(nodes);
    }
  }
  /// To be called after the integration. ends_cycle: all elements are of one time then. Returns the work of the planes
  /// in the step before, which is done at the time of the forces [energy]. due: what was integrated.
  double reflect(const NodeArrays<S>& nodes, const StepLengths& step, bool ends_cycle, const DueSpans& due = {});

  /// Adds what the planes with a name have exerted, as a mean over the steps of the last cycle, to the forces by name.
  void add_forces(std::vector<ForceResult>& forces) const;
  void persist(StateArchive& archive);
  std::size_t bytes() const;

 private:
  struct Side {
    std::unique_ptr<ReflectionKernels<S>> nodes;  ///< of its bodies that are not in the plane
    double sign;                                  ///< of what it exerts along the wall's direction
  };
  struct Wall {
    std::vector<Side> sides;  ///< none: all bodies may pass
    std::string name;
    Point inward;
    double force = 0;  ///< sum over the steps of the cycle [force]
  };
  std::vector<Wall> walls_;
  std::int64_t steps_ = 0;  ///< of this cycle
  bool cycle_ends_ = true;
  double work_ = 0;  ///< in the last step [energy]
};

}  // namespace pinball

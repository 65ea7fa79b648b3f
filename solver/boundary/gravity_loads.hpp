#pragma once

#include <memory>
#include <vector>

#include <solver/model/mass_shares.hpp>
#include <solver/model/model.hpp>

#include "cycle_mean.hpp"
#include "named_forces.hpp"
#include "space/boundary_kernels.hpp"

namespace pinball {

/// Accelerations of all bodies, or of some ([[gravity]]): f = m g.
template <class S>
class GravityLoads {
 public:
  GravityLoads(const Model<S>& model, const BoundaryKernels<S>& kernels);

  /// Adds the forces to those of the nodes; time: of the forces; begins_cycle: the step is the first of its cycle.
  void apply(const NodeArrays<S>& nodes, double time, const StepLengths& step, bool begins_cycle);
  /// Whether it exerts forces on tied nodes: that on all bodies has their masses at the corners of their faces.
  bool loads_tied_nodes() const { return !of_bodies_.empty(); }
  /// Adds the work of the forces that apply() has added; to be called when all forces are known.
  void add_work(const NodeArrays<S>& nodes, const StepLengths& step, ExternalWork& sum) const;
  /// Adds the force of each acceleration that has a name, as apply() has added it: the mean over the steps of the
  /// cycle.
  void add_forces(const Model<S>& model, const NamedForces& named, std::vector<Point>& sums) const;
  std::size_t bytes() const;

 private:
  using Kernels = std::unique_ptr<NodeForceKernels<S>>;
  /// Of an acceleration.
  struct Factor {
    double now = 0;  ///< in this step
    CycleMean cycle{};

    void take(double factor, bool begins_cycle) {
      cycle.begin_step(begins_cycle, now);
      now = factor;
    }
    double mean() const { return cycle.with(now); }
  };
  /// A force on the part of each node's mass that is of some bodies.
  struct OfBodies {
    Gravity given;
    Factor factor;
    double mass = 0;  ///< of all parts
    Kernels forces;
  };
  static OfBodies of_bodies(const Model<S>& model, const Gravity& given, const BoundaryKernels<S>& kernels);

  std::vector<Gravity> of_all_;
  std::vector<Factor> factors_;  ///< of these
  Kernels forces_on_all_;        ///< of their sum; null: there are none
  std::vector<OfBodies> of_bodies_;
};

}  // namespace pinball

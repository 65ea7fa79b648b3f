#pragma once

#include "pair_forces.hpp"

namespace pinball {

/// The loops over pinballs by the threads of the host: packs of pinballs, of nodes and of pairs that touch, and forces
/// that leave tile by tile, colour after colour. They work on the arrays of the host themselves.
template <class S>
class HostPinballs final : public PinballKernels<S> {
 public:
  void take(const PinballArrays<S>& arrays) override { of_ = arrays; }
  void bring_back() override {}

  void update_geometry(const SurfaceNodes<S>& nodes, bool radii) override;
  bool any_strays(const SurfaceNodes<S>& nodes, S elapsed) override;
  bool any_grows(const SurfaceNodes<S>& nodes, S most) override;
  PairSums<S> find_forces(const PenaltyConstants<S>& constants, S dt) override;
  void add_forces(const SurfaceNodes<S>& nodes) override;
  S largest_row(const SurfaceNodes<S>& nodes) override;
  std::size_t bytes() const override { return pair_forces_.bytes(); }

  /// Of the last find_forces.
  const PairForces<S>& pair_forces() const { return pair_forces_; }

 private:
  PinballArrays<S> of_;
  PairForces<S> pair_forces_;
};

}  // namespace pinball

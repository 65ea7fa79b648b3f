#pragma once

#include <utility>

#include "held_nodes.hpp"
#include "node_forces.hpp"
#include "node_motion.hpp"
#include "pressure.hpp"
#include "walls.hpp"

namespace pinball {

/// BoundaryKernels of any execution space, from one source.
template <class S, class Space>
class SpaceBoundaryKernels final : public BoundaryKernels<S> {
 public:
  using Forces = std::unique_ptr<NodeForceKernels<S>>;

  /// place_of_slot: where the elements of the host's slots are in the arrays of the space; empty: they are the slots.
  /// sharing: of several ranks, which share the sums; null: one process has all.
  explicit SpaceBoundaryKernels(std::vector<std::int64_t> place_of_slot = {}, SharedNodes* sharing = nullptr)
      : place_of_slot_(std::move(place_of_slot)), sharing_(sharing) {}

  Forces load(const std::vector<std::int32_t>& nodes, const std::vector<S>& share) const override {
    return std::make_unique<SpaceSharedForces<S, Space, SharedForce<S>, S>>("loads", nodes, share, of_list(nodes));
  }
  Forces gravity(std::int32_t node_count) const override {
    return std::make_unique<SpaceNodeForces<S, Space, GravityForce<S>>>("gravity", node_count, GravityForce<S>{},
                                                                        of_all(node_count));
  }
  Forces gravity(const std::vector<std::int32_t>& nodes, const std::vector<double>& mass) const override {
    return std::make_unique<SpaceSharedForces<S, Space, PartGravityForce<S>, double>>("gravity", nodes, mass,
                                                                                      of_list(nodes));
  }
  Forces damping(std::int32_t node_count, double rate) const override {
    return std::make_unique<SpaceNodeForces<S, Space, DampingForce<S>>>("damping", node_count, DampingForce<S>{rate},
                                                                        of_all(node_count));
  }
  Forces given_forces(std::int32_t node_count, const S* forces) const override {
    return std::make_unique<SpaceGivenForces<S, Space>>(node_count, forces);
  }
  std::unique_ptr<HeldNodeKernels<S>> held_nodes() const override {
    return std::make_unique<SpaceHeldNodes<S, Space>>(sharing_);
  }
  std::unique_ptr<PressureKernels<S>> pressure(const FaceList& faces) const override {
    return std::make_unique<SpacePressure<S, Space>>(faces, place_of_slot_, sharing_);
  }
  std::unique_ptr<WallKernels<S>> wall(bool rubs) const override {
    return std::make_unique<SpaceWall<S, Space>>(rubs, sharing_);
  }
  std::unique_ptr<ReflectionKernels<S>> reflection(const std::vector<std::int32_t>& nodes,
                                                   const std::array<double, 3>& point,
                                                   const std::array<double, 3>& inward) const override {
    return std::make_unique<SpaceReflection<S, Space>>(nodes, point, inward, of_list(nodes));
  }
  std::unique_ptr<NodeMotionKernels<S>> motion(std::int32_t node_count) const override {
    return std::make_unique<SpaceNodeMotion<S, Space>>(node_count);
  }
  std::unique_ptr<NodeMotionKernels<S>> motion(const std::vector<std::int32_t>& nodes, const std::vector<double>& share,
                                               const std::vector<double>& mass) const override {
    return std::make_unique<SpaceNodeMotion<S, Space>>(nodes, share, mass, of_list(nodes));
  }

 private:
  SharedList of_list(const std::vector<std::int32_t>& nodes) const {
    return shared_list(sharing_, nodes.size(), [nodes](std::int64_t i) { return nodes[i]; });
  }
  SharedList of_all(std::int32_t node_count) const {
    return shared_list(sharing_, node_count, [](std::int64_t n) { return static_cast<std::int32_t>(n); });
  }

  std::vector<std::int64_t> place_of_slot_;
  SharedNodes* sharing_;
};

}  // namespace pinball

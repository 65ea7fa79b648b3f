#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <solver/elements/volume_groups.hpp>
#include <solver/model/model.hpp>
#include <solver/parallel/subdomain.hpp>

#include "device_layout.hpp"
#include "device_step.hpp"

namespace pinball {

/// What one of several ranks with a device each works on it, and what crosses to the others.
///
/// Sums over elements are cut into the pieces into which one device cuts them (parallel_reduce), and each piece is
/// summed up by one rank: it works all elements of the piece, also those that are another's, and holds their nodes. So
/// each energy has the bits that it has on one device.
template <class S>
class DeviceRanks {
 public:
  /// All have to stay where they are. device: that the layout is for.
  DeviceRanks(const Model<S>& model, const DeviceLayout<S>& layout, Device device, Subdomain<S>& domain);

  /// Says in the mesh who works what (TileWork), and what has averaged volumes.
  void mark(DeviceMesh<S>& mesh);
  /// Of each part, after mark().
  const std::vector<SomePieces<S>>& pieces() const { return pieces_; }

  /// Before elements are updated: which forces cross from then on.
  void connect(DeviceStep<S>& step);
  /// And volumes of elements around nodes of several ranks.
  void exchange_volumes(DeviceStep<S>& step) const;
  /// Afterwards: the forces of other ranks come to their corners.
  void exchange_forces(DeviceStep<S>& step) const;
  /// Over all ranks. own: of the elements that this one works.
  ElementTotals<S> share(const std::vector<SomePieces<S>>& pieces, const ElementTotals<S>& own);
  /// Per part, over all ranks.
  const std::vector<ElementTotals<S>>& totals_of_parts() const { return totals_of_parts_; }

  struct Resting {
    S time_step = 0;         ///< smallest stable step [time]
    std::int32_t tile = -1;  ///< that has it; -1: nothing rests
    std::int64_t elements = 0;
  };
  Resting share(const Resting& own) const;
  /// Moves the nodes of this rank.
  MotionEnergy integrate(DeviceStep<S>& step, const StepLengths& lengths) const;

 private:
  void mark_pieces(DeviceMesh<S>& mesh);
  void add_volumes(DeviceMesh<S>& mesh);
  std::int32_t adder_of_slot(std::int64_t slot) const;
  std::vector<ElementTotals<S>> joined(const std::vector<ElementTotals<S>>& of_pieces) const;

  const Model<S>& model_;
  const DeviceLayout<S>& layout_;
  int lanes_;  ///< elements that a thread of the device works at a time: one index of a sum
  Messages messages_;
  Subdomain<S>& domain_;
  std::vector<std::shared_ptr<const SharedBlocks>> blocks_;  ///< of each part: pieces of its sum
  std::vector<SomePieces<S>> pieces_;
  std::vector<std::int32_t> owner_;  ///< of the pieces of all parts, one after the other, and then each rank
  std::vector<ElementTotals<S>> totals_of_parts_;
  std::vector<VolumeNeighbour> volume_neighbours_;
  std::int64_t volumes_sent_by_all_ = 0;
  std::int64_t plan_ = 0;  ///< Subdomain::plans() that the device knows
};

}  // namespace pinball

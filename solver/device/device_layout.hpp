#pragma once

#include <cstdint>
#include <vector>

#include <solver/elements/nodal_volume_lists.hpp>
#include <solver/model/model.hpp>

#include "device_mesh.hpp"

namespace pinball {

/// Where the elements of a model lie on a device: in the order of the slots, part after part, each tile and part from
/// the beginning of a pack of the widest kind.
template <class S>
class DeviceLayout {
 public:
  explicit DeviceLayout(const Model<S>& model);

  /// All but what has averaged volumes, of which each rank has its part: lists_of_places().
  DeviceMesh<S> mesh(const Model<S>& model) const;
  /// by_slots: VolumeGroups::lists.
  NodalVolumeLists<S> lists_of_places(NodalVolumeLists<S> by_slots) const;
  /// Positions, velocities and the state of the elements.
  DeviceState<S> state(const Model<S>& model) const;
  void to_model(const DeviceState<S>& state, Model<S>& model) const;

  std::int64_t places() const { return std::ssize(slot_of_place_); }
  const std::vector<DevicePart<S>>& parts() const { return parts_; }  ///< of mesh()
  std::int64_t slot_of_place(std::int64_t place) const { return slot_of_place_[place]; }
  /// Bodies of the parts of mesh(): DevicePart::body.
  std::int32_t body_of_part(std::size_t part) const { return parts_[part].body; }
  /// Per slot; -1: padding.
  const std::vector<std::int64_t>& places_of_slots() const { return place_of_slot_; }
  /// Of no padding.
  std::int64_t place_of_slot(std::int64_t slot) const { return place_of_slot_[slot]; }

 private:
  void add_tile(const Model<S>& model, std::int32_t tile);
  template <class T>
  Array<T> rows_of(const Array<T>& packs, int components) const;
  template <class T>
  void rows_to(const Array<T>& rows, int components, Array<T>& packs) const;
  void repeat_last_element(Array<std::int32_t>& corner) const;
  void add_corners_of_nodes(const Model<S>& model, DeviceMesh<S>& mesh) const;

  std::vector<std::int64_t> slot_of_place_;  ///< -1: padding
  std::vector<std::int64_t> place_of_slot_;  ///< -1: padding
  std::vector<std::int32_t> tile_;           ///< per pack of the widest kind
  std::vector<DevicePart<S>> parts_;
};

}  // namespace pinball

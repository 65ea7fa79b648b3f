#pragma once

#include <cstdint>
#include <vector>

#include <kernels/exec/array.hpp>
#include <solver/contact/surface/surface.hpp>
#include <solver/contact/surface/surface_source.hpp>

#include "host_mesh.hpp"

namespace pinball {

/// The nodes and elements of a host as contact sees them. Elements lie in slots in the order of the host, the spheres
/// after them; each tile begins with a whole pack.
template <class S>
class HostSurface final : public SurfaceSource<S> {
 public:
  HostSurface(const pinball_contact_options& options, HostMesh<S> mesh, const pinball_contact_input& position);

  bool is_element(std::int64_t slot) const override {
    return slot >= 0 && slot < this->slots && element_of_slot_[slot] >= 0;
  }
  ContactElement element(std::int64_t slot) const override;
  bool may_soon_erode(std::int64_t slot) const override { return alive_at(slot) == 2; }
  void before_search() const override;
  /// What contact keeps; asks for what the host has given at creation alone, and takes the positions in.
  InitialSurface start(const pinball_contact_input& position, bool with_held);

  /// The slots that eroded since the last call of this, given the flags of now. Their neighbours, and those of elements
  /// that may soon erode, are watched from now on.
  std::vector<std::int64_t> update_alive(const pinball_contact_arrays& arrays, const Surface& surface);
  /// Takes in where the nodes are that contact looks at: in place where they lie in records, else gathered. listed: the
  /// nodes whose velocities are asked for unless there is a search, before which the others follow; null: all. Throws
  /// HostError for numbers that are not finite; so may a search for those that only it looks at.
  void gather_motion(const pinball_contact_arrays& arrays, const std::vector<std::int32_t>* listed);
  /// Takes in velocities, as constraints have left them, and forces of nodes that impulses look at. Throws as
  /// gather_motion does.
  void gather_impulse_nodes(const pinball_contact_arrays& arrays, const std::vector<std::int32_t>& nodes);
  /// Takes in the forces of nodes: in place where the host says so, else gathered.
  void gather_forces(const pinball_contact_arrays& arrays, const std::vector<std::int32_t>& nodes);
  /// Puts back what gather_forces has gathered.
  void scatter_forces(const pinball_contact_arrays& arrays, const std::vector<std::int32_t>& nodes);

 private:
  void cut_tiles();
  void watch(std::int64_t slot);
  std::uint8_t alive_at(std::int64_t slot) const;
  /// The records of nodes: those of the host, or `records`, into which they are copied.
  const S* gather(const pinball_contact_input& from, Array<S>& records, const std::vector<std::int32_t>& nodes,
                  const char* name) const;
  HostMesh<S> mesh_;
  std::vector<std::int32_t> element_of_slot_;  ///< -1 for padding
  std::vector<std::int32_t> slot_of_element_;
  std::vector<std::int64_t> packs_;  ///< SurfaceSource::tile_packs
  Colouring colours_;
  Array<S> inverse_;                   ///< SurfaceSource::inverse_mass
  std::vector<S> reference_;           ///< undeformed places, three numbers per node [length]
  std::vector<double> mass_;           ///< of the spheres, and of the elements where the host does not give it [mass]
  std::int32_t masses_from_ = 0;       ///< first element whose mass is in it
  std::vector<std::int32_t> watched_;  ///< nodes that contact may look at, ascending
  std::vector<std::uint8_t> is_watched_;
  std::vector<std::uint8_t> alive_before_;                         ///< per element and sphere
  const std::uint8_t *alive_ = nullptr, *sphere_alive_ = nullptr;  ///< of the host, during a call
  const pinball_contact_arrays* waiting_ = nullptr;  ///< during update: has motion that was not taken in yet
  Array<S> positions_, forces_;                      ///< records, only where the host's are not
  mutable Array<S> velocities_;                      ///< the same; before_search completes it
};

}  // namespace pinball

#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/contact/algorithm/contact_algorithm.hpp>
#include <solver/contact/search/surface_motion.hpp>
#include <solver/contact/spheres/sphere_springs.hpp>
#include <solver/contact/surface/surface.hpp>

#include "host_pinballs.hpp"
#include "pair_list.hpp"
#include "pinball_store.hpp"
#include "surface_pinballs.hpp"

namespace pinball {

/// The pinball algorithm (report section 3 and figure 3).
template <class S>
class PinballAlgorithm final : public ContactAlgorithm<S> {
 public:
  PinballAlgorithm(const ContactSettings& settings, const SurfaceSource<S>& source, InitialSurface start);

  /// Figure 3, 1-3: takes eroded elements out, brings centres, velocities and normals up to date.
  void update_surface(const SurfaceSource<S>& source, const std::vector<std::int64_t>& eroded) override;
  /// Springs between balls alone, and no sums for pairs of the scene.
  bool work_with(std::unique_ptr<PinballKernels<S>>& kernels) override;
  /// Figure 3, 4: the pairs that may touch, unless the list still holds.
  void search(const SurfaceSource<S>& source, double dt) override;

  const char* name() const override { return "pinball"; }
  void add_node_forces(std::span<Point> node_force) const override;
  void put_radii(const SurfaceSource<S>& source, std::vector<double>& slot_radius) const override;
  const Surface& surface() const override { return surface_; }
  ListSize listed() const override {
    const std::int64_t of_spheres = on_faces_ ? on_faces_->listed_pairs() : 0;
    return {list_.size(), list_.pairs() + of_spheres, list_.places() + of_spheres};
  }
  const std::vector<std::int32_t>* listed_nodes() const override { return &node_; }
  std::vector<std::int32_t> nodes() const override { return {motion_.nodes().begin(), motion_.nodes().end()}; }
  void persist(StateArchive& archive, const SurfaceSource<S>& source) override;
  std::size_t bytes() const override;

 private:
  /// Figure 3, 5-6: penetrating pairs and their penalty forces, one sum per pinball.
  ContactWork spring_forces(const SurfaceSource<S>& source, S dt) override;
  /// Adds an eighth of each pinball's force to the corners of its element, and bounds the contact frequency.
  void add_spring_forces(const SurfaceSource<S>& source, ContactWork& work) override;
  const std::vector<std::int32_t>& nodes_of_springs() override { return node_; }
  void collect_impulses(const SurfaceSource<S>& source, double dt) override;
  void add_pair_forces_of_springs(std::vector<Point>& sums) const override;
  /// Whether the list still has every pair that may touch.
  bool list_holds(const SurfaceSource<S>& source) const;
  /// Builds the list for a time to come, and the store of the pinballs that are in it.
  void build_list(const SurfaceSource<S>& source);
  void collect_listed(const SurfaceSource<S>& source);
  /// Gives the kernels the lists, and what they remember, as they are now.
  void give_lists(const SurfaceSource<S>& source);
  void list_nodes(std::int32_t node_count);
  /// Exposed faces of the listed pinballs, and which of them take part.
  void update_exposure();
  /// Centres, velocities, normals and (on demand) radii of the listed pinballs.
  void update_geometry(const SurfaceSource<S>& source);
  /// Has the motion of the nodes of all pinballs watched.
  void watch_nodes(const SurfaceSource<S>& source);

  /// Null: no spheres, or their balls meet those of elements. Hosts alone have spheres, and they keep no state.
  std::unique_ptr<SphereSprings<S>> on_faces_;
  Surface surface_;
  std::vector<std::uint8_t> faces_at_start_;  ///< per slot: those that are exposed before anything erodes, a bit each
  JoinedBodies joined_;
  std::vector<std::int32_t> uncovered_;  ///< slots, by erosion since the pinballs of the surface were chosen
  SurfacePinballs<S> all_;
  SurfacePinballs<S> all_before_;  ///< kept for its memory
  SurfaceMotion<S> motion_;
  MovingBalls<S> balls_;  ///< one for each of all pinballs
  PairList<S> list_;
  PinballStore<S> pinballs_;             ///< those in the list
  std::vector<std::int32_t> node_;       ///< corners of the listed pinballs, from the lowest up
  std::vector<std::uint8_t> is_listed_;  ///< per node of the store: among these
  Colouring tile_colours_;               ///< of the source, when lists were given
  HostPinballs<S> host_kernels_;
  std::unique_ptr<PinballKernels<S>> device_kernels_;  ///< in place of these
  PinballKernels<S>* kernels_ = &host_kernels_;        ///< one of both
  std::vector<S> radius_;  ///< of all pinballs, when the list was built; only where radii change [length]
  PenaltyConstants<S> penalty_;
  bool list_valid_ = false;
  bool surface_changed_ = false;  ///< since the pinballs of the surface were chosen
  ListClock<S> clock_;
  double lost_energy_ = 0;   ///< of springs whose pinball eroded in this step
  double ended_energy_ = 0;  ///< of springs whose pair may no longer touch
};

}  // namespace pinball

#pragma once

#include <array>
#include <cstdint>
#include <pinball/solver/contact.hpp>
#include <pinball/solver/neighbour_list.hpp>
#include <pinball/solver/pinball_store.hpp>
#include <pinball/solver/surface.hpp>
#include <vector>

namespace pinball {

/// The pinball algorithm (report section 3 and figure 3).
template <class S>
class PinballContact final : public Contact<S> {
 public:
  explicit PinballContact(const Model<S>& model);

  /// Figure 3, 1-3: takes eroded elements out, brings centres, velocities and normals up to date.
  void update_surface(const Model<S>& model, const std::vector<TileResult<S>>& tiles) override;
  /// Figure 3, 4: cells and neighbour lists, unless the lists still hold.
  void search(const Model<S>& model) override;
  /// Figure 3, 5-6: penetrating pairs and their penalty forces, one sum per pinball.
  ContactResult forces(const Model<S>& model, S dt) override;
  /// Adds an eighth of each pinball's force to the corners of its element, and bounds the contact frequency.
  void scatter(Model<S>& model, ContactResult& result) override;
  void prepare_impulses(const Model<S>& model, double dt) override;

  const char* name() const override { return "pinball"; }
  void report(const Model<S>& model, std::vector<Point>& node_force, std::vector<double>& slot_radius) const override;
  std::int32_t surface_elements() const override { return active_; }
  ListSize listed() const override { return {2 * list_.pairs(), list_.places()}; }
  std::size_t bytes() const override;

 private:
  /// Chooses the pinballs anew: exposed elements, and those across a face of one.
  void collect_pinballs(const Model<S>& model);
  /// Exposed faces of the chosen pinballs, and which of them take part.
  void update_exposure();
  /// Centres, velocities, normals and (on demand) radii.
  void update_geometry(const Model<S>& model);

  Surface surface_;
  PinballStore<S> pinballs_;
  NeighbourList<S> list_;
  std::vector<std::array<float, 3>> reference_centre_;  ///< per slot
  std::vector<std::uint8_t> is_pinball_;                ///< per slot
  PenaltyConstants<S> penalty_;
  bool may_erode_ = false;
  bool surface_changed_ = false;  ///< since the pinballs were chosen
  std::int32_t active_ = 0;       ///< pinballs that take part
  double lost_energy_ = 0;        ///< of springs whose pinball eroded in this step
};

}  // namespace pinball

#pragma once

#include <cstdint>
#include <memory>
#include <pinball/solver/contact_impulses.hpp>
#include <pinball/solver/internal_forces.hpp>
#include <pinball/solver/model.hpp>
#include <pinball/solver/neighbour_list.hpp>
#include <pinball/solver/pinball_store.hpp>
#include <pinball/solver/surface.hpp>
#include <vector>

namespace pinball {

/// Result of the contact stage of one step.
struct ContactResult {
  double stored = 0;             ///< energy in the penalty springs [energy]
  double eroded = 0;             ///< energy of the springs that went with eroded elements [energy]
  double damped_power = 0;       ///< power of the contact damping [power]
  double dissipated = 0;         ///< energy taken out by impulses since the step before [energy]
  double penetration_ratio = 0;  ///< largest g / (R1 + R2) [-]
  std::int64_t pairs = 0;        ///< pairs in contact
  double frequency2 = 0;         ///< bound on the square of the contact frequency [1/time^2]
};

/// The pinball algorithm (report section 3 and figure 3); its stages are called one by one by the step.
template <class S>
class PinballContact {
 public:
  explicit PinballContact(const Model<S>& model);

  /// Figure 3, 1-3: takes eroded elements out, brings centres, velocities and normals up to date.
  void update_pinballs(const Model<S>& model, const std::vector<TileResult<S>>& tiles);
  /// Figure 3, 4: cells and neighbour lists, unless the lists still hold.
  void search(const Model<S>& model);
  /// Figure 3, 5-6: penetrating pairs and their penalty forces, one sum per pinball; dt: the step just made.
  ContactResult forces(S dt);
  /// Adds an eighth of each pinball's force to the corners of its element, and bounds the contact frequency.
  void scatter(Model<S>& model, ContactResult& result);

  /// Whether contact acts through springs, with forces() and scatter(), or through impulses.
  bool by_impulses() const { return impulses_ != nullptr; }
  /// The constraints of the coming step, in the place of forces() and scatter(); dt: the step just made.
  void prepare_impulses(const Model<S>& model, double dt);
  /// Forces on the nodes that keep gaps from closing in the coming step; after all other forces and the constraints.
  ContactResult impulses(Model<S>& model, const StepLengths& step);

  const PinballStore<S>& pinballs() const { return pinballs_; }
  std::int32_t active_pinballs() const { return active_; }
  std::int64_t searches() const { return searches_; }
  std::int64_t searches_skipped() const { return searches_skipped_; }
  std::size_t bytes() const {
    return pinballs_.bytes() + list_.bytes() + surface_.bytes() + (impulses_ ? impulses_->bytes() : 0);
  }

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
  std::unique_ptr<ContactImpulses<S>> impulses_;        ///< only with enforcement by impulses
  std::vector<std::array<float, 3>> reference_centre_;  ///< per slot
  std::vector<std::uint8_t> is_pinball_;                ///< per slot
  PenaltyConstants<S> penalty_;
  double damping_factor_ = 1;  ///< of the squared contact frequency, for its damping
  bool may_erode_ = false;
  bool surface_changed_ = false;  ///< since the pinballs were chosen
  std::int32_t active_ = 0;       ///< pinballs that take part
  double lost_energy_ = 0;        ///< of springs whose pinball eroded in this step
  std::int64_t searches_ = 0, searches_skipped_ = 0;
};

}  // namespace pinball

#pragma once

#include <cstdint>
#include <memory>
#include <pinball/contact/contact.hpp>
#include <pinball/contact/contact_model.hpp>
#include <pinball/solver/model.hpp>
#include <pinball/solver/tile_kernels.hpp>
#include <vector>

namespace pinball {

/// A model as contact sees it: nothing is copied. It is cheap to make, and good until the model moves in memory.
template <class S>
class ModelContact final : public ContactModel<S> {
 public:
  explicit ModelContact(Model<S>& model) : ModelContact(model, model.nodes.force.data()) {}
  /// For who adds no forces.
  explicit ModelContact(const Model<S>& model) : ModelContact(model, nullptr) {}

  ContactElement element(std::int64_t slot) const override;
  bool may_soon_erode(std::int64_t slot) const override;

 private:
  ModelContact(const Model<S>& model, S* node_force);

  const Model<S>& model_;
};

/// The directions in which constraints and prescribed velocities hold the nodes.
template <class S>
HeldDirections held_directions(const Model<S>& model);

template <class S>
SurfaceTopology surface_topology(const Model<S>& model);

/// Slots of tiles in which elements have eroded in the last step: those that are padding or no longer have a mass,
/// ascending.
template <class S>
std::vector<std::int64_t> eroded_slots(const Model<S>& model, const std::vector<TileResult<S>>& tiles);

/// The contact that the scene names; nothing for a scene without contact.
template <class S>
std::unique_ptr<Contact<S>> make_model_contact(const Model<S>& model);

}  // namespace pinball

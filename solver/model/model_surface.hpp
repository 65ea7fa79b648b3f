#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <solver/contact/algorithm/contact_algorithm.hpp>
#include <solver/contact/surface/surface_source.hpp>

#include "model.hpp"

namespace pinball {

/// A model as contact sees it: nothing is copied. It is cheap to make, and good until the model moves in memory.
template <class S>
class ModelSurface final : public SurfaceSource<S> {
 public:
  explicit ModelSurface(Model<S>& model) : ModelSurface(model, model.nodes.force.data()) {}
  /// For who adds no forces.
  explicit ModelSurface(const Model<S>& model) : ModelSurface(model, nullptr) {}

  bool is_element(std::int64_t slot) const override { return slot >= 0 && model_.may_be_place(slot); }
  ContactElement element(std::int64_t slot) const override;
  bool may_soon_erode(std::int64_t slot) const override;

 private:
  ModelSurface(const Model<S>& model, S* node_force);

  const Model<S>& model_;
};

/// The directions in which constraints and prescribed velocities hold the nodes.
template <class S>
HeldDirections held_directions(const Model<S>& model);

template <class S>
SurfaceTopology surface_topology(const Model<S>& model);

/// The contact that the scene names; nothing for a scene without contact.
template <class S>
std::unique_ptr<ContactAlgorithm<S>> make_model_contact(const Model<S>& model);

}  // namespace pinball

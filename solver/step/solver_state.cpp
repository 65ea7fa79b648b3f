#include <solver/results/state_hash.hpp>

#include "solver.hpp"

namespace pinball {

namespace {

template <class S>
void persist_stores(StateArchive& archive, Model<S>& model) {
  archive.of_fixed_size(model.nodes.position);
  archive.of_fixed_size(model.nodes.velocity);  // forces are zero between steps
  ElementStore<S>& elements = model.elements;
  for (AlignedArray<S>* array : {&elements.mass, &elements.stress, &elements.plastic_strain, &elements.hourglass_force,
                                 &elements.viscous_stress, &elements.internal_energy}) {
    archive.of_fixed_size(*array);
  }
}

}  // namespace

template <class S>
void Solver<S>::persist(StateArchive& archive) {
  persist_stores(archive, model_);
  internal_forces_.persist(archive, model_);
  boundary_.persist(archive);
  if (contact_) contact_->persist(archive, ModelSurface<S>(model_));
  if (subcycling_) subcycling_->persist(archive, model_);
  timers_.persist(archive);
  archive(time_, force_time_, dt_, dt_before_, steps_, energies_, damped_power_, initial_energy_, external_max_,
          initial_momentum_, eroded_elements_, counts_, balance_error_max_, penetration_ratio_max_, contact_frequency2_,
          pairs_, pairs_max_, dt_min_, dt_max_, dt_limited_by_);
}

template <class S>
std::uint64_t Solver<S>::fingerprint() const {
  StateHash hash;
  const auto add = [&hash](const auto& array) { hash.add(array.data(), array.size() * sizeof(array[0])); };
  add(model_.elements.corner);
  add(model_.nodes.inverse_mass);
  add(model_.node_mass);
  add(model_.element_mass);
  add(model_.element_of_slot);
  add(model_.tile_packs);
  add(model_.tile_part);
  add(model_.tile_colours.items);
  return hash.value();
}

template class Solver<double>;
template class Solver<float>;

}  // namespace pinball

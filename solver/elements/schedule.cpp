#include "schedule.hpp"

#include <algorithm>
#include <cmath>

#include <solver/base/built_features.hpp>

namespace pinball {

template <class S>
Schedule<S>::Schedule(const Model<S>& model, Subdomain<S>* domain) : domain_(domain) {
  if (model.tile_levels.empty()) return;
  const bool erodes = !model.elements.internal_energy.empty();
  subcycling_.emplace(model, erodes || model.scene.damping.mass > 0 || !model.scene.gravities.empty(), domain);
}

template <class S>
void Schedule<S>::begin_step(const Model<S>& model, const Due& due, const std::vector<TileResult<S>>& results) {
  if (subcycling_) {
    if (due.all() && !due.first && !due.last) subcycling_->plan(results, contact_frequency2_);
  } else if (!resting_) {
    awake_ = deformable(model);
  } else if (resting_->wake(model.nodes)) {
    choose_awake(model);
  }
}

template <class S>
std::int64_t Schedule<S>::end_work(const Model<S>& model) {
  if (!built::resting || subcycling_) return 0;
  const std::int64_t left_out = resting_ && model.scene.skip.resting ? resting_->elements() : 0;
  if (!resting_) find_resting(model);
  return left_out;
}

template <class S>
void Schedule<S>::find_resting(const Model<S>& model) {
  resting_.emplace(model, domain_);
  choose_awake(model);
}

template <class S>
void Schedule<S>::set_resting(const Model<S>& model, const std::vector<std::uint8_t>& rests) {
  resting_.emplace(model, rests, domain_);
  choose_awake(model);
}

/// Frequencies of elements and of contact add in squares: w^2 <= w_elements^2 + w_contact^2.
template <class S>
StepBound Schedule<S>::bound(const Model<S>& model, const Due& due, const std::vector<TileResult<S>>& results,
                             double element_step, std::int64_t slot, double contact_frequency2) {
  contact_frequency2_ = std::max(due.all() ? 0.0 : contact_frequency2_, contact_frequency2);
  if (!due.all() || due.last) return {};
  const double element_frequency2 = 4.0 / (element_step * element_step);
  StepBound bound{2.0 / std::sqrt(element_frequency2 + contact_frequency2), slot,
                  contact_frequency2 > element_frequency2};
  if (subcycling_) {
    subcycling_->begin_cycle(model);
    const auto of_cycle = subcycling_->stable_step(results, contact_frequency2);
    bound.stable = of_cycle.step;
    bound.slot = of_cycle.slot;
    bound.cycle_steps = subcycling_->cycle_steps();
  }
  return bound;
}

/// The tiles of model.tile_colours without those of rigid bodies, colours in the same order.
template <class S>
Colouring Schedule<S>::deformable(const Model<S>& model) const {
  if (model.rigid.empty() && domain_ == nullptr) return model.tile_colours;
  return chosen_of(model.tile_colours, [&](std::int32_t tile) { return !model.is_rigid(tile) && works(tile); });
}

/// The same without those that are to be skipped.
template <class S>
void Schedule<S>::choose_awake(const Model<S>& model) {
  awake_ = chosen_of(model.tile_colours, [&](std::int32_t tile) {
    return works(tile) && !model.is_rigid(tile) && (!model.scene.skip.resting || !resting_->rests(tile));
  });
}

template <class S>
void Schedule<S>::persist(StateArchive& archive, const Model<S>& model) {
  archive(contact_frequency2_);
  if (subcycling_) {
    subcycling_->persist(archive, model);
    return;
  }
  std::vector<std::uint8_t> rests;
  if (resting_) rests = resting_->flags();
  archive(rests);  // empty: not known
  if (!archive.reads()) return;
  resting_.reset();
  if (rests.empty()) return;
  if (rests.size() != model.tile_part.size()) StateArchive::throw_foreign();
  set_resting(model, rests);
}

template <class S>
std::size_t Schedule<S>::bytes() const {
  return (subcycling_ ? subcycling_->bytes() : 0) + (resting_ ? resting_->bytes() : 0) +
         (awake_.items.capacity() + awake_.colour_offsets.capacity()) * sizeof(std::int32_t);
}

template class Schedule<double>;
template class Schedule<float>;

}  // namespace pinball

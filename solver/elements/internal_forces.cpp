#include "internal_forces.hpp"

#include <algorithm>
#include <limits>

#include <kernels/exec.hpp>
#include <solver/base/built_features.hpp>
#include <solver/base/lists_in_order.hpp>

namespace pinball {

template <class S>
InternalForces<S>::InternalForces(const Model<S>& model, Subdomain<S>* domain)
    : domain_(domain), results_(model.tile_count()), volumes_(model, domain) {
  const bool mixed = is_mixed<S>(model.scene);
  for (const Part& part : model.parts) {
    kernel_of_part_.push_back(part.rigid || mixed ? nullptr : choose_tile_kernel<S, S>(part.features));
    mixed_kernel_of_part_.push_back(part.rigid || !mixed ? nullptr : choose_tile_kernel<float, S>(part.features));
  }
  for (std::int32_t tile = 0; tile < model.tile_count(); ++tile) {
    if (model.is_rigid(tile)) results_[tile].time_step = std::numeric_limits<S>::infinity();  // and is never worked
  }
}

namespace {

/// body(tile) for the tiles of one colour side by side, the colours one after the other.
template <class Body>
void for_each_tile(const Colouring& tiles, const Body& body) {
  parallel_for_coloured("internal forces", DefaultExecutionSpace{}, tiles.colour_offsets.data(),
                        static_cast<std::int32_t>(tiles.colour_offsets.size()) - 1, tiles.items.data(), body);
}

}  // namespace

template <class S>
void InternalForces<S>::work(Model<S>& model, std::int32_t tile, const ElementStep<S>& step) {
  const std::int32_t part = model.tile_part[tile];
  if (mixed_kernel_of_part_[part] != nullptr) {
    work_in<float>(model, tile, step, mixed_kernel_of_part_[part]);
  } else {
    work_in<S>(model, tile, step, kernel_of_part_[part]);
  }
}

/// E: precision of the elements.
template <class S>
template <class E>
void InternalForces<S>::work_in(Model<S>& model, std::int32_t tile, const ElementStep<S>& step,
                                TileKernel<E, S> kernel) {
  ElementView<E> elements = model.elements.template view<E>();
  if (domain_) elements.corner = domain_->corner();
  kernel({elements,
          model.nodes.view(),
          model.template constants_in<E>()[model.tile_part[tile]],
          {static_cast<E>(step.length), static_cast<E>(step.weight), static_cast<E>(step.time)},
          model.tile_packs[tile],
          model.tile_packs[tile + 1]},
         results_[tile]);
}

template <class S>
InternalForceResult<S> InternalForces<S>::compute(Model<S>& model, Schedule<S>& schedule, const Due& due,
                                                  const ElementStep<S>& smallest) {
  schedule.begin_step(model, due, results_);
  const bool skips_resting = schedule.resting() != nullptr && model.scene.skip.resting;
  for (TileResult<S>& result : results_)
    result = {.folding = result.folding,
              .time_step = result.time_step,
              .time_step_slot = result.time_step_slot,
              .inside_out_count = result.inside_out_count};
  volumes_.average(model);
  const int highest = schedule.highest_level(due);
  for (int level = highest; level >= 0; --level) {
    schedule.show_mean_velocities(model.nodes, level);
    if (domain_) domain_->spread(model.nodes, level);
    for_each_tile(schedule.tiles(level), [&](std::int32_t tile) {
      TileResult<S>& result = results_[tile];
      const TileResult<S> before = result;
      work(model, tile, schedule.step_of(tile, due, smallest));
      if (!built::resting || !schedule.rests(tile)) return;
      result.time_step = before.time_step;
      result.time_step_slot = before.time_step_slot;
    });
    schedule.show_present_velocities(model.nodes, level);
  }
  std::int64_t resting = schedule.end_work(model);
  if (domain_) {
    domain_->collect(model.nodes, highest);
    resting = share_results(schedule, due, skips_resting);
    share_eroded(model);
  }
  InternalForceResult<S> result = sum();
  result.resting_elements = resting;
  result.subcycled_elements = schedule.count_elements(due, results_);
  return result;
}

/// Makes the results of all tiles that were due known to all ranks. skips_resting: in this step. Returns the elements
/// that were left out because they rest.
template <class S>
std::int64_t InternalForces<S>::share_results(Schedule<S>& schedule, const Due& due, bool skips_resting) {
  struct Report {
    TileResult<S> result;
    std::int64_t left_out, rests;
  };
  std::vector<std::int32_t> tiles, owner;
  std::vector<Report> reports;
  for (std::int32_t t = 0; t < std::ssize(results_); ++t) {
    if (!schedule.is_due(t, due)) continue;
    const bool rests = schedule.rests(t);
    tiles.push_back(t);
    owner.push_back(domain_->rank_of_tile(t));
    reports.push_back({results_[t], skips_resting && rests ? domain_->elements_of_tile(t) : 0, rests ? 1 : 0});
  }
  domain_->share(owner, reports.data());
  std::int64_t left_out = 0;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    results_[tiles[i]] = reports[i].result;
    left_out += reports[i].left_out;
    if (!domain_->works(tiles[i])) schedule.set_other_resting(tiles[i], reports[i].rests != 0);
  }
  return left_out;
}

template <class S>
void InternalForces<S>::share_time_steps(Subdomain<S>& domain) {
  domain.share_tiles(results_.data());
}

template <class S>
void InternalForces<S>::share_eroded(Model<S>& model) {
  std::vector<std::int64_t> of_tile;
  for (const TileResult<S>& result : results_) of_tile.push_back(result.eroded_count);
  if (std::ranges::any_of(of_tile, [](std::int64_t count) { return count > 0; })) domain_->share_eroded(model, of_tile);
}

template <class S>
InternalForceResult<S> InternalForces<S>::sum() const {
  InternalForceResult<S> sum;
  sum.time_step = std::numeric_limits<S>::infinity();
  for (const TileResult<S>& r : results_) {
    sum.internal += r.internal;
    sum.hourglass += r.hourglass;
    sum.viscous += r.viscous;
    sum.eroded += r.eroded;
    sum.hourglass_plastic += r.hourglass_plastic;
    sum.folding += r.folding;
    sum.eroded_count += r.eroded_count;
    sum.inverted_count += r.inverted_count;
    sum.inside_out_count += r.inside_out_count;
    if (r.time_step < sum.time_step) {
      sum.time_step = r.time_step;
      sum.time_step_slot = r.time_step_slot;
    }
  }
  return sum;
}

template <class S>
std::vector<std::int64_t> eroded_slots(const Model<S>& model, const std::vector<TileResult<S>>& tiles) {
  if (std::ranges::all_of(tiles, [](const TileResult<S>& tile) { return tile.eroded_count == 0; })) return {};
  const std::int64_t all = std::ssize(tiles);
  const auto for_each_eroded = [&](std::int64_t tile, const auto& visit) {
    if (tiles[tile].eroded_count == 0) return;
    for (const std::int64_t slot : model.slots_of(tile)) {
      if (!model.elements.alive(slot)) visit(slot);
    }
  };
  std::vector<std::int64_t> first(tiles.size()), slots;
  for_all_of("counts of eroded elements", all, model.elements.slots,
             [&](std::int64_t tile) { for_each_eroded(tile, [&](std::int64_t) { ++first[tile]; }); });
  slots.resize(make_offsets(first));
  for_all_of("eroded elements", all, model.elements.slots, [&](std::int64_t tile) {
    std::int64_t next = first[tile];
    for_each_eroded(tile, [&](std::int64_t slot) { slots[next++] = slot; });
  });
  return slots;
}

template <class S>
void InternalForces<S>::persist(StateArchive& archive, const Model<S>& model) {
  archive.of_fixed_size(results_);
  for (const TileResult<S>& tile : results_) archive.require(model.may_be_place(tile.time_step_slot));
}

template class InternalForces<double>;
template class InternalForces<float>;
template std::vector<std::int64_t> eroded_slots(const Model<double>&, const std::vector<TileResult<double>>&);
template std::vector<std::int64_t> eroded_slots(const Model<float>&, const std::vector<TileResult<float>>&);

}  // namespace pinball

#include "subcycling.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <kernels/exec.hpp>

namespace pinball {

namespace {

/// What a smallest step costs besides its elements, if all nodes are integrated, in element steps per element.
constexpr double cost_of_nodes = 0.1;

constexpr int longest_plan = 50;  // cycles

}  // namespace

template <class S>
Subcycling<S>::Subcycling(const Model<S>& model, bool every_node, Subdomain<S>* domain)
    : every_node_(every_node), domain_(domain) {
  for (const TileLevels& t : model.tile_levels) {
    highest_.push_back(t.highest);
    own_.push_back(t.own);
  }
  elements_.assign(highest_.size(), 0);
  for (std::size_t t = 0; t < elements_.size(); ++t) {
    const auto slot = model.element_of_slot.begin() + model.tile_packs[t] * model.elements.width;
    const auto end = model.element_of_slot.begin() + model.tile_packs[t + 1] * model.elements.width;
    elements_[t] = end - slot - std::count(slot, end, -1);
  }
  find_neighbours(model);
  next_level_ = highest_;
  begin_cycle(model);
  if (domain_ != nullptr) domain_->keep_with_state([this] { share_mixed_nodes(); });
}

template <class S>
void Subcycling<S>::find_neighbours(const Model<S>& model) {
  const std::size_t nodes = model.nodes.count;
  std::vector<std::int32_t> last(nodes, -1);
  const auto for_each_node_of_tile = [&](const auto& visit) {
    std::fill(last.begin(), last.end(), -1);
    for (std::int32_t t = 0; t < model.tile_count(); ++t) {
      const std::size_t tile = t;
      const std::int64_t corners = 8 * model.elements.width;
      for (std::int64_t i = corners * model.tile_packs[tile]; i < corners * model.tile_packs[tile + 1]; ++i) {
        const std::size_t node = model.elements.corner[i];
        if (last[node] == t) continue;
        last[node] = t;
        visit(node, t);
      }
    }
  };
  tile_of_node_offsets_.assign(nodes + 1, 0);
  for_each_node_of_tile([&](std::size_t node, std::int32_t) { ++tile_of_node_offsets_[node + 1]; });
  for (std::size_t n = 0; n < nodes; ++n) tile_of_node_offsets_[n + 1] += tile_of_node_offsets_[n];
  tile_of_node_.resize(tile_of_node_offsets_.back());
  std::vector<std::int32_t> place(tile_of_node_offsets_.begin(), tile_of_node_offsets_.end() - 1);
  neighbours_.resize(highest_.size());
  for_each_node_of_tile([&](std::size_t node, std::int32_t tile) {
    for (std::int32_t i = tile_of_node_offsets_[node]; i < place[node]; ++i) {
      std::vector<std::int32_t>& others = neighbours_[tile];
      const std::int32_t other = tile_of_node_[i];
      if (std::find(others.begin(), others.end(), other) != others.end()) continue;
      others.push_back(other);
      neighbours_[other].push_back(tile);
    }
    tile_of_node_[place[node]++] = tile;
  });
}

/// Contact adds to the frequencies of the elements on whose nodes it acts: w^2 <= w_element^2 + w_contact^2.
template <class S>
std::vector<StepGroup> Subcycling<S>::groups(const std::vector<TileResult<S>>& tiles, double contact_frequency2) const {
  std::vector<StepGroup> groups(tiles.size());
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    const double step = tiles[t].time_step;
    const double frequency2 = 4 / (step * step);
    const double contact2 = highest_[t] == 0 ? contact_frequency2 : 0;  // its nodes are on no other level
    groups[t] = {elements_[t] > 0 ? 2 / std::sqrt(frequency2 + contact2) : std::numeric_limits<double>::infinity(),
                 static_cast<double>(elements_[t]), highest_[t]};
  }
  return groups;
}

/// A tile that has come far below the level of its own elements, because they are squeezed, has no layer around it: its
/// neighbours are that.
template <class S>
void Subcycling<S>::lower_beside_squeezed(const std::vector<StepGroup>& groups, std::vector<int>& levels) const {
  const double smallest = smallest_step(groups, levels);
  std::vector<int> lowered = levels;
  for (std::size_t t = 0; t < levels.size(); ++t) {
    const double ratio = groups[t].stable_step / smallest * (1 + 1e-9);
    if (ratio >= 0.75 * (1 << own_[t])) continue;
    const int stable = static_cast<int>(std::floor(std::log2(ratio)));
    for (const std::int32_t other : neighbours_[t]) {
      int& level = lowered[other];
      level = std::min(level, std::max(0, stable));
    }
  }
  levels = std::move(lowered);
}

template <class S>
void Subcycling<S>::plan(const std::vector<TileResult<S>>& tiles, double contact_frequency2) {
  const std::vector<StepGroup> all = groups(tiles, contact_frequency2);
  std::vector<int> present = level_;
  for (std::size_t t = 0; t < present.size(); ++t) present[t] = std::min(present[t], highest_[t]);
  lower_beside_squeezed(all, present);
  next_level_ = present;
  // All choices are tried where the steps have become smaller, and now and then.
  const double step = smallest_step(all, present);
  if (present == level_ && step > 0.95 * planned_step_ && ++cycles_ < longest_plan) return;
  cycles_ = 0;
  double elements = 0;
  for (const StepGroup& group : all) elements += group.elements;
  const double every_step = every_node_ ? cost_of_nodes * elements : 0;
  std::vector<int> best = choose_levels(all, every_step);
  lower_beside_squeezed(all, best);
  // Another choice has to be worth it: a tile that changes its level breaks the rhythm that keeps the energy.
  if (work_per_time(all, best, every_step) < 0.9 * work_per_time(all, present, every_step)) next_level_ = best;
  planned_step_ = smallest_step(all, next_level_);
}

template <class S>
void Subcycling<S>::begin_cycle(const Model<S>& model) {
  if (next_level_ == level_) return;
  level_ = next_level_;
  sort_by_level(model);
}

template <class S>
void Subcycling<S>::sort_by_level(const Model<S>& model) {
  top_ = *std::max_element(level_.begin(), level_.end());
  tiles_.clear();
  for (int l = 0; l <= top_; ++l) {
    tiles_.push_back(chosen_of(model.tile_colours, [&](std::int32_t tile) {
      return level_[tile] == l && (domain_ == nullptr || domain_->works(tile));
    }));
  }
  if (domain_ != nullptr) domain_->set_levels(level_);

  const std::int32_t count = model.nodes.count;
  std::vector<std::int8_t> kicked(count);  // level at which a node gets impulses
  mixed_.assign(static_cast<std::size_t>(top_) + 1, {});
  for (std::int32_t n = 0; n < count; ++n) {
    const std::size_t node = n;
    unsigned levels = 0;  // of its tiles, a bit each
    for (std::int32_t i = tile_of_node_offsets_[node]; i < tile_of_node_offsets_[node + 1]; ++i) {
      levels |= 1U << level_[tile_of_node_[i]];
    }
    const int lowest = every_node_ || levels == 0 ? 0 : std::countr_zero(levels);
    kicked[node] = static_cast<std::int8_t>(lowest);
    for (int l = lowest + 1; l <= top_; ++l) {
      if ((levels >> l & 1U) != 0) mixed_[l].node.push_back(n);
    }
  }
  for (MixedNodes& mixed : mixed_) {
    for (std::vector<S>* records : {&mixed.first, &mixed.differences, &mixed.present}) {
      records->resize(3 * mixed.node.size());
    }
  }

  level_of_span_.clear();
  for (std::int32_t first = 0; first < count; first += nodes_per_span) {
    level_of_span_.push_back(
        *std::min_element(kicked.begin() + first, kicked.begin() + std::min(count, first + nodes_per_span)));
  }
}

template <class S>
ElementStep<S> Subcycling<S>::step(std::int32_t tile, bool begins_cycle, const ElementStep<S>& smallest) const {
  const std::size_t t = tile;
  const S before = 1 << level_[t];
  const auto after = begins_cycle ? (1 << next_level_[t]) : before;
  return {before * smallest.length, S(0.5) * (before + after), smallest.time};
}

/// body(velocity of the node, its place in the lists) for the mixed nodes of a level.
template <class S>
template <class Body>
void Subcycling<S>::for_each_mixed_node(const MixedNodes& mixed, NodeStore<S>& nodes, const Body& body) {
  parallel_for("mixed nodes", RangePolicy<>{0, std::ssize(mixed.node)}, [&](std::int64_t i) {
    const std::int64_t node = mixed.node[i];
    body(nodes.velocity.data() + 4 * node, 3 * static_cast<std::size_t>(i));
  });
}

template <class S>
void Subcycling<S>::use_mean_velocities(NodeStore<S>& nodes, int level) {
  MixedNodes& mixed = mixed_[level];
  if (mixed.steps == 0) return;  // before the first step there is no other velocity than the present one
  const S factor = S(1) / static_cast<S>(mixed.steps);
  for_each_mixed_node(mixed, nodes, [&](S* velocity, std::size_t place) {
    for (std::size_t k = 0; k < 3; ++k) {
      mixed.present[place + k] = velocity[k];
      velocity[k] = mixed.first[place + k] + factor * mixed.differences[place + k];
    }
  });
}

template <class S>
void Subcycling<S>::use_present_velocities(NodeStore<S>& nodes, int level) {
  MixedNodes& mixed = mixed_[level];
  if (mixed.steps == 0) return;
  for_each_mixed_node(mixed, nodes, [&](S* velocity, std::size_t place) {
    for (std::size_t k = 0; k < 3; ++k) velocity[k] = mixed.present[place + k];
  });
  mixed.steps = 0;
}

template <class S>
void Subcycling<S>::count_step(NodeStore<S>& nodes) {
  for (MixedNodes& mixed : mixed_) {
    for_each_mixed_node(mixed, nodes, [&](const S* velocity, std::size_t place) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (mixed.steps == 0) {
          mixed.first[place + k] = velocity[k];
          mixed.differences[place + k] = S(0);
        } else {
          mixed.differences[place + k] += velocity[k] - mixed.first[place + k];
        }
      }
    });
    ++mixed.steps;
  }
}

/// A rank has those of nodes that it moves.
template <class S>
void Subcycling<S>::share_mixed_nodes() {
  struct OfNode {
    std::array<S, 3> first, differences;
  };
  for (MixedNodes& mixed : mixed_) {
    if (mixed.node.empty()) continue;
    std::vector<std::int32_t> owner;
    std::vector<OfNode> all(mixed.node.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      owner.push_back(domain_->rank_of_node(mixed.node[i]));
      std::copy_n(mixed.first.begin() + 3 * i, 3, all[i].first.begin());
      std::copy_n(mixed.differences.begin() + 3 * i, 3, all[i].differences.begin());
    }
    domain_->share(owner, all.data());
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::copy_n(all[i].first.begin(), 3, mixed.first.begin() + 3 * i);
      std::copy_n(all[i].differences.begin(), 3, mixed.differences.begin() + 3 * i);
    }
  }
}

template <class S>
typename Subcycling<S>::StableStep Subcycling<S>::stable_step(const std::vector<TileResult<S>>& tiles,
                                                              double contact_frequency2) const {
  const std::vector<StepGroup> all = groups(tiles, contact_frequency2);
  StableStep least{std::numeric_limits<double>::infinity(), -1};
  for (std::size_t t = 0; t < all.size(); ++t) {
    const double step = std::ldexp(all[t].stable_step, -level_[t]);
    if (step < least.step) least = {step, tiles[t].time_step_slot};
  }
  return least;
}

template <class S>
std::int64_t Subcycling<S>::count_elements(const std::vector<TileResult<S>>& tiles, std::int32_t step) {
  std::int64_t left_out = 0;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    if (level_[t] > due(step)) left_out += elements_[t];
    if (tiles[t].eroded_count == 0) continue;
    elements_[t] -= tiles[t].eroded_count;
    lower_around(t);
  }
  return left_out;
}

/// What an eroded element uncovers lies in its tile and the tiles beside it, and a layer around that in those beside
/// these.
template <class S>
void Subcycling<S>::lower_around(std::int32_t tile) {
  const auto lower = [&](std::int32_t t) {
    highest_[t] = 0;
    own_[t] = 0;
  };
  lower(tile);
  for (const std::int32_t beside : neighbours_[tile]) {
    lower(beside);
    for (const std::int32_t next : neighbours_[beside]) lower(next);
  }
}

template <class S>
std::vector<std::int64_t> Subcycling<S>::elements_of_levels() const {
  std::vector<std::int64_t> sums(levels(), 0);
  for (std::size_t t = 0; t < level_.size(); ++t) sums[level_[t]] += elements_[t];
  return sums;
}

template <class S>
void Subcycling<S>::persist(StateArchive& archive, const Model<S>& model) {
  archive.of_fixed_size(level_);
  archive.of_fixed_size(next_level_);
  archive.of_fixed_size(highest_);
  archive.of_fixed_size(own_);
  archive.of_fixed_size(elements_);
  archive(planned_step_, cycles_);
  archive.require(cycles_ >= 0 && cycles_ <= longest_plan);
  for (std::size_t t = 0; archive.reads() && t < level_.size(); ++t) {
    const int highest = model.tile_levels[t].highest;
    for (const int level : {level_[t], next_level_[t], highest_[t]}) archive.require(level >= 0 && level <= highest);
    archive.require(own_[t] >= 0 && own_[t] <= model.tile_levels[t].own && elements_[t] >= 0);
    archive.require(elements_[t] <= (model.tile_packs[t + 1] - model.tile_packs[t]) * model.elements.width);
  }
  if (archive.reads()) sort_by_level(model);
  for (MixedNodes& mixed : mixed_) {
    archive.of_fixed_size(mixed.first);
    archive.of_fixed_size(mixed.differences);
    archive(mixed.steps);
    archive.require(mixed.steps >= 0 && mixed.steps <= cycle_steps());
  }
}

template <class S>
std::size_t Subcycling<S>::bytes() const {
  std::size_t sum = (tile_of_node_.capacity() + tile_of_node_offsets_.capacity()) * sizeof(std::int32_t);
  for (const MixedNodes& mixed : mixed_) sum += mixed.node.capacity() * (sizeof(std::int32_t) + 9 * sizeof(S));
  return sum + level_of_span_.capacity();
}

template class Subcycling<double>;
template class Subcycling<float>;

}  // namespace pinball

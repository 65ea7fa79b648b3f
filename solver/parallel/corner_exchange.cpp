#include "corner_exchange.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include <kernels/exec.hpp>
#include <solver/model/corner_order.hpp>

namespace pinball {

template <class S>
CornerExchange<S>::CornerExchange(Model<S>& model, const std::vector<std::int32_t>& rank_of_tile,
                                  const NodeHolders& holders, Ranks& ranks)
    : ranks_(ranks) {
  corner_.renew(model.elements.corner.size());
  std::copy_n(model.elements.corner.data(), corner_.size(), corner_.data());
  find_records(model, rank_of_tile, holders);
  repeat_in_padding(model, rank_of_tile);
  for (Neighbour& of : neighbours_) of.buffer.resize(3 * of.sent.size());
  model.nodes.add_records(static_cast<std::int64_t>(node_of_record_.size()));
}

template <class S>
typename CornerExchange<S>::Neighbour& CornerExchange<S>::neighbour(std::int32_t rank) {
  const auto found = std::ranges::find(neighbours_, rank, &Neighbour::rank);
  if (found != neighbours_.end()) return *found;
  neighbours_.push_back({});
  neighbours_.back().rank = rank;
  return neighbours_.back();
}

/// Both sides of a message go through the corners in the same order.
template <class S>
void CornerExchange<S>::find_records(Model<S>& model, const std::vector<std::int32_t>& rank_of_tile,
                                     const NodeHolders& holders) {
  struct Source {
    std::int32_t node, rank;  // place of the node in holders.shared(); who has the force
    std::int64_t number;      // of the record, or of what that rank sends to this one
  };
  std::vector<Source> sources;
  const std::int32_t self = ranks_.number();
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;  // who sends to whom
  for_each_corner_in_order(model, [&](std::int32_t tile, std::int64_t slot, int i) {
    if (model.is_rigid(tile)) return;  // no kernel works it
    const std::int32_t node = model.elements.corner[model.elements.at(slot, i, 8)];
    if (!holders.is_shared(node)) return;
    const std::span<const std::int32_t> all = holders.of(node);
    records_ += std::ssize(all) - 1;
    const std::int32_t from = rank_of_tile[tile], place = holders.shared_place(node);
    for (const std::int32_t to : all) {
      if (to != from && (pairs.empty() || pairs.back() != std::pair(from, to))) pairs.emplace_back(from, to);
    }
    if (from == self) {
      const auto record = static_cast<std::int32_t>(model.nodes.count + std::ssize(node_of_record_));
      node_of_record_.push_back(node);
      corner_[model.elements.at(slot, i, 8)] = record;
      sources.push_back({place, self, record});
      for (const std::int32_t to : all) {
        if (to != self) neighbour(to).sent.push_back(record);
      }
    } else if (holders.has(node, self)) {
      sources.push_back({place, from, neighbour(from).count++});
    }
  });
  std::ranges::sort(pairs);
  messages_ = std::ranges::unique(pairs).begin() - pairs.begin();
  std::int64_t count = 0;
  for (Neighbour& of : neighbours_) {
    of.first = count;
    count += of.count;
  }
  received_.resize(3 * static_cast<std::size_t>(count));
  std::ranges::stable_sort(sources, {}, &Source::node);
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const Source& source = sources[s];
    if (s == 0 || source.node != sources[s - 1].node) {
      nodes_.push_back(holders.shared()[source.node]);
      first_.push_back(static_cast<std::int64_t>(s));
    }
    source_.push_back(source.rank == self ? source.number : -1 - (neighbour(source.rank).first + source.number));
  }
  first_.push_back(static_cast<std::int64_t>(sources.size()));
}

/// Padding has the shape of the element before it, and adds zeros to its forces.
template <class S>
void CornerExchange<S>::repeat_in_padding(const Model<S>& model, const std::vector<std::int32_t>& rank_of_tile) {
  for (std::int32_t tile = 0; tile < model.tile_count(); ++tile) {
    if (rank_of_tile[tile] != ranks_.number()) continue;
    for (const std::int64_t slot : model.slots_of(tile)) {
      if (!model.is_padding(slot)) continue;
      for (int i = 0; i < 8; ++i) corner_[model.elements.at(slot, i, 8)] = corner_[model.elements.at(slot - 1, i, 8)];
    }
  }
}

template <class S>
void CornerExchange<S>::spread(NodeStore<S>& nodes) const {
  parallel_for("corners of several ranks", RangePolicy<>{0, std::ssize(node_of_record_)}, [&](std::int64_t r) {
    const std::int32_t node = node_of_record_[r];
    std::copy_n(nodes.position_of(node), 4, nodes.position_of(nodes.count + r));
    std::copy_n(nodes.velocity_of(node), 4, nodes.velocity_of(nodes.count + r));
  });
}

template <class S>
void CornerExchange<S>::collect(NodeStore<S>& nodes) {
  std::vector<RankMessage> messages;
  for (Neighbour& of : neighbours_) {
    parallel_for("forces for another rank", RangePolicy<>{0, std::ssize(of.sent)},
                 [&](std::int64_t r) { std::copy_n(nodes.force_of(of.sent[r]), 3, of.buffer.data() + 3 * r); });
    const std::span<S> received(received_.data() + 3 * of.first, 3 * static_cast<std::size_t>(of.count));
    messages.push_back({of.rank, std::as_bytes(std::span(of.buffer)), std::as_writable_bytes(received)});
  }
  ranks_.exchange(messages);
  ranks_.bytes_given += records_ * bytes_per_record;
  parallel_for("forces of several ranks", RangePolicy<>{0, std::ssize(nodes_)}, [&](std::int64_t n) {
    S* const force = nodes.force_of(nodes_[n]);
    S sum[3] = {force[0], force[1], force[2]};
    for (std::int64_t s = first_[n]; s < first_[n + 1]; ++s) {
      const std::int64_t source = source_[s];
      const S* const value = source >= 0 ? nodes.force_of(source) : received_.data() + 3 * (-1 - source);
      for (int k = 0; k < 3; ++k) sum[k] += value[k];
    }
    for (int k = 0; k < 3; ++k) force[k] = sum[k];
  });
  std::fill_n(nodes.force_of(nodes.count), 4 * node_of_record_.size(), S(0));
}

template <class S>
std::size_t CornerExchange<S>::bytes() const {
  std::size_t sum = corner_.bytes() + (node_of_record_.size() + nodes_.size()) * sizeof(std::int32_t) +
                    (first_.size() + source_.size()) * sizeof(std::int64_t) + received_.size() * sizeof(S);
  for (const Neighbour& of : neighbours_) sum += of.sent.size() * (sizeof(std::int32_t) + 3 * sizeof(S));
  return sum;
}

template class CornerExchange<double>;
template class CornerExchange<float>;

}  // namespace pinball

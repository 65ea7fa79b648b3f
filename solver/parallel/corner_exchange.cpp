#include "corner_exchange.hpp"

#include <algorithm>
#include <span>

#include <kernels/exec.hpp>

namespace pinball {

template <class S>
CornerExchange<S>::CornerExchange(Model<S>& model, const CornerPlan& plan,
                                  const std::vector<std::int32_t>& rank_of_tile, Ranks& ranks)
    : plan_(plan), due_(plan, {}), ranks_(ranks), received_(3 * static_cast<std::size_t>(plan.received)) {
  corner_.reset(model.elements.corner.size());
  const std::int64_t row = 8 * static_cast<std::int64_t>(model.elements.width);
  for (std::int32_t tile = 0; tile < model.tile_count(); ++tile) {  // of others nothing is written, nor asked for
    if (rank_of_tile[tile] != ranks_.number()) continue;
    const std::int64_t first = row * model.tile_packs[tile], end = row * model.tile_packs[tile + 1];
    std::copy(model.elements.corner.data() + first, model.elements.corner.data() + end, corner_.data() + first);
  }
  auto record = static_cast<std::int32_t>(model.nodes.count);
  for (const CornerPlan::Corner& of : plan.own) corner_[model.elements.at(of.slot, of.corner, 8)] = record++;
  repeat_in_padding(model, rank_of_tile);
  for (const CornerPlan::Neighbour& of : plan.neighbours) sent_.emplace_back(3 * of.sent.size());
  model.nodes.add_records(std::ssize(plan.own));
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
void CornerExchange<S>::spread(NodeStore<S>& nodes, int level) const {
  const std::vector<std::int32_t>& own = due_.own[level];
  parallel_for("corners of several ranks", RangePolicy<>{0, std::ssize(own)}, [&](std::int64_t i) {
    const std::int32_t r = own[i], node = plan_.own[r].node;
    std::copy_n(nodes.position_of(node), 4, nodes.position_of(nodes.count + r));
    std::copy_n(nodes.velocity_of(node), 4, nodes.velocity_of(nodes.count + r));
  });
}

template <class S>
void CornerExchange<S>::collect(NodeStore<S>& nodes, int level) {
  std::vector<RankMessage> messages;
  for (std::size_t n = 0; n < sent_.size(); ++n) {
    const CornerPlan::Neighbour& of = plan_.neighbours[n];
    const DueCorners::Neighbour& due = due_.neighbours[n];
    const std::int64_t count = due.sent_up_to[level];
    std::vector<S>& sent = sent_[n];
    parallel_for("forces for another rank", RangePolicy<>{0, count}, [&](std::int64_t r) {
      std::copy_n(nodes.force_of(nodes.count + due.sent[r]), 3, sent.data() + 3 * r);
    });
    const std::span<const S> own(sent.data(), 3 * static_cast<std::size_t>(count));
    const std::span<S> others(received_.data() + 3 * of.first, 3 * static_cast<std::size_t>(due.received_up_to[level]));
    messages.push_back({of.rank, std::as_bytes(own), std::as_writable_bytes(others)});
  }
  ranks_.exchange(messages);
  ranks_.bytes_given += due_.records[level] * static_cast<std::int64_t>(3 * sizeof(S));
  parallel_for("forces of several ranks", RangePolicy<>{0, std::ssize(plan_.nodes)}, [&](std::int64_t n) {
    S* const force = nodes.force_of(plan_.nodes[n]);
    S sum[3] = {force[0], force[1], force[2]};
    for (std::int64_t s = plan_.first[n]; s < plan_.first[n + 1]; ++s) {
      const auto [source, of_level] = due_.sources[s];
      if (of_level > level) continue;
      const S* const value = source >= 0 ? nodes.force_of(nodes.count + source) : received_.data() + 3 * (-1 - source);
      for (int k = 0; k < 3; ++k) sum[k] += value[k];
    }
    for (int k = 0; k < 3; ++k) force[k] = sum[k];
  });
  std::fill_n(nodes.force_of(nodes.count), 4 * plan_.own.size(), S(0));
}

template <class S>
std::size_t CornerExchange<S>::bytes() const {
  std::size_t sum = corner_.bytes() + due_.bytes() + received_.size() * sizeof(S);
  for (const std::vector<S>& of : sent_) sum += of.size() * sizeof(S);
  return sum;
}

template class CornerExchange<double>;
template class CornerExchange<float>;

}  // namespace pinball

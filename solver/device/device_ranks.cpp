#include "device_ranks.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include <solver/base/packs.hpp>
#include <solver/model/corner_order.hpp>

namespace pinball {

namespace {

/// Places of a piece of the sum over a part.
template <class S>
SumPiece places_of_piece(const DevicePart<S>& part, int lanes, std::int64_t piece, std::int64_t pieces) {
  const SumPiece of = sum_piece((part.last - part.first) / lanes, piece, pieces);
  return {part.first + of.begin * lanes, part.first + of.end * lanes};
}

}  // namespace

template <class S>
DeviceRanks<S>::DeviceRanks(const Model<S>& model, const DeviceLayout<S>& layout, Device device, Subdomain<S>& domain)
    : model_(model),
      layout_(layout),
      lanes_(device == Device::mock ? native_width<S> : 1),
      messages_(device == Device::cuda && domain.reaches_cuda() ? Messages::device : Messages::host),
      domain_(domain) {
  for (const DevicePart<S>& part : layout.parts()) {
    const std::int64_t count = sum_pieces((part.last - part.first) / lanes_);
    blocks_.push_back(domain.blocks(count, [this, &part, count](std::int64_t p, const auto& take) {
      const SumPiece places = places_of_piece(part, lanes_, p, count);
      for (std::int64_t place = places.begin; place < places.end; ++place) {
        const std::int64_t slot = layout_.slot_of_place(place);
        if (slot < 0) continue;
        for (const std::int32_t node : model_.elements.corners(slot)) take(node);
      }
    }));
    pieces_.push_back({count, {}, {}, {}});
    for (std::int64_t p = 0; p < count; ++p) owner_.push_back(blocks_.back()->owner(p));
  }
  for (std::int32_t rank = 0; rank < domain.ranks(); ++rank) owner_.push_back(rank);
}

template <class S>
void DeviceRanks<S>::mark(DeviceMesh<S>& mesh) {
  mesh.is_shared = true;
  mark_pieces(mesh);
  add_volumes(mesh);
}

template <class S>
void DeviceRanks<S>::mark_pieces(DeviceMesh<S>& mesh) {
  for (std::size_t of = 0; of < pieces_.size(); ++of) {
    SomePieces<S>& some = pieces_[of];
    for (std::int64_t p = 0; p < some.all; ++p) {
      const SumPiece places = places_of_piece(layout_.parts()[of], lanes_, p, some.all);
      const bool sums_up = blocks_[of]->owner(p) == domain_.rank();
      bool works = sums_up;
      for (std::int64_t pack = places.begin / widest_pack<S>; pack < places.end / widest_pack<S>; ++pack) {
        if (domain_.works(mesh.tile[pack])) {
          works = true;
        } else {
          mesh.tile[pack] = sums_up ? TileWork::number_for_sums(mesh.tiles) : TileWork::number_of_none(mesh.tiles);
        }
      }
      if (!works) continue;
      if (some.worked.empty() || some.worked.back().last != p) some.worked.push_back({p, p});
      some.worked.back().last = p + 1;
    }
  }
}

/// The rank that adds up the piece of a sum in which an element is.
template <class S>
std::int32_t DeviceRanks<S>::adder_of_slot(std::int64_t slot) const {
  const std::int64_t place = layout_.place_of_slot(slot);
  const auto after = std::ranges::upper_bound(layout_.parts(), place, {}, &DevicePart<S>::first);
  const std::int64_t of = after - layout_.parts().begin() - 1, count = pieces_[of].all;
  std::int64_t below = 0, above = count;  // the piece that begins last of those at the place or before
  while (above - below > 1) {
    const std::int64_t middle = (below + above) / 2;
    (places_of_piece(layout_.parts()[of], lanes_, middle, count).begin <= place ? below : above) = middle;
  }
  return blocks_[of]->owner(below);
}

template <class S>
void DeviceRanks<S>::add_volumes(DeviceMesh<S>& mesh) {
  VolumeGroups<S> groups(model_, &domain_, [this](std::int64_t slot) { return adder_of_slot(slot); });
  mesh.volumes.lists = layout_.lists_of_places(std::move(groups.lists));
  mesh.volumes.own = groups.own;
  for (const VolumeNeighbour& of : groups.neighbours)
    mesh.volumes.sent.insert(mesh.volumes.sent.end(), of.sent.begin(), of.sent.end());
  volume_neighbours_ = std::move(groups.neighbours);
  volumes_sent_by_all_ = groups.sent_by_all;
}

template <class S>
void DeviceRanks<S>::exchange_volumes(DeviceStep<S>& step) const {
  if (!model_.averages_volumes()) return;
  const S* sent = step.gather_volumes(messages_);
  S* next = step.received_volumes(messages_);
  std::vector<RankMessage> messages;
  for (const VolumeNeighbour& of : volume_neighbours_) {
    const std::span<const S> own(sent, of.sent.size());
    const std::span<S> others(next, static_cast<std::size_t>(of.count));
    messages.push_back({of.rank, std::as_bytes(own), std::as_writable_bytes(others)});
    sent += own.size();
    next += others.size();
  }
  domain_.exchange(messages, volumes_sent_by_all_ * static_cast<std::int64_t>(sizeof(S)));
  step.scatter_volumes(messages_);
}

template <class S>
void DeviceRanks<S>::connect(DeviceStep<S>& step) {
  if (plan_ == domain_.plans()) return;
  plan_ = domain_.plans();
  const CornerPlan& plan = domain_.corner_plan();
  const std::int64_t places = layout_.places();
  const auto number_of = [this](std::int64_t slot, int corner) {
    return static_cast<std::uint32_t>(8 * layout_.place_of_slot(slot) + corner);
  };
  const auto number_of_own = [&](std::int64_t of) { return number_of(plan.own[of].slot, plan.own[of].corner); };
  DeviceHalo halo;
  halo.received = plan.received;
  for (const CornerPlan::Neighbour& of : plan.neighbours) {
    for (const std::int32_t corner : of.sent) halo.sent.push_back(number_of_own(corner));
  }
  std::vector<std::uint8_t> is_shared(model_.nodes.count, 0);
  for (const std::int32_t node : plan.nodes) is_shared[node] = 1;
  const auto for_each_corner = [&](const auto& visit) {
    for_each_corner_in_order(model_, [&](std::int32_t tile, std::int64_t slot, int i) {
      const std::int32_t node = model_.elements.corner[model_.elements.at(slot, i, 8)];
      if (is_shared[node] == 0 && domain_.works(tile)) visit(node, number_of(slot, i));
    });
    for (std::size_t n = 0; n < plan.nodes.size(); ++n) {
      for (std::int64_t s = plan.first[n]; s < plan.first[n + 1]; ++s) {
        const std::int64_t source = plan.source[s];
        visit(plan.nodes[n], source >= 0 ? number_of_own(source) : static_cast<std::uint32_t>(8 * places - 1 - source));
      }
    }
  };
  halo.set_corners(model_.nodes.count, for_each_corner);
  step.set_halo(halo);
}

template <class S>
void DeviceRanks<S>::exchange_forces(DeviceStep<S>& step) const {
  const CornerPlan& plan = domain_.corner_plan();
  const S* sent = step.gather_halo(messages_);
  S* const received = step.received_halo(messages_);
  std::vector<RankMessage> messages;
  for (const CornerPlan::Neighbour& of : plan.neighbours) {
    const std::span<const S> own(sent, 3 * of.sent.size());
    const std::span<S> others(received + 3 * of.first, 3 * static_cast<std::size_t>(of.count));
    messages.push_back({of.rank, std::as_bytes(own), std::as_writable_bytes(others)});
    sent += own.size();
  }
  domain_.exchange(messages, plan.records * static_cast<std::int64_t>(3 * sizeof(S)));
  step.scatter_halo(messages_);
}

/// of_pieces: of all parts, one after the other.
template <class S>
std::vector<ElementTotals<S>> DeviceRanks<S>::joined(const std::vector<ElementTotals<S>>& of_pieces) const {
  std::vector<ElementTotals<S>> of_parts;
  const ElementTotals<S>* next = of_pieces.data();
  for (const SomePieces<S>& some : pieces_) {
    of_parts.push_back(join_pieces(next, some.all));
    next += some.all;
  }
  return of_parts;
}

/// The second sweep is nothing to most steps, and then nothing is said of it.
template <class S>
ElementTotals<S> DeviceRanks<S>::share(const std::vector<SomePieces<S>>& pieces, const ElementTotals<S>& own) {
  std::vector<ElementTotals<S>> all, left;
  for (const SomePieces<S>& some : pieces) {
    all.insert(all.end(), some.usual.begin(), some.usual.end());
    left.insert(left.end(), some.of_left.begin(), some.of_left.end());
  }
  const auto number_of_pieces = static_cast<std::ptrdiff_t>(all.size());
  ElementTotals<S> of_rank;  // whoever sums up the piece
  of_rank.stable_rate = own.stable_rate;
  of_rank.place = own.place;
  all.resize(owner_.size(), of_rank);
  domain_.share(owner_, all.data());
  totals_of_parts_ = joined(all);
  if (std::ranges::any_of(totals_of_parts_, [](const ElementTotals<S>& part) { return part.left_count > 0; })) {
    left.resize(owner_.size());
    domain_.share(owner_, left.data());
    const std::vector<ElementTotals<S>> more = joined(left);
    for (std::size_t of = 0; of < more.size(); ++of) totals_of_parts_[of].join(more[of]);
  }
  ElementTotals<S> totals;
  for (const ElementTotals<S>& part : totals_of_parts_) totals.join(part);
  for (const ElementTotals<S>& rank : std::span(all).subspan(number_of_pieces)) totals.join(rank);
  return totals;
}

template <class S>
typename DeviceRanks<S>::Resting DeviceRanks<S>::share(const Resting& own) const {
  std::vector<std::int32_t> owner(domain_.ranks());
  std::iota(owner.begin(), owner.end(), 0);
  std::vector<Resting> all(owner.size(), own);
  domain_.share(owner, all.data());
  Resting sum;
  for (const Resting& of : all) {
    sum.elements += of.elements;
    const bool is_first = of.time_step < sum.time_step || (of.time_step == sum.time_step && of.tile < sum.tile);
    if (of.tile < 0 || (sum.tile >= 0 && !is_first)) continue;
    sum.time_step = of.time_step;
    sum.tile = of.tile;
  }
  return sum;
}

template <class S>
MotionEnergy DeviceRanks<S>::integrate(DeviceStep<S>& step, const StepLengths& lengths) const {
  const SharedBlocks& blocks = domain_.node_blocks();
  std::vector<MotionEnergy> of_block(blocks.count());
  for (const SharedBlocks::Run& run : blocks.worked()) step.integrate(lengths, {run.begin, run.end}, of_block.data());
  blocks.gather(of_block.data());
  return join_pieces(of_block.data(), blocks.count());
}

template class DeviceRanks<double>;
template class DeviceRanks<float>;

}  // namespace pinball

#include "subdomain.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>

#include <kernels/exec.hpp>
#include <solver/base/error.hpp>
#include <solver/base/piece_share.hpp>
#include <solver/base/state_hash.hpp>

#include "partition.hpp"

namespace pinball {

template <class S>
Subdomain<S>::Subdomain(const Model<S>& model, Ranks& ranks)
    : SharedNodes(ranks),
      elements_of_tile_(elements_of_tiles(model)),
      work_of_tile_(work_of_tiles(model)),
      rank_of_tile_(ranks_of_tiles(model, ranks)),
      tile_packs_(model.tile_packs),
      pack_width_(model.elements.width),
      holders_(model, rank_of_tile_),
      common_(ranks, model.nodes.count),
      sharers_(ranks),
      on_device_(model.scene.device != Device::none) {
  cut_nodes(model.nodes.count);
}

/// Blocks of nodes as they are summed up where the nodes are moved.
template <class S>
void Subdomain<S>::cut_nodes(std::int32_t nodes) {
  static_assert(nodes_per_span == sum_lanes);
  const std::int64_t count = on_device_ ? sum_pieces(nodes) : span_count(nodes);
  for (std::int64_t block = 0; block < count; ++block) {
    const std::int64_t end = on_device_ ? sum_piece(nodes, block, count).end : (block + 1) * nodes_per_span;
    const std::int64_t spans = span_count(static_cast<std::int32_t>(std::min<std::int64_t>(end, nodes)));
    block_of_span_.resize(spans, static_cast<std::int32_t>(block));
    end_of_block_.push_back(std::min<std::int64_t>(end, nodes));
  }
  node_blocks_ = blocks(count, [this](std::int64_t block, const auto& take) {
    const auto [first, end] = nodes_of_block(block);
    for (std::int64_t n = first; n < end; ++n) take(static_cast<std::int32_t>(n));
  });
}

template <class S>
std::pair<std::int64_t, std::int64_t> Subdomain<S>::nodes_of_block(std::int64_t block) const {
  return {block == 0 ? 0 : end_of_block_[block - 1], end_of_block_[block]};
}

template <class S>
Subdomain<S>::~Subdomain() {
  if (!connected_ || !is_first()) return;
  if (waits_) {
    ranks_.give_up();
  } else {
    order(RankOrder::end);
  }
}

template <class S>
std::shared_ptr<const SharedBlocks> Subdomain<S>::blocks(std::int64_t count, SharedBlocks::Visit visit) {
  blocks_.push_back(std::make_shared<SharedBlocks>(ranks_, holders_, count, std::move(visit)));
  return blocks_.back();
}

template <class S>
void Subdomain<S>::add_common(std::span<const std::int32_t> nodes) {
  common_.add(nodes, [this](std::int32_t node) { return rank_of_node(node); });
}

template <class S>
void Subdomain<S>::connect(Model<S>& model, std::uint64_t fingerprint) {
  connect_sums(model);
  state_was_read(model);
  StateHash hash;
  hash.add(&fingerprint, sizeof fingerprint);
  hash.add(rank_of_tile_.data(), rank_of_tile_.size() * sizeof(std::int32_t));
  agree(ranks_, {0, "", model.elements.width, hash.value()});
  connected_ = true;
  if (on_device_) share_devices();
}

template <class S>
void Subdomain<S>::share_devices() {
  using Name = std::array<char, 120>;
  std::vector<std::int32_t> rank(ranks_.count());
  std::iota(rank.begin(), rank.end(), 0);
  std::vector<Name> names(rank.size(), Name{});
  for (Name& name : names) device_.copy(name.data(), name.size() - 1);
  share(rank, names.data());
  for (const Name& name : names) devices_.emplace_back(name.data());
}

/// Lists that have ended are of no one else.
template <class S>
void Subdomain<S>::connect_sums(Model<S>& model) {
  std::erase_if(blocks_, [](const std::shared_ptr<SharedBlocks>& sum) { return sum.use_count() == 1; });
  holders_.take_more();
  corners_.reset();
  plan_.emplace(model, rank_of_tile_, holders_, ranks_.number());
  ++plans_;
  if (!on_device_) {
    corners_.emplace(model, *plan_, rank_of_tile_, ranks_);
    corners_->set_levels(level_of_tile_);
  }
  find_worked();
}

template <class S>
void Subdomain<S>::find_worked() {
  for (const std::shared_ptr<SharedBlocks>& sum : blocks_)
    sum->find_worked([this](std::int32_t node) { return moves(node); });
}

template <class S>
std::int32_t Subdomain<S>::rank_of_slot(std::int64_t slot) const {
  const auto after = std::ranges::upper_bound(tile_packs_, slot / pack_width_);
  return rank_of_tile_[after - tile_packs_.begin() - 1];
}

template <class S>
void Subdomain<S>::begin_cycle() {
  is_whole_ = false;
  in_step_ = waits_ = true;
  bytes_before_ = ranks_.bytes_given;
  steps_of_cycle_ = 0;
}

template <class S>
void Subdomain<S>::end_cycle() {
  in_step_ = waits_ = false;
  bytes_per_step_ = (ranks_.bytes_given - bytes_before_) / std::max<std::int64_t>(1, steps_of_cycle_);
}

template <class S>
void Subdomain<S>::set_levels(const std::vector<int>& level_of_tile) {
  level_of_tile_ = level_of_tile;
  if (corners_) corners_->set_levels(level_of_tile_);
}

template <class S>
void Subdomain<S>::share_eroded(Model<S>& model, const std::vector<std::int64_t>& of_tile) {
  if (!common_.any()) return;
  std::vector<std::size_t> bytes_of(ranks_.count(), 0);
  std::vector<std::int32_t> own, all;
  for (std::size_t tile = 0; tile < of_tile.size(); ++tile) {
    bytes_of[rank_of_tile_[tile]] += of_tile[tile] * sizeof(std::int32_t);
    if (of_tile[tile] == 0 || !works(tile)) continue;
    for (const std::int64_t slot : model.slots_of(tile)) {
      if (is_alive_[slot] != 0 && !model.elements.alive(slot)) own.push_back(static_cast<std::int32_t>(slot));
    }
  }
  all.resize(std::accumulate(of_tile.begin(), of_tile.end(), std::int64_t{0}));
  if (own.size() * sizeof(std::int32_t) != bytes_of[ranks_.number()])
    throw std::logic_error("other elements have eroded than were counted");
  ranks_.gather(std::as_bytes(std::span(own)), bytes_of, std::as_writable_bytes(std::span(all)), true);
  ranks_.bytes_given += std::ssize(all) * static_cast<std::int64_t>(sizeof(std::int32_t));
  for (const std::int32_t slot : all) {
    is_alive_[slot] = 0;
    model.elements.mass[slot] = 0;
  }
  has_eroded_ = has_eroded_ || !all.empty();
}

template <class S>
std::vector<std::int64_t> Subdomain<S>::join_eroded(Model<S>& model, const std::vector<std::int64_t>& own) {
  std::vector<std::int64_t> all;
  for (const std::span<const std::byte> of_rank : sharers_.to_all(std::as_bytes(std::span(own)))) {
    std::vector<std::int64_t> slots(of_rank.size() / sizeof(std::int64_t));
    std::span<const std::byte> rest = of_rank;
    get(rest, std::span(slots));
    all.insert(all.end(), slots.begin(), slots.end());
  }
  std::sort(all.begin(), all.end());
  for (const std::int64_t slot : all) {
    is_alive_[slot] = 0;
    model.elements.mass[slot] = 0;
  }
  has_eroded_ = has_eroded_ || !all.empty();
  return all;
}

template <class S>
void Subdomain<S>::take_out_eroded(Model<S>& model) const {
  for (std::int64_t slot = 0; slot < std::ssize(is_alive_); ++slot) {
    if (is_alive_[slot] == 0) model.elements.mass[slot] = 0;
  }
}

template <class S>
void Subdomain<S>::share_strains(Model<S>& model, const Surface& surface) {
  if (!has_eroded_) return;
  has_eroded_ = false;
  std::vector<std::int32_t> owner, slots;
  std::vector<S> strain;
  for (std::int32_t tile = 0; tile < model.tile_count(); ++tile) {
    if (!model.parts[model.tile_part[tile]].features.erosion) continue;
    for (const std::int64_t slot : model.slots_of(tile)) {
      if (surface.exposed(slot) == 0) continue;
      owner.push_back(rank_of_tile_[tile]);
      slots.push_back(static_cast<std::int32_t>(slot));
      strain.push_back(static_cast<S>(model.elements.plastic_strain[slot]));
    }
  }
  ranks_.share(owner, strain.data());
  for (std::size_t i = 0; i < slots.size(); ++i) model.elements.plastic_strain[slots[i]] = strain[i];
}

template <class S>
void Subdomain<S>::take_in(Model<S>& model, std::span<const std::int32_t> nodes) {
  if (!common_.add(nodes, [this](std::int32_t node) { return rank_of_node(node); })) return;
  common_.share_added(model.nodes);
  find_worked();
}

template <class S>
void Subdomain<S>::bring_nodes(Model<S>& model) {
  gather_nodes({&model.nodes.position, &model.nodes.velocity, &model.nodes.force}, true);
}

template <class S>
void Subdomain<S>::order(RankOrder order) {
  if (!is_first()) return;
  if (waits_) throw RunError("the other ranks wait for messages that do not come");
  auto number = static_cast<std::int32_t>(order);
  ranks_.broadcast(std::as_writable_bytes(std::span(&number, 1)));
}

template <class S>
RankOrder Subdomain<S>::next_order() {
  std::int32_t number = 0;
  ranks_.broadcast(std::as_writable_bytes(std::span(&number, 1)));
  order_ = static_cast<RankOrder>(number);
  return order_;
}

template <class S>
void Subdomain<S>::bring_back(Model<S>& model) {
  if (is_whole_) return;
  if (in_step_) {
    gather_state(model, true);
  } else if (is_first()) {
    order(RankOrder::state);
    send_state(model);
  }
}

template <class S>
std::vector<std::string> Subdomain<S>::ask(std::int64_t number, const std::function<std::string(std::int64_t)>& act) {
  order(RankOrder::answer);
  ranks_.broadcast(std::as_writable_bytes(std::span(&number, 1)));
  const std::string own = act(number);
  std::vector<std::string> all;
  for (const std::span<const std::byte> of : sharers_.to_all(std::as_bytes(std::span(own)))) {
    std::string& text = all.emplace_back(of.size(), ' ');
    std::span<const std::byte> rest = of;
    get(rest, std::span(text));
  }
  return all;
}

template <class S>
void Subdomain<S>::state_was_read(Model<S>& model) {
  is_whole_ = true;
  is_alive_.resize(model.elements.slots);
  for (std::int64_t slot = 0; slot < model.elements.slots; ++slot) is_alive_[slot] = model.elements.alive(slot) ? 1 : 0;
  has_eroded_ = true;
}

template <class S>
void Subdomain<S>::send_state(Model<S>& model) {
  waits_ = true;
  gather_state(model, false);
  waits_ = false;
}

/// Of tiles from those who work them, of nodes from those who sum up their blocks.
template <class S>
void Subdomain<S>::gather_state(Model<S>& model, bool to_all) {
  if (bring_own_) bring_own_();
  const std::int64_t W = model.elements.width;
  const std::int64_t slots = std::max<std::int64_t>(model.elements.slots, 1);
  for (RealArray* array : model.elements.state()) {
    const std::int64_t components = static_cast<std::int64_t>(array->size()) / slots;
    array->visit([&](auto& numbers) {
      gather_ranges(
          numbers, rank_of_tile_,
          [&](std::int64_t tile) {
            return std::pair(model.tile_packs[tile] * W * components, model.tile_packs[tile + 1] * W * components);
          },
          to_all);
    });
  }
  gather_nodes({&model.nodes.position, &model.nodes.velocity}, to_all);
  for (const std::function<void()>& bring : kept_) bring();
  is_whole_ = to_all || is_first();
}

template <class S>
void Subdomain<S>::gather_nodes(std::initializer_list<Array<S>*> arrays, bool to_all) {
  std::vector<std::int32_t> owner;
  for (std::int64_t block = 0; block < node_blocks_->count(); ++block) owner.push_back(node_blocks_->owner(block));
  for (Array<S>* array : arrays) {
    gather_ranges(
        *array, owner,
        [this](std::int64_t block) {
          const auto [first, end] = nodes_of_block(block);
          return std::pair(4 * first, 4 * end);
        },
        to_all);
  }
}

/// range(i): the numbers of the array that are of i; owner: rank of each i.
template <class S>
template <class E, class Range>
void Subdomain<S>::gather_ranges(Array<E>& array, const std::vector<std::int32_t>& owner, const Range& range,
                                 bool to_all) {
  if (array.empty()) return;
  std::vector<std::size_t> bytes_of(ranks_.count(), 0);
  std::vector<E> own;
  for (std::size_t i = 0; i < owner.size(); ++i) {
    const auto [first, last] = range(i);
    bytes_of[owner[i]] += (last - first) * sizeof(E);
  }
  own.reserve(bytes_of[ranks_.number()] / sizeof(E));
  for (std::size_t i = 0; i < owner.size(); ++i) {
    const auto [first, last] = range(i);
    if (owner[i] == ranks_.number()) own.insert(own.end(), array.data() + first, array.data() + last);
  }
  std::vector<std::size_t> next(ranks_.count(), 0);
  for (std::size_t r = 1; r < next.size(); ++r) next[r] = next[r - 1] + bytes_of[r - 1] / sizeof(E);
  const bool gets = to_all || is_first();
  std::vector<E> all(gets ? next.back() + bytes_of.back() / sizeof(E) : 0);
  ranks_.gather(std::as_bytes(std::span(own)), bytes_of, std::as_writable_bytes(std::span(all)), to_all);
  for (std::size_t i = 0; gets && i < owner.size(); ++i) {
    const auto [first, last] = range(i);
    std::copy_n(all.data() + next[owner[i]], last - first, array.data() + first);
    next[owner[i]] += last - first;
  }
}

template <class S>
SharedWork Subdomain<S>::work() const {
  std::vector<std::int64_t> elements(ranks_.count(), 0), work(ranks_.count(), 0);
  for (std::size_t t = 0; t < rank_of_tile_.size(); ++t) {
    elements[rank_of_tile_[t]] += elements_of_tile_[t];
    work[rank_of_tile_[t]] += work_of_tile_[t];
  }
  const double all = std::accumulate(work.begin(), work.end(), 0.0);
  const std::int64_t most = *std::ranges::max_element(work);
  return {.ranks = ranks_.count(),
          .records = plan_ ? plan_->records : 0,
          .messages = plan_ ? plan_->messages : 0,
          .common_nodes = common_.count(),
          .bytes_per_step = bytes_per_step_,
          .most_elements = *std::ranges::max_element(elements),
          .imbalance = static_cast<double>(most) * ranks_.count() / all,
          .devices = devices_};
}

template <class S>
std::size_t Subdomain<S>::bytes() const {
  return (plan_ ? plan_->bytes() : 0) + (corners_ ? corners_->bytes() : 0) + common_.bytes() + sharers_.bytes() +
         is_alive_.capacity();
}

template class Subdomain<double>;
template class Subdomain<float>;

}  // namespace pinball

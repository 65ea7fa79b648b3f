#include "resting_tiles.hpp"

#include <algorithm>
#include <cmath>

#include <kernels/exec.hpp>
#include <kernels/simd.hpp>

namespace pinball {

namespace {

/// Whether nodes have another velocity than `expected`, or one that is not a number.
template <class S>
bool differ(const S* velocities, const NodeRange& nodes, const S* expected) {
  const S* v = record(velocities, nodes.first);
  const S* end = record(velocities, nodes.end);
  if constexpr (native_width<S> >= 4) {  // a record is a pack, of which the fourth number is not used
    using T = Pack<S, 4>;
    const T numbers = load<T>(expected);
    MaskOf<T> other(false);
    for (; v != end; v += 4) other = other || load<T>(v) != numbers;
    return any_lane(other && lane_numbers<T>() < T(3));
  } else {
    bool other = false;
    for (; v != end; v += 4) other = other || v[0] != expected[0] || v[1] != expected[1] || v[2] != expected[2];
    return other;
  }
}

std::vector<NodeRange> ranges_of(std::vector<std::int32_t> nodes) {
  std::sort(nodes.begin(), nodes.end());
  std::vector<NodeRange> ranges;
  for (const std::int32_t node : nodes) {
    if (!ranges.empty() && node < ranges.back().end) continue;  // again
    if (ranges.empty() || node > ranges.back().end) ranges.push_back({node, node});
    ranges.back().end = node + 1;
  }
  ranges.shrink_to_fit();
  return ranges;
}

/// Elements of a tile; 0 if one of them is eroded.
template <class S>
std::int32_t whole_elements(const Model<S>& model, std::int64_t first_slot, std::int64_t last_slot) {
  std::int32_t count = 0;
  for (std::int64_t slot = first_slot; slot < last_slot; ++slot) {
    if (model.element_of_slot[slot] < 0) continue;
    if (!(model.elements.mass[slot] > 0)) return 0;
    ++count;
  }
  return count;
}

/// Whether the elements of some slots carry no stress and are as they were at first.
bool untouched(const ElementStore& elements, std::int64_t first_slot, std::int64_t last_slot) {
  const auto vanishes = [&](const RealArray& array, std::int64_t components) {
    return array.visit([&](const auto& numbers) {
      return numbers.empty() || std::all_of(numbers.data() + components * first_slot,
                                            numbers.data() + components * last_slot, [](auto n) { return n == 0; });
    });
  };
  return vanishes(elements.stress, 6) && vanishes(elements.plastic_strain, 1) &&
         vanishes(elements.hourglass_state, 12) && vanishes(elements.viscous_stress, 1) &&
         vanishes(elements.material_state, elements.material_numbers);
}

}  // namespace

template <class S>
RestingTiles<S>::RestingTiles(const Model<S>& model, const Subdomain<S>* domain)
    : tiles_(model.tile_part.size()), rests_(model.tile_part.size(), 0) {
  const S* velocities = model.nodes.velocity.data();
  parallel_for("tiles at rest", RangePolicy<>{0, model.tile_count()}, [&](std::int64_t number) {
    const std::size_t t = number;
    tiles_[t].number = number;
    if (model.is_rigid(number) || (domain != nullptr && !domain->works(number))) return;
    if (std::isfinite(model.constants[model.tile_part[t]].failure.limits.time)) return;
    if (model.constants[model.tile_part[t]].averaged_volumes) return;
    if (model.constants[model.tile_part[t]].foam.air_pressure > 0) return;  // presses with what volumes are rounded by
    const std::int64_t first_slot = model.tile_packs[t] * model.elements.width;
    const std::int64_t last_slot = model.tile_packs[t + 1] * model.elements.width;
    const std::int32_t* first = model.elements.corner.data() + 8 * first_slot;
    const std::int32_t* last = model.elements.corner.data() + 8 * last_slot;
    const S* const expected = record(velocities, *first);
    const auto moves = [&](std::int32_t node) { return differ(velocities, {node, node + 1}, expected); };
    if (std::any_of(first, last, moves)) return;  // found by its first elements, most often
    const std::int32_t elements = whole_elements(model, first_slot, last_slot);
    if (elements == 0 || !untouched(model.elements, first_slot, last_slot)) return;
    tiles_[t].elements = elements;
    tiles_[t].nodes = ranges_of({first, last});
    rests_[t] = 1;
  });
  drop_awake();
}

template <class S>
RestingTiles<S>::RestingTiles(const Model<S>& model, const std::vector<std::uint8_t>& rests, const Subdomain<S>* domain)
    : tiles_(rests.size()), rests_(rests) {
  for (std::size_t t = 0; t < tiles_.size(); ++t) {
    tiles_[t].number = t;
    if (rests_[t] == 0) continue;
    const std::int64_t first_slot = model.tile_packs[t] * model.elements.width;
    const std::int64_t last_slot = model.tile_packs[t + 1] * model.elements.width;
    const std::int32_t* corner = model.elements.corner.data();
    tiles_[t].elements = whole_elements(model, first_slot, last_slot);
    tiles_[t].nodes = ranges_of({corner + 8 * first_slot, corner + 8 * last_slot});
  }
  if (domain != nullptr) std::erase_if(tiles_, [domain](const Tile& tile) { return !domain->works(tile.number); });
  drop_awake();
}

template <class S>
bool RestingTiles<S>::wake(const NodeStore<S>& nodes) {
  const S* velocities = nodes.velocity.data();
  parallel_for("tiles at rest", RangePolicy<>{0, std::ssize(tiles_)}, [&](std::int64_t i) {
    const Tile& tile = tiles_[i];
    const S* const expected = record(velocities, tile.nodes.front().first);
    const auto moves = [&](const NodeRange& range) { return differ(velocities, range, expected); };
    if (std::any_of(tile.nodes.begin(), tile.nodes.end(), moves)) rests_[tile.number] = 0;
  });
  const std::size_t before = tiles_.size();
  drop_awake();
  return tiles_.size() < before;
}

template <class S>
void RestingTiles<S>::drop_awake() {
  std::erase_if(tiles_, [&](const Tile& tile) { return !rests(tile.number); });
  elements_ = 0;
  for (const Tile& tile : tiles_) elements_ += tile.elements;
}

template <class S>
std::size_t RestingTiles<S>::bytes() const {
  std::size_t sum = tiles_.capacity() * sizeof(Tile) + rests_.capacity();
  for (const Tile& tile : tiles_) sum += tile.nodes.capacity() * sizeof(NodeRange);
  return sum;
}

template class RestingTiles<double>;
template class RestingTiles<float>;

}  // namespace pinball

#include <pinball/solver/neighbour_list.hpp>

#include <algorithm>

#include <pinball/kernels/exec.hpp>

namespace pinball {

template <class S>
bool NeighbourList<S>::may_touch(const PinballStore<S>& pinballs, std::int32_t i, std::int32_t j,
                                 const SameBody& same_body) const {
  constexpr int W = native_width<S>;
  const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
  if (pinballs.body[a] != pinballs.body[b]) return true;
  if (!same_body.allowed) return false;
  // Elements that share a node are kept apart by the mesh.
  const auto corner = [&pinballs](std::int32_t p, int c) {
    return pinballs.corner[static_cast<std::size_t>((p / W * 8 + c) * W + p % W)];
  };
  for (int m = 0; m < 8; ++m) {
    for (int n = 0; n < 8; ++n) {
      if (corner(i, m) == corner(j, n)) return false;
    }
  }
  // Balls of flat elements may overlap from the start; such a pair says nothing about contact.
  const std::array<float, 3>& p = (*same_body.reference_centre)[static_cast<std::size_t>(pinballs.slot[a])];
  const std::array<float, 3>& q = (*same_body.reference_centre)[static_cast<std::size_t>(pinballs.slot[b])];
  float d2 = 0;
  for (std::size_t k = 0; k < 3; ++k) d2 += (p[k] - q[k]) * (p[k] - q[k]);
  const auto reach = static_cast<float>(pinballs.centre[4 * a + 3] + pinballs.centre[4 * b + 3]);
  return d2 > 1.0001f * reach * reach;
}

template <class S>
void NeighbourList<S>::build(const PinballStore<S>& pinballs, S skin, const SameBody& same_body) {
  constexpr int W = native_width<S>;
  const std::int32_t n = pinballs.count;
  const auto size = static_cast<std::size_t>(n);
  // The old list, to carry the offsets over: pinball numbers may have changed, slots have not.
  const std::vector<std::int64_t> old_start = std::move(start_);
  const std::vector<std::int32_t> old_count = std::move(count_), old_neighbour = std::move(neighbour_);
  const std::vector<std::int32_t> old_slot = std::move(slot_);
  const AlignedArray<S> old_offset = std::move(offset_), old_stored = std::move(stored_);

  skin_ = skin;
  valid_ = true;
  pairs_ = 0;
  start_.assign(size + 1, 0);
  count_.assign(size, 0);
  built_at_.assign(pinballs.centre.data(), pinballs.centre.data() + 4 * size);
  neighbour_.clear();
  slot_ = pinballs.slot;
  if (n == 0) return;

  S largest = 0;
  for (std::size_t i = 0; i < size; ++i) largest = std::max(largest, pinballs.centre[4 * i + 3]);
  const double cell_size = static_cast<double>(2 * largest + skin) * 1.000001;
  int bits = 1;
  while ((std::int64_t(1) << bits) < 2 * std::int64_t(n) && bits < 30) ++bits;
  bucket_start_.resize((std::size_t(1) << bits) + 1);
  entry_cell_.resize(size);
  entry_point_.resize(size);
  cell_.resize(size);
  const S* centre = pinballs.centre.data();
  const SpatialHashView hash{{{static_cast<double>(centre[0]), static_cast<double>(centre[1]),
                               static_cast<double>(centre[2])},
                              1.0 / cell_size},
                             bits,
                             bucket_start_.data(),
                             entry_cell_.data(),
                             entry_point_.data()};
  build_spatial_hash(hash, centre, 4, n, cell_.data());

  const auto for_each_candidate = [&](std::int32_t i, const auto& accept) {
    const S* own = centre + 4 * static_cast<std::int64_t>(i);
    for_each_near(hash, own, [&](std::int32_t j) {
      const S* other = centre + 4 * static_cast<std::int64_t>(j);
      const S x = own[0] - other[0], y = own[1] - other[1], z = own[2] - other[2];
      const S reach = own[3] + other[3] + skin;
      if (x * x + y * y + z * z < reach * reach && i != j && may_touch(pinballs, i, j, same_body)) accept(j);
    });
  };
  parallel_for("count neighbours", RangePolicy<>{0, n}, [&](std::int64_t i) {
    std::int32_t found = 0;
    for_each_candidate(static_cast<std::int32_t>(i), [&found](std::int32_t) { ++found; });
    count_[static_cast<std::size_t>(i)] = found;
  });
  for (std::size_t i = 0; i < size; ++i) {
    pairs_ += count_[i];
    start_[i + 1] = start_[i] + (count_[i] + W - 1) / W * W;
  }
  pairs_ /= 2;
  neighbour_.resize(static_cast<std::size_t>(start_[size]));
  parallel_for("fill neighbours", RangePolicy<>{0, n}, [&](std::int64_t i) {
    std::int32_t* place = neighbour_.data() + start_[static_cast<std::size_t>(i)];
    std::int32_t* const end = neighbour_.data() + start_[static_cast<std::size_t>(i) + 1];
    for_each_candidate(static_cast<std::int32_t>(i), [&place](std::int32_t j) { *place++ = j; });
    while (place < end) *place++ = static_cast<std::int32_t>(i);
  });

  offset_ = AlignedArray<S>(neighbour_.size());
  stored_ = AlignedArray<S>(neighbour_.size());
  parallel_for("carry offsets", RangePolicy<>{0, n}, [&](std::int64_t i) {
    const auto p = static_cast<std::size_t>(i);
    const auto found = std::lower_bound(old_slot.begin(), old_slot.end(), slot_[p]);
    const bool known = found != old_slot.end() && *found == slot_[p];
    const auto old = static_cast<std::size_t>(found - old_slot.begin());
    for (std::int64_t e = start_[p]; e < start_[p + 1]; ++e) {
      S& offset = offset_[static_cast<std::size_t>(e)];
      offset = S(-1);
      if (!known || e >= start_[p] + count_[p]) continue;
      const std::int32_t slot = slot_[static_cast<std::size_t>(neighbour_[static_cast<std::size_t>(e)])];
      for (std::int64_t k = old_start[old]; k < old_start[old] + old_count[old]; ++k) {
        const auto entry = static_cast<std::size_t>(k);
        if (old_offset[entry] >= S(0) && old_slot[static_cast<std::size_t>(old_neighbour[entry])] == slot) {
          offset = old_offset[entry];
          stored_[static_cast<std::size_t>(e)] = old_stored[entry];
        }
      }
    }
  });
}

template <class S>
bool NeighbourList<S>::holds(const PinballStore<S>& pinballs) const {
  if (!valid_) return false;
  S moved2 = 0;
  const S* centre = pinballs.centre.data();
  const S* before = built_at_.data();
  parallel_reduce(
      "distance moved", RangePolicy<>{0, pinballs.count}, moved2,
      [&](std::int64_t begin, std::int64_t end, S& largest) {
        for (std::int64_t i = begin; i < end; ++i) {
          S d2 = 0;
          for (std::int64_t k = 4 * i; k < 4 * i + 3; ++k) d2 += (centre[k] - before[k]) * (centre[k] - before[k]);
          largest = largest < d2 ? d2 : largest;
        }
      },
      [](S& result, const S& partial) { result = result < partial ? partial : result; });
  return 4 * moved2 <= skin_ * skin_;
}

template <class S>
double NeighbourList<S>::stored_in_lost_pairs(const std::function<bool(std::int32_t slot)>& gone) const {
  double sum = 0;
  for (std::size_t p = 0; p < slot_.size(); ++p) {
    const bool gone_itself = gone(slot_[p]);
    for (std::int64_t e = start_[p]; e < start_[p] + count_[p]; ++e) {
      const auto entry = static_cast<std::size_t>(e);
      if (!(stored_[entry] > S(0))) continue;
      if (gone_itself || gone(slot_[static_cast<std::size_t>(neighbour_[entry])])) {
        sum += static_cast<double>(stored_[entry]);
      }
    }
  }
  return sum;
}

template <class S>
std::size_t NeighbourList<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return of(start_) + of(count_) + of(neighbour_) + of(built_at_) + of(bucket_start_) + of(entry_point_) +
         of(entry_cell_) + of(cell_) + of(slot_) + offset_.bytes() + stored_.bytes();
}

template class NeighbourList<double>;
template class NeighbourList<float>;

}  // namespace pinball

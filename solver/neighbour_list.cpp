#include <algorithm>
#include <pinball/kernels/exec.hpp>
#include <pinball/solver/neighbour_list.hpp>

namespace pinball {

namespace {

/// Whether two elements have a corner in common.
bool share_corner(const std::array<std::int32_t, 8>& a, const std::array<std::int32_t, 8>& b) {
  std::int32_t equal = 0;
  for (const std::int32_t m : a) {
    for (const std::int32_t n : b) equal |= static_cast<std::int32_t>(m == n);
  }
  return equal != 0;
}

}  // namespace

template <class S>
void NeighbourList<S>::build(const PinballStore<S>& pinballs, S reach_factor, S skin, const SameBody& same_body) {
  constexpr int W = native_width<S>;
  const std::int32_t n = pinballs.count;
  const auto size = static_cast<std::size_t>(n);
  const std::vector<Memory> memory = remember();
  skin_ = skin;
  valid_ = true;
  pairs_ = 0;
  start_.assign(size + 1, 0);
  count_.assign(size, 0);
  neighbour_.clear();
  slot_ = pinballs.slot;
  const S* centre = pinballs.centre.data();
  built_at_.assign(centre, centre + 4 * size);
  if (n == 0) return;

  S largest = 0;
  for (std::size_t i = 0; i < size; ++i) largest = std::max(largest, centre[4 * i + 3]);
  const double cell_size = static_cast<double>(2 * reach_factor * largest + skin) * 1.000001;
  int bits = 1;
  while ((std::int64_t(1) << bits) < 2 * std::int64_t(n) && bits < 30) ++bits;
  bucket_start_.resize((std::size_t(1) << bits) + 1);
  entry_cell_.resize(size);
  entry_point_.resize(size);
  entry_record_.resize(4 * size);
  cell_.resize(size);
  const SpatialHashView<S> hash{
      {{static_cast<double>(centre[0]), static_cast<double>(centre[1]), static_cast<double>(centre[2])},
       1.0 / cell_size},
      bits,
      bucket_start_.data(),
      entry_cell_.data(),
      entry_point_.data(),
      entry_record_.data()};
  build_spatial_hash(hash, centre, n, cell_.data());

  const auto may_touch = [&](std::int32_t i, std::int32_t j) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    if (pinballs.body[a] != pinballs.body[b]) return true;
    // Elements that share a corner are kept apart by the mesh.
    if (!same_body.allowed || share_corner(pinballs.corners[a], pinballs.corners[b])) return false;
    // Balls of flat elements may overlap from the start; such a pair says nothing about contact.
    const std::array<float, 3>& p = (*same_body.reference_centre)[static_cast<std::size_t>(pinballs.slot[a])];
    const std::array<float, 3>& q = (*same_body.reference_centre)[static_cast<std::size_t>(pinballs.slot[b])];
    float d2 = 0;
    for (std::size_t k = 0; k < 3; ++k) d2 += (p[k] - q[k]) * (p[k] - q[k]);
    const auto reach = static_cast<float>(centre[4 * a + 3] + centre[4 * b + 3]);
    return d2 > 1.0001f * reach * reach;
  };

  // Pinballs are worked in fixed pieces, each with a list of its own; the lists are joined in order.
  constexpr std::int64_t pieces = 64;
  std::array<std::vector<std::int32_t>, pieces> found;
  parallel_for("neighbours", RangePolicy<>{0, pieces}, [&](std::int64_t piece) {
    std::vector<std::int32_t>& list = found[static_cast<std::size_t>(piece)];
    const auto end = static_cast<std::int32_t>(n * (piece + 1) / pieces);
    for (auto i = static_cast<std::int32_t>(n * piece / pieces); i < end; ++i) {
      const S* own = centre + 4 * static_cast<std::int64_t>(i);
      const auto before = list.size();
      for_each_near(hash, own, [&](std::int32_t j, const S* other) {
        const S x = own[0] - other[0], y = own[1] - other[1], z = own[2] - other[2];
        const S reach = reach_factor * (own[3] + other[3]) + skin;
        if (x * x + y * y + z * z < reach * reach && i != j && may_touch(i, j)) list.push_back(j);
      });
      count_[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(list.size() - before);
      std::sort(list.begin() + static_cast<std::ptrdiff_t>(before), list.end());
      while (list.size() % W != 0) list.push_back(i);
    }
  });
  for (std::size_t i = 0; i < size; ++i) {
    pairs_ += count_[i];
    start_[i + 1] = start_[i] + (count_[i] + W - 1) / W * W;
  }
  pairs_ /= 2;
  neighbour_.reserve(static_cast<std::size_t>(start_[size]));
  for (const std::vector<std::int32_t>& list : found) neighbour_.insert(neighbour_.end(), list.begin(), list.end());
  recall(memory);
}

template <class S>
std::vector<typename NeighbourList<S>::Memory> NeighbourList<S>::remember() const {
  std::vector<Memory> memory;
  for (std::size_t p = 0; p < count_.size(); ++p) {
    for (std::int64_t e = start_[p]; e < start_[p] + count_[p]; ++e) {
      const auto entry = static_cast<std::size_t>(e);
      if (offset_[entry] < S(0)) continue;
      memory.push_back({slot_[p], slot_[static_cast<std::size_t>(neighbour_[entry])], offset_[entry], stored_[entry]});
    }
  }
  return memory;
}

template <class S>
void NeighbourList<S>::recall(const std::vector<Memory>& memory) {
  offset_ = AlignedArray<S>(neighbour_.size());
  stored_ = AlignedArray<S>(neighbour_.size());
  std::fill(offset_.data(), offset_.data() + offset_.size(), S(-1));
  for (const Memory& m : memory) {
    const auto found = std::lower_bound(slot_.begin(), slot_.end(), m.slot);  // pinballs are in the order of slots
    if (found == slot_.end() || *found != m.slot) continue;
    const auto p = static_cast<std::size_t>(found - slot_.begin());
    for (std::int64_t e = start_[p]; e < start_[p] + count_[p]; ++e) {
      const auto entry = static_cast<std::size_t>(e);
      if (slot_[static_cast<std::size_t>(neighbour_[entry])] != m.other) continue;
      offset_[entry] = m.offset;
      stored_[entry] = m.stored;
    }
  }
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
double NeighbourList<S>::end_pairs_of_inactive(const PinballStore<S>& pinballs) {
  const auto inactive = [&pinballs](std::size_t p) { return !(pinballs.outward[4 * p + 3] > S(0)); };
  double sum = 0;
  for (std::size_t p = 0; p < count_.size(); ++p) {
    const bool itself = inactive(p);
    for (std::int64_t e = start_[p]; e < start_[p] + count_[p]; ++e) {
      const auto entry = static_cast<std::size_t>(e);
      if (offset_[entry] < S(0) || !(itself || inactive(static_cast<std::size_t>(neighbour_[entry])))) continue;
      sum += static_cast<double>(stored_[entry]);
      offset_[entry] = S(-1);
      stored_[entry] = S(0);
    }
  }
  return sum;
}

template <class S>
std::size_t NeighbourList<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return of(start_) + of(count_) + of(neighbour_) + of(built_at_) + of(bucket_start_) + of(entry_point_) +
         of(entry_cell_) + of(cell_) + of(slot_) + of(entry_record_) + offset_.bytes() + stored_.bytes();
}

template class NeighbourList<double>;
template class NeighbourList<float>;

}  // namespace pinball

#include "segment_features.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <kernels/exec.hpp>
#include <solver/base/lists_in_order.hpp>

namespace pinball {

template <class S>
void SegmentFeatures<S>::clear(std::size_t segments) {
  count_ = 0;
  place_.assign(segments, -1);
  asked_.assign(segments, 0);
  known_.assign(segments, 0);
}

template <class S>
void SegmentFeatures<S>::ask_for(std::int32_t segment) {
  set_mark(asked_[segment]);
}

/// A half more than is needed, if there are some: few come at a time. Pages are touched first by who fills them.
template <class S>
void SegmentFeatures<S>::make_room(std::int64_t kept) {
  if (static_cast<std::int64_t>(record_.size()) >= count_) return;
  if (kept == 0) {
    record_.renew(count_);
    return;
  }
  Array<Record> larger;
  larger.renew(count_ + count_ / 2);
  parallel_for("records that stay", RangePolicy<>{0, kept}, [&](std::int64_t i) { larger[i] = record_[i]; });
  record_ = std::move(larger);
}

/// Counts, scans and fills.
template <class S>
void SegmentFeatures<S>::collect(const FeatureBounds<S>& bounds, const SegmentSurface<S>& surface,
                                 const EdgeTable<S>& edges, FeaturesOf which) {
  const std::int64_t segments = place_.size();
  std::array<std::int64_t, fixed_pieces> next{};
  const auto for_each_new = [&](std::int64_t piece, const auto& work) {
    const std::int64_t end = segments * (piece + 1) / fixed_pieces;
    for (std::int64_t s = segments * piece / fixed_pieces; s < end; ++s) {
      if (asked_[s] != 0 && known_[s] == 0) work(static_cast<std::int32_t>(s));
    }
  };
  parallel_for("segments with features", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    for_each_new(piece, [&](std::int32_t segment) { next[piece] += place_[segment] < 0 ? 1 : 0; });
  });
  const std::int64_t kept = count_;
  for (std::int64_t& places : next) count_ += std::exchange(places, count_);
  make_room(kept);
  parallel_for("features of segments", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    for_each_new(piece, [&](std::int32_t segment) {
      if (place_[segment] < 0) place_[segment] = next[piece]++;
      known_[segment] = 1;
      fill(record_[place_[segment]], segment, bounds, surface, edges, which);
    });
  });
}

/// By the calling thread but for the records: what is looked at is as long as the pairs, not as the surface.
template <class S>
void SegmentFeatures<S>::collect_those_of(const PairOrder::Pieces& pairs, const FeatureBounds<S>& bounds,
                                          const SegmentSurface<S>& surface, const EdgeTable<S>& edges,
                                          FeaturesOf which) {
  few_.clear();
  const std::int64_t kept = count_;
  const auto take = [this](std::int32_t segment) {
    if (known_[segment] != 0) return;
    known_[segment] = 1;
    if (place_[segment] < 0) place_[segment] = count_++;
    few_.push_back(segment);
  };
  for (const PairColumns& some : pairs) {
    for (std::size_t pair = 0; pair < some.pairs; ++pair) {
      take(some.first[pair]);
      take(some.second[pair]);
    }
  }
  make_room(kept);
  constexpr std::int64_t numbers = sizeof(Record) / sizeof(S);
  for_all_of("features of few segments", std::ssize(few_), std::ssize(few_) * numbers,
             [&](std::int64_t i) { fill(record_[place_[few_[i]]], few_[i], bounds, surface, edges, which); });
}

template <class S>
void SegmentFeatures<S>::fill(Record& record, std::int32_t segment, const FeatureBounds<S>& bounds,
                              const SegmentSurface<S>& surface, const EdgeTable<S>& edges, FeaturesOf which) {
  constexpr int G = ball_group<S>;
  for (int c = 0; c < 12; ++c) std::fill_n(record.boxes + c * G, G, static_cast<S>(c % 6 < 3 ? HUGE_VAL : -HUGE_VAL));
  const std::array<std::int32_t, 4>& slaves = surface.slaves_of(segment);
  for (std::size_t k = 0; k < 4; ++k) {
    const std::int32_t slave = slaves[k];
    if (which == FeaturesOf::owner && surface.slaves()[slave].owner != segment) continue;
    if (std::find(slaves.begin(), slaves.begin() + k, slave) != slaves.begin() + k) continue;  // of a triangle
    put_box(bounds.node_box(slave), record.boxes, static_cast<std::int64_t>(k));
    record.facing[k] = bounds.facing_of_all(surface.around(slave));
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const std::int32_t edge = edges.edges_of(segment)[k];
    if (edge < 0 || (which == FeaturesOf::owner && owner_of(surface, edges, edge) != segment)) continue;
    put_box(bounds.edge_box(surface, edges, edge), record.boxes, static_cast<std::int64_t>(first_edge + k));
    record.facing[first_edge + k] = bounds.facing_of_all(edges.segments_of(edge));
  }
}

template <class S>
std::size_t SegmentFeatures<S>::bytes() const {
  return record_.bytes() + few_.capacity() * sizeof(few_[0]) + place_.capacity() * sizeof(place_[0]) +
         asked_.capacity() + known_.capacity();
}

template class SegmentFeatures<double>;
template class SegmentFeatures<float>;

}  // namespace pinball

#include "surface_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <kernels/exec.hpp>
#include <solver/base/records.hpp>

namespace pinball {

namespace {

// Allowances over skin times size. Where little happens a short one keeps neighbours of one surface out of the list.
constexpr double least = 0.1, most = 2.0;

}  // namespace

template <class S>
std::int64_t SurfaceMotion<S>::packs() const {
  return count_ / native_width<S>;
}

template <class S>
void SurfaceMotion<S>::adapt(const S* position, S elapsed, S horizon) {
  using T = Pack<S, native_width<S>>;
  constexpr std::size_t W = native_width<S>;
  if (!(elapsed > S(0))) return;
  const ExpectedNodes<S> expected = this->expected();
  // A steady force makes a node stray with the square of time.
  const S growth = 2 * std::max(S(1), horizon / elapsed * (horizon / elapsed));
  parallel_for("allowances", RangePolicy<>{0, packs()}, [&](std::int64_t pack) {
    const std::size_t first = pack * W;
    const T deviation = square_root(deviation2<T>(expected, position, elapsed, pack));
    for (std::size_t i = 0; i < W; ++i) {
      float& allowance = allowance_[node_[first + i]];
      allowance = std::max(0.5F * allowance, static_cast<float>(growth * lane(deviation, i)));
    }
  });
}

template <class S>
void SurfaceMotion<S>::put_started(std::size_t place, const S* position, const S* velocity, S elapsed) {
  constexpr std::size_t W = native_width<S>;
  S* const started = start_.data() + place / W * 6 * W + place % W;
  for (std::size_t k = 0; k < 3; ++k) {
    started[k * W] = record(position, node_[place])[k] - elapsed * record(velocity, node_[place])[k];
    started[(3 + k) * W] = record(velocity, node_[place])[k];
  }
}

template <class S>
void SurfaceMotion<S>::put_allowance(std::size_t place, S allowance, S skin) {
  const S unit = skin * size_[place];
  const S kept = allowance > S(least) * unit ? std::min(allowance, S(most) * unit) : S(least) * unit;
  const float rounded = allowance_[node_[place]] = static_cast<float>(kept);
  allowed2_[place] = static_cast<S>(rounded) * static_cast<S>(rounded);
}

template <class S>
void SurfaceMotion<S>::start(const S* position, const S* velocity, S skin) {
  constexpr std::size_t W = native_width<S>;
  while (node_.size() % W != 0) {  // padding repeats a node
    node_.push_back(node_.back());
    size_.push_back(size_.back());
  }
  if (count_ != node_.size()) {
    count_ = node_.size();
    start_.renew(6 * count_);
    allowed2_.renew(count_);
  }
  parallel_for("start of nodes", RangePolicy<>{0, packs()}, [&](std::int64_t pack) {
    for (std::size_t place = pack * W; place < (pack + 1) * W; ++place) {
      put_started(place, position, velocity, S(0));
      put_allowance(place, allowance_[node_[place]], skin);
    }
  });
}

template <class S>
ExpectedNodes<S> SurfaceMotion<S>::expected() const {
  return {static_cast<std::int64_t>(count_), node_.data(), start_.data(), allowed2_.data(), native_width<S>};
}

template <class S>
bool SurfaceMotion<S>::holds(const S* position, S elapsed) const {
  return !any_strays(expected(), position, elapsed);
}

template <class S>
bool any_strays(const ExpectedNodes<S>& nodes, const S* position, S elapsed) {
  using T = Pack<S, native_width<S>>;
  const std::int64_t packs = nodes.count / width_of<T>;
  return first_where("deviations", packs, NodesStray<T>{nodes, position, elapsed}) < packs;
}

template <class S>
void SurfaceMotion<S>::find_strayed(const S* position, S elapsed, std::vector<std::int32_t>& places) const {
  using T = Pack<S, native_width<S>>;
  constexpr std::size_t W = native_width<S>;
  const ExpectedNodes<S> expected = this->expected();
  std::array<std::vector<std::int32_t>, fixed_pieces> found;
  parallel_for("nodes that strayed", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    const std::int64_t end = packs() * (piece + 1) / fixed_pieces;
    for (std::int64_t pack = packs() * piece / fixed_pieces; pack < end; ++pack) {
      const std::size_t first = pack * W;
      unsigned bits = strayed<T>(expected, position, elapsed, pack);
      for (; bits != 0; bits &= bits - 1) found[piece].push_back(first + __builtin_ctz(bits));
    }
  });
  places.clear();
  for (const auto& some : found) places.insert(places.end(), some.begin(), some.end());
  const auto is_padding = [&](std::int32_t place) { return place > 0 && node_[place] == node_[place - 1]; };
  std::erase_if(places, is_padding);
}

/// A node that has strayed is likely to go on: it may stray as much again, or, as a steady force would have it, more.
template <class S>
void SurfaceMotion<S>::restart(std::span<const std::int32_t> places, const S* position, const S* velocity, S skin,
                               S elapsed, S horizon) {
  const S growth = 2 * std::max(S(1), horizon / elapsed * (horizon / elapsed));
  for (const std::int32_t of : places) {
    const std::size_t first = of;
    const std::int32_t node = node_[first];
    const Vec3<S> strayed = vector_of(record(position, node)) - start_position(first) - elapsed * start_velocity(first);
    const S allowance = growth * square_root(dot(strayed, strayed));
    for (std::size_t place = first; place < count_ && node_[place] == node; ++place) {  // padding, too
      put_started(place, position, velocity, elapsed);
      put_allowance(place, allowance, skin);
    }
  }
}

template <class S>
void SurfaceMotion<S>::put_start(Array<S>& position, Array<S>& velocity) const {
  constexpr std::size_t W = native_width<S>;
  position.reset(4 * allowance_.size());
  velocity.reset(4 * allowance_.size());
  for (std::size_t n = 0; n < count_; ++n) {
    const S* const started = start_.data() + n / W * 6 * W + n % W;
    for (std::size_t k = 0; k < 3; ++k) {
      record(position.data(), node_[n])[k] = started[k * W];
      record(velocity.data(), node_[n])[k] = started[(3 + k) * W];
    }
  }
}

template <class S>
void SurfaceMotion<S>::persist(StateArchive& archive, std::int32_t node_count, bool watched) {
  std::uint64_t count = count_;
  archive(count, node_, size_, start_, allowed2_, allowance_);
  if (!archive.reads()) return;
  count_ = count;
  const bool knows_nodes = std::ssize(allowance_) == node_count;
  archive.require(knows_nodes || (allowance_.empty() && node_.empty() && !watched));
  archive.require(count_ % native_width<S> == 0 && (count_ == 0 || count_ == node_.size()));
  archive.require(size_.size() == node_.size() && start_.size() == 6 * count_ && allowed2_.size() == count_);
  archive.require_all(node_, 0, node_count);
}

template <class S>
std::size_t SurfaceMotion<S>::bytes() const {
  return node_.capacity() * (sizeof(node_[0]) + sizeof(S)) + allowance_.capacity() * sizeof(float) + start_.bytes() +
         allowed2_.bytes();
}

template class SurfaceMotion<double>;
template class SurfaceMotion<float>;
template bool any_strays(const ExpectedNodes<double>&, const double*, double);
template bool any_strays(const ExpectedNodes<float>&, const float*, float);

}  // namespace pinball

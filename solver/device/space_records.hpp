#pragma once

#include <cstdint>
#include <vector>

#include <solver/boundary/space/loops.hpp>

#include "device_step.hpp"

/// Numbers of some nodes and elements, which cross between a device and the host by lists.
namespace pinball {

/// Records of four numbers per node that cross over: positions, velocities and forces, or some of these.
template <class S>
struct CommonRecords {
  static constexpr int most = 3;
  S* of[most];
  int count = 0;

  CommonRecords(NodeNumbers which, S* position, S* velocity, S* force) : of{} {
    if (has(which, NodeNumbers::motion)) {
      of[count++] = position;
      of[count++] = velocity;
    }
    if (has(which, NodeNumbers::force)) of[count++] = force;
  }
};

/// Those of the nodes of a list, one after the other: of all nodes the first kind, and so on.
template <class S>
struct GathersRecords {
  std::int64_t nodes;
  const std::int32_t* node;
  CommonRecords<S> from;
  S* to;
  PINBALL_FUNCTION void operator()(std::int64_t i) const {
    PINBALL_UNROLL
    for (int r = 0; r < CommonRecords<S>::most; ++r) {
      if (r >= from.count) return;
      const S* const record = from.of[r] + 4 * static_cast<std::int64_t>(node[i]);
      for (int k = 0; k < 4; ++k) to[4 * (r * nodes + i) + k] = record[k];
    }
  }
};

/// The way back. No node is twice in a list.
template <class S>
struct ScattersRecords {
  std::int64_t nodes;
  const std::int32_t* node;
  const S* from;
  CommonRecords<S> to;
  PINBALL_FUNCTION void operator()(std::int64_t i) const {
    PINBALL_UNROLL
    for (int r = 0; r < CommonRecords<S>::most; ++r) {
      if (r >= to.count) return;
      S* const record = to.of[r] + 4 * static_cast<std::int64_t>(node[i]);
      for (int k = 0; k < 4; ++k) record[k] = from[4 * (r * nodes + i) + k];
    }
  }
};

/// The common nodes of a step (StepSpace), or the listed ones: lists and messages.
template <class S, class Space>
class SpaceRecords {
  using Memory = typename Space::memory_space;

 public:
  void set(const std::vector<std::int32_t>& nodes) { node_ = list_in<Space>(nodes); }
  void read(const CommonRecords<S>& from, Array<S>& numbers) {
    numbers_.renew(4 * from.count * node_.size());
    parallel_for("numbers of common nodes", all(), GathersRecords<S>{all().end, node_.data(), from, numbers_.data()});
    numbers.renew(numbers_.size());
    deep_copy(numbers, numbers_);
  }
  void write(const Array<S>& numbers, const CommonRecords<S>& to) {
    numbers_.renew(numbers.size());
    deep_copy(numbers_, numbers);
    parallel_for("numbers of common nodes", all(), ScattersRecords<S>{all().end, node_.data(), numbers_.data(), to});
  }
  std::size_t bytes() const { return node_.bytes() + numbers_.bytes(); }

 private:
  RangePolicy<Space> all() const { return {0, static_cast<std::int64_t>(node_.size())}; }

  Array<std::int32_t, Memory> node_;
  Array<S, Memory> numbers_;  ///< that cross over
};

/// Whether the element of a place has lost its mass since it was looked for last.
template <class S>
struct HasEroded {
  const S* mass;
  const std::uint8_t* alive;
  PINBALL_FUNCTION bool of(std::int64_t place) const { return alive[place] != 0 && !(mass[place] > S(0)); }
};

template <class S>
struct CountsEroded {
  HasEroded<S> eroded;
  PINBALL_FUNCTION void operator()(std::int64_t place, std::int64_t& count) const { count += eroded.of(place) ? 1 : 0; }
};

/// Takes them out of those that are alive.
template <class S>
struct ListsEroded {
  HasEroded<S> eroded;
  std::uint8_t* alive;
  std::int64_t* list;
  PINBALL_FUNCTION void operator()(std::int64_t place, std::int64_t& count, bool final) const {
    if (!eroded.of(place)) return;
    if (final) {
      list[count] = place;
      alive[place] = 0;
    }
    ++count;
  }
};

template <class S>
struct MarksAlive {
  const S* mass;
  std::uint8_t* alive;
  PINBALL_FUNCTION void operator()(std::int64_t place) const { alive[place] = mass[place] > S(0) ? 1 : 0; }
};

template <class S>
struct GathersNumbers {
  const std::int64_t* place;
  const S* from;
  S* to;
  PINBALL_FUNCTION void operator()(std::int64_t i) const { to[i] = from[place[i]]; }
};

/// Those of an array of the space that stand at some places.
template <class Space, class S>
std::vector<S> numbers_at(const std::vector<std::int64_t>& places, const S* array) {
  using Memory = typename Space::memory_space;
  const Array<std::int64_t, Memory> list = list_in<Space>(places);
  Array<S, Memory> gathered;
  gathered.renew(places.size());
  parallel_for("numbers of elements", RangePolicy<Space>{0, std::ssize(places)},
               GathersNumbers<S>{list.data(), array, gathered.data()});
  std::vector<S> numbers(places.size());
  deep_copy(numbers.data(), gathered);
  return numbers;
}

/// Which elements have eroded since anybody asked.
template <class S, class Space>
class SpaceEroded {
  using Memory = typename Space::memory_space;

 public:
  void begin(const Array<S, Memory>& mass) {
    alive_.renew(mass.size());
    parallel_for("elements", RangePolicy<Space>{0, std::ssize(alive_)}, MarksAlive<S>{mass.data(), alive_.data()});
  }
  /// Their places, ascending.
  std::vector<std::int64_t> take(const S* mass) {
    const HasEroded<S> eroded{mass, alive_.data()};
    const RangePolicy<Space> all{0, std::ssize(alive_)};
    std::int64_t count = 0;
    parallel_reduce("eroded elements", all, CountsEroded<S>{eroded}, count);
    Array<std::int64_t, Memory> list(count);
    std::int64_t listed = 0;
    parallel_scan("eroded elements", all, ListsEroded<S>{eroded, alive_.data(), list.data()}, listed);
    std::vector<std::int64_t> places(count);
    deep_copy(places.data(), list);
    return places;
  }
  std::size_t bytes() const { return alive_.bytes(); }

 private:
  Array<std::uint8_t, Memory> alive_;  ///< per place
};

}  // namespace pinball

#pragma once

#include <cstdint>
#include <vector>

#include <solver/boundary/space/loops.hpp>

#include "device_step.hpp"

/// Numbers of some nodes and elements, which cross between a device and the host by lists.
namespace pinball {

/// Records of four numbers: of the nodes of a list, one after the other.
template <class S>
struct GathersRecords {
  const std::int32_t* node;
  const S* from;
  S* to;
  PINBALL_FUNCTION void operator()(std::int64_t i) const {
    const S* const record = from + 4 * static_cast<std::int64_t>(node[i]);
    for (int k = 0; k < 4; ++k) to[4 * i + k] = record[k];
  }
};

/// The way back. No node is twice in a list.
template <class S>
struct ScattersRecords {
  const std::int32_t* node;
  const S* from;
  S* to;
  PINBALL_FUNCTION void operator()(std::int64_t i) const {
    S* const record = to + 4 * static_cast<std::int64_t>(node[i]);
    for (int k = 0; k < 4; ++k) record[k] = from[4 * i + k];
  }
};

/// The common nodes of a step (StepSpace): lists and messages.
template <class S, class Space>
class SpaceRecords {
  using Memory = typename Space::memory_space;

 public:
  void set(const std::vector<std::int32_t>& nodes) {
    node_ = list_in<Space>(nodes);
    motion_.renew(8 * nodes.size());
    force_.renew(4 * nodes.size());
  }
  void read_motion(const S* position, const S* velocity, Array<S>& numbers) {
    gather(position, motion_.data());
    gather(velocity, motion_.data() + 4 * node_.size());
    bring(motion_, numbers);
  }
  void read_force(const S* force, Array<S>& numbers) {
    gather(force, force_.data());
    bring(force_, numbers);
  }
  void write_motion(const Array<S>& numbers, S* position, S* velocity) {
    deep_copy(motion_, numbers);
    scatter(motion_.data(), position);
    scatter(motion_.data() + 4 * node_.size(), velocity);
  }
  void write_force(const Array<S>& numbers, S* force) {
    deep_copy(force_, numbers);
    scatter(force_.data(), force);
  }
  std::size_t bytes() const { return node_.bytes() + motion_.bytes() + force_.bytes(); }

 private:
  RangePolicy<Space> all() const { return {0, static_cast<std::int64_t>(node_.size())}; }
  void gather(const S* from, S* to) const {
    parallel_for("numbers of common nodes", all(), GathersRecords<S>{node_.data(), from, to});
  }
  void scatter(const S* from, S* to) const {
    parallel_for("numbers of common nodes", all(), ScattersRecords<S>{node_.data(), from, to});
  }
  static void bring(const Array<S, Memory>& from, Array<S>& to) {
    to.renew(from.size());
    deep_copy(to, from);
  }

  Array<std::int32_t, Memory> node_;
  Array<S, Memory> motion_;  ///< positions, and then velocities
  Array<S, Memory> force_;
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

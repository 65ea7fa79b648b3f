#pragma once

#include <solver/boundary/space/loops.hpp>
#include <solver/contact/algorithm/pinball_kernels.hpp>

#include "pinball_entries.hpp"

/// PinballKernels on the execution space of a device: a thread for each pinball, pair and node.
namespace pinball {

/// Whether any number of a range is one.
struct AnyOf {
  std::uint32_t any = 0;
  PINBALL_FUNCTION void join(const AnyOf& other) { any |= other.any; }
};
template <class Is>
struct LooksForAny {
  Is is;
  PINBALL_FUNCTION void operator()(std::int64_t i, AnyOf& found) const { found.any |= is(i) ? 1U : 0U; }
};

/// EntryLists in the memory of a space.
template <class Space>
class SpaceEntries {
 public:
  void take(const EntryLists& lists) {
    first_ = list_in<Space>(lists.first);
    entry_ = list_in<Space>(lists.entry);
  }
  EntriesOf view() const { return {first_.data(), entry_.data()}; }
  std::size_t bytes() const { return first_.bytes() + entry_.bytes(); }

 private:
  Array<std::uint32_t, typename Space::memory_space> first_, entry_;
};

template <class S, class Space>
class SpacePinballs final : public PinballKernels<S> {
  using Memory = typename Space::memory_space;

 public:
  void take(const PinballArrays<S>& arrays) override {
    host_ = arrays;
    changed_ = false;
    const std::int64_t padded = arrays.packs() * arrays.geometry.row, places = arrays.pairs.places;
    put(arrays.geometry.corner, 8 * padded, corner_);
    put(arrays.geometry.exposed, 6 * padded, exposed_);
    put(arrays.geometry.bulk_modulus, padded, bulk_modulus_);
    put(arrays.geometry.centre, 4 * padded, centre_);
    put(arrays.geometry.velocity, 4 * padded, velocity_);
    put(arrays.geometry.outward, 4 * padded, outward_);
    put(arrays.geometry.two_sided, 4 * padded, two_sided_);
    put(arrays.force, 4 * padded, force_);
    put(arrays.pairs.first, places, first_);
    put(arrays.pairs.second, places, second_);
    put(arrays.pairs.offset, places, offset_);
    put(arrays.pairs.stored, places, stored_);
    pair_force_.renew(4 * places);
    pairs_of_.take(entries_of_pinballs(arrays.pieces, arrays.pairs.first, arrays.pairs.second, arrays.pinballs));
    put(arrays.nodes.data(), std::ssize(arrays.nodes), node_);
    pinballs_of_.take(node_entries_.of(arrays.nodes, arrays.node_count, arrays.geometry.corner, arrays.geometry.row,
                                       arrays.tile_first, arrays.tiles));
    put(arrays.expected.node, arrays.expected.count, expected_node_);
    put(arrays.expected.start, 6 * arrays.expected.count, start_);
    put(arrays.expected.allowed2, arrays.expected.count, allowed2_);
    put(arrays.corner, 8 * std::int64_t(arrays.balls), ball_corner_);
    put(arrays.radius, arrays.balls, radius_);
  }

  void bring_back() override {
    if (!changed_) return;
    changed_ = false;
    deep_copy(host_.geometry.centre, centre_);
    deep_copy(host_.geometry.outward, outward_);
    deep_copy(host_.force, force_);
    deep_copy(host_.pairs.offset, offset_);
    deep_copy(host_.pairs.stored, stored_);
  }

  void update_geometry(const SurfaceNodes<S>& nodes, bool radii) override {
    changed_ = true;
    if (radii) {
      parallel_for("pinballs", all(host_.pinballs),
                   UpdatePinballs<S, true>{geometry(), nodes.position, nodes.velocity});
    } else {
      parallel_for("pinballs", all(host_.pinballs),
                   UpdatePinballs<S, false>{geometry(), nodes.position, nodes.velocity});
    }
  }

  bool any_strays(const SurfaceNodes<S>& nodes, S elapsed) override {
    const ExpectedNodes<S> expected{host_.expected.count, expected_node_.data(), start_.data(), allowed2_.data(),
                                    host_.expected.row};
    return is_any("deviations", expected.count, NodesStray<S>{expected, nodes.position, elapsed});
  }
  bool any_grows(const SurfaceNodes<S>& nodes, S most) override {
    return is_any("radii", host_.balls, BallsGrow<S>{ball_corner_.data(), radius_.data(), nodes.position, most});
  }

  PairSums<S> find_forces(const PenaltyConstants<S>& constants, S dt) override {
    PairSums<S> sums;
    if (host_.pairs.places == 0) return sums;
    changed_ = true;
    const ListedPairs<S> pairs{host_.pairs.places, first_.data(), second_.data(), offset_.data(), stored_.data()};
    parallel_reduce("contact forces", all(pairs.places),
                    FindPairForces<S>{pinballs_of(geometry()), constants, pairs, pair_force_.data(), dt}, sums);
    parallel_for("contact force sums", all(host_.pinballs),
                 SumPairForces<S>{pairs_of_.view(), offset_.data(), pair_force_.data(), force_.data()});
    return sums;
  }

  void add_forces(const SurfaceNodes<S>& nodes) override {
    parallel_reduce("contact scatter", all(host_.nodes.size()),
                    LoadNodes<S>{node_.data(), pinballs_of_.view(), force_.data(), nodes.force, nodes.inverse_mass},
                    largest_);
  }
  S largest_row(const SurfaceNodes<S>& /*nodes*/) override { return largest_.number; }

  std::size_t bytes() const override {
    return corner_.bytes() + exposed_.bytes() + bulk_modulus_.bytes() + centre_.bytes() + velocity_.bytes() +
           outward_.bytes() + two_sided_.bytes() + force_.bytes() + first_.bytes() + second_.bytes() + offset_.bytes() +
           stored_.bytes() + pair_force_.bytes() + pairs_of_.bytes() + node_.bytes() + pinballs_of_.bytes() +
           expected_node_.bytes() + start_.bytes() + allowed2_.bytes() + ball_corner_.bytes() + radius_.bytes();
  }

 private:
  static RangePolicy<Space> all(std::int64_t count) { return {0, count}; }
  template <class T>
  static void put(const T* numbers, std::int64_t count, Array<std::remove_const_t<T>, Memory>& to) {
    to.renew(count);
    deep_copy(to, numbers, count);
  }
  template <class Is>
  static bool is_any(const char* name, std::int64_t count, const Is& is) {
    AnyOf found;
    parallel_reduce(name, all(count), LooksForAny<Is>{is}, found);
    return found.any != 0;
  }
  PinballGeometryView<S> geometry() {
    return {corner_.data(),   exposed_.data(), bulk_modulus_.data(), centre_.data(),
            velocity_.data(), outward_.data(), two_sided_.data(),    host_.geometry.row};
  }

  PinballArrays<S> host_;  ///< as it was taken
  bool changed_ = false;   ///< what bring_back() brings, since then
  Array<std::int32_t, Memory> corner_;
  Array<S, Memory> exposed_, bulk_modulus_, centre_, velocity_, outward_, two_sided_, force_;
  Array<std::int32_t, Memory> first_, second_;
  Array<S, Memory> offset_, stored_, pair_force_;
  SpaceEntries<Space> pairs_of_;  ///< of each pinball
  Array<std::int32_t, Memory> node_;
  SpaceEntries<Space> pinballs_of_;  ///< of each of these nodes
  NodeEntries node_entries_;
  Array<std::int32_t, Memory> expected_node_;
  Array<S, Memory> start_, allowed2_;
  Array<std::int32_t, Memory> ball_corner_;
  Array<S, Memory> radius_;
  LargestOf<S> largest_;
};

}  // namespace pinball

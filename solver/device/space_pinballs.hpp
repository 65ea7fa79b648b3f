#pragma once

#include <solver/boundary/space/loops.hpp>
#include <solver/contact/algorithm/pinball_kernels.hpp>

#include "packed_arrays.hpp"
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

template <class S, class Space>
class SpacePinballs final : public PinballKernels<S> {
  using Memory = typename Space::memory_space;

 public:
  void take(const PinballArrays<S>& arrays) override {
    host_ = arrays;
    changed_ = false;
    const std::int64_t padded = arrays.packs() * arrays.geometry.row, places = arrays.pairs.places;
    const EntryLists pairs =
        entries_of_pinballs(arrays.pieces, arrays.pairs.first, arrays.pairs.second, arrays.pinballs);
    const EntryLists pinballs = node_entries_.of(arrays.nodes, arrays.node_count, arrays.geometry.corner,
                                                 arrays.geometry.row, arrays.tile_first, arrays.tiles);
    packed_.clear();
    centre_ = packed_.add_for_both(arrays.geometry.centre, 4 * padded);
    outward_ = packed_.add_for_both(arrays.geometry.outward, 4 * padded);
    force_ = packed_.add_for_both(arrays.force, 4 * padded);
    offset_ = packed_.add_for_both(arrays.pairs.offset, places);
    stored_ = packed_.add_for_both(arrays.pairs.stored, places);
    corner_ = packed_.add(arrays.geometry.corner, 8 * padded);
    exposed_ = packed_.add(arrays.geometry.exposed, 6 * padded);
    bulk_modulus_ = packed_.add(arrays.geometry.bulk_modulus, padded);
    velocity_ = packed_.add(arrays.geometry.velocity, 4 * padded);
    two_sided_ = packed_.add(arrays.geometry.two_sided, 4 * padded);
    first_ = packed_.add(arrays.pairs.first, places);
    second_ = packed_.add(arrays.pairs.second, places);
    pairs_of_ = {packed_.add(pairs.first), packed_.add(pairs.entry)};
    node_ = packed_.add(arrays.nodes);
    pinballs_of_ = {packed_.add(pinballs.first), packed_.add(pinballs.entry)};
    expected_node_ = packed_.add(arrays.expected.node, arrays.expected.count);
    start_ = packed_.add(arrays.expected.start, 6 * arrays.expected.count);
    allowed2_ = packed_.add(arrays.expected.allowed2, arrays.expected.count);
    ball_corner_ = packed_.add(arrays.corner, 8 * std::int64_t(arrays.balls));
    radius_ = packed_.add(arrays.radius, arrays.balls);
    pair_force_ = packed_.template add_room<S>(4 * places);
    packed_.send();
  }

  void bring_back() override {
    if (!changed_) return;
    changed_ = false;
    packed_.bring_back();
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
    const ExpectedNodes<S> expected{host_.expected.count, data(expected_node_), data(start_), data(allowed2_),
                                    host_.expected.row};
    return is_any("deviations", expected.count, NodesStray<S>{expected, nodes.position, elapsed});
  }
  bool any_grows(const SurfaceNodes<S>& nodes, S most) override {
    return is_any("radii", host_.balls,
                  BallsGrow<S>{data(ball_corner_), data(radius_), nodes.position, most, host_.geometry.radius_factor});
  }

  PairSums<S> find_forces(const PenaltyConstants<S>& constants, S dt) override {
    PairSums<S> sums;
    if (host_.pairs.places == 0) return sums;
    changed_ = true;
    const ListedPairs<S> pairs{host_.pairs.places, data(first_), data(second_), data(offset_), data(stored_)};
    parallel_reduce("contact forces", all(pairs.places),
                    FindPairForces<S>{pinballs_of(geometry()), constants, pairs, data(pair_force_), dt}, sums);
    parallel_for("contact force sums", all(host_.pinballs),
                 SumPairForces<S>{entries(pairs_of_), data(offset_), data(pair_force_), data(force_)});
    return sums;
  }

  void add_forces(const SurfaceNodes<S>& nodes) override {
    parallel_reduce("contact scatter", all(host_.nodes.size()),
                    LoadNodes<S>{data(node_), entries(pinballs_of_), data(force_), nodes.force, nodes.inverse_mass},
                    largest_);
  }
  S largest_row(const SurfaceNodes<S>& /*nodes*/) override { return largest_.number; }

  std::size_t bytes() const override { return packed_.bytes(); }

 private:
  /// EntryLists in the space.
  struct Entries {
    PackedArray<std::uint32_t> first, entry;
  };
  static RangePolicy<Space> all(std::int64_t count) { return {0, count}; }
  template <class Is>
  static bool is_any(const char* name, std::int64_t count, const Is& is) {
    AnyOf found;
    parallel_reduce(name, all(count), LooksForAny<Is>{is}, found);
    return found.any != 0;
  }
  template <class T>
  T* data(PackedArray<T> array) {
    return packed_.data(array);
  }
  EntriesOf entries(const Entries& of) { return {data(of.first), data(of.entry)}; }
  PinballGeometryView<S> geometry() {
    return {data(corner_),    data(exposed_),     data(bulk_modulus_),
            data(centre_),    data(velocity_),    data(outward_),
            data(two_sided_), host_.geometry.row, host_.geometry.radius_factor};
  }

  PinballArrays<S> host_;  ///< as it was taken
  bool changed_ = false;   ///< what bring_back() brings, since then
  PackedArrays<Space> packed_;
  PackedArray<std::int32_t> corner_;
  PackedArray<S> exposed_, bulk_modulus_, centre_, velocity_, outward_, two_sided_, force_;
  PackedArray<std::int32_t> first_, second_;
  PackedArray<S> offset_, stored_, pair_force_;
  Entries pairs_of_;  ///< of each pinball
  PackedArray<std::int32_t> node_;
  Entries pinballs_of_;  ///< of each of these nodes
  NodeEntries node_entries_;
  PackedArray<std::int32_t> expected_node_;
  PackedArray<S> start_, allowed2_;
  PackedArray<std::int32_t> ball_corner_;
  PackedArray<S> radius_;
  LargestOf<S> largest_;
};

}  // namespace pinball

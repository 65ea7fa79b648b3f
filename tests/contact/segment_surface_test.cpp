#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <solver/contact/segments/segment_surface.hpp>

#include "eroding_block.hpp"

namespace pinball::segment_surface_test {
namespace {

using namespace test;

TEST(SegmentSurface, CountsSegmentsAndSharesOfSlaves) {
  Scene scene = scene_of({block("a", {2, 2, 2}, 0.1, {0, 0, 0})}, 1);
  const Model<double> model = build_model<double>(scene);
  const SegmentSurface<double> surface(ModelSurface<double>(model), surface_topology(model));
  EXPECT_EQ(surface.segments().size(), 24);
  EXPECT_EQ(surface.slaves().size(), 26);
  double share = 0, stiffness = 0;
  for (const auto& slave : surface.slaves()) {
    share += slave.share;
    stiffness += slave.stiffness;
    EXPECT_NEAR(slave.radius, 0.1 * std::cbrt(3 / (4 * M_PI)), 1e-15);
  }
  EXPECT_NEAR(share, 24, 1e-13);
  EXPECT_NEAR(stiffness, 24 * model.scene.materials[0].bulk_modulus * 0.1, 1e-3);  // K A^2 / V = K h
}

std::size_t active_segments(const SegmentSurface<double>& surface) {
  std::size_t count = 0;
  for (std::size_t s = 0; s < surface.segments().size(); ++s) {
    const double* plane = surface.plane().data() + 4 * s;
    const bool active = surface.sphere()[4 * s + 3] > 0;
    EXPECT_NEAR(std::hypot(plane[0], plane[1], plane[2]), active ? 1 : 0, 1e-12);
    EXPECT_EQ(active, surface.exposed(surface.segments()[s].slot, surface.segments()[s].face));
    count += active;
  }
  return count;
}

std::vector<SegmentSurface<double>::Slave> active_slaves(const SegmentSurface<double>& surface) {
  std::vector<SegmentSurface<double>::Slave> slaves;
  for (std::size_t i = 0; i < surface.slaves().size(); ++i) {
    if (surface.active(i)) slaves.push_back(surface.slaves()[i]);
  }
  return slaves;
}

TEST(SegmentSurface, FacesBehindElementsThatMaySoonErodeWait) {
  Model<double> model = eroding_block();
  strain_nearly_to_erosion(model, {upper_element, centre_element});  // the strain of what lies inside does not count
  SegmentSurface<double> surface(ModelSurface<double>(model), surface_topology(model));
  EXPECT_EQ(surface.segments().size(), 54 + 5);
  EXPECT_EQ(active_segments(surface), 54);
  EXPECT_EQ(surface.slaves().size(), 56 + 4);
  EXPECT_EQ(active_slaves(surface).size(), 56);
  EXPECT_EQ(surface.topology().exposed_count(), 26);

  EXPECT_TRUE(erode(model, surface, upper_element));
  surface.update(ModelSurface<double>(model));
  EXPECT_TRUE(surface.complete());
  EXPECT_TRUE(surface.changed());
  EXPECT_EQ(active_segments(surface), 54 - 1 + 5);
  EXPECT_EQ(surface.topology().exposed_count(), 26);

  // The slaves are those of a surface that is collected anew, to the last bit.
  const auto before = active_slaves(surface);
  EXPECT_EQ(before.size(), 60);
  surface.collect(ModelSurface<double>(model));
  EXPECT_FALSE(surface.changed());
  EXPECT_EQ(surface.segments().size(), 54 - 1 + 5 + 5) << "those behind the centre, but for the eroded one, wait now";
  const auto after = active_slaves(surface);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].node, before[i].node);
    EXPECT_EQ(after[i].body, before[i].body);
    EXPECT_EQ(after[i].share, before[i].share);
    EXPECT_EQ(after[i].radius, before[i].radius);
    EXPECT_EQ(after[i].stiffness, before[i].stiffness);
  }
}

TEST(SegmentSurface, IsIncompleteUntilItHasCollectedAFaceThatDidNotWait) {
  Model<double> model = eroding_block();
  SegmentSurface<double> surface(ModelSurface<double>(model), surface_topology(model));
  EXPECT_EQ(surface.segments().size(), 54);
  EXPECT_TRUE(surface.complete());
  EXPECT_TRUE(erode(model, surface, upper_element));
  EXPECT_FALSE(surface.complete());
  surface.collect(ModelSurface<double>(model));
  surface.update(ModelSurface<double>(model));
  EXPECT_TRUE(surface.complete());
  EXPECT_EQ(active_segments(surface), 54 - 1 + 5);
}

TEST(SegmentSurface, KeepsWhatListsAskForUpToDate) {
  // Slave 0 is in the corner that three segments share, and lists the last segment.
  Model<double> model = eroding_block();
  SegmentSurface<double> surface(ModelSurface<double>(model), surface_topology(model));
  const auto last = static_cast<std::int32_t>(surface.segments().size() - 1);
  surface.choose_none();
  surface.choose(last);
  surface.choose_around(0);
  surface.finish_choice();
  for (std::size_t i = 0; i < model.nodes.position.size(); ++i) model.nodes.position[i] += 1;
  const std::vector<double> before(surface.sphere().data(), surface.sphere().data() + surface.sphere().size());
  surface.update(ModelSurface<double>(model));
  int around = 0, stale = 0;
  for (std::size_t s = 0; s < surface.segments().size(); ++s) {
    const auto& node = surface.segments()[s].node;
    const bool of_slave = std::count(node, node + 4, surface.slaves()[0].node) > 0;
    around += of_slave;
    const double moved = surface.sphere()[4 * s] - before[4 * s];
    if (of_slave || static_cast<std::int32_t>(s) == last) {
      EXPECT_NEAR(moved, 1, 1e-12);
    }
    stale += moved == 0;
  }
  EXPECT_EQ(around, 3);
  EXPECT_GT(stale, 0) << "no needless work";
  EXPECT_GE(surface.chosen(), 4);
  EXPECT_LT(surface.chosen(), 54);
}

/// The segments that a face of an element is, whatever its number.
std::int32_t segment_of(const Model<double>& model, const SegmentSurface<double>& surface, std::size_t element,
                        std::int32_t face) {
  const auto& all = surface.segments();
  const auto at = std::find_if(all.begin(), all.end(), [&](const auto& segment) {
    return segment.slot == model.slot_of_element[element] && segment.face == face;
  });
  EXPECT_NE(at, all.end());
  return static_cast<std::int32_t>(at - all.begin());
}

constexpr std::int32_t upwards = 5;  // the face of an element

/// Whether elements of the block, numbered along x, y and z, touch each other.
bool are_neighbours(std::size_t a, std::size_t b) {
  const auto near = [&](std::size_t stride) {
    const auto i = static_cast<int>(a / stride % 3), j = static_cast<int>(b / stride % 3);
    return std::abs(i - j) <= 1;
  };
  return near(1) && near(3) && near(9);
}

bool beside(const SegmentSurface<double>& surface, const std::vector<std::int32_t>& some,
            const std::vector<std::int32_t>& others) {
  return surface.beside(some, others);
}

TEST(SegmentSurface, ElementsWithACommonCornerLieBesideEachOther) {
  const Model<double> model = eroding_block();
  const SegmentSurface<double> surface(ModelSurface<double>(model), surface_topology(model));
  const auto count = static_cast<std::int32_t>(surface.segments().size());
  int apart = 0;
  for (std::int32_t a = 0; a < count; ++a) {
    for (std::int32_t b = 0; b < count; ++b) {
      const auto element_of = [&](std::int32_t s) {
        return static_cast<std::size_t>(model.element_of_slot[static_cast<std::size_t>(surface.segments()[s].slot)]);
      };
      const bool expected = are_neighbours(element_of(a), element_of(b));
      EXPECT_EQ(beside(surface, {a}, {b}), expected);
      apart += !expected;
    }
  }
  EXPECT_GT(apart, 100);
}

TEST(SegmentSurface, OneOfSeveralIsEnoughToLieBeside) {
  const Model<double> model = eroding_block();
  const SegmentSurface<double> surface(ModelSurface<double>(model), surface_topology(model));
  const std::int32_t here = segment_of(model, surface, 18, upwards), next = segment_of(model, surface, 19, upwards),
                     far = segment_of(model, surface, 20, upwards), farther = segment_of(model, surface, 26, upwards);
  EXPECT_FALSE(beside(surface, {here}, {far, farther}));
  EXPECT_TRUE(beside(surface, {here}, {far, farther, next}));
  EXPECT_TRUE(beside(surface, {here, next}, {far}));
  EXPECT_FALSE(beside(surface, {}, {far}));
  EXPECT_FALSE(beside(surface, {far}, {}));
}

TEST(SegmentSurface, BodiesAreNeverBesideEachOther) {
  const Model<double> model = build_model<double>(
      scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, 0}), block("b", {1, 1, 1}, 0.1, {0, 0, 0.1})}, 1));
  const SegmentSurface<double> surface(ModelSurface<double>(model), surface_topology(model));
  const auto top = segment_of(model, surface, 0, upwards), other = segment_of(model, surface, 1, upwards);
  EXPECT_TRUE(beside(surface, {top}, {top}));
  EXPECT_FALSE(beside(surface, {top}, {other}));
}

TEST(SegmentSurface, WhatWaitsOrHasEndedLiesBesideNothing) {
  Model<double> model = eroding_block();
  strain_nearly_to_erosion(model, {upper_element});
  SegmentSurface<double> surface(ModelSurface<double>(model), surface_topology(model));
  const auto ends = segment_of(model, surface, upper_element, upwards),
             waits = segment_of(model, surface, centre_element, upwards),
             stays = segment_of(model, surface, 19, upwards);
  EXPECT_TRUE(beside(surface, {ends}, {stays}));
  EXPECT_FALSE(beside(surface, {waits}, {stays}));
  EXPECT_TRUE(beside(surface, {waits, ends}, {stays}));
  ASSERT_TRUE(erode(model, surface, upper_element));
  EXPECT_FALSE(beside(surface, {ends}, {stays}));
  EXPECT_FALSE(beside(surface, {stays}, {ends}));
  EXPECT_TRUE(beside(surface, {waits}, {stays}));
  EXPECT_TRUE(beside(surface, {ends, waits}, {stays}));
}

/// That each slave belongs to the first of its active segments; returns to which they belong.
std::vector<std::int32_t> expect_right_owners(const SegmentSurface<double>& surface) {
  std::vector<std::int32_t> owners;
  for (std::size_t i = 0; i < surface.slaves().size(); ++i) {
    const auto around = surface.around(i);
    EXPECT_TRUE(std::is_sorted(around.begin(), around.end()));
    const auto first = std::find_if(around.begin(), around.end(), [&](std::int32_t s) {
      return surface.exposed(surface.segments()[s].slot, surface.segments()[s].face);
    });
    EXPECT_EQ(surface.active(i), first != around.end());
    const std::int32_t expected = first != around.end() ? *first : around.front();
    EXPECT_EQ(surface.slaves()[i].owner, expected);
    owners.push_back(surface.slaves()[i].owner);
  }
  return owners;
}

TEST(SegmentSurface, SlavesBelongToTheirFirstActiveSegment) {
  Model<double> model = eroding_block();
  strain_nearly_to_erosion(model, {upper_element, corner_element});
  SegmentSurface<double> surface(ModelSurface<double>(model), surface_topology(model));
  auto before = expect_right_owners(surface);
  for (const std::size_t element : {upper_element, corner_element}) {
    const std::int32_t ended = segment_of(model, surface, element, upwards);
    ASSERT_TRUE(erode(model, surface, element));
    ASSERT_TRUE(surface.complete());
    const auto after = expect_right_owners(surface);
    int changed = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      changed += after[i] != before[i];
      EXPECT_TRUE(after[i] != ended || !surface.active(i));
    }
    EXPECT_GT(changed, 0);
    before = after;
  }
  surface.collect(ModelSurface<double>(model));
  expect_right_owners(surface);
}

}  // namespace
}  // namespace pinball::segment_surface_test

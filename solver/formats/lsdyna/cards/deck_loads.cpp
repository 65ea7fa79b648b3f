#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "boundary_keys.hpp"
#include "deck_parts.hpp"

namespace pinball {

void translate_node_load(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  const bool set = block.name.ends_with("_SET");
  for_each_card(block, [&](const Card& card) {
    const Fields f = data.fields(card, set ? layout::load_node_set : layout::load_node);
    const std::int64_t degree = f.integer("DOF");
    if (degree < 1 || degree > 3) {
      if (degree >= 5 && degree <= 7)
        return data.report.ignore(card.place, block.star_name() + " of moments on nodes of solids");
      data.report.reject(card.place, fmt::format("{} with DOF {}", block.star_name(), degree),
                         "1 to 3 are read: give components of forces that turn with nodes");
      return;
    }
    const auto axes = data.axes(definition_number(block, f.integer("CID")), card.place);
    const auto keys = scene.entry<NodalLoad>("load", card_of(block, card.place));
    keys.set("force", axes[degree - 1]);
    keys.set("each", true);
    set_curve(data, block, f.integer("LCID"), f.number("SF"), card.place, keys);
    set_target(block, set, f.integer(set ? "NSID" : "NID"), keys);
  });
}

namespace {

/// Curve, factor and arrival time of segments.
struct SegmentLoad {
  std::int64_t curve = 0;
  double scale = 1, arrival = 0;
  auto operator<=>(const SegmentLoad&) const = default;
};

SegmentLoad segment_load(const Fields& f) { return {f.integer("LCID"), f.number("SF"), f.number("AT")}; }

using FaceNumbers = std::array<std::int64_t, 4>;

/// The time of the curve counts from the arrival.
DeckKeys<Pressure> begin_pressure(const DeckData& data, const KeywordBlock& block, const DeckPlace& place,
                                  const SegmentLoad& load, DeckScene& scene) {
  auto keys = scene.entry<Pressure>("pressure", card_of(block, place));
  keys.set("pressure", 1.0);
  set_curve(data, block, load.curve, load.scale, place, keys, {0, end_of_run(data) - load.arrival});
  if (load.arrival > 0) keys.set("start", load.arrival, "at");
  return keys;
}

/// N1 to N4; a triangle has no N4, or N3 once more.
FaceNumbers corners_of(const KeywordBlock& block, const Fields& f) {
  constexpr std::size_t first = layout::load_segment.find("N1");
  FaceNumbers corners{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::int64_t node = f.integer(first + i);
    corners[i] = i == 3 && node == 0 ? corners[2] : node_number(block, node);
  }
  return corners;
}

}  // namespace

void translate_segment_load(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  std::map<SegmentLoad, std::pair<std::vector<FaceNumbers>, DeckPlace>> faces;
  DeckFaces pressed{block.star_name() + ": the order of N1 to N4", block.place, {}};
  for_each_card(block, [&](const Card& card) {
    const Fields f = data.fields(card, layout::load_segment);
    auto& [corners, first] = faces[segment_load(f)];
    if (corners.empty()) first = card.place;
    const FaceNumbers numbers = corners_of(block, f);
    std::array<std::int32_t, 4> places{};
    std::ranges::transform(numbers, places.begin(), [&](std::int64_t number) { return data.nodes.find(number); });
    const auto triangles = data.middles.pieces_of(places);
    pressed.faces.insert(pressed.faces.end(), triangles.begin(), triangles.end());
    if (triangles.size() == 1) return corners.push_back(numbers);  // perhaps with nodes that are not there
    for (const auto& triangle : triangles) {
      auto& of_triangle = corners.emplace_back();
      std::ranges::transform(triangle, of_triangle.begin(),
                             [&](std::int32_t node) { return data.mesh.node_ids[node]; });
    }
  });
  data.pressed.push_back(std::move(pressed));
  for (const auto& [load, listed] : faces) {
    begin_pressure(data, block, listed.second, load, scene).set("faces", listed.first, "n1 to n4");
  }
}

void translate_segment_set_load(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  for_each_card(block, [&](const Card& card) {
    const Fields f = data.fields(card, layout::load_segment_set);
    const auto keys = begin_pressure(data, block, card.place, segment_load(f), scene);
    const std::int64_t set = f.integer("SSID");
    set_target(block, true, set, keys);
    const FaceSet* faces = find_set(data.mesh.face_sets, std::to_string(set_number(block, set)));
    if (faces != nullptr)
      data.pressed.push_back({block.star_name() + ": the order of the corners", card.place, faces->faces});
  });
}

namespace {

/// *LOAD_BODY_PARTS: what all loads on bodies act on; empty: all.
std::vector<std::string> loaded_bodies(const DeckData& data) {
  std::vector<std::string> bodies;
  for (const KeywordBlock* block : data.blocks_of("LOAD_BODY_PARTS")) {
    Cards cards(*block);
    const Card card = cards.require("the set of parts");
    const std::int64_t set = set_number(*block, data.fields(card, layout::body_load_parts).integer("PSID"));
    for (const std::string& body : bodies_of(data, data.part_set(set, card.place), card.place)) bodies.push_back(body);
    if (bodies.empty()) fail_at(card.place, fmt::format("{}: no part of set {} has solids", block->star_name(), set));
  }
  return bodies;
}

/// The direction along which the frame is accelerated.
Point direction_of_frame(const DeckData& data, const KeywordBlock& block, Cards& cards) {
  Point frame{};
  if (block.name != "LOAD_BODY_VECTOR") {
    frame[block.name.back() - 'X'] = 1;
    return frame;
  }
  const Card vector = cards.require("the direction of the load");
  frame = data.fields(vector, layout::body_load_vector).point("V1");
  const double length = norm(frame);
  if (!(length > 0)) fail_at(vector.place, block.star_name() + ": expected a direction of some length");
  for (double& component : frame) component /= length;
  return frame;
}

}  // namespace

void translate_body_load(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  Cards cards(block);
  const Card card = cards.require("the curve of the load");
  const Fields f = data.fields(card, layout::body_load);
  const Point frame = in_system(data, block, f.integer("CID"), direction_of_frame(data, block, cards), card.place);
  const auto keys = scene.entry<Gravity>("gravity", card_of(block, card.place));
  keys.comment(card_of(block, card.place).text() + ": the frame is accelerated, bodies the other way");
  keys.set("acceleration", minus({0, 0, 0}, frame));
  set_curve(data, block, f.integer("LCID"), f.number("SF"), card.place, keys);
  if (const auto bodies = loaded_bodies(data); !bodies.empty()) keys.set("bodies", bodies, "psid");
}

}  // namespace pinball

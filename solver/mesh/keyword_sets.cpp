#include "keyword_sets.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <solver/base/error.hpp>
#include <solver/keyword/fields.hpp>

namespace pinball {

namespace {

bool is_set_of_places(const std::string& name) {
  for (const char* kind : {"SET_NODE", "SET_SOLID"}) {
    for (const char* form : {"", "_LIST", "_LIST_GENERATE", "_GENERATE", "_GENERAL", "_ADD"}) {
      if (name == std::string(kind) + form) return true;
    }
  }
  return false;
}

/// Number and name of a set: the first cards of its keyword.
template <class Set>
void read_head(const KeywordBlock& block, const Parameters& parameters, Cards& cards, Set& set) {
  if (block.title) set.name = std::string(trimmed(cards.require("a title").text));
  set.id = Fields(cards.require("the number of the set"), parameters).integer(0, "sid") +
           (block.transform ? block.transform->set : 0);
}

}  // namespace

KeywordSets::KeywordSets(const KeywordDeck& deck, MeshFile& file, const NumberIndex& nodes)
    : deck_(deck), file_(file), nodes_(nodes), elements_(file.element_ids) {}

void KeywordSets::read() {
  for (const KeywordBlock& block : deck_.blocks) {
    if (block.name == "DEFINE_BOX") read_box(block);
  }
  for (const bool sums : {false, true}) {  // *SET_NODE_ADD may stand before the sets that it adds
    for (const KeywordBlock& block : deck_.blocks) {
      if (is_set_of_places(block.name) && block.name.ends_with("_ADD") == sums) read_set(block);
    }
  }
  for (const KeywordBlock& block : deck_.blocks) {
    if (block.name == "SET_SEGMENT" || block.name == "SET_SEGMENT_GENERAL") read_segments(block);
  }
}

void KeywordSets::read_box(const KeywordBlock& block) {
  Cards cards(block);
  if (block.title) cards.next();
  const Card card = cards.require("number and bounds of the box");
  const Fields fields(card, deck_.parameters);
  Box box{};
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = fields.number(1 + 2 * k, "minimum", 0.0);
    box.high[k] = fields.number(2 + 2 * k, "maximum", 0.0);
  }
  boxes_[fields.integer(0, "boxid") + (block.transform ? block.transform->define : 0)] = box;
}

void KeywordSets::read_set(const KeywordBlock& block) {
  Cards cards(block);
  MeshSet set;
  read_head(block, deck_.parameters, cards, set);
  Places members;
  try {
    add_members(block, cards, set, members);
  } catch (const InputError& error) {
    set.problem = error.what();  // many decks have sets that nothing uses, of what was left out
  }
  set.members.assign(members.begin(), members.end());
  (of_nodes(block) ? file_.node_sets : file_.element_sets).push_back(std::move(set));
}

void KeywordSets::add_members(const KeywordBlock& block, Cards& cards, MeshSet& set, Places& members) const {
  while (const auto card = cards.next_filled()) {
    const Fields fields(*card, deck_.parameters);
    if (block.name.ends_with("_GENERAL")) {
      add_general(block, fields, members);
    } else if (block.name.ends_with("_ADD")) {
      add_other_sets(block, fields, members);
    } else {
      add_listed(block, fields, block.name.ends_with("_GENERATE"), set, members);
    }
  }
}

void KeywordSets::add_listed(const KeywordBlock& block, const Fields& fields, bool generate, MeshSet& set,
                             Places& known) const {
  for (std::size_t i = 0; i < 8; i += generate ? 2 : 1) {
    const std::int64_t first = fields.integer(i, "number", 0);
    if (first == 0) continue;
    if (!generate) {
      known.insert(place_of(block, first + offset(block), fields.place()));
      continue;
    }
    const std::int64_t last = fields.integer(i + 1, "last number", first);
    const std::vector<std::int64_t>& ids = of_nodes(block) ? file_.node_ids : file_.element_ids;
    const std::size_t before = known.size();
    for (std::size_t place = 0; place < ids.size(); ++place) {  // what is not there in between is left out
      if (ids[place] >= first + offset(block) && ids[place] <= last + offset(block))
        known.insert(static_cast<std::int32_t>(place));
    }
    if (known.size() == before)
      fail_at(fields.place(), fmt::format("{} {}: none from {} to {}", block.star_name(), set.id, first, last));
  }
}

void KeywordSets::add_general(const KeywordBlock& block, const Fields& fields, Places& members) const {
  const std::string option = upper_case(fields.text(0));
  const bool removes = option.starts_with('D');
  const Places some = members_of(block, removes ? option.substr(1) : option, fields);
  for (const std::int32_t place : some) {
    if (removes) {
      members.erase(place);
    } else {
      members.insert(place);
    }
  }
}

KeywordSets::Places KeywordSets::members_of(const KeywordBlock& block, const std::string& option,
                                            const Fields& fields) const {
  if (option == "ALL") return all(block);
  Places some;
  for (std::size_t i = 1; i < 8; ++i) {
    const std::int64_t number = fields.integer(i, "number", 0);
    if (number == 0) continue;
    if (option == "PART") {
      some.merge(of_part(block, number + (block.transform ? block.transform->part : 0), fields.place()));
    } else if (option == "BOX") {
      some.merge(in_box(block, number + (block.transform ? block.transform->define : 0), fields.place()));
    } else if (option == (of_nodes(block) ? "NODE" : "ELEM")) {
      some.insert(place_of(block, number + offset(block), fields.place()));
    } else {
      fail_at(fields.place(), fmt::format("{}: option {} is not read", block.star_name(), fields.text(0)));
    }
  }
  return some;
}

void KeywordSets::add_other_sets(const KeywordBlock& block, const Fields& fields, Places& members) const {
  const std::vector<MeshSet>& sets = of_nodes(block) ? file_.node_sets : file_.element_sets;
  for (std::size_t i = 0; i < 8; ++i) {
    const std::int64_t number = fields.integer(i, "set", 0);
    if (number == 0) continue;
    const std::int64_t id = number + (block.transform ? block.transform->set : 0);
    const auto found = std::ranges::find(sets, id, &MeshSet::id);
    if (found == sets.end())
      fail_at(fields.place(), fmt::format("{}: no set has the number {}", block.star_name(), id));
    members.insert(found->members.begin(), found->members.end());
  }
}

KeywordSets::Places KeywordSets::all(const KeywordBlock& block) const {
  Places places;
  const std::size_t count = of_nodes(block) ? file_.node_ids.size() : file_.element_ids.size();
  for (std::size_t i = 0; i < count; ++i) places.insert(places.end(), static_cast<std::int32_t>(i));
  return places;
}

KeywordSets::Places KeywordSets::of_part(const KeywordBlock& block, std::int64_t part, const DeckPlace& place) const {
  const auto found = std::ranges::find(file_.parts, part, &MeshPart::id);
  if (found == file_.parts.end()) fail_at(place, fmt::format("{}: no part has the number {}", block.star_name(), part));
  const auto wanted = static_cast<std::int32_t>(found - file_.parts.begin());
  Places places;
  for (std::size_t e = 0; e < file_.part.size(); ++e) {
    if (file_.part[e] != wanted) continue;
    if (of_nodes(block)) {
      places.insert(file_.mesh.hexahedra[e].begin(), file_.mesh.hexahedra[e].end());
    } else {
      places.insert(static_cast<std::int32_t>(e));
    }
  }
  return places;
}

/// Nodes in the box; elements all of whose nodes are.
KeywordSets::Places KeywordSets::in_box(const KeywordBlock& block, std::int64_t number, const DeckPlace& place) const {
  const auto found = boxes_.find(number);
  if (found == boxes_.end()) fail_at(place, fmt::format("{}: no box has the number {}", block.star_name(), number));
  const Box& box = found->second;
  const auto inside = [&](std::int32_t node) {
    const Point& x = file_.mesh.nodes[node];
    for (std::size_t k = 0; k < 3; ++k) {
      if (x[k] < box.low[k] || x[k] > box.high[k]) return false;
    }
    return true;
  };
  Places places;
  if (of_nodes(block)) {
    for (std::size_t n = 0; n < file_.mesh.nodes.size(); ++n) {
      if (inside(static_cast<std::int32_t>(n))) places.insert(static_cast<std::int32_t>(n));
    }
    return places;
  }
  for (std::size_t e = 0; e < file_.mesh.hexahedra.size(); ++e) {
    if (std::ranges::all_of(file_.mesh.hexahedra[e], inside)) places.insert(static_cast<std::int32_t>(e));
  }
  return places;
}

std::int32_t KeywordSets::place_of(const KeywordBlock& block, std::int64_t number, const DeckPlace& place) const {
  const std::int32_t found = index(block).find(number);
  if (found < 0)
    fail_at(place,
            fmt::format("{}: {} {} is not there", block.star_name(), of_nodes(block) ? "node" : "solid", number));
  return found;
}

std::int64_t KeywordSets::offset(const KeywordBlock& block) const {
  if (!block.transform) return 0;
  return of_nodes(block) ? block.transform->node : block.transform->element;
}

void KeywordSets::read_segments(const KeywordBlock& block) {
  Cards cards(block);
  FaceSet set;
  read_head(block, deck_.parameters, cards, set);
  try {
    while (const auto card = cards.next_filled()) set.faces.push_back(segment(block, *card));
  } catch (const InputError& error) {
    set.problem = error.what();
  }
  file_.face_sets.push_back(std::move(set));
}

std::array<std::int32_t, 4> KeywordSets::segment(const KeywordBlock& block, const Card& card) const {
  const Fields fields(card, deck_.parameters);
  const bool general = block.name.ends_with("_GENERAL");
  const std::int64_t add = block.transform ? block.transform->node : 0;
  if (general && upper_case(fields.text(0)) != "SEG")
    fail_at(card.place, fmt::format("{}: option {} is not read", block.star_name(), fields.text(0)));
  std::array<std::int32_t, 4> face{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::int64_t number = fields.integer(i + (general ? 1 : 0), "node", 0);
    if (number == 0 && i == 3) {  // a triangle
      face[3] = face[2];
      continue;
    }
    face[i] = nodes_.find(number + add);
    if (face[i] < 0) fail_at(card.place, fmt::format("{}: node {} is not there", block.star_name(), number + add));
  }
  return face;
}

}  // namespace pinball

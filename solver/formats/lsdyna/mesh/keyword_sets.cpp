#include "keyword_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include <solver/base/error.hpp>
#include <solver/formats/deck/missed_last.hpp>
#include <solver/formats/lsdyna/scan/keyword_scanner.hpp>

namespace pinball {

namespace {

bool is_set_of_places(const std::string& name) { return name.starts_with("SET_NODE") || name.starts_with("SET_SOLID"); }

/// What follows the kind of a set in its name, without _COLLECT: one of these forms.
std::string form_of(const KeywordBlock& block) {
  std::string form = block.name;
  take_ending(form, "_COLLECT");
  form.erase(0, std::string_view(form.starts_with("SET_NODE") ? "SET_NODE" : "SET_SOLID").size());
  if (form.starts_with("_LIST")) form.erase(0, 5);
  static constexpr std::array<std::string_view, 6> forms{"",         "_GENERATE", "_GENERATE_INCREMENT",
                                                         "_GENERAL", "_ADD",      "_COLUMN"};
  if (std::ranges::find(forms, form) == forms.end()) fail_at(block.place, block.star_name() + " is not read");
  return form;
}

/// What the lines of a form have.
const CardLayout& layout_of(const std::string& form) {
  if (form == "_GENERAL") return layout::set_general;
  if (form == "_COLUMN") return layout::set_column;
  if (form == "_GENERATE") return layout::set_ranges;
  return form == "_GENERATE_INCREMENT" ? layout::set_steps : layout::members;
}

void sort_and_keep_one_of_each(std::vector<std::int32_t>& places) {
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

void append(std::vector<std::int32_t>& places, const std::vector<std::int32_t>& more) {
  places.insert(places.end(), more.begin(), more.end());
}

}  // namespace

KeywordSets::KeywordSets(const KeywordDeck& deck, MeshFile& file, const NumberIndex& nodes)
    : deck_(deck), file_(file), nodes_(nodes), elements_(file.element_ids), boxes_(deck) {}

void KeywordSets::read() {
  for (const bool sums : {false, true}) {  // *SET_NODE_ADD may stand before the sets that it adds
    for (const KeywordBlock& block : deck_.blocks) {
      const bool adds = block.name.ends_with("_ADD") || block.name.ends_with("_ADD_COLLECT");
      if (is_set_of_places(block.name) && adds == sums) read_set(block);
    }
  }
}

void KeywordSets::read_set(const KeywordBlock& block) {
  Cards cards(block);
  MeshSet set;
  read_set_head(block, deck_.parameters, cards, set);
  if (block.name.ends_with("_COLLECT")) {  // more of the set of this number
    const auto same = std::ranges::find(sets(block), set.id, &MeshSet::id);
    if (same != sets(block).end()) {
      set = std::move(*same);
      sets(block).erase(same);
    }
  } else {
    given_.add(fmt::format("set of {} {}", of_nodes(block) ? "nodes" : "solids", set.id), block.place, block.of_case);
    if (block.of_case) std::erase_if(sets(block), [&](const MeshSet& other) { return other.id == set.id; });
  }
  try {
    add_members(block, cards, set.members);
  } catch (const InputError& error) {
    set.problem = error.what();
  }
  sort_and_keep_one_of_each(set.members);
  sets(block).push_back(std::move(set));
}

void KeywordSets::add_members(const KeywordBlock& block, Cards& cards, Places& members) {
  const std::string form = form_of(block);
  while (const auto card = cards.next_filled()) {
    const Fields fields(*card, deck_.parameters, layout_of(form));
    if (form == "_GENERAL") {
      add_general(block, fields, members);
    } else if (form == "_ADD") {
      add_other_sets(block, fields, members);
    } else if (form == "_COLUMN") {  // a number, and values that are for other keywords
      members.push_back(place_of(block, fields.integer("ID") + offset(block), fields.place()));
    } else if (form.empty()) {
      add_listed(block, fields, members);
    } else {
      add_generated(block, fields, members);
    }
  }
}

void KeywordSets::add_listed(const KeywordBlock& block, const Fields& fields, Places& members) const {
  for (std::size_t i = 0; i < 8; ++i) {
    const std::int64_t number = fields.integer(i);
    if (number != 0) members.push_back(place_of(block, number + offset(block), fields.place()));
  }
}

/// Pairs of a first and a last number; with _INCREMENT one pair and a step.
void KeywordSets::add_generated(const KeywordBlock& block, const Fields& fields, Places& members) {
  const bool steps = block.name.find("_INCREMENT") != std::string::npos;
  for (std::size_t i = 0; i < (steps ? 2U : 8U); i += 2) {
    const std::int64_t first = fields.integer(i);
    if (first == 0) continue;
    const std::int64_t last = fields.blank(i + 1) ? first : fields.integer(i + 1);
    const std::int64_t step = steps ? fields.integer("INCR") : 1;
    const std::size_t before = members.size();
    add_numbers(block, first + offset(block), last + offset(block), step, members);
    if (members.size() == before)
      fail_at(fields.place(), fmt::format("{}: none from {} to {}", block.star_name(), first, last));
    note_missed_last(block.star_name(), fields.place(), first, last, step, file_.notes);
  }
}

/// What is not there in between is left out.
void KeywordSets::add_numbers(const KeywordBlock& block, std::int64_t first, std::int64_t last, std::int64_t step,
                              Places& members) {
  const Numbered& numbers = sorted(block);
  auto found = std::lower_bound(numbers.begin(), numbers.end(), std::pair{first, std::int32_t{-1}});
  for (; found != numbers.end() && found->first <= last; ++found) {
    if ((found->first - first) % step == 0) members.push_back(found->second);
  }
}

const KeywordSets::Numbered& KeywordSets::sorted(const KeywordBlock& block) {
  const std::vector<std::int64_t>& ids = of_nodes(block) ? file_.node_ids : file_.element_ids;
  Numbered& numbers = of_nodes(block) ? sorted_nodes_ : sorted_elements_;
  if (numbers.size() == ids.size()) return numbers;
  for (std::size_t i = 0; i < ids.size(); ++i) numbers.emplace_back(ids[i], static_cast<std::int32_t>(i));
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

void KeywordSets::add_general(const KeywordBlock& block, const Fields& fields, Places& members) const {
  const std::string option = upper_case(fields.text("OPTION"));
  const bool removes = option.starts_with('D');
  Places some = members_of(block, removes ? option.substr(1) : option, fields);
  if (!removes) return append(members, some);
  sort_and_keep_one_of_each(some);
  std::erase_if(members, [&some](std::int32_t place) { return std::binary_search(some.begin(), some.end(), place); });
}

KeywordSets::Places KeywordSets::members_of(const KeywordBlock& block, const std::string& option,
                                            const Fields& fields) const {
  if (option == "ALL") return all(block);
  Places some;
  for (std::size_t i = 1; i < 8; ++i) {
    const std::int64_t number = fields.integer(i);
    if (number != 0) append(some, members_of(block, option, number, fields));
  }
  return some;
}

KeywordSets::Places KeywordSets::members_of(const KeywordBlock& block, const std::string& option, std::int64_t number,
                                            const Fields& fields) const {
  if (option == "PART") return of_part(block, number + offset_of(block, &DeckTransform::part), fields.place());
  if (option == "BOX") return in_box(block, boxes_.find(block, number, fields.place()));
  if (option == (of_nodes(block) ? "NODE" : "ELEM")) return {place_of(block, number + offset(block), fields.place())};
  fail_at(fields.place(), fmt::format("{}: option {} is not read", block.star_name(), fields.text("OPTION")));
}

void KeywordSets::add_other_sets(const KeywordBlock& block, const Fields& fields, Places& members) const {
  for (std::size_t i = 0; i < 8; ++i) {
    const std::int64_t number = fields.integer(i);
    if (number == 0) continue;
    const std::int64_t id = number + offset_of(block, &DeckTransform::set);
    const auto found = std::ranges::find(sets(block), id, &MeshSet::id);
    if (found == sets(block).end())
      fail_at(fields.place(), fmt::format("{}: no set has the number {}", block.star_name(), id));
    if (!found->problem.empty()) throw InputError(found->problem);
    append(members, found->members);
  }
}

KeywordSets::Places KeywordSets::all(const KeywordBlock& block) const {
  Places places(of_nodes(block) ? file_.node_ids.size() : file_.element_ids.size());
  std::iota(places.begin(), places.end(), 0);
  return places;
}

KeywordSets::Places KeywordSets::of_part(const KeywordBlock& block, std::int64_t part, const DeckPlace& place) const {
  const auto found = std::ranges::find(file_.parts, part, &MeshPart::id);
  if (found == file_.parts.end()) fail_at(place, fmt::format("{}: no part has the number {}", block.star_name(), part));
  const std::int32_t wanted = found - file_.parts.begin();
  Places places;
  for (std::size_t e = 0; e < file_.part.size(); ++e) {
    if (file_.part[e] != wanted) continue;
    if (of_nodes(block)) {
      add_nodes_of_element(file_, e, places);
    } else {
      places.push_back(e);
    }
  }
  sort_and_keep_one_of_each(places);
  return places;
}

/// Nodes in the box; elements all of whose nodes are.
KeywordSets::Places KeywordSets::in_box(const KeywordBlock& block, const KeywordBox& box) const {
  const auto is_inside = [&](std::int32_t node) { return box.holds(file_.mesh.nodes[node]); };
  Places places = all(block);
  std::erase_if(places, [&](std::int32_t place) {
    if (of_nodes(block)) return !is_inside(place);
    Places nodes;
    add_nodes_of_element(file_, place, nodes);
    return !std::ranges::all_of(nodes, is_inside);
  });
  return places;
}

std::int32_t KeywordSets::place_of(const KeywordBlock& block, std::int64_t number, const DeckPlace& place) const {
  const std::int32_t found = (of_nodes(block) ? nodes_ : elements_).find(number);
  if (found >= 0) return found;
  fail_at(place, fmt::format("{}: {} {} is not there", block.star_name(), of_nodes(block) ? "node" : "solid", number));
}

}  // namespace pinball

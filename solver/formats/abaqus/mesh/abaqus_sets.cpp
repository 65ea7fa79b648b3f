#include "abaqus_sets.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <solver/base/error.hpp>
#include <solver/formats/deck/given_once.hpp>
#include <solver/formats/deck/missed_last.hpp>

namespace pinball {

namespace {

const char* kind(bool of_nodes) { return of_nodes ? "node" : "element"; }

void make_ascending(std::vector<std::int32_t>& members) {
  std::sort(members.begin(), members.end());
  members.erase(std::unique(members.begin(), members.end()), members.end());
}

}  // namespace

AbaqusSets::AbaqusSets(const AbaqusMesh& mesh, MeshFile& file, std::vector<NumberIndex> nodes,
                       std::vector<NumberIndex> elements)
    : components_(mesh.components),
      ranges_(mesh.ranges),
      types_(mesh.types),
      file_(file),
      nodes_(std::move(nodes)),
      elements_(std::move(elements)),
      node_sets_(components_.size()),
      element_sets_(components_.size()),
      surfaces_(components_.size()) {
  for (std::size_t c = 0; c < components_.size(); ++c) {
    if (!components_[c].key.empty()) component_of_key_.emplace(components_[c].key, c);
  }
}

void AbaqusSets::add_range(std::size_t component, bool of_nodes, const std::string& name, std::size_t first,
                           std::size_t last) {
  Set& set = sets(component, of_nodes)[label_key(name)];
  if (set.name.empty()) set.name = label_text(name);
  set.ranges.emplace_back(first, last);
}

void AbaqusSets::read() {
  for (std::size_t c = 0; c < components_.size(); ++c) {
    GivenOnce given;  // an instance has the blocks of its part
    for (const AbaqusBlock* block : components_[c].blocks) {
      const bool of_nodes = block->name == "NSET";
      if (of_nodes || block->name == "ELSET") {
        const std::string name = block->require(block->name.c_str());
        Set& set = sets(c, of_nodes)[label_key(name)];
        if (set.name.empty()) set.name = label_text(name);
        set.blocks.push_back(block);
      }
      if (block->name == "SURFACE") {
        const std::string name = block->require("NAME");
        given.add(
            fmt::format("surface {}{}{}", components_[c].key, components_[c].key.empty() ? "" : ".", label_key(name)),
            block->place);
        surfaces_[c].push_back({label_text(name), label_key(name), block});
      }
    }
  }
}

AbaqusSets::Set* AbaqusSets::find(const SetKey& key) {
  Sets& known = sets(key.component, key.of_nodes);
  const auto found = known.find(key.key);
  return found == known.end() ? nullptr : &found->second;
}

void AbaqusSets::resolve(const SetKey& first) {
  std::vector<SetKey> stack{first};
  while (!stack.empty()) {
    const SetKey key = stack.back();
    Set* const set = find(key);
    if (set == nullptr || set->state == Set::State::done) {
      stack.pop_back();
      continue;
    }
    if (set->state == Set::State::open) {
      set->state = Set::State::at_work;
      set->needs = sets_in(key, *set);
    }
    if (set->needs.empty()) {
      fill(key, *set);
      stack.pop_back();
      continue;
    }
    const SetKey next = std::move(set->needs.back());
    set->needs.pop_back();
    const Set* const other = find(next);
    if (other != nullptr && other->state == Set::State::open) stack.push_back(next);
  }
}

std::vector<AbaqusSets::SetKey> AbaqusSets::sets_of_label(std::size_t component, bool of_nodes,
                                                          std::string_view label) const {
  std::vector<SetKey> keys{{component, of_nodes, label_key(label)}};
  if (const auto parts = split_label(label)) {
    if (const auto other = component_of(parts->first)) keys.push_back({*other, of_nodes, label_key(parts->second)});
  }
  return keys;
}

std::vector<AbaqusSets::SetKey> AbaqusSets::sets_in(const SetKey& key, const Set& set) const {
  std::vector<SetKey> all;
  const auto add = [&](std::size_t component, bool of_nodes, std::string_view label) {
    for (SetKey& one : sets_of_label(component, of_nodes, label)) all.push_back(std::move(one));
  };
  for (const AbaqusBlock* block : set.blocks) {
    const std::size_t scope = component_of(block->value("INSTANCE").value_or("")).value_or(key.component);
    if (key.of_nodes && block->has("ELSET")) {
      add(scope, false, block->value("ELSET").value_or(""));
      continue;
    }
    if (block->has("GENERATE")) continue;
    DataLines lines(*block);
    while (const auto card = lines.next()) {
      for (const std::string_view entry : entries_of(card->text)) {
        const bool is_label = !entry.empty() && entry.find_first_of("0123456789+-") != 0;
        if (is_label) add(scope, key.of_nodes, entry);
      }
    }
  }
  return all;
}

void AbaqusSets::fill(const SetKey& key, Set& set) {
  try {
    for (const auto& [first, last] : set.ranges) {
      for (std::size_t i = first; i < last; ++i) set.members.push_back(i);
    }
    for (const AbaqusBlock* block : set.blocks) add_block(key.component, key.of_nodes, *block, set.members);
  } catch (const InputError& error) {
    set.problem = error.what();  // of sets that nothing uses nobody has to know
  }
  make_ascending(set.members);
  set.state = Set::State::done;
}

void AbaqusSets::add_block(std::size_t component, bool of_nodes, const AbaqusBlock& block,
                           std::vector<std::int32_t>& members) {
  std::size_t scope = component;
  if (const auto instance = block.value("INSTANCE")) {
    const auto found = component_of(*instance);
    if (!found) fail_at(block.place, fmt::format("{}: there is no *INSTANCE {}", block.star_name(), *instance));
    scope = *found;
  }
  if (of_nodes && block.has("ELSET")) {
    add_nodes_of_elements(this->members(scope, false, block.require("ELSET"), block.place), members);
    return;
  }
  const bool generates = block.has("GENERATE");
  DataLines lines(block);
  while (const auto card = lines.next()) {
    if (generates) {
      generate(scope, of_nodes, block, *card, members);
    } else {
      for (const std::string_view entry : entries_of(card->text)) {
        if (!entry.empty()) add_entry(scope, of_nodes, std::string(entry), card->place, members);
      }
    }
  }
}

/// First, last, step. Numbers in between that are not there are left out, as in a mesh with gaps.
void AbaqusSets::generate(std::size_t component, bool of_nodes, const AbaqusBlock& block, const DataLine& card,
                          std::vector<std::int32_t>& members) {
  const DataFields f(card);
  const std::int64_t first = f.integer(0, "first"), last = f.integer(1, "last", first);
  std::int64_t step = f.integer(2, "step", 1);
  if (step == 0) step = 1;
  if (step < 0 || last < first)
    fail_at(card.place,
            fmt::format("GENERATE: expected first <= last and a step > 0, got {}, {}, {}", first, last, step));
  const AbaqusRange& range = ranges_[component];
  const std::size_t begin = of_nodes ? range.first_node : range.first_element,
                    count = of_nodes ? range.nodes : range.elements, before = members.size();
  const std::vector<std::int64_t>& numbers = of_nodes ? file_.node_ids : file_.element_ids;
  for (std::size_t i = begin; i < begin + count; ++i) {
    if (numbers[i] >= first && numbers[i] <= last && (numbers[i] - first) % step == 0) members.push_back(i);
  }
  const auto is_between = [&](const auto& passed) {
    return passed.first == component && passed.second >= first && passed.second <= last;
  };
  if (members.size() == before && (of_nodes || std::ranges::none_of(passed_over_, is_between)))
    fail_at(card.place, fmt::format("GENERATE: there is no {} from {} to {}", kind(of_nodes), first, last));
  note_missed_last(block.star_name() + ", GENERATE", card.place, first, last, step, file_.notes);
}

std::optional<std::int32_t> AbaqusSets::numbered(std::size_t component, bool of_nodes, std::int64_t number) const {
  const std::int32_t place = (of_nodes ? nodes_ : elements_)[component].find(number);
  if (place < 0) return std::nullopt;
  const AbaqusRange& range = ranges_[component];
  return place + static_cast<std::int32_t>(of_nodes ? range.first_node : range.first_element);
}

std::optional<std::size_t> AbaqusSets::component_of(const std::string& instance) const {
  const auto found = component_of_key_.find(label_key(instance));
  return found == component_of_key_.end() ? std::nullopt : std::optional(found->second);
}

void AbaqusSets::add_entry(std::size_t component, bool of_nodes, const std::string& label, const DeckPlace& place,
                           std::vector<std::int32_t>& members) {
  if (const auto number = deck_integer(label)) {
    const auto found = numbered(component, of_nodes, *number);
    if (!found && !of_nodes && passed_over_.contains({component, *number})) return;
    if (!found) fail_at(place, fmt::format("{} {} is not there", kind(of_nodes), label));
    members.push_back(*found);
    return;
  }
  const std::vector<std::int32_t>& others = this->members(component, of_nodes, label, place);
  members.insert(members.end(), others.begin(), others.end());
}

const std::vector<std::int32_t>& AbaqusSets::members(std::size_t component, bool of_nodes, const std::string& label,
                                                     const DeckPlace& place) {
  for (const SetKey& key : sets_of_label(component, of_nodes, label)) {
    Set* const set = find(key);
    if (set == nullptr) continue;
    if (set->state == Set::State::at_work) fail_at(place, fmt::format("the set {} has itself as a member", set->name));
    resolve(key);
    if (!set->problem.empty()) throw InputError(set->problem);
    return set->members;
  }
  const auto parts = split_label(label);
  const auto other = parts ? component_of(parts->first) : std::nullopt;
  const std::size_t owner = other.value_or(component);
  const auto number = deck_integer(trimmed(other ? parts->second : label));
  if (!number) fail_at(place, fmt::format("there is no set of {}s {}", kind(of_nodes), label));
  const auto place_of = numbered(owner, of_nodes, *number);
  if (!place_of) fail_at(place, fmt::format("{} {} is not there", kind(of_nodes), label));
  Set& single = sets(owner, of_nodes)[fmt::format("{}", *number)];  // kept, and not named in the file
  single.state = Set::State::done;
  single.members = {*place_of};
  return single.members;
}

void AbaqusSets::add_nodes_of_elements(const std::vector<std::int32_t>& elements,
                                       std::vector<std::int32_t>& nodes) const {
  for (const std::int32_t e : elements) add_nodes_of_element(file_, e, nodes);
}

std::vector<AbaqusSets::NameInFile> AbaqusSets::names_in_file(std::size_t component, const std::string& name,
                                                              const std::string& key,
                                                              const std::map<std::string, int>& uses) const {
  const AbaqusComponent& instance = components_[component];
  if (instance.name.empty()) return {{name, key}};
  std::vector<NameInFile> names{{instance.name + '.' + name, instance.key + '.' + key}};
  if (uses.at(key) == 1) names.push_back({name, key});
  return names;
}

AbaqusKeys AbaqusSets::name_all() {
  for (const bool of_nodes : {true, false}) {
    std::map<std::string, int> uses;
    for (std::size_t c = 0; c < components_.size(); ++c) {
      for (const auto& [key, set] : sets(c, of_nodes)) ++uses[key];
    }
    if (of_nodes) node_set_uses_ = uses;
    for (std::size_t c = 0; c < components_.size(); ++c) {
      for (auto& [key, set] : sets(c, of_nodes)) {
        if (set.name.empty()) continue;  // a single node or element
        resolve({c, of_nodes, key});
        for (const auto& [name, full_key] : names_in_file(c, set.name, key, uses)) {
          (of_nodes ? file_.node_sets : file_.element_sets).push_back({0, name, set.members, set.problem});
          (of_nodes ? keys_.node_sets : keys_.element_sets).push_back(full_key);
        }
      }
    }
  }
  for (const auto& surfaces : surfaces_) {
    for (const Surface& surface : surfaces) ++surface_uses_[surface.key];
  }
  for (std::size_t c = 0; c < components_.size(); ++c) {
    for (const Surface& surface : surfaces_[c]) name_surface(c, surface);
  }
  tell_apart(file_.node_sets, keys_.node_sets, &MeshSet::name);
  tell_apart(file_.element_sets, keys_.element_sets, &MeshSet::name);
  tell_apart(file_.face_sets, keys_.face_sets, &FaceSet::name);
  return std::move(keys_);
}

}  // namespace pinball

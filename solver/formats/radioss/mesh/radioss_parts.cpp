#include "radioss_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "radioss_members.hpp"

namespace pinball {

namespace {

void append(std::vector<std::int64_t>& all, const std::vector<std::int64_t>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

RadiossParts::RadiossParts(const RadiossDeck& deck) {
  for (const RadiossBlock& block : deck.blocks) {
    if (block.name == "PART") read_part(block);
    if (block.name == "SUBSET") {
      given_.add(fmt::format("subset {}", block.id()), block.place);
      subsets_[block.id()] = &block;
    }
  }
}

void RadiossParts::read_part(const RadiossBlock& block) {
  RadiossLines lines(block);
  const DataLine line = lines.require("the property and the material of the part");
  const RadiossFields f(line, block, radioss::part);
  given_.add(fmt::format("part {}", block.id()), block.place);
  parts_[block.id()] = {block.id(),    f.integer("prop_ID"), f.integer("mat_ID"), f.integer("subset_ID"),
                        lines.title(), block.place};
}

std::vector<std::int64_t> RadiossParts::named(std::string_view kind, std::int64_t id, const DeckPlace& place) const {
  if (kind == "SUBSET") return of_subset(id, place);
  std::vector<std::int64_t> found;
  for (const auto& [number, part] : parts_) {
    const bool is_named = kind == "PART" ? number == id : kind == "MAT" ? part.material == id : part.property == id;
    if (is_named) found.push_back(number);
  }
  if (found.empty())
    fail_at(place, kind == "PART" ? fmt::format("no /PART has the number {}", id)
                                  : fmt::format("no /PART has the /{} {}", kind, id));
  return found;
}

/// The parts that name it, and those of the subsets in it.
std::vector<std::int64_t> RadiossParts::of_subset(std::int64_t id, const DeckPlace& place) const {
  const auto found = subsets_.find(id);
  if (found == subsets_.end()) fail_at(place, fmt::format("no /SUBSET has the number {}", id));
  if (depth_ > deepest_radioss_group) fail_at(found->second->place, "/SUBSET: the subset is in itself");
  std::vector<std::int64_t> all;
  for (const auto& [number, part] : parts_) {
    if (part.subset == id) all.push_back(number);
  }
  ++depth_;
  for_each_radioss_member(*found->second,
                          [&](std::int64_t member, const DeckPlace& where) { append(all, of_subset(member, where)); });
  --depth_;
  return all;
}

}  // namespace pinball

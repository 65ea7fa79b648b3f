#include <fmt/format.h>

#include <map>

#include <solver/formats/lsdyna/layouts/rigid_cards.hpp>

#include "deck_data.hpp"
#include "deck_parts.hpp"
#include "keyword_rules.hpp"

/// Which parts of a deck are rigid, and which of them are one body.
namespace pinball {

namespace {

/// Into which part each merged one goes, as the cards say.
struct MergedInto {
  std::int64_t part;
  DeckPlace place;
};

using Merged = std::map<std::int64_t, MergedInto>;

/// The part that a chain of merged ones ends at.
std::int64_t end_of_chain(const Merged& merged, std::int64_t part) {
  std::size_t links = 0;
  for (auto next = merged.find(part); next != merged.end(); next = merged.find(part)) {
    if (++links > merged.size())
      fail_at(next->second.place, fmt::format("*CONSTRAINED_RIGID_BODIES: part {} is merged into itself", part));
    part = next->second.part;
  }
  return part;
}

}  // namespace

void DeckData::find_rigid_parts() {
  for (const KeywordBlock& block : deck.blocks) {  // of one number the last counts, as in translate_materials()
    const std::string kind = keyword_alias(block.name);
    if (!kind.starts_with("MAT_") || kind == "MAT_ADD_EROSION") continue;
    const std::int64_t number = material_number(*this, block);
    rigid_materials.erase(number);
    if (kind == "MAT_RIGID") rigid_materials[number] = &block;
  }
  for (DeckPart& part : parts) {
    if (rigid_materials.contains(part.material)) part.lead = part.id;
  }
  merge_rigid_parts();
  find_rigid_nodes();
}

void DeckData::merge_rigid_parts() {
  Merged merged;
  for (const KeywordBlock* block : blocks_of("CONSTRAINED_RIGID_BODIES")) {
    const auto rigid_part = [&](const Card& card, std::int64_t id) {
      if (!body_of(id, card.place)) {
        report.unused(card.place, fmt::format("{} of part {}", block->star_name(), id), "it has no solids");
        return false;
      }
      if (!find_part(id)->is_rigid())
        fail_at(card.place, fmt::format("{}: part {} is not rigid: give it a *MAT_RIGID", block->star_name(), id));
      return true;
    };
    for_each_card(*block, [&](const Card& card) {
      const Fields f = fields(card, layout::merged_parts);
      const std::int64_t add = offset_of(*block, &DeckTransform::part);
      const std::int64_t lead = f.integer("PIDM") + add, part = f.integer("PIDS") + add;
      const bool both = rigid_part(card, lead) && rigid_part(card, part);
      if (!both) return;
      give_once(*block, fmt::format("what the rigid part {} is merged into", part), card.place);
      merged[part] = {lead, card.place};
    });
  }
  for (DeckPart& part : parts) {
    if (part.is_rigid()) part.lead = end_of_chain(merged, part.id);
  }
}

/// Two rigid bodies have no node in common.
void DeckData::find_rigid_nodes() {
  if (rigid_materials.empty()) return;
  lead_of_node.assign(mesh.mesh.nodes.size(), 0);
  for (std::size_t e = 0; e < mesh.mesh.hexahedra.size(); ++e) {
    const DeckPart* part = find_part(mesh.parts[mesh.part[e]].id);
    if (part == nullptr || !part->is_rigid()) continue;
    for (const std::int32_t node : mesh.mesh.hexahedra[e]) {
      std::int64_t& lead = lead_of_node[node];
      if (lead != 0 && lead != part->lead)
        fail_at(part->place, fmt::format("*PART: the rigid parts {} and {} have nodes in common: merge them by "
                                         "*CONSTRAINED_RIGID_BODIES",
                                         lead, part->id));
      lead = part->lead;
    }
  }
}

std::vector<std::string> DeckData::bodies_with(std::int64_t lead) const {
  std::vector<std::string> bodies{find_part(lead)->body};
  for (const DeckPart& part : parts) {
    if (part.lead == lead && part.id != lead) bodies.push_back(part.body);
  }
  return bodies;
}

bool DeckData::reject_rigid_nodes(const std::vector<std::int32_t>& members, const DeckPlace& place,
                                  const std::string& star_name, const char* instead) {
  if (lead_of_node.empty()) return false;
  for (const std::int32_t node : members) {
    if (node < 0 || lead_of_node[node] == 0) continue;
    report.reject(place, fmt::format("{} of nodes of the rigid part {}", star_name, lead_of_node[node]), instead);
    return true;
  }
  return false;
}

}  // namespace pinball

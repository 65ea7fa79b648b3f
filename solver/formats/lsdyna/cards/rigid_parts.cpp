#include <fmt/format.h>

#include <map>

#include <solver/formats/lsdyna/mesh/part_inertia.hpp>

#include "deck_data.hpp"
#include "deck_parts.hpp"
#include "keyword_rules.hpp"

/// Which parts of a deck are rigid, and which of them are one body.
namespace pinball {

namespace {

/// Into which part each merged one goes, as the cards say.
struct MergedInto {
  std::int64_t part;
  bool adds;  ///< to a given inertia
  DeckPlace place;
};

using Merged = std::map<std::int64_t, MergedInto>;

/// A tensor in components of the axes, in those of the deck.
std::array<Point, 3> turned(const std::array<Point, 3>& tensor, const std::array<Point, 3>& axes) {
  std::array<Point, 3> whole{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) whole[i][j] += axes[a][i] * tensor[a][b] * axes[b][j];
      }
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {  // as far as rounding lets it be
    for (std::size_t j = 0; j < i; ++j) whole[i][j] = whole[j][i];
  }
  return whole;
}

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
  for (const KeywordBlock* block : blocks_of("PART_INERTIA")) read_inertias(*block);
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
      merged[part] = {lead, !inertia.empty() && f.integer("IFLAG") == 1, card.place};
    });
  }
  for (DeckPart& part : parts) {
    if (part.is_rigid()) part.lead = end_of_chain(merged, part.id);
  }
  for (const auto& [part, into] : merged) {
    const bool given = inertia.contains(find_part(part)->lead);
    if (given && into.adds)
      report.reject(into.place, "*CONSTRAINED_RIGID_BODIES with IFLAG 1 of a part with *PART_INERTIA",
                    "leave it 0, and give the leading part the inertia of all");
    if (!inertia.contains(part)) continue;
    const DeckPlace& place = inertia.at(part).card.place;
    if (given) {
      report.unused(place, "*PART_INERTIA of a merged part", "that of the leading part is of all");
    } else {
      report.reject(place, "*PART_INERTIA of a merged part", "give the leading part the inertia of all");
    }
  }
}

void DeckData::read_inertias(const KeywordBlock& block) {
  const auto none = [](const Card&, const Card&) {};
  for_each_part(block, none, [&](const Card& card, Cards& cards) {
    const std::int64_t id = fields(card, layout::part).integer("PID") + offset_of(block, &DeckTransform::part);
    const DeckPart* part = find_part(id);
    if (part != nullptr && part->is_rigid()) {
      inertia[id] = read_inertia(block, cards);
    } else {
      report.unused(card.place, fmt::format("{}: XC to VRZ of part {}", block.star_name(), id),
                    part == nullptr ? "it has no solids" : "it is not rigid: its mass is that of its density");
      pass_inertia(cards, deck.parameters);
    }
  });
}

DeckInertia DeckData::read_inertia(const KeywordBlock& block, Cards& cards) {
  const Card first = cards.next_or_blank(), second = cards.next_or_blank(), third = cards.next_or_blank();
  const Fields f = fields(first, layout::part_inertia), moments = fields(second, layout::part_moments),
               v = fields(third, layout::part_velocity);
  if (block.transform && block.transform->transformation != 0)
    report.reject(first.place, block.star_name() + " in a file that is transformed", "move it into a file that is not");
  DeckInertia given;
  given.card = {block.star_name(), first.place};
  given.mass = f.number("TM");
  if (!(given.mass > 0)) f.fail("TM", fmt::format("expected a mass > 0, got {}", given.mass));
  given.centre = f.integer("NODEID") == 0 ? f.point("XC") : Point{};
  if (const std::int64_t node = f.integer("NODEID"); node != 0) {
    const std::int32_t found = nodes.find(node + offset_of(block, &DeckTransform::node));
    if (found < 0) f.fail("NODEID", fmt::format("node {} is not there", node));
    given.centre = mesh.mesh.nodes[found];
  }
  const Point rows = moments.point("IXX"), rest = moments.point("IYY");
  given.inertia = {{{rows[0], rows[1], rows[2]}, {rows[1], rest[0], rest[1]}, {rows[2], rest[1], rest[2]}}};
  given.velocity = v.point("VTX");
  given.angular_velocity = v.point("VRX");
  if (f.integer("IRCS") == 1) {
    const Card last = cards.next_or_blank();
    const Fields s = fields(last, layout::part_system);
    const std::int64_t system = s.integer("CID");
    const auto axes_of_card = [&] { return axes_by(s.point("XL"), s.point("XLIP"), last.place); };
    given.inertia =
        turned(given.inertia,
               system == 0 ? axes_of_card() : axes(system + offset_of(block, &DeckTransform::define), last.place));
  }
  return given;
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
  for (const LayerNodes& layer : mesh.layers) {  // their own nodes are of no solid, and joints know them
    const DeckPart* part = find_part(mesh.parts[layer.part].id);
    std::int64_t& lead = lead_of_node[layer.middle];
    if (lead != 0 && lead != part->lead)
      fail_at(part->place, fmt::format("*PART: the rigid parts {} and {} have nodes in common: merge them by "
                                       "*CONSTRAINED_RIGID_BODIES",
                                       lead, part->id));
    lead = part->lead;
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

#include <fmt/format.h>

#include <solver/formats/lsdyna/layouts/definition_cards.hpp>

#include "deck_parts.hpp"
#include "keyword_rules.hpp"

namespace pinball {

namespace {

void add_limits(const DeckData& data, Cards& cards, const Fields& first, DeckLimits& limits) {
  const Card second = cards.next_or_blank(), damage = cards.next_or_blank(), curves = cards.next_or_blank(),
             last = cards.next_or_blank();
  const Fields f = data.fields(second, layout::erosion_limits), more = data.fields(last, layout::erosion_more);
  data.fields(damage, layout::erosion_damage);
  data.fields(curves, layout::erosion_curves);
  limits.add("tension", -f.number("MNPRES"));
  limits.add("compression", first.number("MXPRES"));
  limits.add("principal_stress", f.number("SIGP1"));
  limits.add("effective_stress", f.number("SIGVM"));
  limits.add("principal_strain", f.number("MXEPS"));
  limits.add("shear_strain", f.number("EPSSH"));
  limits.add("time", f.number("FAILTM"));
  limits.add("smallest_step", more.number("DTMIN"));
}

}  // namespace

std::map<std::int64_t, DeckLimits> limits_of_materials(DeckData& data) {
  std::map<std::int64_t, DeckLimits> all;
  for (const KeywordBlock* block : data.blocks_of("MAT_ADD_EROSION")) {
    Cards cards(*block);
    if (block->title) cards.next();
    const Card card = cards.require("the number of a material");
    const Fields f = data.fields(card, layout::erosion);
    const std::int64_t id = f.integer("MID") + offset_of(*block, &DeckTransform::material);
    data.give_once(*block, fmt::format("erosion of material {}", id), card.place);
    if (!data.is_used(id)) {
      data.report.unused(block->place,
                         fmt::format("{} of material {}, which no part with solids has", block->star_name(), id));
      if (block->log != nullptr) block->log->done(block);
      continue;
    }
    if (data.rigid_materials.contains(id)) {
      data.report.unused(block->place, fmt::format("{} of material {}", block->star_name(), id),
                         "rigid parts have no stress, and do not erode");
      if (block->log != nullptr) block->log->done(block);
      continue;
    }
    if (f.number("EXCL") != 0) {  // what its number stands for in the other fields is no limit, and out of their bounds
      constexpr const CardField& excluded = layout::erosion[layout::erosion.find("EXCL")];
      data.report.reject(card.place, fmt::format("{} with {}", block->star_name(), excluded.name),
                         std::string(excluded.remark));
      if (block->log != nullptr) block->log->done(block);
      continue;
    }
    DeckLimits& limits = all[id];
    limits.card = {block->star_name(), card.place};
    add_limits(data, cards, f, limits);
    if (!limits.any)
      data.report.unused(block->place, fmt::format("{} of material {}", block->star_name(), id), "it has no limit");
  }
  if (data.step_share > 0) {
    for (const DeckPart& part : data.parts) {
      if (part.is_rigid()) continue;
      DeckLimits& limits = all[part.material];
      if (limits.has_share) continue;
      if (!limits.any) limits.card = data.step_card;
      limits.add("step_share", data.step_share);
      limits.has_share = true;
    }
  }
  return all;
}

}  // namespace pinball

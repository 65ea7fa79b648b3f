#include <fmt/format.h>

#include <algorithm>

#include <solver/base/counted.hpp>
#include <solver/formats/lsdyna/layouts/mesh_cards.hpp>

#include "deck_parts.hpp"

namespace pinball {

namespace {

/// A part of nothing but tetrahedra, or wedges, with a form of theirs.
bool is_of_own_shape(const DeckPart& part, std::int64_t form) {
  if (form == 15 || form == 115) return part.wedges == part.solids;
  if (part.ten_nodes) return form == 16 || form == 17;
  return part.tetrahedra == part.solids && (form == 10 || form == 13);
}

/// A rigid part of nothing but shells, which has no *SECTION_SOLID.
bool is_of_shells(const DeckData& data, const DeckPart& part) {
  const auto own = std::ranges::find(data.mesh.parts, part.id, &MeshPart::id);
  return static_cast<std::int64_t>(own->shells) == part.solids;
}

void reject_shells_that_deform(DeckData& data) {
  for (const KeywordBlock* block : data.blocks_of("ELEMENT_SHELL")) {
    std::int64_t count = 0;
    for_each_card(*block, [&](const Card& card) {
      const DeckPart* part =
          data.find_part(data.fields(card, layout::shell).integer("PID") + offset_of(*block, &DeckTransform::part));
      if (part == nullptr || !part->is_rigid()) ++count;
    });
    if (count > 0)
      data.report.reject(block->place, block->star_name() + " of parts that deform",
                         "solids, one or more through the thickness, in their place", static_cast<int>(count));
  }
}

/// What stands in the place of a form of elements that deform, or that there is none.
void tell_form(DeckData& data, const DeckPart& part, std::int64_t form) {
  if (is_of_own_shape(part, form) || form == 0 || form == 1) return;
  if (is_of_full_integration(form)) {
    data.report.understood(
        fmt::format("part {}: ELFORM {}, full integration: elements of assumed strain in its place", part.id, form));
    return;
  }
  data.report.reject(part.place, fmt::format("*SECTION_SOLID with ELFORM {}", form),
                     is_of_users(form) ? "an element that users have written: give 1 or 2"
                     : part.ten_nodes  ? "give 16"
                                       : "give 1 or 2",
                     part.solids);
}

}  // namespace

void translate_parts(DeckData& data, const std::string& mesh_file, std::optional<std::int64_t> chosen_case,
                     DeckScene& scene) {
  const std::map<std::int64_t, std::int64_t> rigid_form{{0, 1}};
  reject_shells_that_deform(data);
  for (std::size_t p = 0; p < data.parts.size(); ++p) {
    const DeckPart& part = data.parts[p];
    const bool of_shells = is_of_shells(data, part);
    const auto form = of_shells ? rigid_form.begin() : data.section_form.find(part.section);
    if (!of_shells && form == data.section_form.end())
      fail_at(part.place, fmt::format("no *SECTION_SOLID has the number {}", part.section));
    if (part.tetrahedra > 0 && !part.is_rigid()) {
      data.report.understood(fmt::format("part {}: {} tetrahedr{} with volumes averaged over nodes, as ELFORM 13",
                                         part.id, part.tetrahedra, part.tetrahedra == 1 ? "on" : "a"));
    }
    if (part.wedges > 0 && !part.is_rigid()) {
      data.report.understood(
          fmt::format("part {}: {} with volumes averaged over nodes", part.id, counted(part.wedges, "wedge")));
    }
    if (!part.is_rigid()) tell_form(data, part, form->second);
    const auto keys = scene.entry<Body>("body", {"*PART", part.place});
    keys.comment("");
    keys.set("name", part.body);
    keys.set("material", fmt::format("mat_{}", part.material), "mid");
    InnerKeys<FileMesh> mesh;
    mesh.set("type", "keyword");
    mesh.set("file", mesh_file);
    if (chosen_case) mesh.set("case", *chosen_case);
    mesh.set("part", std::to_string(part.id));
    keys.set("mesh", mesh.value());
    if (!part.is_rigid() && data.part_elements[p] != data.part_elements.front())
      set_body_element(data.part_elements[p], keys);
  }
}

}  // namespace pinball

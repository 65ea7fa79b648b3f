#include "keyword_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/formats/deck/given_once.hpp>
#include <solver/formats/lsdyna/mesh/keyword_mesh.hpp>
#include <solver/mesh/file/input_file.hpp>

#include "deck_data.hpp"
#include "deck_parts.hpp"
#include "keyword_rules.hpp"
#include "sorted_keywords.hpp"
#include "transformed_keywords.hpp"
#include "unread.hpp"

namespace pinball {

namespace {

std::string rigid_text(const DeckData& data, const DeckPart& part) {
  if (!part.is_rigid()) return "";
  return part.lead == part.id ? ", a rigid body"
                              : fmt::format(", of the rigid body {}", data.find_part(part.lead)->body);
}

std::string elements_text(const MeshPart& part, std::int64_t elements) {
  const auto shells = static_cast<std::int64_t>(part.shells);
  if (shells == 0) return fmt::format("{} solids", elements);
  if (shells == elements) return fmt::format("{} shells", shells);
  return fmt::format("{} solids and {} shells", elements - shells, shells);
}

void describe_mesh(const DeckData& data, DeckReport& report) {
  std::vector<std::int64_t> elements(data.mesh.parts.size(), 0);
  for (const std::int32_t part : data.mesh.part) ++elements[part];
  for (std::size_t p = 0; p < data.mesh.parts.size(); ++p) {
    const DeckPart* part = data.find_part(data.mesh.parts[p].id);
    if (part != nullptr)
      report.understood(fmt::format("part {}: body {} of {}, material mat_{}{}", part->id, part->body,
                                    elements_text(data.mesh.parts[p], elements[p]), part->material,
                                    rigid_text(data, *part)));
  }
}

/// By their numbers: whatever their order in the deck, the scene is the same. Returns these.
std::set<std::int64_t> translate_materials(DeckData& data, DeckScene& scene) {
  std::map<std::int64_t, const KeywordBlock*> materials;
  GivenOnce given;
  for (const KeywordBlock& block : data.deck.blocks) {
    if (!block.name.starts_with("MAT_") || keyword_alias(block.name) == "MAT_ADD_EROSION") continue;
    const std::int64_t number = material_number(data, block);
    given.add(fmt::format("material {}", number), block.place, block.of_case);
    materials[number] = &block;
  }
  const auto limits = limits_of_materials(data);
  for (const auto& [number, block] : materials) {
    const auto own = limits.find(number);
    translate_material(data, *block, own == limits.end() ? DeckLimits{} : own->second, scene);
  }
  std::set<std::int64_t> numbers;
  for (const auto& [number, block] : materials) numbers.insert(number);
  return numbers;
}

void require_materials(const DeckData& data, const std::set<std::int64_t>& numbers) {
  for (const DeckPart& part : data.parts) {
    if (!numbers.contains(part.material))
      fail_at(part.place, fmt::format("no *MAT_... has the number {}{}", part.material,
                                      second_of_keyword(data.deck, "MAT_", part.material, &DeckTransform::material)));
  }
}

/// The scene; what is not done of it goes to the report. of_parts: what is not there; empty once it is known which
/// parts have some of it.
TranslatedDeck scene_of(const KeywordDeck& deck, const std::string& path, const DeckOptions& options,
                        std::vector<KeywordBlock>& of_parts, DeckReport& report) {
  MeshFile mesh = keyword_mesh(deck);
  if (mesh.mesh.hexahedra.empty()) throw InputError(path + ": expected solids (*ELEMENT_SOLID), there are none");
  DeckData data(deck, mesh, report);
  reject_of_parts(std::exchange(of_parts, {}), &data, report);

  DeckScene scene;
  translate_controls(data, scene);
  const bool contact_said = translate_contact(data, scene);
  DeckScene bodies, boundary;
  translate_parts(data, options.mesh_file(path), options.chosen_case, bodies);
  translate_node_codes(data, boundary);
  translate_single_point_constraints(data, boundary);
  const std::set<std::int64_t> materials = translate_materials(data, scene);
  translate_rigid_bodies(data, bodies);
  std::vector<const KeywordBlock*> in_order;
  for (const KeywordBlock& block : deck.blocks) in_order.push_back(&block);
  // Velocities of single nodes count before those of sets and bodies, wherever they stand.
  std::stable_partition(in_order.begin(), in_order.end(),
                        [](const KeywordBlock* block) { return !gives_velocity_of_nodes(*block); });
  for (const KeywordBlock* block : in_order) {
    const KeywordRule* rule = rule_of(keyword_alias(block->name));
    if (rule != nullptr && rule->translate != nullptr) rule->translate(data, *block, boundary);
  }
  tell_order_of_velocities(data);
  tell_reversed(data.mesh.mesh, data.pressed, report);
  translate_probes(data, boundary);
  if (!report.rejects()) require_materials(data, materials);
  data.tell_unused_definitions();
  describe_mesh(data, report);
  for (const std::string& note : deck.parameters.notes()) report.understood(note);
  for (const std::string& note : std::exchange(mesh.notes, {})) report.understood(note);
  if (deck.left_out_of_case > 0) {
    const char* why = deck.case_is_empty ? "; the chosen *CASE lists no numbers (SCID, from its third line on)" : "";
    report.understood(fmt::format("{} keywords belong to other cases: --case takes one of {}{}", deck.left_out_of_case,
                                  fmt::join(deck.cases, ", "), why));
  }
  scene.append(std::move(bodies));
  scene.append(std::move(boundary));
  return given_deck(
      std::move(scene), contact_said, std::move(mesh),
      {.format = MeshFormat::keyword, .file = path, .part = {}, .scale = 1, .chosen_case = options.chosen_case});
}

}  // namespace

TranslatedDeck translate_deck(const std::string& path, const DeckOptions& options) {
  return translate_deck_text(bytes_of_file(path), path, options);
}

TranslatedDeck translate_deck_text(std::string text, const std::string& path, const DeckOptions& options) {
  KeywordDeck deck = parse_keyword_deck(std::move(text), path, options.chosen_case);
  DeckReport report;
  UnreadKeywords unread = sort_keywords(deck, options.lenient, report);
  ReadingLog log;
  follow_reading(deck, log);
  TranslatedDeck translated;
  try {
    reject_transformed(deck, report);
    if (!unread.of_mesh) translated = scene_of(deck, path, options, unread.of_parts, report);
    tell_unread(deck, log, report);
  } catch (const InputError& error) {
    if (!report.rejects() && unread.of_parts.empty()) throw;
    report.add_error(error.what());
  }
  reject_of_parts(unread.of_parts, nullptr, report);
  report.require_all_done(path);
  translated.understood = report.understood();
  translated.ignored = report.ignored();
  return translated;
}

}  // namespace pinball

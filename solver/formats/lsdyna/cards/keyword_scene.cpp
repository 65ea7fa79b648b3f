#include "keyword_scene.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/formats/deck/given_once.hpp>
#include <solver/formats/lsdyna/mesh/keyword_mesh.hpp>
#include <solver/mesh/file/input_file.hpp>
#include <solver/mesh/held_mesh.hpp>

#include "deck_data.hpp"
#include "deck_parts.hpp"
#include "keyword_rules.hpp"
#include "sorted_keywords.hpp"
#include "unread.hpp"

namespace pinball {

namespace {

using Translate = void (*)(DeckData&, const KeywordBlock&, DeckScene&);

/// Keywords that become tables one by one, in the order of the deck; all others are looked at together.
Translate translation_of(const std::string& name) {
  static const std::map<std::string, Translate> table{
      {"BOUNDARY_PRESCRIBED_MOTION_NODE", translate_prescribed_motion},
      {"BOUNDARY_PRESCRIBED_MOTION_SET", translate_prescribed_motion},
      {"BOUNDARY_PRESCRIBED_MOTION_RIGID", translate_prescribed_motion},
      {"INITIAL_VELOCITY", translate_initial_velocity},
      {"INITIAL_VELOCITY_SET", translate_initial_velocity},
      {"INITIAL_VELOCITY_NODE", translate_initial_velocity_of_nodes},
      {"INITIAL_VELOCITY_GENERATION", translate_velocity_generation},
      {"LOAD_NODE_SET", translate_node_load},
      {"LOAD_NODE_POINT", translate_node_load},
      {"LOAD_SEGMENT", translate_segment_load},
      {"LOAD_SEGMENT_SET", translate_segment_set_load},
      {"LOAD_BODY_VECTOR", translate_body_load},
      {"LOAD_BODY_X", translate_body_load},
      {"LOAD_BODY_Y", translate_body_load},
      {"LOAD_BODY_Z", translate_body_load},
  };
  const auto found = table.find(name);
  return found == table.end() ? nullptr : found->second;
}

void describe_mesh(const DeckData& data, DeckReport& report) {
  std::vector<std::int64_t> elements(data.mesh.parts.size(), 0);
  for (const std::int32_t part : data.mesh.part) ++elements[part];
  for (std::size_t p = 0; p < data.mesh.parts.size(); ++p) {
    const DeckPart* part = data.find_part(data.mesh.parts[p].id);
    if (part != nullptr)
      report.understood(fmt::format("part {}: body {} of {} solids, material mat_{}", part->id, part->body, elements[p],
                                    part->material));
  }
}

/// By their numbers: whatever their order in the deck, the scene is the same.
void translate_materials(DeckData& data, DeckScene& scene) {
  std::map<std::int64_t, const KeywordBlock*> materials;
  GivenOnce given;
  for (const KeywordBlock& block : data.deck.blocks) {
    if (!block.name.starts_with("MAT_")) continue;
    const std::int64_t number = material_number(data, block);
    given.add(fmt::format("material {}", number), block.place, block.of_case);
    materials[number] = &block;
  }
  for (const auto& [number, block] : materials) translate_material(data, *block, scene);
}

/// As a scene names the deck, from which its meshes are read.
std::string mesh_file_of(const std::string& path, const DeckOptions& options) {
  return options.name_in_scene.empty() ? std::filesystem::path(path).filename().string() : options.name_in_scene;
}

/// The scene; what is not done of it goes to the report. of_parts: what is not there; empty once it is known which
/// parts have some of it.
TranslatedDeck scene_of(const KeywordDeck& deck, const std::string& path, const DeckOptions& options,
                        std::vector<KeywordBlock>& of_parts, DeckReport& report) {
  MeshFile mesh = keyword_mesh(deck);
  if (mesh.mesh.hexahedra.empty()) throw InputError(path + ": expected solids (*ELEMENT_SOLID), there are none");
  DeckData data(deck, mesh, report);
  refuse_of_parts(std::exchange(of_parts, {}), &data, report);

  DeckScene scene;
  translate_controls(data, scene);
  const bool contact_said = translate_contact(data, scene);
  DeckScene bodies, boundary;
  std::size_t walls = 0;
  translate_parts(data, mesh_file_of(path, options), options.chosen_case, bodies);
  translate_node_codes(data, boundary);
  translate_single_point_constraints(data, boundary);
  translate_materials(data, scene);
  for (const KeywordBlock& block : deck.blocks) {
    const std::string name = keyword_alias(block.name);
    if (name.starts_with("RIGIDWALL_PLANAR")) translate_rigid_walls(data, block, walls, boundary);
    const Translate translate = translation_of(name);
    if (translate != nullptr) translate(data, block, boundary);
  }
  tell_order_of_velocities(data);
  tell_reversed(data.mesh.mesh, data.pressed, report);
  translate_probes(data, boundary);
  describe_mesh(data, report);
  for (const std::string& note : deck.parameters.notes()) report.understood(note);
  if (deck.left_out_of_case > 0)
    report.understood(fmt::format("{} keywords belong to other cases: --case takes one of {}", deck.left_out_of_case,
                                  fmt::join(deck.cases, ", ")));
  scene.append(std::move(bodies));
  scene.append(std::move(boundary));
  TranslatedDeck translated = given_deck(std::move(scene), path, contact_said);
  FileMesh settings;
  settings.format = MeshFormat::keyword;
  settings.file = path;
  settings.chosen_case = options.chosen_case;
  translated.given->mesh = std::make_shared<HeldMesh>(std::move(mesh), settings);
  return translated;
}

}  // namespace

bool is_deck(const std::string& path) {
  const std::string ending = lower_case(std::filesystem::path(path).extension().string());
  return ending == ".k" || ending == ".key" || ending == ".dyn";
}

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
    if (!unread.of_mesh) translated = scene_of(deck, path, options, unread.of_parts, report);
    tell_unread(deck, log, report);
  } catch (const InputError& error) {
    if (!report.refuses() && unread.of_parts.empty()) throw;
    report.add_error(error.what());
  }
  refuse_of_parts(unread.of_parts, nullptr, report);
  report.require_all_done(path);
  translated.understood = report.understood();
  translated.ignored = report.ignored();
  return translated;
}

}  // namespace pinball

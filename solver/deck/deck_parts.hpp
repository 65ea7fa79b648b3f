#pragma once

#include "deck_data.hpp"
#include "toml_text.hpp"

/// Keywords of a deck as tables of a scene, one function per kind.
namespace pinball {

/// *MAT_...: a [[material]] each, named mat_NUMBER; those that no part has are left out.
void translate_material(DeckData& data, const KeywordBlock& block, TomlText& scene);

/// A [[body]] for each part that has solids; mesh_file: as the scene names it.
void translate_parts(DeckData& data, const std::string& mesh_file, TomlText& scene);

/// *NODE: constraints of TC, all nodes of one code together.
void translate_node_codes(DeckData& data, TomlText& scene);
/// *BOUNDARY_SPC_NODE, _SET: those with the same directions together.
void translate_single_point_constraints(DeckData& data, TomlText& scene);
void translate_prescribed_motion(DeckData& data, const KeywordBlock& block, TomlText& scene);
void translate_initial_velocity(DeckData& data, const KeywordBlock& block, TomlText& scene);
void translate_initial_velocity_of_nodes(DeckData& data, const KeywordBlock& block, TomlText& scene);
void translate_velocity_generation(DeckData& data, const KeywordBlock& block, TomlText& scene);
void translate_rigid_wall(DeckData& data, const KeywordBlock& block, std::size_t number, TomlText& scene);
void translate_node_load(DeckData& data, const KeywordBlock& block, TomlText& scene);
void translate_body_load(DeckData& data, const KeywordBlock& block, TomlText& scene);

/// All contact keywords together: [contact].
void translate_contact(DeckData& data, TomlText& scene);
/// CONTROL, DAMPING, DATABASE: title, [time], [element], [damping], [output], and probes.
void translate_controls(DeckData& data, TomlText& scene);
void translate_probes(DeckData& data, TomlText& scene);

}  // namespace pinball

#include "radioss_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/formats/radioss/mesh/radioss_mesh.hpp>
#include <solver/formats/radioss/mesh/radioss_shells.hpp>
#include <solver/mesh/file/input_file.hpp>

#include "radioss_keys.hpp"
#include "radioss_rules.hpp"
#include "radioss_unread.hpp"

namespace pinball {

namespace {

/// Laws, properties and what stands beside materials that are not done: refused where a part with solids has them.
void reject_of_parts(const RadiossData& data) {
  for (const RadiossBlock& block : data.deck.blocks) {
    const RadiossRule* rule = radioss_rule_of(block.name);
    if (rule == nullptr || rule->treatment != Treatment::rejected || !is_of_radioss_parts(block)) continue;
    const bool property = block.name.starts_with("PROP/");
    int solids = 0;
    for (const RadiossBody& body : data.bodies)
      solids += (property ? body.part.property : body.part.material) == block.id() ? body.solids : 0;
    if (solids > 0) {
      data.report.reject(block.place, block.title, "", solids);
    } else if (block.name.starts_with("FAIL/")) {  // of others it is said where they are read
      data.report.unused(block.place, fmt::format("{}, which no part with solids has", block.title));
    }
  }
}

/// Of parts that have become no layers.
void reject_shells_that_deform(const RadiossDeck& deck, const MeshFile& mesh, DeckReport& report) {
  for (const RadiossBlock& block : deck.blocks) {
    if (!is_of_shells(block)) continue;
    const auto part = std::ranges::find(mesh.parts, block.id(), &MeshPart::id);
    if (part == mesh.parts.end() || part->shells == 0)
      report.reject(block.place, '/' + block.name + " of a part that deforms",
                    "solids, one or more through the thickness, in their place");
  }
}

/// What acts has a number of its kind, once: of two the second would add to the first. Of /BCS both hold, as in the
/// starter, which is reported.
void require_one_of_each(const RadiossDeck& deck, DeckReport& report) {
  static const std::set<std::string> kinds{"IMPVEL", "IMPDISP", "IMPACC", "INIVEL", "GRAV", "CLOAD", "PLOAD", "RWALL"};
  GivenOnce given;
  std::set<std::int64_t> held;
  for (const RadiossBlock& block : deck.blocks) {
    if (block.name == "BCS" && !block.numbers.empty() && !held.insert(block.id()).second)
      report.understood(
          fmt::format("{} ({}): stands there once more, and holds beside the other", block.title, block.place.text()));
    const std::string kind = block.name.substr(0, block.name.find('/'));
    if (kinds.contains(kind) && !block.numbers.empty()) given.add(fmt::format("/{}/{}", kind, block.id()), block.place);
  }
}

TranslatedDeck scene_of(const RadiossDeck& deck, const std::string& path, const DeckOptions& options,
                        DeckReport& report) {
  std::size_t given_nodes = 0;
  MeshFile mesh = radioss_mesh(deck, &given_nodes);
  reject_shells_that_deform(deck, mesh, report);
  if (mesh.mesh.hexahedra.empty()) throw InputError(path + ": expected solids (/BRICK), there are none");
  RadiossData data(deck, mesh, report);
  data.given_nodes = given_nodes;
  require_one_of_each(deck, report);
  reject_of_parts(data);
  const std::vector<RadiossJoint> joints = find_radioss_joints(data);
  find_radioss_rigid_bodies(data);
  DeckScene scene, bodies, boundary;
  data.elements = radioss_elements(data);
  translate_radioss_controls(data, scene);
  const bool contact_said = translate_radioss_contact(data, scene);
  translate_radioss_materials(data, scene);
  translate_radioss_bodies(data, options.mesh_file(path), bodies);
  translate_radioss_walls(data, boundary);  // whose nodes the next ones pass over
  translate_radioss_boundary(data, boundary);
  translate_radioss_velocities(data, boundary);
  translate_radioss_stresses(data, boundary);
  translate_radioss_loads(data, boundary);
  translate_radioss_added_masses(data, boundary);
  translate_radioss_rigid_bodies(data, bodies);
  translate_radioss_joints(data, joints, bodies);
  translate_radioss_probes(data, boundary);
  data.tell_unused_definitions();
  if (const std::string next = radioss_engine_of(path, 2); !next.empty())
    report.understood(fmt::format("{}, with which the run would go on, is not read", next));
  for (const std::string& note : std::exchange(mesh.notes, {})) report.understood(note);
  scene.append(std::move(bodies));
  scene.append(std::move(boundary));
  return given_deck(std::move(scene), contact_said, std::move(mesh),
                    {.format = MeshFormat::radioss, .file = path, .part = {}});
}

}  // namespace

TranslatedDeck translate_radioss(const std::string& path, const DeckOptions& options) {
  return translate_radioss_text(bytes_of_file(path), path, options);
}

TranslatedDeck translate_radioss_text(std::string text, const std::string& path, const DeckOptions& options) {
  if (options.chosen_case) throw InputError(path + ": --case is for LS-DYNA decks (.k, .key, .dyn)");
  RadiossDeck deck = parse_radioss_deck(std::move(text), path);
  ReadingLog log;
  follow_reading(deck, log);
  DeckReport report;
  for (const RadiossBlock& block : deck.blocks) sort_radioss_keyword(block, options.lenient, report);
  TranslatedDeck translated;
  try {
    translated = scene_of(deck, path, options, report);
    tell_unread(deck, log, report);
  } catch (const InputError& error) {
    if (!report.rejects()) throw;
    report.add_error(error.what());
  }
  report.require_all_done(path);
  translated.understood = report.understood();
  translated.ignored = report.ignored();
  return translated;
}

}  // namespace pinball

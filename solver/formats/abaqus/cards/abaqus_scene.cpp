#include "abaqus_scene.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/formats/abaqus/mesh/abaqus_rigid_elements.hpp>
#include <solver/mesh/file/input_file.hpp>

#include "abaqus_parts.hpp"
#include "abaqus_rules.hpp"
#include "abaqus_transform.hpp"
#include "abaqus_unread.hpp"

namespace pinball {

namespace {

/// Whether what a keyword has depends on temperature or fields: behind so many fields of its data lines. Where all
/// lines are of the same ones, as a single line is, it does not. one_line: more lines are those of other temperatures.
bool depends_on_more(const AbaqusBlock& block, std::size_t fields, bool one_line) {
  DataLines lines(block);
  std::optional<std::vector<double>> first;
  while (const auto card = lines.next()) {
    std::vector<double> more;
    for (const std::string_view entry : entries_of(card->text)) more.push_back(deck_number(entry).value_or(0.0));
    more.erase(more.begin(), more.begin() + static_cast<std::ptrdiff_t>(std::min(fields, more.size())));
    if (first && (one_line || more != *first)) return true;
    first = more;
  }
  return false;
}

/// Whether its first field is all that it has.
bool is_one_constant(const AbaqusBlock& block) {
  return block.name == "SPECIFICHEAT" || block.name == "INELASTICHEATFRACTION" || block.name == "EXPANSION" ||
         block.name == "DENSITY" || block.name == "SHEARFAILURE";
}

/// The first kind of load of *DLOAD or *DSLOAD that is not done; empty: none.
std::string rejected_load(const AbaqusBlock& block) {
  DataLines lines(block);
  while (const auto card = lines.next()) {
    const std::string kind = squeezed(DataFields(*card).text(1));
    const bool face = kind.size() == 2 && kind[0] == 'P' && kind[1] >= '1' && kind[1] <= '6';
    if (block.name == "DSLOAD" ? kind != "P" : kind != "GRAV" && !face) return block.star_name() + ", " + kind;
  }
  return "";
}

/// What of the data lines of a keyword is not done; empty: nothing.
std::string rejected_data(const AbaqusBlock& block) {
  const std::string& name = block.name;
  if (name == "ELEMENT") {
    const std::string type = block.option("TYPE");
    const bool known = nodes_of_rigid_element(type) > 0 || is_point_element(type) ||
                       element_type(&ElementType::abaqus, type) != nullptr;
    return known ? "" : "*ELEMENT, TYPE=" + type;
  }
  const bool is_isotropic = name == "ELASTIC" && (!block.has("TYPE") || block.option("TYPE").starts_with("ISO")),
             is_johnson_cook = name == "PLASTIC" && block.option("HARDENING") == "JOHNSONCOOK";
  const bool depends =
      (is_one_constant(block) && depends_on_more(block, 1, true)) ||
      (is_isotropic && depends_on_more(block, 2, true)) ||
      (name == "HYPERELASTIC" && (block.has("NEOHOOKE") || block.has("MOONEY-RIVLIN")) &&
       depends_on_more(block, block.has("NEOHOOKE") ? 2 : 3, true)) ||
      (is_johnson_cook && depends_on_more(block, 6, true)) ||
      (name == "DRUCKERPRAGER" && depends_on_more(block, 3, true)) ||
      (name == "DRUCKERPRAGERHARDENING" && depends_on_more(block, 2, false)) ||
      ((name == "PLASTIC" || name == "RATEDEPENDENT") && !is_johnson_cook && depends_on_more(block, 2, false));
  if (depends) return block.star_name() + " that depends on temperature or fields";
  if ((name == "HYPERELASTIC" || name == "HYPERFOAM") && block.has("TESTDATAINPUT"))
    return block.star_name() + " of test data (it is not fitted: give its constants)";
  if (name == "DLOAD" || name == "DSLOAD") return rejected_load(block);
  if (name == "DAMPING" && block.number("BETA", 0.0) != 0) return "*DAMPING, BETA";
  return "";
}

/// What each keyword is: the deck is refused as a whole, before its mesh is read.
void sort_keywords(const AbaqusDeck& deck, bool lenient, DeckReport& report) {
  bool has_steps = false;
  for (const AbaqusBlock& block : deck.blocks) {
    has_steps |= block.step > 0;
    sort_abaqus_keyword(block, lenient, report);
    if (has_steps && block.step == 0 && block.name == "BOUNDARY")
      report.reject(block.place, "*BOUNDARY behind *END STEP", "move it into a step, or before the first one");
    if (const std::string what = rejected_data(block); !what.empty()) report.reject(block.place, what);
  }
}

}  // namespace

TranslatedDeck translate_abaqus(const std::string& path, const DeckOptions& options) {
  return translate_abaqus_text(bytes_of_file(path), path, options);
}

TranslatedDeck translate_abaqus_text(std::string text, const std::string& path, const DeckOptions& options) {
  if (options.chosen_case) throw InputError(path + ": --case is for LS-DYNA decks (.k, .key, .dyn)");
  AbaqusDeck deck = parse_abaqus_deck(std::move(text), path);
  ReadingLog log;
  follow_reading(deck, log);
  DeckReport report;
  sort_keywords(deck, options.lenient, report);
  report.require_all_done(path);
  AbaqusMesh mesh = abaqus_mesh(deck);
  if (mesh.file.mesh.hexahedra.empty()) throw InputError(path + ": expected solids (*ELEMENT), there are none");
  AbaqusData data(deck, mesh, report);

  find_abaqus_rigid_bodies(data);
  find_abaqus_point_masses(data);
  DeckScene scene, bodies, boundary;
  data.body_elements = abaqus_elements(data);
  translate_abaqus_controls(data, scene);
  const bool contact_said = translate_abaqus_contact(data, scene);
  translate_abaqus_materials(data, scene);
  translate_abaqus_bodies(data, options.mesh_file(path), bodies);
  const AbaqusTransforms transforms(data);
  translate_abaqus_boundary(data, transforms, boundary);
  translate_abaqus_equations(data, transforms, boundary);
  translate_abaqus_initial_velocities(data, boundary);
  translate_abaqus_initial_stresses(data, boundary);
  translate_abaqus_loads(data, transforms, boundary);
  data.point_masses.write(mesh.file.node_ids, "mass", "ELSET", boundary);
  translate_abaqus_rigid_bodies(data, bodies);
  translate_abaqus_probes(data, boundary);
  data.tell_unused_definitions();
  for (const std::string& note : deck.notes) report.understood(note);
  for (const std::string& note : std::exchange(mesh.file.notes, {})) report.understood(note);
  tell_unread(deck, log, report);
  report.require_all_done(path);
  scene.append(std::move(bodies));
  scene.append(std::move(boundary));
  TranslatedDeck translated = given_deck(std::move(scene), contact_said, std::move(mesh.file),
                                         {.format = MeshFormat::abaqus, .file = path, .part = {}});
  translated.understood = report.understood();
  translated.ignored = report.ignored();
  return translated;
}

}  // namespace pinball

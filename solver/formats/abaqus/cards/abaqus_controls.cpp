#include <fmt/format.h>

#include <algorithm>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

void write_title(const AbaqusData& data, DeckScene& scene) {
  std::string title;
  if (const AbaqusBlock* heading = data.last("HEADING")) {
    DataLines lines(*heading);
    if (const auto card = lines.next()) title = std::string(card->text);
  }
  scene.top().set("title", title);
  scene.top().set("units", "");
}

/// DT is the stable increment that elements get mass for; the step is SCALE FACTOR times it.
void set_mass_scaling(AbaqusData& data, double factor, DeckKeys<TimeSettings> keys) {
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name != "FIXEDMASSSCALING") continue;
    const double step = block.number("DT", 0.0);
    if (!(step > 0)) fail_at(block.place, "*FIXED MASS SCALING: DT: expected more than 0");
    if (data.whole_bodies(block.value("ELSET").value_or(""), block.place).size() != data.bodies.size())
      data.report.reject(block.place, "*FIXED MASS SCALING of some elements");
    keys.from(card_of(block, block.place));
    keys.set("smallest_step", factor * step);
    if (block.option("TYPE") == "SETEQUALDT") keys.set("mass_scaling", "all");
  }
}

/// The part of the stable increment that steps are, which is one for all of them.
double scale_factor(AbaqusData& data) {
  const AbaqusBlock& last = *data.last("DYNAMIC");
  const double factor = last.number("SCALEFACTOR", 1.0);
  if (!(factor > 0)) fail_at(last.place, "*DYNAMIC: SCALE FACTOR: expected more than 0");
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name == "DYNAMIC" && block.number("SCALEFACTOR", 1.0) != factor)
      data.report.reject(last.place, "*DYNAMIC: another SCALE FACTOR than in a step before");
  }
  return factor;
}

void write_time(AbaqusData& data, DeckScene& scene) {
  const AbaqusBlock& dynamic = *data.last("DYNAMIC");
  DataLines lines(dynamic);
  const DataLine card = lines.require("the period of the step");
  const DataFields f(card);
  const auto keys = scene.table<TimeSettings>("time", card_of(dynamic, card.place));
  keys.comment("");
  keys.set("end", data.end());
  const double factor = scale_factor(data);
  keys.set("cfl", 0.9 * factor);
  set_mass_scaling(data, factor, keys);
  if (f.number(3, "largest increment", 0.0) > 0)
    data.report.understood(
        fmt::format("*DYNAMIC ({}): the largest increment is not used, steps are the stable ones", card.place.text()));
}

/// Fields at so many equal intervals of the step, 20 where nothing is said; rows of history.csv 200. Of several
/// requests the one that is more.
void write_output(const AbaqusData& data, DeckScene& scene) {
  const auto keys = scene.table<OutputSettings>("output", {});
  const auto interval = [&](const AbaqusBlock& block) {
    const double intervals = block.number("NUMBERINTERVAL", 0.0), time = block.number("TIMEINTERVAL", 0.0);
    return time > 0 ? time : intervals > 0 ? data.step_of(block).period / intervals : 0.0;
  };
  const auto smaller = [](double so_far, double given) { return so_far > 0 ? std::min(so_far, given) : given; };
  double fields = 0, rows = 0;
  bool of_bodies = false;
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name == "ENERGYOUTPUT" && block.has("ELSET")) of_bodies = true;
    if (block.name != "OUTPUT") continue;
    const double given = interval(block);
    if (block.has("FIELD")) fields = smaller(fields, given > 0 ? given : data.step_of(block).period / 20);
    if (block.has("HISTORY") && given > 0) rows = smaller(rows, given);
  }
  if (rows > 0) keys.set("interval", rows);
  if (fields > 0) keys.set("field_interval", fields);
  if (of_bodies) keys.set("body_energies", true);
}

}  // namespace

void translate_abaqus_controls(AbaqusData& data, DeckScene& scene) {
  write_title(data, scene);
  write_time(data, scene);
  if (!data.bodies.empty()) set_element(data.body_elements.front(), scene.table<ElementSettings>("element", {}));
  write_output(data, scene);
}

void translate_abaqus_bodies(const AbaqusData& data, const std::string& mesh_file, DeckScene& scene) {
  for (const AbaqusBody& body : data.bodies) {
    const AbaqusBlock& section = *data.mesh.sections[body.section].block;
    const auto keys = scene.entry<Body>("body", card_of(section, section.place));
    keys.comment("");
    keys.set("name", body.name);
    keys.set("material", data.material_name(body.material));
    const DeckElement& element = data.body_elements[&body - data.bodies.data()];
    if (element != data.body_elements.front()) set_body_element(element, keys);
    InnerKeys<FileMesh> mesh;
    mesh.set("type", "abaqus");
    mesh.set("file", mesh_file);
    mesh.set("part", body.part);
    keys.set("mesh", mesh.value());
  }
}

}  // namespace pinball

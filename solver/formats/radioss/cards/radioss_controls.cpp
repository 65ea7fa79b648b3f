#include <fmt/format.h>

#include <algorithm>

#include <solver/base/error.hpp>
#include <solver/formats/radioss/layouts/radioss_boundary_cards.hpp>
#include <solver/formats/radioss/layouts/radioss_control_cards.hpp>

#include "radioss_keys.hpp"

namespace pinball {

namespace {

/// The one block of a name that a deck has; a second one is an error.
const RadiossBlock* only(const RadiossData& data, const char* name) {
  const auto& blocks = data.blocks_of(name);
  if (blocks.size() > 1)
    fail_at(blocks[1]->place, fmt::format("{} is given twice, first in {}", blocks[1]->title, blocks[0]->place.text()));
  return blocks.empty() ? nullptr : blocks.front();
}

/// A step that is 0 is the default. That of solids counts before that of all, and nodal steps before both.
void set_step(RadiossData& data, const DeckKeys<TimeSettings>& of_run) {
  DeckKeys<TimeSettings> keys = of_run;
  for (const char* name : {"DT", "DT/BRICK/STOP", "DT/BRICK/CST", "DT/NODA", "DT/NODA/CST"}) {
    const RadiossBlock* block = only(data, name);
    if (block == nullptr) continue;
    RadiossLines lines(*block);
    const DataLine line = lines.next_or_blank();
    const bool scales = block->name == "DT/NODA/CST";
    const RadiossFields f(line, *block, scales ? radioss::step_mass : radioss::step);
    const double given = f.number("Tsca"), factor = given > 0 ? given : 0.9;
    keys.from(card_of(*block, line.place));
    keys.set("cfl", factor, "Tsca");
    if (!scales) continue;
    const double step = f.number("Tmin");
    if (step > 0) keys.set("smallest_step", step, "Tmin");
    if (step > 0)
      data.report.understood(
          fmt::format("{} ({}): elements whose step is less than {:.6g} get mass at the start, and "
                      "not again where they become smaller",
                      block->title, line.place.text(), step));
  }
  if (const RadiossBlock* block = only(data, "DTIX")) {
    RadiossLines lines(*block);
    const DataLine line = lines.next_or_blank();
    RadiossFields(line, *block, radioss::first_step);
  }
}

void set_time(RadiossData& data, DeckScene& scene) {
  const RadiossBlock* run = only(data, "RUN");
  if (run == nullptr) {
    const std::string name = data.deck.engine.empty() ? "NAME_0001.rad beside NAME_0000.rad" : data.deck.engine;
    throw InputError(
        fmt::format("{}: expected /RUN with the time of the end in the file of the engine, {}", data.mesh.path, name));
  }
  auto keys = scene.table<TimeSettings>("time", card_of(*run, run->place));
  keys.comment("");
  keys.set("end", data.run_end(), "Tstop");
  set_step(data, keys);
}

/// Of a line of an engine's block; 0 where the deck has none.
double interval_of(const RadiossData& data, const char* name, const CardLayout& layout, const char* field,
                   DeckCard& card) {
  const RadiossBlock* block = only(data, name);
  if (block == nullptr) return 0;
  RadiossLines lines(*block);
  const DataLine line = lines.next_or_blank();
  card = card_of(*block, line.place);
  return RadiossFields(line, *block, layout).number(field);
}

void set_output(RadiossData& data, DeckScene& scene) {
  DeckCard of_rows, of_fields;
  const double rows = interval_of(data, "TFILE", radioss::th_step, "DT_his", of_rows),
               fields = interval_of(data, "ANIM/DT", radioss::anim_step, "Tfreq", of_fields);
  auto keys = scene.table<OutputSettings>("output", of_rows);
  keys.comment("");
  if (rows > 0) keys.set("interval", rows, "DT_his");
  if (const RadiossBlock* part = data.last("TH/PART")) {
    keys.from(card_of(*part, part->place));
    keys.set("body_energies", true);
    data.report.understood("/TH/PART: energies, momentum and mass of all bodies");
    for (const RadiossBlock* block : data.blocks_of("TH/PART")) {
      if (block->log != nullptr) block->log->done(block);
    }
  }
  if (fields > 0) {
    keys.from(of_fields);
    keys.set("field_interval", fields, "Tfreq");
  }
}

void set_damping(RadiossData& data, DeckScene& scene) {
  const RadiossBlock* block = only(data, "DAMP");
  if (block == nullptr) return;
  RadiossLines lines(*block);
  const DataLine line = lines.require("the coefficients of damping");
  const RadiossFields f(line, *block, radioss::damping);
  while (const auto more = lines.next_filled()) RadiossFields(*more, *block, radioss::damping_more);
  const std::int64_t group = f.integer("grnod_ID");
  if (group != 0) {
    const MeshSet& nodes = data.node_group(group, line.place);
    for (std::size_t n = 0; n < data.used.size(); ++n) {
      if (!data.used[n] || std::ranges::binary_search(nodes.members, static_cast<std::int32_t>(n))) continue;
      data.report.reject(line.place, block->title + " of some nodes", "give a group of all nodes, or 0");
      break;
    }
  }
  const auto keys = scene.table<DampingSettings>("damping", card_of(*block, line.place));
  keys.comment("");
  keys.set("mass", f.number("Alpha"), "Alpha");
}

/// What changes the answer where it is not 0, and limits that end a run of another program.
void read_switches(const RadiossData& data) {
  for (const char* name : {"STOP", "KILL"}) {
    const RadiossBlock* block = only(data, name);
    if (block == nullptr) continue;
    RadiossLines lines(*block);
    const DataLine line = lines.next_or_blank();
    RadiossFields(line, *block, radioss::limits);
  }
  if (const RadiossBlock* block = only(data, "ANALY")) {
    RadiossLines lines(*block);
    const DataLine line = lines.next_or_blank();
    RadiossFields(line, *block, radioss::analysis);
  }
  if (const RadiossBlock* block = only(data, "RANDOM")) {
    RadiossLines lines(*block);
    const DataLine line = lines.next_or_blank();
    RadiossFields(line, *block, radioss::random_noise);
  }
}

std::string title_of(const RadiossData& data) {
  for (const RadiossBlock* block : data.blocks_of("TITLE")) {
    RadiossLines lines(*block);
    const auto line = lines.next_filled();
    if (block->log != nullptr) block->log->done(block);
    if (!block->engine && line) return std::string(trimmed(line->text));
  }
  return "";
}

}  // namespace

void translate_radioss_controls(RadiossData& data, DeckScene& scene) {
  std::string title = title_of(data);
  for (const RadiossBlock* block : data.blocks_of("TITLE")) {
    if (block->log != nullptr) block->log->done(block);
  }
  scene.top().set("title", title);
  scene.top().set("units", "");
  read_switches(data);
  set_time(data, scene);
  set_element(data.elements.front(), scene.table<ElementSettings>("element", {}));
  set_damping(data, scene);
  set_output(data, scene);
}

}  // namespace pinball

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <solver/keyword/number_index.hpp>

#include "deck_parts.hpp"

namespace pinball {

namespace {

/// The first card of the last keyword of a name, which is the one that counts; none: the deck has none.
std::optional<Card> last_card(const DeckData& data, const std::string& name) {
  std::optional<Card> found;
  for (const KeywordBlock& block : data.deck.blocks) {
    if (block.name != name) continue;
    Cards cards(block);
    if (const auto card = cards.next()) found = card;
  }
  return found;
}

void write_time(DeckData& data, TomlText& scene) {
  const auto termination = last_card(data, "CONTROL_TERMINATION");
  if (!termination)
    fail_at({std::make_shared<const std::string>(data.mesh.path), 1},
            "expected *CONTROL_TERMINATION with the time of the end");
  const Fields end = data.fields(*termination);
  scene.table("time");
  scene.key("end", end.number(0, "endtim"));
  if (const std::int64_t cycles = end.integer(1, "endcyc", 0); cycles > 0) scene.key("steps", cycles);
  const auto step = last_card(data, "CONTROL_TIMESTEP");
  if (!step) return;
  const Fields f = data.fields(*step);
  const double factor = f.number(1, "tssfac", 0.9);
  scene.key("cfl", factor == 0 ? 0.9 : factor);
  if (f.number(4, "dt2ms", 0.0) != 0) data.report.refuse(step->place, "*CONTROL_TIMESTEP with mass scaling (DT2MS)");
  if (f.integer(5, "lctm", 0) != 0)
    data.report.refuse(step->place, "*CONTROL_TIMESTEP with a curve of the step (LCTM)");
}

/// The form of hourglass control that all parts have, and its coefficient.
void write_element(DeckData& data, TomlText& scene) {
  DeckHourglass common;
  if (const auto card = last_card(data, "CONTROL_HOURGLASS")) {
    const Fields f = data.fields(*card);
    common = {f.integer(0, "ihq", 0), f.number(1, "qh", 0.1)};
    if (common.form == 0) common.form = 1;
    if (common.coefficient == 0) common.coefficient = 0.1;
  }
  std::set<std::pair<std::string, double>> forms;
  for (const DeckPart& part : data.parts) {
    DeckHourglass h = common;
    if (part.hourglass != 0) {
      const auto found = data.hourglass.find(part.hourglass);
      if (found == data.hourglass.end())
        fail_at(part.place, fmt::format("no *HOURGLASS has the number {}", part.hourglass));
      h = found->second;
    }
    const auto section = data.section_form.find(part.section);
    const bool full = section != data.section_form.end() && (section->second == 2 || section->second < 0);
    if (full || h.form == 6 || h.form == 7) {
      forms.emplace("assumed_strain", 1.0);
    } else if (h.form >= 1 && h.form <= 3) {
      forms.emplace("viscous", h.coefficient / 4);
    } else if (h.form == 4 || h.form == 5) {
      forms.emplace("stiffness", h.coefficient);
    } else {
      data.report.refuse(part.place, fmt::format("hourglass control of form {}", h.form));
    }
  }
  if (forms.size() > 1) data.report.refuse(data.parts.front().place, "parts with different hourglass control");
  scene.table("element");
  if (!forms.empty()) {
    scene.key("hourglass", forms.begin()->first);
    scene.key("hourglass_coefficient", forms.begin()->second);
  }
  double q1 = 1.5, q2 = 0.06;
  if (const auto card = last_card(data, "CONTROL_BULK_VISCOSITY")) {
    const Fields f = data.fields(*card);
    q1 = f.number(0, "q1", 1.5);
    q2 = f.number(1, "q2", 0.06);
  }
  scene.key("quadratic_viscosity", std::sqrt(q1));
  scene.key("linear_viscosity", q2);
}

void write_damping(DeckData& data, TomlText& scene) {
  const auto card = last_card(data, "DAMPING_GLOBAL");
  if (!card) return;
  const Fields f = data.fields(*card);
  if (f.integer(0, "lcid", 0) != 0) {
    data.report.refuse(card->place, "*DAMPING_GLOBAL with a curve");
    return;
  }
  for (std::size_t i = 2; i < 8; ++i) {
    const double factor = f.number(i, "factor", 0.0);
    if (i < 5 && factor != 0 && factor != 1) {
      data.report.refuse(card->place, "*DAMPING_GLOBAL with factors of directions");
      return;
    }
  }
  scene.table("damping");
  scene.key("mass", f.number(1, "valdmp", 0.0));
}

void write_output(DeckData& data, TomlText& scene) {
  double rows = std::numeric_limits<double>::infinity();
  for (const char* name : {"GLSTAT", "MATSUM", "RCFORC", "RWFORC", "SPCFORC", "NODOUT", "ELOUT", "SLEOUT"}) {
    const auto card = last_card(data, std::string("DATABASE_") + name);
    if (!card) continue;
    const double interval = data.fields(*card).number(0, "dt", 0.0);
    if (interval > 0) rows = std::min(rows, interval);
  }
  scene.table("output");
  if (std::isfinite(rows)) scene.key("interval", rows);
  if (const auto card = last_card(data, "DATABASE_BINARY_D3PLOT")) {
    const double interval = data.fields(*card).number(0, "dt", 0.0);
    if (interval > 0) scene.key("field_interval", interval);
  }
}

}  // namespace

void translate_controls(DeckData& data, TomlText& scene) {
  const auto title = last_card(data, "TITLE");
  scene.key("title", title ? std::string(trimmed(title->text)) : std::string());
  scene.key("units", "");
  if (const auto card = last_card(data, "CONTROL_SOLUTION")) {
    if (data.fields(*card).integer(0, "soln", 0) != 0)
      data.report.refuse(card->place, "*CONTROL_SOLUTION with SOLN other than 0");
  }
  write_time(data, scene);
  write_element(data, scene);
  write_damping(data, scene);
  write_output(data, scene);
}

void translate_probes(DeckData& data, TomlText& scene) {
  const NumberIndex index(data.mesh.node_ids);
  std::set<std::int64_t> watched;
  for (const KeywordBlock& block : data.deck.blocks) {
    if (block.name != "DATABASE_HISTORY_NODE") continue;
    Cards cards(block);
    while (const auto card = cards.next_filled()) {
      const Fields f = data.fields(*card);
      for (std::size_t i = 0; i < (block.id ? 1U : 8U); ++i) {
        const std::int64_t id = f.integer(i, "node", 0) + offset_of(block, &DeckTransform::node);
        const std::int32_t place = index.find(id);
        if (f.integer(i, "node", 0) == 0 || !watched.insert(id).second) continue;
        if (place < 0) fail_at(card->place, fmt::format("{}: node {} is not there", block.star_name(), id));
        if (!data.used[place]) continue;
        scene.entry("probe", fmt::format("{} {}", block.star_name(), card->place.text()));
        scene.key("name", fmt::format("node_{}", id));
        scene.key("point", data.mesh.mesh.nodes[place]);
      }
    }
  }
}

}  // namespace pinball

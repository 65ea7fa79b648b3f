#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <solver/formats/lsdyna/layouts/contact_cards.hpp>
#include <solver/formats/lsdyna/layouts/control_cards.hpp>

#include "deck_parts.hpp"

namespace pinball {

namespace {

/// DT2MS < 0: elements whose stable step is below its amount get mass; > 0: mass is added to all and taken from all, so
/// that this is the step of each. The step of the run is TSSFAC times it.
void set_mass_scaling(DeckData& data, const Fields& f, double factor, const DeckKeys<TimeSettings>& keys) {
  const double dt2ms = f.number("DT2MS");
  const auto second = last_card(data, "CONTROL_TIMESTEP", 1), third = last_card(data, "CONTROL_TIMESTEP", 2);
  if (third) data.fields(*third, layout::timestep_more);
  if (second) {
    const Fields more = data.fields(*second, layout::timestep_scaling);
    if (dt2ms != 0 && more.integer("IMSCL") != 0)
      data.report.reject(second->place, "*CONTROL_TIMESTEP with selective mass scaling (IMSCL)",
                         "leave it 0: mass is added to nodes");
  }
  if (dt2ms == 0) return;
  keys.set("smallest_step", factor * std::abs(dt2ms), "dt2ms");
  if (dt2ms > 0) keys.set("mass_scaling", "all", "dt2ms");
  if (dt2ms < 0 && f.integer("MS1ST") == 0)
    data.report.understood(
        fmt::format("*CONTROL_TIMESTEP ({}): mass is added at the start, and not again where "
                    "elements become smaller (as with MS1ST = 1)",
                    f.place().text()));
}

/// ERODE: elements whose step is less than DTMIN times the first step of the run are eroded.
void set_erosion_by_step(DeckData& data, const Card& termination, double share, const std::optional<Card>& step,
                         bool erodes) {
  if (share > 0 && erodes) {
    data.step_share = share;
    data.step_card = {"*CONTROL_TIMESTEP", step->place};
  } else if (share > 0) {
    data.report.unused(termination.place, "*CONTROL_TERMINATION: DTMIN",
                       "without ERODE of *CONTROL_TIMESTEP the run goes on to ENDTIM, however small its step is");
  } else if (erodes) {
    data.report.unused(step->place, "*CONTROL_TIMESTEP: ERODE", "DTMIN of *CONTROL_TERMINATION is 0");
  }
}

void write_time(DeckData& data, DeckScene& scene) {
  const auto termination = last_card(data, "CONTROL_TERMINATION");
  if (!termination)
    fail_at({std::make_shared<const std::string>(data.mesh.path), 1},
            "expected *CONTROL_TERMINATION with the time of the end");
  const Fields end = data.fields(*termination, layout::termination);
  auto keys = scene.table<TimeSettings>("time", {"*CONTROL_TERMINATION", termination->place});
  keys.comment("");
  keys.set("end", end.number("ENDTIM"), "endtim");
  if (const std::int64_t cycles = end.integer("ENDCYC"); cycles > 0) keys.set("steps", cycles, "endcyc");
  const auto step = last_card(data, "CONTROL_TIMESTEP");
  if (!step) return set_erosion_by_step(data, *termination, end.number("DTMIN"), step, false);
  const Fields f = data.fields(*step, layout::timestep);
  set_erosion_by_step(data, *termination, end.number("DTMIN"), step, f.integer("ERODE") == 1);
  const double given = f.number("TSSFAC"), factor = given == 0 ? 0.9 : given;
  keys.from({"*CONTROL_TIMESTEP", step->place});
  keys.set("cfl", factor, "tssfac");
  set_mass_scaling(data, f, factor, keys);
}

void write_damping(DeckData& data, DeckScene& scene) {
  const auto card = last_card(data, "DAMPING_GLOBAL");
  if (!card) return;
  const Fields f = data.fields(*card, layout::damping);
  const Point factors = f.point("STX");
  if (factors[1] != factors[0] || factors[2] != factors[0]) {
    data.report.reject(card->place, "*DAMPING_GLOBAL with STX, STY and STZ that differ",
                       "damping has no direction: give one factor for all");
    return;
  }
  const double value = f.number("VALDMP");
  if (factors[0] == 0 && f.point("SRX") != Point{})  // all six are 1 where none is given
    return data.report.unused(card->place, "*DAMPING_GLOBAL: VALDMP", "SRX, SRY and SRZ alone are given a factor");
  const auto keys = scene.table<DampingSettings>("damping", {"*DAMPING_GLOBAL", card->place});
  keys.comment("");
  keys.set("mass", factors[0] == 0 ? value : factors[0] * value, "valdmp");  // all blank: 1
}

/// 0: none. What is below it asks for nothing that there is.
double interval_of(const DeckData& data, const std::string& name, const Card& card, const CardLayout& layout) {
  const double interval = data.fields(card, layout).number("DT");
  if (interval < 0)
    data.report.unused(card.place, fmt::format("*{}: DT", name), "an interval is above 0: nothing is written for it");
  return interval;
}

void write_output(DeckData& data, DeckScene& scene) {
  double rows = std::numeric_limits<double>::infinity();
  DeckCard of_rows;
  for (const char* name :
       {"GLSTAT", "MATSUM", "RCFORC", "RWFORC", "SPCFORC", "BNDOUT", "RBDOUT", "NODOUT", "ELOUT", "SLEOUT"}) {
    const auto card = last_card(data, std::string("DATABASE_") + name);
    if (!card) continue;
    const double interval = interval_of(data, std::string("DATABASE_") + name, *card, layout::ascii);
    if (!(interval > 0 && interval < rows)) continue;
    rows = interval;
    of_rows = {std::string("*DATABASE_") + name, card->place};
  }
  auto keys = scene.table<OutputSettings>("output", of_rows);
  keys.comment("");
  if (std::isfinite(rows)) keys.set("interval", rows, "dt");
  if (const auto card = last_card(data, "DATABASE_MATSUM")) {
    if (data.inertia.empty()) keys.set("body_energies", true);
    if (!data.inertia.empty())
      data.report.unused(card->place, "*DATABASE_MATSUM: energies of each body",
                         "they are sums over nodes, which have not the inertia of *PART_INERTIA");
  }
  if (const auto card = last_card(data, "DATABASE_BINARY_D3PLOT")) {
    if (const auto more = last_card(data, "DATABASE_BINARY_D3PLOT", 1)) data.fields(*more, layout::plot_more);
    const double interval = interval_of(data, "DATABASE_BINARY_D3PLOT", *card, layout::plot);
    keys.from({"*DATABASE_BINARY_D3PLOT", card->place});
    if (interval > 0) keys.set("field_interval", interval, "dt");
  }
}

/// IDRFLG 0: curves say whether there is a phase of relaxation, which is refused there; -999: there is none.
void read_relaxation(DeckData& data) {
  const auto card = last_card(data, "CONTROL_DYNAMIC_RELAXATION");
  if (!card) return;
  const std::int64_t flag = data.fields(*card, layout::relaxation).integer("IDRFLG");
  if (flag != 0 && flag != -999)
    data.report.reject(card->place, fmt::format("*CONTROL_DYNAMIC_RELAXATION with IDRFLG {}", flag),
                       "leave it 0: the run begins at rest");
}

}  // namespace

void translate_controls(DeckData& data, DeckScene& scene) {
  const auto title = last_card(data, "TITLE");
  scene.top().set("title", title ? std::string(trimmed(title->text)) : std::string());
  scene.top().set("units", "");
  for (int i = 0; i < std::ssize(layout::control_contact); ++i) {
    if (const auto card = last_card(data, "CONTROL_CONTACT", i)) data.fields(*card, *layout::control_contact[i]);
  }
  if (const auto card = last_card(data, "CONTROL_SOLUTION")) data.fields(*card, layout::solution);
  read_relaxation(data);
  write_time(data, scene);
  data.part_elements = deck_elements(data);
  set_element(data.part_elements.front(), scene.table<ElementSettings>("element", {}));
  write_damping(data, scene);
  write_output(data, scene);
}

}  // namespace pinball

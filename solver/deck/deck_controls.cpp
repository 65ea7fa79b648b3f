#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "deck_parts.hpp"

namespace pinball {

namespace {

/// DT2MS < 0: elements whose stable step is below its amount get mass; > 0: mass is added to all and taken from all, so
/// that this is the step of each. The step of the run is TSSFAC times it.
void write_mass_scaling(DeckData& data, const Fields& f, double factor, TomlText& scene) {
  const double dt2ms = f.number(4, "dt2ms", 0.0);
  const auto second = last_card(data, "CONTROL_TIMESTEP", 1);
  const auto more = [&](std::size_t field, const char* name) {
    return second ? data.fields(*second).number(field, name, 0.0) : 0.0;
  };
  if (more(0, "dt2msf") != 0)
    data.report.refuse(second->place, "*CONTROL_TIMESTEP with a step over the initial one (DT2MSF)");
  if (more(1, "dt2mslc") != 0) data.report.refuse(second->place, "*CONTROL_TIMESTEP with a curve of DT2MS (DT2MSLC)");
  if (dt2ms == 0) return;
  if (more(2, "imscl") != 0) data.report.refuse(second->place, "*CONTROL_TIMESTEP with selective mass scaling (IMSCL)");
  scene.key("smallest_step", factor * std::abs(dt2ms));
  if (dt2ms > 0) scene.key("mass_scaling", "all");
  if (dt2ms < 0 && f.integer(7, "ms1st", 0) == 0)
    data.report.understood(
        fmt::format("*CONTROL_TIMESTEP ({}): mass is added at the start, and not again where "
                    "elements become smaller (as with MS1ST = 1)",
                    f.place().text()));
}

void write_time(DeckData& data, TomlText& scene) {
  const auto termination = last_card(data, "CONTROL_TERMINATION");
  if (!termination)
    fail_at({std::make_shared<const std::string>(data.mesh.path), 1},
            "expected *CONTROL_TERMINATION with the time of the end");
  const Fields end = data.fields(*termination);
  scene.table("time");
  scene.from("*CONTROL_TERMINATION", termination->place.text());
  scene.key("end", end.number(0, "endtim"));
  if (const std::int64_t cycles = end.integer(1, "endcyc", 0); cycles > 0) scene.key("steps", cycles);
  const auto step = last_card(data, "CONTROL_TIMESTEP");
  if (!step) return;
  const Fields f = data.fields(*step);
  const double given = f.number(1, "tssfac", 0.9), factor = given == 0 ? 0.9 : given;
  scene.from("*CONTROL_TIMESTEP", step->place.text());
  scene.key("cfl", factor);
  if (f.integer(5, "lctm", 0) != 0)
    data.report.refuse(step->place, "*CONTROL_TIMESTEP with a curve of the step (LCTM)");
  write_mass_scaling(data, f, factor, scene);
}

void write_damping(DeckData& data, TomlText& scene) {
  const auto card = last_card(data, "DAMPING_GLOBAL");
  if (!card) return;
  const Fields f = data.fields(*card);
  if (f.integer(0, "lcid", 0) != 0) {
    data.report.refuse(card->place, "*DAMPING_GLOBAL with a curve");
    return;
  }
  for (std::size_t i = 2; i < 5; ++i) {
    const double factor = f.number(i, "factor", 0.0);
    if (factor != 0 && factor != 1) {
      data.report.refuse(card->place, "*DAMPING_GLOBAL with factors of directions");
      return;
    }
  }
  scene.table("damping");
  scene.key("mass", f.number(1, "valdmp", 0.0));
}

void write_output(DeckData& data, TomlText& scene) {
  double rows = std::numeric_limits<double>::infinity();
  for (const char* name : {"GLSTAT", "MATSUM", "RCFORC", "RWFORC", "SPCFORC", "BNDOUT", "NODOUT", "ELOUT", "SLEOUT"}) {
    const auto card = last_card(data, std::string("DATABASE_") + name);
    if (!card) continue;
    const double interval = data.fields(*card).number(0, "dt", 0.0);
    if (interval > 0) rows = std::min(rows, interval);
  }
  scene.table("output");
  if (std::isfinite(rows)) scene.key("interval", rows);
  if (last_card(data, "DATABASE_MATSUM")) scene.key("body_energies", true);
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
  data.part_elements = deck_elements(data);
  write_element(data.part_elements.front(), scene);
  write_damping(data, scene);
  write_output(data, scene);
}

}  // namespace pinball

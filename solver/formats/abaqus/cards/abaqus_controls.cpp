#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

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

constexpr int most_times = 100'000;  ///< of a line of *TIME POINTS

bool scales_mass(const AbaqusBlock& block) {
  return block.name == "FIXEDMASSSCALING" || block.name == "VARIABLEMASSSCALING";
}

/// DT is the stable increment that elements get mass for; the step is SCALE FACTOR times it. Mass is that of the start
/// here: of VARIABLE MASS SCALING only what it does then.
void set_mass_scaling(AbaqusData& data, double factor, DeckKeys<TimeSettings> keys) {
  const AbaqusBlock* before = nullptr;
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (!scales_mass(block) || !block.has("DT")) continue;
    const double step = block.number("DT", 0.0);
    if (!(step > 0)) fail_at(block.place, block.star_name() + ": DT: expected more than 0");
    if (before != nullptr)
      data.report.reject(block.place,
                         fmt::format("{} with DT beside {} with DT", block.star_name(), before->star_name()));
    before = &block;
    if (data.whole_bodies(block.value("ELSET").value_or(""), block.place).size() != data.bodies.size())
      data.report.reject(block.place, block.star_name() + " of some elements");
    keys.from(card_of(block, block.place));
    keys.set("smallest_step", factor * step);
    if (block.option("TYPE") == "SETEQUALDT") keys.set("mass_scaling", "all");
    if (block.name == "FIXEDMASSSCALING") continue;
    data.report.understood(
        fmt::format("*VARIABLE MASS SCALING ({}): elements get mass at the start alone; where they shrink later, steps "
                    "become shorter in its place",
                    block.place.text()));
    for (const char* often : {"FREQUENCY", "NUMBERINTERVAL"}) block.has(often);  // that sentence is of these, too
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

/// Of a step: a list, or with GENERATE the first, the last and the interval of each line.
std::vector<double> times_of(AbaqusData& data, const AbaqusBlock& block) {
  std::vector<double> times;
  const bool generates = block.has("GENERATE");
  DataLines lines(block);
  while (const auto card = lines.next()) {
    if (!generates) {
      std::ranges::copy(numbers_of(block, *card), std::back_inserter(times));
      continue;
    }
    const DataFields f(*card);
    const double first = f.number(0, "first time"), last = f.number(1, "last time"), interval = f.number(2, "interval");
    if (!(interval > 0) || !((last - first) / interval <= most_times))
      f.fail("interval", fmt::format("expected more than 0, and at most {} times, got {}", most_times, interval));
    for (int i = 0; first + i * interval <= last * (1 + 1e-9); ++i)
      times.push_back(std::min(first + i * interval, last));
    if (!times.empty() && times.back() < last * (1 - 1e-9))
      data.report.unused(card->place, "*TIME POINTS, GENERATE: the last time", "no interval ends there");
  }
  return times;
}

/// Times of a *TIME POINTS, of the run: those of a step begin with it, and end with it.
std::vector<double> time_points(AbaqusData& data, const AbaqusBlock& request) {
  const std::string label = request.require("TIMEPOINTS");
  const AbaqusStep& step = data.step_of(request);
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name != "TIMEPOINTS" || label_key(block.require("NAME")) != label_key(label)) continue;
    std::vector<double> times;
    for (const double time : times_of(data, block)) {
      if (time <= step.period) {
        times.push_back(step.start + time);
      } else {
        data.report.unused(block.place, fmt::format("*TIME POINTS {}: a time", label),
                           "it is behind the end of the step");
      }
    }
    return times;
  }
  fail_at(request.place, "there is no *TIME POINTS " + label);
}

/// Fields at so many equal intervals of the step, 20 where nothing is said; rows of history.csv 200. Of several
/// requests the one that is more; times that are listed beside these.
void write_output(AbaqusData& data, DeckScene& scene) {
  const auto keys = scene.table<OutputSettings>("output", {});
  const auto interval = [&](const AbaqusBlock& block) {
    const double intervals = block.number("NUMBERINTERVAL", 0.0), time = block.number("TIMEINTERVAL", 0.0);
    return time > 0 ? time : intervals > 0 ? data.step_of(block).period / intervals : 0.0;
  };
  const auto smaller = [](double so_far, double given) { return so_far > 0 ? std::min(so_far, given) : given; };
  double fields = 0, rows = 0;
  std::vector<double> times;
  bool of_bodies = false;
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name == "ENERGYOUTPUT" && block.has("ELSET")) of_bodies = true;
    if (block.name != "OUTPUT") continue;
    if (block.has("FIELD") && block.has("TIMEPOINTS")) {
      std::ranges::copy(time_points(data, block), std::back_inserter(times));
      continue;
    }
    if (block.has("TIMEPOINTS"))
      data.report.unused(block.place, "*OUTPUT, HISTORY, TIME POINTS", "rows of history.csv are at equal intervals");
    const double given = interval(block);
    if (block.has("FIELD")) fields = smaller(fields, given > 0 ? given : data.step_of(block).period / 20);
    if (block.has("HISTORY") && given > 0) rows = smaller(rows, given);
  }
  if (rows > 0) keys.set("interval", rows);
  if (fields > 0) keys.set("field_interval", fields);
  if (!times.empty()) keys.set("field_times", times);
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

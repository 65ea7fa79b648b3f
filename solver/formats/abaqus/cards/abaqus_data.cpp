#include "abaqus_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <numeric>
#include <set>

#include <solver/base/error.hpp>
#include <solver/formats/deck/names_once.hpp>

namespace pinball {

std::string AbaqusData::plain_name(const std::string& label) {
  std::string name;
  for (const char c : label) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    name += plain ? c : '_';
  }
  return name;
}

bool AbaqusRigidBody::is_led(std::size_t direction, double end) const {
  std::vector<std::array<double, 2>> times = led[direction];
  std::ranges::sort(times);
  double until = 0;
  for (const auto& [from, to] : times) {
    if (from <= until) until = std::max(until, to);
  }
  return until >= end;
}

AbaqusData::AbaqusData(const AbaqusDeck& deck_, const AbaqusMesh& mesh_, DeckReport& report_)
    : deck(deck_), mesh(mesh_), report(report_), middles(mesh_.file), numbers_(mesh_.file.node_ids) {
  used.assign(mesh.file.mesh.nodes.size(), false);
  for (const auto& hexahedron : mesh.file.mesh.hexahedra) {
    for (const std::int32_t node : hexahedron) used[node] = true;
  }
  for (std::size_t i = 0; i < mesh.keys.node_sets.size(); ++i) node_sets_[mesh.keys.node_sets[i]] = i;
  for (std::size_t i = 0; i < mesh.keys.element_sets.size(); ++i) element_sets_[mesh.keys.element_sets[i]] = i;
  for (std::size_t i = 0; i < mesh.keys.face_sets.size(); ++i) face_sets_[mesh.keys.face_sets[i]] = i;
  for (std::size_t c = 0; c < mesh.components.size(); ++c) components_.emplace(mesh.components[c].key, c);
  require_sections();
  name_bodies();
  read_steps();
  for (const AbaqusBlock& block : deck.blocks) {
    require_once(block);
    if (block.name == "AMPLITUDE") read_amplitude(block);
  }
}

/// What has a name stands once, and so does what each step has one of.
void AbaqusData::require_once(const AbaqusBlock& block) {
  static const std::set<std::string> named{"MATERIAL", "AMPLITUDE", "SECTIONCONTROLS", "SURFACEINTERACTION",
                                           "TIMEPOINTS"},
      one_a_step{"DYNAMIC", "BULKVISCOSITY", "FIXEDMASSSCALING", "VARIABLEMASSSCALING"};
  if (named.contains(block.name)) give_once(block.star_name() + ' ' + label_key(block.require("NAME")), block.place);
  if (block.name == "TIE" && block.has("NAME")) give_once("*TIE " + label_key(block.require("NAME")), block.place);
  if (one_a_step.contains(block.name))
    give_once(block.step > 0 ? fmt::format("{} of step {}", block.star_name(), block.step) : block.star_name(),
              block.place);
}

const AbaqusBlock* AbaqusData::last(const std::string& name) const {
  const AbaqusBlock* found = nullptr;
  for (const AbaqusBlock& block : deck.blocks) {
    if (block.name == name) found = &block;
  }
  return found;
}

void AbaqusData::require_sections() const {
  for (std::size_t e = 0; e < mesh.file.part.size(); ++e) {
    if (static_cast<std::size_t>(mesh.file.part[e]) < mesh.sections.size()) continue;
    const std::string& name = mesh.file.parts[mesh.file.part[e]].name;
    throw_at_element(e, name);
  }
}

void AbaqusData::throw_at_element(std::size_t e, const std::string& part) const {
  fail_at(
      {std::make_shared<const std::string>(mesh.file.path), mesh.file.line[e]},
      fmt::format("element {}{} is of no *SOLID SECTION", mesh.file.element_ids[e], part.empty() ? "" : " of " + part));
}

void AbaqusData::name_bodies() {
  std::vector<std::int64_t> elements(mesh.file.parts.size(), 0);
  for (const std::int32_t part : mesh.file.part) ++elements[part];
  NamesOnce names;
  for (std::size_t s = 0; s < mesh.sections.size(); ++s) {
    if (elements[s] == 0) continue;
    const AbaqusSection& section = mesh.sections[s];
    const std::string plain = plain_name(section.part), name = names.take(plain, fmt::format("{}_{}", plain, s));
    if (section.is_rigid()) {
      bodies.push_back({name, section.part, "", s});
      report.understood(fmt::format("{}: body {} of {} rigid elements", section.part, name, elements[s]));
      continue;
    }
    bodies.push_back({name, section.part, label_key(section.block->require("MATERIAL")), s});
    report.understood(fmt::format("{}: body {} of {} solids, material {}", section.part, name, elements[s],
                                  material_name(bodies.back().material)));
  }
}

void AbaqusData::read_steps() {
  const auto fail_without = [](const DeckPlace& place) {
    fail_at(place, "expected *STEP with *DYNAMIC, EXPLICIT and its period");
  };
  const AbaqusBlock* open = nullptr;
  for (const AbaqusBlock& block : deck.blocks) {
    if (block.name == "STEP") {
      if (open != nullptr) fail_without(open->place);
      open = &block;
      steps.push_back({steps.empty() ? 0.0 : end(), 0.0, block.option("AMPLITUDE") == "RAMP"});
      if (steps.size() > 1)
        report.understood(fmt::format("*STEP ({}): begins at {:.6g}", block.place.text(), steps.back().start));
      if (steps.size() > 1 && (steps.back().ramps || steps.front().ramps))
        report.reject(block.place, "*STEP, AMPLITUDE=RAMP beside other steps");
    }
    if (block.name != "DYNAMIC" || steps.empty()) continue;
    DataLines lines(block);
    const DataLine card = lines.require("the period of the step");
    const DataFields f(card);
    const double period = f.number(1, "period");
    if (const double smallest = f.number(2, "smallest increment", 0.0); smallest != 0)
      report.unused(card.place, fmt::format("*DYNAMIC: the smallest increment, {:.6g}", smallest),
                    "CalculiX gives elements mass for it: here *FIXED MASS SCALING, DT= does");
    if (!(period > 0)) fail_at(card.place, fmt::format("*DYNAMIC: period: expected more than 0, got {}", period));
    steps.back().period = period;
    open = nullptr;
  }
  if (open != nullptr) fail_without(open->place);
  if (steps.empty()) fail_without({std::make_shared<const std::string>(mesh.file.path), 1});
}

const AbaqusStep& AbaqusData::step_of(const AbaqusBlock& block) const { return steps[std::max(block.step, 1) - 1]; }

std::vector<double> numbers_of(const AbaqusBlock& block, const DataLine& card) {
  std::vector<double> numbers;
  for (const std::string_view entry : entries_of(card.text)) {
    const auto number = deck_number(entry);
    if (!number) fail_at(card.place, fmt::format("{}: expected a number, got \"{}\"", block.star_name(), entry));
    numbers.push_back(*number);
  }
  return numbers;
}

namespace {

/// Pairs of time and value, four to a line; or values alone for equal intervals.
std::vector<double> all_numbers_of(const AbaqusBlock& block) {
  std::vector<double> numbers;
  DataLines lines(block);
  while (const auto card = lines.next()) std::ranges::copy(numbers_of(block, *card), std::back_inserter(numbers));
  return numbers;
}

/// a + (b - a) x^3 (10 - 15 x + 6 x^2) between two points, in straight pieces.
AbaqusCurve smooth(const AbaqusCurve& points) {
  constexpr int pieces = 64;
  AbaqusCurve curve{{points.times.front()}, {points.factors.front()}, points.absolute, points.total_time};
  for (std::size_t i = 1; i < points.times.size(); ++i) {
    const double from = points.times[i - 1], to = points.times[i], low = points.factors[i - 1],
                 high = points.factors[i];
    for (int k = 1; k <= (low == high ? 1 : pieces); ++k) {
      const double x = low == high ? 1.0 : static_cast<double>(k) / pieces;
      curve.times.push_back(x == 1.0 ? to : from + x * (to - from));
      curve.factors.push_back(x == 1.0 ? high : low + (high - low) * (x * x * x * (10 + x * (6 * x - 15))));
    }
  }
  return curve;
}

}  // namespace

void AbaqusData::read_amplitude(const AbaqusBlock& block) {
  AbaqusCurve curve;
  curve.absolute = block.option("VALUE") == "ABSOLUTE";
  curve.total_time = block.option("TIME") == "TOTALTIME";
  const std::vector<double> numbers = all_numbers_of(block);
  if (block.option("DEFINITION") == "EQUALLYSPACED") {
    const double interval = block.number("FIXEDINTERVAL", 0.0), begin = block.number("BEGIN", 0.0);
    if (!(interval > 0)) fail_at(block.place, "*AMPLITUDE: FIXED INTERVAL: expected more than 0");
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      curve.times.push_back(begin + i * interval);
      curve.factors.push_back(numbers[i]);
    }
  } else {
    if (numbers.size() % 2 != 0) fail_at(block.place, "*AMPLITUDE: expected pairs of time and value");
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
      curve.times.push_back(numbers[i]);
      curve.factors.push_back(numbers[i + 1]);
    }
  }
  if (curve.times.empty()) fail_at(block.place, "*AMPLITUDE: expected at least one time and value");
  for (std::size_t i = 1; i < curve.times.size(); ++i) {
    if (!(curve.times[i] > curve.times[i - 1]))
      fail_at(block.place, fmt::format("*AMPLITUDE: expected times that increase, got {} after {}", curve.times[i],
                                       curve.times[i - 1]));
  }
  if (block.option("DEFINITION") == "SMOOTHSTEP") {
    curve = smooth(curve);
    report.understood(fmt::format("*AMPLITUDE ({}): smooth steps as 64 straight pieces each", block.place.text()));
  }
  const std::string key = label_key(block.require("NAME"));
  definitions_.add("amplitude", key, block.star_name(), block.place);
  amplitudes_[key] = std::move(curve);
}

namespace {

/// Of a time: over how much of it before that what begins or ends at once does so.
constexpr double leap = 1e-9;

double factor_at(const AbaqusCurve& curve, double time) {
  const auto after = std::ranges::upper_bound(curve.times, time) - curve.times.begin();
  if (after == 0) return curve.factors.front();
  if (after == std::ssize(curve.times)) return curve.factors.back();
  const std::size_t i = after;
  const double share = (time - curve.times[i - 1]) / (curve.times[i] - curve.times[i - 1]);
  return curve.factors[i - 1] + share * (curve.factors[i] - curve.factors[i - 1]);
}

/// From a time on the factor stays what it is then.
void hold_from(double time, AbaqusCurve& curve) {
  if (curve.times.back() <= time) return;
  const double factor = factor_at(curve, time);
  while (!curve.times.empty() && curve.times.back() >= time) {
    curve.times.pop_back();
    curve.factors.pop_back();
  }
  curve.times.push_back(time);
  curve.factors.push_back(factor);
}

/// Before a time the factor is 0.
void begin_at(double time, AbaqusCurve& curve) {
  const double factor = factor_at(curve, time);
  const auto after = std::ranges::upper_bound(curve.times, time) - curve.times.begin();
  curve.times.erase(curve.times.begin(), curve.times.begin() + after);
  curve.factors.erase(curve.factors.begin(), curve.factors.begin() + after);
  curve.times.insert(curve.times.begin(), {time * (1 - leap), time});
  curve.factors.insert(curve.factors.begin(), {0.0, factor});
}

/// From a time on the factor is 0.
void end_at(double time, AbaqusCurve& curve) {
  hold_from(time * (1 - leap), curve);
  if (curve.times.back() < time * (1 - leap)) {
    curve.factors.push_back(curve.factors.back());
    curve.times.push_back(time * (1 - leap));
  }
  curve.times.push_back(time);
  curve.factors.push_back(0.0);
}

}  // namespace

AbaqusCurve within(AbaqusCurve curve, double start, std::optional<double> end) {
  if (!(start > 0) && !end) return curve;
  if (curve.times.empty()) curve = {{start}, {1.0}};
  if (start > 0) begin_at(start, curve);
  if (end) end_at(*end, curve);
  return curve;
}

AbaqusCurve AbaqusData::curve(const AbaqusBlock& block) const {
  const AbaqusStep& step = step_of(block);
  const auto name = block.value("AMPLITUDE");
  if (!name) return step.ramps ? AbaqusCurve{{0.0, step.period}, {0.0, 1.0}} : AbaqusCurve{};
  const auto found = amplitudes_.find(definitions_.name("amplitude", label_key(*name)));
  if (found == amplitudes_.end())
    fail_at(block.place, fmt::format("{}: there is no *AMPLITUDE {}", block.star_name(), *name));
  AbaqusCurve curve = found->second;
  if (curve.total_time) return curve;
  for (double& time : curve.times) time += step.start;
  if (&step != &steps.back()) hold_from(step.start + step.period, curve);
  return curve;
}

const AbaqusRange* AbaqusData::range_of(const std::string& instance) const {
  const auto found = components_.find(label_key(instance));
  return found == components_.end() ? nullptr : &mesh.ranges[found->second];
}

AbaqusNodes AbaqusData::nodes(const std::string& label, const DeckPlace& place) const {
  if (const auto found = node_sets_.find(label_key(label)); found != node_sets_.end()) {
    const MeshSet& set = mesh.file.node_sets[found->second];
    if (!set.problem.empty()) throw InputError(set.problem);
    return {set.name, 0, set.members};
  }
  const auto parts = split_label(label);
  const auto number = deck_integer(trimmed(parts ? parts->second : label));
  const AbaqusRange* range = range_of(parts ? parts->first : "");
  if (!number) fail_at(place, fmt::format("there is no set of nodes {}", label));
  if (range != nullptr) {
    const std::int32_t node = numbers_.find(*number + range->added);
    const auto after = node - range->first_node;
    if (node >= 0 && after < range->nodes) return {"", *number + range->added, {node}};
  }
  fail_at(place, fmt::format("node {} is not there", label));
}

const FaceSet* AbaqusData::find_faces(const std::string& label) const {
  const auto found = face_sets_.find(label_key(label));
  return found == face_sets_.end() ? nullptr : &mesh.file.face_sets[found->second];
}

std::string AbaqusData::faces(const std::string& label, const DeckPlace& place) const {
  const FaceSet* set = find_faces(label);
  if (set == nullptr) fail_at(place, fmt::format("there is no surface {}", label));
  if (!set->problem.empty()) throw InputError(set->problem);
  return set->name;
}

DeckSide AbaqusData::surface(const std::string& label, const DeckPlace& place) const {
  if (find_faces(label) != nullptr || !node_sets_.contains(label_key(label))) return {{}, "faces", faces(label, place)};
  return {{}, "nodes", nodes(label, place).set};
}

std::vector<std::int32_t> AbaqusData::elements(const std::string& label, const DeckPlace& place) const {
  if (label.empty()) {
    std::vector<std::int32_t> all(mesh.file.part.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  if (const auto found = element_sets_.find(label_key(label)); found != element_sets_.end()) {
    const MeshSet& set = mesh.file.element_sets[found->second];
    if (!set.problem.empty()) throw InputError(set.problem);
    return set.members;
  }
  const auto parts = split_label(label);
  const auto number = deck_integer(trimmed(parts ? parts->second : label));
  const AbaqusRange* range = range_of(parts ? parts->first : "");
  if (!number) fail_at(place, fmt::format("there is no set of elements {}", label));
  if (range != nullptr) {
    const auto begin = mesh.file.element_ids.begin() + range->first_element, end = begin + range->elements,
               found = std::find(begin, end, *number + range->added);
    if (found != end) return {static_cast<std::int32_t>(found - mesh.file.element_ids.begin())};
  }
  fail_at(place, fmt::format("element {} is not there", label));
}

std::vector<std::string> AbaqusData::whole_bodies(const std::string& label, const DeckPlace& place) const {
  std::vector<std::string> names;
  std::vector<bool> member(mesh.file.part.size(), false);
  for (const std::int32_t e : elements(label, place)) member[e] = true;
  std::vector<std::int64_t> inside(mesh.file.parts.size(), 0), all(mesh.file.parts.size(), 0);
  for (std::size_t e = 0; e < member.size(); ++e) {
    ++all[mesh.file.part[e]];
    if (member[e]) ++inside[mesh.file.part[e]];
  }
  for (const AbaqusBody& body : bodies) {
    if (inside[body.section] == 0) continue;
    if (inside[body.section] != all[body.section]) return {};
    names.push_back(body.name);
  }
  return names;
}

void set_curve(const AbaqusCurve& curve, double magnitude, const DeckKeys<TimeTable>& keys) {
  if (curve.times.empty()) return;
  std::vector<double> factors = curve.factors;
  for (double& factor : factors) factor *= curve.absolute ? 1.0 : magnitude;
  keys.set("times", curve.times);
  keys.set("factors", factors);
}

}  // namespace pinball

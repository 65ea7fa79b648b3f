#include "radioss_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include <solver/base/error.hpp>
#include <solver/formats/deck/names_once.hpp>
#include <solver/formats/radioss/layouts/radioss_control_cards.hpp>
#include <solver/formats/radioss/layouts/radioss_mesh_cards.hpp>

namespace pinball {

namespace {

std::string plain_name(const std::string& title) {
  std::string name;
  for (const char c : title) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    name += plain ? c : '_';
  }
  return name;
}

/// Three words: two systems of units are the same where these are. Case counts where it tells mega from milli, and peta
/// from pico.
std::string units_text(const RadiossFields& f) {
  std::string all;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string given = f.text(i);
    std::string word = lower_case(given);
    if (given.size() > 1 && (given[0] == 'M' || given[0] == 'P')) word[0] = given[0];
    all += word + " ";
  }
  return all;
}

/// Where points do not reach from 0 to the end of the run, functions of Radioss go on along their first and their last
/// piece, and tables of a scene keep their values. True where the points became more.
bool extend_to_run(std::vector<double>& x, std::vector<double>& y, double end) {
  const std::size_t points = x.size();
  if (points < 2) return false;
  const auto at = [&](double time, std::size_t from, std::size_t to) {
    return y[from] + (time - x[from]) * (y[to] - y[from]) / (x[to] - x[from]);
  };
  const bool behind = x[points - 1] < end && x[points - 2] < x[points - 1] && y[points - 2] != y[points - 1],
             before = x[0] > 0 && x[0] < x[1] && y[0] != y[1];
  const double last = behind ? at(end, points - 2, points - 1) : 0, first = before ? at(0, 0, 1) : 0;
  if (behind) {
    x.push_back(end);
    y.push_back(last);
  }
  if (before) {
    x.insert(x.begin(), 0.0);
    y.insert(y.begin(), first);
  }
  return behind || before;
}

bool is_system(const RadiossBlock& block) { return block.name == "SKEW/FIX" || block.name == "FRAME/FIX"; }

}  // namespace

RadiossData::RadiossData(const RadiossDeck& deck_, const MeshFile& mesh_, DeckReport& report_)
    : deck(deck_), mesh(mesh_), report(report_), parts(deck_), nodes(mesh_.node_ids) {
  for (const RadiossBlock& block : deck.blocks) {
    blocks_[block.name].push_back(&block);
    if (block.name == "FUNCT") read_function(block);
    if (is_system(block)) read_axes(block);
  }
  name_bodies();
  require_units();
}

const std::vector<const RadiossBlock*>& RadiossData::blocks_of(const std::string& name) const {
  static const std::vector<const RadiossBlock*> none;
  const auto found = blocks_.find(name);
  return found == blocks_.end() ? none : found->second;
}

const RadiossBlock* RadiossData::last(const std::string& name) const {
  const auto& blocks = blocks_of(name);
  return blocks.empty() ? nullptr : blocks.back();
}

void RadiossData::read_function(const RadiossBlock& block) {
  given_.add(fmt::format("function {}", block.id()), block.place);
  definitions_.add("function", block.id(), "/FUNCT", block.place);
  auto& [x, y] = functions_[block.id()];
  RadiossLines lines(block);
  while (const auto line = lines.next_filled()) {
    const RadiossFields f(*line, block, radioss::function_point);
    x.push_back(f.number("X"));
    y.push_back(f.number("Y"));
  }
  if (x.empty()) fail_at(block.place, block.title + ": expected at least one point");
}

/// Z' and, in the plane of both, Y': X is Y' x Z' and Y is Z' x X, as in the starter (hm_read_skw.F, hm_read_frm.F). A
/// skew of version 120 on and a frame have an origin before these.
void RadiossData::read_axes(const RadiossBlock& block) {
  constexpr std::int64_t skews_with_origin = 120;
  given_.add(fmt::format("{} {}", block.name, block.id()), block.place);
  definitions_.add(block.name, block.id(), '/' + block.name, block.place);
  RadiossLines lines(block);
  const bool frame = block.name == "FRAME/FIX", has_origin = frame || deck.version >= skews_with_origin;
  const DataLine first = has_origin ? lines.require("the origin of the system") : DataLine{{}, block.place},
                 second = lines.require("the axis Y of the system"), third = lines.require("the axis Z of the system");
  const RadiossFields o(first, block, frame ? radioss::frame_origin : radioss::axes_origin),
      a(second, block, radioss::axes_y), b(third, block, radioss::axes_z);
  const Point y = radioss_unit(a.point("X1"), second.place), z = radioss_unit(b.point("X2"), third.place),
              x = radioss_unit(cross(y, z), third.place);
  const std::array<Point, 3> axes{x, cross(z, x), z};
  if (frame) {
    frames_[block.id()] = {o.point("Ox"), axes};
  } else {
    skews_[block.id()] = axes;
  }
}

void RadiossData::name_bodies() {
  std::vector<int> solids(mesh.parts.size(), 0);
  for (const std::int32_t part : mesh.part) ++solids[part];
  used.assign(mesh.mesh.nodes.size(), false);
  rigid_of_node.assign(mesh.mesh.nodes.size(), -1);
  for (const auto& hexahedron : mesh.mesh.hexahedra) {
    for (const std::int32_t node : hexahedron) used[node] = true;
  }
  for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
    if (solids[p] == 0) continue;
    const auto found = parts.all().find(mesh.parts[p].id);
    if (found == parts.all().end()) {
      const auto first = std::ranges::find(mesh.part, static_cast<std::int32_t>(p)) - mesh.part.begin();
      throw InputError(fmt::format("{}: solid {} is of part {}, which no /PART defines", place_of_element(mesh, first),
                                   mesh.element_ids[first], mesh.parts[p].id));
    }
    bodies.push_back({plain_name(found->second.title), found->second, solids[p], mesh.parts[p].shells > 0});
  }
  std::ranges::sort(bodies, {}, [](const RadiossBody& body) { return body.part.id; });
  NamesOnce names;
  for (RadiossBody& body : bodies) {
    body.name = names.take(body.name, fmt::format("part_{}", body.part.id));
    report.understood(fmt::format("part {}: body {} of {} solids{}, material mat_{}", body.part.id, body.name,
                                  body.solids, body.is_of_shells ? ", layers in the place of shells" : "",
                                  body.part.material));
  }
}

/// What is in other units than the deck is refused.
void RadiossData::require_units() const {
  RadiossLines lines(*last("BEGIN"));
  const DataLine name = lines.require("the name of the run"), version = lines.require("the version of the input"),
                 input = lines.next_or_blank(), work = lines.next_or_blank();
  const RadiossBlock& begin = *last("BEGIN");
  const RadiossFields n(name, begin, radioss::begin_name), v(version, begin, radioss::begin_version),
      i(input, begin, radioss::begin_input), w(work, begin, radioss::begin_work);
  v.integer("Invers");
  n.text("run_name");
  const std::string own = units_text(i);
  if (own != units_text(w))
    report.reject(work.place, "/BEGIN with work units other than those of the input",
                  "give mass_work, length_work and "
                  "time_work as mass_in, length_in "
                  "and time_in");
  std::map<std::int64_t, std::string> units;
  for (const RadiossBlock* block : blocks_of("UNIT")) {
    RadiossLines of_unit(*block);
    const DataLine line = of_unit.require("the units of mass, length and time");
    units[block->id()] = units_text(RadiossFields(line, *block, radioss::unit_line));
  }
  for (const RadiossBlock& block : deck.blocks) {
    if (block.engine || block.unit() == 0 || block.name.starts_with("ADMAS")) continue;
    const auto found = units.find(block.unit());
    if (found == units.end()) fail_at(block.place, fmt::format("no /UNIT has the number {}", block.unit()));
    if (found->second != own)
      report.reject(block.place, fmt::format("{} in units other than those of /BEGIN", block.title),
                    std::string(radioss::own_units));
  }
}

const MeshSet& RadiossData::node_group(std::int64_t id, const DeckPlace& place) const {
  const auto found = std::ranges::find(mesh.node_sets, id, &MeshSet::id);
  if (found == mesh.node_sets.end()) fail_at(place, fmt::format("no /GRNOD has the number {}", id));
  if (!found->problem.empty()) throw InputError(found->problem);
  return *found;
}

const FaceSet& RadiossData::surface(std::int64_t id, const DeckPlace& place) const {
  const auto found = std::ranges::find(mesh.face_sets, id, &FaceSet::id);
  if (found == mesh.face_sets.end()) fail_at(place, fmt::format("no /SURF has the number {}", id));
  if (!found->problem.empty()) throw InputError(found->problem);
  return *found;
}

RadiossRigidBody* RadiossData::rigid_at(std::int32_t node) {
  const auto found = std::ranges::find(rigid, node, &RadiossRigidBody::main);
  return found == rigid.end() ? nullptr : &*found;
}

std::vector<RadiossRigidBody*> RadiossData::rigid_in(const MeshSet& group) {
  std::vector<RadiossRigidBody*> found;
  for (RadiossRigidBody& one : rigid) {
    if (std::ranges::binary_search(group.members, one.main)) found.push_back(&one);
  }
  return found;
}

bool RadiossData::has_used(const MeshSet& group) const {
  return std::ranges::any_of(group.members, [&](std::int32_t node) { return used[node]; });
}

std::vector<bool> RadiossData::nodes_in(const MeshSet& group) const {
  std::vector<bool> in_group(used.size(), false);
  for (const std::int32_t node : group.members) in_group[node] = true;
  return in_group;
}

std::vector<bool> RadiossData::whole_parts(const std::vector<bool>& in_group) const {
  std::vector<bool> whole(mesh.parts.size(), true);
  for (std::size_t e = 0; e < mesh.part.size(); ++e) {
    for (const std::int32_t node : mesh.mesh.hexahedra[e]) whole[mesh.part[e]] = whole[mesh.part[e]] && in_group[node];
  }
  return whole;
}

bool RadiossData::are_of_parts(const std::vector<bool>& in_group, const std::vector<bool>& parts_) const {
  std::vector<bool> covered(used.size(), false);
  for (std::size_t e = 0; e < mesh.part.size(); ++e) {
    for (const std::int32_t node : mesh.mesh.hexahedra[e]) covered[node] = covered[node] || parts_[mesh.part[e]];
  }
  for (std::size_t n = 0; n < used.size(); ++n) {
    if (in_group[n] && used[n] && !covered[n]) return false;
  }
  return true;
}

std::vector<std::string> RadiossData::bodies_of(const std::vector<bool>& parts_) const {
  std::vector<std::string> names;
  for (const RadiossBody& body : bodies) {
    if (parts_[std::ranges::find(mesh.parts, body.part.id, &MeshPart::id) - mesh.parts.begin()])
      names.push_back(body.name);
  }
  return names;
}

std::vector<std::string> RadiossData::whole_bodies(const MeshSet& group) const {
  const std::vector<bool> in_group = nodes_in(group), whole = whole_parts(in_group);
  return are_of_parts(in_group, whole) ? bodies_of(whole) : std::vector<std::string>{};
}

std::vector<std::string> RadiossData::all_bodies() const {
  std::vector<std::string> names;
  for (const RadiossBody& body : bodies) names.push_back(body.name);
  return names;
}

std::array<Point, 3> RadiossData::axes(std::int64_t skew, const DeckPlace& place) const {
  if (skew == 0) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto found = skews_.find(definitions_.name("SKEW/FIX", skew));
  if (found == skews_.end()) fail_at(place, fmt::format("no /SKEW/FIX has the number {}", skew));
  return found->second;
}

std::pair<Point, std::array<Point, 3>> RadiossData::frame(std::int64_t id, const DeckPlace& place) const {
  if (id == 0) return {{}, axes(0, place)};
  const auto found = frames_.find(definitions_.name("FRAME/FIX", id));
  if (found == frames_.end()) fail_at(place, fmt::format("no /FRAME/FIX has the number {}", id));
  return found->second;
}

const std::pair<std::vector<double>, std::vector<double>>& RadiossData::function(std::int64_t id,
                                                                                 const DeckPlace& place) const {
  const auto found = functions_.find(definitions_.name("function", id));
  if (found == functions_.end()) fail_at(place, fmt::format("no /FUNCT has the number {}", id));
  return found->second;
}

void RadiossData::set_function(std::int64_t id, double ascale, double fscale, const DeckPlace& place,
                               const DeckKeys<TimeTable>& keys) const {
  auto [x, y] = function(id, place);
  for (double& time : x) time *= ascale == 0 ? 1.0 : ascale;
  for (double& factor : y) factor *= fscale == 0 ? 1.0 : fscale;
  if (extend_to_run(x, y, run_end()))
    report.understood(fmt::format("/FUNCT/{} ({}) goes on straight from its points to the start and the end of the run",
                                  id, place.text()));
  keys.set("times", x, "fct_IDT, Ascale_x");
  keys.set("factors", y, "fct_IDT, Fscale_y");
}

double RadiossData::run_end() const {
  const RadiossBlock* run = last("RUN");
  if (run == nullptr) return 0;
  RadiossLines lines(*run);
  const DataLine line = lines.require("the time of the end");
  return RadiossFields(line, *run, radioss::run).number("Tstop");
}

bool RadiossData::has_material(std::int64_t id) const {
  return std::ranges::any_of(bodies, [&](const RadiossBody& body) { return body.part.material == id; });
}

bool RadiossData::has_property(std::int64_t id) const {
  return std::ranges::any_of(bodies, [&](const RadiossBody& body) { return body.part.property == id; });
}

int degree_of(const RadiossFields& f, std::string_view name) {
  static constexpr std::string_view degrees[] = {"X", "Y", "Z", "XX", "YY", "ZZ"};
  const std::string given = upper_case(f.text(name));
  for (int i = 0; i < 6; ++i) {
    if (given == degrees[i]) return i;
  }
  f.fail(name, fmt::format("expected X, Y, Z, XX, YY or ZZ, got \"{}\"", given));
}

Point radioss_unit(const Point& vector, const DeckPlace& place) {
  const double length = norm(vector);
  if (!(length > 0)) fail_at(place, "expected a direction of some length");
  return {vector[0] / length, vector[1] / length, vector[2] / length};
}

}  // namespace pinball

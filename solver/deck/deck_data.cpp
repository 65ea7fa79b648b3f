#include "deck_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include <solver/base/error.hpp>
#include <solver/keyword/keyword_scanner.hpp>

#include "keyword_rules.hpp"

namespace pinball {

namespace {

constexpr std::array<int, 2> point_columns{20, 20};

Point unit(Point d, const DeckPlace& place) {
  const double length = std::sqrt(dot(d, d));
  if (!(length > 0)) fail_at(place, "expected a direction, got a vector of no length");
  for (double& component : d) component /= length;
  return d;
}

/// A title as a name in a scene: letters, digits, "_" and "-".
std::string name_of(const std::string& title) {
  std::string name;
  for (const char c : trimmed(title)) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    name += plain ? c : '_';
  }
  return name;
}

}  // namespace

DeckData::DeckData(const KeywordDeck& deck_, const MeshFile& mesh_, DeckReport& report_)
    : deck(deck_), mesh(mesh_), report(report_) {
  for (const KeywordBlock& block : deck.blocks) {
    blocks_[block.name].push_back(&block);
    read(block);
  }
  name_bodies();
}

const std::vector<const KeywordBlock*>& DeckData::blocks_of(const std::string& name) const {
  static const std::vector<const KeywordBlock*> none;
  const auto found = blocks_.find(name);
  return found == blocks_.end() ? none : found->second;
}

void DeckData::read(const KeywordBlock& block) {
  require_one_of_a_kind(block);
  if (is_part(block)) read_parts(block);
  if (block.name == "SECTION_SOLID") read_section(block);
  if (block.name == "HOURGLASS") read_hourglass(block);
  if (block.name == "DEFINE_CURVE") read_curve(block);
  if (block.name == "DEFINE_TABLE") read_table(block);
  if (block.name == "DEFINE_VECTOR") read_vector(block);
  if (block.name == "DEFINE_COORDINATE_SYSTEM" || block.name == "DEFINE_COORDINATE_VECTOR") read_system(block);
  if (block.name.starts_with("SET_PART")) read_part_set(block);
  if (block.name == "DEFINE_BOX") read_box(block);
}

/// Controls, and files of output, have no numbers: a deck has one of each kind. Those that are ignored may stand as
/// often as they like.
void DeckData::require_one_of_a_kind(const KeywordBlock& block) {
  const bool kind = block.name.starts_with("CONTROL_") || block.name == "DAMPING_GLOBAL" ||
                    (block.name.starts_with("DATABASE_") && !block.name.starts_with("DATABASE_HISTORY_"));
  const KeywordRule* rule = kind ? rule_of(block.name) : nullptr;
  if (rule != nullptr && rule->treatment == Treatment::done) give_once(block, block.star_name(), block.place);
}

void DeckData::read_parts(const KeywordBlock& block) {
  const std::int64_t other = offset_of(block, &DeckTransform::other);
  for_each_part(block, [&](const Card& title, const Card& card) {
    const Fields f = fields(card);
    const std::int64_t id = f.integer(0, "pid") + offset_of(block, &DeckTransform::part);
    if (f.integer(3, "eosid", 0) != 0) report.refuse(card.place, "*PART with an equation of state");
    if (f.integer(7, "tmid", 0) != 0) report.understood(fmt::format("part {}: heat (TMID) is not computed", id));
    const std::int64_t hourglass_id = f.integer(4, "hgid", 0);
    all_parts_[id] = {id,
                      f.integer(1, "secid", 0) + other,
                      f.integer(2, "mid", 0) + offset_of(block, &DeckTransform::material),
                      hourglass_id == 0 ? 0 : hourglass_id + other,
                      "",
                      card.place};
    titles_[id] = std::string(trimmed(title.text));
  });
}

void DeckData::read_section(const KeywordBlock& block) {
  for_each_card(block, [&](const Card& card) {
    const Fields f = fields(card);
    const std::int64_t id = f.integer(0, "secid") + offset_of(block, &DeckTransform::other);
    give_once(block, fmt::format("section {}", id), card.place);
    section_form[id] = f.integer(1, "elform", 1);
  });
}

void DeckData::read_hourglass(const KeywordBlock& block) {
  for_each_card(block, [&](const Card& card) {
    const Fields f = fields(card);
    const DeckHourglass h{f.integer(1, "ihq", 0), f.number(2, "qm", 0.0), f.number(4, "q1", 0.0),
                          f.number(5, "q2", 0.0)};
    const std::int64_t id = f.integer(0, "hgid") + offset_of(block, &DeckTransform::other);
    give_once(block, fmt::format("hourglass control {}", id), card.place);
    hourglass[id] = h;
  });
}

void DeckData::read_curve(const KeywordBlock& block) {
  Cards cards(block);
  if (block.title) cards.next();
  const Card head = cards.require("the number of the curve");
  const Fields f = fields(head);
  const auto factor = [&f](std::size_t field, const char* name) {
    const double value = f.number(field, name, 1.0);
    return value == 0 ? 1.0 : value;
  };
  const double sfa = factor(2, "sfa"), sfo = factor(3, "sfo");
  const double offa = f.number(4, "offa", 0.0), offo = f.number(5, "offo", 0.0);
  DeckCurve curve;
  curve.units = units_of(block);
  curve.relaxes = f.integer(1, "sidr", 0) == 1;
  while (const auto card = cards.next_filled()) {
    const Fields point(*card, deck.parameters, point_columns);
    curve.abscissa.push_back(sfa * (point.number(0, "abscissa", 0.0) + offa));
    curve.ordinate.push_back(sfo * (point.number(1, "ordinate", 0.0) + offo));
  }
  const std::int64_t id = f.integer(0, "lcid") + offset_of(block, &DeckTransform::define);
  give_once(block, fmt::format("curve or table {}", id), head.place);
  curves_[id] = std::move(curve);
}

/// Values, and then as many curves, which follow as keywords of their own in the order of the values. The values are
/// logarithms of rates where the first is below 0.
void DeckData::read_table(const KeywordBlock& block) {
  Cards cards(block);
  if (block.title) cards.next();
  const Card head = cards.require("the number of the table");
  const std::int64_t add = offset_of(block, &DeckTransform::define);
  const std::int64_t number = fields(head).integer(0, "tbid") + add;
  give_once(block, fmt::format("curve or table {}", number), head.place);
  DeckTable& table = tables_[number] = {};
  while (const auto card = cards.next_filled()) {
    const Fields point(*card, deck.parameters, point_columns);
    table.curves.emplace_back(point.number(0, "value", 0.0), point.integer(1, "lcid", 0));
  }
  table.logarithmic = !table.curves.empty() && table.curves.front().first < 0;
  auto next = static_cast<std::size_t>(&block - deck.blocks.data()) + 1;
  for (auto& [rate, id] : table.curves) {
    rate = (table.logarithmic ? std::exp(rate) : rate) * units_of(block).rate();
    if (id != 0) {
      id += add;
      continue;
    }
    while (next < deck.blocks.size() && deck.blocks[next].name != "DEFINE_CURVE") ++next;
    if (next == deck.blocks.size()) fail_at(block.place, "*DEFINE_TABLE: expected a curve for each of its values");
    Cards of_curve(deck.blocks[next]);
    if (deck.blocks[next].title) of_curve.next();
    const Card of_number = of_curve.require("the number of the curve");
    id = fields(of_number).integer(0, "lcid") + add;
    ++next;
  }
}

void DeckData::read_vector(const KeywordBlock& block) {
  for_each_card(block, [&](const Card& card) {
    const Fields f = fields(card);
    Point d{};
    for (std::size_t k = 0; k < 3; ++k) d[k] = f.number(4 + k, "head", 0.0) - f.number(1 + k, "tail", 0.0);
    const std::int64_t id = f.integer(0, "vid") + offset_of(block, &DeckTransform::define);
    give_once(block, fmt::format("vector {}", id), card.place);
    vectors_[id] = unit(d, card.place);
  });
}

void DeckData::read_box(const KeywordBlock& block) {
  for_each_card(block, [&](const Card& card) {
    const Fields f = fields(card);
    Box box{};
    const double length = units_of(block).length;
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = length * f.number(1 + 2 * k, "minimum", 0.0);
      box.high[k] = length * f.number(2 + 2 * k, "maximum", 0.0);
    }
    boxes_[f.integer(0, "boxid") + offset_of(block, &DeckTransform::define)] = box;
  });
}

/// Origin, a point of the x axis and one of the xy plane; or the x axis and a vector of the xy plane.
void DeckData::read_system(const KeywordBlock& block) {
  Cards cards(block);
  if (block.title) cards.next();
  const Card first = cards.require("the number of the system");
  const Fields f = fields(first);
  Point x{}, in_plane{};
  if (block.name == "DEFINE_COORDINATE_VECTOR") {
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = f.number(1 + k, "x", 0.0);
      in_plane[k] = f.number(4 + k, "v", 0.0);
    }
  } else {
    const Card second = cards.require("a point of the xy plane");
    const Fields more = fields(second);
    for (std::size_t k = 0; k < 3; ++k) {
      const double origin = f.number(1 + k, "o", 0.0);
      x[k] = f.number(4 + k, "l", 0.0) - origin;
      in_plane[k] = more.number(k, "p", 0.0) - origin;
    }
  }
  const Point e1 = unit(x, first.place), e3 = unit(cross(e1, in_plane), first.place);
  const std::int64_t id = f.integer(0, "cid") + offset_of(block, &DeckTransform::define);
  give_once(block, fmt::format("local system {}", id), first.place);
  systems_[id] = {e1, cross(e3, e1), e3};
}

void DeckData::read_part_set(const KeywordBlock& block) {
  std::string form = block.name;
  const bool collects = take_ending(form, "_COLLECT");
  form.erase(0, std::string_view("SET_PART").size());
  if (form != "" && form != "_LIST" && form != "_LIST_GENERATE" && form != "_ADD" && form != "_GENERATE") {
    report.refuse(block, "a form of sets that is not read");
    return;
  }
  Cards cards(block);
  if (block.title) cards.next();
  const Card head = cards.require("the number of the set");
  const std::int64_t id = fields(head).integer(0, "sid") + offset_of(block, &DeckTransform::set);
  std::vector<std::int64_t> members;
  while (const auto card = cards.next_filled()) add_parts(block, *card, members);
  if (!collects) give_once(block, fmt::format("set of parts {}", id), head.place);
  std::vector<std::int64_t>& set = part_sets_[id];
  if (!collects) set.clear();
  set.insert(set.end(), members.begin(), members.end());
}

/// Parts, first and last ones, or sets: of the parts in between those that have solids.
void DeckData::add_parts(const KeywordBlock& block, const Card& card, std::vector<std::int64_t>& members) const {
  const Fields f = fields(card);
  const bool generate = block.name.ends_with("_GENERATE"), sums = block.name.ends_with("_ADD");
  const std::int64_t add = offset_of(block, &DeckTransform::part);
  for (std::size_t i = 0; i < 8; i += generate ? 2 : 1) {
    const std::int64_t first = f.integer(i, "part", 0);
    if (first == 0) continue;
    if (sums) {
      const auto other = part_set(first + offset_of(block, &DeckTransform::set), card.place);
      members.insert(members.end(), other.begin(), other.end());
    } else if (generate) {
      const std::int64_t last = f.integer(i + 1, "last part", first);
      for (const MeshPart& part : mesh.parts) {
        if (part.id >= first + add && part.id <= last + add) members.push_back(part.id);
      }
    } else {
      members.push_back(first + add);
    }
  }
}

void DeckData::name_bodies() {
  std::vector<std::int64_t> elements(mesh.parts.size(), 0);
  for (const std::int32_t part : mesh.part) ++elements[part];
  used.assign(mesh.mesh.nodes.size(), false);
  for (const auto& hexahedron : mesh.mesh.hexahedra) {
    for (const std::int32_t node : hexahedron) used[node] = true;
  }
  for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
    if (elements[p] == 0) continue;
    const auto found = all_parts_.find(mesh.parts[p].id);
    if (found == all_parts_.end()) {
      const auto first = std::ranges::find(mesh.part, static_cast<std::int32_t>(p)) - mesh.part.begin();
      throw InputError(fmt::format("{}: element {} is of part {}, which no *PART defines",
                                   place_of_element(mesh, static_cast<std::int32_t>(first)), mesh.element_ids[first],
                                   mesh.parts[p].id));
    }
    parts.push_back(found->second);
    materials_.insert(found->second.material);
  }
  std::ranges::sort(parts, {}, &DeckPart::id);  // whatever their order in the deck: the scene is the same
  std::set<std::string> taken;
  for (DeckPart& part : parts) {
    part.body = name_of(titles_[part.id]);
    if (part.body.empty() || !taken.insert(part.body).second) part.body = fmt::format("part_{}", part.id);
    taken.insert(part.body);
  }
}

const DeckCurve& DeckData::find_curve(std::int64_t id, const DeckPlace& place) const {
  const auto found = curves_.find(id);
  if (found == curves_.end()) fail_at(place, fmt::format("no *DEFINE_CURVE has the number {}", id));
  if (found->second.abscissa.empty()) fail_at(place, fmt::format("*DEFINE_CURVE {} has no points", id));
  return found->second;
}

const DeckCurve& DeckData::curve(std::int64_t id, const DeckPlace& place) const {
  const DeckCurve& found = find_curve(id, place);
  if (found.relaxes)
    fail_at(place, fmt::format("*DEFINE_CURVE {} is for dynamic relaxation alone (SIDR 1), which is not there", id));
  if (!found.units.are_own())
    fail_at(place, fmt::format("*DEFINE_CURVE {} stands in an included file of other units, where curves are those of "
                               "materials alone: move it into the deck",
                               id));
  return found;
}

DeckCurve DeckData::yield_curve(std::int64_t id, const DeckPlace& place) const {
  DeckCurve curve = find_curve(id, place);
  for (double& stress : curve.ordinate) stress *= curve.units.stress();
  return curve;
}

DeckCurve DeckData::rate_curve(std::int64_t id, const DeckPlace& place) const {
  DeckCurve curve = find_curve(id, place);
  for (double& rate : curve.abscissa) rate *= curve.units.rate();
  return curve;
}

const DeckTable* DeckData::table(std::int64_t id) const {
  const auto found = tables_.find(id);
  return found == tables_.end() ? nullptr : &found->second;
}

const Box& DeckData::box(std::int64_t id, const DeckPlace& place) const {
  const auto found = boxes_.find(id);
  if (found == boxes_.end()) fail_at(place, fmt::format("no *DEFINE_BOX has the number {}", id));
  return found->second;
}

Point DeckData::vector(std::int64_t id, const DeckPlace& place) const {
  const auto found = vectors_.find(id);
  if (found == vectors_.end()) fail_at(place, fmt::format("no *DEFINE_VECTOR has the number {}", id));
  return found->second;
}

std::array<Point, 3> DeckData::axes(std::int64_t system, const DeckPlace& place) const {
  if (system == 0) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto found = systems_.find(system);
  if (found == systems_.end())
    fail_at(place, fmt::format("no *DEFINE_COORDINATE_SYSTEM or _VECTOR has the number {}", system));
  return found->second;
}

std::vector<std::int64_t> DeckData::part_set(std::int64_t id, const DeckPlace& place) const {
  const auto found = part_sets_.find(id);
  if (found == part_sets_.end()) fail_at(place, fmt::format("no *SET_PART has the number {}", id));
  return found->second;
}

const DeckPart* DeckData::find_part(std::int64_t id) const {
  const auto found = std::ranges::lower_bound(parts, id, {}, &DeckPart::id);
  return found != parts.end() && found->id == id ? &*found : nullptr;
}

std::optional<std::string> DeckData::body_of(std::int64_t part, const DeckPlace& place) const {
  if (const DeckPart* found = find_part(part)) return found->body;
  if (!all_parts_.contains(part)) fail_at(place, fmt::format("no *PART has the number {}", part));
  return std::nullopt;
}

}  // namespace pinball

#include "deck_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include <solver/base/error.hpp>
#include <solver/formats/deck/names_once.hpp>
#include <solver/formats/lsdyna/layouts/definition_cards.hpp>
#include <solver/formats/lsdyna/layouts/mesh_cards.hpp>
#include <solver/formats/lsdyna/mesh/part_inertia.hpp>
#include <solver/formats/lsdyna/scan/keyword_scanner.hpp>
#include <solver/mesh/element_types.hpp>

#include "deck_plastic_laws.hpp"
#include "keyword_rules.hpp"
#include "unread.hpp"

namespace pinball {

namespace {

Point unit(Point d, const DeckPlace& place) {
  const double length = std::sqrt(dot(d, d));
  if (!(length > 0)) fail_at(place, "expected a direction, got a vector of no length");
  for (double& component : d) component /= length;
  return d;
}

/// A factor, for which 0 is 1.
double factor_of(const Fields& f, const char* name) {
  const double value = f.number(name);
  return value == 0 ? 1.0 : value;
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
    : deck(deck_), mesh(mesh_), report(report_), nodes(mesh_.node_ids), middles(mesh_), boxes(deck_) {
  for (const KeywordBlock& block : deck.blocks) {
    blocks_[block.name].push_back(&block);
    read(block);
  }
  for (const bool sums : {false, true}) {  // *SET_PART_ADD may stand before the sets that it adds
    for (const KeywordBlock& block : deck.blocks) {
      const bool adds = block.name.ends_with("_ADD") || block.name.ends_with("_ADD_COLLECT");
      if (block.name.starts_with("SET_PART") && adds == sums) read_part_set(block);
    }
  }
  name_bodies();
  find_rigid_parts();
  tell_unused_state_equations();
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
  if (block.name.starts_with("EOS_")) number_state_equation(block);
  if (block.name == "HOURGLASS") read_hourglass(block);
  if (block.name == "DEFINE_CURVE") read_curve(block);
  if (block.name == "DEFINE_TABLE") read_table(block);
  if (block.name == "DEFINE_VECTOR") read_vector(block);
  if (block.name == "DEFINE_COORDINATE_SYSTEM" || block.name == "DEFINE_COORDINATE_VECTOR") read_system(block);
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
  const auto read = [&](const Card& title, const Card& card) {
    const Fields f = fields(card, layout::part);
    const std::int64_t id = f.integer("PID") + offset_of(block, &DeckTransform::part);
    const std::int64_t hourglass_id = f.integer("HGID"), equation = f.integer("EOSID");
    all_parts_[id] = {id,
                      f.integer("SECID") + other,
                      f.integer("MID") + offset_of(block, &DeckTransform::material),
                      hourglass_id == 0 ? 0 : hourglass_id + other,
                      equation == 0 ? 0 : equation + offset_of(block, &DeckTransform::material),
                      "",
                      card.place};
    titles_[id] = std::string(trimmed(title.text));
  };
  for_each_part(block, read, [&](const Card&, Cards& cards) {
    if (block.name == "PART_CONTACT") {
      const Card contact = cards.next_or_blank();
      fields(contact, layout::part_contact);
    } else {
      pass_inertia(cards, deck.parameters);
    }
  });
}

namespace {

/// The lines of an element that users have written: numbers of its points and of its constants, then these.
void pass_users_element(const DeckData& data, Cards& cards) {
  static constexpr CardLayout numbers{layout::whole("NIP"), layout::gap, layout::gap, layout::gap,
                                      layout::whole("LMC")};
  const Card card = cards.next_or_blank();
  const Fields f = data.fields(card, numbers);
  constexpr std::int64_t most = 10'000;  // lines; what has more of them is damaged
  const std::int64_t lines = std::clamp<std::int64_t>(f.integer("NIP"), 0, most) +
                             (std::clamp<std::int64_t>(f.integer("LMC"), 0, 8 * most) + 7) / 8;
  for (std::int64_t i = 0; i < lines && cards.next(); ++i) {
  }
}

}  // namespace

void DeckData::read_section(const KeywordBlock& block) {
  for_each_card(block, [&](const Card& card, Cards& cards) {
    const Fields f = fields(card, layout::section_solid);
    const std::int64_t id = f.integer("SECID") + offset_of(block, &DeckTransform::other);
    define(block, "section", id, card.place);
    section_form[id] = f.integer("ELFORM");
    if (is_of_users(section_form[id])) pass_users_element(*this, cards);
  });
}

void DeckData::read_hourglass(const KeywordBlock& block) {
  for_each_card(block, [&](const Card& card) {
    const Fields f = fields(card, layout::hourglass);
    const DeckHourglass h{f.integer("IHQ"), f.number("QM"), f.number("Q1"), f.number("Q2")};
    const std::int64_t id = f.integer("HGID") + offset_of(block, &DeckTransform::other);
    define(block, "hourglass control", id, card.place);
    hourglass[id] = h;
  });
}

void DeckData::read_curve(const KeywordBlock& block) {
  Cards cards(block);
  if (block.title) cards.next();
  const Card head = cards.require("the number of the curve");
  const Fields f = fields(head, layout::curve);
  const double sfa = factor_of(f, "SFA"), sfo = factor_of(f, "SFO"), offa = f.number("OFFA"), offo = f.number("OFFO");
  const std::int64_t relaxation = f.integer("SIDR");
  DeckCurve curve{{}, {}, units_of(block), relaxation == 1, head.place};
  if (sfa * offa > 0 && f.integer("DATTYP") == 0) curve.moved = sfa * offa;
  if (relaxation == 2)
    report.unused(head.place, block.star_name() + ": SIDR", "there is no dynamic relaxation: it is for the run alone");
  while (const auto card = cards.next_filled()) {
    const Fields point = fields(*card, layout::curve_point);
    curve.abscissa.push_back(sfa * (point.number("A1") + offa));
    curve.ordinate.push_back(sfo * (point.number("O1") + offo));
  }
  const std::int64_t id = f.integer("LCID") + offset_of(block, &DeckTransform::curve);
  define(block, "curve or table", id, head.place);
  curves_[id] = std::move(curve);
}

/// Values, and then as many curves, which follow as keywords of their own in the order of the values. The values are
/// logarithms of rates where the first is below 0.
void DeckData::read_table(const KeywordBlock& block) {
  Cards cards(block);
  if (block.title) cards.next();
  const Card head = cards.require("the number of the table");
  const std::int64_t add = offset_of(block, &DeckTransform::curve);
  const Fields f = fields(head, layout::table);
  const double scale = factor_of(f, "SFA"), offset = f.number("OFFA");
  const std::int64_t number = f.integer("TBID") + add;
  define(block, "curve or table", number, head.place);
  DeckTable& table = tables_[number] = {};
  while (const auto card = cards.next_filled()) {
    const Fields point = fields(*card, layout::table_value);
    table.curves.emplace_back(scale * (point.number("VALUE") + offset), point.integer("LCID"));
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
    id = fields(of_number, layout::curve).integer("LCID") + add;
    ++next;
  }
}

void DeckData::read_vector(const KeywordBlock& block) {
  for_each_card(block, [&](const Card& card) {
    const Fields f = fields(card, layout::vector);
    const std::int64_t id = f.integer("VID") + offset_of(block, &DeckTransform::define);
    define(block, "vector", id, card.place);
    vectors_[id] = unit(minus(f.point("XH"), f.point("XT")), card.place);
  });
}

std::array<Point, 3> axes_by(const Point& x, const Point& in_plane, const DeckPlace& place) {
  const Point e1 = unit(x, place), e3 = unit(cross(e1, in_plane), place);
  return {e1, cross(e3, e1), e3};
}

/// Origin, a point of the x axis and one of the xy plane; or the x axis and a vector of the xy plane.
void DeckData::read_system(const KeywordBlock& block) {
  Cards cards(block);
  if (block.title) cards.next();
  const Card first = cards.require("the number of the system");
  const bool vectors = block.name == "DEFINE_COORDINATE_VECTOR";
  const Fields f = fields(first, vectors ? layout::system_vectors : layout::system);
  Point x{}, in_plane{};
  if (vectors) {
    x = f.point("XX");
    in_plane = f.point("XV");
  } else {
    const Card second = cards.require("a point of the xy plane");
    const Point origin = f.point("XO");
    x = minus(f.point("XL"), origin);
    in_plane = minus(fields(second, layout::system_plane).point("XP"), origin);
  }
  const std::int64_t id = f.integer("CID") + offset_of(block, &DeckTransform::define);
  define(block, "local system", id, first.place);
  systems_[id] = axes_by(x, in_plane, first.place);
}

void DeckData::read_part_set(const KeywordBlock& block) {
  std::string form = block.name;
  const bool collects = take_ending(form, "_COLLECT");
  form.erase(0, std::string_view("SET_PART").size());
  if (form != "" && form != "_LIST" && form != "_LIST_GENERATE" && form != "_ADD" && form != "_GENERATE") {
    report.reject(block.place, block.star_name(), "give its parts as _LIST, _GENERATE or _ADD");
    return;
  }
  Cards cards(block);
  if (block.title) cards.next();
  const Card head = cards.require("the number of the set");
  const std::int64_t id = fields(head, layout::set_head).integer("SID") + offset_of(block, &DeckTransform::set);
  std::vector<std::int64_t> members;
  while (const auto card = cards.next_filled()) add_parts(block, *card, members);
  if (!collects) give_once(block, fmt::format("set of parts {}", id), head.place);
  std::vector<std::int64_t>& set = part_sets_[id];
  if (!collects) set.clear();
  set.insert(set.end(), members.begin(), members.end());
}

/// Parts, first and last ones, or sets: of the parts in between those that have solids.
void DeckData::add_parts(const KeywordBlock& block, const Card& card, std::vector<std::int64_t>& members) const {
  const bool generate = block.name.find("_GENERATE") != std::string::npos,
             sums = block.name.find("_ADD") != std::string::npos;
  const Fields f = fields(card, generate ? layout::set_ranges : layout::members);
  const std::int64_t add = offset_of(block, &DeckTransform::part);
  for (std::size_t i = 0; i < 8; i += generate ? 2 : 1) {
    const std::int64_t first = f.integer(i);
    if (first == 0) continue;
    if (sums) {
      const auto other = part_set(first + offset_of(block, &DeckTransform::set), card.place);
      members.insert(members.end(), other.begin(), other.end());
    } else if (generate) {
      const std::int64_t last = f.blank(i + 1) ? first : f.integer(i + 1);
      const std::size_t before = members.size();
      for (const MeshPart& part : mesh.parts) {
        if (part.id >= first + add && part.id <= last + add) members.push_back(part.id);
      }
      if (members.size() == before)
        report.unused(
            card.place,
            fmt::format("{}: B{}BEG to B{}END, {} to {}", block.star_name(), i / 2 + 1, i / 2 + 1, first, last),
            "no part with solids has a number in between");
    } else {
      members.push_back(first + add);
    }
  }
}

void DeckData::name_bodies() {
  std::vector<std::int64_t> elements(mesh.parts.size(), 0), tetrahedra(elements), wedges(elements);
  used.assign(mesh.mesh.nodes.size(), false);
  for (std::size_t e = 0; e < mesh.part.size(); ++e) {
    ++elements[mesh.part[e]];
    const WorkedShape shape = worked_as(mesh.mesh.hexahedra[e]);
    if (shape == WorkedShape::tetrahedron) ++tetrahedra[mesh.part[e]];
    if (shape == WorkedShape::wedge) ++wedges[mesh.part[e]];
    for (const std::int32_t node : mesh.mesh.hexahedra[e]) used[node] = true;
  }
  for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
    if (elements[p] == 0) continue;
    const auto found = all_parts_.find(mesh.parts[p].id);
    if (found == all_parts_.end()) {
      const auto first = std::ranges::find(mesh.part, static_cast<std::int32_t>(p)) - mesh.part.begin();
      throw InputError(fmt::format("{}: element {} is of part {}, which no *PART defines",
                                   place_of_element(mesh, first), mesh.element_ids[first], mesh.parts[p].id));
    }
    found->second.solids = elements[p];
    found->second.tetrahedra = tetrahedra[p];
    found->second.wedges = wedges[p];
    found->second.ten_nodes = elements[p] == static_cast<std::int64_t>(8 * mesh.parts[p].ten_nodes);
    parts.push_back(found->second);
    materials_.insert(found->second.material);
  }
  std::ranges::sort(parts, {}, &DeckPart::id);  // whatever their order in the deck: the scene is the same
  NamesOnce names;
  for (DeckPart& part : parts) part.body = names.take(name_of(titles_[part.id]), fmt::format("part_{}", part.id));
}

const DeckCurve& DeckData::find_curve(std::int64_t id, const DeckPlace& place) const {
  const auto found = curves_.find(definitions_.name("curve or table", id));
  if (found == curves_.end()) fail_at(place, fmt::format("no *DEFINE_CURVE has the number {}", id));
  if (found->second.abscissa.empty()) fail_at(place, fmt::format("*DEFINE_CURVE {} has no points", id));
  if (found->second.relaxes)
    fail_at(place, fmt::format("*DEFINE_CURVE {} is for dynamic relaxation alone (SIDR 1), which is not there", id));
  return found->second;
}

const DeckCurve& DeckData::curve(std::int64_t id, const DeckPlace& place) const {
  const DeckCurve& found = find_curve(id, place);
  if (!found.units.are_own())
    fail_at(place, fmt::format("*DEFINE_CURVE {} stands in an included file of other units, where curves are those of "
                               "materials alone: move it into the deck",
                               id));
  return found;
}

DeckCurve DeckData::yield_curve(std::int64_t id, const DeckPlace& place) const {
  DeckCurve curve = find_curve(id, place);
  for (double& stress : curve.ordinate) stress *= curve.units.stress();
  tell_first_strain(report, fmt::format("*DEFINE_CURVE {} ({})", id, curve.place.text()), curve);
  return curve;
}

DeckCurve DeckData::rate_curve(std::int64_t id, const DeckPlace& place) const {
  DeckCurve curve = find_curve(id, place);
  for (double& rate : curve.abscissa) rate *= curve.units.rate();
  return curve;
}

const DeckTable* DeckData::table(std::int64_t id) const {
  const auto found = tables_.find(definitions_.name("curve or table", id));
  return found == tables_.end() ? nullptr : &found->second;
}

Point DeckData::vector(std::int64_t id, const DeckPlace& place) const {
  const auto found = vectors_.find(definitions_.name("vector", id));
  if (found == vectors_.end()) fail_at(place, fmt::format("no *DEFINE_VECTOR has the number {}", id));
  return found->second;
}

std::array<Point, 3> DeckData::axes(std::int64_t system, const DeckPlace& place) const {
  if (system == 0) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto found = systems_.find(definitions_.name("local system", system));
  if (found == systems_.end())
    fail_at(place, fmt::format("no *DEFINE_COORDINATE_SYSTEM or _VECTOR has the number {}{}", system,
                               second_of_keyword(deck, "DEFINE_COORDINATE_", system, &DeckTransform::define)));
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

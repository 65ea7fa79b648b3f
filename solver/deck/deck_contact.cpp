#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "deck_parts.hpp"

namespace pinball {

namespace {

using Bodies = std::set<std::string>;

/// One contact keyword.
struct DeckContact {
  Bodies slave, master;  ///< master: empty for a single surface
  bool single = false;
  double friction = 0, static_friction = 0;
};

Bodies all_bodies(const DeckData& data) {
  Bodies bodies;
  for (const DeckPart& part : data.parts) bodies.insert(part.body);
  return bodies;
}

/// Bodies of a side; none for what is not made of parts, which is refused.
Bodies side(DeckData& data, const KeywordBlock& block, const Fields& f, std::size_t which) {
  const std::int64_t id = f.integer(which, "ssid, msid", 0), kind = f.integer(2 + which, "sstyp, mstyp", 0);
  if ((id == 0 && which == 0) || kind == 5) return all_bodies(data);
  Bodies bodies;
  if (kind != 2 && kind != 3) {
    data.report.refuse(f.place(), fmt::format("{} of sets of segments, nodes or shells", block.star_name()));
    return bodies;
  }
  const auto parts = kind == 2 ? data.part_set(id + offset_of(block, &DeckTransform::set), f.place())
                               : std::vector{id + offset_of(block, &DeckTransform::part)};
  for (const std::int64_t part : parts) {
    if (const auto body = data.body_of(part, f.place())) bodies.insert(*body);
  }
  return bodies;
}

DeckContact read_contact(DeckData& data, const KeywordBlock& block) {
  Cards cards(block);
  if (block.id || block.title) cards.next();
  const Card first = cards.require("the surfaces of the contact"), second = cards.next_or_blank();
  const Fields f = data.fields(first), constants = data.fields(second);
  DeckContact contact;
  contact.single = block.name.ends_with("SINGLE_SURFACE") || block.name.ends_with("GENERAL");
  if (f.integer(4, "sboxid", 0) != 0 || f.integer(5, "mboxid", 0) != 0)
    data.report.refuse(first.place, block.star_name() + " with boxes");
  contact.slave = side(data, block, f, 0);
  if (!contact.single) contact.master = side(data, block, f, 1);
  const double fs = constants.number(0, "fs", 0.0), fd = constants.number(1, "fd", 0.0),
               dc = constants.number(2, "dc", 0.0);
  contact.static_friction = fs;
  contact.friction = dc > 0 ? fd : fs;
  if (dc > 0 && fd != fs)
    data.report.understood(
        fmt::format("{} ({}): friction is FS at rest and FD while sliding; the decay DC between them "
                    "is not used",
                    block.star_name(), second.place.text()));
  const double death = constants.number(7, "dt", 0.0);
  if (constants.number(6, "bt", 0.0) != 0 || (death != 0 && death < 1e19))
    data.report.refuse(second.place, block.star_name() + " with birth or death");
  if (constants.number(4, "vdc", 0.0) != 0)
    data.report.understood(fmt::format("{} ({}): damping of contact (VDC) is not used: impulses do not ring",
                                       block.star_name(), second.place.text()));
  return contact;
}

}  // namespace

void translate_contact(DeckData& data, TomlText& scene) {
  std::vector<DeckContact> contacts;
  const KeywordBlock* last = nullptr;
  for (const KeywordBlock& block : data.deck.blocks) {
    if (!block.name.starts_with("CONTACT_AUTOMATIC_") && !block.name.starts_with("CONTACT_ERODING_")) continue;
    contacts.push_back(read_contact(data, block));
    last = &block;
  }
  if (contacts.empty()) return;
  const Bodies all = all_bodies(data);
  const DeckContact& first = contacts.front();
  const bool whole = first.single && first.slave == all;
  const bool two = !first.single && all.size() == 2 && first.slave.size() == 1 && first.master.size() == 1 &&
                   first.slave != first.master;
  if (contacts.size() > 1 || !(whole || two))
    data.report.refuse(last->place, fmt::format("contact of some parts of a deck alone ({})", last->star_name()));
  scene.table("contact", fmt::format("{} {}", last->star_name(), last->place.text()));
  scene.key("method", "pinball");
  scene.key("self", whole);
  scene.key("friction", first.friction);
  if (first.static_friction > first.friction) scene.key("static_friction", first.static_friction);
  data.report.understood(fmt::format("{}: exact contact of faces and edges, without penalties", last->star_name()));
}

}  // namespace pinball

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <solver/formats/deck/deck_side.hpp>
#include <solver/formats/lsdyna/layouts/contact_cards.hpp>

#include "boundary_keys.hpp"
#include "deck_parts.hpp"

/// *CONTACT_...: in the form of R11 of the manual: cards 1 to 3 as SSID MSID SSTYP MSTYP SBOXID MBOXID SPR MPR, FS FD
/// DC VC VDC PENCHK BT DT and SFS SFM SST MST SFST SFMT FSF VSF, after the card of _ID; what follows scales penalties.
namespace pinball {

namespace {

/// One contact keyword.
struct DeckContact {
  std::string name;
  DeckCard card;
  bool single = false, tied = false;
  DeckSide slave, master;
  double friction = 0, static_friction = 0, decay = 0;
  double start = 0, end = 0;  ///< end: 0: none
  double tolerance = -1;      ///< of a tied contact; negative: none is given
};

bool is_contact(const std::string& name) {
  return name.starts_with("CONTACT_") && !name.starts_with("CONTACT_FORCE_TRANSDUCER") && name != "CONTACT_INTERIOR";
}

std::vector<std::string> all_but(const DeckData& data, const std::vector<std::string>& bodies) {
  std::vector<std::string> others = all_bodies(data);
  std::erase_if(others, [&](const std::string& b) { return std::ranges::find(bodies, b) != bodies.end(); });
  return others;
}

/// which: 0 the slave side, 1 the master side.
DeckSide side_of(DeckData& data, const KeywordBlock& block, const Fields& f, std::size_t which) {
  const std::int64_t id = f.integer(which == 0 ? "SSID" : "MSID"), kind = f.integer(which == 0 ? "SSTYP" : "MSTYP");
  const std::int64_t set = id + offset_of(block, &DeckTransform::set);
  DeckSide side;
  if (id == 0 && which == 0 && kind != 0 && kind != 5)
    data.report.unused(f.place(), block.star_name() + ": SSTYP", "without SSID all parts touch");
  if ((id == 0 && which == 0) || kind == 5) {
    side.bodies = all_bodies(data);
  } else if (kind == 2) {
    side.bodies = bodies_of(data, data.part_set(set, f.place()), f.place());
  } else if (kind == 3) {
    side.bodies = bodies_of(data, {id + offset_of(block, &DeckTransform::part)}, f.place());
  } else if (kind == 6) {
    side.bodies = all_but(data, bodies_of(data, data.part_set(set, f.place()), f.place()));
  } else if (kind == 0 || (kind == 4 && which == 0 && block.name.find("NODES_TO_SURFACE") != std::string::npos)) {
    return {{}, kind == 0 ? "faces" : "nodes", std::to_string(set)};
  } else {
    data.report.reject(f.place(), fmt::format("{} with SSTYP or MSTYP {}", block.star_name(), kind),
                       "give segments (0), parts (2, 3, 6) or, of NODES_TO_SURFACE, nodes (4)");
    return side;
  }
  if (side.bodies.empty())
    data.report.reject(f.place(), fmt::format("{} with a side that has no parts with solids", block.star_name()),
                       "give a side with solids, or leave the contact out");
  return side;
}

/// FS at rest, FD while sliding, DC the decay between both; all times FSF.
void read_friction(DeckData& data, const KeywordBlock& block, const Fields& f, const Fields& scales,
                   DeckContact& contact) {
  const double fs = f.number("FS"), fd = f.number("FD");
  if (fs == 0 && fd == 0) return;
  if (fs < 0 || fs == 2)
    data.report.reject(f.place(),
                       fmt::format("{} with FS = {}, friction of parts or from a table", block.star_name(), fs),
                       "give FS, FD and DC here");
  if (f.number("VC") != 0)
    data.report.reject(f.place(), block.star_name() + " with a limit of the friction stress (VC)", "leave it 0");
  const double given = scales.number("FSF"), factor = given > 0 ? given : 1.0, dc = f.number("DC");
  if (dc <= 0 && fd != 0 && fd != fs)
    data.report.unused(f.place(), block.star_name() + ": FD", "without DC friction is FS, whatever the speed");
  if (dc > 0 && fd == fs) data.report.unused(f.place(), block.star_name() + ": DC", "FD is FS, whatever the speed");
  contact.static_friction = factor * fs;
  contact.friction = factor * (dc > 0 ? fd : fs);
  contact.decay = dc > 0 && fd != fs ? dc : 0.0;
}

void read_times(DeckData& data, const KeywordBlock& block, const Fields& f, DeckContact& contact) {
  contact.start = f.number("BT");
  contact.end = f.number("DT");
  if (contact.start < 0 || contact.end < 0)
    data.report.reject(f.place(), block.star_name() + " with a negative birth or death", "give times (BT, DT)");
  if (contact.end >= 1e19) contact.end = 0;
}

/// What follows the three cards of each contact; nothing of it becomes anything, and all of it is reported.
void read_more(const DeckData& data, const KeywordBlock& block, Cards& cards) {
  if (block.name.starts_with("CONTACT_ERODING")) data.fields(cards.next_or_blank(), layout::contact_eroding);
  for (const CardLayout* optional : layout::contact_optional) {
    if (const auto card = cards.next()) data.fields(*card, *optional);
  }
}

/// The lines of _MPP, of which nothing becomes anything. Returns the line behind them.
Card read_processors(const DeckData& data, const KeywordBlock& block, Cards& cards) {
  if (block.mpp) {
    const Card first = cards.require("the line of _MPP");
    data.fields(first, layout::contact_mpp);
  }
  Card card = cards.require("the surfaces of the contact");
  const bool is_second =
      block.mpp && card.text.starts_with('&') && (card.text.size() == 1 || card.text[1] == ' ' || card.text[1] == ',');
  if (!is_second) return card;  // & before a letter is a parameter
  {
    const Fields second = data.fields(card, layout::contact_mpp_more);
    second.blank(0);  // the sign that it is such a line
  }
  return cards.require("the surfaces of the contact");
}

DeckContact read_contact(DeckData& data, const KeywordBlock& block) {
  Cards cards(block);
  DeckContact contact;
  if (block.id || block.title) {
    Card number = cards.require("the number of the contact");
    number.log = nullptr;  // what follows it is a title
    const std::int64_t given = data.fields(number, layout::contact_number).integer("CID");
    const std::int64_t id = given == 0 ? 0 : given + offset_of(block, &DeckTransform::other);
    if (id > 0) contact.name = fmt::format("contact_{}", id);
    if (id > 0) data.give_once(block, fmt::format("contact {}", id), block.place);
  }
  const Card first = read_processors(data, block, cards), second = cards.next_or_blank(), third = cards.next_or_blank();
  read_more(data, block, cards);
  const Fields f = data.fields(first, layout::contact_sides), constants = data.fields(second, layout::contact_friction),
               scales = data.fields(third, layout::contact_scales);
  contact.card = {block.star_name(), first.place};
  contact.single =
      block.name.find("SINGLE_SURFACE") != std::string::npos || block.name.find("_GENERAL") != std::string::npos;
  contact.tied = block.name.starts_with("CONTACT_TIED_");
  contact.slave = side_of(data, block, f, 0);
  if (!contact.single) contact.master = side_of(data, block, f, 1);
  read_times(data, block, constants, contact);
  if (contact.tied) {
    const double thickness = scales.number("SST"), of_master = scales.number("MST");
    if (thickness < 0 || of_master < 0) {
      contact.tolerance = 0.6 * std::abs(thickness + of_master);
    } else if (thickness > 0 || of_master > 0) {
      data.report.unused(third.place, block.star_name() + ": SST, MST", "nodes are tied by them where one is negative");
    }
    return contact;
  }
  read_friction(data, block, constants, scales, contact);
  return contact;
}

/// Of several with one number the later ones have none.
void name_contacts(std::vector<DeckContact>& contacts) {
  std::set<std::string> taken;
  for (DeckContact& contact : contacts) {
    if (!contact.name.empty() && !taken.insert(contact.name).second) contact.name.clear();
  }
}

/// Of all that touches, or of a pair.
template <class Keys>
void set_friction(const DeckContact& contact, const Keys& keys) {
  keys.set("friction", contact.friction, "fd");
  if (contact.static_friction != contact.friction) keys.set("static_friction", contact.static_friction, "fs");
  if (contact.decay > 0) keys.set("friction_decay", contact.decay, "dc");
}

/// Of a pair, or of what is tied.
template <class Keys>
void set_sides(const DeckContact& contact, const Keys& keys) {
  if (!contact.name.empty()) keys.set("name", contact.name, "cid");
  keys.set("first", contact.slave.given());
  if (!contact.single) keys.set("second", contact.master.given());
  if (contact.start > 0) keys.set("start", contact.start, "bt");
  if (contact.end > 0) keys.set("end", contact.end, "dt");
}

/// A lone single surface of all parts needs no pairs.
bool is_contact_of_all(const DeckData& data, const std::vector<const DeckContact*>& touching) {
  const DeckContact& only = *touching.front();
  return touching.size() == 1 && only.single && only.slave.kind.empty() && only.slave.bodies == all_bodies(data) &&
         only.start == 0 && only.end == 0;
}

void write_touching(DeckData& data, const std::vector<const DeckContact*>& touching, DeckScene& scene) {
  const auto all = scene.table<ContactSettings>("contact", touching.front()->card);
  all.set("method", "pinball");
  if (is_contact_of_all(data, touching)) {
    set_friction(*touching.front(), all);
  } else {
    for (const DeckContact* contact : touching) {
      const auto pair = scene.entry<ContactPair>("contact.pair", contact->card);
      set_sides(*contact, pair);
      set_friction(*contact, pair);
    }
  }
  for (const DeckContact* contact : touching)
    data.report.understood(
        fmt::format("{}: exact contact of faces and edges, without penalties", contact->card.text()));
  for (const DeckContact* contact : touching) {
    if (contact->card.keyword.find("ONE_WAY") != std::string::npos)
      data.report.understood(
          fmt::format("{}: both sides touch each other, not the first the second alone", contact->card.text()));
  }
  if (touching.size() > 1)
    data.report.understood("where several contacts name the same two surfaces, the last one counts");
}

void write_tied(DeckData& data, const DeckContact& contact, DeckScene& scene) {
  const auto keys = scene.entry<TiedContact>("contact.tied", contact.card);
  set_sides(contact, keys);
  if (contact.tolerance >= 0) keys.set("tolerance", contact.tolerance, "sst, mst");
  const bool offset = contact.card.keyword.find("_OFFSET") != std::string::npos;
  data.report.understood(fmt::format("{}: nodes of the first side are tied to faces of the second, and put on them{}",
                                     contact.card.text(), offset ? ", offset or not" : ""));
}

}  // namespace

bool translate_contact(DeckData& data, DeckScene& scene) {
  std::vector<DeckContact> contacts;
  for (const KeywordBlock& block : data.deck.blocks) {
    if (is_contact(block.name)) contacts.push_back(read_contact(data, block));
    if (block.name == "CONTACT_INTERIOR")
      for_each_card(block, [&](const Card& card) { data.fields(card, layout::contact_interior); });
  }
  name_contacts(contacts);
  std::vector<const DeckContact*> touching;
  for (const DeckContact& contact : contacts) {
    if (!contact.tied) touching.push_back(&contact);
  }
  if (touching.empty()) {
    const auto keys = scene.table<ContactSettings>("contact", {});
    keys.comment("of which no card says anything");
    keys.set("method", "none");
  } else {
    write_touching(data, touching, scene);
  }
  for (const DeckContact& contact : contacts) {
    if (contact.tied) write_tied(data, contact, scene);
  }
  return !touching.empty();
}

}  // namespace pinball

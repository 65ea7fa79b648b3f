#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "abaqus_exclusions.hpp"
#include "abaqus_interactions.hpp"
#include "abaqus_parts.hpp"

namespace pinball {

namespace {

/// Of all that touches, or of a pair.
template <class Keys>
void set_friction(const AbaqusFriction& friction, const Keys& keys) {
  keys.set("friction", friction.sliding);
  if (friction.at_rest != friction.sliding) keys.set("static_friction", friction.at_rest);
  if (friction.at_rest != friction.sliding) keys.set("friction_decay", friction.decay);
}

/// What may touch what; no second side: the first touches itself.
struct Pair {
  const AbaqusBlock* block;
  DeckPlace place;
  std::string first, second;  ///< labels of surfaces; first empty: all bodies
  std::optional<AbaqusFriction> friction;
};

class Contact {
 public:
  explicit Contact(AbaqusData& data) : data_(data), interactions_(data), exclusions_(data) {}

  /// Returns whether anything says what touches, be it nothing.
  bool translate(DeckScene& scene) {
    for (const AbaqusBlock& block : data_.deck.blocks) {
      if (block.name == "CONTACTINCLUSIONS") read_inclusions(block);
      if (block.name == "CONTACTPROPERTYASSIGNMENT") read_assignments(block);
      if (block.name == "CONTACTPAIR") read_pairs(block);
      if (block.name == "CONTACTEXCLUSIONS") exclusions_.read(block);
    }
    for (const std::vector<Pair>* some : {&assigned_, &of_pairs_})
      pairs_.insert(pairs_.end(), some->begin(), some->end());
    write_walls(scene);
    drop_pairs_not_included();
    if (all_ != nullptr) pairs_.insert(pairs_.begin(), Pair{all_, all_->place, "", "", {}});
    const std::vector<Touching> touching = what_touches();
    exclusions_.report_idle();
    if (touching.empty()) {
      if (!pairs_.empty()) data_.report.understood("contact: none, all of it is excluded");
      const auto keys = scene.table<ContactSettings>("contact", {});
      keys.comment(pairs_.empty() ? "of which no keyword says anything" : "all of which is excluded");
      keys.set("method", "none");
      return !pairs_.empty();
    }
    const AbaqusBlock& head = *pairs_.front().block;
    const auto keys = scene.table<ContactSettings>("contact", card_of(head, head.place));
    keys.set("method", "pinball");
    set_friction(common_, keys);
    write_pairs(touching, scene);
    data_.report.understood("contact: exact, of faces and edges, without penalties");
    return true;
  }

 private:
  /// All of the outside, or pairs of surfaces.
  void read_inclusions(const AbaqusBlock& block) {
    if (block.has("ALLEXTERIOR")) {
      all_ = &block;
      return;
    }
    DataLines lines(block);
    while (const auto card = lines.next()) {
      const DataFields f(*card);
      pairs_.push_back({&block, card->place, f.text(0), f.text(1), {}});
    }
  }

  /// Of all that touches, or of two surfaces: a pair again, which counts before those that it is a part of. Where
  /// assignments overlap, the last one counts: one of all takes the place of all before it.
  void read_assignments(const AbaqusBlock& block) {
    DataLines lines(block);
    while (const auto card = lines.next()) {
      const DataFields f(*card);
      const AbaqusFriction& friction = interactions_.use(f.text(2), card->place);
      if (!f.blank(0) || !f.blank(1)) {
        assigned_.push_back({&block, card->place, f.text(0), f.text(1), friction});
        continue;
      }
      for (const Pair& pair : assigned_)
        data_.report.unused(pair.place, block.star_name() + " of two surfaces",
                            "one of all stands behind it, and counts");
      assigned_.clear();
      common_ = friction;
    }
  }

  /// Assignments say how surfaces touch that general contact includes, and make none touch.
  void drop_pairs_not_included() {
    if (all_ != nullptr || assigned_.empty()) return;
    AbaqusExclusions included(data_);
    for (const Pair& pair : pairs_) {
      if (pair.block->name == "CONTACTINCLUSIONS") included.add(pair.place, pair.first, pair.second);
    }
    std::erase_if(pairs_, [&](const Pair& pair) {
      if (pair.block->name != "CONTACTPROPERTYASSIGNMENT") return false;
      const Share share = included.share_of_pair(pair.first, pair.second, pair.place);
      const std::string what = pair.block->star_name() + " of two surfaces";
      if (share == Share::none) data_.report.unused(pair.place, what, "*CONTACT INCLUSIONS do not let these touch");
      if (share == Share::some)
        data_.report.reject(pair.place, what, "*CONTACT INCLUSIONS let a part of these touch: name that part alone");
      return share == Share::none;
    });
  }

  /// Of general contact for all nodes, of a pair for those of its other surface.
  void write_walls(DeckScene& scene) {
    for (AbaqusWall& wall : data_.walls) {
      if (all_ != nullptr) set_wall_friction(common_, *all_, begin_wall(data_, wall, scene));
    }
    std::erase_if(pairs_, [&](const Pair& pair) {
      AbaqusWall* wall = data_.wall(pair.first);
      const std::string& other = wall == nullptr ? pair.first : pair.second;
      if (wall == nullptr) wall = data_.wall(pair.second);
      if (wall == nullptr) return false;
      if (pair.block->name != "CONTACTPAIR" || all_ != nullptr) {
        data_.report.reject(pair.place, pair.block->star_name() + " with an analytical surface",
                            "a CONTACT PAIR, or CONTACT INCLUSIONS, ALL EXTERIOR");
        return true;
      }
      const auto keys = begin_wall(data_, *wall, scene);
      keys.set("set", data_.surface(other, pair.place).set);
      set_wall_friction(*pair.friction, *pair.block, keys);
      return true;
    });
    tell_unused_walls(data_);
  }

  void set_wall_friction(const AbaqusFriction& friction, const AbaqusBlock& block, const DeckKeys<RigidWall>& keys) {
    keys.set("friction", friction.sliding);
    if (friction.at_rest != friction.sliding)
      data_.report.unused(block.place, block.star_name() + ": friction at rest", "walls have that while sliding alone");
  }

  void read_pairs(const AbaqusBlock& block) {
    if (block.option("TYPE") == "MASSLESS") {
      data_.report.unused(block.place, "*CONTACT PAIR, TYPE=MASSLESS", "nodes keep their masses, impulses stop them");
    }
    const AbaqusFriction& friction = interactions_.use(block.require("INTERACTION"), block.place);
    DataLines lines(block);
    while (const auto card = lines.next()) {
      const DataFields f(*card);
      of_pairs_.push_back({&block, card->place, f.text(0), f.text(1), friction});
    }
  }

  /// A pair of the scene, and what it is from.
  struct Touching {
    const Pair* pair;
    AbaqusSides sides;
  };

  /// Exclusions are of general contact: a *CONTACT PAIR stays, which is often why they are there.
  std::vector<Touching> what_touches() {
    std::vector<Touching> touching;
    for (const Pair& pair : pairs_) {
      if (pair.block->name == "CONTACTPAIR") {
        touching.push_back({&pair, exclusions_.all_of(pair.first, pair.second, pair.place)});
        continue;
      }
      for (const AbaqusSides& sides : exclusions_.left_of(pair.first, pair.second, pair.place))
        touching.push_back({&pair, sides});
    }
    return touching;
  }

  void write_pairs(const std::vector<Touching>& touching, DeckScene& scene) {
    const bool all = touching.size() == 1 && touching[0].pair->block == all_;
    if (all && touching[0].sides == exclusions_.all_of("", "", all_->place)) return;
    for (const auto& [pair, sides] : touching) {
      const auto keys = scene.entry<ContactPair>("contact.pair", card_of(*pair->block, pair->place));
      keys.set("first", sides.first.given());
      if (!sides.second.empty()) keys.set("second", sides.second.given());
      if (pair->friction) set_friction(*pair->friction, keys);
    }
  }

  AbaqusData& data_;
  AbaqusInteractions interactions_;
  const AbaqusBlock* all_ = nullptr;  ///< *CONTACT INCLUSIONS, ALL EXTERIOR
  std::vector<Pair> pairs_;           ///< those of general contact first, of what overlaps the last one counts
  std::vector<Pair> assigned_, of_pairs_;
  AbaqusExclusions exclusions_;
  AbaqusFriction common_;
};

}  // namespace

namespace {

/// *TIE: pairs of surfaces.
void write_ties(const AbaqusData& data, const AbaqusBlock& block, DeckScene& scene) {
  DataLines lines(block);
  while (const auto card = lines.next()) {
    const DataFields f(*card);
    const auto keys = scene.entry<TiedContact>("contact.tied", card_of(block, card->place));
    keys.set("first", data.surface(f.text(0), card->place).given());
    keys.set("second", data.surface(f.text(1), card->place).given());
    if (block.has("POSITIONTOLERANCE")) keys.set("tolerance", block.number("POSITIONTOLERANCE", 0.0));
  }
}

}  // namespace

bool translate_abaqus_contact(AbaqusData& data, DeckScene& scene) {
  const bool said = Contact(data).translate(scene);
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name == "TIE") write_ties(data, block, scene);
  }
  return said;
}

}  // namespace pinball

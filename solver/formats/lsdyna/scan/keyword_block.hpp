#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <solver/formats/deck/data_line.hpp>

#include "deck_units.hpp"

namespace pinball {

struct KeywordBlock;

/// One line of data of a keyword.
struct Card : DataLine {
  const KeywordBlock* block = nullptr;  ///< that it is of
};

/// *INCLUDE_TRANSFORM: what is added to the numbers of the included file, its units, and the transformation that its
/// nodes undergo after that into the units of the deck.
struct DeckTransform {
  std::int64_t node = 0, element = 0, part = 0, material = 0, set = 0, curve = 0, define = 0,
               other = 0;  ///< idnoff ... idroff; material: also of equations of state, curve: also of tables
  DeckUnits units{};
  std::int64_t transformation = 0;  ///< number of the *DEFINE_TRANSFORMATION; 0: none
};

/// A keyword and the lines up to the next one.
struct KeywordBlock {
  std::string name;       ///< upper case, without star and options: "SET_NODE_LIST"
  bool title = false;     ///< _TITLE: the first card is one
  bool id = false;        ///< _ID: the first card has number and title
  bool mpp = false;       ///< _MPP of a contact: one or two more cards behind that of _ID
  bool wide = false;      ///< "%" behind the name: ten columns for the numbers of nodes and elements
  bool twenty = false;    ///< "+" behind the name, LONG=Y: twenty columns for each field
  std::string_view body;  ///< lines, comments among them
  DeckPlace place;        ///< of the keyword itself
  std::shared_ptr<const DeckTransform> transform;  ///< none: numbers as they are
  bool of_case = false;                            ///< whether it belongs to the chosen case, and not to all
  ReadingLog* log = nullptr;                       ///< as that of its cards

  std::string star_name() const {
    return '*' + name + (title ? "_TITLE" : "") + (id ? "_ID" : "") + (mpp ? "_MPP" : "");
  }
};

/// What *INCLUDE_TRANSFORM adds to numbers of one kind in a block.
inline std::int64_t offset_of(const KeywordBlock& block, std::int64_t DeckTransform::*which) {
  return block.transform ? (*block.transform).*which : 0;
}

/// The units that a block is in.
inline DeckUnits units_of(const KeywordBlock& block) { return block.transform ? block.transform->units : DeckUnits{}; }

/// The lines of a block that are no comments, one after the other.
class Cards {
 public:
  explicit Cards(const KeywordBlock& block)
      : body_(block.body), place_{block.place.file, block.place.line}, block_(&block) {}
  Cards(const Cards&) = delete;
  Cards& operator=(const Cards&) = delete;
  ~Cards() {
    if (block_->log != nullptr) block_->log->reached(block_, lines_);
  }

  /// The next line; none: the block ends.
  std::optional<Card> next();
  /// The next line that is not blank.
  std::optional<Card> next_filled();
  /// The same behind the line of its number or title. Throws InputError where that stands alone: a card without the
  /// line that _ID and _TITLE ask for would be taken for it, and be lost.
  std::optional<Card> next_behind(const std::optional<Card>& head);
  /// The next line. Throws InputError naming what was expected where the block ends before it.
  Card require(const std::string& expected);
  /// The next line, or a blank one where the block ends: cards of defaults may be left out.
  Card next_or_blank();

 private:
  std::string_view body_;
  DeckPlace place_;
  const KeywordBlock* block_;
  std::size_t lines_ = 0;  ///< that were taken
};

/// The cards of a keyword that has one for each of its things, with one more before each where it has _TITLE or _ID.
/// What reads a card may take the cards, too, and from them what follows it.
template <class Read>
void for_each_card(const KeywordBlock& block, const Read& read) {
  Cards cards(block);
  const bool headed = block.title || block.id;
  while (true) {
    const std::optional<Card> head = headed ? cards.next() : std::nullopt;
    if (headed && !head) return;
    const std::optional<Card> card = cards.next_behind(head);
    if (!card) return;
    if constexpr (std::is_invocable_v<Read, const Card&, Cards&>) {
      read(*card, cards);
    } else {
      read(*card);
    }
  }
}

/// The same of *PART, each of which has a title and a card. read_more(card, cards) takes what _CONTACT and _INERTIA
/// have behind these.
template <class Read, class ReadMore>
void for_each_part(const KeywordBlock& block, const Read& read, const ReadMore& read_more) {
  Cards cards(block);
  while (const std::optional<Card> title = cards.next()) {
    const std::optional<Card> card = cards.next();
    if (title->blank() && (!card || card->blank())) continue;
    if (!card) fail_at(title->place, block.star_name() + ": expected a line of numbers after the title");
    read(*title, *card);
    if (block.name != "PART") read_more(*card, cards);
  }
}

inline bool is_part(const KeywordBlock& block) {
  return block.name == "PART" || block.name == "PART_CONTACT" || block.name == "PART_INERTIA";
}

}  // namespace pinball

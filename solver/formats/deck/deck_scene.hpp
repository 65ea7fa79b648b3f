#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <solver/base/point.hpp>
#include <solver/scene/given/given.hpp>
#include <solver/scene/schema/kinds.hpp>

#include "deck_place.hpp"

/// What the cards of a deck say as keys of a scene, which remember their cards.
namespace pinball {

/// A keyword and where it stands; what has none is of no card.
struct DeckCard {
  std::string keyword;  ///< "*MAT_ELASTIC"
  DeckPlace place{};

  /// "*MAT_ELASTIC deck.k:12"
  std::string text() const { return keyword + ' ' + place.text(); }
  /// For messages. field: the manual's name of what a key is made of; empty: no one field.
  GivenPlace given(std::string_view field = {}) const;
};

/// The name of a key of tables of a kind: one that there is not does not compile.
template <class T>
struct KeyOf {
  std::string_view name;
  consteval KeyOf(const char* name_) : name(name_) {  // NOLINT: a name stands for its key
    if (!schema::has_key<T>(name)) throw "the scene format has no such key here";
  }
};

// Values as a scene has them; of texts what no line of a file can have is left out.
GivenValue given(bool value);
GivenValue given(std::int64_t value);
GivenValue given(double value);
GivenValue given(std::string_view value);
inline GivenValue given(const std::string& value) { return given(std::string_view(value)); }
inline GivenValue given(const char* value) { return given(std::string_view(value)); }
inline GivenValue given(const GivenValue& value) { return value; }
GivenValue given(const Point& value);
GivenValue given(const std::array<std::int64_t, 4>& value);
template <class Value>
GivenValue given(const std::vector<Value>& values);

template <class Values>
GivenValue given_list(const Values& values) {
  GivenArray array;
  array.reserve(values.size());
  for (const auto& value : values) array.push_back(given(value));
  return GivenValue(std::move(array));
}
inline GivenValue given(const Point& value) { return given_list(value); }
inline GivenValue given(const std::array<std::int64_t, 4>& value) { return given_list(value); }
template <class Value>
GivenValue given(const std::vector<Value>& values) {
  return given_list(values);
}

/// The keys of one table, or of a group of them.
template <class T>
class DeckKeys {
 public:
  DeckKeys(GivenTable& table, DeckCard card) : table_(&table), card_(std::move(card)) {}
  /// Those of a part whose keys stand in the table of a whole.
  template <class Whole>
  DeckKeys(const DeckKeys<Whole>& whole)  // NOLINT: the whole has them
      requires(schema::has_group<Whole, T>())
      : table_(whole.table_), card_(whole.card_) {}

  template <class Value>
  void set(KeyOf<T> key, const Value& value, std::string_view field = {}) const {
    GivenValue one = given(value);
    one.place = card_.given(field);
    table_->set(key.name, std::move(one), card_.given());
  }
  /// What follows is of another card.
  void from(DeckCard card) { card_ = std::move(card); }
  /// In the place of the card, where the scene is written as text.
  void comment(std::string text) const { table_->comment = std::move(text); }

 private:
  template <class Other>
  friend class DeckKeys;

  GivenTable* table_;
  DeckCard card_;
};

/// A table that is the value of a key: { ... }.
template <class T>
class InnerKeys {
 public:
  template <class Value>
  void set(KeyOf<T> key, const Value& value) {
    table_.set(key.name, given(value));
  }
  GivenValue value() const {
    GivenValue all(table_);
    all.is_inline = true;
    return all;
  }

 private:
  GivenTable table_;
};

/// The tables of a scene, in the order in which they are begun.
class DeckScene {
 public:
  /// The one of this name, "time". card: that its keys are of.
  template <class T>
  DeckKeys<T> table(const char* name, DeckCard card) {
    return begin<T>(name, false, std::move(card));
  }
  /// One more of this name, "body" or "contact.pair".
  template <class T>
  DeckKeys<T> entry(const char* name, DeckCard card) {
    return begin<T>(name, true, std::move(card));
  }
  /// The keys above all tables.
  DeckKeys<Scene> top() { return {top_, {}}; }
  /// Puts the tables of another one behind these.
  void append(DeckScene&& more);
  /// All of it. comment: a line about the whole.
  GivenTable take(std::string comment);

 private:
  struct Part {
    std::string name;
    bool is_entry;
    GivenPlace place;
    GivenTable table;
  };

  template <class T>
  DeckKeys<T> begin(const char* name, bool is_entry, DeckCard card) {
    Part& part = parts_.emplace_back(Part{name, is_entry, card.given(), {}});
    if (card.place.file) part.table.comment = card.text();
    return {part.table, std::move(card)};
  }

  GivenTable top_;
  std::deque<Part> parts_;  ///< they stay where they are
};

}  // namespace pinball

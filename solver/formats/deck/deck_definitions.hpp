#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "deck_report.hpp"

namespace pinball {

/// What a deck defines by number or by label for others to name: curves, tables, vectors, systems, sections, hourglass
/// control. Who has one number wrong in a card that may go without has defined in vain.
template <class Id>
class DeckDefinitions {
 public:
  /// title: of the keyword, as messages name it.
  void add(const std::string& kind, const Id& id, const std::string& title, const DeckPlace& place) {
    given_[{kind, id}] = {title, place};
  }
  /// Something of what is read names it. Returns the number.
  const Id& name(const std::string& kind, const Id& id) const {
    named_.emplace(kind, id);
    return id;
  }
  /// One line for each keyword with some that nothing has named.
  void tell_unused(DeckReport& report) const {
    for (const auto& [which, definition] : given_) {
      if (!named_.contains(which))
        report.unused(definition.place, definition.title + " that nothing of what is read names");
    }
  }

 private:
  using Which = std::pair<std::string, Id>;
  struct Definition {
    std::string title;
    DeckPlace place;
  };
  std::map<Which, Definition> given_;
  mutable std::set<Which> named_;
};

}  // namespace pinball

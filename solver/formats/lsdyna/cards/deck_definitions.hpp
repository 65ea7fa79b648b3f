#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <solver/formats/deck/deck_report.hpp>

namespace pinball {

/// What a deck defines by number for others to name: curves, tables, vectors, systems, sections,
/// hourglass control. Who has one number
/// wrong in a card that may go without has defined in vain.
class DeckDefinitions {
 public:
  void add(const std::string& kind, std::int64_t id, const std::string& star_name, const DeckPlace& place) {
    given_[{kind, id}] = {star_name, place};
  }
  /// Something of what is read names it. Returns the number.
  std::int64_t name(const std::string& kind, std::int64_t id) const {
    named_.emplace(kind, id);
    return id;
  }
  /// One line for each keyword with some that nothing has named.
  void tell_unused(DeckReport& report) const {
    for (const auto& [which, definition] : given_) {
      if (!named_.contains(which))
        report.unused(definition.place, definition.star_name + " that nothing of what is read names");
    }
  }

 private:
  using Which = std::pair<std::string, std::int64_t>;
  struct Definition {
    std::string star_name;
    DeckPlace place;
  };
  std::map<Which, Definition> given_;
  mutable std::set<Which> named_;
};

}  // namespace pinball

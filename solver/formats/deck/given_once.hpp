#pragma once

#include <map>
#include <string>

#include "deck_place.hpp"

namespace pinball {

/// Where each thing of a kind that has a number or a name is given: once.
class GivenOnce {
 public:
  /// what: "material 5". Throws InputError that names both places where it is given already. of_case: it belongs to the
  /// chosen case of a deck, and takes the place of what belongs to none.
  void add(const std::string& what, const DeckPlace& place, bool of_case = false) {
    const auto [found, is_new] = first_.try_emplace(what, Given{place, of_case});
    if (!is_new && (found->second.of_case || !of_case))
      fail_at(place, what + " is given twice, first in " + found->second.place.text());
    found->second = {place, of_case};
  }

 private:
  struct Given {
    DeckPlace place;
    bool of_case;
  };
  std::map<std::string, Given> first_;
};

}  // namespace pinball

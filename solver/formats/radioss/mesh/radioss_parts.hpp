#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <solver/formats/deck/given_once.hpp>
#include <solver/formats/radioss/scan/radioss_deck.hpp>

namespace pinball {

/// A /PART.
struct RadiossPart {
  std::int64_t id = 0, property = 0, material = 0, subset = 0;
  std::string title;
  DeckPlace place;
};

/// The parts of a deck, and who names several of them: /SUBSET
class RadiossParts {
 public:
  /// deck has to stay. Throws InputError for what is given twice.
  explicit RadiossParts(const RadiossDeck& deck);

  const std::map<std::int64_t, RadiossPart>& all() const { return parts_; }
  /// Numbers of the parts that a line of a group of parts names: those of "PART", "SUBSET", "MAT" or "PROP" with this
  /// number. Throws InputError at the place where there is none.
  std::vector<std::int64_t> named(std::string_view kind, std::int64_t id, const DeckPlace& place) const;

 private:
  void read_part(const RadiossBlock& block);
  std::vector<std::int64_t> of_subset(std::int64_t id, const DeckPlace& place) const;

  std::map<std::int64_t, RadiossPart> parts_;
  std::map<std::int64_t, const RadiossBlock*> subsets_;
  GivenOnce given_;
  mutable std::size_t depth_ = 0;  ///< of groups in groups
};

}  // namespace pinball

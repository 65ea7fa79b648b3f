#pragma once

#include <string>
#include <vector>

#include <solver/formats/deck/treatment.hpp>

namespace pinball {

class DeckData;
class DeckScene;
struct KeywordBlock;

/// What is done with a keyword. docs/decks.md shows these rules (a test compares).
struct KeywordRule {
  const char* name;  ///< with "*" at its end: all that begin so
  Treatment treatment;
  const char* remark;
  /// Whether it may stand in an included file of other units: what it has is converted, or has no dimension.
  bool in_other_units = false;
  /// What makes tables of one such keyword, in the order of the deck; null: all of a kind are looked at together.
  void (*translate)(DeckData&, const KeywordBlock&, DeckScene&) = nullptr;
};

const std::vector<KeywordRule>& keyword_rules();

/// The name by which a keyword is known here: MAT_003 is MAT_PLASTIC_KINEMATIC.
std::string keyword_alias(const std::string& name);

/// The rule of the longest name that fits; null: unknown.
const KeywordRule* rule_of(const std::string& name);

}  // namespace pinball

#pragma once

#include <solver/formats/abaqus/scan/abaqus_block.hpp>
#include <solver/formats/deck/deck_report.hpp>
#include <solver/formats/deck/treatment.hpp>

namespace pinball {

/// What is done with a keyword of Abaqus. docs/decks.md shows name, treatment and remark (a test compares).
struct AbaqusRule {
  const char* name;  ///< with "*" at its end: all that begin so
  Treatment treatment;
  const char* remark;
  /// Parameters that are known: "NAME TYPE=A|B", without blanks in names; after "=" the values that are done, "="
  /// alone: none. All others are refused, so that none is lost.
  const char* parameters = "";
};

const std::vector<AbaqusRule>& abaqus_rules();

/// The rule of the longest name that fits; null: unknown. name: without case and blanks.
const AbaqusRule* abaqus_rule_of(const std::string& name);

/// Puts a keyword with its parameters where it belongs: nowhere, to what is ignored or to what is refused.
void sort_abaqus_keyword(const AbaqusBlock& block, bool lenient, DeckReport& report);

}  // namespace pinball

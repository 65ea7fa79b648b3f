#pragma once

#include <string>
#include <vector>

#include <solver/formats/deck/deck_report.hpp>
#include <solver/formats/deck/treatment.hpp>
#include <solver/formats/radioss/scan/radioss_block.hpp>

namespace pinball {

/// What is done with a keyword of Radioss. docs/decks.md shows name, treatment and remark (a test compares).
struct RadiossRule {
  const char* name;  ///< without the first slash, with "*" at its end: all that begin so
  Treatment treatment;
  const char* remark;
};

const std::vector<RadiossRule>& radioss_rules();

/// The rule of the longest name that fits; null: unknown.
const RadiossRule* radioss_rule_of(const std::string& name);

/// Whether a keyword is refused only where a part with solids has what it defines: a law, a property, what stands
/// beside a material.
bool is_of_radioss_parts(const RadiossBlock& block);

/// Puts a keyword where it belongs: nowhere, to what is ignored or to what is refused.
void sort_radioss_keyword(const RadiossBlock& block, bool lenient, DeckReport& report);

}  // namespace pinball

#include "abaqus_unread.hpp"

#include <fmt/format.h>

#include <set>

#include "abaqus_rules.hpp"

namespace pinball {

namespace {

/// Names alone, what is read with the files, and what is the only way that there is.
bool means_nothing(const AbaqusBlock& block, const std::string& parameter) {
  static const std::set<std::string> silent{"NAME", "INTERNAL", "UNSORTED", "INPUT", "CPSET", "EXPLICIT", "NLGEOM"};
  const bool has_one_type = block.name == "SURFACE" || block.name == "INITIALCONDITIONS";
  return silent.contains(parameter) || (has_one_type && (parameter == "TYPE" || parameter == "DEFINITION"));
}

void tell_parameters(const AbaqusBlock& block, const ReadingLog& log, DeckReport& report) {
  for (std::size_t i = 0; i < block.parameters.size(); ++i) {
    const auto& [name, value] = block.parameters[i];
    if (log.has_asked(&block, i) || means_nothing(block, name)) continue;
    report.unused(block.place,
                  fmt::format("{}, {}{}", block.star_name(), name, value.empty() ? "" : '=' + squeezed(value)));
  }
}

/// "field 3", "fields 3 and 5": of these bits.
std::string fields_text(std::uint32_t fields) {
  std::vector<int> numbers;
  for (int i = 0; i < 32; ++i) {
    if ((fields >> i & 1U) != 0) numbers.push_back(i + 1);
  }
  if (numbers.size() == 1) return fmt::format("field {}", numbers[0]);
  const int last = numbers.back();
  numbers.pop_back();
  return fmt::format("fields {} and {}", fmt::join(numbers, ", "), last);
}

bool says_something(const DataLine& card) {
  for (const std::string_view entry : entries_of(card.text)) {
    if (!entry.empty() && deck_number(entry) != 0.0) return true;
  }
  return false;
}

void tell_lines(const AbaqusBlock& block, const ReadingLog& log, DeckReport& report) {
  if (block.is_mesh() || block.name == "HEADING") return;
  AbaqusBlock silent = block;
  silent.log = nullptr;
  DataLines lines(silent);
  for (std::size_t line = 0; const auto card = lines.next(); ++line) {
    if (line >= log.lines_of(&block)) {
      if (says_something(*card)) report.unused(card->place, block.star_name() + ": a data line");
    } else if (const std::uint32_t left = log.left_of(card->text.data()).fields; left != 0) {
      report.unused(card->place, fmt::format("{}: {}", block.star_name(), fields_text(left)));
    }
  }
}

}  // namespace

void follow_reading(AbaqusDeck& deck, ReadingLog& log) {
  for (AbaqusBlock& block : deck.blocks) {
    const AbaqusRule* rule = abaqus_rule_of(block.name);
    const bool is_done = rule != nullptr && (rule->treatment == Treatment::done || rule->treatment == Treatment::mesh);
    if (is_done) block.log = &log;
  }
}

void tell_unread(const AbaqusDeck& deck, const ReadingLog& log, DeckReport& report) {
  for (const AbaqusBlock& block : deck.blocks) {
    if (block.log == nullptr || log.is_done(&block)) continue;
    tell_parameters(block, log, report);
    tell_lines(block, log, report);
  }
}

}  // namespace pinball

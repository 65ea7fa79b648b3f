#include "indented_keyword.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pinball {

namespace {

constexpr std::string_view blanks = " \t";

/// First words of the keywords of LS-DYNA and Radioss that say what a model is made of.
constexpr std::array<std::string_view, 44> first_words = {
    "ACCEL",     "BCS",      "BEGIN",     "BOUNDARY", "BRICK",     "CLOAD",   "CONSTRAINED", "CONTACT", "CONTROL",
    "DAMPING",   "DATABASE", "DEFINE",    "ELEMENT",  "END",       "EOS",     "FAIL",        "FUNCT",   "GRAV",
    "GRBRIC",    "GRNOD",    "HOURGLASS", "IMPDISP",  "IMPVEL",    "INCLUDE", "INITIAL",     "INIVEL",  "INTER",
    "KEYWORD",   "LOAD",     "MAT",       "NODE",     "PARAMETER", "PART",    "PLOAD",       "PROP",    "RBODY",
    "RIGIDWALL", "RWALL",    "SECTION",   "SET",      "SH3N",      "SHELL",   "SURF",        "TETRA4"};

}  // namespace

void refuse_indented_keyword(std::string_view line, char mark, const DeckPlace& place) {
  const std::size_t first = line.find_first_not_of(blanks);
  if (first == 0 || first == std::string_view::npos || line[first] != mark) return;
  std::string_view name = line.substr(first + 1);
  name = name.substr(0, name.find_last_not_of(" \t\r") + 1);
  if (name.find_first_of(blanks) != std::string_view::npos) return;
  if (std::ranges::find(first_words, name.substr(0, name.find_first_of("_/"))) == first_words.end()) return;
  fail_at(place, fmt::format("a keyword begins in the first column, and blanks stand before {}{}", mark, name));
}

}  // namespace pinball

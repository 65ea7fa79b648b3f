#include "abaqus_text.hpp"

#include <cctype>

namespace pinball {

std::string squeezed(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c != ' ' && c != '\t' && c != '\r') result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return result;
}

std::string label_text(std::string_view label) {
  std::string result;
  for (const char c : trimmed(label)) {
    if (c != '"') result += c;
  }
  return result;
}

std::string label_key(std::string_view label) {
  std::string key;
  bool quoted = false;
  for (const char c : trimmed(label)) {
    if (c == '"') {
      quoted = !quoted;
    } else {
      key += quoted ? c : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
  }
  return key;
}

/// 0 says nothing, as a blank.
DataFields::~DataFields() {
  write_down(nullptr, [](std::size_t, std::string_view given) { return deck_number(given) != 0.0; });
}

std::optional<std::pair<std::string, std::string>> split_label(std::string_view label) {
  bool quoted = false;
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (label[i] == '"') quoted = !quoted;
    if (label[i] == '.' && !quoted) return std::pair{std::string(label.substr(0, i)), std::string(label.substr(i + 1))};
  }
  return std::nullopt;
}

std::vector<std::string_view> entries_of(std::string_view line) {
  std::vector<std::string_view> entries;
  std::string_view rest = trimmed(line);
  while (!rest.empty()) {
    std::size_t comma = 0;
    bool quoted = false;
    while (comma < rest.size() && (quoted || rest[comma] != ',')) quoted ^= rest[comma++] == '"';
    entries.push_back(trimmed(rest.substr(0, comma)));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return entries;
}

bool goes_on(std::string_view line) { return trimmed(line).ends_with(','); }

}  // namespace pinball

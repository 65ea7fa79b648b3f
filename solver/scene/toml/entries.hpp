#pragma once

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "listing.hpp"

/// How the values of a scene are written, for listing.cpp and those beside it.
namespace pinball {

std::string toml_text(const std::string& text);  ///< in quotes
inline std::string toml_text(const char* text) { return toml_text(std::string(text)); }
inline std::string toml_text(bool value) { return value ? "true" : "false"; }
inline std::string toml_text(double value) { return fmt::format("{:.12g}", value); }
template <class Integer, std::enable_if_t<std::is_integral_v<Integer> && !std::is_same_v<Integer, bool>, int> = 0>
std::string toml_text(Integer value) {
  return fmt::format("{}", value);
}
template <class List, class = typename List::value_type>
std::string toml_text(const List& values) requires(!std::is_same_v<List, std::string>) {
  std::string text;
  for (const auto& value : values) {
    if (!text.empty()) text += ", ";
    text += toml_text(value);
  }
  return fmt::format("[{}]", text);
}

/// The rows of one table.
class Entries {
 public:
  Entries(std::vector<SceneEntry>& all, std::string table) : all_(all), table_(std::move(table)) {}

  template <class Value>
  void add(std::string_view key, const Value& value) {
    add_words(key, toml_text(value), false);
  }
  /// A text that is written as it stands, and not in quotes.
  void add_words(std::string_view key, const std::string& words, bool is_default, const std::string& unit = {}) {
    all_.push_back({table_, std::string(key), words, unit, is_default});
  }

 private:
  std::vector<SceneEntry>& all_;
  std::string table_;
};

/// Of a body: [element] or body.NAME.element.
void list_element(const ElementSettings& element, const std::string& name, std::vector<SceneEntry>& all);
/// Pairs and tied contacts.
void list_contact_parts(const Scene& scene, std::vector<SceneEntry>& all);
void list_bodies(const Scene& scene, std::vector<SceneEntry>& all);
/// What acts from outside, and probes.
void list_boundary(const Scene& scene, std::vector<SceneEntry>& all);

}  // namespace pinball
